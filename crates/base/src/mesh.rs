//! Nodes along the plate.

use crate::plate::Bands;

/// Distance from the rim within which the plate may lift with a fine mesh [m].
pub(crate) const FINE: f64 = 3.0;

/// Nodes from the rim inwards [m], the last at `length`.
///
/// At the rim one thickness (a plastic hinge is some thicknesses long), growing by 5 % to a third of the length (4 D/k)^(1/4) over which
/// the plate sinks into the ground, at most 30 mm; beyond the distance `fine` growing by a fifth. `refinement` divides all widths.
pub(crate) fn nodes(bands: &Bands, modulus: f64, length: f64, (refinement, fine): (f64, f64)) -> Vec<f64> {
    let rim = bands.rim();
    let sinking = (4.0 * rim.bending_stiffness() / modulus).powf(0.25);
    let largest = (sinking / 3.0).min(0.03) / refinement;
    let fine = fine.min(length);
    let mut nodes = vec![0.0];
    let mut width = (rim.thickness / refinement).min(largest);
    let mut at = 0.0;
    let step = |at: f64, width: f64| {
        // A node where the thickness changes.
        match bands.width() {
            Some(end) if at < end - 1e-9 && at + 1.5 * width > end => end,
            _ => at + width,
        }
    };
    while at < fine {
        at = step(at, width);
        nodes.push(at);
        width = (width * 1.05_f64.powf(1.0 / refinement)).min(largest);
    }
    while at < length {
        width = (width * 1.2_f64.powf(1.0 / refinement)).min(length / (20.0 * refinement));
        at = step(at, width);
        nodes.push(at);
    }
    // The last node stands at the end, and no sliver before it.
    while nodes.len() > 2 && nodes[nodes.len() - 2] > length - 0.5 * width {
        nodes.pop();
    }
    if let Some(last) = nodes.last_mut() {
        *last = length;
    }
    nodes
}

#[cfg(test)]
mod tests {
    use super::nodes;
    use crate::plate::{Bands, Plate};

    #[test]
    fn nodes_rise_to_the_end_and_meet_the_edge_of_the_annular_plate() {
        let plate = |thickness| Plate { thickness, young_modulus: 2e11, poisson_ratio: 0.3, yield_stress: None };
        let bands = Bands::annular(plate(0.01), 0.7123, plate(0.006));
        for length in [0.5, 2.0, 20.0] {
            let nodes = nodes(&bands, 1e8, length, (1.0, 3.0));
            assert!(nodes.windows(2).all(|w| w[1] > w[0]));
            assert_eq!(nodes.first(), Some(&0.0));
            assert_eq!(nodes.last(), Some(&length));
            assert_eq!(nodes.iter().any(|x| (x - 0.7123).abs() < 1e-12), length > 0.7123);
        }
        // One thickness at the rim and at most 30 mm as far as the plate may lift, over the refinement.
        for refinement in [1.0, 2.0] {
            let nodes = nodes(&bands, 1e8, 20.0, (refinement, 3.0));
            let widths = |to: f64| nodes.windows(2).filter(move |w| w[1] <= to).map(|w| w[1] - w[0]);
            let largest = widths(3.0).fold(0.0, f64::max);
            // A node moves by half a width to where the thickness changes.
            assert!((0.03..0.0451).contains(&(refinement * largest)), "{largest}");
            assert!((refinement * nodes[1] - 0.01).abs() < 1e-12);
            // A twentieth of the length beyond; the last one has the sliver that is left.
            assert!(refinement * widths(20.0).fold(0.0, f64::max) <= 1.5);
        }
    }
}
