//! Mesh of the liquid, as fine at the wall as the waves of the wall that the ground motion excites.
//!
//! A wall that bends in half-waves of length π/k over the depth moves the liquid next to it by e^{−k (R − r)}: the outermost element of the
//! default mesh, 0.15 R, is longer than 1/k in broad tanks, and eight elements over the depth hold three half-waves badly. Structural mode
//! 3 of a tank with H/R = 0.3 is then 3 % too high and its pressure 6 % off.
//!
//! ```text
//! k_n = (n − ½) π/H                                                                    clamped below, free surface above
//! ω²(k) = [E t/R² λ⁴/(λ² + 1)² + D (λ² + 1)²/R⁴] / (ρ_s t + ρ R/√(1 + λ²))              λ = k R   (shell, Donnell; m = 1)
//! ω²(k) = D k⁴/(ρ_s t + ρ/k)                                                            (plane strip)
//! k from ω(k) = 1.25 · 2π f                 f: 99 % of the energy of the record lies below; of a site without record 20 Hz
//! elements    at least 2.5 k H over the depth; the outermost element is halved until it is at most 0.8/k;  k ≤ 2.5 π/H
//! ```
//!
//! The added mass R/√(1 + λ²) is I_1(λ)/(k I_1'(λ)) within 15 %; with it ω(k_n) is that of the coupled modes within 6 % for uniform walls
//! and at most 16 % above it for walls that are thinner towards the top, which the factor 1.25 covers. Beyond the third half-wave modes
//! carry at most 0.3 % of the mass of the liquid in tanks of steel up to H/R = 3: their number would be paid by all runs.

use std::f64::consts::{PI, TAU};

use fem::liquid::{LiquidMesh, scaled};
use results::Labelled;
use tank::case::GroundMotion;
use tank::units::significant;
use tank::{Case, Shape, Tank};

use super::content::frequency_of_share;

/// Share of a record's energy that lies below its content's end.
const SHARE: f64 = 0.99;
/// End of the content of design spectra without a record [Hz]: they rise to their plateau from T = 0.05 s at the earliest
/// (EN 1998-1:2004 table 3.3, ground A and spectrum 2).
const SITE: f64 = 20.0;
/// Margin for walls with courses, of which the equivalent uniform wall is up to 16 % too stiff.
const MARGIN: f64 = 1.25;
/// Elements over the depth for k H = 1.
const VERTICAL: f64 = 2.5;
/// Longest outermost element over 1/k.
const OUTERMOST: f64 = 0.8;
/// Half-waves that are resolved at most.
const HALF_WAVES: f64 = 3.0;
/// Breaks of the default mesh but for the wall, r/R (`LiquidMesh::graded`), and the length of its outermost element.
const BREAKS: [f64; 5] = [0.0, 0.25, 0.5, 0.7, 0.85];
const LAST: f64 = 0.15;
/// Default elements over the depth, the grading towards the surface, and the slenderness from which there are more of them.
const DEFAULT: f64 = 8.0;
const GRADING: f64 = 1.3;
const SLENDER: f64 = 2.7;

/// What the mesh of a case is made for.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Aim {
    /// End of the content [Hz].
    frequency: f64,
    /// Whether that of a record.
    record: bool,
    /// Wave number k of the wall, at most three half-waves [1/m].
    wave: f64,
    /// Whether the content reaches beyond three half-waves.
    beyond: bool,
}

/// End of the content of a motion [Hz]: of its components the highest.
pub(crate) fn content(motion: &GroundMotion) -> f64 {
    let all = [Some(&motion.horizontal), motion.transverse.as_ref(), motion.vertical.as_ref()];
    let each = all.into_iter().flatten().map(|r| frequency_of_share(r, SHARE));
    each.fold(0.0, f64::max)
}

impl Aim {
    /// Aim for a case; `None` without ground motion and site.
    fn of(case: &Case) -> Option<Aim> {
        let (frequency, record) = match &case.ground_motion {
            Some(motion) => (content(motion), true),
            None => (SITE, false),
        };
        if !record && !case.site.is_given() {
            return None;
        }
        let most = (HALF_WAVES - 0.5) * PI / case.liquid.fill_height;
        let excited = MARGIN * TAU * frequency;
        let beyond = wall_frequency(case, most) < excited;
        let wave = if beyond { most } else { wave_number(case, excited, most) };
        Some(Aim { frequency, record, wave, beyond })
    }
}

/// Circular frequency [rad/s] of waves of wave number `k` [1/m] of the wetted wall, by its mean thickness.
fn wall_frequency(case: &Case, k: f64) -> f64 {
    let (stretch, bending, mass) = mean_wall(&case.tank, case.liquid.fill_height);
    let density = case.liquid.density;
    let (stiffness, liquid) = match case.tank.shape {
        Shape::Cylinder { radius } => {
            let square = (k * radius).powi(2) + 1.0;
            let membrane = stretch / radius.powi(2) * ((square - 1.0) / square).powi(2);
            (membrane + bending * (square / radius.powi(2)).powi(2), density * radius / square.sqrt())
        }
        Shape::Rectangle { .. } => (bending * k.powi(4), density / k),
    };
    (stiffness / (mass + liquid)).sqrt()
}

/// Wave number up to `most` [1/m] at which waves of the wall have the circular frequency `omega` [rad/s]; ω(k) grows with k.
fn wave_number(case: &Case, omega: f64, most: f64) -> f64 {
    let (mut low, mut high) = (0.0, most);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if wall_frequency(case, middle) < omega {
            low = middle;
        } else {
            high = middle;
        }
    }
    high
}

/// E t [N/m], D [N m] and mass [kg/m²] of the wall, means over the wetted height.
fn mean_wall(tank: &Tank, depth: f64) -> (f64, f64, f64) {
    let (mut bottom, mut sums) = (0.0, (0.0, 0.0, 0.0));
    for course in &tank.courses {
        let top = (bottom + course.height).min(depth);
        let share = (top - bottom).max(0.0) / depth;
        let (e, nu, t) = (course.material.youngs_modulus, course.material.poisson_ratio, course.thickness);
        sums.0 += share * e * t;
        sums.1 += share * e * t.powi(3) / (12.0 * (1.0 - nu * nu));
        sums.2 += share * course.material.density * t;
        bottom += course.height;
    }
    sums
}

/// Numbers of elements along radius and depth before refinement, and the elements that take the place of the outermost one.
fn counts(case: &Case, aim: Option<Aim>) -> Option<(f64, u32)> {
    let (half, depth) = (case.tank.shape.half_length(), case.liquid.fill_height);
    let default = DEFAULT * (depth / half / SLENDER).max(1.0);
    let wave = aim?.wave;
    let vertical = (VERTICAL * wave * depth).ceil().max(default);
    let parts = (1..=6).find(|&j| LAST * half / f64::from(2_u32.pow(j) - 1) <= OUTERMOST / wave).unwrap_or(6);
    (parts > 1 || vertical > default).then_some((vertical, parts))
}

/// The mesh of a case; the default one where it suffices. Every count is multiplied by `refine`.
pub(super) fn mesh(case: &Case, refine: f64) -> LiquidMesh {
    let (half, depth) = (case.tank.shape.half_length(), case.liquid.fill_height);
    let Some((vertical, parts)) = counts(case, Aim::of(case)) else { return LiquidMesh::graded(half, depth, refine) };
    // Elements 2^(j−1), …, 2, 1 parts of the outermost one.
    let smallest = LAST / f64::from(2_u32.pow(parts) - 1);
    let inner = (0..parts).rev().map(|j| 1.0 - smallest * f64::from(2_u32.pow(j) - 1));
    let breaks: Vec<f64> = BREAKS.into_iter().chain(inner).collect();
    let (last, radial) = (breaks.len() - 1, scaled((breaks.len() - 1) as f64, refine));
    let vertical = scaled(vertical, refine);
    let at = |i: usize| {
        let place = i as f64 / radial as f64 * last as f64;
        let k = (place as usize).min(last - 1);
        half * (breaks[k] + (breaks[k + 1] - breaks[k]) * (place - k as f64))
    };
    let height = |j: usize| depth * (1.0 - (1.0 - j as f64 / vertical as f64).powf(GRADING));
    LiquidMesh {
        r: with_midpoints((0..=radial).map(at).collect()),
        z: with_midpoints((0..=vertical).map(height).collect()),
    }
}

/// Numbers of elements of [`mesh`] along radius and depth, without making it.
pub(super) fn elements(case: &Case, refine: f64) -> [f64; 2] {
    let slender = (case.liquid.fill_height / case.tank.shape.half_length() / SLENDER).max(1.0);
    let (vertical, parts) = counts(case, Aim::of(case)).unwrap_or((DEFAULT * slender, 1));
    let radial = (BREAKS.len() - 1) as f64 + f64::from(parts);
    [radial, vertical].map(|count| (count * refine).round().max(2.0))
}

fn with_midpoints(corners: Vec<f64>) -> Vec<f64> {
    let mut nodes = vec![corners[0]];
    for pair in corners.windows(2) {
        nodes.extend([0.5 * (pair[0] + pair[1]), pair[1]]);
    }
    nodes
}

/// What the mesh is made for, in words; none without ground motion and site.
pub(super) fn label(case: &Case) -> Option<Labelled> {
    let aim = Aim::of(case)?;
    let source = if aim.record { "99 % of the record's energy lies below" } else { "design spectra without a record" };
    let content = format!("{} Hz ({source})", significant(aim.frequency, 3));
    let text = match counts(case, Some(aim)) {
        None => format!("the default suffices for structural modes up to {content}"),
        Some(_) if aim.beyond => {
            format!("three half-waves of the wall over the depth; the content reaches beyond them, up to {content}")
        }
        Some(_) => format!(
            "structural modes up to {content}: half-waves of the wall down to {} m",
            significant(PI / aim.wave, 3)
        ),
    };
    Some(Labelled { label: "mesh of the liquid follows".into(), text })
}

#[cfg(test)]
mod tests;
