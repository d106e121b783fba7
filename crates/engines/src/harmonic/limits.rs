//! Assumptions of the linear engine, and cases outside its range of validity.

use std::f64::consts::PI;
use tank::Case;
use tank::{Shape, Support, WallBase};

use crate::fittings;
use crate::modes::Kind;
use results::Mode;

/// Bulging frequency over the lowest acoustic frequency above which compressibility is mentioned; its relative effect is
/// about half the square of the ratio, 4.5 % here.
const ACOUSTIC_RATIO: f64 = 0.3;

/// Thickness over radius above which a thin shell (no shear deformation, one radius) is no longer a good model.
const THICK: f64 = 0.1;

/// The foot of a cylinder's wall.
pub(crate) const CLAMPED: &str = "The wall is clamped at its base to rigid ground.";
/// The foot of a wall of concrete that turns on its base.
const HINGED: &str = "The foot of the wall turns freely on rigid ground.";
/// The foot of one that slides.
const SLIDING: &str = "The foot of the wall turns freely on rigid ground and moves along the radius against the stiffness of its bearing; \
    along the circumference it is held. Friction of the joint is left out.";
/// The foot of one on isolators.
const ON_SLAB: &str = "The wall is clamped at its base to the rigid slab, which moves on its isolators.";
/// The foot of an unanchored one.
pub(crate) const IN_CONTACT: &str =
    "The tank is unanchored, but the engine keeps it in contact with the ground: no uplift.";

/// Assumptions of the model for this case, one sentence each.
///
/// * `plates`: whether the walls of a box are plates, whose engine states what it assumes of them
/// * `isolated`: whether the engine moves the tank on its isolators
pub(crate) fn assumptions(case: &Case, plates: bool, isolated: bool) -> Vec<String> {
    let mut out = vec![
        "The liquid is inviscid and incompressible, its waves are small (linear potential theory about the state of rest)."
            .to_owned(),
        format!(
            "The liquid stays in contact with the wall everywhere; the bottom is rigid and follows the {}.",
            if isolated { "slab" } else { "ground" }
        ),
        "The wall is linear elastic and thin; hydrostatic and self-weight stresses do not stiffen it.".to_owned(),
    ];
    match case.tank.shape {
        Shape::Cylinder { .. } => {
            let foot = match case.tank.wall_base {
                WallBase::Hinged => HINGED,
                WallBase::Sliding { .. } => SLIDING,
                WallBase::Fixed if isolated => ON_SLAB,
                WallBase::Fixed => CLAMPED,
            };
            out.push(foot.to_owned());
            if case.tank.support == Support::Unanchored {
                out.push(IN_CONTACT.to_owned());
            }
            if case.tank.roof.mass > 0.0 && case.tank.roof.holds.is_free() {
                out.push(
                    "The roof is a ring of mass on the top edge, its centre joined rigidly to the edge; it does not \
                     stiffen the wall."
                        .to_owned(),
                );
            }
        }
        Shape::Rectangle { .. } if plates => {}
        Shape::Rectangle { strip, .. } => {
            out.push(
                "The two walls across the shaking are cantilevers in plane strain, clamped at the base; what ties them \
                 together at the corners or the top is left out."
                    .to_owned(),
            );
            if !strip {
                out.push(
                    "The tank is modelled as a strip of its breadth: the side walls are rigid and follow the ground; \
                     their mass, and their share of the roof by length, counts in the base reactions."
                        .to_owned(),
                );
            }
        }
    }
    out.extend(fittings::assumptions(&case.tank, false));
    out
}

/// Warnings that follow from the modes of a case, one sentence each.
pub fn notes(case: &Case, modes: &[Mode]) -> Vec<String> {
    let mut out = Vec::new();
    let structural =
        |harmonic: u32| modes.iter().find(move |m| m.harmonic == harmonic && m.kind == Kind::Structural.id());
    let sound = case.liquid.sound();
    let acoustic = sound / (4.0 * case.liquid.fill_height);
    let of_water = if case.liquid.bulk_modulus.is_some() { "" } else { ", water" };
    for (harmonic, name) in [(1, "bulging"), (0, "breathing")] {
        let Some(mode) = structural(harmonic) else { continue };
        let frequency = mode.omega / (2.0 * PI);
        if frequency > ACOUSTIC_RATIO * acoustic {
            out.push(format!(
                "compressibility: the first {name} mode ({frequency:.1} Hz) lies above {ACOUSTIC_RATIO} of the lowest \
                 acoustic frequency c/(4 H) = {acoustic:.1} Hz (c = {sound:.0} m/s{of_water}); the liquid is taken as \
                 incompressible, which changes that frequency by about {:.0} %",
                50.0 * (frequency / acoustic).powi(2)
            ));
        }
    }
    if modes.iter().any(|m| m.harmonic >= 2 && m.kind == Kind::Structural.id()) {
        out.push(
            "structural modes with two or more waves around the circumference are without the stiffening by the \
             hydrostatic hoop tension and come out too low"
                .to_owned(),
        );
    }
    if let Shape::Cylinder { radius } = case.tank.shape {
        let thickest = case.tank.courses.iter().fold(0.0_f64, |m, c| m.max(c.thickness));
        if thickest > THICK * radius {
            out.push(format!(
                "thick wall: t/R = {:.2} exceeds {THICK}; shear deformation of the wall is left out",
                thickest / radius
            ));
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::harmonic::{modes, test_tanks};
    use tank::options::LinearOptions as Options;

    /// The broad tank: 26.2 Hz against 0.3 · 235 Hz, thin wall. A stiff deep one of concrete must warn twice.
    #[test]
    fn warns_where_it_should() {
        let case = test_tanks::broad();
        let found = modes(&case, &Options::default(), &[0, 1], 2).unwrap();
        assert_eq!(notes(&case, &found), Vec::<String>::new());

        let deep =
            test_tanks::case(Shape::Cylinder { radius: 4.0 }, &[(20.0, 0.5)], (30e9, 0.2, 2500.0), (1000.0, 19.0));
        let found = modes(&deep, &Options::default(), &[0, 1], 2).unwrap();
        let notes = notes(&deep, &found);
        assert!(notes.iter().any(|n| n.starts_with("compressibility")), "{notes:?}");
        assert!(notes.iter().any(|n| n.starts_with("thick wall")), "{notes:?}");
    }
}
