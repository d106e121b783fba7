//! A wall of the strip as layered shells: leaves of one element across, with the layer between them.
//!
//! ```text
//!   wet leaf     layer    leaf that bends          levels as of the fibre wall; every node at y = 0 and y = 1 m
//!     ●────────────░────────────●                  plane strain: no displacement across, no rotation about z
//! ```
//!
//! Moments refer to the middle of each leaf: the layer passes no shear, so that normal forces of the leaves are their own weights.
//! Results at points (cracks, bars, plastic strain) are those of the leaf that bends, as with fibres.

use fem::dofs::Dof;
use fem::element::fibre_beam::FibreBeam;
use fem::element::shell4::MassKind;
use fem::element::wall::place::{Build, Footprint, WallMesh};
use fem::linalg::Matrix;
use fem::model::Builder;
use tank::options::nonlinear::NonlinearOptions;
use tank::{Behaviour, Case, Layer, LayerKind};

use super::parameters::{StripError, StripTank};
use super::section::{course_at, main_leaf};
use super::shell_wall::{BREADTH, ShellRow, ShellWall};
use crate::FeError;
use crate::nonlinear::cylinder::section::{Part, row};
use crate::nonlinear::laws::unsupported;

/// Nodes of a wall.
pub(super) struct Nodes {
    /// Nodes of the leaf that bends, one at each level, upwards.
    pub axis: Vec<usize>,
    /// Nodes of the wet face, all of each level, upwards.
    pub wet: Vec<Vec<usize>>,
    /// Nodes of the leaf that bends, all of each level, upwards.
    pub leaf: Vec<Vec<usize>>,
    /// All at the base.
    pub feet: Vec<usize>,
}

/// Adds nodes and elements of the wall; a fibre wall may still turn at its base.
///
/// Errors: those of the elements; shells on a spring at the base, of another number than levels, bonded without a layer.
pub(super) fn place(builder: &mut Builder, tank: &StripTank, group: &str) -> Result<Nodes, StripError> {
    let Some(shells) = &tank.shells else {
        let axis: Vec<usize> = tank.levels.iter().map(|&z| builder.node([0.0, 0.0, z])).collect();
        builder.hold(axis[0], Dof::Ux);
        builder.hold(axis[0], Dof::Uz);
        for (ends, section) in axis.windows(2).zip(&tank.sections) {
            FibreBeam::add_to(builder, group, [ends[0], ends[1]], section.clone(), tank.options)?;
        }
        let levels: Vec<Vec<usize>> = axis.iter().map(|&n| vec![n]).collect();
        return Ok(Nodes { wet: levels.clone(), leaf: levels, feet: vec![axis[0]], axis });
    };
    check(tank, shells)?;
    let mesh_error = |e: fem::mesh::MeshError| StripError::Parameter {
        parameter: "levels",
        found: e.to_string(),
        allowed: "ascending from 0",
    };
    let footprint = Footprint::strip(0.0, &[0.0, BREADTH], &tank.levels).map_err(mesh_error)?;
    let mesh = WallMesh {
        footprint: &footprint,
        courses: &|row| shells.rows[row].build.clone(),
        offsets: [0.0, shells.gap],
        name: group,
        mass: MassKind::Consistent,
    };
    let placed = mesh.place(builder)?;
    for level in &footprint.levels {
        placed.hold(builder, level, &[Dof::Uy, Dof::Ry]);
    }
    placed.hold(builder, &footprint.levels[0], Dof::SHELL);
    let bending = if shells.main == 0 { &placed.inner } else { &placed.outer };
    let base = &footprint.levels[0];
    Ok(Nodes {
        axis: footprint.levels.iter().map(|l| bending[l[0]]).collect(),
        wet: footprint.levels.iter().map(|l| l.iter().map(|&p| placed.inner[p]).collect()).collect(),
        leaf: footprint.levels.iter().map(|l| l.iter().map(|&p| bending[p]).collect()).collect(),
        feet: [&placed.inner, &placed.outer]
            .iter()
            .flat_map(|nodes| base.iter().filter_map(|&p| nodes.get(p).copied()))
            .collect(),
    })
}

fn check(tank: &StripTank, shells: &ShellWall) -> Result<(), StripError> {
    let refuse = |parameter, found: String, allowed| Err(StripError::Parameter { parameter, found, allowed });
    if tank.base_spring.is_some() {
        return refuse("base spring", "one under shells".into(), "a clamped base");
    }
    if shells.rows.len() + 1 != tank.levels.len() {
        let found = format!("{} for {} elements", shells.rows.len(), tank.levels.len() - 1);
        return refuse("shells", found, "one an element");
    }
    let leaves = |row: &ShellRow| match row.build {
        Build::Shell(_) => 1,
        Build::Bonded(_) => 0,
        Build::Layered(..) => 2,
    };
    if let Some(row) = shells.rows.iter().find(|r| leaves(r) <= shells.main) {
        let found = format!("leaf {} of {}", shells.main, leaves(row));
        return refuse("shells", found, "one shell, or two with a layer");
    }
    Ok(())
}

/// A matrix over the unknowns of a face (`each` a level) and of the amplitudes as one over the unknowns of all nodes of each level,
/// the displacement of the face being their mean. One node a level: the matrix itself.
pub(super) fn spread(matrix: &Matrix, each: usize, face: &[Vec<usize>]) -> Matrix {
    let from = each * face.len();
    let amplitudes = matrix.rows - from;
    // For each new unknown: the old one and its share.
    let mut rows: Vec<(usize, f64)> = Vec::new();
    for (level, nodes) in face.iter().enumerate() {
        for _ in nodes {
            rows.extend((0..each).map(|k| (each * level + k, 1.0 / nodes.len() as f64)));
        }
    }
    rows.extend((0..amplitudes).map(|i| (from + i, 1.0)));
    let mut out = Matrix::zeros(rows.len(), rows.len());
    for (j, &(q, b)) in rows.iter().enumerate() {
        for (i, &(p, a)) in rows.iter().enumerate() {
            out.add(i, j, a * b * matrix.get(p, q));
        }
    }
    out
}

/// Shells of a wall with nodes at `levels` [m], with the free strains of a temperature at rest.
///
/// Errors: layers or laws that shells do not have; a leaf that bends on another side, or another distance between leaves, from
/// course to course.
pub(super) fn wall(case: &Case, levels: &[f64], options: &NonlinearOptions) -> Result<ShellWall, FeError> {
    let mut found: Option<ShellWall> = None;
    for ends in levels.windows(2) {
        let layers = course_at(case, 0.5 * (ends[0] + ends[1])).build_up();
        let (own, main, gap) = shell_row(&layers, ends[1] - ends[0], options)?;
        let wall = found.get_or_insert_with(|| ShellWall { rows: Vec::new(), main, gap });
        if wall.main != main || (wall.gap - gap).abs() > 1e-9 * levels[levels.len() - 1] {
            return unsupported(
                "courses of a strip of shells have the same number of leaves at the same distance between their middles",
            );
        }
        wall.rows.push(own);
    }
    match found {
        Some(wall) => Ok(wall),
        None => unsupported("a wall without elements"),
    }
}

/// Shells of an element of this length [m]; number of the leaf that bends, and distance of the leaves [m].
///
/// Errors: layers or laws that shells do not have.
pub(crate) fn shell_row(
    layers: &[Layer],
    element: f64,
    options: &NonlinearOptions,
) -> Result<(ShellRow, usize, f64), FeError> {
    // What localises does so up the wall: the breadth of 1 m has no part in it.
    let row = row(layers, [element; 2], &options.integration, options.temperature)?;
    let main = main_leaf(layers)?;
    let leaves = layers.split(|l| l.kind == LayerKind::Interlayer);
    let number = leaves.take_while(|leaf| !std::ptr::eq(*leaf, main)).count();
    let parts = row.parts.get(number).into_iter().flatten();
    let own = ShellRow { build: row.build, layers: parts.filter(|p| !matches!(p, Part::Bar(_))).count() };
    Ok((own, number, row.gap))
}

/// The wall as if it stayed elastic and had no bars: mass and stiffness of the fibre section beside the shells.
pub(super) fn elastic(layers: &[Layer]) -> Vec<Layer> {
    let mut out = layers.to_vec();
    for layer in out.iter_mut().filter(|l| l.kind != LayerKind::Interlayer) {
        layer.reinforcement.clear();
        layer.material.behaviour = Behaviour::Elastic;
    }
    out
}
