//! Properties of whole procedures on any sensible tank.

use proptest::prelude::*;

use super::example::{oil_tank, site, steel};
use super::*;
use crate::samples::{case, course};
use tank::Support;
use tank::case::Ec8Site;
use tank::quantity::Quantity;

fn procedures() -> [&'static dyn Procedure; 2] {
    [&En2006, &Env1998]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    /// Any sensible tank: all lines finite, named and cited; SRSS ≤ absolute sum ≤ √2 SRSS.
    #[test]
    fn sheets_are_complete(radius in 1.0f64..40.0, gamma in 0.1f64..3.9, freeboard in 0.0f64..0.3, s in 0.5e-3f64..3e-3,
                           vertical: bool, iterative: bool, anchored: bool) {
        let depth = gamma * radius;
        let height = depth * (1.0 + freeboard);
        let courses = [1.0, 0.7]
            .map(|k| course(0.5 * height, k * s * radius, steel()))
            .to_vec();
        let shape = Shape::Cylinder { radius };
        let mut case = case(shape, courses, depth, Some(Ec8Site { vertical, ..site() }));
        case.liquid.density = 900.0;
        case.tank.roof.mass = 100.0;
        case.tank.support = if anchored { Support::Anchored } else { Support::Unanchored };
        if iterative {
            case.procedures.ec8_impulsive = FlexibleImpulsive::Iterative;
        }
        for procedure in procedures() {
            let a = procedure.assess(&case, Excitation::Site).unwrap();
            for s in &a.steps {
                prop_assert!(s.value.is_finite(), "{s:?}");
                prop_assert!(!s.symbol.is_empty() && !s.name.is_empty() && !s.clause.is_empty() && !s.section.is_empty(), "{s:?}");
            }
            for c in &a.checks {
                prop_assert!(!c.compared() || c.demand.is_some_and(f64::is_finite), "{c:?}");
                prop_assert!(c.compared() || !c.reason.is_empty(), "{c:?}");
            }
            case.procedures.ec8_combination = Combination::Srss;
            let srss = procedure.assess(&case, Excitation::Site).unwrap();
            case.procedures.ec8_combination = Combination::Abs;
            for q in [Quantity::BaseShear, Quantity::BaseMoment, Quantity::OverturningMoment, Quantity::HoopStress] {
                let (sum, root) = (a.values[&q], srss.values[&q]);
                prop_assert!(root <= sum * (1.0 + 1e-12) && sum <= std::f64::consts::SQRT_2 * root * (1.0 + 1e-12), "{q:?}");
            }
        }
    }

    /// Linear in the ground acceleration; liquid, wall and modulus scaled together leave periods and wave, and scale forces.
    #[test]
    fn scaling(k in 0.1f64..10.0, iterative: bool) {
        let mut base = oil_tank();
        if iterative {
            base.procedures.ec8_impulsive = FlexibleImpulsive::Iterative;
        }
        let mut stronger = base.clone();
        stronger.site.ec8 = Some(Ec8Site { ag: k * site().ag, ..site() });
        let mut heavier = base.clone();
        heavier.liquid.density *= k;
        heavier.tank.roof.mass *= k;
        for course in &mut heavier.tank.courses {
            course.material.density *= k;
            course.material.youngs_modulus *= k;
        }
        use Quantity::*;
        for procedure in procedures() {
            let [a, b, c] = [&base, &stronger, &heavier].map(|case| procedure.assess(case, Excitation::Site).unwrap().values);
            for (q, value) in &a {
                let (strong, heavy) = match q {
                    SloshingPeriod | ImpulsivePeriod => (1.0, 1.0),
                    SloshingHeight => (k, 1.0),
                    ImpulsiveMass | WallMass | RoofMass | ConvectiveMass => (1.0, k),
                    _ => (k, k),
                };
                prop_assert!((b[q] / (strong * value) - 1.0).abs() < 1e-9, "{q:?}");
                prop_assert!((c[q] / (heavy * value) - 1.0).abs() < 1e-6, "{q:?} {} {}", c[q], heavy * value);
            }
        }
    }
}
