//! From a case to the coupled system of one harmonic.

use tank::Case;
use tank::Shape;

use crate::FeError;
use crate::checks::check_options;
use crate::coupled::{Coupled, Part, ShapeRows};
use crate::error::failure;
use fem::linalg::Cholesky;
use fem::liquid::{Domain, Potential};
use results::Labelled;
use tank::options::LinearOptions as Options;

use super::assembly::{Assembly, RoofShare};
use super::dashpots;
use super::liquid_mesh;
use super::observe::Observer;
use super::places::Places;
use super::state::Static;
use super::wall::Wall;

/// Builds the coupled system of a harmonic: m = 0, 1, 2, … of a cylinder; 0 (symmetric) or 1 (antisymmetric) of a
/// rectangle, which is modelled as a plane strip of its breadth.
///
/// Memory is not looked at: [`super::estimate`] counts it.
///
/// Errors: an option out of range; a liquid too shallow for a mesh; a harmonic a rectangle does not have.
pub fn build(case: &Case, options: &Options, harmonic: u32) -> Result<Coupled, FeError> {
    build_observed(case, options, harmonic, Places::Usual)
}

/// [`build`] with outputs over the height at other places.
///
/// Errors: as [`build`].
pub(crate) fn build_observed(
    case: &Case,
    options: &Options,
    harmonic: u32,
    places: Places,
) -> Result<Coupled, FeError> {
    check_options(case, options)?;
    let domain = domain(case, harmonic)?;
    let depth = case.liquid.fill_height;
    let wall = Wall::new(&case.tank, depth, harmonic, options.refine);
    let mesh = liquid_mesh::mesh(case, options.refine);

    let tolerance = 1e-6 * case.tank.wall_height();
    let mut trace: Vec<f64> = wall.nodes.iter().copied().filter(|&z| z <= depth + tolerance).collect();
    *trace.last_mut().expect("the base is always wetted") = depth;
    let liquid = Potential::new(domain, mesh, trace, case.liquid.density).map_err(failure("the liquid matrix H"))?;
    let share = meshed_share(case);
    let roof =
        RoofShare { mass: share * case.tank.roof.mass, offset: case.tank.roof_height() - case.tank.wall_height() };
    let state = Static::solve(case, options.refine, share * case.tank.roof.on_wall())
        .map_err(failure("the wall's static stiffness"))?;
    let assembly = Assembly::new(case, harmonic, wall, liquid, roof);

    let mass = assembly.reduction.matrix(&assembly.mass);
    let stiffness = assembly.reduction.matrix(&assembly.stiffness);
    let factor = Cholesky::factor(&mass).map_err(failure("the coupled mass matrix"))?;
    let influence = factor.solve_vector(&assembly.reduction.row(&assembly.load));
    let moment_arm = factor.solve_vector(&assembly.reduction.row(&assembly.mass.times(&assembly.rotation)));
    let observer = Observer {
        assembly: &assembly,
        state: &state,
        case,
        influence: &influence,
        places,
        rigid: rigid_part(case, share),
    };
    let (probes, lines, shear) = (observer.probes(options), observer.lines(), observer.shear());
    let first = (0..assembly.surface_start()).filter(|&i| assembly.reduction.index(i).is_some()).count();
    Ok(Coupled {
        harmonic,
        surface: Part::block(&stiffness, first..assembly.reduction.len()),
        rotation: None,
        probes,
        lines,
        level: case.liquid.fill_height,
        shear,
        liquid_mass: case.liquid_mass(),
        wall_mass: case.tank.wall_mass() + case.tank.roof.mass,
        structure: (harmonic == 1).then(|| {
            let rows = [&assembly.wall_inertia, &assembly.roof_inertia];
            rows.map(|rows| rows.each_ref().map(|row| assembly.reduction.row(row)))
        }),
        dashpots: dashpots::rows(&assembly, options),
        mesh: describe(&assembly).into_iter().chain(liquid_mesh::label(case)).collect(),
        shape_rows: shape_rows(&assembly),
        mass,
        stiffness,
        influence,
        moment_arm,
    })
}

fn domain(case: &Case, harmonic: u32) -> Result<Domain, FeError> {
    match case.tank.shape {
        Shape::Cylinder { radius } => Ok(Domain::Cylinder { radius, harmonic }),
        Shape::Rectangle { length, breadth, .. } if harmonic <= 1 => {
            Ok(Domain::Strip { half_length: 0.5 * length, breadth, symmetric: harmonic == 0 })
        }
        Shape::Rectangle { .. } => Err(FeError::Unsupported(format!(
            "harmonic {harmonic}: a rectangular tank has the harmonics 0 (symmetric) and 1 (antisymmetric) only"
        ))),
    }
}

/// Share of wall perimeter (and of the roof) that the meshed walls carry: all of it but for the side walls of a rectangle.
fn meshed_share(case: &Case) -> f64 {
    match case.tank.shape {
        Shape::Cylinder { .. } => 1.0,
        Shape::Rectangle { breadth, .. } => 2.0 * breadth / case.tank.perimeter(),
    }
}

/// Mass and first moment about the base of the side walls and their share of the roof, which follow the ground.
fn rigid_part(case: &Case, meshed: f64) -> (f64, f64) {
    let walls = (1.0 - meshed) * case.tank.wall_mass();
    let roof = (1.0 - meshed) * case.tank.roof.mass;
    (walls + roof, walls * case.tank.wall_centroid() + roof * case.tank.roof_height())
}

fn describe(assembly: &Assembly) -> Vec<Labelled> {
    let (r, z) = assembly.liquid.mesh.elements();
    let wall = &assembly.wall;
    let shortest = wall.elements.iter().fold(f64::INFINITY, |m, e| m.min(e.length));
    let kind = if wall.curvature > 0.0 { "shell of revolution" } else { "plane strip" };
    let label = |label: &str, text: String| Labelled { label: label.into(), text };
    vec![
        label("liquid elements", format!("{r} × {z}, nine nodes, potential condensed")),
        label(
            "wall elements",
            format!(
                "{}, {kind}, shortest {} at the base",
                wall.elements.len(),
                tank::units::display(shortest, tank::units::Dimension::Length)
            ),
        ),
        label(
            "unknowns",
            format!(
                "{} ({} wall, {} free surface)",
                assembly.reduction.len(),
                assembly.reduction.len() - free_surface(assembly),
                free_surface(assembly)
            ),
        ),
    ]
}

fn free_surface(assembly: &Assembly) -> usize {
    (assembly.surface_start()..assembly.size).filter(|&i| assembly.reduction.index(i).is_some()).count()
}

fn shape_rows(assembly: &Assembly) -> ShapeRows {
    let start = assembly.surface_start() - assembly.liquid.surface_columns().start;
    let row = |index: Option<usize>| index.map(|i| (i, 1.0)).into_iter().collect();
    let of_node = |index: Option<usize>| row(index.and_then(|i| assembly.reduction.index(i)));
    let mut rows = ShapeRows {
        z: assembly.wall.nodes.clone(),
        wall: assembly.node.iter().map(|n| of_node(n[2])).collect(),
        tangential: assembly.node.iter().map(|n| [of_node(n[0]), of_node(n[1])]).collect(),
        ..ShapeRows::default()
    };
    for (&r, column) in assembly.liquid.mesh.r.iter().zip(&assembly.liquid.surface) {
        let index = column.map(|c| assembly.reduction.index(start + c));
        // The elevation that follows from the balance of volume is not an unknown.
        if let (Some(None), Some(c)) = (index, column) {
            let mut all = vec![0.0; assembly.size];
            all[start + c] = 1.0;
            let own = assembly.reduction.row(&all).into_iter().enumerate();
            rows.closing = Some((r, own.filter(|(_, c)| *c != 0.0).collect()));
        } else {
            rows.r.push(r);
            rows.surface.push(row(index.flatten()));
        }
    }
    rows
}
