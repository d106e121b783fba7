//! Equilibrium of strips side by side under a wall whose foot need not stay plane.
//!
//! ```text
//! w(φ) = w₀ + ψ R cos φ + Σ U_n cos nφ          ∫ F(w) dφ + 2 π w_t = 0          ∫ F(w) cos nφ dφ + π K_n U_n = 0
//! ```
//!
//! K_n is that of [`crate::Warping`].

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::f64::consts::PI;
use std::rc::Rc;

use crate::element::GAUSS;
use crate::error::BaseError;
use crate::response::Response;
use crate::rocking::Turn;
use crate::warp::{WAVES, Wall};

/// Centre and waves.
pub(crate) const UNKNOWNS: usize = WAVES + 1;
/// Iterations of Newton's method at one rotation.
const ITERATIONS: usize = 60;
/// Residual over the weight at which the iteration ends, and the largest that is accepted where rounding stops it.
const SETTLED: f64 = 1e-11;
const ROUNDED: f64 = 1e-7;
/// The same of a foot that is followed in time, before its last step, and how fast it has to fall in an iteration: a tenth of it is left then.
const FOLLOWED: f64 = 3e-5;
const FASTEST: f64 = 0.1;
/// Smallest part of a Newton step: the work of strips and wall is convex, so that some part reduces the residual.
const SHORTEST: f64 = 1e-3;

/// Places side by side.
pub(crate) const LANES: usize = 4;
/// Pairs of orders 0 and 1, 2 and 3, … of cos nφ: those whose sums with the slopes make up their products, and those whose sums with the pulls are forces.
const SLOPES: usize = UNKNOWNS + 1;
const PULLS: usize = UNKNOWNS / 2 + 1;

/// A value for every even order and the odd one after it.
type Pairs<T, const N: usize> = [[T; 2]; N];

/// Order of the wave of an unknown: the centre, then n = 2, 3, …
fn order(unknown: usize) -> usize {
    if unknown == 0 { 0 } else { unknown + 1 }
}

/// Pull of strips around on the wall [N/m] and its slope [N/m²] by the uplift [m] and the cosine of the angle from the lifted side.
pub(crate) trait Strips {
    fn pull(&self, uplift: f64, cos: f64) -> [f64; 2];

    /// Pulls and slopes at the places of a block.
    #[inline(always)]
    fn pulls(&self, _block: usize, uplifts: [f64; LANES], cosines: [f64; LANES]) -> [[f64; LANES]; 2] {
        let mut pulls = [[0.0; LANES]; 2];
        for i in 0..LANES {
            [pulls[0][i], pulls[1][i]] = self.pull(uplifts[i], cosines[i]);
        }
        pulls
    }
}

impl<F: Fn(f64, f64) -> [f64; 2]> Strips for F {
    #[inline(always)]
    fn pull(&self, uplift: f64, cos: f64) -> [f64; 2] {
        self(uplift, cos)
    }
}

/// A foot that warps, for any law of its rim.
pub(crate) struct Foot<'a, S> {
    /// Radius R [m].
    pub(crate) radius: f64,
    /// Weight w_t of wall and roof [N/m].
    pub(crate) weight: f64,
    /// What the wall resists waves with.
    pub(crate) wall: Wall,
    /// Places around at which the law is asked.
    pub(crate) places: Rc<[Block]>,
    pub(crate) strips: &'a S,
}

/// Places φ on the lifted half of the rim, each with its mirror π − φ, where waves of an odd order change their sign.
#[derive(Clone, Debug)]
pub(crate) struct Block {
    /// Angles that they stand for [rad].
    width: [f64; LANES],
    /// cos nφ.
    forms: Pairs<[f64; LANES], SLOPES>,
}

impl Block {
    /// Uplifts [m] of the places and of their mirrors from those of each order.
    #[inline(always)]
    fn uplifts(&self, orders: &Pairs<f64, PULLS>) -> [[f64; LANES]; 2] {
        let mut parts = [[0.0; LANES]; 2];
        for (own, form) in orders.iter().zip(&self.forms) {
            for odd in 0..2 {
                for lane in 0..LANES {
                    parts[odd][lane] += own[odd] * form[odd][lane];
                }
            }
        }
        let [even, odd] = parts;
        [std::array::from_fn(|lane| even[lane] + odd[lane]), std::array::from_fn(|lane| even[lane] - odd[lane])]
    }

    /// Adds values at the places and at their mirrors, times cos nφ.
    #[inline(always)]
    fn add<const N: usize>(&self, sums: &mut Pairs<[f64; LANES], N>, [here, there]: [[f64; LANES]; 2]) {
        let mut parts = [[0.0; LANES]; 2];
        for lane in 0..LANES {
            parts[0][lane] = self.width[lane] * (here[lane] + there[lane]);
            parts[1][lane] = self.width[lane] * (here[lane] - there[lane]);
        }
        for (sums, form) in sums.iter_mut().zip(&self.forms) {
            for odd in 0..2 {
                for lane in 0..LANES {
                    sums[odd][lane] += parts[odd][lane] * form[odd][lane];
                }
            }
        }
    }
}

thread_local! {
    /// The places of each number of panels that was asked for.
    static PLACES: RefCell<BTreeMap<usize, Rc<[Block]>>> = const { RefCell::new(BTreeMap::new()) };
}

/// The Gauss points of panels from the lifted side to the toe, three in each; the number of panels is a multiple of twice [`LANES`].
pub(crate) fn places(panels: usize) -> Rc<[Block]> {
    let step = PI / panels as f64;
    let block = |block: usize| {
        let at: [(f64, f64); LANES] = std::array::from_fn(|i| {
            let place = LANES * block + i;
            let (x, weight) = GAUSS[place % GAUSS.len()];
            (((place / GAUSS.len()) as f64 + x) * step, weight * step)
        });
        Block {
            width: at.map(|(_, width)| width),
            forms: std::array::from_fn(|pair| {
                [0, 1].map(|odd| at.map(|(angle, _)| ((2 * pair + odd) as f64 * angle).cos()))
            }),
        }
    };
    let made = || (0..panels * GAUSS.len() / (2 * LANES)).map(block).collect();
    PLACES.with_borrow_mut(|kept| Rc::clone(kept.entry(panels).or_insert_with(made)))
}

/// Sums over half of the circumference, over R.
struct Sums {
    /// Forces on the unknowns [N/m].
    force: [f64; UNKNOWNS],
    /// Their derivatives [N/m²].
    slope: [[f64; UNKNOWNS]; UNKNOWNS],
    /// Their derivatives by ψ R [N/m²].
    turning: [f64; UNKNOWNS],
    /// ∫ F cos φ dφ [N/m], and its derivative by ψ R with the unknowns held [N/m²].
    moment: f64,
    turned: f64,
}

impl<S: Strips> Foot<'_, S> {
    /// The base at a rotation ψ [rad], starting from a turn close to it.
    ///
    /// Errors: the rim leaves the range of uplifts of the law [m]; no equilibrium.
    pub(crate) fn at(&self, rotation: f64, start: &Turn, (from, to): (f64, f64)) -> Result<Turn, BaseError> {
        let mut unknowns = [start.centre; UNKNOWNS];
        unknowns[1..].copy_from_slice(&start.waves);
        let sums = self.settle(rotation, &mut unknowns, 0)?;
        let mut waves = [0.0; WAVES];
        waves.copy_from_slice(&unknowns[1..]);
        let mut turn = Turn {
            rotation,
            moment: 2.0 * self.radius * self.radius * sums.moment,
            centre: unknowns[0],
            uplift: 0.0,
            toe_force: 0.0,
            pull: 0.0,
            waves,
        };
        let rim = turn.around(self.radius);
        let lowest = rim.iter().copied().fold(f64::INFINITY, f64::min);
        let highest = rim.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        // The toe first: where it is pressed too deep, the lifted side may be out of range as well.
        for wanted in [lowest, highest] {
            if wanted < from || wanted > to {
                return Err(BaseError::BeyondCurve { rotation, wanted, from, to });
            }
        }
        let (high, low) = (rim[0], rim[rim.len() - 1]);
        turn.uplift = high;
        turn.toe_force = -self.strips.pull(low, -1.0)[0];
        turn.pull = self.strips.pull(high, 1.0)[0];
        Ok(turn)
    }

    /// Force [N] and moment [N m] of the strips with the centre of the foot held at a height [m]; `waves` is updated to the equilibrium there.
    ///
    /// Errors: no equilibrium.
    pub(crate) fn held(&self, rotation: f64, centre: f64, waves: &mut [f64; WAVES]) -> Result<(f64, f64), BaseError> {
        let mut unknowns = [centre; UNKNOWNS];
        unknowns[1..].copy_from_slice(waves);
        let sums = self.settle(rotation, &mut unknowns, 1)?;
        waves.copy_from_slice(&unknowns[1..]);
        let force = sums.force[0] - PI * self.weight;
        Ok((2.0 * self.radius * force, 2.0 * self.radius * self.radius * sums.moment))
    }

    /// Moment at a rotation ψ [rad], of which a negative one lifts the other side, and its derivative at a state close to it, which becomes that there.
    ///
    /// Errors: no equilibrium.
    pub(crate) fn follow(&self, rotation: f64, standing: &mut Standing) -> Result<Response, BaseError> {
        let reach = rotation * self.radius;
        let scale = PI * self.weight.abs().max(f64::MIN_POSITIVE);
        let turned = reach - std::mem::replace(&mut standing.reach, reach);
        let Standing { unknowns, tangent, .. } = standing;
        let mut last = 0.0;
        if let Some(known) = tangent {
            unknowns.iter_mut().zip(known.follow).for_each(|(x, own)| *x -= own * turned);
            last = f64::INFINITY;
        }
        for _ in 0..ITERATIONS {
            let (force, moment) = self.forces(unknowns, reach);
            let off = force.iter().map(|f| f * f).sum::<f64>().sqrt() / scale;
            // A tangent that is too old makes the residual fall too slowly.
            let known = match tangent {
                Some(known) if off <= FASTEST * last || off <= FOLLOWED => known,
                _ => tangent.insert(Tangent::of(&self.sums(unknowns, reach))),
            };
            last = off;
            let step = known.inverse.solve(force);
            unknowns.iter_mut().zip(step).for_each(|(x, own)| *x -= own);
            if off <= FOLLOWED {
                // With what the last step changes, to first order.
                let change: f64 = known.turning.iter().zip(step).map(|(own, step)| own * step).sum();
                let square = 2.0 * self.radius * self.radius;
                return Ok(Response {
                    moment: square * (moment - change),
                    tangent: square * self.radius * known.moment,
                });
            }
        }
        *tangent = None;
        let sums = self.settle(rotation, unknowns, 0)?;
        let own = tangent.insert(Tangent::of(&sums)).moment;
        let square = 2.0 * self.radius * self.radius;
        Ok(Response { moment: square * sums.moment, tangent: square * self.radius * own })
    }

    /// Newton's method on all unknowns except the first `held`.
    fn settle(&self, rotation: f64, unknowns: &mut [f64; UNKNOWNS], held: usize) -> Result<Sums, BaseError> {
        let reach = rotation * self.radius;
        let scale = PI * self.weight.abs().max(f64::MIN_POSITIVE);
        let size = |sums: &Sums| sums.force[held..].iter().map(|f| f * f).sum::<f64>().sqrt() / scale;
        let mut found = self.sums(unknowns, reach);
        for _ in 0..ITERATIONS {
            let off = size(&found);
            if off <= SETTLED {
                return Ok(found);
            }
            let mut force = found.force;
            force[..held].fill(0.0);
            let step = Eliminated::of(&found.slope, held).solve(force);
            // The law stiffens and softens: the step is halved until the residual decreases.
            let mut share = 1.0;
            loop {
                let next: [f64; UNKNOWNS] = std::array::from_fn(|i| unknowns[i] - share * step[i]);
                let there = self.sums(&next, reach);
                if size(&there) < off {
                    (*unknowns, found) = (next, there);
                    break;
                }
                share *= 0.5;
                if share < SHORTEST {
                    if off <= ROUNDED {
                        return Ok(found);
                    }
                    (*unknowns, found) = (next, there);
                    break;
                }
            }
        }
        if size(&found) <= ROUNDED {
            return Ok(found);
        }
        let (name, allowed) = ("rotation of a foot that warps", "one with an equilibrium");
        Err(BaseError::Parameter { name, value: rotation, allowed })
    }

    /// Forces of weight and wall on the unknowns [N/m].
    fn given(&self, unknowns: &[f64; UNKNOWNS]) -> [f64; UNKNOWNS] {
        let mut force = [PI * self.weight; UNKNOWNS];
        for ((force, row), load) in force[1..].iter_mut().zip(&self.wall.stiffness).zip(self.wall.load) {
            let held: f64 = row.iter().zip(&unknowns[1..]).map(|(own, u)| own * u).sum();
            *force = 0.5 * PI * (held - load);
        }
        force
    }

    /// Forces on the unknowns, and the moment, as those of [`Foot::sums`].
    fn forces(&self, unknowns: &[f64; UNKNOWNS], reach: f64) -> ([f64; UNKNOWNS], f64) {
        let [pulls] = self.around::<1, PULLS>(unknowns, reach);
        (self.forced(unknowns, pulls.as_flattened()), pulls[0][1])
    }

    fn forced(&self, unknowns: &[f64; UNKNOWNS], pulls: &[f64]) -> [f64; UNKNOWNS] {
        let given = self.given(unknowns);
        std::array::from_fn(|i| given[i] + pulls[order(i)])
    }

    /// With cos nφ cos mφ = ½ [cos (n + m)φ + cos (n − m)φ].
    fn sums(&self, unknowns: &[f64; UNKNOWNS], reach: f64) -> Sums {
        let [pulls, slopes] = self.around::<2, SLOPES>(unknowns, reach);
        let slopes = slopes.as_flattened();
        let both = |n: usize, m: usize| 0.5 * (slopes[n + m] + slopes[n.abs_diff(m)]);
        let mut slope: [[f64; UNKNOWNS]; UNKNOWNS] =
            std::array::from_fn(|i| std::array::from_fn(|j| both(order(i), order(j))));
        for (to, row) in slope[1..].iter_mut().zip(&self.wall.stiffness) {
            to[1..].iter_mut().zip(row).for_each(|(to, own)| *to += 0.5 * PI * own);
        }
        Sums {
            force: self.forced(unknowns, pulls.as_flattened()),
            slope,
            turning: std::array::from_fn(|i| both(order(i), 1)),
            moment: pulls[0][1],
            turned: both(1, 1),
        }
    }

    /// ∫ F cos nφ dφ of the strips, and the same of their slopes where `KINDS` is 2, in the widest registers there are.
    fn around<const KINDS: usize, const N: usize>(
        &self,
        unknowns: &[f64; UNKNOWNS],
        reach: f64,
    ) -> [Pairs<f64, N>; KINDS] {
        let mut orders = [[0.0; 2]; PULLS];
        orders[0][1] = reach;
        for (i, own) in unknowns.iter().enumerate() {
            orders.as_flattened_mut()[order(i)] = *own;
        }
        pulp::Arch::new().dispatch(Around::<S, KINDS, N> { foot: self, orders })
    }
}

/// Sums around a foot whose uplift has these orders.
struct Around<'a, S, const KINDS: usize, const N: usize> {
    foot: &'a Foot<'a, S>,
    orders: Pairs<f64, PULLS>,
}

impl<S: Strips, const KINDS: usize, const N: usize> pulp::WithSimd for Around<'_, S, KINDS, N> {
    type Output = [Pairs<f64, N>; KINDS];

    #[inline(always)]
    fn with_simd<A: pulp::Simd>(self, _: A) -> [Pairs<f64, N>; KINDS] {
        let mut sums = [[[[0.0; LANES]; 2]; N]; KINDS];
        for (number, block) in self.foot.places.iter().enumerate() {
            let [here, there] = block.uplifts(&self.orders);
            let cos = block.forms[0][1];
            let here = self.foot.strips.pulls(2 * number, here, cos);
            let there = self.foot.strips.pulls(2 * number + 1, there, cos.map(|c| -c));
            for (kind, sums) in sums.iter_mut().enumerate() {
                block.add(sums, [here[kind], there[kind]]);
            }
        }
        let mut totals = [[[0.0; 2]; N]; KINDS];
        let lanes = sums.as_flattened().as_flattened();
        totals.as_flattened_mut().as_flattened_mut().iter_mut().zip(lanes).for_each(|(total, lanes)| {
            *total = (lanes[0] + lanes[1]) + (lanes[2] + lanes[3]);
        });
        totals
    }
}

/// A matrix of the unknowns after elimination without pivoting: it is positive definite.
#[derive(Clone, Debug)]
struct Eliminated([[f64; UNKNOWNS]; UNKNOWNS]);

impl Eliminated {
    /// All unknowns except the first `held`.
    fn of(slope: &[[f64; UNKNOWNS]; UNKNOWNS], held: usize) -> Eliminated {
        let mut a = *slope;
        for k in 0..held {
            a[k] = [0.0; UNKNOWNS];
            a.iter_mut().for_each(|row| row[k] = 0.0);
            a[k][k] = 1.0;
        }
        for k in held..UNKNOWNS {
            for i in k + 1..UNKNOWNS {
                let factor = a[i][k] / a[k][k];
                a[i][k] = factor;
                for j in k + 1..UNKNOWNS {
                    a[i][j] -= factor * a[k][j];
                }
            }
        }
        Eliminated(a)
    }

    fn solve(&self, mut b: [f64; UNKNOWNS]) -> [f64; UNKNOWNS] {
        let Eliminated(a) = self;
        for k in 0..UNKNOWNS {
            for i in k + 1..UNKNOWNS {
                b[i] -= a[i][k] * b[k];
            }
        }
        for k in (0..UNKNOWNS).rev() {
            let known: f64 = (k + 1..UNKNOWNS).map(|j| a[k][j] * b[j]).sum();
            b[k] = (b[k] - known) / a[k][k];
        }
        b
    }
}

/// A foot in equilibrium, and the tangent of a state close to it.
#[derive(Clone, Debug)]
pub(crate) struct Standing {
    /// Centre and waves [m].
    pub(crate) unknowns: [f64; UNKNOWNS],
    /// ψ R [m].
    reach: f64,
    tangent: Option<Tangent>,
}

#[derive(Clone, Debug)]
struct Tangent {
    inverse: Eliminated,
    /// Derivatives by ψ R of the forces [N/m²], and how the unknowns fall as it grows.
    turning: [f64; UNKNOWNS],
    follow: [f64; UNKNOWNS],
    /// Derivative by ψ R of ∫ F cos φ dφ [N/m²].
    moment: f64,
}

impl Tangent {
    fn of(sums: &Sums) -> Tangent {
        let inverse = Eliminated::of(&sums.slope, 0);
        let follow = inverse.solve(sums.turning);
        let given: f64 = sums.turning.iter().zip(follow).map(|(a, b)| a * b).sum();
        Tangent { inverse, turning: sums.turning, follow, moment: sums.turned - given }
    }
}

impl Standing {
    /// Unknowns and ψ R [m].
    pub(crate) fn place(&self) -> ([f64; UNKNOWNS], f64) {
        (self.unknowns, self.reach)
    }

    /// Straight on from a foot to this one, as far as both are apart; returns this one.
    pub(crate) fn go_on(&mut self, (unknowns, reach): ([f64; UNKNOWNS], f64)) -> ([f64; UNKNOWNS], f64) {
        let now = self.place();
        self.unknowns.iter_mut().zip(unknowns).for_each(|(own, before)| *own += *own - before);
        self.reach += self.reach - reach;
        now
    }

    /// Upright, with its centre at a height [m].
    pub(crate) fn upright(centre: f64) -> Standing {
        let mut unknowns = [0.0; UNKNOWNS];
        unknowns[0] = centre;
        Standing { unknowns, reach: 0.0, tangent: None }
    }
}
