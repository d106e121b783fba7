//! Section of a beam as fibres of uniaxial laws.
//!
//! ```text
//! ε(ζ) = ε₀ + ζ κ          N = Σ A_i σ_i          M = Σ A_i ζ_i σ_i          κ = −w″, ζ along the deflection w
//! ```
//!
//! Areas may be those of a strip of unit width [m²/m]; then the resultants are per metre too. Fibres of one law form
//! a block, whose law is asked for a row of fibres at a time.
//!
//! **Layers.** A block of depth h in n layers of area A/n has its fibres at the middle of the layers, moved outwards by
//! 1/√(1 − 1/n²): area and second moment h³/12 are then exact, and an elastic section does not depend on n. Bars stand at
//! their true depth; the concrete they displace is not subtracted.
//!
//! History of a point: energy dissipated so far per length [J/m], then the fibres' own.

use std::sync::Arc;

use materials::{Law, PointState, Response as LawResponse};

use super::{ElementError, not_negative, positive, require};

const KIND: &str = "beam section";

/// Fibres in one call of their law.
const ROW: usize = 16;

/// Fibres of one law.
#[derive(Clone, Debug)]
struct Block {
    law: Arc<dyn Law<1>>,
    /// History slots of one fibre.
    slots: usize,
    /// Depth ζ [m] and area [m²].
    fibres: Vec<[f64; 2]>,
}

/// The section.
#[derive(Clone, Debug)]
pub struct FibreSection {
    blocks: Vec<Block>,
    /// Fibres before the first bar.
    layers: usize,
    slots: usize,
    mass: f64,
    attached_mass: f64,
    shear: f64,
}

/// Resultants of a section and their derivatives.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FibreResponse {
    /// N [N].
    pub axial: f64,
    /// M [N m].
    pub moment: f64,
    /// ∂(N, M)/∂(ε₀, κ).
    pub tangent: [[f64; 2]; 2],
}

/// A fibre as a picture shows it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FibreState {
    /// Number, in the order of the blocks.
    pub fibre: usize,
    /// Number of its block.
    pub block: usize,
    /// Depth ζ [m].
    pub depth: f64,
    /// Strain.
    pub strain: f64,
    /// Stress [Pa].
    pub stress: f64,
    /// State of the material.
    pub state: PointState,
}

/// A point of a moment-curvature line.
#[derive(Clone, Debug, PartialEq)]
pub struct CurvaturePoint {
    /// κ [1/m].
    pub curvature: f64,
    /// M [N m].
    pub moment: f64,
    /// ε₀.
    pub strain: f64,
    /// All fibres.
    pub fibres: Vec<FibreState>,
}

fn law_error(source: materials::LawError) -> ElementError {
    ElementError::Law { kind: KIND, source }
}

impl FibreSection {
    /// A section without fibres.
    ///
    /// * `mass`: mass per length [kg/m], ≥ 0; the beam carries its weight
    ///
    /// Errors: a parameter out of range.
    pub fn new(mass: f64) -> Result<FibreSection, ElementError> {
        require(not_negative(mass), KIND, "mass", mass, "≥ 0")?;
        Ok(FibreSection { blocks: Vec::new(), layers: 0, slots: 1, mass, attached_mass: 0.0, shear: f64::INFINITY })
    }

    /// Adds mass per length [kg/m] that moves with the beam but rests on something else (a liner with its layer).
    ///
    /// Errors: a parameter out of range.
    pub fn with_attached_mass(mut self, mass: f64) -> Result<FibreSection, ElementError> {
        require(not_negative(mass), KIND, "attached mass", mass, "≥ 0")?;
        self.attached_mass = mass;
        Ok(self)
    }

    /// Elastic shear stiffness G A_s [N]; without, the section stays normal to the axis (Bernoulli).
    ///
    /// Errors: a parameter out of range.
    pub fn with_shear(mut self, stiffness: f64) -> Result<FibreSection, ElementError> {
        require(stiffness > 0.0, KIND, "shear stiffness", stiffness, "> 0, or infinite")?;
        self.shear = stiffness;
        Ok(self)
    }

    /// Adds a rectangle of `width` × `height` [m] about the depth `centre` [m] in `layers` layers.
    ///
    /// Errors: a parameter out of range.
    pub fn rectangle(
        self,
        law: Arc<dyn Law<1>>,
        [width, height]: [f64; 2],
        centre: f64,
        layers: usize,
    ) -> Result<FibreSection, ElementError> {
        let area = width > 0.0 && height > 0.0 && (width * height).is_finite();
        require(area, KIND, "width × height", format_args!("{width} × {height} m"), "> 0")?;
        // The rule for the places of the layers needs at least two.
        require(layers >= 2, KIND, "layers", layers, "2 or more")?;
        let n = layers as f64;
        let outwards = 1.0 / (1.0 - 1.0 / (n * n)).sqrt();
        let fibres: Vec<[f64; 2]> = (0..layers)
            .map(|i| {
                let middle = ((i as f64 + 0.5) / n - 0.5) * height;
                [centre + outwards * middle, width * height / n]
            })
            .collect();
        self.fibres(law, &fibres)
    }

    /// Adds fibres of one law: depth ζ [m] and area [m²]. Bars come last.
    ///
    /// Errors: a parameter out of range, bars already there.
    pub fn fibres(self, law: Arc<dyn Law<1>>, fibres: &[[f64; 2]]) -> Result<FibreSection, ElementError> {
        let no_bars = self.layers >= self.fibre_count();
        require(no_bars, KIND, "fibres", "fibres after bars", "bars after all other fibres")?;
        let mut section = self.bars(law, fibres)?;
        section.layers += fibres.len();
        Ok(section)
    }

    /// Adds bars of one law: depth ζ [m] and area [m²].
    ///
    /// Errors: a parameter out of range.
    pub fn bars(mut self, law: Arc<dyn Law<1>>, fibres: &[[f64; 2]]) -> Result<FibreSection, ElementError> {
        for [depth, area] in fibres {
            let found = format_args!("{area} m² at {depth} m");
            require(depth.is_finite() && positive(*area), KIND, "fibre", found, "an area > 0 at a finite depth")?;
        }
        let slots = law.history_len();
        self.slots += slots * fibres.len();
        self.blocks.push(Block { law, slots, fibres: fibres.to_vec() });
        Ok(self)
    }

    /// Number of history slots of one point.
    pub fn history_len(&self) -> usize {
        self.slots
    }

    /// Number of fibres of all blocks.
    pub fn fibre_count(&self) -> usize {
        self.blocks.iter().map(|b| b.fibres.len()).sum()
    }

    /// Number of fibres that are not bars; these come first.
    pub fn layers(&self) -> usize {
        self.layers
    }

    /// Mass per length that moves with the beam, m [kg/m].
    pub fn mass(&self) -> f64 {
        self.mass + self.attached_mass
    }

    /// Mass per length whose weight the beam carries [kg/m].
    pub fn weight_mass(&self) -> f64 {
        self.mass
    }

    /// G A_s [N].
    pub fn shear(&self) -> f64 {
        self.shear
    }

    /// Writes the initial history of one point.
    pub fn init_history(&self, slots: &mut [f64]) {
        let (first, mut rest) = slots.split_at_mut(1);
        first[0] = 0.0;
        for block in &self.blocks {
            for _ in &block.fibres {
                let (own, others) = rest.split_at_mut(block.slots);
                block.law.init_history(own);
                rest = others;
            }
        }
    }

    /// Asks the laws of the fibres at ε₀ and κ, row by row; `take` is given the fibres of a row and their responses.
    fn rows(
        &self,
        [strain, curvature]: [f64; 2],
        old: &[f64],
        new: &mut [f64],
        mut take: impl FnMut(&[[f64; 2]], &[LawResponse<1>]),
    ) -> Result<(), ElementError> {
        let (mut strains, mut found) = ([[0.0]; ROW], [LawResponse::default(); ROW]);
        let mut at = 1;
        for block in &self.blocks {
            for fibres in block.fibres.chunks(ROW) {
                let (n, end) = (fibres.len(), at + block.slots * fibres.len());
                for (own, [depth, _]) in strains.iter_mut().zip(fibres) {
                    *own = [strain + depth * curvature];
                }
                let law = block.law.respond_row(&strains[..n], &old[at..end], &mut new[at..end], &mut found[..n]);
                law.map_err(law_error)?;
                take(fibres, &found[..n]);
                at = end;
            }
        }
        Ok(())
    }

    /// Resultants at the strain ε₀ of the axis and the curvature κ, with the committed history `old`; writes the trial
    /// history `new`.
    ///
    /// Errors: a fibre that fails.
    pub fn respond(
        &self,
        [strain, curvature]: [f64; 2],
        old: &[f64],
        new: &mut [f64],
    ) -> Result<FibreResponse, ElementError> {
        let mut out = FibreResponse::default();
        let [mut k00, mut k01, mut k11] = [0.0; 3];
        let mut dissipated = 0.0;
        self.rows([strain, curvature], old, new, |fibres, found| {
            for (&[depth, area], found) in fibres.iter().zip(found) {
                let (force, stiffness) = (area * found.stress[0], area * found.tangent[0][0]);
                out.axial += force;
                out.moment += depth * force;
                k00 += stiffness;
                k01 += depth * stiffness;
                k11 += depth * depth * stiffness;
                dissipated += area * found.dissipation;
            }
        })?;
        new[0] = old[0] + dissipated;
        out.tangent = [[k00, k01], [k01, k11]];
        Ok(out)
    }

    /// Response of the initial section without strain; its tangent is E A, E S, E I.
    ///
    /// Errors: a fibre that fails.
    pub fn at_rest(&self) -> Result<FibreResponse, ElementError> {
        let mut old = vec![0.0; self.slots];
        self.init_history(&mut old);
        self.respond([0.0; 2], &old, &mut old.clone())
    }

    /// Energy dissipated so far per length [J/m], from the committed history of one point.
    pub fn dissipated(&self, history: &[f64]) -> f64 {
        history[0]
    }

    /// Shows every fibre at committed strains and history. A law that fails there has no stress.
    pub fn inspect(&self, [strain, curvature]: [f64; 2], history: &[f64], see: &mut dyn FnMut(FibreState)) {
        let mut scratch = vec![0.0; self.blocks.iter().map(|b| b.slots).max().unwrap_or(0)];
        let (mut at, mut number) = (1, 0);
        for (b, block) in self.blocks.iter().enumerate() {
            for &[depth, _] in &block.fibres {
                let end = at + block.slots;
                let own = [strain + depth * curvature];
                let found = block.law.respond(&own, &history[at..end], &mut scratch[..block.slots]);
                see(FibreState {
                    fibre: number,
                    block: b,
                    depth,
                    strain: own[0],
                    stress: found.map_or(f64::NAN, |r| r.stress[0]),
                    state: block.law.inspect(&own, &history[at..end]),
                });
                (at, number) = (end, number + 1);
            }
        }
    }

    /// Moments under a constant normal force `axial` [N] while the curvature passes through `curvatures` [1/m].
    ///
    /// At each curvature ε₀ balances N(ε₀, κ) = N to 10⁻¹⁰ of E A; the history is committed from point to point.
    ///
    /// Errors: a fibre that fails; no ε₀ found between −1 and 1.
    pub fn moment_curvature(&self, axial: f64, curvatures: &[f64]) -> Result<Vec<CurvaturePoint>, ElementError> {
        let stiffness = self.at_rest()?.tangent[0][0];
        let mut old = vec![0.0; self.slots];
        self.init_history(&mut old);
        let (mut new, mut strain) = (old.clone(), axial / stiffness);
        let mut line = Vec::new();
        for &curvature in curvatures {
            let found = self.balance(axial, curvature, &mut strain, stiffness, &old, &mut new)?;
            old.copy_from_slice(&new);
            let mut fibres = Vec::new();
            self.inspect([strain, curvature], &old, &mut |f| fibres.push(f));
            line.push(CurvaturePoint { curvature, moment: found.moment, strain, fibres });
        }
        Ok(line)
    }

    /// Finds ε₀ by Newton's method inside a bracket that shrinks, by bisection where Newton leaves it.
    fn balance(
        &self,
        axial: f64,
        curvature: f64,
        strain: &mut f64,
        stiffness: f64,
        old: &[f64],
        new: &mut [f64],
    ) -> Result<FibreResponse, ElementError> {
        // Forces grow with ε₀ except in softening; wide enough for any wall.
        let (mut low, mut high) = (-1.0_f64, 1.0_f64);
        for _ in 0..200 {
            let found = self.respond([*strain, curvature], old, new)?;
            let gap = axial - found.axial;
            if gap.abs() <= 1e-10 * stiffness * (strain.abs() + 1e-6) {
                return Ok(found);
            }
            if gap > 0.0 {
                low = low.max(*strain);
            } else {
                high = high.min(*strain);
            }
            let next = *strain + gap / found.tangent[0][0];
            let inside = next > low && next < high && found.tangent[0][0] > 0.0;
            *strain = if inside { next } else { 0.5 * (low + high) };
        }
        Err(ElementError::NoAnswer {
            kind: KIND,
            reason: format!("no strain balances {axial:.4e} N at a curvature of {curvature:.4e} 1/m"),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use materials::elastic::Elastic;

    fn elastic(young: f64) -> Arc<dyn Law<1>> {
        Arc::new(Elastic::new(young, 0.0).unwrap())
    }

    /// E A, E I of the rectangle exactly, whatever the layers; a bar adds E A ζ².
    #[test]
    fn elastic_stiffness_does_not_depend_on_the_layers() {
        for layers in [2, 3, 30] {
            let section = FibreSection::new(0.0)
                .unwrap()
                .rectangle(elastic(2.0), [0.5, 0.3], 0.0, layers)
                .unwrap()
                .fibres(elastic(10.0), &[[0.1, 0.02], [-0.1, 0.02]])
                .unwrap();
            let k = section.at_rest().unwrap().tangent;
            let (area, inertia) = (0.15 * 2.0 + 0.04 * 10.0, 0.5 * 0.027 / 12.0 * 2.0 + 0.04 * 0.01 * 10.0);
            assert!((k[0][0] - area).abs() < 1e-14 && k[0][1].abs() < 1e-16);
            assert!((k[1][1] - inertia).abs() < 1e-15, "{layers}: {}", k[1][1]);
        }
    }

    /// Elastic and eccentric: M = E I κ + N times the distance of the centroid.
    #[test]
    fn moment_of_an_eccentric_section() {
        let section = FibreSection::new(0.0).unwrap().rectangle(elastic(200.0), [1.0, 0.3], 0.15, 10).unwrap();
        let line = section.moment_curvature(-6.0, &[1e-3, 2e-3]).unwrap();
        for point in line {
            let exact = 200.0 * 0.027 / 12.0 * point.curvature - 6.0 * 0.15;
            assert!((point.moment - exact).abs() < 1e-9, "{} {exact}", point.moment);
        }
    }

    #[test]
    fn bad_sections_are_rejected() {
        let section = || FibreSection::new(1.0).unwrap();
        assert!(FibreSection::new(-1.0).is_err());
        assert!(section().with_attached_mass(f64::NAN).is_err());
        assert!(section().with_shear(0.0).is_err());
        assert!(section().rectangle(elastic(1.0), [1.0, 0.0], 0.0, 4).is_err());
        assert!(section().rectangle(elastic(1.0), [1.0, 1.0], 0.0, 1).is_err());
        assert!(section().fibres(elastic(1.0), &[[0.0, -1.0]]).is_err());
    }
}
