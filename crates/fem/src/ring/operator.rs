//! Block-circulant matrices as operators.
//!
//! ```text
//! x = (w at the nodes level · meridians + k, amplitudes q)
//! M = diag(G, 1) diag(M^(m)) diag(G, 1)ᵀ          M^(m) over (ŵ at the levels, amplitudes of harmonic m)
//! ```
//!
//! One product takes two transforms of every level and one small product a harmonic: L N log N + N L² operations for L levels
//! on N meridians, and memory for N/2 blocks L × L. The dense matrix has (N L)² entries.

use std::sync::Arc;

use super::{Ring, Weight};
use crate::linalg::Matrix;

/// Matrices of one harmonic, the same for both families.
#[derive(Clone, Debug, PartialEq)]
pub struct RingBlock {
    /// Mass over (levels, amplitudes of the harmonic).
    pub mass: Matrix,
    /// Stiffness over the same; `None` if it is zero.
    pub stiffness: Option<Matrix>,
}

/// Where an amplitude belongs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RingAmplitude {
    /// m.
    pub harmonic: usize,
    /// 0: cos mθ, 1: sin mθ.
    pub family: usize,
    /// Its number in the block after the levels.
    pub slot: usize,
}

/// Mass and stiffness over an even component at all nodes of a grid of levels and meridians, and over amplitudes.
#[derive(Clone, Debug)]
pub struct RingOperator {
    ring: Ring,
    levels: usize,
    /// Shared by the copies.
    blocks: Arc<[RingBlock]>,
    amplitudes: Vec<RingAmplitude>,
    /// Damping of the amplitudes.
    damping: Vec<f64>,
    /// Longest block.
    stride: usize,
}

impl RingOperator {
    /// Operator of one block for each harmonic of `ring`.
    ///
    /// Panics if there are fewer blocks than harmonics, or amplitudes without a place.
    pub fn new(ring: Ring, levels: usize, blocks: Vec<RingBlock>, amplitudes: Vec<RingAmplitude>) -> RingOperator {
        assert_eq!(blocks.len(), ring.harmonics(), "one block a harmonic");
        for a in &amplitudes {
            let fits = a.family < ring.families() && levels + a.slot < blocks[a.harmonic].mass.rows;
            assert!(fits, "an amplitude has a place in its block");
        }
        RingOperator {
            stride: blocks.iter().map(|b| b.mass.rows).max().unwrap_or(levels),
            damping: vec![0.0; amplitudes.len()],
            ring,
            levels,
            blocks: blocks.into(),
            amplitudes,
        }
    }

    /// With a damping of each amplitude, c q̇.
    ///
    /// Panics if there are not as many as amplitudes.
    pub fn with_damping(mut self, damping: Vec<f64>) -> RingOperator {
        assert_eq!(damping.len(), self.amplitudes.len(), "one damping an amplitude");
        self.damping = damping;
        self
    }

    /// Damping of each amplitude.
    pub fn damping(&self) -> &[f64] {
        &self.damping
    }

    /// Its meridians.
    pub fn ring(&self) -> &Ring {
        &self.ring
    }

    /// Number of levels.
    pub fn levels(&self) -> usize {
        self.levels
    }

    /// Number of nodes: unknowns before the amplitudes.
    pub fn wall(&self) -> usize {
        self.levels * self.ring.meridians()
    }

    /// Number of unknowns.
    pub fn size(&self) -> usize {
        self.wall() + self.amplitudes.len()
    }

    /// The blocks, by harmonic.
    pub fn blocks(&self) -> &[RingBlock] {
        &self.blocks
    }

    /// The amplitudes, in the order of the unknowns.
    pub fn amplitudes(&self) -> &[RingAmplitude] {
        &self.amplitudes
    }

    /// y ← y + M x.
    pub fn add_mass(&self, factor: f64, x: &[f64], y: &mut [f64]) {
        self.add(factor, x, y, |b| Some(&b.mass));
    }

    /// y ← y + K x.
    pub fn add_stiffness(&self, factor: f64, x: &[f64], y: &mut [f64]) {
        self.add(factor, x, y, |b| b.stiffness.as_ref());
    }

    /// M as a matrix, for small grids.
    pub fn dense_mass(&self) -> Matrix {
        self.dense(|x, y| self.add_mass(1.0, x, y))
    }

    /// K as a matrix, for small grids.
    pub fn dense_stiffness(&self) -> Matrix {
        self.dense(|x, y| self.add_stiffness(1.0, x, y))
    }

    fn dense(&self, product: impl Fn(&[f64], &mut [f64])) -> Matrix {
        let n = self.size();
        let mut out = Matrix::zeros(n, n);
        let mut unit = vec![0.0; n];
        for j in 0..n {
            unit[j] = 1.0;
            product(&unit, out.column_mut(j));
            unit[j] = 0.0;
        }
        out
    }

    fn add<'a>(&'a self, factor: f64, x: &[f64], y: &mut [f64], of: impl Fn(&'a RingBlock) -> Option<&'a Matrix>) {
        let (meridians, families, stride) = (self.ring.meridians(), self.ring.families(), self.stride);
        let mut room = self.ring.room();
        let at = |m: usize, family: usize| (family * self.blocks.len() + m) * stride;
        let mut waves = vec![0.0; families * self.blocks.len() * stride];
        for (level, row) in x[..self.wall()].chunks_exact(meridians).enumerate() {
            self.ring.analyse(row, false, Weight::Forces, &mut room, |m, f, c| waves[at(m, f) + level] = c);
        }
        let place = |a: &RingAmplitude| at(a.harmonic, a.family) + self.levels + a.slot;
        for (a, &q) in self.amplitudes.iter().zip(&x[self.wall()..]) {
            waves[place(a)] = q;
        }
        let mut images = vec![0.0; waves.len()];
        let matrices = self.blocks.iter().map(of).enumerate();
        for (m, matrix) in matrices.filter_map(|(m, a)| Some((m, a?))) {
            for family in 0..families {
                let start = at(m, family);
                let image = &mut images[start..start + matrix.rows];
                for (j, &c) in waves[start..start + matrix.rows].iter().enumerate() {
                    let c = factor * c;
                    image.iter_mut().zip(matrix.column(j)).for_each(|(y, a)| *y += a * c);
                }
            }
        }
        let (nodes, own) = y.split_at_mut(self.wall());
        let mut row = vec![0.0; meridians];
        for (level, out) in nodes.chunks_exact_mut(meridians).enumerate() {
            let get = |m: usize, f: usize| images[at(m, f) + level];
            self.ring.synthesise(false, Weight::Forces, &mut room, get, &mut row);
            out.iter_mut().zip(&row).for_each(|(y, r)| *y += r);
        }
        for (a, y) in self.amplitudes.iter().zip(own) {
            *y += images[place(a)];
        }
    }
}
