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
    /// Largest relative error of a peak that lies between two of the times.
    pub sampling: f64,
}

impl Demands {
    /// Those of a linear model under the same motion times a positive factor: the histories and the wave grow, the static state stays.
    #[must_use]
    pub fn scaled(&self, factor: f64) -> Demands {
        let histories = |all: &[Vec<f64>]| -> Vec<Vec<f64>> {
            let scaled = |history: &Vec<f64>| history.iter().map(|v| v * factor).collect();
            all.iter().map(scaled).collect()
        };
        let wave = self.wave.map(|peak| Peak {
            value: peak.value * factor,
            ..peak
        });
        Demands {
            times: self.times.clone(),
            states: histories(&self.states),
            transverse: histories(&self.transverse),
            angles: self.angles,
            places: self.places.clone(),
            wave,
            base_shear: self.base_shear.clone(),
            overturning_moment: self.overturning_moment.clone(),
            vertical: self.vertical.clone(),
            plates: self.plates,
            base: self.base.clone(),
            sampling: self.sampling,
        }
    }

    /// A combination at all times.
    pub fn history(&self, terms: &Terms) -> Vec<f64> {
        combined(terms, &self.states, self.times.len())
    }

    /// The same combination under the component along y; none without one.
    pub fn transverse(&self, terms: &Terms) -> Option<Vec<f64>> {
        (!self.transverse.is_empty()).then(|| combined(terms, &self.transverse, self.times.len()))
    }
}

/// Instants that are combined together: their sums stay in the nearest cache while the states pass by.
const TOGETHER: usize = 1024;

/// Σ c_k s_k at `count` times, summed in the order of the terms.
fn combined(terms: &Terms, states: &[Vec<f64>], count: usize) -> Vec<f64> {
    let mut out = vec![0.0; count];
    for (i, sums) in out.chunks_mut(TOGETHER).enumerate() {
        let part = |&(state, factor): &(usize, f64)| -> (&[f64], f64) {
            let state = &states[state];
            (&state[(i * TOGETHER).min(state.len())..], factor)
        };
        let mut fours = terms.chunks_exact(4);
        for four in &mut fours {
            let [a, b, c, d] = [&four[0], &four[1], &four[2], &four[3]].map(part);
            let rows = a.0.iter().zip(b.0).zip(c.0.iter().zip(d.0));
            for (y, ((s, t), (u, v))) in sums.iter_mut().zip(rows) {
                *y = *y + a.1 * s + b.1 * t + c.1 * u + d.1 * v;
            }
        }
        for term in fours.remainder() {
            let (state, factor) = part(term);
            for (y, s) in sums.iter_mut().zip(state) {
                *y += factor * s;
            }
        }
    }
    out
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

    /// Six states over two blocks: Σ k (i + k) = 15 i + 55 for k = 0 to 5.
    #[test]
    fn blocks_and_fours_leave_nothing_out() {
        let count = TOGETHER + 3;
        let terms: Terms = (0..6_u32).map(|k| (k as usize, f64::from(k))).collect();
        let demands = Demands {
            times: vec![0.0; count],
            states: (0..6).map(|k| (0..count).map(|i| (i + k) as f64).collect()).collect(),
            ..Demands::default()
        };
        let found = demands.history(&terms);
        assert!((0..count).all(|i| found[i] == (15 * i + 55) as f64));
    }
}
