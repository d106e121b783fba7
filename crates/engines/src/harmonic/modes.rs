//! Coupled modes of several harmonics.

use results::Mode;
use tank::Case;

use super::build::build;
use crate::FeError;
use crate::modes::solve;
use tank::options::LinearOptions as Options;

/// Modes of several harmonics: at most `count` of each kind and harmonic, by ascending frequency within a harmonic.
///
/// Errors: as [`build`] and [`solve`].
pub fn modes(case: &Case, options: &Options, harmonics: &[u32], count: usize) -> Result<Vec<Mode>, FeError> {
    let mut found = Vec::new();
    for &harmonic in harmonics {
        let coupled = build(case, options, harmonic)?;
        let wanted = (coupled.surface.unknowns.len() + count).min(coupled.mass.rows);
        let modes = solve(&coupled, Some(wanted))?;
        found.extend(modes.iter().filter(|m| m.number <= count).map(|m| m.to_result(&coupled, case)));
    }
    Ok(found)
}
