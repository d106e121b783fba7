//! Source:    the same checks of demands whose histories are multiplied by the factor
//! Goal:      the same utilisations, instants and angles by the bounds of blocks, over 400 instants and three places
//! Tolerance: 1e-12: another order of the products

use super::*;

/// Three places of both courses under motion along x, or x and y, whose histories have their largest values in few blocks.
fn demands(seed: u64, transverse: bool) -> Demands {
    let mut all = Demands::default();
    for (number, (z, course)) in [(0.0, 0), (4.0, 0), (5.0, 1)].into_iter().enumerate() {
        let states = all.states.len();
        let mut one = shaken(seed + 100 * number as u64).demands(z, course);
        let mut place = one.places.remove(0);
        let moved = |terms: &mut tank::demand::Terms| terms.iter_mut().for_each(|term| term.0 += states);
        for on_wall in [Some(&mut place.hoop), Some(&mut place.axial), place.bending.as_mut(), place.pressure.as_mut()]
        {
            let on_wall = on_wall.unwrap();
            moved(&mut on_wall.even);
            moved(&mut on_wall.odd);
        }
        moved(place.shear.as_mut().unwrap());
        for state in &mut one.states {
            for (k, value) in state.iter_mut().enumerate() {
                *value *= (-((k as f64 - 130.0) / 60.0).powi(2)).exp();
            }
        }
        (all.times, all.wave) = (one.times, one.wave);
        all.states.extend(one.states);
        all.places.push(place);
    }
    if transverse {
        all.transverse = demands(seed + 50, false).states;
    }
    all.states.extend([noise(seed + 7, 4e6), noise(seed + 8, 2.0), noise(seed + 9, 6e7)]);
    if transverse {
        all.transverse.extend([noise(seed + 17, 4e6), vec![0.0; 400], noise(seed + 19, 6e7)]);
    }
    let last = all.states.len();
    all.base_shear = Some(vec![(last - 3, 1.0)]);
    all.vertical = Some(vec![(last - 2, 1.0)]);
    all.overturning_moment = Some(vec![(last - 1, 1.0)]);
    all
}

#[test]
fn a_factor_is_a_multiplied_motion() {
    let mut case = steel_tank();
    case.site.ec8 = Some(crate::ec8::example::site());
    case.site.api650 = Some(api_site());
    case.tank.anchors =
        Some(Anchors { count: 20, capacity: Some(40e3), attachment_capacity: None, ..Anchors::default() });
    if let Some(site) = &mut case.site.ec8 {
        (site.friction, site.bearing_capacity) = (Some(0.4), Some(400e3));
    }
    case.tank.courses[0].corrosion = 0.002;
    for (seed, transverse) in [(21, false), (22, false), (23, true)] {
        let unit = demands(seed, transverse);
        let ready = Ready::new(&case, &unit);
        // Up and down: a search begins where another factor's ended.
        for factor in [0.05, 0.6, 1.0, 1.7, 6.0, 0.3, 1.0] {
            let mut scaled = unit.clone();
            for value in scaled.states.iter_mut().chain(&mut scaled.transverse).flatten() {
                *value *= factor;
            }
            if let Some(wave) = &mut scaled.wave {
                wave.value *= factor;
            }
            let codes = &counted(&case, &[]);
            let found = assess_at(&case, codes, (&ready, factor), &BTreeMap::new());
            let wanted = assess(&case, codes, &scaled, &BTreeMap::new());
            assert_eq!(found.checks.len(), wanted.checks.len());
            assert!(found.checks.iter().filter(|c| c.utilisation.is_some()).count() >= 8);
            for (a, b) in found.checks.iter().zip(&wanted.checks) {
                assert_eq!((&a.id, a.status, a.time_s), (&b.id, b.status, b.time_s));
                close(a.theta.unwrap_or(1.0), b.theta.unwrap_or(1.0), 1e-9);
                close(a.demand.unwrap_or(1.0), b.demand.unwrap_or(1.0), 1e-12);
                close(a.capacity.unwrap_or(1.0), b.capacity.unwrap_or(1.0), 1e-12);
            }
        }
    }
}
