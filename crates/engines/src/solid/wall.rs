//! The wall of a model: shells, clamped base, rings and attachments, mass of the roof.

use std::sync::Arc;

use fem::dofs::Dof;
use fem::element::ElementError;
use fem::element::shell::section::{ElasticSection, Section};
use fem::element::shell::surface::{Normals, ShellCell, ShellSurface};
use fem::element::shell4::Axes;
use fem::mesh::{Cylinder, Face, Wall};
use fem::model::Builder;
use tank::Case;

use super::form::Form;
use super::mesh::Division;
use super::plan::Plan;
use super::ring::{Circle, add_fittings, level_at};
use super::roof::RoofRing;
use crate::FeError;
use crate::error::failed;

/// Group of the wall's shells, rings and attachments.
pub const WALL: &str = "wall";
/// Group of what the loaded state adds to the stiffness of the wall.
pub const LOADED: &str = "loaded state";
/// Group of the roof's mass.
pub const ROOF: &str = "roof";

/// Where the wall is in the model.
#[derive(Clone, Debug)]
pub struct WallPart {
    /// Heights of the node levels [m].
    pub z: Vec<f64>,
    /// Nodes: `rows[level][sector]`.
    pub rows: Vec<Vec<usize>>,
    /// Faces, sector by sector and level by level; numbers of the model.
    pub faces: Vec<Face>,
    /// Element of each face.
    pub elements: Vec<usize>,
    /// Thickness of the faces of each level [m].
    pub thickness: Vec<f64>,
    /// Poisson's ratio of the faces of each level.
    pub poisson_ratio: Vec<f64>,
    /// Elements of the loaded state; none if the wall moves about its unloaded state.
    pub loaded: Vec<usize>,
}

impl WallPart {
    /// Levels of elements of equal thickness and material, from the base up.
    pub fn courses(&self) -> Vec<std::ops::Range<usize>> {
        let mut out = Vec::new();
        let mut start = 0;
        for level in 1..=self.thickness.len() {
            let same = level < self.thickness.len()
                && self.thickness[level] == self.thickness[start]
                && self.poisson_ratio[level] == self.poisson_ratio[start];
            if !same {
                out.push(start..level);
                start = level;
            }
        }
        out
    }
}

/// Nodes and faces of the wall before its elements.
fn mantle(division: &Division, plan: Option<&Plan>) -> Result<Wall, FeError> {
    if let Some(plan) = plan {
        let (nodes, cells, rows) = plan.walls(&division.wall);
        return Ok(Wall { nodes, cells, rows });
    }
    let mesh = Cylinder { radii: division.radii.clone(), sectors: division.sectors, heights: division.wall.clone() };
    mesh.wall().map_err(failed)
}

/// Shells, clamped base, rings, attachments and roof.
///
/// Errors: an element that cannot be built.
pub(super) fn add_wall(
    case: &Case,
    division: &Division,
    (plan, form): (Option<&Plan>, &Form<'_>),
    builder: &mut Builder,
) -> Result<WallPart, FeError> {
    let wall = mantle(division, plan)?;
    let places: Vec<[f64; 3]> = wall.nodes.iter().map(|p| form.moved(*p)).collect();
    builder.nodes(&places);
    let levels = division.wall.windows(2);
    let courses: Vec<_> = levels.map(|z| case.tank.course_at(0.5 * (z[0] + z[1]))).collect();
    let sections = courses
        .iter()
        .map(|c| {
            let m = &c.material;
            let section = ElasticSection::new(m.youngs_modulus, m.poisson_ratio, c.thickness, m.density)?;
            Ok(Arc::new(section) as Arc<dyn Section>)
        })
        .collect::<Result<Vec<_>, ElementError>>()
        .map_err(failed)?;
    let cells = wall
        .cells
        .iter()
        .enumerate()
        .map(|(k, face)| ShellCell {
            nodes: face.nodes,
            section: sections[k / division.sectors].clone(),
            group: WALL.into(),
        })
        .collect();
    let outwards = |_: usize, node: usize| form.normal(wall.nodes[node]);
    let surface = ShellSurface {
        // Plates have the normals of their elements; where two meet, the corner is a fold.
        normals: match plan {
            Some(_) => Normals::Cells,
            None => Normals::Exact(&outwards),
        },
        axes: Axes::HOOP_Z,
        ..ShellSurface::new(cells)
    };
    let placed = surface.place(builder).map_err(failed)?;
    for &node in &wall.rows[0] {
        for &dof in Dof::SHELL {
            builder.hold(node, dof);
        }
    }
    fit(case, division, plan.is_none(), &wall, builder)?;
    if case.tank.roof.mass > 0.0 {
        let top = wall.rows[wall.rows.len() - 1].clone();
        let positions: Vec<[f64; 3]> = top.iter().map(|&n| wall.nodes[n]).collect();
        let lever = case.tank.roof_height() - case.tank.wall_height();
        let ring = match plan {
            Some(_) => RoofRing::frame(top, &positions, case.tank.roof.mass, lever),
            None => RoofRing::new(top, &positions, case.tank.roof.mass, lever),
        };
        builder.element(ROOF, ring.carrying(1.0 - case.tank.roof.on_columns));
    }
    Ok(WallPart {
        z: division.wall.clone(),
        rows: wall.rows,
        faces: wall.cells,
        elements: placed.elements,
        thickness: courses.iter().map(|c| c.thickness).collect(),
        poisson_ratio: courses.iter().map(|c| c.material.poisson_ratio).collect(),
        loaded: Vec::new(),
    })
}

/// Rings and attachments; attachments alone on plane walls.
///
/// Errors: nodes that coincide.
fn fit(case: &Case, division: &Division, round: bool, wall: &Wall, builder: &mut Builder) -> Result<(), FeError> {
    if round {
        let sectors = division.sectors as f64;
        let circle = |level: usize| Circle {
            nodes: wall.rows[level].clone(),
            angles: (0..division.sectors).map(|s| std::f64::consts::TAU * s as f64 / sectors).collect(),
            half: false,
            radius: case.tank.shape.half_length(),
        };
        return add_fittings(&case.tank, &division.wall, circle, WALL, builder);
    }
    for (mass, height) in case.tank.carried().filter(|(mass, _)| *mass > 0.0) {
        let level = level_at(&division.wall, height);
        let nodes = wall.rows[level].clone();
        let positions: Vec<[f64; 3]> = nodes.iter().map(|&n| wall.nodes[n]).collect();
        builder.element(WALL, RoofRing::frame(nodes, &positions, mass, height - division.wall[level]));
    }
    Ok(())
}
