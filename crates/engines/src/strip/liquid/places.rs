//! Pressures of the condensed liquid on the wall and on the bottom.
//!
//! ```text
//! φ = Σ_j (2/H) D_j(u) sinh(l_j x) cos(l_j z)/(l_j cosh l_j L) + Σ_n (q_n + S_n(u)) sin(k_n x) cosh(k_n z)/(k_n sinh k_n H)
//! D_j(u) = ∫₀ᴴ u cos(l_j z) dz        p' = −ρ φ̈        u_z = φ,z        moment of the bottom: ρ ∫₀ᴸ x φ̈ dx at z = 0
//! ```
//!
//! the displacement potential whose kinetic energy is the M of the parent module; q_n + S_n(u), the surface of the second part,
//! makes up for that of the first. A pressure takes total accelerations, a displacement those relative to the ground.

use super::{StripLiquid, Trace};

/// Rows over the unknowns at the levels of a face, then q_n.
#[derive(Clone, Debug, PartialEq)]
pub struct Place {
    /// Height [m].
    pub height: f64,
    /// p' [Pa] for total accelerations.
    pub pressure: Vec<f64>,
    /// u_z of the particle at the wall [m] for displacements relative to the ground.
    pub rise: Vec<f64>,
}

impl StripLiquid {
    /// Places on the wetted wall at the given `heights` [m]; the rest as in [`StripLiquid::on`].
    pub fn places(&self, trace: Trace, levels: &[f64], sloshing: usize, heights: &[f64]) -> Vec<Place> {
        let parts = self.parts(trace, levels, sloshing);
        let (l, h) = (self.half_width, self.depth);
        let wall = trace.unknowns() * levels.len();
        let all = wall + sloshing;
        let place = |&height: &f64| {
            let mut place = Place { height, pressure: vec![0.0; all], rise: vec![0.0; all] };
            for (j, row) in parts.mass_rows.iter().enumerate() {
                let k = self.depth_wave(j);
                let factor = 2.0 / h * (k * l).tanh();
                add(&mut place.pressure, -self.density * factor / k * (k * height).cos(), row);
                add(&mut place.rise, -factor * (k * height).sin(), row);
            }
            for (n, row) in parts.sloshing_rows.iter().enumerate() {
                let k = self.wave_number(n);
                let crest = (k * l).sin() / (k * h).sinh();
                let own = wall + n;
                for (out, factor) in [
                    (&mut place.pressure, -self.density * crest * (k * height).cosh() / k),
                    (&mut place.rise, crest * (k * height).sinh()),
                ] {
                    add(out, factor, row);
                    out[own] += factor;
                }
            }
            place
        };
        heights.iter().map(place).collect()
    }

    /// Moment of the pressure on this half of the bottom about the middle of the tank [N], for total accelerations; positive
    /// as the moment of the wall's pressure.
    pub fn bottom_moment(&self, trace: Trace, levels: &[f64], sloshing: usize) -> Vec<f64> {
        let parts = self.parts(trace, levels, sloshing);
        let wall = trace.unknowns() * levels.len();
        let (l, h) = (self.half_width, self.depth);
        let mut out = vec![0.0; wall + sloshing];
        for (j, row) in parts.mass_rows.iter().enumerate() {
            let k = self.depth_wave(j);
            let arm = (l - (k * l).tanh() / k) / (k * k);
            add(&mut out, self.density * 2.0 / h * arm, row);
        }
        for (n, row) in parts.sloshing_rows.iter().enumerate() {
            let k = self.wave_number(n);
            let factor = self.density * (k * l).sin() / (k.powi(3) * (k * h).sinh());
            add(&mut out, factor, row);
            out[wall + n] += factor;
        }
        out
    }
}

fn add(out: &mut [f64], factor: f64, row: &[f64]) {
    out.iter_mut().zip(row).for_each(|(o, r)| *o += factor * r);
}

#[cfg(test)]
mod tests {
    use super::*;

    const LEVELS: [f64; 6] = [0.0, 0.4, 1.1, 1.9, 2.4, 3.0];

    fn liquid() -> StripLiquid {
        StripLiquid::new(2.5, 2.57, 1000.0)
    }

    /// Rigid translation in many modes: φ = x, so that p' = −ρ L everywhere, no particle rises, and the bottom turns with
    /// ρ L³/3. The series of the surface's displacement lacks 4/(π² n), its half at the wall.
    #[test]
    fn rigid_translation() {
        let (liquid, modes) = (liquid(), 100);
        let translation: Vec<f64> = (0..12 + modes).map(|i| f64::from(i < 12 && i % 2 == 0)).collect();
        let dot = |row: &[f64]| row.iter().zip(&translation).map(|(a, b)| a * b).sum::<f64>();
        for place in liquid.places(Trace::Cubic, &LEVELS, modes, &[0.0, 0.5, 1.3, 2.0]) {
            let p = dot(&place.pressure) / (-1000.0 * 2.5);
            assert!((p - 1.0).abs() < 2e-3, "{}: {p}", place.height);
            assert!(dot(&place.rise).abs() < 2e-2, "{}", dot(&place.rise));
        }
        let bottom = dot(&liquid.bottom_moment(Trace::Cubic, &LEVELS, modes)) / (1000.0 * 2.5_f64.powi(3) / 3.0);
        assert!((bottom - 1.0).abs() < 1e-4, "{bottom}");
    }

    /// Virtual work of the pressure on a moving wall is the mass matrix: −∫ N p' dz = M over the wall's rows.
    #[test]
    fn pressure_is_the_mass() {
        let (liquid, modes) = (liquid(), 3);
        let on_wall = liquid.on_wall(&LEVELS, modes);
        let x: Vec<f64> = (0..12 + modes).map(|i| (1.7 * i as f64 + 0.3).sin()).collect();
        // Rigid translation and rotation as virtual motions; the pressure by a fine mid-point rule.
        let count = 2000;
        let heights: Vec<f64> = (0..count).map(|i| 2.57 * (i as f64 + 0.5) / f64::from(count)).collect();
        let (mut force, mut moment) = (0.0, 0.0);
        for place in liquid.places(Trace::Cubic, &LEVELS, modes, &heights) {
            let p: f64 = place.pressure.iter().zip(&x).map(|(a, b)| a * b).sum();
            force -= p * 2.57 / f64::from(count);
            moment -= p * place.height * 2.57 / f64::from(count);
        }
        let inertia = on_wall.mass.times(&x);
        let by_mass: f64 = (0..6).map(|i| inertia[2 * i]).sum();
        let turned: f64 = (0..6).map(|i| inertia[2 * i] * LEVELS[i] + inertia[2 * i + 1]).sum();
        assert!((force / by_mass - 1.0).abs() < 1e-5, "{force} {by_mass}");
        assert!((moment / turned - 1.0).abs() < 1e-5, "{moment} {turned}");
    }

    /// A standing wave in the first mode: u_z at the surface is its elevation, p' there ρ g η.
    #[test]
    fn a_wave() {
        let liquid = liquid();
        let place = &liquid.places(Trace::Cubic, &LEVELS, 1, &[2.57])[0];
        let omega = liquid.sloshing_frequency(0);
        assert!((place.rise[12] - 1.0).abs() < 1e-12);
        let pressure = -omega * omega * place.pressure[12];
        assert!((pressure / (1000.0 * liquid.gravity) - 1.0).abs() < 1e-12);
    }
}
