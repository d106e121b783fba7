//! The response mode by mode, per unit of pseudo-acceleration.
//!
//! ```text
//! y_j / S_a = γ_j (a·φ_j − d·φ_j/ω_j²)        y = a·ẍ_total + d·x, ẍ_total = −ω_j² x in a mode without damping
//! rest      = y of the rigid tank − Σ_j y_j/S_a
//! ```
//!
//! Stresses follow the displacements: their rest is the sum over the modes that are not listed.

use fem::linalg::dot;
use results::Channel;
use results::channel::{OnWall, Side};
use results::modal::{Inertia, ModalPart, ModalStress, REST};

use super::model::Model;
use crate::coupled::Coupled;
use crate::modes::{CoupledMode, Kind};
use crate::probe::{ModeSelection, Probe};

/// A mode whose share in every response is below this part of the rigid tank's (of the largest wave) belongs to the rest.
const SMALL: f64 = 1e-3;

/// The modes of horizontal motion that matter, by ascending frequency, and the rest.
///
/// * `hoop`: number of the place of the largest hoop stress on its line; `None` for a wall without hoop stress
pub(super) fn parts(model: &Model, hoop: Option<usize>) -> Vec<ModalPart> {
    let horizontal = &model.horizontal;
    let coupled = &horizontal.coupled;
    let whole = inertia(coupled, |probe| {
        dot_or_zero(&probe.absolute_acceleration, &coupled.influence) + probe.ground_acceleration
    });
    let all: Vec<ModalPart> = horizontal
        .modes
        .iter()
        .map(|mode| part(model, coupled, mode, hoop))
        // An overcritical mode is switched off.
        .filter(|part| part.damping < 1.0)
        .collect();
    let highest = all.iter().map(|p| p.wave).fold(0.0, f64::max);
    let matters = |p: &ModalPart| {
        let share = |value: f64, whole: f64| value.abs() > SMALL * whole.abs();
        let first = p.number == 1 && p.kind != Kind::Rotational.id();
        first
            || share(p.total.shear, whole.shear)
            || share(p.total.moment, whole.moment)
            || share(p.total.overturning, whole.overturning)
            || share(p.wave, highest)
    };
    let mut listed: Vec<ModalPart> = all.into_iter().filter(matters).collect();
    let totals: Vec<Inertia> = listed.iter().map(|p| p.total).collect();
    let every = horizontal.modes.iter().map(|mode| stress(coupled, mode, hoop?));
    let own: Option<Vec<ModalStress>> = listed.iter().map(|p| p.stress).collect();
    let stress = every.collect::<Option<Vec<_>>>().and_then(|every| Some(sum(&every).without(&own?)));
    listed.push(ModalPart {
        kind: REST.into(),
        number: 1,
        period: 0.0,
        damping: 0.0,
        wave: 0.0,
        total: whole.without(&totals),
        structure: None,
        stress,
    });
    listed
}

fn sum(stresses: &[ModalStress]) -> ModalStress {
    stresses
        .iter()
        .fold(ModalStress::default(), |sum, s| ModalStress { hoop: sum.hoop + s.hoop, axial: sum.axial + s.axial })
}

/// Stresses of a mode; `None` if the model does not observe them.
fn stress(coupled: &Coupled, mode: &CoupledMode, hoop: usize) -> Option<ModalStress> {
    let of = |probe: &Probe| response(probe, mode);
    Some(ModalStress {
        hoop: coupled.line(OnWall::Hoop)?.probes.get(hoop).map(of)?,
        axial: coupled.probe(Channel::Base(OnWall::Axial)).map(of)?,
    })
}

/// The response of a mode per unit of its pseudo-acceleration.
fn response(probe: &Probe, mode: &CoupledMode) -> f64 {
    let counts = match probe.modes {
        ModeSelection::All => true,
        ModeSelection::FirstSloshing(most) => mode.kind == Kind::Sloshing && mode.number <= most,
    };
    let acceleration = dot_or_zero(&probe.absolute_acceleration, &mode.vector);
    let displacement = dot_or_zero(&probe.displacement, &mode.vector);
    let value = mode.participation * (acceleration - displacement / (mode.omega * mode.omega));
    if counts { value } else { 0.0 }
}

fn part(model: &Model, coupled: &Coupled, mode: &CoupledMode, hoop: Option<usize>) -> ModalPart {
    let structure = coupled.structure.as_ref().map(|rows| {
        rows.each_ref().map(|[shear, moment]| {
            let of = |row: &[f64]| mode.participation * dot(row, &mode.vector);
            Inertia { shear: of(shear), moment: of(moment), overturning: of(moment) }
        })
    });
    ModalPart {
        kind: mode.kind.id().into(),
        number: mode.number,
        period: std::f64::consts::TAU / mode.omega,
        damping: model.damper.of(mode),
        wave: coupled.probe(Channel::Wave(Side::Front)).map_or(0.0, |p| response(p, mode).abs()),
        total: inertia(coupled, |probe| response(probe, mode)),
        structure,
        stress: hoop.and_then(|place| stress(coupled, mode, place)),
    }
}

/// Shear and moments of a functional of their probes.
fn inertia(coupled: &Coupled, of: impl Fn(&Probe) -> f64) -> Inertia {
    let value = |channel| coupled.probe(channel).map_or(0.0, &of);
    Inertia {
        shear: value(Channel::BaseShear),
        moment: value(Channel::BaseMoment),
        overturning: value(Channel::OverturningMoment),
    }
}

/// The product with a vector; an empty one stands for zeros.
fn dot_or_zero(row: &[f64], x: &[f64]) -> f64 {
    if row.is_empty() { 0.0 } else { dot(row, x) }
}
