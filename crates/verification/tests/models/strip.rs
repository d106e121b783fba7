//! Source:    strip 8.4 of the dissertation; theory of the strip
//! Goal:      walls that stay uncracked answer linearly, and cracked ones keep the balance of energy
//! Model:     fibre beams under the liquid in closed form, El Centro as textbooks print it
//! Tolerance: at each row

use engines::strip::{Side, StripDamping, StripModel, StripQuake};
use fem::analysis::march::Outcome;
use fem::analysis::motion::{Grid, Motion};
use fem::analysis::scheme::TimeScheme;
use fem::analysis::transient::{Load, Settings, integrate};
use fem::element::fibre_beam::Options;
use fem::progress::Silent;
use oscillator::record::Record;
use verification::strip::reinforced_tank;

/// El Centro as textbooks print it (`examples/records`), 0.32 g.
fn el_centro() -> Record {
    let text = include_str!("../../../../examples/records/elcentro.csv");
    let value = |line: &str| line.split(',').nth(1).unwrap().trim().parse::<f64>().unwrap() * 9.80665;
    Record {
        name: "El Centro 1940".into(),
        dt: 0.02,
        acceleration: text.lines().skip(1).map(value).collect(),
        processing: Vec::new(),
    }
}

/// Uncracked, the march of the fibre walls is the linear integration of the same matrices; at four times that the walls
/// crack, dissipate, and the balance of energy still closes.
#[test]
fn uncracked_walls_are_linear_and_cracked_ones_keep_the_balance() {
    let damping = StripDamping::ByGroup { wall: 0.02, sloshing: 0.005 };
    let tank = reinforced_tank(5, 10, 3e-4, Options::default()).unwrap();
    let strip = StripModel::new(&tank, damping).unwrap();
    let record = el_centro();
    let mut quake = StripQuake::new(record.clone(), 5e-3);
    quake.scheme = TimeScheme::Trapezoidal;
    quake.until = Some(3.0);
    let rest = strip.run(&quake, 0.0, Side::Front, &Silent).unwrap();
    let levels = strip.incremental(&quake, &[0.2, 1.6], 2, &Silent, |_| {}).unwrap();

    let grid = Grid::new(record.dt, 3.0, 0.0, 5e-3);
    let scaled: Vec<f64> = record.acceleration.iter().map(|a| 0.2 * a).collect();
    let load = Load::ground(0, Motion::sampled(record.dt, &scaled, &grid));
    let linear =
        integrate(&strip.system, &strip.symbolic, &[load], &Settings::new(grid), &strip.observables(), &[], &Silent)
            .unwrap();
    let top = linear[0].observed.scalars[0].extreme;
    for (wall, dynamic) in levels[0].walls.iter().zip([top.max, -top.min]) {
        assert_eq!(wall.outcome, Outcome::Completed);
        assert_eq!(wall.demand.first_crack, None);
        let expected = rest.demand.deflection + dynamic;
        // The extreme between steps, which only the linear analysis looks for, is up to (ω h)²/8 = 3 % of the wall's part above.
        let error = (wall.demand.deflection - expected) / dynamic;
        assert!(error < 1e-6 && error > -0.03, "{error}");
    }
    let d = levels[1].demand();
    assert!(d.first_crack.is_some() && d.highest_crack > 0.0);
    assert!(levels[1].imbalance() < 1e-3, "{}", levels[1].imbalance());
    assert!(levels[1].walls.iter().any(|w| w.hysteretic > 0.0));
}
