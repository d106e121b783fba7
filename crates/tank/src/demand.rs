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
    /// Largest plastic rotation of the joint of bottom plate and wall [rad]; none where the plate has no yield strength.
    pub joint: Option<Peak>,
    /// Largest force of an anchor [N], of one that yields as if it had stayed elastic; none without anchors.
    pub anchor: Option<Peak>,
    /// Base shear of the same tank held in place [N], where it slides.
    pub held_shear: Option<Terms>,
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
    /// How the tank stands.
    pub footing: Footing,
    /// Largest relative error of a peak that lies between two of the times.
    pub sampling: f64,
}

impl Demands {
    /// A combination at all times.
    pub fn history(&self, terms: &Terms) -> Vec<f64> {
        self.part(terms, 0..self.times.len())
    }

    /// The same combination under the component along y; none without one.
    pub fn transverse(&self, terms: &Terms) -> Option<Vec<f64>> {
        self.transverse_part(terms, 0..self.times.len())
    }

    /// A combination at some of the times: the values of [`Demands::history`] there, to the last bit.
    pub fn part(&self, terms: &Terms, instants: Range<usize>) -> Vec<f64> {
        combined(terms, &self.states, instants)
    }

    /// The same under the component along y; none without one.
    pub fn transverse_part(&self, terms: &Terms, instants: Range<usize>) -> Option<Vec<f64>> {
        (!self.transverse.is_empty()).then(|| combined(terms, &self.transverse, instants))
    }
}

/// Σ c_k s_k at some instants, summed in the order of the terms: on every machine the same bits. A state ends in rest.
fn combined(terms: &Terms, states: &[Vec<f64>], instants: Range<usize>) -> Vec<f64> {
    let mut sums = vec![0.0; instants.len()];
    pulp::Arch::new().dispatch(Combine {
        terms,
        states,
        start: instants.start,
        sums: &mut sums,
    });
    sums
}

/// Instants that are summed together, in the registers of the machine.
const LANES: usize = 16;

/// The combination of instants in a row, compiled for the widest registers: each instant has its own lane, and no product is fused with a
/// sum.
struct Combine<'a> {
    terms: &'a Terms,
    states: &'a [Vec<f64>],
    /// First instant.
    start: usize,
    sums: &'a mut [f64],
}

impl pulp::WithSimd for Combine<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: pulp::Simd>(self, _: S) {
        let Combine {
            terms,
            states,
            mut start,
            sums,
        } = self;
        let shortest = terms.iter().map(|&(state, _)| states[state].len()).min();
        for sums in sums.chunks_mut(LANES) {
            let whole = shortest.is_some_and(|length| start + LANES <= length);
            if let (true, Some(sums)) = (whole, sums.first_chunk_mut::<LANES>()) {
                *sums = whole_lanes(terms, states, start);
            } else {
                for (k, sum) in sums.iter_mut().enumerate() {
                    let at = |state: usize| states[state].get(start + k).copied().unwrap_or(0.0);
                    *sum = terms.iter().fold(0.0, |sum, &(state, factor)| sum + factor * at(state));
                }
            }
            start += LANES;
        }
    }
}

/// The sums of [`LANES`] instants that every state has.
#[inline(always)]
fn whole_lanes(terms: &Terms, states: &[Vec<f64>], start: usize) -> [f64; LANES] {
    let mut lanes = [0.0; LANES];
    for &(state, factor) in terms {
        let values: &[f64] = &states[state][start..start + LANES];
        for k in 0..LANES {
            lanes[k] += factor * values[k];
        }
    }
    lanes
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_history_is_the_combination_of_its_states() {
        let demands = Demands {
            times: vec![0.0, 1.0],
            states: vec![vec![1.0, 2.0], vec![-3.0, 5.0]],
            ..Demands::default()
        };
        assert_eq!(demands.history(&vec![(0, 2.0), (1, 10.0)]), [-28.0, 54.0]);
        assert_eq!(demands.history(&Terms::new()), [0.0, 0.0]);
    }

    /// Six states, three instants beyond the last full lanes: Σ k (i + k) = 15 i + 55 for k = 0 to 5.
    #[test]
    fn lanes_leave_nothing_out() {
        let count = 64 * LANES + 3;
        let terms: Terms = (0..6_u32).map(|k| (k as usize, f64::from(k))).collect();
        let demands = Demands {
            times: vec![0.0; count],
            states: (0..6).map(|k| (0..count).map(|i| (i + k) as f64).collect()).collect(),
            ..Demands::default()
        };
        let found = demands.history(&terms);
        assert!((0..count).all(|i| found[i] == (15 * i + 55) as f64));
        assert_eq!(demands.part(&terms, 1020..count), found[1020..]);
    }
}
