//! Memory and time of a run, estimated before anything is built, and their limits.
//!
//! Every engine has a function from case and options to an [`Estimate`]: bytes of its matrices, factors and histories,
//! operations of its solves and steps. [`Estimate::hold`] is the one place that compares them with the limits and reports what
//! fits instead. Counts are numbers of type `f64`, which do not overflow on absurd input.
//!
//! | limit | value |
//! |---|---|
//! | memory | [`MEMORY_LIMIT_MIB`], or `--memory-limit` |
//! | samples of a response | [`MOST_SAMPLES`] |
//! | steps of a time integration | [`MOST_STEPS`] |
//! | free vibration after the record | [`LONGEST_TAIL`] |
//! | computing time | [`LONGEST_RUN`] |

use tank::Case;
use tank::options::AfterRecord;
pub use tank::options::MEMORY_LIMIT_MIB;
use tank::{Course, Shape};

use super::FeError;

/// Most samples of a response, free vibration included: twice the longest record that is read (5.5 hours at 100 Hz).
pub const MOST_SAMPLES: f64 = 4e6;
/// Most instants of the kept histories; of a longer run every second, third … sub-step is kept.
pub(crate) const MOST_INSTANTS: usize = 100_000;
/// Most steps of a time integration: the longest record with forty steps a sample takes 8e7.
pub const MOST_STEPS: f64 = 1e9;
/// Longest free vibration after the record, two periods of sloshing [s]. A lake of 1 km sloshes in less than an hour.
pub const LONGEST_TAIL: f64 = 86_400.0;
/// Longest computing time that a run may be estimated to take [s]: a month.
pub const LONGEST_RUN: f64 = 30.0 * 86_400.0;
/// A run estimated to take longer than this is announced [s].
pub const WORTH_SAYING: f64 = 2.0;

/// Memory of the program itself, its input and its report [bytes].
pub const PROGRAM: f64 = 16.0 * MIB;
/// Bytes that the checks keep of an instant at a place of the wall: extremes of its fields by blocks of instants. Measured from 6 000 to 87 000 instants at
/// 74 to 347 places: 9.0 to 12.7.
const CHECKED: f64 = 10.5;
/// Bytes of a modal state of an instant: the number itself, and its part of the copies while states are gathered.
const STATE: f64 = 10.0;
/// Its name among the parts of an estimate.
pub const THE_PROGRAM: &str = "the program";
/// Bytes of a MiB.
pub const MIB: f64 = (1 << 20) as f64;
/// Bytes of a number.
pub const NUMBER: f64 = 8.0;
/// Operations a second of dense eigenvalue problems and products on one core of the reference machine [1/s].
pub const DENSE_RATE: f64 = 1e10;
/// Operations a second of sparse factors there, multiplications and additions [1/s].
pub const FACTOR_RATE: f64 = 2.5e10;
/// Bytes a second of solves and of products of long vectors there [1/s].
pub const SWEEP_RATE: f64 = 1.4e10;
/// Bytes a second of products with a sparse matrix there [1/s].
pub const PRODUCT_RATE: f64 = 5e9;

/// Memory and time of a run.
#[derive(Clone, Debug, PartialEq)]
pub struct Estimate {
    /// Which run, as `three-dimensional run`.
    pub run: &'static str,
    /// Its size in words: elements, unknowns, steps.
    pub size: String,
    /// Bytes by purpose.
    pub parts: Vec<(&'static str, f64)>,
    /// Samples of the response; 0 without one.
    pub samples: f64,
    /// Steps of the time integration; 0 without one.
    pub steps: f64,
    /// Processor time [s] on one core of the reference machine; of a wall that may yield or crack, while it stays elastic.
    pub seconds: f64,
    /// Processor time [s] there if the wall yields or cracks during the whole record; `None` of linear runs and where it makes no
    /// difference.
    pub inelastic: Option<f64>,
    /// Ways to make the run smaller.
    pub lever: Lever,
}

/// Ways to make a run smaller.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Lever {
    /// Smaller runs in descending size: the option, and bytes and seconds of that run.
    pub smaller: Vec<(String, f64, f64)>,
    /// Advice if none of these fits.
    pub other: String,
}

impl Estimate {
    /// Memory [bytes].
    pub fn bytes(&self) -> f64 {
        self.parts.iter().map(|(_, bytes)| bytes).sum()
    }

    /// Memory [MiB].
    pub fn mib(&self) -> u64 {
        mib(self.bytes())
    }

    /// The longer of both times [s].
    pub fn longest(&self) -> f64 {
        self.inelastic.unwrap_or(self.seconds)
    }

    /// Holds the run against the limits; `limit` is the memory allowed [MiB].
    ///
    /// Errors: more memory, samples, steps or time than allowed, with a size that fits.
    pub fn hold(&self, limit: u64) -> Result<(), FeError> {
        check_steps(self.run, self.samples, self.steps)?;
        if self.bytes() > limit as f64 * MIB {
            return Err(FeError::Memory {
                run: format!("{} ({}; {})", self.run, self.size, self.largest_part()),
                needed_mib: self.mib(),
                allowed_mib: limit,
                help: self.help(limit, "raise --memory-limit"),
            });
        }
        if self.seconds > LONGEST_RUN {
            return Err(FeError::TooLong {
                what: format!("the {} ({}) takes about {}", self.run, self.size, span(self.seconds)),
                allowed: format!("at most {}", span(LONGEST_RUN)),
                help: self.help(limit, "shorten the record"),
            });
        }
        Ok(())
    }

    /// The largest part, such as `factors 900 MiB`.
    fn largest_part(&self) -> String {
        let largest = self.parts.iter().max_by(|a, b| a.1.total_cmp(&b.1));
        largest.map_or(String::new(), |(what, bytes)| format!("{what} {} MiB", mib(*bytes)))
    }

    /// A size that fits, or else advice.
    fn help(&self, limit: u64, other: &str) -> String {
        let fits = |bytes: f64, seconds: f64| bytes <= limit as f64 * MIB && seconds <= LONGEST_RUN;
        match self.lever.smaller.iter().find(|(_, bytes, seconds)| fits(*bytes, *seconds)) {
            Some((give, bytes, _)) => format!("{give} (about {} MiB), or {other}", mib(*bytes)),
            None if self.lever.other.is_empty() => other.to_owned(),
            None => format!("{}, or {other}", self.lever.other),
        }
    }

    /// `three-dimensional run: 12x16x20 elements, 5074 unknowns, about 37 MiB, about 1 s`.
    /// Of a wall that may yield: `…, about 1 min if the wall stays elastic, up to about 4 min if it yields or cracks`.
    pub fn sentence(&self) -> String {
        let time = match self.inelastic {
            Some(inelastic) => format!(
                "about {} if the wall stays elastic, up to about {} if it yields or cracks",
                span(self.seconds),
                span(inelastic)
            ),
            None => format!("about {}", span(self.seconds)),
        };
        format!("{}: {}, about {} MiB, {time}", self.run, self.size, self.mib())
    }
}

/// Holds samples and steps of a run against [`MOST_SAMPLES`] and [`MOST_STEPS`].
///
/// Errors: more than that, or no number.
pub fn check_steps(run: &str, samples: f64, steps: f64) -> Result<(), FeError> {
    for (what, found, most) in [("samples of the response", samples, MOST_SAMPLES), ("time steps", steps, MOST_STEPS)] {
        if found > most || found.is_nan() {
            return Err(FeError::TooLong {
                what: format!("the {run} takes {} {what}", count(found)),
                allowed: format!("at most {}", count(most)),
                help: format!(
                    "resample the record {} times as coarse or more (`record.resample` in the tank file), or shorten it",
                    count((found / most).ceil())
                ),
            });
        }
    }
    Ok(())
}

fn mib(bytes: f64) -> u64 {
    (bytes / MIB).ceil() as u64
}

/// A count as people read it: whole up to a million, then with its power of ten.
fn count(n: f64) -> String {
    match n {
        n if n < 1e7 => format!("{n:.0}"),
        n => format!("{n:.1e}"),
    }
}

/// A time as a person waits it.
pub fn span(seconds: f64) -> String {
    match seconds {
        s if s < 90.0 => format!("{:.0} s", s.max(1.0)),
        s if s < 5400.0 => format!("{:.0} min", s / 60.0),
        s if s < 129_600.0 => format!("{:.1} h", s / 3600.0),
        s if s < 4e7 => format!("{:.0} days", s / 86_400.0),
        s => format!("{} years", count(s / 31_557_600.0)),
    }
}

/// Times of a response.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Response {
    /// Time between two samples [s].
    pub dt: f64,
    /// Duration of the ground motion [s].
    pub duration: f64,
    /// Free vibration after it [s].
    pub tail: f64,
}

impl Response {
    /// The response of a case, with free vibration after the record; `None` without a record.
    ///
    /// Errors: a sloshing period so long that the free vibration passes [`LONGEST_TAIL`].
    pub fn of(case: &Case, after: AfterRecord) -> Result<Option<Response>, FeError> {
        let Some(motion) = &case.ground_motion else { return Ok(None) };
        let period = sloshing_period(case);
        let tail = after.duration(period);
        // A period that is not a number counts as too long.
        if tail.is_nan() || tail > LONGEST_TAIL {
            return Err(FeError::TooLong {
                what: format!(
                    "the first sloshing period is {period:.3e} s, the free vibration after the record {tail:.3e} s"
                ),
                allowed: format!("at most {LONGEST_TAIL:.0} s of free vibration, a day"),
                help: "check `gravity`, the width of the tank and `liquid.fill_height`".into(),
            });
        }
        Ok(Some(Response { dt: motion.horizontal.dt, duration: motion.duration(), tail }))
    }

    /// Number of samples.
    pub fn samples(&self) -> f64 {
        ((self.duration + self.tail) / self.dt).ceil() + 1.0
    }
}

/// Memory of the limit states of a run: modal states at the instants that are searched, and what the checks keep of each place [bytes].
///
/// * `steps`: of the time integration
/// * `states`: that the observables combine
/// * `places`: on the wall
pub fn limit_states(case: &Case, steps: f64, states: f64, places: f64) -> [(&'static str, f64); 2] {
    let most = MOST_INSTANTS as f64;
    let instants = steps / (steps / most).ceil().max(1.0);
    let twice = case.ground_motion.as_ref().is_some_and(|motion| motion.transverse.is_some());
    let searched = matches!(case.tank.shape, Shape::Cylinder { .. }) && case.tank.is_metal();
    // Isolators are checked with the bounds of their properties, too.
    let runs = if case.tank.isolators.is_some() { 3.0 } else { 1.0 };
    let both = if twice { 2.0 } else { 1.0 };
    let places = if searched { places } else { 0.0 };
    [("limit states", runs * both * STATE * instants * states), ("checks", runs * CHECKED * instants * places)]
}

/// The runs of several engines under one motion, which are kept together.
pub fn together(runs: &[Estimate]) -> Option<Estimate> {
    let (first, others) = runs.split_first()?;
    let mut all = first.clone();
    for other in others {
        let own = other.parts.iter().filter(|(what, _)| *what != THE_PROGRAM);
        all.parts.extend(own.copied());
        all.size = format!("{}; {}: {}", all.size, other.run, other.size);
        all.seconds += other.seconds;
        all.inelastic = match (all.inelastic, other.inelastic) {
            (None, None) => None,
            (a, b) => Some(a.unwrap_or(all.seconds) + b.unwrap_or(0.0)),
        };
        all.lever = other.lever.clone();
    }
    Some(all)
}

/// Period of the first sloshing mode of a rigid tank [s].
///
/// ```text
/// ω² = g k tanh k H      k = 1.8412/R (cylinder), π/L (rectangle of length L)
/// ```
///
/// Source: linear potential theory, Lamb 1932, §§191 and 257.
pub fn sloshing_period(case: &Case) -> f64 {
    let k = match case.tank.shape {
        Shape::Cylinder { radius } => 1.841_183_8 / radius,
        Shape::Rectangle { length, .. } => std::f64::consts::PI / length,
    };
    std::f64::consts::TAU / (case.gravity * k * (k * case.liquid.fill_height).tanh()).sqrt()
}

/// ω of the first mode of wall and liquid, roughly [rad/s].
///
/// ```text
/// cylinder   ω = 2π/(6.5 H) √(E t/(ρ R))                      (Malhotra, Wenk & Wieland 2000: 6.1 … 9.3)
/// strip      ω = 3.516/h² √(E t³/12 / (ρ_w t + ρ H/2))        cantilever with half of the liquid's depth as added mass
/// ```
pub fn first_wall_frequency(case: &Case) -> f64 {
    let tank = &case.tank;
    let (height, depth) = (tank.wall_height(), case.liquid.fill_height);
    let mean = |of: fn(&Course) -> f64| tank.courses.iter().map(|c| of(c) * c.height).sum::<f64>() / height;
    let density = case.liquid.density;
    match tank.shape {
        Shape::Cylinder { radius } => {
            let stiffness = mean(|c| c.material.youngs_modulus * c.thickness);
            std::f64::consts::TAU / (6.5 * depth) * (stiffness / (density * radius)).sqrt()
        }
        Shape::Rectangle { .. } => {
            let bending = mean(|c| c.material.youngs_modulus * c.thickness.powi(3) / 12.0);
            let mass = mean(|c| c.material.density * c.thickness) + 0.5 * density * depth;
            3.516 / (height * height) * (bending / mass).sqrt()
        }
    }
}

/// First circular frequency [rad/s] of a plane wall `side` [m] long, clamped at its base and both sides, with half of the liquid's depth
/// as added mass: cantilever and clamped beam side by side, a lower bound for constant thickness (Dunkerley).
///
/// ```text
/// ω² = (3.516/h²)² + (22.37/a²)², times E t³/12 / (ρ_w t + ρ H/2)
/// ```
pub fn first_plate_frequency(case: &Case, side: f64) -> f64 {
    let height = case.tank.wall_height();
    let cantilever = first_wall_frequency(case);
    cantilever * (1.0 + (22.37 / 3.516 * (height / side).powi(2)).powi(2)).sqrt()
}

/// Entries of a factor and operations of its factorisation.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Fill {
    /// Entries of L.
    pub entries: f64,
    /// Additions and multiplications.
    pub flops: f64,
}

impl Fill {
    /// Fill of a dense matrix of order `n`.
    pub fn dense(n: f64) -> Fill {
        Fill::front(n, 0.0)
    }

    /// Fill of a front: `own` unknowns eliminated, `rest` that stay.
    fn front(own: f64, rest: f64) -> Fill {
        Fill {
            entries: 0.5 * own * own + own * rest,
            flops: own * own * own / 3.0 + own * own * rest + own * rest * rest,
        }
    }

    /// Fill of a block of nodes in a regular grid with `dofs` unknowns a node, ordered by nested dissection: the smallest plane of
    /// nodes that halves the block comes last, its front holds the planes of nodes around the block.
    ///
    /// * `nodes` along the three axes; one of them 1 for a surface
    /// * `closed`: whether the first axis is a circle
    pub fn grid(nodes: [f64; 3], dofs: f64, closed: bool) -> Fill {
        let nodes = nodes.map(f64::ceil);
        if closed && nodes[0] > 3.0 {
            // Two planes open the circle; the halves have neighbours on both sides.
            let plane = nodes[1] * nodes[2];
            let half = [0.5 * (nodes[0] - 2.0), nodes[1], nodes[2]];
            return Fill::front(2.0 * plane * dofs, 0.0).with(2.0, Fill::block(half, dofs, [2.0, 0.0, 0.0]));
        }
        Fill::block(nodes, dofs, [0.0; 3])
    }

    /// Fill of a block with so many neighbouring planes across each axis.
    fn block(nodes: [f64; 3], dofs: f64, neighbours: [f64; 3]) -> Fill {
        let all: f64 = nodes.iter().product();
        let area = |axis: usize| all / nodes[axis];
        let around: f64 = (0..3).map(|axis| neighbours[axis] * area(axis)).sum();
        let longest = (0..3).fold(0, |a, b| if nodes[b] > nodes[a] { b } else { a });
        if all <= 6.0 || nodes[longest] < 3.0 {
            return Fill::front(all * dofs, around * dofs);
        }
        let mut half = nodes;
        half[longest] = 0.5 * (nodes[longest] - 1.0);
        // Mean of both halves: the cut borders on each, and its former neighbours remain in one of them.
        let mut next = neighbours;
        next[longest] = 1.0 + 0.5 * neighbours[longest];
        Fill::front(area(longest) * dofs, around * dofs).with(2.0, Fill::block(half, dofs, next))
    }

    /// With `times` another.
    pub fn with(self, times: f64, other: Fill) -> Fill {
        Fill { entries: self.entries + times * other.entries, flops: self.flops + times * other.flops }
    }
}

/// Refinements below `from` that are offered where a mesh is too fine, by falling size.
pub fn coarser(from: f64) -> impl Iterator<Item = f64> {
    [12.0, 8.0, 6.0, 4.0, 3.0, 2.0, 1.5, 1.0, 0.75, 0.5, 0.25].into_iter().filter(move |refine| *refine < from)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn estimate(mib: f64) -> Estimate {
        Estimate {
            run: "harmonic run",
            size: "400 unknowns".into(),
            parts: vec![("matrices", 0.75 * mib * MIB), ("histories", 0.25 * mib * MIB)],
            samples: 100.0,
            steps: 1000.0,
            seconds: 10.0,
            inelastic: None,
            lever: Lever {
                smaller: vec![("use --refine 2".into(), 300.0 * MIB, 5.0), ("use --refine 1".into(), 90.0 * MIB, 1.0)],
                other: String::new(),
            },
        }
    }

    #[test]
    fn what_fits_is_let_through_and_said_in_words() {
        let fits = estimate(100.0);
        assert_eq!(fits.hold(100), Ok(()));
        assert_eq!(fits.sentence(), "harmonic run: 400 unknowns, about 100 MiB, about 10 s");
    }

    #[test]
    fn both_times_are_said() {
        let mut run = estimate(100.0);
        run.inelastic = Some(250.0);
        let expected = "about 100 MiB, about 10 s if the wall stays elastic, up to about 4 min if it yields or cracks";
        assert!(run.sentence().ends_with(expected), "{}", run.sentence());
        assert_eq!((run.longest(), estimate(1.0).longest()), (250.0, 10.0));
    }

    #[test]
    fn too_much_memory_names_the_largest_part_and_what_fits() {
        let text = estimate(1000.0).hold(100).unwrap_err().to_string();
        for part in [
            "the harmonic run (400 unknowns; matrices 750 MiB) needs about 1000 MiB, more than the allowed 100 MiB",
            "help: use --refine 1 (about 90 MiB), or raise --memory-limit",
        ] {
            assert!(text.contains(part), "`{part}` is missing in {text}");
        }
        let text = estimate(1000.0).hold(50).unwrap_err().to_string();
        assert!(text.ends_with("help: raise --memory-limit"), "{text}");
    }

    #[test]
    fn too_many_samples_steps_and_years_are_refused() {
        type Change = fn(&mut Estimate);
        let limits: [(Change, &str); 3] = [
            (|e| e.samples = 5e6, "takes 5000000 samples of the response"),
            (|e| e.steps = 2e9, "takes 2.0e9 time steps"),
            (|e| e.seconds = 1e10, "takes about 317 years"),
        ];
        for (change, part) in limits {
            let mut long = estimate(1.0);
            change(&mut long);
            let error = long.hold(100).unwrap_err();
            assert!(matches!(error, FeError::TooLong { .. }), "{error:?}");
            let text = error.to_string();
            assert!(text.contains(part) && text.contains("at most") && text.contains("help: "), "{text}");
        }
    }

    #[test]
    fn spans_are_in_units_a_person_waits_in() {
        for (seconds, text) in
            [(0.2, "1 s"), (300.0, "5 min"), (9000.0, "2.5 h"), (3e6, "35 days"), (3.2e9, "101 years")]
        {
            assert_eq!(span(seconds), text);
        }
    }

    /// George 1973: nested dissection of an n × n grid of nine-point stencils has 31/4 n² log₂ n entries to leading order, with
    /// terms of order n² against it; a factor of 1.5 holds from 15 to 255.
    #[test]
    fn fill_of_a_square_grid_is_that_of_nested_dissection() {
        for n in [31.0_f64, 63.0, 127.0, 255.0] {
            let entries = Fill::grid([n, n, 1.0], 1.0, false).entries;
            let george = 7.75 * n * n * (n.log2() - 2.0);
            assert!((0.5..2.0).contains(&(entries / george)), "{n}: {entries} {george}");
        }
    }

    /// A chain: one neighbour on each side, entries proportional to its length.
    #[test]
    fn fill_of_a_chain_is_linear() {
        let entries = |n: f64| Fill::grid([1.0, 1.0, n], 1.0, false).entries;
        let growth = entries(2000.0) / entries(1000.0);
        assert!((1.95..2.05).contains(&growth), "{growth}");
    }
}
