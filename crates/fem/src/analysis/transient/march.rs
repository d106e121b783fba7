//! The step itself: vectors of all records side by side, one sweep and one solve.

mod energy;

use std::sync::Arc;

use super::low_rank::LowRank;
use super::{Load, Settings};
use crate::analysis::scheme::GeneralizedAlpha;
use crate::analysis::sweep::Sweep;
use crate::analysis::system::System;
use crate::analysis::{AnalysisError, failed};
use crate::linalg::{Factor, Matrix, Symbolic, dot};

/// Residual ‖r − A a‖/‖r‖ above which every solution is refined once.
const REFINE: f64 = 1e-10;

/// K, M and the sparse part of C where there is one.
enum Matrices {
    Two(Sweep<2>),
    Three(Sweep<3>),
}

pub(super) struct March<'a> {
    system: &'a System,
    loads: &'a [Load],
    constant: Option<&'a [f64]>,
    scheme: GeneralizedAlpha,
    n: usize,
    matrices: Matrices,
    factor: Factor,
    /// (M + ε K), for jumps.
    symbolic: &'a Arc<Symbolic>,
    settings: &'a Settings,
    mass_factor: Option<Factor>,
    low_rank: Option<LowRank<'a>>,
    u: Vec<f64>,
    v: Vec<f64>,
    a: Vec<f64>,
    ku: Vec<f64>,
    kv: Vec<f64>,
    ka: Vec<f64>,
    mv: Vec<f64>,
    ma: Vec<f64>,
    /// C_s v, C_s a; empty without C_s.
    sv: Vec<f64>,
    sa: Vec<f64>,
    right: Vec<f64>,
    next: Matrix,
    spare: Vec<f64>,
    products: [Vec<f64>; 3],
    /// Values of the time functions at the end of the last step: three components, then the forces, record by record.
    now: Vec<Vec<f64>>,
    input: Vec<f64>,
    damped: Vec<f64>,
    /// Kinetic and elastic energy of the initial state.
    initial: Vec<(f64, f64)>,
    /// Whether all dofs and no held ones carry mass, so that a jump Δa_g of the ground is a jump −ι_k Δa_g of ẍ.
    rigid: [bool; 3],
    refine: bool,
    residual: f64,
}

impl<'a> March<'a> {
    pub(super) fn new(
        system: &'a System,
        symbolic: &'a Arc<Symbolic>,
        loads: &'a [Load],
        settings: &'a Settings,
        scheme: GeneralizedAlpha,
    ) -> Result<March<'a>, AnalysisError> {
        let (n, columns) = (system.size(), loads.len());
        let w = scheme.acceleration_weights();
        let r = system.damping.rayleigh;
        let mut effective = system.mass.clone();
        (effective.values.iter_mut()).for_each(|m| *m *= w.mass + w.damping * r.mass);
        effective.add(w.stiffness + w.damping * r.stiffness, &system.stiffness);
        if let Some(c) = &system.damping.sparse {
            effective.add(w.damping, c);
        }
        let factor =
            symbolic.factor(&effective, settings.kind).map_err(failed("the effective matrix of a time step"))?;
        let zero = || vec![0.0; n * columns];
        let sparse = system.damping.sparse.as_ref();
        let matrices = match sparse {
            None => Matrices::Two(Sweep::new([&system.stiffness, &system.mass])),
            Some(c) => Matrices::Three(Sweep::new([&system.stiffness, &system.mass, c])),
        };
        let optional = |wanted: bool| if wanted { zero() } else { Vec::new() };
        let low_rank = match &system.damping.modal {
            Some(part) => Some(LowRank::new(part, w.damping, &factor, columns)?),
            None => None,
        };
        let massive = (0..n).all(|i| system.mass.get(i, i) > 0.0);
        let mut march = March {
            system,
            loads,
            constant: settings.constant.as_deref(),
            scheme,
            n,
            matrices,
            factor,
            symbolic,
            settings,
            mass_factor: None,
            low_rank,
            u: zero(),
            v: zero(),
            a: zero(),
            ku: zero(),
            kv: zero(),
            ka: zero(),
            mv: zero(),
            ma: zero(),
            sv: optional(sparse.is_some()),
            sa: optional(sparse.is_some()),
            right: zero(),
            next: Matrix::zeros(n, columns),
            spare: vec![0.0; n],
            products: [zero(), zero(), optional(sparse.is_some())],
            now: loads.iter().map(|l| vec![0.0; 3 + l.forces.len()]).collect(),
            input: vec![0.0; columns],
            damped: vec![0.0; columns],
            initial: vec![(0.0, 0.0); columns],
            rigid: [0, 1, 2].map(|k| massive && system.inertia[k] == system.mass.times(&system.influence[k])),
            refine: false,
            residual: 0.0,
        };
        march.start()?;
        Ok(march)
    }

    /// Initial state, and the acceleration that its loads give.
    fn start(&mut self) -> Result<(), AnalysisError> {
        let (n, columns) = (self.n, self.loads.len());
        if let Some((u, v)) = &self.settings.initial {
            for c in 0..columns {
                self.u[c * n..(c + 1) * n].copy_from_slice(u);
                self.v[c * n..(c + 1) * n].copy_from_slice(v);
            }
            self.refresh();
            for c in 0..columns {
                self.initial[c] = self.stored(c);
            }
            // Imbalance of the initial state: constant load − K u − C v.
            for c in 0..columns {
                let range = c * n..(c + 1) * n;
                let damping = &self.system.damping;
                let mut force = self.ku[range.clone()].to_vec();
                let viscous = damping.times(&self.system.mass, &self.system.stiffness, &self.v[range.clone()]);
                let constant = self.constant.unwrap_or(&[]);
                let mut scale = 0.0;
                for (i, f) in force.iter_mut().enumerate() {
                    let p = constant.get(i).copied().unwrap_or(0.0);
                    scale += f.abs() + p.abs() + viscous[i].abs();
                    *f = p - *f - viscous[i];
                }
                // The rounding of an equilibrium is not a load.
                if force.iter().map(|f| f.abs()).sum::<f64>() > 1e-9 * scale {
                    self.accelerate(c, &force)?;
                }
            }
        } else if let Some(p) = self.constant {
            for c in 0..columns {
                self.accelerate(c, p)?;
            }
        }
        self.jumps(0)
    }

    /// Adds M⁻¹ `force` to the acceleration of record `c`.
    fn accelerate(&mut self, c: usize, force: &[f64]) -> Result<(), AnalysisError> {
        let h = self.scheme.h;
        if self.mass_factor.is_none() {
            let mut regular = self.system.mass.clone();
            regular.add(0.25e-6 * h * h, &self.system.stiffness);
            let factor = self.symbolic.factor(&regular, self.settings.kind);
            self.mass_factor = Some(factor.map_err(failed("the mass matrix"))?);
        }
        let factor = self.mass_factor.as_ref().expect("just made");
        let mut a = factor.solve_vector(force).map_err(failed("the initial acceleration"))?;
        let mut rest = force.to_vec();
        self.system.mass.add_product(-1.0, &a, &mut rest);
        let d = factor.solve_vector(&rest).map_err(failed("the initial acceleration"))?;
        for (a, d) in a.iter_mut().zip(d) {
            *a += d;
        }
        let range = c * self.n..(c + 1) * self.n;
        for (total, a) in self.a[range].iter_mut().zip(a) {
            *total += a;
        }
        self.products_of_acceleration();
        Ok(())
    }

    /// Lets the accelerations jump where the loads do at the beginning of sub-step `i`.
    fn jumps(&mut self, i: usize) -> Result<(), AnalysisError> {
        for c in 0..self.loads.len() {
            let load = &self.loads[c];
            let mut force: Option<Vec<f64>> = None;
            let ground = load.ground.iter().map(Option::as_ref);
            let motions = ground.chain(load.forces.iter().map(|(_, m)| Some(m)));
            for (k, motion) in motions.enumerate() {
                let Some(motion) = motion else { continue };
                let begin = match i {
                    0 => motion.at(0),
                    _ => motion.interval(i).0,
                };
                let jump = begin - self.now[c][k];
                if jump == 0.0 {
                    continue;
                }
                self.now[c][k] = begin;
                if self.rigid.get(k) == Some(&true) {
                    let own = &mut self.a[c * self.n..(c + 1) * self.n];
                    for (a, iota) in own.iter_mut().zip(&self.system.influence[k]) {
                        *a -= jump * iota;
                    }
                    self.products_of_acceleration();
                    continue;
                }
                let (shape, sign) = match k {
                    0..3 => (&self.system.inertia[k], -1.0),
                    _ => (&load.forces[k - 3].0, 1.0),
                };
                let force = force.get_or_insert_with(|| vec![0.0; self.n]);
                for (f, s) in force.iter_mut().zip(shape) {
                    *f += sign * jump * s;
                }
            }
            if let Some(force) = force {
                self.accelerate(c, &force)?;
            }
        }
        Ok(())
    }

    /// K x, M x and C_s x of all columns into `products`.
    fn multiply(matrices: &mut Matrices, products: &mut [Vec<f64>; 3], x: &[f64], columns: usize) {
        let [k, m, c] = products;
        match matrices {
            Matrices::Two(sweep) => sweep.apply(x, columns, [k, m]),
            Matrices::Three(sweep) => sweep.apply(x, columns, [k, m, c]),
        }
    }

    fn products_of_acceleration(&mut self) {
        let columns = self.loads.len();
        Self::multiply(&mut self.matrices, &mut self.products, &self.a, columns);
        self.ka.copy_from_slice(&self.products[0]);
        self.ma.copy_from_slice(&self.products[1]);
        self.sa.copy_from_slice(&self.products[2]);
        if let Some(low) = &mut self.low_rank {
            low.set_acceleration(&self.a);
        }
    }

    /// Forms K u, K v, M v … again from u and v.
    pub(super) fn refresh(&mut self) {
        let columns = self.loads.len();
        Self::multiply(&mut self.matrices, &mut self.products, &self.u, columns);
        self.ku.copy_from_slice(&self.products[0]);
        Self::multiply(&mut self.matrices, &mut self.products, &self.v, columns);
        self.kv.copy_from_slice(&self.products[0]);
        self.mv.copy_from_slice(&self.products[1]);
        self.sv.copy_from_slice(&self.products[2]);
        if let Some(low) = &mut self.low_rank {
            low.set_velocity(&self.v);
        }
    }

    /// The sub-step from `i` to `i` + 1; `look` at the residual of its solution.
    pub(super) fn step(&mut self, i: usize, look: bool) -> Result<(), AnalysisError> {
        if i > 0 {
            self.jumps(i)?;
        }
        let columns = self.loads.len();
        for c in 0..columns {
            self.right_hand_side(c, i);
        }
        self.next.data.copy_from_slice(&self.right);
        self.solve()?;
        Self::multiply(&mut self.matrices, &mut self.products, &self.next.data, columns);
        if look || self.refine {
            self.look()?;
        }
        if let Some(low) = &mut self.low_rank {
            low.set_next(&self.next.data);
        }
        for c in 0..columns {
            self.advance(c, i);
        }
        self.a.copy_from_slice(&self.next.data);
        self.ka.copy_from_slice(&self.products[0]);
        self.ma.copy_from_slice(&self.products[1]);
        self.sa.copy_from_slice(&self.products[2]);
        Ok(())
    }

    /// Right-hand side of record `c` into `right`.
    fn right_hand_side(&mut self, c: usize, i: usize) {
        let (n, s) = (self.n, &self.scheme);
        let (af, h) = (1.0 - s.alpha_f, s.h);
        let (g1, b1) = ((1.0 - s.gamma) * h, (0.5 - s.beta) * h * h);
        let r = self.system.damping.rayleigh;
        let on_kv = af * h + r.stiffness;
        let on_ka = af * (b1 + r.stiffness * g1);
        let (on_mv, on_ma) = (r.mass, s.alpha_m + r.mass * af * g1);
        let range = c * n..(c + 1) * n;
        let right = &mut self.right[range.clone()];
        let (ku, kv, ka) = (&self.ku[range.clone()], &self.kv[range.clone()], &self.ka[range.clone()]);
        let (mv, ma) = (&self.mv[range.clone()], &self.ma[range.clone()]);
        for j in 0..n {
            right[j] = -(ku[j] + on_kv * kv[j] + on_ka * ka[j] + on_mv * mv[j] + on_ma * ma[j]);
        }
        if !self.sv.is_empty() {
            let (sv, sa) = (&self.sv[range.clone()], &self.sa[range]);
            for j in 0..n {
                right[j] -= sv[j] + af * g1 * sa[j];
            }
        }
        if let Some(low) = &self.low_rank {
            low.subtract_force(c, af * g1, right);
        }
        if let Some(p) = self.constant {
            add(1.0, p, right);
        }
        let load = &self.loads[c];
        let at = |end: (f64, f64)| af * end.1 + (1.0 - af) * end.0;
        for (k, motion) in load.ground.iter().enumerate() {
            if let Some(motion) = motion {
                add(-at(motion.interval(i)), &self.system.inertia[k], right);
            }
        }
        for (force, motion) in &load.forces {
            add(at(motion.interval(i)), force, right);
        }
    }

    /// `next` ← A⁻¹ `next`.
    fn solve(&mut self) -> Result<(), AnalysisError> {
        self.factor.solve(&mut self.next).map_err(failed("a time step"))?;
        if let Some(low) = &self.low_rank {
            low.correct(&mut self.next);
        }
        Ok(())
    }

    /// Looks at the residual of the solution and refines it if it is worse than it should be.
    fn look(&mut self) -> Result<(), AnalysisError> {
        let found = self.residual_of_solution();
        self.residual = self.residual.max(found);
        if found > REFINE || self.refine {
            self.refine = true;
            let first = self.next.data.clone();
            let columns = self.loads.len();
            for c in 0..columns {
                self.rest(c);
                self.next.column_mut(c).copy_from_slice(&self.spare);
            }
            self.solve()?;
            for (x, first) in self.next.data.iter_mut().zip(&first) {
                *x += first;
            }
            Self::multiply(&mut self.matrices, &mut self.products, &self.next.data, columns);
        }
        Ok(())
    }

    /// r − A a of record `c` into `spare`, from the products.
    fn rest(&mut self, c: usize) {
        let (n, w) = (self.n, self.scheme.acceleration_weights());
        let r = self.system.damping.rayleigh;
        let (on_k, on_m) = (w.stiffness + w.damping * r.stiffness, w.mass + w.damping * r.mass);
        let range = c * n..(c + 1) * n;
        let (k, m) = (&self.products[0][range.clone()], &self.products[1][range.clone()]);
        let right = &self.right[range.clone()];
        for j in 0..n {
            self.spare[j] = right[j] - on_k * k[j] - on_m * m[j];
        }
        if !self.products[2].is_empty() {
            add(-w.damping, &self.products[2][range], &mut self.spare);
        }
        if let Some(low) = &self.low_rank {
            low.add_product(-w.damping, self.next.column(c), &mut self.spare);
        }
    }

    fn residual_of_solution(&mut self) -> f64 {
        let mut worst = 0.0_f64;
        for c in 0..self.loads.len() {
            self.rest(c);
            let right = &self.right[c * self.n..(c + 1) * self.n];
            let scale = dot(right, right);
            if scale > 0.0 {
                worst = worst.max((dot(&self.spare, &self.spare) / scale).sqrt());
            }
        }
        worst
    }

    /// Carries the vectors and energies of record `c` to the end of the step.
    fn advance(&mut self, c: usize, i: usize) {
        let (n, s) = (self.n, &self.scheme);
        let h = s.h;
        let (g0, g1) = ((1.0 - s.gamma) * h, s.gamma * h);
        let (b0, b1) = ((0.5 - s.beta) * h * h, s.beta * h * h);
        let r = self.system.damping.rayleigh;
        let range = c * n..(c + 1) * n;
        let du = &mut self.spare[..n];
        let mut loss = 0.0;
        {
            let (u, v) = (&mut self.u[range.clone()], &mut self.v[range.clone()]);
            let (a0, a1) = (&self.a[range.clone()], &self.next.data[range.clone()]);
            for j in 0..n {
                du[j] = h * v[j] + b0 * a0[j] + b1 * a1[j];
                u[j] += du[j];
                v[j] += g0 * a0[j] + g1 * a1[j];
            }
        }
        {
            let (ku, kv) = (&mut self.ku[range.clone()], &mut self.kv[range.clone()]);
            let mv = &mut self.mv[range.clone()];
            let (ka0, ka1) = (&self.ka[range.clone()], &self.products[0][range.clone()]);
            let (ma0, ma1) = (&self.ma[range.clone()], &self.products[1][range.clone()]);
            for j in 0..n {
                ku[j] += h * kv[j] + b0 * ka0[j] + b1 * ka1[j];
                let (dk, dm) = (g0 * ka0[j] + g1 * ka1[j], g0 * ma0[j] + g1 * ma1[j]);
                loss += du[j] * (r.stiffness * (2.0 * kv[j] + dk) + r.mass * (2.0 * mv[j] + dm));
                kv[j] += dk;
                mv[j] += dm;
            }
        }
        if !self.sv.is_empty() {
            let sv = &mut self.sv[range.clone()];
            let (sa0, sa1) = (&self.sa[range.clone()], &self.products[2][range]);
            for j in 0..n {
                let d = g0 * sa0[j] + g1 * sa1[j];
                loss += du[j] * (2.0 * sv[j] + d);
                sv[j] += d;
            }
        }
        if let Some(low) = &mut self.low_rank {
            loss += low.advance(c, [h, b0, b1, g0, g1]);
        }
        self.damped[c] += 0.5 * loss;
        let load = &self.loads[c];
        let mut work = self.constant.map_or(0.0, |p| dot(p, du));
        for (k, motion) in load.ground.iter().enumerate() {
            if let Some(motion) = motion {
                let (begin, end) = motion.interval(i);
                work -= 0.5 * (begin + end) * dot(&self.system.inertia[k], du);
                self.now[c][k] = end;
            }
        }
        for (k, (force, motion)) in load.forces.iter().enumerate() {
            let (begin, end) = motion.interval(i);
            work += 0.5 * (begin + end) * dot(force, du);
            self.now[c][3 + k] = end;
        }
        self.input[c] += work;
    }

    /// u, v, a of record `c`.
    pub(super) fn fields(&self, c: usize) -> (&[f64], &[f64], &[f64]) {
        let range = c * self.n..(c + 1) * self.n;
        (&self.u[range.clone()], &self.v[range.clone()], &self.a[range])
    }

    pub(super) fn load(&self, c: usize) -> &Load {
        &self.loads[c]
    }

    pub(super) fn residual(&self) -> f64 {
        self.residual
    }
}

/// y ← y + factor x.
fn add(factor: f64, x: &[f64], y: &mut [f64]) {
    for (y, x) in y.iter_mut().zip(x) {
        *y += factor * x;
    }
}
