//! Crack width of a wall, and its limit for tightness.
//!
//! ```text
//! w_k = s_r,max (ε_sm − ε_cm)
//! ε_sm − ε_cm = max([σ_s − k_t f_ct/ρ_p,eff (1 + α_e ρ_p,eff)]/E_s, 0.6 σ_s/E_s)
//! s_r,max = 3.4 c + 0.425 k_1 k_2 φ/ρ_p,eff      1.3 (h − x) where the bars are wider apart than 5 (c + φ/2)
//! h_c,ef = min(2.5 (h − d), (h − x)/3, h/2)      k_1 = 0.8      k_2 = (ε_1 + ε_2)/(2 ε_1)
//! ```
//!
//! σ_s is that of the cracked elastic section, even where the concrete would not crack: restraint and shrinkage are not known.
//! k_t = 0.4 for lasting loads, 0.6 for an earthquake.
//!
//! Source: EN 1992-1-1:2004 7.3.4; EN 1992-3:2006 7.3.1(111); recalled.

use super::section::{Bars, Face, Section};

/// Duration factor k_t of lasting loads.
pub const LASTING: f64 = 0.4;
/// Duration factor k_t of short loads.
pub const SHORT: f64 = 0.6;

/// Stress state of a cracked section.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cracked {
    /// Depth of the compressed zone x [m]; 0 where the whole section pulls.
    pub compressed: f64,
    /// Strain at the face in tension.
    pub strain: f64,
    /// Strain at the opposite face, tension positive.
    pub opposite: f64,
}

/// Crack width with its parts, SI.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Width {
    /// Stress of the bars [Pa].
    pub stress: f64,
    /// Cover of the bars c [m].
    pub cover: f64,
    /// Diameter of the bars φ [m].
    pub diameter: f64,
    /// Effective height h_c,ef [m].
    pub effective: f64,
    /// ρ_p,eff.
    pub ratio: f64,
    /// k_2.
    pub distribution: f64,
    /// s_r,max [m].
    pub spacing: f64,
    /// ε_sm − ε_cm.
    pub strain: f64,
    /// w_k [m].
    pub width: f64,
    /// Depth of the compressed zone x [m].
    pub compressed: f64,
}

/// Stress state of the cracked section under a force [N/m] and a moment [N·m/m], and the face with the larger strain; none without
/// bars or where nothing pulls.
///
/// The strain is plane, concrete carries compression only. The neutral axis follows from the ratio of the moment to the force, by
/// bisection.
pub fn cracked(section: &Section, n: f64, m: f64) -> Option<(Cracked, Face)> {
    if section.bars.is_empty() {
        return None;
    }
    let faces = if m >= 0.0 { [Face::Inner, Face::Outer] } else { [Face::Outer, Face::Inner] };
    // Unsymmetric bars under a small moment: the face on the side of fewer bars strains more.
    let bent = faces.into_iter().find_map(|face| bent(section, n, m, face));
    bent.or_else(|| {
        let strain = n / sums(section, faces[0], FAR * section.thickness).0;
        let uniform = Cracked { compressed: 0.0, strain, opposite: strain };
        (n > 0.0).then_some((uniform, faces[0]))
    })
}

/// Steps of the bisection: from [`FAR`] to 1e-13 of the thickness.
const STEPS: usize = 64;
/// Depth of the neutral axis, over the thickness, of a strain that is uniform to 1e-6.
const FAR: f64 = -1e6;

/// Force [N/m] and moment about the middle [N·m/m] of a strain that is 1 at the `tension` face and 0 at x [m] from the other.
fn sums(section: &Section, tension: Face, x: f64) -> (f64, f64) {
    let h = section.thickness;
    let strain = |y: f64| (y - x) / (h - x);
    let depth = x.clamp(0.0, h);
    let concrete = 0.5 * section.modulus * strain(0.0).min(0.0) * depth;
    let (mut force, mut moment) = (concrete, concrete * (depth / 3.0 - 0.5 * h));
    for bars in &section.bars {
        let d = section.effective_depth(bars, tension);
        let f = bars.area * bars.modulus * strain(d);
        force += f;
        moment += f * (d - 0.5 * h);
    }
    (force, moment)
}

/// The state with a neutral axis above the `tension` face; none if there is none.
fn bent(section: &Section, n: f64, m: f64, tension: Face) -> Option<(Cracked, Face)> {
    let h = section.thickness;
    let m = match tension {
        Face::Inner => m,
        Face::Outer => -m,
    };
    // M F(x) − N S(x) changes its sign at the neutral axis.
    let difference = |x: f64| {
        let (force, moment) = sums(section, tension, x);
        m * force - n * moment
    };
    let (mut low, mut high) = (FAR * h, h * (1.0 - 1e-9));
    let positive = difference(low) > 0.0;
    if (difference(high) > 0.0) == positive {
        return None;
    }
    for _ in 0..STEPS {
        let x = 0.5 * (low + high);
        if (difference(x) > 0.0) == positive {
            low = x;
        } else {
            high = x;
        }
    }
    let x = 0.5 * (low + high);
    let (force, moment) = sums(section, tension, x);
    let strain = if n.abs() * h > m.abs() { n / force } else { m / moment };
    let state = Cracked { compressed: x.max(0.0), strain, opposite: strain * -x / (h - x) };
    (strain > 0.0).then_some((state, tension))
}

/// Crack width, the larger of both faces where both pull. None without bars at a face that pulls, or without their diameter.
///
/// * `n`, `m`: force [N/m] and moment [N·m/m] of the combination; `tensile`: f_ct,eff [Pa]; `duration`: k_t
pub fn width(section: &Section, n: f64, m: f64, tensile: f64, duration: f64) -> Option<Width> {
    let Some((state, tension)) = cracked(section, n, m) else {
        // Nothing pulls.
        return (!section.bars.is_empty()).then_some(Width::none(section));
    };
    let first = width_at(section, state, tension, tensile, duration)?;
    if state.opposite <= 0.0 {
        return Some(first);
    }
    let (mirrored, other) = (
        Cracked { compressed: 0.0, strain: state.opposite, opposite: state.strain },
        match tension {
            Face::Inner => Face::Outer,
            Face::Outer => Face::Inner,
        },
    );
    let second = width_at(section, mirrored, other, tensile, duration)?;
    Some(if second.width > first.width { second } else { first })
}

/// Crack width at one face, whose strain is `state.strain`.
fn width_at(section: &Section, state: Cracked, tension: Face, tensile: f64, duration: f64) -> Option<Width> {
    let (h, half) = (section.thickness, 0.5 * section.thickness);
    let depth = |b: &&Bars| section.effective_depth(b, tension);
    let layers = || section.bars.iter().filter(|b| section.effective_depth(b, tension) > half);
    let outermost = layers().max_by(|a, b| depth(a).total_cmp(&depth(b)))?;
    let area: f64 = layers().map(|b| b.area).sum();
    let (diameter, d) = (outermost.diameter?, depth(&outermost));
    let x = state.compressed;
    let strain = state.opposite + (state.strain - state.opposite) * d / h;
    let stress = (outermost.modulus * strain).max(0.0);
    let cover = (h - d - 0.5 * diameter).max(0.0);
    let effective = effective_height(h, d, x);
    let ratio = area / effective;
    let distribution = {
        let larger = state.strain.max(state.opposite);
        ((state.strain + state.opposite.max(0.0)) / (2.0 * larger)).clamp(0.5, 1.0)
    };
    let bar_spacing = 0.25 * std::f64::consts::PI * diameter * diameter / outermost.area;
    let spacing = if bar_spacing > 5.0 * (cover + 0.5 * diameter) {
        // Closer bars have the other formula: the larger of the two is safe.
        (1.3 * (h - x)).max(spacing(cover, diameter, ratio, distribution))
    } else {
        spacing(cover, diameter, ratio, distribution)
    };
    let strain = mean_strain(stress, outermost.modulus, section.modulus, tensile, ratio, duration);
    Some(Width {
        stress,
        cover,
        diameter,
        effective,
        ratio,
        distribution,
        spacing,
        strain,
        width: spacing * strain,
        compressed: x,
    })
}

impl Width {
    /// No crack.
    fn none(section: &Section) -> Width {
        Width {
            stress: 0.0,
            cover: 0.0,
            diameter: 0.0,
            effective: 0.0,
            ratio: 0.0,
            distribution: 0.0,
            spacing: 0.0,
            strain: 0.0,
            width: 0.0,
            compressed: section.thickness,
        }
    }
}

/// h_c,ef [m].
fn effective_height(h: f64, d: f64, x: f64) -> f64 {
    (2.5 * (h - d)).min((h - x) / 3.0 * if x > 0.0 { 1.0 } else { f64::INFINITY }).min(0.5 * h)
}

/// s_r,max [m] of bars close together, equation 7.11.
fn spacing(cover: f64, diameter: f64, ratio: f64, distribution: f64) -> f64 {
    3.4 * cover + 0.425 * 0.8 * distribution * diameter / ratio
}

/// ε_sm − ε_cm, equation 7.9.
fn mean_strain(stress: f64, e_s: f64, e_cm: f64, tensile: f64, ratio: f64, duration: f64) -> f64 {
    let stiffening = duration * tensile / ratio * (1.0 + e_s / e_cm * ratio);
    ((stress - stiffening) / e_s).max(0.6 * stress / e_s)
}

/// Mean tensile strength f_ctm [Pa] of f_ck [Pa], EN 1992-1-1 table 3.1.
pub fn tensile_strength(f_ck: f64) -> f64 {
    let mpa = f_ck / 1e6;
    1e6 * if mpa <= 50.0 { 0.3 * mpa.powf(2.0 / 3.0) } else { 2.12 * (1.0 + (mpa + 8.0) / 10.0).ln() }
}

/// Limit of w_k [m]: tightness class 0, and sections of class 1 that are not cracked through (compressed zone at least 50 mm and
/// 0.2 h): 0.3 mm of EN 1992-1-1 table 7.1N. Cracked through, class 1: w_k1, 0.2 mm for h_D/h ≤ 5 to 0.05 mm for h_D/h ≥ 35.
///
/// * `head`: of the liquid h_D [m]; `compressed`: x [m]
pub fn limit(class: u8, head: f64, thickness: f64, compressed: f64) -> f64 {
    // x_min is the lesser of both in EN 1992-3 7.3.1(112); of walls above 25 cm that is 50 mm.
    let closed = compressed >= (0.05f64).min(0.2 * thickness);
    if class == 0 || closed {
        return 0.3e-3;
    }
    let gradient = head / thickness;
    (0.2 - 0.15 * ((gradient - 5.0) / 30.0).clamp(0.0, 1.0)) * 1e-3
}

#[cfg(test)]
mod tests;
