//! The hoop stress of the wall up to the surface at rest, and that of the rim above it.
//!
//! Procedures know hoop stress from the pressure of the liquid alone. A wall without a ring swings with its edge and its roof as well, so that
//! its stress above the surface is a quantity of its own.

use std::collections::BTreeMap;
use std::ops::Range;

use tank::Quantity;

/// Number of places that are not above the surface at rest.
///
/// * `z`: their heights, ascending [m]; `level`: height of the surface [m]
pub(crate) fn wetted(z: &[f64], level: f64) -> usize {
    z.partition_point(|z| *z <= level * (1.0 + 1e-9))
}

/// Number of the place with the largest value in a range; none in an empty one.
pub(crate) fn worst(mut places: Range<usize>, peak: impl Fn(usize) -> f64) -> Option<usize> {
    let first = places.next()?;
    Some(places.fold(first, |w, i| if peak(i) > peak(w) { i } else { w }))
}

/// Puts both largest hoop stresses among the comparable values.
///
/// * `peak`: largest hoop stress at a place [Pa]
pub(crate) fn put(values: &mut BTreeMap<Quantity, f64>, (z, level): (&[f64], f64), peak: impl Fn(usize) -> f64) {
    let wet = wetted(z, level);
    for (quantity, places) in [(Quantity::HoopStress, 0..wet), (Quantity::RimHoopStress, wet..z.len())] {
        values.extend(worst(places, &peak).map(|i| (quantity, peak(i))));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// By hand: the surface at 3 m belongs to the wetted wall; of a wall that ends there nothing is dry.
    #[test]
    fn the_surface_parts_the_wall() {
        let (z, stress) = ([0.0, 1.0, 3.0, 4.0, 5.0], [0.0, 5.0, 4.0, 9.0, 8.0]);
        let found = |places: usize| {
            let mut values = BTreeMap::new();
            put(&mut values, (&z[..places], 3.0), |i| stress[i]);
            values
        };
        let wet = (Quantity::HoopStress, 5.0);
        assert_eq!(found(5), BTreeMap::from([wet, (Quantity::RimHoopStress, 9.0)]));
        assert_eq!(found(3), BTreeMap::from([wet]));
        assert_eq!(found(0), BTreeMap::new());
    }
}
