//! The fast spectrum: eight oscillators side by side, time outermost, exact maxima of the continuous response.
//!
//! Units and symbols are those of [`super::peaks`]. Each group of oscillators is run in two passes:
//!
//! 1. **Trace** the whole record, eight oscillators at a time, in vector registers whose width is chosen at run
//!    time ([`pulp`]). For each block of 16 steps the state at its start and a bound of the continuous response are stored.
//! 2. **Search**: only blocks whose bound exceeds the largest value so far are searched, for the one oscillator
//!    concerned, and within them only the steps that can contain the maximum.
//!
//! Oscillators with at least eight samples per period are [`super::soft`], the others [`super::stiff`]; the two
//! differ in how they step and in their bounds. Both are exact except for rounding and for the interpolation error of
//! [`super::peaks`], below 3e-7 R.

use std::f64::consts::TAU;

use rayon::prelude::*;

use super::blocks::{Loads, Oscillator, Trace};
use super::lanes::{LANES, lanes};
use super::peaks::Maxima;
use super::soft::{Soft, SoftTrace};
use super::stiff::{Stiff, StiffTrace};

/// Oscillators with fewer steps per period are stiff.
const STIFF: f64 = 8.0;

/// Largest ω²|u|, ω|u̇| and |ü + a_g| [m/s²] of each oscillator over the record and the free vibration after it.
///
/// `ground`: acceleration [m/s²] at samples `h` [s] apart.
pub(crate) fn maxima(ground: &[f64], h: f64, oscillators: &[Oscillator]) -> Vec<Maxima> {
    // Neighbours in frequency share a group, so that a group is of one kind.
    let mut order: Vec<usize> = (0..oscillators.len()).collect();
    order.sort_by(|&i, &j| oscillators[j].omega.total_cmp(&oscillators[i].omega));
    let border = order.partition_point(|&i| oscillators[i].omega * h * STIFF > TAU);
    let loads = Loads::new(ground, h);
    let stiff = order[..border].chunks(LANES).map(|group| (true, group));
    let groups: Vec<(bool, &[usize])> =
        stiff.chain(order[border..].chunks(LANES).map(|group| (false, group))).collect();
    let mut result = vec![Maxima::default(); oscillators.len()];
    // Threads take about 30 µs to wake up, a group of a usual record about as much: at least four groups per thread.
    let workers = match groups.len() / 4 {
        0 | 1 => 1,
        most => rayon::current_num_threads().min(most),
    };
    let share = |worker: usize| {
        // Distributed in turn, because neighbours in frequency have similar cost.
        run(&loads, h, oscillators, groups.iter().skip(worker).step_by(workers))
    };
    let found: Vec<(usize, Maxima)> = match workers {
        1 => share(0),
        _ => (0..workers).into_par_iter().flat_map_iter(share).collect(),
    };
    for (place, maxima) in found {
        result[place] = maxima;
    }
    result
}

/// Maxima of some groups of oscillators, each (whether it is stiff, places of its members).
fn run<'a>(
    loads: &Loads,
    h: f64,
    oscillators: &[Oscillator],
    groups: impl Iterator<Item = &'a (bool, &'a [usize])>,
) -> Vec<(usize, Maxima)> {
    let mut trace = vec![Trace::default(); loads.blocks.len()];
    let mut candidates = Vec::new();
    let mut found = Vec::new();
    let arch = pulp::Arch::new();
    for &(is_stiff, group) in groups {
        let members = members(group, oscillators);
        if is_stiff {
            let stiff = Stiff::new(&members, h);
            let traced = arch.dispatch(StiffTrace { stiff: &stiff, loads, trace: &mut trace });
            let first: [Maxima; LANES] = std::array::from_fn(|lane| stiff.begin(lane, loads, &trace, &traced));
            select(&trace, &first, &mut candidates);
            for (lane, &place) in group.iter().enumerate() {
                found.push((place, stiff.search(lane, loads, &trace, &candidates, first[lane])));
            }
        } else {
            let soft = Soft::new(&members, h);
            let traced = arch.dispatch(SoftTrace { soft: &soft, loads, trace: &mut trace });
            let first: [Maxima; LANES] = std::array::from_fn(|lane| soft.begin(lane, &traced));
            select(&trace, &first, &mut candidates);
            for (lane, &place) in group.iter().enumerate() {
                found.push((place, soft.search(lane, loads, &trace, &candidates, first[lane])));
            }
        }
    }
    found
}

/// The oscillators of a group; a short one is filled up with its last.
fn members(group: &[usize], oscillators: &[Oscillator]) -> [Oscillator; LANES] {
    std::array::from_fn(|i| oscillators[group[i.min(group.len() - 1)]])
}

/// The blocks whose bound exceeds `m` in any lane.
fn select(trace: &[Trace], m: &[Maxima; LANES], blocks: &mut Vec<usize>) {
    let m = [lanes(|i| m[i].y), lanes(|i| m[i].y1), lanes(|i| m[i].a)];
    let exceeds = |t: &Trace| {
        let mut any = false;
        for (bound, m) in t.bound.iter().zip(&m) {
            for i in 0..LANES {
                any |= bound[i] > m[i];
            }
        }
        any
    };
    blocks.clear();
    blocks.extend(trace.iter().enumerate().filter(|(_, t)| exceeds(t)).map(|(block, _)| block));
}
