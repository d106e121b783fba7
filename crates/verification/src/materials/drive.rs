//! One point driven along a path.

use materials::{Law, LawError, Response};

/// A point with its committed history.
pub(super) struct Point<'a, const N: usize> {
    law: &'a dyn Law<N>,
    /// Committed strain.
    pub strain: [f64; N],
    committed: Vec<f64>,
    trial: Vec<f64>,
    /// Energy dissipated so far [J/m³].
    pub dissipated: f64,
    /// Smallest dissipation of a step [J/m³].
    pub least: f64,
}

impl<'a, const N: usize> Point<'a, N> {
    /// A point with the initial history.
    pub(crate) fn new(law: &'a dyn Law<N>) -> Self {
        let mut committed = vec![0.0; law.history_len()];
        law.init_history(&mut committed);
        Point { law, strain: [0.0; N], trial: committed.clone(), committed, dissipated: 0.0, least: f64::INFINITY }
    }

    /// A copy that goes its own way.
    pub(crate) fn fork(&self) -> Self {
        Point { committed: self.committed.clone(), trial: self.trial.clone(), ..*self }
    }

    /// Answers at `strain` without committing.
    ///
    /// Errors: no stress found.
    pub(crate) fn answer(&mut self, strain: [f64; N]) -> Result<Response<N>, LawError> {
        self.law.respond(&strain, &self.committed, &mut self.trial)
    }

    /// Steps to `strain` and commits.
    ///
    /// Errors: no stress found.
    pub(crate) fn step(&mut self, strain: [f64; N]) -> Result<Response<N>, LawError> {
        let response = self.answer(strain)?;
        self.committed.copy_from_slice(&self.trial);
        self.strain = strain;
        self.dissipated += response.dissipation;
        self.least = self.least.min(response.dissipation);
        Ok(response)
    }

    /// Steps to ε_1 = `axial` under uniaxial stress: all other stresses vanish within 10⁻¹⁰ `strength`.
    ///
    /// Errors: no stress found; other strains not found.
    pub(crate) fn step_uniaxial(&mut self, axial: f64, strength: f64) -> Result<Response<N>, LawError> {
        let mut strain = self.strain;
        strain[0] = axial;
        for _ in 0..100 {
            let response = self.answer(strain)?;
            if response.stress[1..].iter().all(|s| s.abs() <= 1e-10 * strength) {
                return self.step(strain);
            }
            let tangent = nalgebra::DMatrix::from_fn(N - 1, N - 1, |i, j| response.tangent[i + 1][j + 1]);
            let stress = nalgebra::DVector::from_fn(N - 1, |i, _| response.stress[i + 1]);
            let Some(correction) = tangent.lu().solve(&stress) else { break };
            for i in 1..N {
                strain[i] -= correction[i - 1];
            }
        }
        Err(LawError::NoConvergence { law: self.law.kind(), increment: axial - self.strain[0] })
    }

    /// Internal state for output.
    pub(crate) fn inspect(&self) -> materials::PointState {
        self.law.inspect(&self.strain, &self.committed)
    }
}

/// Random numbers from −1 to 1, the same on every machine (a linear congruence, its upper bits).
pub(super) struct Noise(pub u64);

impl Noise {
    /// The next number.
    pub(crate) fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as f64 / f64::from(1u32 << 30) - 1.0
    }

    /// The next `N` numbers.
    pub(crate) fn vector<const N: usize>(&mut self) -> [f64; N] {
        std::array::from_fn(|_| self.next())
    }
}
