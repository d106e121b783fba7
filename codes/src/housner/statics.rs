//! Hydrostatic membrane state of a cylindrical wall with its edge disturbances (dissertation, Anhang D.4).
//!
//! Axisymmetric bending of a cylinder under the pressure `p = γ (H − z)` below the surface, courses of different
//! thickness:
//!
//! ```text
//! K w⁗ + (E s/R²) w = p          K = E s³/(12 (1 − ν²))       λ = [3 (1 − ν²)]^¼/√(R s)
//! w = γ R²/(E s) (H − z) + e^{−λ(z−z₀)} [A cos λ(z−z₀) + B sin λ(z−z₀)]
//!                        + e^{−λ(z₁−z)} [C cos λ(z₁−z) + D sin λ(z₁−z)]                z₀ ≤ z ≤ z₁
//! n_φ = E s w/R      m_z = −K w″      q_z = −K w‴
//! ```
//!
//! Each segment (course, split at the surface) has four constants; deflection, slope, moment and shear are continuous at
//! joints, the base is clamped or hinged, the top free. A long uniform wall clamped at its base gives the closed form
//! `m_z(0) = −γ R s H (1 − 1/(λH))/√(12 (1 − ν²))`.
//!
//! `w` is positive outwards, `m_z` positive if it compresses the outside; no axial force (self-weight is small).

/// A ring of constant thickness.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Ring {
    /// Height [m].
    pub height: f64,
    /// Thickness s [m].
    pub thickness: f64,
    /// Young's modulus E [Pa].
    pub youngs_modulus: f64,
    /// Poisson's ratio ν.
    pub poisson_ratio: f64,
}

impl Ring {
    /// Plate stiffness K [N·m].
    pub(crate) fn bending_stiffness(&self) -> f64 {
        self.youngs_modulus * self.thickness.powi(3) / (12.0 * (1.0 - self.poisson_ratio * self.poisson_ratio))
    }

    /// Decay λ [1/m]; a disturbance has faded after 2π/λ.
    ///
    /// Check: R = 1.83 m, s = 2.0 mm, ν = 0.32: 2π/λ = 29.67 cm (dissertation 8.1.3: 29.6).
    pub(crate) fn decay(&self, radius: f64) -> f64 {
        (3.0 * (1.0 - self.poisson_ratio * self.poisson_ratio)).powf(0.25) / (radius * self.thickness).sqrt()
    }
}

/// Support of the wall at its base.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Base {
    /// w = w′ = 0.
    Clamped,
    /// w = 0, m_z = 0.
    Hinged,
}

/// State of the wall at one height.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct State {
    /// Radial displacement w, outwards [m].
    pub displacement: f64,
    /// Rotation w′ [rad].
    pub rotation: f64,
    /// Hoop force n_φ [N/m].
    pub hoop_force: f64,
    /// Axial bending moment m_z = −K w″ [N·m/m].
    pub moment: f64,
    /// Transverse shear q_z = −K w‴ [N/m].
    pub shear: f64,
}

/// Solved wall.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Wall {
    radius: f64,
    specific_weight: f64,
    depth: f64,
    segments: Vec<Segment>,
}

#[derive(Clone, Debug, PartialEq)]
struct Segment {
    bottom: f64,
    top: f64,
    wet: bool,
    ring: Ring,
    /// A, B, C, D.
    constants: [f64; 4],
}

/// Derivatives 0 to 3 of the four decaying solutions.
type Basis = [[f64; 4]; 4];

impl Wall {
    /// Solves the wall.
    ///
    /// * `radius`: R [m]; `rings`: from the base up; `specific_weight`: γ = ρ g [N/m³]; `depth`: H [m]
    ///
    /// Returns none if a dimension is not positive and finite or the rings end below the liquid.
    pub(crate) fn solve(radius: f64, rings: &[Ring], specific_weight: f64, depth: f64, base: Base) -> Option<Wall> {
        let sound = |v: f64| v > 0.0 && v.is_finite();
        let admissible = sound(radius)
            && sound(specific_weight)
            && sound(depth)
            && rings.iter().all(|r| {
                sound(r.height) && sound(r.thickness) && sound(r.youngs_modulus) && r.poisson_ratio.abs() < 0.5
            })
            && rings.iter().map(|r| r.height).sum::<f64>() >= depth * (1.0 - 1e-12);
        if !admissible {
            return None;
        }
        let mut wall = Wall { radius, specific_weight, depth, segments: segments(rings, depth) };
        let (matrix, right) = wall.conditions(base);
        let constants = solve_dense(matrix, right)?;
        for (segment, c) in wall.segments.iter_mut().zip(constants.chunks_exact(4)) {
            segment.constants.copy_from_slice(c);
        }
        Some(wall)
    }

    /// State at height z [m]; the upper course at a joint. Heights outside the wall are moved to its ends.
    pub(crate) fn at(&self, z: f64) -> State {
        let last = self.segments.len() - 1;
        let segment = &self.segments[self.segments.iter().position(|s| z < s.top).unwrap_or(last)];
        self.state(segment, z.clamp(segment.bottom, segment.top))
    }

    /// State just below height z [m]: the lower course at a joint.
    pub(crate) fn below(&self, z: f64) -> State {
        let last = self.segments.len() - 1;
        let segment = &self.segments[self.segments.iter().position(|s| z <= s.top).unwrap_or(last)];
        self.state(segment, z.clamp(segment.bottom, segment.top))
    }

    fn state(&self, segment: &Segment, z: f64) -> State {
        let basis = segment.basis(self.radius, z);
        let particular = self.particular(segment, z);
        let derivative = |order: usize| {
            particular[order] + basis[order].iter().zip(&segment.constants).map(|(b, c)| b * c).sum::<f64>()
        };
        let stiffness = segment.ring.bending_stiffness();
        State {
            displacement: derivative(0),
            rotation: derivative(1),
            hoop_force: segment.ring.youngs_modulus * segment.ring.thickness * derivative(0) / self.radius,
            moment: -stiffness * derivative(2),
            shear: -stiffness * derivative(3),
        }
    }

    /// Membrane solution and its derivatives.
    fn particular(&self, segment: &Segment, z: f64) -> [f64; 4] {
        if !segment.wet {
            return [0.0; 4];
        }
        let flexibility = self.radius * self.radius / (segment.ring.youngs_modulus * segment.ring.thickness);
        let slope = -self.specific_weight * flexibility;
        [slope * (z - self.depth), slope, 0.0, 0.0]
    }

    /// Support, joint and free-edge conditions, each row scaled to the size of its neighbours (w, w′/λ, w″/λ², w‴/λ³).
    fn conditions(&self, base: Base) -> (Vec<Vec<f64>>, Vec<f64>) {
        let n = 4 * self.segments.len();
        let (mut matrix, mut right) = (Vec::with_capacity(n), Vec::with_capacity(n));
        let mut edge = |segment: usize, z: f64, order: usize| {
            let s = &self.segments[segment];
            let scale = s.ring.decay(self.radius).powi(order as i32).recip();
            let mut row = vec![0.0; n];
            for (k, b) in s.basis(self.radius, z)[order].iter().enumerate() {
                row[4 * segment + k] = b * scale;
            }
            matrix.push(row);
            right.push(-self.particular(s, z)[order] * scale);
        };
        edge(0, 0.0, 0);
        edge(0, 0.0, if base == Base::Clamped { 1 } else { 2 });
        let last = self.segments.len() - 1;
        edge(last, self.segments[last].top, 2);
        edge(last, self.segments[last].top, 3);
        for joint in 1..self.segments.len() {
            let (lower, upper) = (&self.segments[joint - 1], &self.segments[joint]);
            let z = upper.bottom;
            let (basis_l, basis_u) = (lower.basis(self.radius, z), upper.basis(self.radius, z));
            let (part_l, part_u) = (self.particular(lower, z), self.particular(upper, z));
            let decay = lower.ring.decay(self.radius);
            let ratio = upper.ring.bending_stiffness() / lower.ring.bending_stiffness();
            for order in 0..4 {
                let scale = decay.powi(order as i32).recip();
                // Moment and shear carry K; relative to the lower course.
                let upper_factor = if order >= 2 { ratio } else { 1.0 };
                let mut row = vec![0.0; n];
                for k in 0..4 {
                    row[4 * (joint - 1) + k] = basis_l[order][k] * scale;
                    row[4 * joint + k] = -upper_factor * basis_u[order][k] * scale;
                }
                matrix.push(row);
                right.push((upper_factor * part_u[order] - part_l[order]) * scale);
            }
        }
        (matrix, right)
    }
}

impl Segment {
    /// Derivatives of `e^{−λu}(cos λu, sin λu)` from the bottom, u = z − z₀, and from the top, u = z₁ − z.
    fn basis(&self, radius: f64, z: f64) -> Basis {
        let lambda = self.ring.decay(radius);
        let mut basis = [[0.0; 4]; 4];
        for (column, u, direction) in [(0, z - self.bottom, 1.0), (2, self.top - z, -1.0)] {
            let e = (-lambda * u).exp();
            let (sin, cos) = (lambda * u).sin_cos();
            // d/du maps (cos, sin) to λ (−cos − sin, cos − sin).
            let (mut c, mut s) = ([e, 0.0], [0.0, e]);
            for (order, row) in basis.iter_mut().enumerate() {
                let sign = if direction < 0.0 && order % 2 == 1 { -1.0 } else { 1.0 };
                row[column] = sign * (c[0] * cos + c[1] * sin);
                row[column + 1] = sign * (s[0] * cos + s[1] * sin);
                c = [lambda * (c[1] - c[0]), -lambda * (c[0] + c[1])];
                s = [lambda * (s[1] - s[0]), -lambda * (s[0] + s[1])];
            }
        }
        basis
    }
}

/// Courses, split at the liquid surface.
fn segments(rings: &[Ring], depth: f64) -> Vec<Segment> {
    let mut list = Vec::new();
    let mut bottom = 0.0;
    for ring in rings {
        let top = bottom + ring.height;
        let segment = |bottom: f64, top: f64, wet: bool| Segment { bottom, top, wet, ring: *ring, constants: [0.0; 4] };
        // A sliver of rounding at the surface is not a segment.
        let sliver = 1e-9 * depth;
        if depth > bottom + sliver && depth < top - sliver {
            list.push(segment(bottom, depth, true));
            list.push(segment(depth, top, false));
        } else {
            list.push(segment(bottom, top, depth >= top - sliver));
        }
        bottom = top;
    }
    list
}

/// Gaussian elimination with partial pivoting; none if singular.
fn solve_dense(mut a: Vec<Vec<f64>>, mut b: Vec<f64>) -> Option<Vec<f64>> {
    let n = b.len();
    for column in 0..n {
        let pivot = (column..n).max_by(|&i, &j| a[i][column].abs().total_cmp(&a[j][column].abs()))?;
        if a[pivot][column].abs() < 1e-14 {
            return None;
        }
        a.swap(column, pivot);
        b.swap(column, pivot);
        let (done, rest) = a.split_at_mut(column + 1);
        let pivot_row = &done[column];
        for (offset, row) in rest.iter_mut().enumerate() {
            let factor = row[column] / pivot_row[column];
            if factor != 0.0 {
                for k in column..n {
                    row[k] -= factor * pivot_row[k];
                }
                b[column + 1 + offset] -= factor * b[column];
            }
        }
    }
    for i in (0..n).rev() {
        let known: f64 = (i + 1..n).map(|k| a[i][k] * b[k]).sum();
        b[i] = (b[i] - known) / a[i][i];
    }
    Some(b)
}

#[cfg(test)]
mod tests;
