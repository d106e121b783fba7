//! Bending of a wall under a pressure that varies with the height: strip or wall of a box clamped at its base, cylinder on the joint with its
//! base (clamped, hinged, or sliding against a bearing).
//!
//! Ritz' method minimises
//!
//! ```text
//! Π = ½ ∫∫ D [(w_xx + w_zz)² − 2(1−ν)(w_xx w_zz − w_xz²)] + (E s/R²) w² dx dz − ∫∫ p(z) w dx dz      D = E s³/(12(1−ν²))
//! w = Σ a_ij X_i(x/B) Z_j(z)      X_i = (1−ξ²)² P_2i(ξ)  (wall of a box)   1  (strip, cylinder)      Z_j cubic splines of Hermite
//! m_z = D (w_zz + ν w_xx)      m_x = D (w_xx + ν w_zz)      m_xz = D (1−ν) w_xz      v_x = D w_xxx at a clamped side
//! ```
//!
//! with 2B the width of the wall; the term with R only in a cylinder, whose hoop force is E s w/R. Loads act outwards; moments are
//! positive where they pull on the inner face. Clamping moment and shear at the base are the reactions of the base nodes, which
//! are exact for strips; elsewhere the moments are those of the splines. A box wall is symmetric about ξ = 0.
//!
//! A cylinder of one thickness is Timoshenko's, w'''' + 4β⁴ w = p/D with β⁴ = 3(1−ν²)/(R² s²); the splines have courses of several
//! thicknesses and a free upper edge besides. A hinge leaves the slope of the base node free, a bearing its deflection too, with the
//! stiffness k beside it: the reaction is k w.
//!
//! Against the closed forms and published tables see the tests.

use super::plate::{Element, elements, gauss, hermite};
use tank::{Course, WallBase};

/// Plan of the wall.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Plan {
    /// Wall of a box between walls to which it is clamped, width 2B [m].
    Box {
        /// Half width B [m].
        half_width: f64,
    },
    /// Strip of a long wall, plane strain.
    Strip,
    /// Cylinder under a pressure that does not vary around it.
    Cylinder {
        /// Radius R [m].
        radius: f64,
        /// What holds its foot.
        base: WallBase,
    },
}

/// Functions X of a box wall.
const FUNCTIONS: usize = 8;
/// Elements over the height, at least.
const ELEMENTS: f64 = 48.0;
/// Elements over √(R s) of a cylinder: its edge disturbance falls as exp(−1.3 z/√(R s)).
const ACROSS_DISTURBANCE: f64 = 12.0;

/// A wall, factored.
#[derive(Clone, Debug)]
pub(crate) struct Wall {
    plan: Plan,
    functions: usize,
    elements: Vec<Element>,
    /// Lower band of the Cholesky factor: row i holds columns i − width to i.
    factor: Vec<Vec<f64>>,
    /// ∫ X_i X_j, ∫ X_i″ X_j″, ∫ X_i X_j″, ∫ X_i′ X_j′ over the width.
    integrals: [Vec<Vec<f64>>; 4],
    /// ∫ X_i over the width.
    loads: Vec<f64>,
    /// Stiffness of the first element, for the reactions of the base.
    first: Vec<Vec<f64>>,
}

/// Its state under one load.
#[derive(Clone, Debug)]
pub(crate) struct State<'a> {
    wall: &'a Wall,
    /// Deflection and slope of each node from the base up, for each X.
    unknowns: Vec<f64>,
    /// Moment [N·m/m] and shear [N/m] with which the base holds the wall at ξ = 0; no moment of a hinge, k w of a bearing.
    pub base: (f64, f64),
}

/// Moments per length [N·m/m] and deflection [m] at a point.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Forces {
    pub m_x: f64,
    pub m_z: f64,
    pub m_xz: f64,
    pub w: f64,
    /// D w_xxx [N/m]: the reaction at a clamped side.
    pub v_x: f64,
}

impl Wall {
    pub(crate) fn new(courses: &[Course], plan: Plan) -> Wall {
        let height: f64 = courses.iter().map(|c| c.height).sum();
        let thinnest = courses.iter().map(|c| c.thickness).fold(f64::INFINITY, f64::min);
        let least = match plan {
            Plan::Cylinder { radius, .. } => {
                let fine = ACROSS_DISTURBANCE * height / (radius * thinnest).sqrt();
                // No wall is so thin that more are needed for three digits.
                fine.clamp(ELEMENTS, 2000.0)
            }
            _ => ELEMENTS,
        };
        Wall::with(courses, plan, FUNCTIONS, least)
    }

    fn with(courses: &[Course], plan: Plan, functions: usize, least: f64) -> Wall {
        let functions = if matches!(plan, Plan::Box { .. }) { functions } else { 1 };
        let mut wall = Wall {
            plan,
            functions,
            elements: elements(courses, &[], least),
            factor: Vec::new(),
            integrals: std::array::from_fn(|_| vec![vec![0.0; functions]; functions]),
            loads: vec![0.0; functions],
            first: Vec::new(),
        };
        wall.integrate_across();
        wall.first = wall.stiffness(&wall.elements[0]);
        wall.factor = wall.factored();
        wall
    }

    /// Value and derivatives up to the third of X_i at ξ, by x.
    fn across(&self, i: usize, xi: f64) -> [f64; 4] {
        let Plan::Box { half_width } = self.plan else { return [1.0, 0.0, 0.0, 0.0] };
        let bubble = [(1.0 - xi * xi).powi(2), 4.0 * (xi.powi(3) - xi), 12.0 * xi * xi - 4.0, 24.0 * xi];
        let [p, p1, p2, p3] = legendre(2 * i, xi);
        let [b, b1, b2, b3] = bubble;
        [
            b * p,
            (b1 * p + b * p1) / half_width,
            (b2 * p + 2.0 * b1 * p1 + b * p2) / half_width.powi(2),
            (b3 * p + 3.0 * b2 * p1 + 3.0 * b1 * p2 + b * p3) / half_width.powi(3),
        ]
    }

    /// Integrals over the width; a strip and a cylinder are 1 m wide.
    fn integrate_across(&mut self) {
        let scale = match self.plan {
            Plan::Box { half_width } => half_width,
            _ => 1.0,
        };
        // Half the width, the other half is its mirror: the factor 2 stands in stiffness and load alike.
        for (xi, weight) in across_points() {
            let jets: Vec<[f64; 4]> = (0..self.functions).map(|i| self.across(i, xi)).collect();
            let weight = weight * scale;
            for (i, a) in jets.iter().enumerate() {
                self.loads[i] += weight * a[0];
                for (j, b) in jets.iter().enumerate() {
                    for (matrix, (p, q)) in self.integrals.iter_mut().zip([(0, 0), (2, 2), (0, 2), (1, 1)]) {
                        matrix[i][j] += weight * a[p] * b[q];
                    }
                }
            }
        }
    }

    /// Stiffness between the spline `a`, X_i and the spline `b`, X_j of one element; jets and weight at a point of its height.
    fn density(&self, element: &Element, (a, i): (&[f64; 3], usize), (b, j): (&[f64; 3], usize)) -> f64 {
        let [i00, i22, i02, i11] = &self.integrals;
        let (nu, d) = (element.nu, element.rigidity);
        let plate = i22[i][j] * a[0] * b[0]
            + i00[i][j] * a[2] * b[2]
            + nu * (i02[j][i] * a[0] * b[2] + i02[i][j] * a[2] * b[0])
            + 2.0 * (1.0 - nu) * i11[i][j] * a[1] * b[1];
        let ring = match self.plan {
            Plan::Cylinder { radius, .. } => element.membrane / (radius * radius) * i00[i][j] * a[0] * b[0],
            _ => 0.0,
        };
        d * plate + ring
    }

    /// Stiffness of an element: rows and columns spline by spline, within one X by X.
    fn stiffness(&self, element: &Element) -> Vec<Vec<f64>> {
        let n = 4 * self.functions;
        let mut k = vec![vec![0.0; n]; n];
        for (t, weight) in along_points() {
            let splines = hermite(t, element.length);
            for (row, line) in k.iter_mut().enumerate() {
                for (column, value) in line.iter_mut().enumerate() {
                    let (a, i) = (&splines[row / self.functions], row % self.functions);
                    let (b, j) = (&splines[column / self.functions], column % self.functions);
                    *value += weight * element.length * self.density(element, (a, i), (b, j));
                }
            }
        }
        k
    }

    /// Number of unknowns that the base holds: deflection and slope of its node, the deflection alone, or none.
    fn held(&self) -> usize {
        match self.plan {
            Plan::Cylinder { base, .. } => {
                let (moves, turns) = base.holds();
                usize::from(moves) + usize::from(turns)
            }
            _ => 2 * self.functions,
        }
    }

    fn factored(&self) -> Vec<Vec<f64>> {
        let held = self.held();
        let n = 2 * self.functions * (self.elements.len() + 1) - held;
        let width = 4 * self.functions - 1;
        let mut band = vec![vec![0.0; width + 1]; n];
        let mut last: Option<(Element, Vec<Vec<f64>>)> = None;
        for (e, element) in self.elements.iter().enumerate() {
            let first = 2 * e * self.functions;
            let known = last.take().filter(|(known, _)| known.is_like(element));
            let (_, stiffness) = last.insert(known.unwrap_or_else(|| (*element, self.stiffness(element))));
            for (row, line) in stiffness.iter().enumerate() {
                for (column, value) in line.iter().enumerate().take(row + 1) {
                    let (Some(i), Some(j)) = ((first + row).checked_sub(held), (first + column).checked_sub(held))
                    else {
                        continue;
                    };
                    band[i][width + j - i] += value;
                }
            }
        }
        if let (Plan::Cylinder { base, .. }, 0) = (self.plan, held) {
            band[0][width] += base.stiffness();
        }
        for i in 0..n {
            let least = i.saturating_sub(width);
            for j in least..=i {
                let from = least.max(j.saturating_sub(width));
                let sum: f64 = (from..j).map(|k| band[i][width + k - i] * band[j][width + k - j]).sum();
                let value = band[i][width + j - i] - sum;
                band[i][width + j - i] = if i == j { value.sqrt() } else { value / band[j][width] };
            }
        }
        band
    }

    /// State under a pressure [Pa] over the height [m].
    pub(crate) fn under(&self, pressure: impl Fn(f64) -> f64) -> State<'_> {
        let mut force = vec![0.0; 2 * self.functions * (self.elements.len() + 1)];
        for (e, element) in self.elements.iter().enumerate() {
            for (t, weight) in along_points() {
                let load = weight * element.length * pressure(element.base + t * element.length);
                for (a, spline) in hermite(t, element.length).iter().enumerate() {
                    for (i, across) in self.loads.iter().enumerate() {
                        force[(2 * e + a) * self.functions + i] += load * spline[0] * across;
                    }
                }
            }
        }
        self.state(&force)
    }

    /// State of a cylinder under an outward line force of 1 N/m at a foot that can move.
    pub(crate) fn pulled(&self) -> State<'_> {
        let mut force = vec![0.0; 2 * self.functions * (self.elements.len() + 1)];
        force[0] = 1.0;
        self.state(&force)
    }

    fn state(&self, force: &[f64]) -> State<'_> {
        let held = self.held();
        let mut unknowns = force.to_vec();
        unknowns[..held].fill(0.0);
        self.solve(&mut unknowns[held..]);
        // Reactions of the base: stiffness of the first element times its unknowns, less its load.
        let reaction = |row: usize| -> f64 {
            let inner: f64 = self.first[row].iter().zip(&unknowns).map(|(k, u)| k * u).sum();
            inner - force[row]
        };
        let [shear, moment] = [0, 1].map(|a| {
            let rows: Vec<f64> = (0..self.functions).map(|i| reaction(a * self.functions + i)).collect();
            // As a line load Σ c_i X_i, at ξ = 0.
            let line = dense_solve(&self.integrals[0], &rows);
            line.iter().enumerate().map(|(i, c)| c * self.across(i, 0.0)[0]).sum::<f64>()
        });
        State {
            wall: self,
            unknowns,
            // The base pulls inwards and turns the wall inwards.
            base: (-moment, -shear),
        }
    }

    fn solve(&self, x: &mut [f64]) {
        let width = 4 * self.functions - 1;
        let (band, n) = (&self.factor, x.len());
        for i in 0..n {
            let sum: f64 = (i.saturating_sub(width)..i).map(|k| band[i][width + k - i] * x[k]).sum();
            x[i] = (x[i] - sum) / band[i][width];
        }
        for i in (0..n).rev() {
            let sum: f64 = (i + 1..n.min(i + width + 1)).map(|k| band[k][width + i - k] * x[k]).sum();
            x[i] = (x[i] - sum) / band[i][width];
        }
    }
}

impl State<'_> {
    /// Forces at the height z [m] and ξ = x/B.
    pub(crate) fn at(&self, xi: f64, z: f64) -> Forces {
        let wall = self.wall;
        let holds = |e: &Element| z < e.base + e.length;
        let last = wall.elements.len() - 1;
        let e = wall.elements.iter().position(holds).unwrap_or(last);
        let element = &wall.elements[e];
        let t = ((z - element.base) / element.length).clamp(0.0, 1.0);
        let mut jet = [[0.0; 3]; 4];
        let across: Vec<[f64; 4]> = (0..wall.functions).map(|i| wall.across(i, xi)).collect();
        for (a, spline) in hermite(t, element.length).iter().enumerate() {
            for (i, functions) in across.iter().enumerate() {
                let u = self.unknowns[(2 * e + a) * wall.functions + i];
                for (row, x) in jet.iter_mut().zip(functions) {
                    for (value, s) in row.iter_mut().zip(spline) {
                        *value += u * x * s;
                    }
                }
            }
        }
        let (d, nu) = (element.rigidity, element.nu);
        Forces {
            m_x: d * (jet[2][0] + nu * jet[0][2]),
            m_z: d * (jet[0][2] + nu * jet[2][0]),
            m_xz: d * (1.0 - nu) * jet[1][1],
            w: jet[0][0],
            v_x: d * jet[3][0],
        }
    }

    /// Hoop force of a cylinder E s w/R [N/m]; zero otherwise.
    pub(crate) fn hoop(&self, z: f64) -> f64 {
        let Plan::Cylinder { radius, .. } = self.wall.plan else { return 0.0 };
        let holds = |e: &&Element| z < e.base + e.length;
        let element = self.wall.elements.iter().find(holds).or(self.wall.elements.last());
        element.map_or(0.0, |e| e.membrane * self.at(0.0, z).w / radius)
    }
}

/// Legendre's polynomial P_n and its derivatives up to the third.
fn legendre(n: usize, xi: f64) -> [f64; 4] {
    let (mut before, mut p) = ([0.0; 4], [1.0, 0.0, 0.0, 0.0]);
    for k in 1..=n {
        let k = k as f64;
        let next = std::array::from_fn(|m| {
            let lower = if m > 0 { m as f64 * p[m - 1] } else { 0.0 };
            ((2.0 * k - 1.0) * (xi * p[m] + lower) - (k - 1.0) * before[m]) / k
        });
        (before, p) = (p, next);
    }
    p
}

/// Points and weights over half the width; the highest product has the degree 4 · FUNCTIONS + 4 = 36, two panels of order 15 do.
fn across_points() -> impl Iterator<Item = (f64, f64)> {
    let panels = [0.0, 0.5];
    panels.into_iter().flat_map(|from| gauss().into_iter().map(move |(x, w)| (from + 0.5 * x, 0.5 * w)))
}

/// Points and weights of order 4 along an element: exact to degree 7.
fn along_points() -> [(f64, f64); 4] {
    let [near, far] = [0.339_981_043_584_856_3, 0.861_136_311_594_052_6].map(|x| 0.5 * x);
    let [inner, outer] = [0.652_145_154_862_546_1, 0.347_854_845_137_453_9].map(|w| 0.5 * w);
    [(0.5 - far, outer), (0.5 - near, inner), (0.5 + near, inner), (0.5 + far, outer)]
}

/// Solution of a small symmetric positive definite system by Gauss' elimination.
fn dense_solve(matrix: &[Vec<f64>], right: &[f64]) -> Vec<f64> {
    let n = right.len();
    let (mut a, mut x) = (matrix.to_vec(), right.to_vec());
    for i in 0..n {
        for row in i + 1..n {
            let factor = a[row][i] / a[i][i];
            for column in i..n {
                a[row][column] -= factor * a[i][column];
            }
            x[row] -= factor * x[i];
        }
    }
    for i in (0..n).rev() {
        let sum: f64 = (i + 1..n).map(|k| a[i][k] * x[k]).sum();
        x[i] = (x[i] - sum) / a[i][i];
    }
    x
}

#[cfg(test)]
mod tests;
