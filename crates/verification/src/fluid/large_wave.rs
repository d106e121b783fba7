//! Waves that are not small in rigid tanks: crest and trough, balance, frequencies, and measured waves.
//!
//! The tolerances were set before the rows were computed: 1 % of the crests and troughs of an independent program, 0.1 % of
//! linear theory and of the energy, 5 % of the shift of a frequency, 2 % of the critical depth. Measurements whose motion is
//! known only in part have none.

use std::f64::consts::{PI, TAU};

use codes::mechanical::{self, Plan};
use fem::liquid::large_wave::{Basis, Liquid, Motion, Properties, RESONANCE, Run, Sampled, Side, run};
use oscillator::sdof;

use crate::{Answer, Benchmark, Part, Reference, Row};

/// The page.
pub(crate) const BENCHMARK: Benchmark = Benchmark {
    id: "large-waves",
    title: "Waves that are not small",
    model: "Potential flow in rigid tanks by the expansion of the surface to third order: cylinder with cos 0θ to cos 3θ and four \
            radial modes of each, strip with 16 modes; classical Runge-Kutta steps of 0.25 over the highest circular frequency.",
    ids: &[
        ("W1", "crest and trough over the linear wave, three cycles of sine in resonance, damping 0.5 %"),
        ("W2", "order 1 against oscillators of the modes, and against masses and levers of potential flow"),
        ("W3", "volume, energy, and forces by two ways"),
        ("W4", "frequency of a standing wave: the shift in deep liquid, and the depth where it changes its sign"),
        ("W5", "measured waves"),
    ],
    parts: &[
        Part::Fast(crests),
        Part::Fast(linear),
        Part::Fast(balances),
        Part::Fast(frequencies),
        Part::Fast(measured),
    ],
};

const GRAVITY: f64 = 9.81;

/// Table of an independent program.
const TABLE: &str = "order 3, 16 modes, by an independent program in NumPy, printed with two decimals";

fn row(id: &str, what: String, reference: (f64, &'static str, Reference), computed: f64, tolerance: f64) -> Row {
    Row::new(id, what, reference, computed, (tolerance, "1"))
}

fn own(depth: f64, damping: f64, order: usize) -> Properties {
    Properties { depth, density: 1000.0, gravity: GRAVITY, damping, order }
}

/// η/R of linear theory, and the ratios of crest and trough to it.
type Ratios = (f64, f64, f64);

/// W1: the crests and troughs of section 1 of the theory.
fn crests() -> Answer {
    let mut rows = Vec::new();
    let basis = Basis::cylinder(1.0, 4, Side::Cosine);
    let table: [(f64, &[Ratios]); 6] = [
        (0.2, &[(0.025, 1.13, 0.91), (0.05, 1.31, 0.82), (0.1, 1.72, 0.67)]),
        (0.4, &[(0.025, 1.05, 0.95), (0.05, 1.12, 0.90), (0.1, 1.27, 0.82), (0.2, 1.61, 0.71)]),
        (0.6, &[(0.025, 1.03, 0.97), (0.05, 1.06, 0.95), (0.1, 1.14, 0.90), (0.2, 1.30, 0.82)]),
        (0.75, &[(0.025, 1.02, 0.98), (0.05, 1.05, 0.96), (0.1, 1.10, 0.92), (0.2, 1.20, 0.85)]),
        (1.5, &[(0.025, 1.02, 0.98), (0.05, 1.04, 0.97), (0.1, 1.07, 0.93), (0.2, 1.15, 0.88)]),
        (2.0, &[(0.025, 1.02, 0.98), (0.05, 1.04, 0.97), (0.1, 1.07, 0.93), (0.2, 1.15, 0.88)]),
    ];
    for (share, waves) in table {
        for &(rise, crest, trough) in waves {
            let [high, low] = RESONANCE.ratios(&basis, own(share, 0.005, 3), rise).unwrap_or([f64::NAN; 2]);
            let place = format!("H/R {share}, linear wave {rise} R");
            let reference = |value| (value, TABLE, Reference::SecondFormulation);
            rows.push(row("W1", format!("{place}: crest"), reference(crest), high, 0.01));
            rows.push(row("W1", format!("{place}: trough"), reference(trough), low, 0.01));
        }
    }
    Ok(rows)
}

/// W2: the linear limit.
fn linear() -> Answer {
    let mut rows = Vec::new();
    // A record with slow and fast parts; its step is a fifth of that of the liquid.
    let (step, count) = (0.01, 3000);
    let ground: Vec<f64> = (0..count)
        .map(|i| step * f64::from(i))
        .map(|t| 0.3 * (0.9 * t).sin() + 2.0 * (23.0 * t).sin() * (-0.1 * t).exp())
        .collect();
    for basis in [Basis::cylinder(10.0, 4, Side::Cosine), Basis::strip(20.0, 1.0, 16)] {
        let (name, plan) = if basis.modes().len() == 17 && basis.modes()[1].harmonic == 0 {
            ("cylinder R 10 m, H 7 m", Plan::Circle)
        } else {
            ("strip L 20 m, H 7 m", Plan::Rectangle)
        };
        let liquid = Liquid::new(basis, own(7.0, 0.005, 1));
        let place = [10.0, 0.0];
        let values = liquid.values(place);
        let mut wave = vec![0.0; ground.len()];
        // As many modes as the liquid has: of a strip half of the 16 are antisymmetric.
        let modes = if plan == Plan::Circle { 4 } else { 8 };
        for n in 1..=modes {
            let omega = mechanical::sloshing_omega(plan, n, 10.0, 7.0, GRAVITY);
            let history = sdof::exact(&ground, step, omega, 0.005);
            // Wave of a mode: the factor of the response to an acceleration, over gravity.
            let factor = 10.0 * mechanical::wave_factor(plan, n) * omega * omega / GRAVITY;
            // The liquid lags: at +x it falls when the tank is accelerated to +x, as the oscillator does.
            wave.iter_mut().zip(&history.u).for_each(|(w, u)| *w += factor * u);
        }
        let samples = ground.iter().map(|&a| Motion::along_x(a)).collect();
        let record = Sampled::new(step, samples);
        let found = run(&liquid, &record, record.duration(), None, |motion| motion);
        let largest = |f: &dyn Fn(usize) -> f64| (0..ground.len()).map(f).fold(0.0_f64, |a, b| a.max(b.abs()));
        let difference = largest(&|i| found.wave_at(&values, step * i as f64) - wave[i]) / largest(&|i| wave[i]);
        let what =
            format!("{name}, order 1: largest difference of the wave from its {modes} oscillators over its largest");
        rows.push(row("W2", what, (0.0, "modal superposition, exact steps", Reference::ClosedForm), difference, 1e-3));
        let rigid = run(&liquid, &(|_| Motion::along_x(1.0)), 1e-6, None, |motion| motion);
        let force = liquid.forces(rigid.frames())[0];
        let masses = mechanical::impulsive(plan, 0.7);
        for (what, reference, computed) in [
            ("impulsive mass from the shear", masses.mass, -force.shear[0] / liquid.mass()),
            ("the same from the pressures", masses.mass, -force.pressure_shear[0] / liquid.mass()),
            ("lever of the wall's pressures", masses.lever, force.wall_moment[0] / force.shear[0] / 7.0),
            ("lever with those of the floor", masses.lever_with_base, force.moment[0] / force.shear[0] / 7.0),
        ] {
            let source = (reference, "series of potential flow", Reference::ClosedForm);
            // The modes that are left out have 0.5 % of the mass.
            rows.push(row("W2", format!("{name}, order 1: {what}"), source, computed, 0.01));
        }
    }
    Ok(rows)
}

/// W3: volume, energy, forces.
fn balances() -> Answer {
    let mut rows = Vec::new();
    let liquid = Liquid::new(Basis::cylinder(10.0, 4, Side::Both), own(7.5, 0.005, 3));
    let omega = liquid.omega()[5];
    // Both components and vertical motion; a crest of about 0.15 R.
    let drive = move |t: f64| Motion {
        acceleration: [0.09 * (omega * t).sin(), 0.045 * (0.9 * omega * t).sin()],
        vertical: 1.0 * (3.1 * omega * t).sin(),
        ..Motion::default()
    };
    let found = run(&liquid, &drive, 6.0 * TAU / omega, None, |motion| motion);
    let crest = found.extremes(&liquid, [10.0, 0.0])[0].1;
    let zero = |source| (0.0, source, Reference::ClosedForm);
    let what = |text: &str| format!("cylinder H/R 0.75, two components and vertical motion: {text}");
    rows.push(row(
        "W3",
        what("largest mean elevation over the crest"),
        zero("volume"),
        found.volume_error / crest,
        1e-3,
    ));
    rows.push(row(
        "W3",
        what("largest rest of the energies over the largest"),
        zero("energy"),
        found.energy_error(),
        1e-3,
    ));
    let forces = liquid.forces(found.frames());
    for d in 0..2 {
        let largest = forces.iter().fold(0.0_f64, |a, f| a.max(f.shear[d].abs()));
        let difference = forces.iter().fold(0.0_f64, |a, f| a.max((f.shear[d] - f.pressure_shear[d]).abs())) / largest;
        let axis = ["x", "y"][d];
        let text = format!("largest difference of the shear along {axis} from that of the pressures, over the largest");
        // The modes that are left out have 0.5 % of the mass; the pressure on the crest is of third order.
        rows.push(row("W3", what(&text), zero("momentum"), difference, 0.02));
    }
    let free = Liquid::new(Basis::strip(1.0, 1.0, 16), own(0.5, 0.0, 3));
    // The products of the expansion are not cut, so that the energy is kept to fifth order of the wave: 0.08 L shows where it is not.
    for (height, tolerance) in [(0.05, 1e-3), (0.08, f64::INFINITY)] {
        let start = standing(&free, height);
        let rest = vec![0.0; start.len()];
        let found = run(&free, &(|_| Motion::default()), 20.0, Some((&start, &rest)), |motion| motion);
        let first = found.energies[0];
        let total = first.kinetic + first.potential;
        let drift = found.energies.iter().fold(0.0_f64, |a, e| a.max((e.kinetic + e.potential - total).abs())) / total;
        let what = format!("strip H/L 0.5, free wave of {height} L: change of energy in 20 s");
        rows.push(row("W3", what, zero("energy"), drift, tolerance));
    }
    Ok(rows)
}

/// A standing wave of the first mode of a strip with its second harmonic in deep liquid, at rest at its highest.
fn standing(liquid: &Liquid, height: f64) -> Vec<f64> {
    let mut start = vec![0.0; liquid.basis().modes().len()];
    start[1] = height;
    start[2] = 0.5 * liquid.basis().modes()[1].wave_number * height * height;
    start
}

/// Circular frequency of the first mode of a free wave over `periods` of it.
fn frequency(liquid: &Liquid, height: f64, periods: f64) -> f64 {
    let start = standing(liquid, height);
    let duration = (periods + 0.6) * TAU / liquid.omega()[1];
    let found =
        run(liquid, &(|_| Motion::default()), duration, Some((&start, &vec![0.0; start.len()])), |motion| motion);
    let mut rising = Vec::new();
    let wave = |i: usize| found.frame(i).elevation[1];
    for i in 1..found.len() {
        if wave(i - 1) < 0.0 && wave(i) >= 0.0 {
            rising.push(crossing(&found, i));
        }
    }
    match (rising.first(), rising.last()) {
        (Some(first), Some(last)) if last > first => TAU * (rising.len() - 1) as f64 / (last - first),
        _ => f64::NAN,
    }
}

/// Time of the zero of the first mode's coefficient in the step before an instant, by bisection of its cubic.
fn crossing(found: &Run, i: usize) -> f64 {
    let mut unit = vec![0.0; found.frame(i).elevation.len()];
    unit[1] = 1.0;
    let (mut low, mut high) = (found.frame(i - 1).time, found.frame(i).time);
    for _ in 0..50 {
        let middle = 0.5 * (low + high);
        if found.wave_at(&unit, middle) < 0.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
    0.5 * (low + high)
}

/// W4: frequencies of free waves.
fn frequencies() -> Answer {
    let mut rows = Vec::new();
    let strip = |depth: f64| Liquid::new(Basis::strip(1.0, 1.0, 16), own(depth, 0.0, 3));
    let deep = strip(2.0);
    let shift = frequency(&deep, 0.1 / PI, 30.0) / deep.omega()[1] - 1.0;
    let source = (-0.1_f64.powi(2) / 8.0, "−(ka)²/8 (Penney & Price 1952)", Reference::ClosedForm);
    rows.push(row("W4", "strip H/L 2, free wave ka = 0.1: shift of the frequency".into(), source, shift, 0.05));
    let at = |depth: f64| {
        let liquid = strip(depth);
        frequency(&liquid, 0.06 / PI, 30.0) / liquid.omega()[1] - 1.0
    };
    let (mut low, mut high) = (0.25, 0.45);
    for _ in 0..8 {
        let middle = 0.5 * (low + high);
        if at(middle) > 0.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
    let source = (0.337, "Tadjbakhsh & Keller 1960", Reference::Published);
    rows.push(row(
        "W4",
        "strip: H/L where a wave becomes neither faster nor slower".into(),
        source,
        0.5 * (low + high),
        0.02,
    ));
    Ok(rows)
}

/// Local extremes of a gauge of a strip: highest and lowest elevation between two times [m].
fn gauge(liquid: &Liquid, found: &Run, x: f64, [from, to]: [f64; 2]) -> [f64; 2] {
    let values = liquid.values([x, 0.0]);
    (0..=400)
        .map(|i| found.wave_at(&values, from + (to - from) * f64::from(i) / 400.0))
        .fold([f64::MIN, f64::MAX], |[high, low], v| [high.max(v), low.min(v)])
}

/// W5: waves that were measured.
fn measured() -> Answer {
    const FALTINSEN: &str =
        "Faltinsen, Rognebakke, Lukovsky & Timokha 2000, figure 7, digitised (PySPH); amplitude not printed there";
    const SHEET: &str = "order 3 by an independent program in NumPy";
    let mut rows = Vec::new();
    let liquid = |length: f64, depth: f64, damping: f64, order: usize| {
        Liquid::new(Basis::strip(length, 1.0, 16), own(depth, damping, order))
    };
    let mut tank = |amplitude: f64, expected: [f64; 3]| {
        // Undamped: 0.5 % of damping lowers the third crest by 5 %.
        let order = 3;
        let omega = TAU / 1.3;
        let liquid = liquid(1.73, 0.6, 0.0, order);
        let drive = move |t: f64| Motion::along_x(-amplitude * omega * omega * (omega * t).cos());
        let found = run(&liquid, &drive, 5.0, None, |motion| motion);
        let windows = [[0.8, 1.5], [2.2, 2.9], [3.6, 4.4]];
        let at = -0.5 * 1.73 + 0.05;
        let crests = windows.map(|window| gauge(&liquid, &found, at, window)[0]);
        for (i, (crest, measured)) in crests.into_iter().zip([0.0754, 0.1421, 0.1093]).enumerate() {
            let what = |by: &str| {
                format!("strip 1.73 × 0.6 m, x = {amplitude} m cos(2πt/1.3 s), undamped: crest {}{by}", i + 1)
            };
            let source = (1e-3 * expected[i], SHEET, Reference::SecondFormulation);
            // Printed in whole millimetres: half of one beside the 1 %.
            let tolerance = 0.01 + 0.5 / expected[i];
            rows.push(Row::new("W5", what(""), source, crest, (tolerance, "m")));
            let source = (measured, FALTINSEN, Reference::Experiment);
            rows.push(Row::new("W5", what(", measured"), source, crest, (f64::INFINITY, "m")));
        }
    };
    tank(0.032, [89.0, 202.0, 138.0]);
    tank(0.025, [68.0, 149.0, 107.0]);
    // Bäuerlein & Avila 2021: 7.86 ± 0.10 rad/s.
    let shallow = liquid(0.5, 0.4, 0.0083, 3);
    let source = (7.86, "Bäuerlein & Avila 2021, 0.500 × 0.400 m", Reference::Experiment);
    rows.push(Row::new("W5", "first frequency", source, shallow.omega()[1], (0.1 / 7.86, "rad/s")));
    // Chen et al. 2007: x = a sin ωt with 0.5 mm at 0.9 of the first frequency begins with a velocity.
    let chen = liquid(0.8, 0.1, 0.002, 3);
    let omega = 0.9 * chen.omega()[1];
    let speed = 0.0005 * omega;
    let drive = move |t: f64| Motion::along_x(-speed * omega * (omega * t).sin());
    let mut psi = vec![0.0; chen.basis().modes().len()];
    for (j, p) in psi.iter_mut().enumerate().skip(1) {
        // The coefficient of x in the modes: ∫xF over ∫F² of cos nπ(x/L + ½), with F = 1 at +L/2.
        *p = -speed * if j % 2 == 1 { 4.0 * 0.8 / (PI * j as f64).powi(2) } else { 0.0 };
    }
    let found = run(&chen, &drive, 8.92, Some((&vec![0.0; psi.len()], &psi)), |motion| motion);
    for (sign, name) in [(1.0, "+x"), (-1.0, "−x")] {
        let [high, low] = gauge(&chen, &found, sign * 0.4, [0.0, 8.92]);
        for (what, reference, computed) in [("rise", 1.704e-3, high), ("fall", 1.573e-3, -low)] {
            let source = (reference, "Chen et al. 2007, file slo_exp_09.dat, first 8.92 s", Reference::Experiment);
            let what = format!("strip 0.8 × 0.1 m, 0.5 mm at 0.9 of the first frequency: largest {what} at {name}");
            rows.push(Row::new("W5", what, source, computed, (f64::INFINITY, "m")));
        }
    }
    Ok(rows)
}
