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
use crate::rocking::{Turn, lifted};
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

/// A foot that warps, for any law of its rim.
pub(crate) struct Foot<'a> {
    /// Radius R [m].
    pub(crate) radius: f64,
    /// Weight w_t of wall and roof [N/m].
    pub(crate) weight: f64,
    /// What the wall resists waves with.
    pub(crate) wall: Wall,
    /// Places around at which the law is asked.
    pub(crate) places: Rc<[Place]>,
    /// Pull on the wall [N/m] and its slope [N/m²] as functions of the uplift [m] and of the cosine of the angle from the lifted side.
    pub(crate) hold: &'a dyn Fn(f64, f64) -> [f64; 2],
}

/// A place around, from the lifted side to the toe.
#[derive(Debug)]
pub(crate) struct Place {
    /// Cosine of its angle.
    cos: f64,
    /// Angle that it stands for [rad].
    width: f64,
    /// 1, cos 2φ, cos 3φ, …
    forms: [f64; UNKNOWNS],
}

thread_local! {
    /// The places of each number of panels that was asked for.
    static PLACES: RefCell<BTreeMap<usize, Rc<[Place]>>> = const { RefCell::new(BTreeMap::new()) };
}

/// The Gauss points of panels from the lifted side to the toe, three in each.
pub(crate) fn places(panels: usize) -> Rc<[Place]> {
    let width = PI / panels as f64;
    let place = |panel: usize, (x, weight): (f64, f64)| {
        let cos = ((panel as f64 + x) * width).cos();
        let mut forms = [1.0; UNKNOWNS];
        let (mut before, mut last) = (1.0, cos);
        for form in &mut forms[1..] {
            (before, last) = (last, 2.0 * cos * last - before);
            *form = last;
        }
        Place { cos, width: weight * width, forms }
    };
    let made = || (0..panels).flat_map(|panel| GAUSS.map(|point| place(panel, point))).collect();
    PLACES.with_borrow_mut(|kept| Rc::clone(kept.entry(panels).or_insert_with(made)))
}

/// Sums over half of the circumference, over R.
#[derive(Default)]
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

impl Foot<'_> {
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
            lifted_angle: 0.0,
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
        turn.toe_force = -(self.hold)(low, -1.0)[0];
        turn.pull = (self.hold)(high, 1.0)[0];
        turn.lifted_angle = lifted(&rim);
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
        let (mut forces, mut moment) = (self.given(unknowns), 0.0);
        for Place { cos, width, forms } in self.places.iter() {
            // Four sums side by side.
            let mut lanes = [reach * cos, 0.0, 0.0, 0.0];
            for (form, own) in forms.chunks_exact(4).zip(unknowns.chunks_exact(4)) {
                lanes.iter_mut().zip(form.iter().zip(own)).for_each(|(lane, (f, u))| *lane += f * u);
            }
            let uplift = (lanes[0] + lanes[1]) + (lanes[2] + lanes[3]);
            let force = width * (self.hold)(uplift, *cos)[0];
            moment += force * cos;
            forces.iter_mut().zip(forms).for_each(|(own, form)| *own += force * form);
        }
        (forces, moment)
    }

    fn sums(&self, unknowns: &[f64; UNKNOWNS], reach: f64) -> Sums {
        let mut sums = Sums { force: self.given(unknowns), ..Sums::default() };
        for (to, row) in sums.slope[1..].iter_mut().zip(&self.wall.stiffness) {
            to[1..].iter_mut().zip(row).for_each(|(to, own)| *to = 0.5 * PI * own);
        }
        for Place { cos, width, forms } in self.places.iter() {
            let uplift = reach * cos + forms.iter().zip(unknowns).map(|(f, u)| f * u).sum::<f64>();
            let [force, slope] = (self.hold)(uplift, *cos).map(|f| f * width);
            sums.moment += force * cos;
            sums.turned += slope * cos * cos;
            for i in 0..UNKNOWNS {
                sums.force[i] += force * forms[i];
                let own = slope * forms[i];
                sums.turning[i] += own * cos;
                for (to, form) in sums.slope[i][..=i].iter_mut().zip(forms) {
                    *to += own * form;
                }
            }
        }
        for i in 0..UNKNOWNS {
            for j in i + 1..UNKNOWNS {
                sums.slope[i][j] = sums.slope[j][i];
            }
        }
        sums
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
    /// Upright, with its centre at a height [m].
    pub(crate) fn upright(centre: f64) -> Standing {
        let mut unknowns = [0.0; UNKNOWNS];
        unknowns[0] = centre;
        Standing { unknowns, reach: 0.0, tangent: None }
    }
}
