//! Modes of the strip with its initial stiffness, for the results folder.

use std::f64::consts::TAU;

use fem::dofs::Dof;
use fem::linalg::dot;

use super::model::StripModel;
use crate::modes::Kind;
use results::{DampingRow, Mode, ModeShape};

/// Modes of each kind that are listed.
const LISTED: usize = 6;
/// Points over half of the surface.
const SURFACE: usize = 20;
/// Share of the mass from which a mode is listed in the table of damping.
const SIGNIFICANT: f64 = 0.01;

/// The first modes of each kind of a tank of the given breadth, both walls.
pub(super) fn modes(model: &StripModel, breadth: f64) -> Vec<Mode> {
    let (mut sloshing, mut structural) = (0, 0);
    let moment = model.base_moment();
    let sparse = |row: &[(usize, f64)], phi: &[f64]| row.iter().map(|&(e, c)| c * phi[e]).sum::<f64>();
    let total = 2.0 * breadth * dot(&model.system.inertia[0], &model.system.influence[0]);
    let mut out = Vec::new();
    for (j, &omega) in model.modes.omega.iter().enumerate() {
        let phi = model.modes.vectors.column(j);
        let kind = kind(model, j);
        let counter = match kind {
            Kind::Sloshing => &mut sloshing,
            _ => &mut structural,
        };
        *counter += 1;
        if *counter > LISTED {
            continue;
        }
        // φᵀ M φ = 1 of the whole tank, 2 b strips.
        let participation = (2.0 * breadth).sqrt() * dot(&model.system.inertia[0], phi);
        // κᵀ M φ: the reactions at the base alone balance the moment of the inertia forces.
        let turned = sparse(&moment.acceleration, phi) - sparse(&moment.displacement, phi) / (omega * omega);
        let turned = (2.0 * breadth).sqrt() * turned;
        let carries_mass = participation * participation > 1e-12 * total;
        out.push(Mode {
            harmonic: 1,
            axial: None,
            kind: kind.id().into(),
            number: *counter,
            omega,
            period: TAU / omega,
            damping: model.ratios[j].ratio,
            participation,
            effective_mass: participation * participation,
            effective_height: if carries_mass { turned / participation } else { 0.0 },
            shape: shape(model, phi),
        });
    }
    out
}

/// Kind of mode `j`: sloshing if more than half of its potential energy is in the surface.
fn kind(model: &StripModel, j: usize) -> Kind {
    let phi = model.modes.vectors.column(j);
    let spring = model.tank.liquid.spring();
    let surface: f64 = model.amplitudes.iter().map(|&e| spring * phi[e] * phi[e]).sum();
    if surface > 0.5 * model.modes.omega[j].powi(2) { Kind::Sloshing } else { Kind::Structural }
}

fn shape(model: &StripModel, phi: &[f64]) -> ModeShape {
    let liquid = &model.tank.liquid;
    let amplitudes: Vec<f64> = model.amplitudes.iter().map(|&e| phi[e]).collect();
    let r: Vec<f64> = (0..=SURFACE).map(|i| liquid.half_width * i as f64 / SURFACE as f64).collect();
    let elevation = |x: &f64| {
        let waves = amplitudes.iter().enumerate();
        waves.map(|(n, q)| q * (liquid.wave_number(n) * x).sin()).sum::<f64>()
    };
    let mut shape = ModeShape {
        z: model.tank.levels.clone(),
        wall: model.walls[0].nodes.iter().map(|&node| model.model.at_node(phi, node)[Dof::Ux.index()]).collect(),
        surface: r.iter().map(elevation).collect(),
        r,
    };
    let all = shape.wall.iter().chain(&shape.surface);
    let peak = all.fold(0.0_f64, |m, v| m.max(v.abs()));
    if peak > 0.0 {
        shape.wall.iter_mut().chain(&mut shape.surface).for_each(|v| *v /= peak);
    }
    shape
}

/// Ratios that result at the modes with a share of the mass.
pub(super) fn damping_table(model: &StripModel) -> Vec<DampingRow> {
    let total = dot(&model.system.inertia[0], &model.system.influence[0]);
    let row = |(j, ratio): (usize, &fem::analysis::damping::RatioRow)| {
        let part = dot(&model.system.inertia[0], model.modes.vectors.column(j));
        (part * part > SIGNIFICANT * total).then(|| DampingRow {
            omega: ratio.omega,
            kind: kind(model, j).id().into(),
            ratio: ratio.ratio,
            note: ratio.note.into(),
        })
    };
    model.ratios.iter().enumerate().filter_map(row).collect()
}
