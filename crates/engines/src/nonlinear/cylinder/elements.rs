//! Rows, supports, rings, attachments, roof, liquid and pressure of a cylinder.

use std::collections::BTreeMap;

use fem::dofs::Dof;
use fem::element::liquid_joint::PENALTY;
use fem::element::shell::load::{FollowerPressure, NodalLoads};
use fem::element::wall::place::{Footprint, PlacedWall};
use fem::liquid::{CircularLiquid, CondensedLiquid, HarmonicLiquid, LiquidMesh, WallLiquid};
use fem::model::Builder;
use tank::Case;
use tank::options::nonlinear::{Contact, Damping as Wanted, NonlinearOptions};

use super::floor::LiquidFloor;
use super::mesh::Cells;
use super::section::{self, RowBuild};
use crate::FeError;
use crate::error::failed;
use crate::solid::ring::{Circle, add_fittings};
use crate::solid::roof::RoofRing;

/// Group of shells and layers.
pub(super) const WALL: &str = "wall";
/// Group of the liquid.
pub(super) const LIQUID: &str = "liquid";
/// Group of the pressure that rotates with the wall.
const PRESSURE: &str = "pressure";
/// Group of the roof's mass.
const ROOF: &str = "roof";

/// Sloshing modes of the condensed liquid of each family: harmonic 0, cosine and sine of harmonic 1. The twelfth holds 1e-4 of
/// the liquid's mass; those left out follow the wall without gravity.
const SLOSHING_MODES: usize = 12;
/// Highest harmonic whose surface is free to slosh.
const SLOSHING_HARMONICS: u32 = 1;

/// Wetted nodes up to which the liquid is a dense block, bonded and with contact that opens. Above, it is an operator. Bonded, an
/// operator needs one to four products a solution and is faster from some hundred nodes; every joint that opens takes a step of
/// the iteration, so that with contact the block serves as long as it fits (docs/performance.md).
const DENSE: [usize; 2] = [400, 3000];

/// Whether the liquid of so many wetted nodes is an operator.
pub(super) fn iterates(wetted: usize, contact: Contact) -> bool {
    let [bonded, opening] = DENSE;
    match contact {
        Contact::Bonded => wetted > bonded,
        Contact::Opening => wetted > opening,
    }
}

pub(super) fn build_rows(
    case: &Case,
    cells: &Cells,
    radius: f64,
    options: &NonlinearOptions,
) -> Result<Vec<RowBuild>, FeError> {
    let length = radius * cells.angle();
    cells
        .z
        .windows(2)
        .map(|z| {
            let course = case.tank.course_at(0.5 * (z[0] + z[1]));
            section::row(&course.build_up(), [length, z[1] - z[0]], &options.integration, options.temperature)
        })
        .collect()
}

/// Stiffness of the joint of liquid and wall: [`PENALTY`] times that of the stiffest course against a pressure, E t/R².
pub(super) fn penalty(case: &Case, radius: f64) -> f64 {
    let courses = case.tank.courses.iter().map(|course| {
        let layers = course.build_up();
        layers.iter().map(|l| l.material.youngs_modulus * l.thickness).sum::<f64>()
    });
    PENALTY * courses.fold(0.0, f64::max) / (radius * radius)
}

/// Clamped base, unless the wall `stands` on its bottom; the plane of symmetry.
pub(super) fn support(builder: &mut Builder, footprint: &Footprint, wall: &PlacedWall, cells: &Cells, stands: bool) {
    // A bottom holds the foot itself.
    let levels = &footprint.levels[usize::from(stands)..];
    if !stands {
        wall.hold(builder, &footprint.levels[0], Dof::SHELL);
    }
    if cells.half {
        for level in levels {
            let ends = [level[0], level[level.len() - 1]];
            // u_θ, and the rotation about the meridian.
            wall.hold(builder, &ends, &[Dof::Uy, Dof::Ry]);
        }
    }
}

/// Rings and attachments.
///
/// Errors: nodes that coincide.
pub(super) fn fit(
    case: &Case,
    builder: &mut Builder,
    footprint: &Footprint,
    wall: &PlacedWall,
    cells: &Cells,
) -> Result<(), FeError> {
    let columns = if cells.half { cells.columns() + 1 } else { cells.columns() };
    let circle = |level: usize| Circle {
        nodes: footprint.levels[level].iter().map(|&p| wall.inner[p]).collect(),
        angles: cells.edges()[..columns].to_vec(),
        half: cells.half,
        radius: case.tank.shape.half_length(),
    };
    add_fittings(&case.tank, &cells.z, circle, WALL, builder)
}

pub(super) fn add_roof(case: &Case, builder: &mut Builder, footprint: &Footprint, wall: &PlacedWall, cells: &Cells) {
    let top = &footprint.levels[footprint.levels.len() - 1];
    let nodes: Vec<usize> = top.iter().map(|&p| wall.inner[p]).collect();
    let positions: Vec<[f64; 3]> = nodes.iter().map(|&n| builder.position(n)).collect();
    let lever = case.tank.roof_height() - case.tank.wall_height();
    let ring = match cells.half {
        true => RoofRing::half(nodes, &positions, case.tank.roof.mass, lever),
        false => RoofRing::new(nodes, &positions, case.tank.roof.mass, lever),
    };
    builder.element(ROOF, ring.carrying(1.0 - case.tank.roof.on_columns));
}

/// The liquid over the wetted nodes and the `rings` of a floor that moves.
pub(super) fn condense(case: &Case, cells: &Cells, operator: bool, rings: &[f64]) -> Result<WallLiquid, FeError> {
    let (radius, depth) = (case.tank.shape.half_length(), case.liquid.fill_height);
    let mut heights = cells.z[..cells.wet(depth)].to_vec();
    if let Some(last) = heights.last_mut() {
        *last = depth;
    }
    let mesh = LiquidMesh::graded(radius, depth, 1.0);
    let harmonic = HarmonicLiquid::with_floor(
        [radius, case.liquid.density, case.gravity],
        cells.sectors,
        [&heights, rings],
        &mesh,
        SLOSHING_HARMONICS,
    )
    .map_err(failed)?;
    let families = if cells.half { 2 } else { 3 };
    let modes = families * SLOSHING_MODES;
    if operator {
        return Ok(WallLiquid::Circular(CircularLiquid::new(&harmonic, cells.half, modes).map_err(failed)?));
    }
    let whole = match cells.half {
        true => CondensedLiquid::of_harmonic_half(&harmonic).map_err(failed)?,
        false => CondensedLiquid::of_harmonic(&harmonic),
    };
    let modes = modes.min(whole.surface());
    Ok(WallLiquid::Dense(whole.with_sloshing_modes(modes).map_err(failed)?))
}

pub(super) fn add_liquid(
    case: &Case,
    builder: &mut Builder,
    cells: &Cells,
    wetted: &[usize],
    options: &NonlinearOptions,
    (operator, floor): (bool, Option<&LiquidFloor>),
) -> Result<(WallLiquid, Vec<usize>, usize), FeError> {
    let depth = case.liquid.fill_height;
    let liquid = condense(case, cells, operator, floor.map_or(&[][..], |floor| &floor.radii))?;
    let amplitudes: Vec<usize> = liquid.omega().iter().map(|_| builder.node([0.0, 0.0, depth])).collect();
    let ratio = match options.damping {
        Wanted::ByGroup { sloshing, .. } => sloshing,
        _ => 0.0,
    };
    let mut wall: Vec<(usize, Dof)> = wetted.iter().map(|&n| (n, Dof::Ux)).collect();
    wall.extend(floor.iter().flat_map(|floor| &floor.nodes).map(|&n| (n, Dof::Amplitude)));
    let surface: Vec<(usize, Dof)> = amplitudes.iter().map(|&n| (n, Dof::Amplitude)).collect();
    let number = match &liquid {
        WallLiquid::Dense(dense) => builder.element(LIQUID, dense.element(&wall, &surface, ratio).map_err(failed)?),
        WallLiquid::Circular(own) => builder.element(LIQUID, own.element(&wall, &surface, ratio).map_err(failed)?),
    };
    Ok((liquid, amplitudes, number))
}

/// Hydrostatic pressure as dead load, its change where it rotates with the wall, and a unit pressure.
pub(super) fn pressures(
    builder: &mut Builder,
    footprint: &Footprint,
    wall: &PlacedWall,
    cells: &Cells,
    [unit_weight, depth]: [f64; 2],
    pressed: &BTreeMap<usize, usize>,
    options: &NonlinearOptions,
) -> (NodalLoads, NodalLoads) {
    let (mut pressure, mut area) = (NodalLoads::new(), NodalLoads::new());
    let at = |z: f64| unit_weight * (depth - z).max(0.0);
    for (&cell, &row) in footprint.cells.iter().zip(&footprint.rows) {
        if cells.z[row + 1] > depth * (1.0 + 1e-9) {
            continue;
        }
        let nodes = wall.inner_cell(cell);
        let positions = nodes.map(|n| builder.position(n));
        // On the liquid's face.
        let face = nodes.map(|n| pressed.get(&n).copied().unwrap_or(n));
        pressure.pressure(&face, &positions, |x| at(x[2]));
        area.pressure(&face, &positions, |_| 1.0);
        if options.follower_pressure {
            let corners = positions.map(|x| at(x[2]));
            let follower = FollowerPressure::varying(nodes, positions, corners).without_dead_part();
            builder.element(PRESSURE, follower);
        }
    }
    (pressure, area)
}
