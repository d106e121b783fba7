//! Demands of an engine under the record: what a wall, its base and its freeboard must bear at every instant.
//!
//! Every history is a combination of a few common ones (of the modes and the ground, or of itself):
//!
//! ```text
//! h(t) = Σ c_k s_k(t)        value(θ, t) = rest + even(t) + odd(t) cos θ
//! ```
//!
//! rest is the static state, even(t) the axisymmetric part of the motion, odd(t) that of the horizontal one. A second horizontal
//! component along y moves the tank as the first one does, turned by 90°: its part is that of the same terms over other histories,
//!
//! ```text
//! value(θ, t) = rest + even(t) + odd(t) cos θ + odd_y(t) sin θ        odd_y(t) = Σ c_k y_k(t)
//! ```
//!
//! Plain data: engines fill it, limit states read it, and it is not part of the results.

use std::ops::Range;

/// A history as a combination of common ones: (number of the state, coefficient).
pub type Terms = Vec<(usize, f64)>;

/// A quantity on the wall.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct OnWall {
    /// Value in the static state.
    pub rest: f64,
    /// Part that is the same around the circumference.
    pub even: Terms,
    /// Part that goes with cos θ.
    pub odd: Terms,
}

/// Stresses at a height of the wall; membrane stresses are positive in tension.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Place {
    /// Height above the base [m].
    pub z: f64,
    /// Number of its course, from 0.
    pub course: usize,
    /// Where θ = 0 of its histories is on the circumference [rad]; other than 0 only where they are known at two sides alone.
    pub turned: f64,
    /// Hoop membrane stress [Pa].
    pub hoop: OnWall,
    /// Axial membrane stress [Pa].
    pub axial: OnWall,
    /// Meridional bending stress at the outer face [Pa], where the engine gives it.
    pub bending: Option<OnWall>,
    /// Amplitude of the membrane shear stress, which goes with sin θ [Pa], where the engine gives it.
    pub shear: Option<Terms>,
    /// Pressure of the liquid on the wall [Pa], where the engine gives it; none above the liquid.
    pub pressure: Option<OnWall>,
}

/// Where the histories are known around the circumference.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Angles {
    /// Everywhere: they go with cos θ.
    #[default]
    All,
    /// At θ = 0 and θ = 180° of each place alone.
    Sides,
}

/// A largest value.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Peak {
    /// Value.
    pub value: f64,
    /// Its time [s].
    pub time: f64,
    /// Its angle [rad].
    pub theta: f64,
}

/// The base of an unanchored tank, of an engine that lets it lift and slide.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FreeBase {
    /// Whether the rim leaves the ground.
    pub lifts: bool,
    /// Whether runs that should agree do not: its demands are one draw of many.
    pub scatters: bool,
    /// Whether the pressure of the motion on the bottom exceeds that up to which strips of it hold.
    pub softened: bool,
    /// Whether its foot lifts and warps under a rim that is not round, with waves that follow at once.
    pub warps: bool,
    /// Largest plastic rotation of the joint of bottom plate and wall [rad]; none where the plate has no yield strength.
    pub joint: Option<Peak>,
    /// Largest force of an anchor [N], of one that yields as if it had stayed elastic; none without anchors.
    pub anchor: Option<Peak>,
    /// Whether the engine leaves the wall elastic at the joint.
    pub elastic_wall: bool,
    /// Anchors that break; the engine holds the tank in place along the ground all the same.
    pub broken: usize,
    /// Base shear of the same tank held in place [N], where it slides.
    pub held_shear: Option<Terms>,
}

/// Isolators under the tank.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Isolation {
    /// Largest displacement [m].
    pub displacement: Peak,
    /// Smallest force of the outermost bearing over that at rest; negative in tension.
    pub bearing_share: Option<Peak>,
    /// The demands with scaled properties, and their factor.
    pub bounds: Vec<(f64, Demands)>,
}

/// How a tank stands under a motion, for those who would scale its response.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Footing {
    /// Nothing of its base can move, or the engine holds it down under any motion.
    #[default]
    Fixed,
    /// Its base may lift, slide or pull at its anchors, and does not under this motion.
    Rests,
    /// It moves.
    Moves,
    /// It moves beyond what the engine models; the demands are those of the wall held down.
    Beyond {
        /// When it leaves the model [s], where that is known.
        time: Option<f64>,
        /// The reason, as a clause.
        reason: String,
    },
}

/// What the largest rise of the surface is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Surface {
    /// A wave of linear theory, which has a crest of its own ([`crate::large_wave`]).
    #[default]
    Linear,
    /// The crest of a nonlinear liquid.
    Nonlinear,
    /// The crest of a nonlinear liquid until the wave breaks: a lower bound.
    Stopped,
}

/// All demands of a run.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Demands {
    /// Times [s].
    pub times: Vec<f64>,
    /// The common histories at these times.
    pub states: Vec<Vec<f64>>,
    /// The same histories under the horizontal component along y; empty without one.
    pub transverse: Vec<Vec<f64>>,
    /// Where they are known.
    pub angles: Angles,
    /// Places on the wall by course and height; none for a wall without membrane stresses.
    pub places: Vec<Place>,
    /// Largest rise of the surface at the wall [m].
    pub wave: Option<Peak>,
    /// What that rise is.
    pub surface: Surface,
    /// Horizontal force on the foundation [N].
    pub base_shear: Option<Terms>,
    /// Moment of the motion below the base plate, the pressure on the bottom included [N·m].
    pub overturning_moment: Option<Terms>,
    /// Vertical acceleration of the ground, upwards [m/s²]; none without a vertical record.
    pub vertical: Option<Terms>,
    /// Whether the engine models the walls of a box as plates, not as cantilevers.
    pub plates: bool,
    /// The base, where it is free to lift and slide.
    pub base: Option<FreeBase>,
    /// The isolators, of an engine that moves the tank on them.
    pub isolation: Option<Isolation>,
    /// How the tank stands.
    pub footing: Footing,
    /// Largest relative error of a peak that lies between two of the times.
    pub sampling: f64,
}

impl Demands {
    /// A combination at all times.
    pub fn history(&self, terms: &Terms) -> Vec<f64> {
        self.part(0..self.times.len()).history(terms)
    }

    /// The same combination under the component along y; none without one.
    pub fn transverse(&self, terms: &Terms) -> Option<Vec<f64>> {
        self.part(0..self.times.len()).transverse(terms)
    }

    /// Some of the times: combinations there are those of [`Demands::history`], to the last bit.
    pub fn part(&self, instants: Range<usize>) -> Part<'_> {
        let along = States::Of(&self.states, instants.start);
        let transverse = States::Of(&self.transverse, instants.start);
        Part { count: instants.len(), along, transverse: (!self.transverse.is_empty()).then_some(transverse) }
    }
}

/// The common histories at some instants in a row.
pub struct Part<'a> {
    count: usize,
    along: States<'a>,
    transverse: Option<States<'a>>,
}

impl Part<'_> {
    /// A combination.
    pub fn history(&self, terms: &Terms) -> Vec<f64> {
        self.histories(&[terms]).swap_remove(0)
    }

    /// The same under the component along y; none without one.
    pub fn transverse(&self, terms: &Terms) -> Option<Vec<f64>> {
        Some(self.transverses(&[terms])?.swap_remove(0))
    }

    /// Several combinations: the states at some instants serve them all while they are in the nearest cache.
    pub fn histories(&self, terms: &[&Terms]) -> Vec<Vec<f64>> {
        combined(terms, &self.along, self.count)
    }

    /// The same under the component along y; none without one.
    pub fn transverses(&self, terms: &[&Terms]) -> Option<Vec<Vec<f64>>> {
        let states = self.transverse.as_ref()?;
        Some(combined(terms, states, self.count))
    }

    /// The same with all states copied next to one another: where many combinations follow, they are found in the nearest cache. Where they come from, at
    /// equal distances in memory, they would drive each other out of it.
    pub fn gathered(self) -> Part<'static> {
        Part {
            count: self.count,
            along: self.along.gathered(self.count),
            transverse: self.transverse.map(|states| states.gathered(self.count)),
        }
    }
}

/// Where the states are.
enum States<'a> {
    /// Histories, from an instant on.
    Of(&'a [Vec<f64>], usize),
    /// One after the other.
    Gathered(Gathered),
}

/// States one after the other.
struct Gathered {
    values: Vec<f64>,
    /// Number of the first value, which begins a line of the cache, so that no register is loaded from two.
    first: usize,
    /// Instants of each state, a whole number of [`WHOLE`].
    count: usize,
    /// From one state to the next: the same instants of all states are spread over the cache, where at multiples of its pages they would share a part
    /// of it.
    stride: usize,
}

impl Gathered {
    fn get(&self, state: usize) -> &[f64] {
        &self.values[self.first + state * self.stride..][..self.count]
    }
}

impl States<'_> {
    /// A state from the first instant on; it ends in rest.
    #[inline(always)]
    fn get(&self, state: usize) -> &[f64] {
        match self {
            States::Of(states, start) => states[state].get(*start..).unwrap_or_default(),
            States::Gathered(states) => states.get(state),
        }
    }

    fn gathered(&self, instants: usize) -> States<'static> {
        let states = match self {
            States::Of(states, _) => states.len(),
            States::Gathered(states) => states.values.len() / states.stride,
        };
        let count = instants.next_multiple_of(WHOLE);
        let stride = count + WHOLE / 2;
        let mut values = vec![0.0; states * stride + LINE];
        let first = values.as_ptr().align_offset(LINE * size_of::<f64>()).min(LINE);
        for state in 0..states {
            let from = self.get(state);
            let most = from.len().min(instants);
            values[first + state * stride..][..most].copy_from_slice(&from[..most]);
        }
        States::Gathered(Gathered { values, first, count, stride })
    }
}

/// Σ c_k s_k at some instants, summed in the order of the terms: on every machine the same bits.
fn combined(terms: &[&Terms], states: &States<'_>, count: usize) -> Vec<Vec<f64>> {
    let mut sums = vec![vec![0.0; count]; terms.len()];
    pulp::Arch::new().dispatch(Combine { terms, states, sums: &mut sums, count });
    sums
}

/// Registers of sums: as many as two fused operations a cycle need to hide a latency of four.
const REGISTERS: usize = 8;

/// Doubles in a line of the cache.
const LINE: usize = 8;

/// Instants to which gathered states are filled up: a whole number of [`REGISTERS`] of the widest machine.
const WHOLE: usize = 8 * REGISTERS;

/// Combinations of instants in a row, in the widest registers: each instant has its own lane, and every product is fused with its sum,
/// where the machine cannot by a function that rounds alike.
struct Combine<'a> {
    terms: &'a [&'a Terms],
    states: &'a States<'a>,
    sums: &'a mut [Vec<f64>],
    count: usize,
}

impl pulp::WithSimd for Combine<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: pulp::Simd>(self, simd: S) {
        let Combine { terms, states, sums, count } = self;
        let width = REGISTERS * S::F64_LANES;
        let shortest = match states {
            States::Gathered(states) => states.count,
            States::Of(..) => {
                let lengths = terms.iter().copied().flatten().map(|&(state, _)| states.get(state).len());
                lengths.min().unwrap_or_default()
            }
        };
        for first in (0..count).step_by(width) {
            for (terms, sums) in terms.iter().zip(&mut *sums) {
                let sums = &mut sums[first..count.min(first + width)];
                if first + width <= shortest {
                    let found = match states {
                        States::Gathered(states) => {
                            let values = &states.values[states.first + first..];
                            summed(simd, terms, |state| &values[state * states.stride..])
                        }
                        States::Of(histories, start) => summed(simd, terms, |state| &histories[state][start + first..]),
                    };
                    let (whole, rest) = S::as_mut_simd_f64s(sums);
                    let filled = whole.len();
                    whole.iter_mut().zip(found).for_each(|(sum, found)| *sum = found);
                    if !rest.is_empty() {
                        let found: &[f64] = pulp::bytemuck::cast_slice(&found);
                        rest.copy_from_slice(&found[filled * S::F64_LANES..][..rest.len()]);
                    }
                    continue;
                }
                for (k, sum) in (first..).zip(sums) {
                    let at = |state: usize| states.get(state).get(k).copied().unwrap_or(0.0);
                    *sum = terms.iter().fold(0.0, |sum, &(state, factor)| factor.mul_add(at(state), sum));
                }
            }
        }
    }
}

/// The sums of [`REGISTERS`] of instants that every state has.
///
/// * `from`: a state from the first of them on
#[inline(always)]
fn summed<'a, S: pulp::Simd>(simd: S, terms: &Terms, from: impl Fn(usize) -> &'a [f64]) -> [S::f64s; REGISTERS] {
    let mut sums = [simd.splat_f64s(0.0); REGISTERS];
    for &(state, factor) in terms {
        let (values, _) = S::as_simd_f64s(from(state));
        if let Some(values) = values.first_chunk::<REGISTERS>() {
            let factor = simd.splat_f64s(factor);
            for k in 0..REGISTERS {
                sums[k] = simd.mul_add_f64s(factor, values[k], sums[k]);
            }
        }
    }
    sums
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_history_is_the_combination_of_its_states() {
        let demands =
            Demands { times: vec![0.0, 1.0], states: vec![vec![1.0, 2.0], vec![-3.0, 5.0]], ..Demands::default() };
        assert_eq!(demands.history(&vec![(0, 2.0), (1, 10.0)]), [-28.0, 54.0]);
        assert_eq!(demands.history(&Terms::new()), [0.0, 0.0]);
    }

    /// Six states, three instants beyond the last full lanes: Σ k (i + k) = 15 i + 55 for k = 0 to 5.
    #[test]
    fn lanes_leave_nothing_out() {
        let count = 64 * WHOLE + 3;
        let terms: Terms = (0..6_u32).map(|k| (k as usize, f64::from(k))).collect();
        let demands = Demands {
            times: vec![0.0; count],
            states: (0..6).map(|k| (0..count).map(|i| (i + k) as f64).collect()).collect(),
            ..Demands::default()
        };
        let found = demands.history(&terms);
        assert!((0..count).all(|i| found[i] == (15 * i + 55) as f64));
        for start in [4080, count - 1, count] {
            assert_eq!(demands.part(start..count).history(&terms), found[start..]);
            assert_eq!(demands.part(start..count).gathered().history(&terms), found[start..]);
            let both = demands.part(start..count).gathered().histories(&[&Terms::new(), &terms]);
            assert_eq!(both, [vec![0.0; count - start], found[start..].to_vec()]);
        }
    }
}
