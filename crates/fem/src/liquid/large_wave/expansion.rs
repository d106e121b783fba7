//! Rates of the elevation and of the potential on the surface.

use super::basis::{Basis, LANES};
use super::motion::Motion;

/// What the liquid is, beside its plan.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Properties {
    /// Depth at rest H [m].
    pub depth: f64,
    /// Density [kg/m³].
    pub density: f64,
    /// Gravity [m/s²].
    pub gravity: f64,
    /// Damping ratio of each mode.
    pub damping: f64,
    /// Order of the expansion, 1 to 3; 1 is the linear theory.
    pub order: usize,
}

/// Liquid in a rigid upright tank.
#[derive(Clone, Debug)]
pub struct Liquid {
    pub(super) basis: Basis,
    pub(super) own: Properties,
    /// tanh k_j H and ω_j [rad/s] of each mode.
    pub(super) tanh: Vec<f64>,
    pub(super) omega: Vec<f64>,
}

/// A place for what a step computes, so that none is allocated in a step.
#[derive(Clone, Debug)]
pub(super) struct Work {
    /// Coefficients of the derivatives of the three orders.
    coefficients: [Vec<f64>; 6],
    /// Projections of the second and third order of the potential, the rates before they are summed.
    pub(super) orders: [Vec<f64>; 2],
    sums: [Vec<[f64; LANES]>; 2],
    fields: Vec<Fields>,
    /// Largest squared slope, and the point that has it.
    pub(super) steepest: (f64, usize),
    /// Smallest elevation, and the point that has it.
    pub(super) lowest: (f64, usize),
}

/// Values on the points of a block, which later passes need.
#[derive(Clone, Copy, Debug, Default)]
struct Fields {
    elevation: [f64; LANES],
    /// |∇η|², ∇η·∇ψ and |∇ψ|².
    products: [[f64; LANES]; 3],
    /// ∂_z to ∂_z³ of the first order.
    first: [[f64; LANES]; 3],
    /// ∂_z and ∂_z² of the second order.
    second: [[f64; LANES]; 2],
}

/// An expansion in the widest registers there are. The body of a closure is not compiled for them.
struct Expand<'a> {
    liquid: &'a Liquid,
    state: (&'a [f64], &'a [f64]),
    work: &'a mut Work,
    rates: (&'a mut [f64], &'a mut [f64]),
}

impl pulp::WithSimd for Expand<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: pulp::Simd>(self, _: S) {
        self.liquid.expand(self.state, self.work, self.rates);
    }
}

impl Liquid {
    /// Liquid on the modes of a tank. The order is limited to 1 to 3.
    pub fn new(basis: Basis, own: Properties) -> Liquid {
        let own = Properties { order: own.order.clamp(1, 3), ..own };
        let tanh: Vec<f64> = basis.modes.iter().map(|mode| (mode.wave_number * own.depth).tanh()).collect();
        let omega = basis.modes.iter().zip(&tanh).map(|(m, t)| (own.gravity * m.wave_number * t).sqrt()).collect();
        Liquid { basis, own, tanh, omega }
    }

    /// The modes.
    pub fn basis(&self) -> &Basis {
        &self.basis
    }

    /// The properties.
    pub fn properties(&self) -> Properties {
        self.own
    }

    /// Circular frequencies of small waves [rad/s], 0 of the constant.
    pub fn omega(&self) -> &[f64] {
        &self.omega
    }

    /// Mass of the liquid [kg].
    pub fn mass(&self) -> f64 {
        self.own.density * self.basis.area() * self.own.depth
    }

    pub(super) fn work(&self) -> Work {
        let n = self.basis.modes.len();
        Work {
            coefficients: std::array::from_fn(|_| vec![0.0; n]),
            orders: std::array::from_fn(|_| vec![0.0; n]),
            sums: std::array::from_fn(|_| vec![[0.0; LANES]; n]),
            fields: vec![Fields::default(); self.basis.blocks],
            steepest: (0.0, 0),
            lowest: (0.0, 0),
        }
    }

    /// Rates of the coefficients of η and ψ; the higher orders of the potential stay in the workspace.
    pub(super) fn rates(
        &self,
        (elevation, potential): (&[f64], &[f64]),
        motion: &Motion,
        work: &mut Work,
        (elevation_rate, potential_rate): (&mut [f64], &mut [f64]),
    ) {
        let rates = (&mut *elevation_rate, &mut *potential_rate);
        pulp::Arch::new().dispatch(Expand { liquid: self, state: (elevation, potential), work, rates });
        let Properties { gravity, damping, .. } = self.own;
        for j in 0..elevation.len() {
            potential_rate[j] -= (gravity + motion.vertical) * elevation[j]
                + 2.0 * damping * self.omega[j] * potential[j]
                + self.push(j, motion);
        }
    }

    /// Horizontal acceleration and rotation as the potential of mode j feels them [m²/s²].
    ///
    /// The potential of a rotation about the floor's centre has H − (2/k) tanh(kH/2) times the coefficient of x at the level at
    /// rest.
    pub(super) fn push(&self, j: usize, motion: &Motion) -> f64 {
        let Properties { gravity, depth, .. } = self.own;
        let k = self.basis.modes[j].wave_number;
        if k == 0.0 {
            return 0.0;
        }
        let arm = depth - 2.0 / k * (0.5 * k * depth).tanh();
        let along = |d: usize| {
            (motion.acceleration[d] - gravity * motion.tilt[d] + arm * motion.angular[d]) * self.basis.lever[d][j]
        };
        (along(0) + along(1)) / self.basis.norm[j]
    }

    /// Rates without gravity, damping and motion, by three passes over the points: each order needs the projection of the one
    /// before it.
    #[inline(always)]
    fn expand(
        &self,
        (elevation, potential): (&[f64], &[f64]),
        work: &mut Work,
        (elevation_rate, potential_rate): (&mut [f64], &mut [f64]),
    ) {
        let [z1, z2, z3, ..] = &mut work.coefficients;
        for (j, mode) in self.basis.modes.iter().enumerate() {
            let k = mode.wave_number;
            z1[j] = k * self.tanh[j] * potential[j];
            z2[j] = k * k * potential[j];
            z3[j] = k * k * z1[j];
        }
        work.orders.iter_mut().for_each(|order| order.fill(0.0));
        if self.own.order == 1 {
            elevation_rate.copy_from_slice(&work.coefficients[0]);
            potential_rate.fill(0.0);
            self.watch(elevation, work);
            return;
        }
        self.second_order(elevation, potential, work);
        self.third_order(work);
        self.collected(work, elevation_rate, potential_rate);
    }

    /// Products of first-order fields, and the projection of the potential of second order.
    #[inline(always)]
    fn second_order(&self, elevation: &[f64], potential: &[f64], work: &mut Work) {
        let basis = &self.basis;
        let size = elevation.len() * LANES;
        let [z1, z2, z3, s1, s2, _] = &mut work.coefficients;
        let sum = &mut work.sums[0];
        sum.fill([0.0; LANES]);
        work.steepest = (0.0, 0);
        work.lowest = (0.0, 0);
        for (b, fields) in work.fields.iter_mut().enumerate() {
            let part = b * size..(b + 1) * size;
            let value = &basis.value[part.clone()];
            let [eta, w1, w2, w3] = synthesise(value, [elevation, z1, z2, z3]);
            let [ex, px] = synthesise(&basis.slope[0][part.clone()], [elevation, potential]);
            let [ey, py] = synthesise(&basis.slope[1][part.clone()], [elevation, potential]);
            let mut second = [0.0; LANES];
            for i in 0..LANES {
                fields.products[0][i] = ex[i] * ex[i] + ey[i] * ey[i];
                fields.products[1][i] = ex[i] * px[i] + ey[i] * py[i];
                fields.products[2][i] = px[i] * px[i] + py[i] * py[i];
                second[i] = -eta[i] * w1[i];
            }
            for i in 0..LANES {
                if fields.products[0][i] > work.steepest.0 {
                    work.steepest = (fields.products[0][i], b * LANES + i);
                }
                if eta[i] < work.lowest.0 {
                    work.lowest = (eta[i], b * LANES + i);
                }
            }
            fields.elevation = eta;
            fields.first = [w1, w2, w3];
            collect(&basis.projection[part], &second, sum);
        }
        total(sum, &mut work.orders[0]);
        for (j, mode) in basis.modes.iter().enumerate() {
            let k = mode.wave_number;
            s1[j] = k * self.tanh[j] * work.orders[0][j];
            s2[j] = k * k * work.orders[0][j];
        }
    }

    /// Derivatives of the second order, and the projection of the potential of third order, where that is asked for.
    #[inline(always)]
    fn third_order(&self, work: &mut Work) {
        let basis = &self.basis;
        let size = basis.modes.len() * LANES;
        let third_too = self.own.order > 2;
        let [.., s1, s2, t1] = &mut work.coefficients;
        let sum = &mut work.sums[0];
        sum.fill([0.0; LANES]);
        for (b, fields) in work.fields.iter_mut().enumerate() {
            let part = b * size..(b + 1) * size;
            fields.second = synthesise(&basis.value[part.clone()], [s1, s2]);
            if third_too {
                let mut third = [0.0; LANES];
                for i in 0..LANES {
                    let eta = fields.elevation[i];
                    third[i] = -eta * (fields.second[0][i] + 0.5 * eta * fields.first[1][i]);
                }
                collect(&basis.projection[part], &third, sum);
            }
        }
        if third_too {
            total(sum, &mut work.orders[1]);
            for (j, mode) in basis.modes.iter().enumerate() {
                t1[j] = mode.wave_number * self.tanh[j] * work.orders[1][j];
            }
        }
    }

    /// The projected rates from the fields of all orders.
    #[inline(always)]
    fn collected(&self, work: &mut Work, elevation_rate: &mut [f64], potential_rate: &mut [f64]) {
        let basis = &self.basis;
        let size = basis.modes.len() * LANES;
        let order = self.own.order;
        let [z1, .., t1] = &work.coefficients;
        let [sum, other] = &mut work.sums;
        sum.fill([0.0; LANES]);
        other.fill([0.0; LANES]);
        for (b, fields) in work.fields.iter().enumerate() {
            let part = b * size..(b + 1) * size;
            let third = if order > 2 {
                let [third] = synthesise(&basis.value[part.clone()], [t1]);
                third
            } else {
                [0.0; LANES]
            };
            let (mut rise, mut push) = ([0.0; LANES], [0.0; LANES]);
            let [steep, mixed, fast] = &fields.products;
            for i in 0..LANES {
                let eta = fields.elevation[i];
                let w1 = fields.first[0][i];
                let w2 = fields.second[0][i] + eta * fields.first[1][i];
                let w3 = third[i] + eta * (fields.second[1][i] + 0.5 * eta * fields.first[2][i]);
                let third = if order > 2 { w3 } else { 0.0 };
                // W is cut at the order; its products with η and with itself keep all terms, which is nearer to the next order.
                let w = w1 + w2 + third;
                rise[i] = w - w1 - mixed[i] + steep[i] * w;
                push[i] = 0.5 * ((1.0 + steep[i]) * w * w - fast[i]);
            }
            collect(&basis.projection[part.clone()], &rise, sum);
            collect(&basis.projection[part], &push, other);
        }
        total(sum, elevation_rate);
        total(other, potential_rate);
        for (rate, z) in elevation_rate.iter_mut().zip(z1) {
            *rate += z;
        }
    }

    /// Slope and lowest elevation of a linear wave.
    #[inline(always)]
    fn watch(&self, elevation: &[f64], work: &mut Work) {
        let size = elevation.len() * LANES;
        work.steepest = (0.0, 0);
        work.lowest = (0.0, 0);
        for b in 0..self.basis.blocks {
            let part = b * size..(b + 1) * size;
            let [eta] = synthesise(&self.basis.value[part.clone()], [elevation]);
            let [x] = synthesise(&self.basis.slope[0][part.clone()], [elevation]);
            let [y] = synthesise(&self.basis.slope[1][part], [elevation]);
            for i in 0..LANES {
                let steep = x[i] * x[i] + y[i] * y[i];
                if steep > work.steepest.0 {
                    work.steepest = (steep, b * LANES + i);
                }
                if eta[i] < work.lowest.0 {
                    work.lowest = (eta[i], b * LANES + i);
                }
            }
        }
    }
}

/// Fields on the points of a block from coefficients of the modes.
#[inline(always)]
fn synthesise<const F: usize>(table: &[f64], coefficients: [&[f64]; F]) -> [[f64; LANES]; F] {
    let mut sums = [[0.0; LANES]; F];
    for (j, row) in table.as_chunks::<LANES>().0.iter().enumerate() {
        for f in 0..F {
            let c = coefficients[f][j];
            for i in 0..LANES {
                sums[f][i] += c * row[i];
            }
        }
    }
    sums
}

/// Adds a field's part of the projections.
#[inline(always)]
fn collect(table: &[f64], field: &[f64; LANES], sums: &mut [[f64; LANES]]) {
    for (row, sum) in table.as_chunks::<LANES>().0.iter().zip(sums) {
        for i in 0..LANES {
            sum[i] += row[i] * field[i];
        }
    }
}

#[inline(always)]
fn total(sums: &[[f64; LANES]], out: &mut [f64]) {
    for (out, sum) in out.iter_mut().zip(sums) {
        *out = sum.iter().sum();
    }
}
