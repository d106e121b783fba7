//! A rigid disc on an elastic half-space or on a layer over rock.
//!
//! ```text
//! K_x = 8 G R/(2 − ν)      K_θ = 8 G R³/(3 (1 − ν))      K_z = 4 G R/(1 − ν)      K_t = 16 G R³/3       G = ρ_s V_s²
//! layer of depth d:  K_x (1 + R/2d)      K_θ (1 + R/6d)      K_z (1 + 1.28 R/d)
//! ```
//!
//! The impedance K(ω) is force over displacement in e^{iωt}; its imaginary part radiates and, with the hysteretic damping ξ_g of the
//! soil, dissipates: K(ω) (1 + 2 i ξ_g).
//!
//! Below its cut-off frequency, V_s/4d for translation, V_La/4d for rocking and the vertical motion, a layer does not radiate; then
//! only the real part is kept.
//!
//! Source: Veletsos & Verbic 1973; Meek & Wolf 1992; Gazetas 1983 (layer). Free field at the ground end, surface foundation.

use std::f64::consts::PI;

use crate::C64;
use crate::error::{SoilError, not_negative, positive};

/// Soil, at the strains of the earthquake.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Soil {
    /// Density ρ_s [kg/m³].
    pub density: f64,
    /// Velocity V_s of shear waves [m/s].
    pub shear_wave_velocity: f64,
    /// Poisson's ratio ν, from 0 to below 0.5.
    pub poisson_ratio: f64,
    /// Hysteretic damping ratio ξ_g.
    pub damping: f64,
    /// Depth d of the layer over rock [m]; none for a half-space.
    pub depth: Option<f64>,
}

/// Stiffnesses [N/m] and [N m].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stiffness {
    /// Horizontal K_x [N/m].
    pub horizontal: f64,
    /// Rocking K_θ [N m].
    pub rocking: f64,
    /// Vertical K_z [N/m].
    pub vertical: f64,
    /// Torsional K_t [N m].
    pub torsional: f64,
}

/// A rigid disc on soil.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Disc {
    /// Radius R [m].
    pub radius: f64,
    /// The soil below.
    pub soil: Soil,
}

/// Which impedance is taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Impedance {
    /// Static stiffness.
    Static,
    /// Fitted functions of Veletsos & Verbic 1973.
    Veletsos,
    /// Cones of Meek & Wolf 1992, which have constant coefficients in time.
    Cone,
}

/// Constant coefficients of the cones.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cones {
    /// Springs.
    pub stiffness: Stiffness,
    /// Horizontal dashpot ρ_s V_s π R² [N s/m].
    pub horizontal_dashpot: f64,
    /// Dashpot C = ρ_s c I₀ between the disc's rotation and the internal one [N m s].
    pub rocking_dashpot: f64,
    /// Moment of inertia M = ρ_s z₀ I₀ of the internal rotation [kg m²].
    pub internal_inertia: f64,
    /// Vertical dashpot ρ_s c π R² [N s/m].
    pub vertical_dashpot: f64,
    /// Soil that moves with the disc vertically, 2.4 (ν − 1/3) ρ_s π R³ for ν > 1/3 [kg].
    pub trapped_mass: f64,
    /// Moment of inertia of the soil that rocks with the disc, 0.3 π (ν − 1/3) ρ_s R⁵ for ν > 1/3 [kg m²].
    pub trapped_inertia: f64,
    /// Time z₀/c of the rocking cone [s].
    pub travel_time: f64,
}

impl Soil {
    /// Shear modulus G = ρ_s V_s² [Pa].
    pub fn shear_modulus(&self) -> f64 {
        self.density * self.shear_wave_velocity.powi(2)
    }

    /// Wave velocity c of the vertical and the rocking cone [m/s]: that of dilatational waves for ν ≤ 1/3, else 2 V_s.
    pub fn cone_velocity(&self) -> f64 {
        let nu = self.poisson_ratio;
        if nu <= 1.0 / 3.0 {
            self.shear_wave_velocity * (2.0 * (1.0 - nu) / (1.0 - 2.0 * nu)).sqrt()
        } else {
            2.0 * self.shear_wave_velocity
        }
    }

    /// Lysmer's analogue velocity V_La = 3.4 V_s/(π (1 − ν)) [m/s].
    pub fn lysmer_velocity(&self) -> f64 {
        3.4 * self.shear_wave_velocity / (PI * (1.0 - self.poisson_ratio))
    }
}

impl Disc {
    /// A disc.
    ///
    /// Errors: a radius, density, velocity or depth that is not above 0, ν outside 0 to 0.5, a negative damping.
    pub fn new(radius: f64, soil: Soil) -> Result<Disc, SoilError> {
        positive("radius of the foundation [m]", radius)?;
        positive("soil density [kg/m3]", soil.density)?;
        positive("shear-wave velocity [m/s]", soil.shear_wave_velocity)?;
        not_negative("damping ratio of the soil", soil.damping)?;
        if let Some(depth) = soil.depth {
            positive("depth of the soil layer [m]", depth)?;
        }
        if !(0.0..0.5).contains(&soil.poisson_ratio) {
            return Err(SoilError::Value {
                what: "Poisson's ratio of the soil",
                found: soil.poisson_ratio,
                expected: "from 0 to below 0.5",
            });
        }
        Ok(Disc { radius, soil })
    }

    /// Static stiffness.
    pub fn stiffness(&self) -> Stiffness {
        let (r, nu, g) = (self.radius, self.soil.poisson_ratio, self.soil.shear_modulus());
        let slender = self.soil.depth.map_or(0.0, |d| r / d);
        Stiffness {
            horizontal: 8.0 * g * r / (2.0 - nu) * (1.0 + slender / 2.0),
            rocking: 8.0 * g * r.powi(3) / (3.0 * (1.0 - nu)) * (1.0 + slender / 6.0),
            vertical: 4.0 * g * r / (1.0 - nu) * (1.0 + 1.28 * slender),
            torsional: 16.0 * g * r.powi(3) / 3.0,
        }
    }

    /// a₀ = ω R/V_s.
    pub fn frequency_parameter(&self, omega: f64) -> f64 {
        omega * self.radius / self.soil.shear_wave_velocity
    }

    /// Cones with the static stiffness of the disc; those of a layer radiate at all frequencies.
    pub fn cones(&self) -> Cones {
        let Soil { density, shear_wave_velocity, poisson_ratio: nu, .. } = self.soil;
        let (r, c) = (self.radius, self.soil.cone_velocity());
        let (area, second) = (PI * r * r, PI * r.powi(4) / 4.0);
        let apex = 9.0 * PI / 32.0 * (1.0 - nu) * (c / shear_wave_velocity).powi(2) * r;
        let trapped = (nu - 1.0 / 3.0).max(0.0);
        Cones {
            stiffness: self.stiffness(),
            horizontal_dashpot: density * shear_wave_velocity * area,
            rocking_dashpot: density * c * second,
            internal_inertia: density * apex * second,
            vertical_dashpot: density * c * area,
            trapped_mass: 2.4 * trapped * density * PI * r.powi(3),
            trapped_inertia: 0.3 * PI * trapped * density * r.powi(5),
            travel_time: apex / c,
        }
    }

    /// Horizontal impedance K_x(ω) [N/m].
    pub fn horizontal(&self, omega: f64, kind: Impedance) -> C64 {
        let static_stiffness = self.stiffness().horizontal;
        let radiates = self.radiates(omega, self.soil.shear_wave_velocity);
        let imaginary = match kind {
            _ if !radiates => 0.0,
            Impedance::Static => 0.0,
            Impedance::Veletsos => {
                self.frequency_parameter(omega) * veletsos(self.soil.poisson_ratio).0 * static_stiffness
            }
            Impedance::Cone => omega * self.cones().horizontal_dashpot,
        };
        self.hysteretic(C64::new(static_stiffness, imaginary))
    }

    /// Rocking impedance K_θ(ω) [N m], without the trapped soil, whose inertia belongs to the base.
    pub fn rocking(&self, omega: f64, kind: Impedance) -> C64 {
        let static_stiffness = self.stiffness().rocking;
        let mut ratio = match kind {
            Impedance::Static => C64::new(1.0, 0.0),
            Impedance::Veletsos => {
                let a0 = self.frequency_parameter(omega);
                let (_, b1, b3) = veletsos(self.soil.poisson_ratio);
                let square = (B2 * a0).powi(2);
                let share = square / (1.0 + square);
                C64::new(1.0 - b1 * share - b3 * a0 * a0, a0 * b1 * B2 * share)
            }
            Impedance::Cone => {
                let cones = self.cones();
                let b0 = omega * cones.travel_time;
                let share = b0 * b0 / (1.0 + b0 * b0);
                let third = cones.rocking_dashpot.powi(2) / (cones.internal_inertia * static_stiffness);
                C64::new(1.0 - third * share, third * b0 * share)
            }
        };
        if !self.radiates(omega, self.soil.lysmer_velocity()) {
            ratio.im = 0.0;
        }
        self.hysteretic(ratio * static_stiffness)
    }

    /// Vertical impedance K_z + i ω C_z of the cone [N/m], without the trapped soil.
    pub fn vertical(&self, omega: f64) -> C64 {
        let cones = self.cones();
        let radiates = self.radiates(omega, self.soil.lysmer_velocity());
        let imaginary = if radiates { omega * cones.vertical_dashpot } else { 0.0 };
        self.hysteretic(C64::new(cones.stiffness.vertical, imaginary))
    }

    fn radiates(&self, omega: f64, velocity: f64) -> bool {
        self.soil.depth.is_none_or(|d| omega >= 2.0 * PI * velocity / (4.0 * d))
    }

    fn hysteretic(&self, impedance: C64) -> C64 {
        impedance * C64::new(1.0, 2.0 * self.soil.damping)
    }
}

/// b₂ of the rocking function.
const B2: f64 = 0.8;

/// Constants of Veletsos & Verbic 1973, linear between their values of ν: b₁ of translation, b₁ and b₃ of rocking.
fn veletsos(nu: f64) -> (f64, f64, f64) {
    const TABLE: [[f64; 4]; 4] =
        [[0.0, 0.775, 0.525, 0.0], [1.0 / 3.0, 0.65, 0.5, 0.0], [0.45, 0.60, 0.45, 0.023], [0.5, 0.60, 0.40, 0.027]];
    let i = TABLE.iter().rposition(|row| row[0] <= nu).unwrap_or(0).min(2);
    let (low, high) = (TABLE[i], TABLE[i + 1]);
    let f = (nu - low[0]) / (high[0] - low[0]);
    let at = |j: usize| low[j] + f * (high[j] - low[j]);
    (at(1), at(2), at(3))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn soil(poisson_ratio: f64) -> Soil {
        Soil { density: 1900.0, shear_wave_velocity: 250.0, poisson_ratio, damping: 0.0, depth: None }
    }

    /// The rocking spring of a disc of R = 13.9 m at V_s = 250 m/s is 1.3e12 N m/rad.
    #[test]
    fn rocking_spring_of_a_tank() {
        let disc = Disc::new(13.9, soil(1.0 / 3.0)).unwrap();
        assert!((disc.stiffness().rocking / 1.3e12 - 1.0).abs() < 0.03);
    }

    fn close(found: f64, wanted: f64) {
        assert!((found - wanted).abs() <= 1e-12 * wanted.abs(), "{found}, not {wanted}");
    }

    /// By hand: G = 2·10⁷ Pa, R = 2 m, ν = 0.25 on a layer of 4 m, R/d = 1/2.
    #[test]
    fn springs_of_a_layer() {
        let layer =
            Soil { density: 2000.0, shear_wave_velocity: 100.0, poisson_ratio: 0.25, damping: 0.0, depth: Some(4.0) };
        let found = Disc::new(2.0, layer).unwrap().stiffness();
        close(found.horizontal, 3.2e8 / 1.75 * 1.25);
        close(found.rocking, 1.28e9 / 2.25 * 13.0 / 12.0);
        close(found.vertical, 1.6e8 / 0.75 * 1.64);
        close(found.torsional, 2.56e9 / 3.0);
    }

    /// By hand, ρ = 2000 kg/m³, V_s = 100 m/s, R = 2 m, so that the area is 4π and I₀ too: ν = 0.45 with c = 2 V_s and trapped soil, ν = 0.25 with
    /// c = √3 V_s and none. At ν = 1/3 dilatational waves have 2 V_s as well.
    #[test]
    fn cones_by_hand() {
        let cones = |poisson_ratio| {
            let soil = Soil { density: 2000.0, shear_wave_velocity: 100.0, ..soil(poisson_ratio) };
            (Disc::new(2.0, soil).unwrap().cones(), soil.cone_velocity())
        };
        // z₀ = 9π/32 (1 − ν) (c/V_s)² R.
        for (nu, velocity, apex, mass, inertia) in [
            (0.45, 200.0, 1.2375 * PI, 4480.0 * PI, 2240.0 * PI),
            (0.25, 100.0 * 3.0_f64.sqrt(), 1.265_625 * PI, 0.0, 0.0),
            (1.0 / 3.0, 200.0, 1.5 * PI, 0.0, 0.0),
        ] {
            let (found, c) = cones(nu);
            close(c, velocity);
            close(found.horizontal_dashpot, 8e5 * PI);
            close(found.vertical_dashpot, 8e3 * PI * velocity);
            close(found.rocking_dashpot, 8e3 * PI * velocity);
            close(found.internal_inertia, 8e3 * PI * apex);
            close(found.travel_time, apex / velocity);
            close(found.trapped_mass, mass);
            close(found.trapped_inertia, inertia);
        }
    }

    /// The constants of Veletsos & Verbic 1973, table 1, and halfway between two of them, at a₀ = 1.25 where (b₂ a₀)² = 1:
    /// K_x/K = 1 + i a₀ b₁, K_θ/K = 1 − b₁/2 − b₃ a₀² + i b₁/2.
    #[test]
    fn functions_of_veletsos_and_verbic() {
        for (nu, translation, rocking, third) in [
            (0.0, 0.775, 0.525, 0.0),
            (1.0 / 6.0, 0.7125, 0.5125, 0.0),
            (1.0 / 3.0, 0.65, 0.5, 0.0),
            (0.45, 0.60, 0.45, 0.023),
            (0.475, 0.60, 0.425, 0.025),
        ] {
            let disc = Disc::new(10.0, soil(nu)).unwrap();
            let omega = 1.25 * 25.0;
            let found = disc.horizontal(omega, Impedance::Veletsos) / disc.stiffness().horizontal;
            assert!((found - C64::new(1.0, 1.25 * translation)).norm() < 1e-12, "{nu}: {found}");
            let found = disc.rocking(omega, Impedance::Veletsos) / disc.stiffness().rocking;
            let wanted = C64::new(1.0 - 0.5 * rocking - 1.5625 * third, 0.5 * rocking);
            assert!((found - wanted).norm() < 1e-12, "{nu}: {found} {wanted}");
        }
    }

    /// A layer radiates above V_s/4d, in rocking and up and down above V_La/4d; above it a cone has the dashpot of its area, and in rocking that of I₀
    /// where the disc turns fast. Hysteresis turns the impedance by 2 ξ_g.
    #[test]
    fn a_layer_radiates_above_its_cut_off_only() {
        let layer = Soil { depth: Some(20.0), ..soil(0.3) };
        let disc = Disc::new(10.0, layer).unwrap();
        let cones = disc.cones();
        type Function = fn(&Disc, f64) -> C64;
        let shear: [Function; 2] = [
            |disc, omega| disc.horizontal(omega, Impedance::Cone),
            |disc, omega| disc.horizontal(omega, Impedance::Veletsos),
        ];
        let lysmer: [Function; 3] = [
            |disc, omega| disc.rocking(omega, Impedance::Cone),
            |disc, omega| disc.rocking(omega, Impedance::Veletsos),
            |disc, omega| disc.vertical(omega),
        ];
        for (velocity, functions) in [(250.0, &shear[..]), (3.4 * 250.0 / (0.7 * PI), &lysmer)] {
            let cut_off = 2.0 * PI * velocity / 80.0;
            for f in functions {
                assert_eq!(f(&disc, 0.99 * cut_off).im, 0.0);
                assert!(f(&disc, 1.01 * cut_off).im > 0.0);
            }
        }
        close(disc.horizontal(100.0, Impedance::Cone).im, 100.0 * cones.horizontal_dashpot);
        close(disc.vertical(100.0).im, 100.0 * cones.vertical_dashpot);
        let fast = disc.rocking(1e6, Impedance::Cone).im / (1e6 * cones.rocking_dashpot);
        assert!((fast - 1.0).abs() < 1e-6, "{fast}");
        let turned = Disc { soil: Soil { damping: 0.1, ..layer }, ..disc };
        let (a, b) = (disc.vertical(100.0), turned.vertical(100.0));
        assert!((b / a - C64::new(1.0, 0.2)).norm() < 1e-12);
    }

    #[test]
    fn impossible_soils_are_errors() {
        assert!(Disc::new(0.0, soil(0.3)).is_err());
        assert!(Disc::new(10.0, soil(0.5)).is_err());
        assert!(Disc::new(f64::NAN, soil(0.3)).is_err());
        assert!(Disc::new(10.0, Soil { depth: Some(-1.0), ..soil(0.3) }).is_err());
    }
}
