//! Where and when a liquid that is computed as joined to its wall leaves it ([`SeparationCheck`]), and where one that may
//! leave it has done so ([`Openings`]).
//!
//! ```text
//! p = p₀(z) + p'(z, t) − ρ g u_z(z, t) < 0          gauge pressure of the particle that was at z
//! ```
//!
//! The pressure is that of the displaced particle: p₀ belongs to its place at rest, p' is the linear dynamic pressure, and one
//! that has sunk by −u_z has come under −ρ g u_z more. Without the last term the test fails at the surface: p' = ρ g η there, so
//! that p₀(z) + p' < 0 wherever the surface has fallen below z, where the wall is simply dry. (The classical way out is to
//! look only below the trough; see [`Place::below_trough`].)
//!
//! This is a check of the linear result, not a correction of it. Liquid separates from a tight wall near −98 kPa, not at 0,
//! unless air can enter; so a negative gauge pressure means something near the surface only.
//!
//! Source: theory sheet of this project; dissertation, section 8.4 (its contact elements).

use crate::analysis::checkpoint::{CheckpointError, Reader, Writer};

/// Liquid and places that are watched.
#[derive(Clone, Debug, PartialEq)]
pub struct SeparationCheck {
    /// ρ g [N/m³].
    weight: f64,
    /// Height of the surface at rest [m].
    surface: f64,
    heights: Vec<f64>,
    /// Per place: first time, lowest pressure, its time, instants below zero.
    seen: Vec<Seen>,
    /// Lowest elevation of the surface so far [m], ≤ 0.
    lowest: f64,
    instants: usize,
}

#[derive(Clone, Copy, Debug, PartialEq)]
struct Seen {
    first: Option<f64>,
    pressure: f64,
    time: f64,
    instants: usize,
}

/// A place where the pressure was negative.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// Number of the place, as given.
    pub number: usize,
    /// Its height [m].
    pub height: f64,
    /// First time with negative pressure [s].
    pub first: f64,
    /// Lowest pressure [Pa].
    pub pressure: f64,
    /// Its time [s].
    pub time: f64,
    /// Share of the instants seen with negative pressure.
    pub share: f64,
    /// Whether the place stayed under the surface all the time: z < H − |η|max.
    pub below_trough: bool,
}

/// Result of the check.
#[derive(Clone, Debug, PartialEq)]
pub struct Separation {
    /// Lowest level of the surface [m].
    pub trough: f64,
    /// Places with negative pressure, as given.
    pub places: Vec<Place>,
    /// Lowest pressure anywhere [Pa]; infinite before the first instant.
    pub lowest_pressure: f64,
}

impl Separation {
    /// Lowest of the places below the trough.
    pub fn lowest_below_trough(&self) -> Option<&Place> {
        let below = self.places.iter().filter(|p| p.below_trough);
        below.min_by(|a, b| a.height.total_cmp(&b.height))
    }
}

impl SeparationCheck {
    /// * `weight`: ρ g [N/m³]
    /// * `surface`: height of the surface at rest [m]
    /// * `heights`: places on the wetted wall [m]
    pub fn new(weight: f64, surface: f64, heights: Vec<f64>) -> SeparationCheck {
        let seen = Seen { first: None, pressure: f64::INFINITY, time: 0.0, instants: 0 };
        SeparationCheck { weight, surface, seen: vec![seen; heights.len()], heights, lowest: 0.0, instants: 0 }
    }

    /// Static gauge pressure at place `i` [Pa].
    pub fn hydrostatic(&self, i: usize) -> f64 {
        self.weight * (self.surface - self.heights[i])
    }

    /// Heights of the places [m], with the lowest pressure there so far [Pa].
    pub fn lowest_pressures(&self) -> impl Iterator<Item = (f64, f64)> + '_ {
        self.heights.iter().copied().zip(self.seen.iter().map(|s| s.pressure))
    }

    /// Looks at one instant.
    ///
    /// * `pressure(i)`: dynamic pressure p' at place i [Pa]
    /// * `rise(i)`: vertical displacement u_z of the particle there [m]; 0 for the plain test at the undeformed height
    /// * `elevation`: lowest elevation of the surface at the wall [m]
    pub fn see(&mut self, time: f64, pressure: impl Fn(usize) -> f64, rise: impl Fn(usize) -> f64, elevation: f64) {
        self.instants += 1;
        self.lowest = self.lowest.min(elevation);
        for i in 0..self.heights.len() {
            let total = self.hydrostatic(i) + pressure(i) - self.weight * rise(i);
            let seen = &mut self.seen[i];
            if total < seen.pressure {
                (seen.pressure, seen.time) = (total, time);
            }
            if total < 0.0 {
                seen.first.get_or_insert(time);
                seen.instants += 1;
            }
        }
    }

    /// Writes the results so far to a checkpoint.
    pub fn save(&self, to: &mut Writer) {
        to.number(self.lowest);
        to.count(self.instants);
        for s in &self.seen {
            to.numbers(&[s.first.unwrap_or(f64::NAN), s.pressure, s.time]);
            to.count(s.instants);
        }
    }

    /// Reads it back.
    ///
    /// Errors: a payload that is not its own.
    pub fn restore(&mut self, from: &mut Reader) -> Result<(), CheckpointError> {
        self.lowest = from.number()?;
        self.instants = from.count()?;
        for s in &mut self.seen {
            let mut own = [0.0; 3];
            from.numbers_into("a watched place", &mut own)?;
            s.first = Some(own[0]).filter(|t| !t.is_nan());
            [s.pressure, s.time] = [own[1], own[2]];
            s.instants = from.count()?;
        }
        Ok(())
    }

    /// Result so far.
    pub fn result(&self) -> Separation {
        let trough = self.surface + self.lowest;
        let place = |(number, seen): (usize, &Seen)| {
            let height = self.heights[number];
            seen.first.map(|first| Place {
                number,
                height,
                first,
                pressure: seen.pressure,
                time: seen.time,
                share: seen.instants as f64 / self.instants.max(1) as f64,
                below_trough: height < trough,
            })
        };
        Separation {
            trough,
            places: self.seen.iter().enumerate().filter_map(place).collect(),
            lowest_pressure: self.seen.iter().map(|s| s.pressure).fold(f64::INFINITY, f64::min),
        }
    }
}

/// Where and when a liquid that may leave its wall has done so.
#[derive(Clone, Debug, PartialEq)]
pub struct Openings {
    heights: Vec<f64>,
    /// Area of the wall that belongs to each place [m²]; of a strip per metre [m].
    areas: Vec<f64>,
    /// Area that was open at each instant [m²].
    open: Vec<f64>,
    seen: Vec<Gap>,
    instants: usize,
    /// Largest penetration of the penalty [m].
    penetration: f64,
}

#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Gap {
    first: Option<f64>,
    widest: f64,
    time: f64,
    instants: usize,
}

/// A place where the liquid has left the wall.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Opening {
    /// Number of the place, as given.
    pub number: usize,
    /// Its height [m].
    pub height: f64,
    /// First time [s].
    pub first: f64,
    /// Largest distance of liquid and wall [m].
    pub widest: f64,
    /// Its time [s].
    pub time: f64,
    /// Share of the instants seen in which it was open.
    pub share: f64,
}

impl Openings {
    /// * `heights`: places on the wetted wall [m]
    /// * `areas`: of the wall that belongs to each [m²]; of a strip per metre [m]
    pub fn new(heights: Vec<f64>, areas: Vec<f64>) -> Openings {
        Openings {
            seen: vec![Gap::default(); heights.len()],
            heights,
            areas,
            open: Vec::new(),
            instants: 0,
            penetration: 0.0,
        }
    }

    /// Looks at one instant: distance of liquid and wall at each place [m], 0 where they touch, and by how much the penalty
    /// gives way there [m].
    pub fn see(&mut self, time: f64, gaps: impl Iterator<Item = (f64, f64)>) {
        self.instants += 1;
        let mut open = 0.0;
        for ((seen, area), (gap, penetration)) in self.seen.iter_mut().zip(&self.areas).zip(gaps) {
            self.penetration = self.penetration.max(penetration);
            if gap > 0.0 {
                open += area;
                seen.first.get_or_insert(time);
                seen.instants += 1;
            }
            if gap > seen.widest {
                (seen.widest, seen.time) = (gap, time);
            }
        }
        self.open.push(open);
    }

    /// Area of the wall that the liquid has left at each instant seen [m²]; of a strip per metre [m].
    pub fn open(&self) -> &[f64] {
        &self.open
    }

    /// Largest distance at each place so far [m].
    pub fn widest(&self) -> impl Iterator<Item = f64> + '_ {
        self.seen.iter().map(|s| s.widest)
    }

    /// Largest penetration of the penalty so far [m].
    pub fn penetration(&self) -> f64 {
        self.penetration
    }

    /// Places that have opened, as given.
    pub fn places(&self) -> Vec<Opening> {
        let place = |(number, seen): (usize, &Gap)| {
            seen.first.map(|first| Opening {
                number,
                height: self.heights[number],
                first,
                widest: seen.widest,
                time: seen.time,
                share: seen.instants as f64 / self.instants.max(1) as f64,
            })
        };
        self.seen.iter().enumerate().filter_map(place).collect()
    }

    /// Writes the results so far to a checkpoint.
    pub fn save(&self, to: &mut Writer) {
        to.count(self.instants);
        to.number(self.penetration);
        to.numbers(&self.open);
        for s in &self.seen {
            to.numbers(&[s.first.unwrap_or(f64::NAN), s.widest, s.time]);
            to.count(s.instants);
        }
    }

    /// Reads it back.
    ///
    /// Errors: a payload that is not its own.
    pub fn restore(&mut self, from: &mut Reader) -> Result<(), CheckpointError> {
        self.instants = from.count()?;
        self.penetration = from.number()?;
        self.open = from.numbers("the open area")?;
        for s in &mut self.seen {
            let mut own = [0.0; 3];
            from.numbers_into("a place that opens", &mut own)?;
            s.first = Some(own[0]).filter(|t| !t.is_nan());
            [s.widest, s.time] = [own[1], own[2]];
            s.instants = from.count()?;
        }
        Ok(())
    }
}

/// Where and when the liquid first separates from its wall.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parting {
    /// Time [s].
    pub time: f64,
    /// Height [m].
    pub height: f64,
    /// Whether it has left the wall; otherwise the model keeps it there though the pressure of the displaced particle is below
    /// that of the air, at a height that stays under the surface.
    pub open: bool,
}

impl Parting {
    /// The earliest separation so far: where the liquid may leave the wall, of its openings; otherwise of the places below
    /// the trough where the check fails.
    pub fn first(check: &SeparationCheck, openings: Option<&Openings>) -> Option<Parting> {
        let all: Vec<Parting> = match openings {
            Some(openings) => {
                let of = |p: &Opening| Parting { time: p.first, height: p.height, open: true };
                openings.places().iter().map(of).collect()
            }
            None => {
                let of = |p: &Place| Parting { time: p.first, height: p.height, open: false };
                check.result().places.iter().filter(|p| p.below_trough).map(of).collect()
            }
        };
        all.into_iter().min_by(|a, b| a.time.total_cmp(&b.time))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A standing wave in deep liquid, p' = ρ g η e^{−ks}, u_z = η e^{−ks} at the depth s: the particle's pressure stays
    /// ρ g s > 0 at any amplitude, while the plain test reports every point that falls dry.
    #[test]
    fn a_wave_alone_does_not_part() {
        let (weight, k, amplitude) = (9810.0, 1.3, 0.4);
        let depths = [0.05, 0.2, 0.5, 1.0];
        let heights: Vec<f64> = depths.iter().map(|s| 2.0 - s).collect();
        let mut right = SeparationCheck::new(weight, 2.0, heights.clone());
        let mut plain = SeparationCheck::new(weight, 2.0, heights);
        for step in 0..100 {
            let eta = amplitude * (0.1 * f64::from(step)).sin();
            let decayed = |i: usize| eta * f64::exp(-k * depths[i]);
            right.see(f64::from(step), |i| weight * decayed(i), decayed, eta);
            plain.see(f64::from(step), |i| weight * decayed(i), |_| 0.0, eta);
        }
        let (right, plain) = (right.result(), plain.result());
        assert!(right.places.is_empty() && (right.lowest_pressure - weight * 0.05).abs() < 1e-9);
        assert!((right.trough - 1.6).abs() < 1e-3);
        // At 0.05 and 0.2 m: above the trough.
        assert_eq!(plain.places.len(), 2);
        assert!(plain.places.iter().all(|p| !p.below_trough) && plain.lowest_below_trough().is_none());
    }

    /// Two of three places open at once, one alone later: their areas, at every instant.
    #[test]
    fn the_open_area_is_that_of_the_open_places() {
        let mut openings = Openings::new(vec![0.5, 1.0, 1.5], vec![2.0, 3.0, 4.0]);
        for (time, gaps) in [(0.0, [0.0; 3]), (0.1, [0.0, 1e-3, 2e-3]), (0.2, [0.0, 0.0, 1e-3])] {
            openings.see(time, gaps.into_iter().map(|g| (g, 0.0)));
        }
        assert_eq!(openings.open(), [0.0, 7.0, 4.0]);
    }

    /// A rigid acceleration of the wall away from the liquid: p' = −ρ a s; separates at all depths beyond g.
    #[test]
    fn pulled_away() {
        let depths = [0.5, 1.0];
        let heights: Vec<f64> = depths.iter().map(|s| 2.0 - s).collect();
        let mut check = SeparationCheck::new(9810.0, 2.0, heights);
        for (time, a) in [(0.0, 5.0), (0.1, 9.0), (0.2, 11.0), (0.3, 12.0), (0.4, 2.0)] {
            check.see(time, |i| -1000.0 * a * depths[i], |_| 0.0, 0.0);
        }
        let found = check.result();
        assert_eq!(found.places.len(), 2);
        let lowest = found.lowest_below_trough().unwrap();
        assert!(lowest.height == 1.0 && lowest.first == 0.2 && lowest.time == 0.3);
        assert!((lowest.pressure - (9810.0 - 12000.0)).abs() < 1e-9 && (lowest.share - 0.4).abs() < 1e-12);
    }
}
