//! The impulsive mode among the structural ones: one rule for the engines and for the comparison of methods.
//!
//! ```text
//! dominant   a structural mode of period T_1 whose effective mass m_1 is the largest between T_1/√3 and √3 T_1
//! group      every structural mode with  m ≥ ½ m_1  and  T_1/√3 ≤ T ≤ √3 T_1
//! impulsive  of the groups with half of the mass of the heaviest one the lowest
//! ```
//!
//! The reasons of both limits are given where the engines use them (`engines::impulsive`).

use crate::modal::ModalPart;

/// Least effective mass of a member over that of the dominant mode, and of a group over the heaviest one.
const COMPARABLE: f64 = 0.5;

/// The dominant mode of pairs of circular frequency [rad/s] and effective mass [kg], and the group it belongs to, as places in `modes`;
/// `None` without a mode. Of equal masses the first counts.
pub fn group(modes: &[(f64, f64)]) -> Option<(usize, Vec<usize>)> {
    let near = 3.0_f64.sqrt();
    let beside = |i: usize| {
        let close = move |j: &usize| (1.0 / near..=near).contains(&(modes[*j].0 / modes[i].0));
        (0..modes.len()).filter(close)
    };
    let dominant = |&i: &usize| beside(i).all(|j| modes[j].1 < modes[i].1 || (modes[j].1 == modes[i].1 && j >= i));
    let groups: Vec<(usize, Vec<usize>, f64)> = (0..modes.len())
        .filter(dominant)
        .map(|i| {
            let members: Vec<usize> = beside(i).filter(|&j| modes[j].1 >= COMPARABLE * modes[i].1).collect();
            let mass = members.iter().map(|&j| modes[j].1).sum();
            (i, members, mass)
        })
        .collect();
    let heaviest = groups.iter().map(|g| g.2).reduce(f64::max)?;
    let comparable = groups.into_iter().filter(|g| g.2 >= COMPARABLE * heaviest);
    let lowest = comparable.reduce(|a, b| if modes[b.0].0 < modes[a.0].0 { b } else { a })?;
    Some((lowest.0, lowest.1))
}

/// The impulsive mode of a response mode by mode, and its group by ascending frequency.
pub fn among(modal: &[ModalPart]) -> Option<(&ModalPart, Vec<&ModalPart>)> {
    let structural: Vec<&ModalPart> = modal.iter().filter(|p| p.kind == "structural").collect();
    let pairs: Vec<(f64, f64)> = structural.iter().map(|p| (std::f64::consts::TAU / p.period, p.total.shear)).collect();
    let (dominant, members) = group(&pairs)?;
    Some((structural[dominant], members.into_iter().map(|i| structural[i]).collect()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::modal::Inertia;

    fn part(number: usize, (omega, mass): (f64, f64)) -> ModalPart {
        ModalPart {
            kind: "structural".into(),
            number,
            period: std::f64::consts::TAU / omega,
            damping: 0.05,
            wave: 0.0,
            total: Inertia { shear: mass, ..Inertia::default() },
            structure: None,
            stress: None,
        }
    }

    /// The box 8 × 5 × 4 m: the fourth mode holds what is left of the mass and moves the walls in their planes. The first plate mode is
    /// meant; the second, √2 above it with two thirds of its mass, belongs to it, the third with 0.40 does not.
    #[test]
    fn the_rest_of_a_box_is_not_its_impulsive_mode() {
        let modes = [(183.3, 32.8), (263.8, 21.8), (460.7, 13.1), (804.0, 48.1)];
        let modal: Vec<ModalPart> = modes.into_iter().zip(1..).map(|(mode, n)| part(n, mode)).collect();
        let (dominant, members) = among(&modal).unwrap();
        assert_eq!(dominant.number, 1);
        assert_eq!(members.iter().map(|p| p.number).collect::<Vec<_>>(), [1, 2]);
    }

    /// A slender steel tank with a roof of 50 t and little liquid: wall and roof swing at 41.7 rad/s with 106 t, the liquid with two modes
    /// that have 265 t together.
    #[test]
    fn a_group_outweighs_a_single_mode_below() {
        let (dominant, members) = group(&[(41.7, 106.1), (83.1, 126.8), (112.8, 138.1)]).unwrap();
        assert_eq!((dominant, members), (2, vec![1, 2]));
    }

    /// A roof on a soft support with a tenth of the mass is the lowest mode and not the impulsive one.
    #[test]
    fn a_light_mode_below_is_passed_over() {
        let modal = [part(1, (1.0, 0.1)), part(2, (3.0, 1.0))];
        let (dominant, members) = among(&modal).unwrap();
        assert_eq!((dominant.number, members.len()), (2, 1));
        assert!(among(&[]).is_none());
    }
}
