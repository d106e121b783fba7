//! von Mises plasticity of steel: bar, plane stress, solid; linear or saturating isotropic hardening, kinematic hardening
//! of Prager's or of Armstrong and Frederick's kind.
//!
//! With ξ = σ − Σ b_i, the accumulated plastic strain a and the matrix P of the deviator (in plane stress ⅓ [2 −1 0; −1 2 0;
//! 0 0 6]):
//!
//! ```text
//! f = √(3/2 ξᵀ P ξ) − κ(a) ≤ 0 ,   κ = f_y + K a + Q (1 − e^(−r a))
//! ε_p' = g P ξ ,   a' = g √(2/3 ξᵀ P ξ) ,   b_i' = ⅔ H_i g ξ − γ_i b_i a'
//! ```
//!
//! Implicit Euler. On the surface Δa = ⅔ g κ, so that g = 3/2 Δa/κ(a_n + Δa), and Δa is the only unknown:
//!
//! ```text
//! θ_i = 1/(1 + γ_i Δa) ,   h = ⅔ Σ θ_i H_i
//! ξ = (1 + g (C P + h))⁻¹ ξ⁰ ,   ξ⁰ = C (ε − ε_p,n) − Σ θ_i b_i,n ,   b_i = θ_i (b_i,n + ⅔ H_i g ξ)
//! κ/√(3/2 ξᵀ P ξ) − 1 = 0
//! ```
//!
//! C and P share their eigenvectors, so that ξ is computed without a matrix; in the solid and in the bar this is the
//! radial return. The last line is linear in Δa there under linear hardening, and nearly so in plane stress: Newton
//! from Δa = 0 needs few steps for increments of any size. A bracket guards it. The tangent is the derivative of this
//! map. It is symmetric unless γ_i > 0.
//!
//! Dissipation. With the stored energy ½ ε_e : C : ε_e + Σ 3/(4 H_i) b_i : b_i + ∫ (κ − f_y) da,
//!
//! ```text
//! σ : ε_p' − Σ b_i : (ε_p' − 3γ_i/(2H_i) b_i a') − (κ − f_y) a' = (f_y + Σ 3γ_i/(2H_i) b_iᵀ P b_i) a' ≥ 0
//! ```
//! Linear hardening stores its part of the work.
//!
//! Source: Simo & Taylor 1986 (plane stress), Simo & Hughes 1998 ch. 3 (tangents), Armstrong & Frederick 1966, Voce 1948,
//! Chaboche 1986 (several back stresses).

#[cfg(test)]
mod tests;

use crate::check::{below, positive, within};
use crate::elastic::Elastic;
use crate::modes::Modes;
use crate::{ElasticRange, Law, LawError, PointState, Response, refuse};

const KIND: &str = "von_mises";

/// Largest number of back stresses.
pub const BACK_STRESSES: usize = 4;

/// Relative excess of the yield surface taken for rounding.
const ON_SURFACE: f64 = 1e-12;

/// One back stress, b' = ⅔ H ε_p' − γ b a'.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct BackStress {
    /// H [Pa] > 0.
    modulus: f64,
    /// γ ≥ 0.
    recall: f64,
}

/// von Mises law; `Law<1>`, `Law<3>` and `Law<6>`.
///
/// History of a point: a, ε_p (N), b_1 (N), b_2 (N), …
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VonMises {
    elastic: Elastic,
    yield_stress: f64,
    isotropic: f64,
    saturation: f64,
    rate: f64,
    back: [BackStress; BACK_STRESSES],
    backs: usize,
    bar: Modes<1>,
    plane: Modes<3>,
    solid: Modes<6>,
}

impl VonMises {
    /// Linear hardening of modulus K + H = E E_T/(E − E_T), of which the share `kinematic` is H.
    ///
    /// * `young_modulus` E [Pa] > 0
    /// * `poisson_ratio` ν, −1 < ν < 0.5
    /// * `yield_stress` f_y [Pa] > 0
    /// * `tangent_modulus` E_T [Pa], slope of the uniaxial curve beyond f_y, 0 ≤ E_T < E
    /// * `kinematic`, from 0 (isotropic) to 1 (kinematic, the choice for cyclic work)
    ///
    /// Errors: a parameter out of range.
    pub fn new(
        young_modulus: f64,
        poisson_ratio: f64,
        yield_stress: f64,
        tangent_modulus: f64,
        kinematic: f64,
    ) -> Result<VonMises, LawError> {
        let elastic = Elastic::new(young_modulus, poisson_ratio)?;
        positive(KIND, "yield_stress", yield_stress, "Pa")?;
        below(KIND, "tangent_modulus", tangent_modulus, [0.0, young_modulus], "Pa")?;
        within(KIND, "kinematic_share", kinematic, [0.0, 1.0], "")?;
        let hardening = young_modulus * tangent_modulus / (young_modulus - tangent_modulus);
        let mut law = VonMises {
            elastic,
            yield_stress,
            isotropic: (1.0 - kinematic) * hardening,
            saturation: 0.0,
            rate: 0.0,
            back: [BackStress::default(); BACK_STRESSES],
            backs: 0,
            bar: Modes::bar(&elastic),
            plane: Modes::plane(&elastic),
            solid: Modes::solid(&elastic),
        };
        if kinematic * hardening > 0.0 {
            law = law.with_back_stress(kinematic * hardening, 0.0)?;
        }
        Ok(law)
    }

    /// Adds Q (1 − e^(−r a)) to the yield stress.
    ///
    /// * `saturation` Q [Pa] ≥ 0
    /// * `rate` r > 0
    ///
    /// Errors: a parameter out of range.
    pub fn with_saturation(mut self, saturation: f64, rate: f64) -> Result<VonMises, LawError> {
        below(KIND, "saturation", saturation, [0.0, f64::INFINITY], "Pa")?;
        positive(KIND, "saturation_rate", rate, "")?;
        self.saturation = saturation;
        self.rate = rate;
        Ok(self)
    }

    /// Adds a back stress, b' = ⅔ H ε_p' − γ b a'; uniaxially it saturates at H/γ.
    ///
    /// * `modulus` H [Pa] > 0
    /// * `recall` γ ≥ 0; 0 is Prager's linear rule
    ///
    /// Errors: a parameter out of range, more than [`BACK_STRESSES`] terms.
    pub fn with_back_stress(mut self, modulus: f64, recall: f64) -> Result<VonMises, LawError> {
        positive(KIND, "back_stress.modulus", modulus, "Pa")?;
        below(KIND, "back_stress.recall", recall, [0.0, f64::INFINITY], "")?;
        let Some(slot) = self.back.get_mut(self.backs) else {
            let found = (self.backs + 1).to_string();
            return Err(refuse(KIND, "number of back stresses", found, "at most 4"));
        };
        *slot = BackStress { modulus, recall };
        self.backs += 1;
        Ok(self)
    }

    /// Elastic part.
    pub fn elastic(&self) -> &Elastic {
        &self.elastic
    }

    /// Initial yield stress f_y [Pa].
    pub fn yield_stress(&self) -> f64 {
        self.yield_stress
    }

    /// κ(a) and κ'(a) [Pa].
    fn radius(&self, a: f64) -> (f64, f64) {
        let mut kappa = self.yield_stress + self.isotropic * a;
        let mut slope = self.isotropic;
        if self.saturation > 0.0 {
            let rest = (-self.rate * a).exp();
            kappa += self.saturation * (1.0 - rest);
            slope += self.saturation * self.rate * rest;
        }
        (kappa, slope)
    }

    fn back(&self) -> &[BackStress] {
        &self.back[..self.backs]
    }

    fn len(&self, n: usize) -> usize {
        1 + n * (1 + self.backs)
    }

    /// History of a point, along the modes.
    fn read<const N: usize>(&self, slots: &[f64]) -> Point<N> {
        let mut parts = slots[1..].chunks_exact(N).map(|part| {
            let mut v = [0.0; N];
            v.copy_from_slice(part);
            Modes::split(&v)
        });
        let plastic = parts.next().unwrap_or([0.0; N]);
        let mut back = [[0.0; N]; BACK_STRESSES];
        for (b, part) in back.iter_mut().zip(parts) {
            *b = part;
        }
        Point { a: slots[0], plastic, back }
    }

    /// Inverse of [`VonMises::read`].
    fn write<const N: usize>(&self, point: &Point<N>, slots: &mut [f64]) {
        slots[0] = point.a;
        let parts = std::iter::once(&point.plastic).chain(&point.back);
        for (slot, part) in slots[1..].chunks_exact_mut(N).zip(parts) {
            slot.copy_from_slice(&Modes::join(part));
        }
    }

    /// State of the return map at Δa.
    fn map<const N: usize>(&self, modes: &Modes<N>, trial: &[f64; N], point: &Point<N>, step: f64) -> Map<N> {
        let (kappa, kappa_slope) = self.radius(point.a + step);
        let g = 1.5 * step / kappa;
        let g_slope = 1.5 * (kappa - step * kappa_slope) / (kappa * kappa);
        let (mut h, mut h_slope) = (0.0, 0.0);
        let mut xi = *trial;
        let mut xi_slope = [0.0; N];
        for (term, b) in self.back().iter().zip(&point.back) {
            let theta = 1.0 / (1.0 + term.recall * step);
            let theta_slope = -term.recall * theta * theta;
            h += 2.0 / 3.0 * theta * term.modulus;
            h_slope += 2.0 / 3.0 * theta_slope * term.modulus;
            for j in 0..N {
                xi[j] -= theta * b[j];
                xi_slope[j] -= theta_slope * b[j];
            }
        }
        let mut d = [0.0; N];
        for j in 0..N {
            let cp = modes.c[j] * modes.p[j];
            d[j] = 1.0 + g * (cp + h);
            xi[j] /= d[j];
            xi_slope[j] = (xi_slope[j] - xi[j] * (g_slope * (cp + h) + g * h_slope)) / d[j];
        }
        let f = modes.equivalent(&xi);
        let mut normal = [0.0; N];
        for j in 0..N {
            normal[j] = 1.5 * modes.p[j] * xi[j] / f;
        }
        let f_slope: f64 = normal.iter().zip(&xi_slope).map(|(n, x)| n * x).sum();
        Map {
            g,
            g_slope,
            d,
            xi,
            xi_slope,
            normal,
            kappa_slope,
            f_slope,
            residual: kappa / f - 1.0,
            slope: (kappa_slope - kappa * f_slope / f) / f,
        }
    }

    /// Δa by Newton's method from 0 inside a bracket. The residual is negative at 0 and increases.
    fn solve<const N: usize>(&self, modes: &Modes<N>, trial: &[f64; N], point: &Point<N>) -> Option<(f64, Map<N>)> {
        let (mut low, mut high) = (0.0, f64::INFINITY);
        let mut step = 0.0;
        let mut map = self.map(modes, trial, point, step);
        for _ in 0..60 {
            if !map.residual.is_finite() {
                return None;
            }
            // Rounding of the residual: a few units of 2⁻⁵³.
            if map.residual.abs() < 4e-15 {
                break;
            }
            if map.residual < 0.0 {
                low = step;
            } else {
                high = step;
            }
            let mut next = step - map.residual / map.slope;
            if !(next > low && next < high) {
                next = if high.is_finite() { 0.5 * (low + high) } else { 2.0 * low + 1e-12 };
            }
            if next == step {
                break;
            }
            step = next;
            map = self.map(modes, trial, point, step);
        }
        (map.residual.abs() < ON_SURFACE).then_some((step, map))
    }

    fn respond_in<const N: usize>(
        &self,
        modes: &Modes<N>,
        strain: &[f64; N],
        old: &[f64],
        new: &mut [f64],
    ) -> Result<Response<N>, LawError> {
        let mut point: Point<N> = self.read(old);
        let total = Modes::split(strain);
        let mut trial = [0.0; N];
        let mut xi = [0.0; N];
        for j in 0..N {
            trial[j] = modes.c[j] * (total[j] - point.plastic[j]);
            xi[j] = trial[j] - point.back[..self.backs].iter().map(|b| b[j]).sum::<f64>();
        }
        let f = modes.equivalent(&xi);
        if f <= (1.0 + ON_SURFACE) * self.radius(point.a).0 {
            new.copy_from_slice(old);
            return Ok(Response { stress: Modes::join(&trial), tangent: modes.moduli, dissipation: 0.0 });
        }
        let Some((step, map)) = self.solve(modes, &trial, &point) else {
            let increment = f / self.elastic.young_modulus();
            return Err(LawError::NoConvergence { law: KIND, increment });
        };
        let mut dissipated = self.yield_stress;
        for (term, b) in self.back().iter().zip(&mut point.back) {
            let theta = 1.0 / (1.0 + term.recall * step);
            let mut square = 0.0;
            for j in 0..N {
                b[j] = theta * (b[j] + 2.0 / 3.0 * term.modulus * map.g * map.xi[j]);
                square += modes.p[j] * b[j] * b[j];
            }
            dissipated += 1.5 * term.recall / term.modulus * square;
        }
        // dΔa = pull · dε
        let mut stress = [0.0; N];
        let (mut diagonal, mut push, mut pull) = ([0.0; N], [0.0; N], [0.0; N]);
        for j in 0..N {
            let (c, p) = (modes.c[j], modes.p[j]);
            point.plastic[j] += map.g * p * map.xi[j];
            stress[j] = c * (total[j] - point.plastic[j]);
            diagonal[j] = c * (1.0 - map.g * p * c / map.d[j]);
            push[j] = -c * p * (map.g_slope * map.xi[j] + map.g * map.xi_slope[j]);
            pull[j] = map.normal[j] * c / map.d[j] / (map.kappa_slope - map.f_slope);
        }
        point.a += step;
        self.write(&point, new);
        Ok(Response {
            stress: Modes::join(&stress),
            tangent: Modes::matrix(&diagonal, &push, &pull),
            dissipation: step * dissipated,
        })
    }

    fn inspect_in<const N: usize>(&self, modes: &Modes<N>, strain: &[f64; N], history: &[f64]) -> PointState {
        let point: Point<N> = self.read(history);
        let total = Modes::split(strain);
        let mut xi = [0.0; N];
        for j in 0..N {
            xi[j] = modes.c[j] * (total[j] - point.plastic[j]);
            xi[j] -= point.back[..self.backs].iter().map(|b| b[j]).sum::<f64>();
        }
        PointState {
            plastic_strain: point.a,
            utilisation: modes.equivalent(&xi) / self.radius(point.a).0,
            ..PointState::default()
        }
    }
}

/// History of a point, along the modes.
struct Point<const N: usize> {
    a: f64,
    plastic: [f64; N],
    back: [[f64; N]; BACK_STRESSES],
}

/// Return map at one Δa; slopes are derivatives by Δa.
struct Map<const N: usize> {
    g: f64,
    g_slope: f64,
    /// 1 + g (c p + h).
    d: [f64; N],
    xi: [f64; N],
    xi_slope: [f64; N],
    /// ∂√(3/2 ξᵀ P ξ)/∂ξ.
    normal: [f64; N],
    kappa_slope: f64,
    f_slope: f64,
    residual: f64,
    slope: f64,
}

/// The three sizes differ only in their modes.
macro_rules! law {
    ($n:literal, $modes:ident) => {
        impl Law<$n> for VonMises {
            fn kind(&self) -> &'static str {
                KIND
            }

            fn history_len(&self) -> usize {
                self.len($n)
            }

            fn elastic_range(&self) -> Option<&dyn ElasticRange<$n>> {
                Some(self)
            }

            fn respond(&self, strain: &[f64; $n], old: &[f64], new: &mut [f64]) -> Result<Response<$n>, LawError> {
                self.respond_in(&self.$modes, strain, old, new)
            }

            fn inspect(&self, strain: &[f64; $n], history: &[f64]) -> PointState {
                self.inspect_in(&self.$modes, strain, history)
            }
        }

        /// The first yield surface.
        impl ElasticRange<$n> for VonMises {
            fn holds(&self, strain: &[f64; $n]) -> bool {
                let split = Modes::split(strain);
                let trial = std::array::from_fn(|j| self.$modes.c[j] * split[j]);
                self.$modes.equivalent(&trial) <= self.yield_stress
            }

            fn moduli(&self) -> [[f64; $n]; $n] {
                self.$modes.moduli
            }

            fn history(&self, _strain: &[f64; $n], slots: &mut [f64]) {
                slots.fill(0.0);
            }
        }
    };
}

law!(1, bar);
law!(3, plane);
law!(6, solid);
