//! Concrete: cracks with fracture energy, plastic or crushing compression.
//!
//! ```text
//! CrackedConcrete    N = 3   layers: two fixed orthogonal cracks, plastic compression
//! UniaxialConcrete   N = 1   one axis: fibres of beams, rings
//! ```
//! A crack opens by a crack strain e, added to the elastic and the plastic strain; its traction softens by the
//! fracture energy G_f over the element size h ([`Tension`]), so that a localised crack consumes G_f on any mesh. A
//! closed crack carries full compression, and reopens along the secant to its largest opening: no second cracking
//! strength.
//!
//! Strengths are positive numbers, stresses and strains positive in tension.

pub mod bond;
pub mod cracked;
mod surface;
mod tension;
pub mod uniaxial;

pub use bond::{Bond, Conditions};
pub use cracked::{CrackAxes, CrackedConcrete, CrackedParameters, Envelope, ShearRetention};
pub use tension::{Softening, Stiffening, Tension};
pub use uniaxial::{Compression, PostPeak, UniaxialConcrete};

/// Length over which a crack in a rectangular cell is smeared [m]: the side next to its normal.
///
/// The extent of the cell along the normal itself would vary with the angle, and the traction of a beginning crack with the direction of its strain.
///
/// * `sides`: along axes 1 and 2 [m]
/// * `angle`: of the normal from axis 1 [rad]
///
/// Source: Bažant & Oh 1983 (a crack is spread over one element).
pub fn crack_band([first, second]: [f64; 2], angle: f64) -> f64 {
    let (s, c) = angle.sin_cos();
    if c.abs() >= s.abs() { first } else { second }
}

/// Share of the snap-back bound E G_f/f_t² that an element may have.
pub const SIZE_MARGIN: f64 = 0.98;

/// Fracture energy G_f [N/m] of concrete of ordinary weight.
///
/// ```text
/// G_f = 73 f_cm^0.18        f_cm in MPa
/// ```
///
/// * `mean_strength`: mean compressive strength f_cm [Pa]
///
/// Source: fib Model Code 2010, eq. (5.1-9).
pub fn fracture_energy(mean_strength: f64) -> f64 {
    73.0 * (mean_strength / 1e6).powf(0.18)
}

/// Strain ε_c1 at the peak of the compressive stress, positive.
///
/// ```text
/// ε_c1 = 0.7 f_cm^0.31 / 1000 ≤ 2.8 / 1000        f_cm in MPa
/// ```
///
/// * `mean_strength`: mean compressive strength f_cm [Pa]
///
/// Source: EN 1992-1-1:2004, table 3.1.
pub fn peak_strain(mean_strength: f64) -> f64 {
    (0.7e-3 * (mean_strength / 1e6).powf(0.31)).min(2.8e-3)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// EN 1992-1-1:2004, table 3.1: C20/25, C30/37, C50/60, C90/105; printed to a tenth (C50/60: to 0.05) of a thousandth.
    #[test]
    fn peak_strains_of_the_table() {
        for (mean, printed, rounding) in
            [(28e6, 2.0e-3, 5e-5), (38e6, 2.2e-3, 5e-5), (58e6, 2.45e-3, 2.5e-5), (98e6, 2.8e-3, 5e-5)]
        {
            let found = peak_strain(mean);
            assert!((found - printed).abs() <= rounding, "{mean}: {found}");
        }
    }

    /// By hand: 73 · 38^0.18 = 73 · 1.92469, 73 · 1 at 1 MPa.
    #[test]
    fn fracture_energy_by_hand() {
        assert!((fracture_energy(38e6) - 140.50).abs() < 0.01);
        assert!((fracture_energy(1e6) - 73.0).abs() < 1e-12);
    }
}
