//! The search for modes wave number by wave number (part by part of a rectangle), several at a time.
//!
//! The searches share matrices and factors and nothing else: neither their number at a time nor their order changes a bit.

use fem::cores;
use fem::progress::Progress;
use rayon::prelude::*;

use super::model::TankModel;
use super::spectrum::{self, TankMode};
use super::system::System;
use crate::FeError;
use crate::modes::Kind;

/// Ritz vectors of a wave number.
const VECTORS: usize = 48;
/// The same of a part of a rectangle, whose waves in both directions take up most of them, at first …
const FIRST_VECTORS: usize = 72;
/// … and where those do not suffice.
const PART_VECTORS: usize = 144;
/// Searches at a time at most: each has a basis of its own.
const AT_A_TIME: usize = 4;

/// Modes of the wave numbers 0 to `most`, at most `count` of each kind and wave number.
///
/// Errors: as [`spectrum::of_harmonic`]; interrupted.
pub(super) fn search(
    tank: &TankModel,
    system: &System,
    (most, count): (u32, usize),
    progress: &dyn Progress,
) -> Result<Vec<Vec<TankMode>>, FeError> {
    let numbers: Vec<u32> = (0..=most).collect();
    progress.stage("modes by wave number", u64::from(most + 1) * vectors(tank)[0] as u64);
    let mut found = Vec::new();
    for together in numbers.chunks(cores::available().min(AT_A_TIME)) {
        if progress.interrupted() {
            return Err(FeError::Interrupted { stage: "the search for modes".into() });
        }
        let one = |&n: &u32| of_number(tank, system, n, count, progress);
        let modes: Vec<Result<_, FeError>> = together.par_iter().map(one).collect();
        found.extend(modes.into_iter().collect::<Result<Vec<_>, FeError>>()?);
    }
    Ok(found)
}

/// Numbers of Ritz vectors to try.
fn vectors(tank: &TankModel) -> &'static [usize] {
    if tank.is_round() { &[VECTORS] } else { &[FIRST_VECTORS, PART_VECTORS] }
}

/// Modes of one number: with the first number of vectors that gives all that are asked for, or with the last.
fn of_number(
    tank: &TankModel,
    system: &System,
    n: u32,
    count: usize,
    progress: &dyn Progress,
) -> Result<Vec<TankMode>, FeError> {
    let complete = |modes: &[TankMode]| {
        [Kind::Sloshing, Kind::Structural].iter().all(|kind| modes.iter().filter(|m| m.kind == *kind).count() >= count)
    };
    let mut modes = Vec::new();
    for &vectors in vectors(tank) {
        modes = spectrum::of_harmonic(tank, system, n, (vectors, count), progress)?;
        if complete(&modes) {
            break;
        }
    }
    Ok(modes)
}
