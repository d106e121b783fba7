//! Strains and forces of the four Gauss points side by side, in the registers of the processor.
//!
//! ```text
//! x_i = Σ N_a,i x_a ,  d_i = Σ N_a,i d_a                          i = 1, 2: along the axes of the point
//! p_1 = n_11 x_1 + m_11 d_1 + m_12 d_2 ,  p_2 = n_22 x_2 + m_22 d_2 + m_12 d_1
//! f_a = Σ (N_a,1 p_1 + N_a,2 p_2) A + N_12 (M_a,1 y_2 + M_a,2 y_1)          M, y: N and x at the centre, N_12 = Σ n_12 A
//! m_a = d_a × Σ (N_a,1 (m_11 x_1 + m_12 x_2) + N_a,2 (m_22 x_2 + m_12 x_1)) A
//! ```
//!
//! and the tied shears edge by edge. A register holds the four points where it has four places; on a processor without such registers the points
//! follow one another. Products and sums may be rounded once or twice, as the processor has it.

use nalgebra::Vector3;

use super::place::{Configuration, EDGES, Values, tying};
use super::turn::Turn;
use crate::element::shell::geometry::{Point, blend};

/// One number of each point.
pub(super) type Four = [f64; 4];

/// Geometry of the points, number by number.
#[derive(Clone)]
pub(super) struct Fours {
    d1: [Four; 4],
    d2: [Four; 4],
    x1: [Four; 3],
    x2: [Four; 3],
    tying: [[Four; 4]; 2],
    area: Four,
    /// Cosines and sines of the turns into the frame of the section.
    turn: Option<[Four; 2]>,
}

/// x_1, x_2, d_1, d_2 of the points.
pub(super) struct Slopes([[Four; 3]; 4]);

impl Fours {
    pub(super) fn new(x: &[Vector3<f64>; 4], points: &[Point; 4]) -> Fours {
        let of = |value: &dyn Fn(&Point) -> f64| std::array::from_fn(|g| value(&points[g]));
        let base =
            |slope: fn(&Point) -> &[f64; 4]| -> [Four; 3] { std::array::from_fn(|i| of(&|p| blend(slope(p), x)[i])) };
        Fours {
            d1: std::array::from_fn(|a| of(&|p| p.d1[a])),
            d2: std::array::from_fn(|a| of(&|p| p.d2[a])),
            x1: base(|p| &p.d1),
            x2: base(|p| &p.d2),
            tying: std::array::from_fn(|i| std::array::from_fn(|e| of(&|p| tying(p)[i][e]))),
            area: of(&|p| p.area),
            turn: None,
        }
    }

    /// The same with turns into the frame of the section.
    pub(super) fn set_turns(&mut self, turns: Option<&[Turn; 4]>) {
        self.turn = turns.map(|t| [t.map(|t| t.cosine()), t.map(|t| t.sine())]);
    }
}

/// Strains in the frame of the section, component by component, with the slopes of the configuration.
pub(super) struct Strains<'a> {
    pub(super) own: &'a Fours,
    pub(super) values: Values,
    pub(super) c: &'a Configuration,
}

/// Adds the forces of resultants, component by component.
pub(super) struct Forces<'a> {
    pub(super) own: &'a Fours,
    /// Where the membrane shear is taken for all points; none where each has its own.
    pub(super) centre: Option<&'a Point>,
    pub(super) c: &'a Configuration,
    pub(super) slopes: &'a Slopes,
    /// In the frame of the section.
    pub(super) resultants: &'a [Four; 8],
    pub(super) force: &'a mut [f64],
}

/// The arithmetic of the points of one register. Loops and small functions, which the compiler puts in place: a closure would be called, and by a
/// function that does not know these registers.
#[derive(Clone, Copy)]
struct Registers<S: pulp::Simd>(S);

impl<S: pulp::Simd> Registers<S> {
    /// Registers of the four points.
    const COUNT: usize = 4 / S::F64_LANES;

    #[inline(always)]
    fn load(self, from: &Four, k: usize) -> S::f64s {
        S::as_simd_f64s(from).0[k]
    }

    #[inline(always)]
    fn store(self, to: &mut Four, k: usize, value: S::f64s) {
        S::as_mut_simd_f64s(to).0[k] = value;
    }

    #[inline(always)]
    fn zeros<const N: usize>(self) -> [S::f64s; N] {
        [self.0.splat_f64s(0.0); N]
    }

    #[inline(always)]
    fn load_all<const N: usize>(self, from: &[Four; N], k: usize) -> [S::f64s; N] {
        let mut out = self.zeros();
        for i in 0..N {
            out[i] = self.load(&from[i], k);
        }
        out
    }

    /// Σ f_a v_a.
    #[inline(always)]
    fn blend(self, f: &[S::f64s; 4], v: &[Vector3<f64>; 4]) -> [S::f64s; 3] {
        let mut out = self.zeros();
        for i in 0..3 {
            out[i] = self.0.mul_f64s(f[0], self.0.splat_f64s(v[0][i]));
            for a in 1..4 {
                out[i] = self.0.mul_add_e_f64s(f[a], self.0.splat_f64s(v[a][i]), out[i]);
            }
        }
        out
    }

    /// a · b + c.
    #[inline(always)]
    fn dot(self, a: &[S::f64s; 3], b: &[S::f64s; 3], c: S::f64s) -> S::f64s {
        let mut sum = c;
        for i in 0..3 {
            sum = self.0.mul_add_e_f64s(a[i], b[i], sum);
        }
        sum
    }

    /// f a + g b + h c of vectors.
    #[inline(always)]
    fn sum(self, f: [S::f64s; 3], [a, b, c]: [&[S::f64s; 3]; 3]) -> [S::f64s; 3] {
        let mut out = self.zeros();
        for i in 0..3 {
            out[i] = self.0.mul_add_e_f64s(f[2], c[i], self.pair(f[0], a[i], f[1], b[i]));
        }
        out
    }

    /// a b + c d.
    #[inline(always)]
    fn pair(self, a: S::f64s, b: S::f64s, c: S::f64s, d: S::f64s) -> S::f64s {
        self.0.mul_add_e_f64s(c, d, self.0.mul_f64s(a, b))
    }

    /// g · u + u · u/2.
    #[inline(always)]
    fn stretch(self, g: &[S::f64s; 3], u: &[S::f64s; 3]) -> S::f64s {
        let square = self.dot(u, u, self.0.splat_f64s(0.0));
        self.dot(g, u, self.0.mul_f64s(self.0.splat_f64s(0.5), square))
    }

    /// u · d + g · w + `to`.
    #[inline(always)]
    fn bend(self, [u, d, g, w]: [&[S::f64s; 3]; 4], to: S::f64s) -> S::f64s {
        self.dot(u, d, self.dot(g, w, to))
    }

    /// Strains with an engineering shear in a frame that is turned by a cosine and a sine; resultants in the frame from which it was turned.
    #[inline(always)]
    fn turn(self, [a, b, g]: [S::f64s; 3], [c, s]: [S::f64s; 2], of_strain: bool) -> [S::f64s; 3] {
        let simd = self.0;
        let (cc, ss, cs) = (simd.mul_f64s(c, c), simd.mul_f64s(s, s), simd.mul_f64s(c, s));
        let (twice, spin) = (simd.add_f64s(cs, cs), simd.sub_f64s(cc, ss));
        let (first, second) = (self.pair(cc, a, ss, b), self.pair(ss, a, cc, b));
        if of_strain {
            let shift = simd.mul_f64s(cs, g);
            let shear = self.pair(twice, simd.sub_f64s(b, a), spin, g);
            [simd.add_f64s(first, shift), simd.sub_f64s(second, shift), shear]
        } else {
            let shift = simd.mul_f64s(twice, g);
            let shear = self.pair(cs, simd.sub_f64s(a, b), spin, g);
            [simd.sub_f64s(first, shift), simd.add_f64s(second, shift), shear]
        }
    }
}

impl pulp::WithSimd for Strains<'_> {
    type Output = ([Four; 8], Slopes);

    #[inline(always)]
    fn with_simd<S: pulp::Simd>(self, simd: S) -> Self::Output {
        let Strains { own, values, c } = self;
        let r = Registers(simd);
        let (mut out, mut slopes) = ([[0.0; 4]; 8], Slopes([[[0.0; 4]; 3]; 4]));
        let zero = simd.splat_f64s(0.0);
        for k in 0..Registers::<S>::COUNT {
            let (n1, n2) = (r.load_all(&own.d1, k), r.load_all(&own.d2, k));
            let (g1, g2) = (r.load_all(&own.x1, k), r.load_all(&own.x2, k));
            let (u1, u2) = (r.blend(&n1, &c.u), r.blend(&n2, &c.u));
            let (d1, d2) = (r.blend(&n1, &c.d), r.blend(&n2, &c.d));
            let (w1, w2) = (r.blend(&n1, &c.w), r.blend(&n2, &c.w));
            let shear = match values.shear {
                Some(shear) => simd.splat_f64s(shear),
                None => r.dot(&g1, &u2, r.dot(&g2, &u1, r.dot(&u1, &u2, zero))),
            };
            let mut plane = [r.stretch(&g1, &u1), r.stretch(&g2, &u2), shear];
            let twist = r.bend([&u1, &d2, &g1, &w2], r.bend([&u2, &d1, &g2, &w1], zero));
            let mut bent = [r.bend([&u1, &d1, &g1, &w1], zero), r.bend([&u2, &d2, &g2, &w2], zero), twist];
            let mut across = [zero; 2];
            for i in 0..2 {
                for e in 0..4 {
                    let edge = simd.splat_f64s(values.edges[e]);
                    across[i] = simd.mul_add_e_f64s(r.load(&own.tying[i][e], k), edge, across[i]);
                }
            }
            if let Some([cosine, sine]) = &own.turn {
                let [c, s] = [r.load(cosine, k), r.load(sine, k)];
                (plane, bent) = (r.turn(plane, [c, s], true), r.turn(bent, [c, s], true));
                let [a, b] = across;
                across = [r.pair(c, a, s, b), simd.sub_f64s(simd.mul_f64s(c, b), simd.mul_f64s(s, a))];
            }
            for i in 0..3 {
                r.store(&mut out[i], k, plane[i]);
                r.store(&mut out[3 + i], k, bent[i]);
                r.store(&mut slopes.0[0][i], k, simd.add_f64s(g1[i], u1[i]));
                r.store(&mut slopes.0[1][i], k, simd.add_f64s(g2[i], u2[i]));
                r.store(&mut slopes.0[2][i], k, d1[i]);
                r.store(&mut slopes.0[3][i], k, d2[i]);
            }
            r.store(&mut out[6], k, across[0]);
            r.store(&mut out[7], k, across[1]);
        }
        (out, slopes)
    }
}

impl pulp::WithSimd for Forces<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: pulp::Simd>(self, simd: S) {
        let Forces { own, centre, c, slopes, resultants, force } = self;
        let r = Registers(simd);
        let (mut f, mut pull) = ([[0.0; 3]; 4], [[0.0; 3]; 4]);
        let (mut twist, mut edges) = (0.0, [0.0; 4]);
        for k in 0..Registers::<S>::COUNT {
            let area = r.load(&own.area, k);
            let mut n = r.load_all(resultants, k);
            for i in 0..8 {
                n[i] = simd.mul_f64s(area, n[i]);
            }
            let (mut plane, mut bent, mut across) = ([n[0], n[1], n[2]], [n[3], n[4], n[5]], [n[6], n[7]]);
            if let Some([cosine, sine]) = &own.turn {
                let [c, s] = [r.load(cosine, k), r.load(sine, k)];
                (plane, bent) = (r.turn(plane, [c, s], false), r.turn(bent, [c, s], false));
                let [a, b] = across;
                across = [simd.sub_f64s(simd.mul_f64s(c, a), simd.mul_f64s(s, b)), r.pair(c, b, s, a)];
            }
            let ([n11, n22, n12], [m11, m22, m12]) = (plane, bent);
            let x1 = r.load_all(&slopes.0[0], k);
            let x2 = r.load_all(&slopes.0[1], k);
            let d1 = r.load_all(&slopes.0[2], k);
            let d2 = r.load_all(&slopes.0[3], k);
            let mut p1 = r.sum([n11, m11, m12], [&x1, &d1, &d2]);
            let mut p2 = r.sum([n22, m22, m12], [&x2, &d2, &d1]);
            if centre.is_none() {
                for i in 0..3 {
                    p1[i] = simd.mul_add_e_f64s(n12, x2[i], p1[i]);
                    p2[i] = simd.mul_add_e_f64s(n12, x1[i], p2[i]);
                }
            } else {
                twist += simd.reduce_sum_f64s(n12);
            }
            let (n1, n2) = (r.load_all(&own.d1, k), r.load_all(&own.d2, k));
            for i in 0..3 {
                let (s1, s2) = (r.pair(m11, x1[i], m12, x2[i]), r.pair(m22, x2[i], m12, x1[i]));
                for a in 0..4 {
                    f[a][i] += simd.reduce_sum_f64s(r.pair(n1[a], p1[i], n2[a], p2[i]));
                    pull[a][i] += simd.reduce_sum_f64s(r.pair(n1[a], s1, n2[a], s2));
                }
            }
            for e in 0..4 {
                let tied = r.pair(across[0], r.load(&own.tying[0][e], k), across[1], r.load(&own.tying[1][e], k));
                edges[e] += 0.25 * simd.reduce_sum_f64s(tied);
            }
        }
        let (mut f, mut pull) = (f.map(Vector3::from), pull.map(Vector3::from));
        if let Some(centre) = centre {
            let (y1, y2) = (blend(&centre.d1, &c.x), blend(&centre.d2, &c.x));
            for a in 0..4 {
                f[a] += y2 * (twist * centre.d1[a]) + y1 * (twist * centre.d2[a]);
            }
        }
        for (&(a, b), q) in EDGES.iter().zip(edges) {
            let (director, along) = ((c.d[a] + c.d[b]) * q, (c.x[b] - c.x[a]) * q);
            f[a] -= director;
            f[b] += director;
            pull[a] += along;
            pull[b] += along;
        }
        for a in 0..4 {
            let moment = c.d[a].cross(&pull[a]);
            for i in 0..3 {
                force[6 * a + i] += f[a][i];
                force[6 * a + 3 + i] += moment[i];
            }
        }
    }
}
