//! Values that are allowed and that hardly any tank has: used, with a warning and a line in the summary.

use tank::case::{Case, Combination};
use tank::options::linear::DampingModel;
use tank::options::{LinearOptions, NonlinearOptions, nonlinear};
use tank::units::{Dimension, display};
use tank::{Anchors, Pipes};

use super::damping::USUAL;
use crate::input::tank::resolver::Resolver;

/// Design tension of one anchor [N], from a bolt of 12 mm to a strap of 100 cm² of steel.
const TENSION: (f64, f64) = (5e3, 3e6);
/// Largest usual strength of an attachment, which is designed for three times the tension [N].
const ATTACHMENT: f64 = 3.0 * TENSION.1;
/// Least usual distance of anchors [m]: chairs stand beside each other; a small tank has a few of them closer.
const APART: f64 = 0.4;
const FEW: u32 = 12;
/// Largest usual displacement that a pipe can bear [m], and distance to its first support [m].
const PIPE: f64 = 0.5;
const SUPPORT: f64 = 50.0;
/// Largest usual damping of a wall of metal: 0.02 by EN 1998-4 2.3.3, 0.05 in the spectrum of ASCE 7.
const METAL: f64 = 0.05;

/// All of them.
pub(super) fn warn(r: &mut Resolver<'_>, case: &Case, linear: &LinearOptions, nonlinear: &NonlinearOptions) {
    if let Some(given) = &case.tank.anchors {
        anchors(r, given, case.tank.perimeter());
    }
    if let Some(given) = &case.tank.pipes {
        pipes(r, given);
    }
    if case.procedures.ec8_combination == Combination::Srss {
        let asked = "EN 1998-4:2006 A.3.2.1 asks for the sum of absolute values";
        r.unusual("procedures.ec8.combination", "srss", asked);
    }
    if case.tank.wall_materials().all(|material| material.is_metal()) {
        damping(r, case, linear, nonlinear);
    }
}

fn anchors(r: &mut Resolver<'_>, given: &Anchors, around: f64) {
    let most = (around / APART).floor();
    if given.count > FEW && f64::from(given.count) > most {
        let apart = display(APART, Dimension::Length);
        let usual = format!("usual are at most {} on this wall, one every {apart}", most.max(f64::from(FEW)));
        r.unusual("tank.anchors.count", &given.count.to_string(), &usual);
    }
    for (key, force, most) in [
        ("capacity", given.capacity, TENSION.1),
        ("yield_force", given.yield_force, TENSION.1),
        ("attachment_capacity", given.attachment_capacity, ATTACHMENT),
    ] {
        let Some(force) = force.filter(|force| *force < TENSION.0 || *force > most) else { continue };
        let [found, least, most] = [force, TENSION.0, most].map(|force| display(force, Dimension::Force));
        r.unusual(&format!("tank.anchors.{key}"), &found, &format!("usual is {least} to {most}"));
    }
}

fn pipes(r: &mut Resolver<'_>, given: &Pipes) {
    for (key, length, most) in [
        ("support_distance", given.support_distance, SUPPORT),
        ("allowable_displacement", given.allowable_displacement, PIPE),
        ("uplift", given.uplift, PIPE),
        ("settlement", given.settlement, PIPE),
        ("horizontal", given.horizontal, PIPE),
    ] {
        if let Some(length) = length.filter(|length| *length > most) {
            let [found, most] = [length, most].map(|length| display(length, Dimension::Length));
            r.unusual(&format!("tank.pipes.{key}"), &found, &format!("usual is up to {most}"));
        }
    }
}

/// Ratios of a wall of metal, of the case and of the engines that have their own.
fn damping(r: &mut Resolver<'_>, case: &Case, linear: &LinearOptions, nonlinear: &NonlinearOptions) {
    let of_linear = match &linear.damping {
        DampingModel::Rayleigh { first, second, .. } => first.1.max(second.1),
        DampingModel::ByGroup { wall, .. } => *wall,
        _ => 0.0,
    };
    let of_nonlinear = match &nonlinear.damping {
        nonlinear::Damping::ByGroup { wall, .. } => *wall,
        nonlinear::Damping::Rayleigh { first, second, .. } => first.1.max(second.1),
        nonlinear::Damping::MassProportional { ratio, .. } => *ratio,
    };
    let own = case.damping.impulsive;
    for (path, ratio) in
        [("damping.impulsive", own), ("analysis.damping", of_linear), ("analysis.nonlinear.damping", of_nonlinear)]
    {
        // An engine without its own takes that of the case; the range of the key names what lies above its own limit.
        let told = match path {
            "damping.impulsive" => ratio > USUAL,
            _ => ratio == own,
        };
        if ratio > METAL && !told {
            let usual = format!("usual of a wall of metal is up to {METAL}");
            r.unusual(path, &ratio.to_string(), &usual);
        }
    }
}
