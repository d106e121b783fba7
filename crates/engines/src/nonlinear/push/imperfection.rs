//! Imperfections: a weld depression around the tank, or the buckling mode.
//!
//! ```text
//! w = δ e^{−πx/λ} (cos πx/λ + sin πx/λ) ,   x = |z − z_0| ,   λ = π √(R t)/(3 (1 − ν²))^¼
//! ```
//!
//! the depression of a circumferential weld, here also outwards (δ > 0): at the base that is the shape of the buckle itself. The
//! quality classes of EN 1993-1-6 for the amplitude, δ = √(R/t) t/Q with Q = 40 (A, excellent), 25 (B, high), 16 (C, normal).
//!
//! The mode moves every node by δ φ and turns its normal by the rotations of φ, which is 1 where its radial part is largest: the
//! surface stays smooth and the supports where they are. See `buckling` for φ.
//!
//! Source: Rotter & Teng 1989 (type A); EN 1993-1-6:2007, 8.7.2 and table D.2 (recalled).

use std::f64::consts::PI;

use nalgebra::Vector3;
use tank::imperfection::Deviation;

use crate::out_of_round::place;

/// How large an imperfection is asked for.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub enum Amplitude {
    /// In thicknesses of the wall where it stands, outwards positive.
    Thicknesses(f64),
    /// In metres, outwards positive.
    Length(f64),
    /// By the fabrication quality parameter Q, outwards.
    Quality(Quality),
}

/// Fabrication tolerance quality class of EN 1993-1-6.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize)]
pub enum Quality {
    /// Excellent, Q = 40.
    A,
    /// High, Q = 25.
    B,
    /// Normal, Q = 16.
    C,
}

impl Quality {
    /// Q.
    pub fn parameter(self) -> f64 {
        match self {
            Quality::A => 40.0,
            Quality::B => 25.0,
            Quality::C => 16.0,
        }
    }

    /// Letter.
    pub fn name(self) -> char {
        match self {
            Quality::A => 'A',
            Quality::B => 'B',
            Quality::C => 'C',
        }
    }
}

impl Amplitude {
    /// δ [m] on a wall of thickness `t` and radius `radius` [m].
    pub fn of_wall(self, t: f64, radius: f64) -> f64 {
        match self {
            Amplitude::Thicknesses(n) => n * t,
            Amplitude::Length(l) => l,
            Amplitude::Quality(q) => (radius / t).sqrt() * t / q.parameter(),
        }
    }

    /// Its source in words; `shape` describes the shape.
    pub fn source(self, shape: &str) -> String {
        match self {
            Amplitude::Quality(q) => {
                format!("{shape}; amplitude √(R/t) t/{} of EN 1993-1-6, quality class {}", q.parameter(), q.name())
            }
            _ => format!("{shape}; amplitude as given"),
        }
    }
}

/// The form of an imperfection.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Serialize)]
pub enum Form {
    /// The depression of a circumferential weld.
    #[default]
    Weld,
    /// The lowest linear buckling mode of the loaded tank.
    Mode,
}

/// What is wrong with a shell, node by node.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Dent {
    /// A depression around the tank.
    Weld(Depression),
    /// Displacements and rotations of the nodes `[ring][angle]`, global components.
    Mode(Vec<Vec<[Vector3<f64>; 2]>>),
}

impl Dent {
    /// Displacement of a node and its normal there, of any length.
    ///
    /// * `node`: ring and angle, by number; `angle` [rad], `z` [m]
    pub(super) fn at(&self, node: (usize, usize), angle: f64, z: f64) -> (Vector3<f64>, Vector3<f64>) {
        let (s, c) = angle.sin_cos();
        let radial = Vector3::new(c, s, 0.0);
        match self {
            Dent::Weld(depression) => {
                let (w, along_z) = depression.at(z);
                let along_theta = 0.0;
                place(depression.radius, angle, Deviation { w, along_theta, along_z })
            }
            Dent::Mode(field) => {
                let [moved, turned] = field[node.0][node.1];
                (moved, radial + turned.cross(&radial))
            }
        }
    }
}

/// A depression that goes around the tank.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Depression {
    /// R [m].
    pub(super) radius: f64,
    /// δ [m], outwards positive.
    pub(super) amplitude: f64,
    /// z_0 [m].
    pub(super) height: f64,
    /// λ [m].
    pub(super) half_wave: f64,
}

/// λ [m].
pub(super) fn half_wave(radius: f64, t: f64, nu: f64) -> f64 {
    PI * (radius * t).sqrt() / (3.0 * (1.0 - nu * nu)).powf(0.25)
}

impl Depression {
    /// Deviation of the radius [m] and its slope at z.
    pub(super) fn at(&self, z: f64) -> (f64, f64) {
        let x = PI * (z - self.height).abs() / self.half_wave;
        let (s, c) = x.sin_cos();
        let decay = self.amplitude * (-x).exp();
        let slope = -2.0 * PI / self.half_wave * decay * s;
        (decay * (c + s), slope * (z - self.height).signum())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slope_is_the_derivative() {
        let d = Depression { radius: 12.0, amplitude: 0.01, height: 0.5, half_wave: half_wave(12.0, 0.012, 0.3) };
        assert_eq!(d.at(0.5), (0.01, 0.0));
        for z in [0.1, 0.45, 0.6, 1.3] {
            let numeric = (d.at(z + 1e-6).0 - d.at(z - 1e-6).0) / 2e-6;
            assert!((d.at(z).1 - numeric).abs() < 1e-7, "{z}");
        }
    }

    /// λ = 2.444 √(R t) at ν = 0.3; class A at R/t = 1000: √1000/40 = 0.79 t.
    #[test]
    fn measures() {
        assert!((half_wave(1.0, 1.0, 0.3) - 2.444).abs() < 1e-3);
        assert!((Amplitude::Quality(Quality::A).of_wall(0.01, 10.0) - 0.0079057).abs() < 1e-6);
        assert_eq!(Amplitude::Thicknesses(-0.5).of_wall(0.01, 10.0), -0.005);
    }
}
