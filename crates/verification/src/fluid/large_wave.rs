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
        ("W6", "depths between those of the table, predicted before they were compared"),
        ("W7", "300 s of long-period motion on tanks of 43 and 78 m, Tokachi-oki 2003"),
    ],
    parts: &[
        Part::Fast(crests),
        Part::Fast(linear),
        Part::Fast(balances),
        Part::Fast(frequencies),
        Part::Fast(measured),
        Part::Fast(predicted),
        Part::Fast(long_period),
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
    for (depth, name) in [(0.8, "the tank of Bäuerlein & Avila"), (0.25, "below the critical depth")] {
        let liquid = strip(depth);
        let shift = frequency(&liquid, 0.06 / PI, 30.0) / liquid.omega()[1] - 1.0;
        // ω = tanh kH to the power ½: ω + (ka)² (9 ω⁻⁷ − 12 ω⁻³ − 3 ω − 2 ω⁵)/64.
        let w = (PI * depth).tanh().sqrt();
        let third = (9.0 * w.powi(-7) - 12.0 * w.powi(-3) - 3.0 * w - 2.0 * w.powi(5)) / 64.0;
        let source = (0.06_f64.powi(2) * third / w, "Tadjbakhsh & Keller 1960", Reference::ClosedForm);
        let what = format!("strip H/L {depth} ({name}), free wave ka = 0.06: shift of the frequency");
        rows.push(row("W4", what, source, shift, 0.05));
    }
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
    let source = (0.065, "Bäuerlein & Avila 2021, ± 0.015", Reference::Experiment);
    let what = "the same tank, decay of a small wave with the damping of the codes, 0.5 %";
    rows.push(Row::new("W5", what, source, 0.005 * shallow.omega()[1], (f64::INFINITY, "1/s")));
    rows.extend(chen());
    Ok(rows)
}

/// Chen et al. 2007: x = a sin ωt with 0.5 mm at 0.9 of the first frequency begins with a velocity. What the wave depends on is varied: damping,
/// that velocity, and the ratio of the frequencies.
fn chen() -> Vec<Row> {
    const SOURCE: &str = "Chen et al. 2007, file slo_exp_09.dat, first 8.92 s";
    let mut rows = Vec::new();
    for (name, ratio, damping, moves) in [
        ("0.9 of the first frequency", 0.9, 0.002, true),
        ("0.9 of the first frequency, damping 1 %", 0.9, 0.01, true),
        ("0.9 of the first frequency, without the velocity at the start", 0.9, 0.002, false),
        ("0.88 of the first frequency", 0.88, 0.002, true),
        ("0.88 of the first frequency, without the velocity at the start", 0.88, 0.002, false),
    ] {
        let liquid = Liquid::new(Basis::strip(0.8, 1.0, 16), own(0.1, damping, 3));
        let omega = ratio * liquid.omega()[1];
        let speed = 0.0005 * omega;
        let drive = move |t: f64| Motion::along_x(-speed * omega * (omega * t).sin());
        let mut psi = vec![0.0; liquid.basis().modes().len()];
        for (j, p) in psi.iter_mut().enumerate().skip(1).filter(|_| moves) {
            // The coefficient of x in the modes: ∫xF over ∫F² of cos nπ(x/L + ½), with F = 1 at +L/2.
            *p = -speed * if j % 2 == 1 { 4.0 * 0.8 / (PI * j as f64).powi(2) } else { 0.0 };
        }
        let found = run(&liquid, &drive, 8.92, Some((&vec![0.0; psi.len()], &psi)), |motion| motion);
        let [high, low] = gauge(&liquid, &found, 0.4, [0.0, 8.92]);
        for (what, reference, computed) in [("rise", 1.704e-3, high), ("fall", 1.573e-3, -low)] {
            let what = format!("strip 0.8 × 0.1 m, 0.5 mm at {name}: largest {what} at +x");
            rows.push(Row::new("W5", what, (reference, SOURCE, Reference::Experiment), computed, (f64::INFINITY, "m")));
        }
    }
    rows
}

/// W6: crest and trough at depths that the table does not have, beside what lies between its rows on logarithmic scales of excess and depth.
fn predicted() -> Answer {
    const BETWEEN: &str = "between the neighbours of the independent program's table";
    let basis = Basis::cylinder(1.0, 4, Side::Cosine);
    let rows: [(f64, f64, f64, f64); 9] = [
        (0.3, 0.025, 1.074, 0.936),
        (0.3, 0.05, 1.178, 0.872),
        (0.3, 0.1, 1.406, 0.769),
        (0.5, 0.05, 1.082, 0.932),
        (0.5, 0.1, 1.188, 0.870),
        (0.5, 0.2, 1.413, 0.777),
        (1.0, 0.05, 1.046, 0.965),
        (1.0, 0.1, 1.086, 0.924),
        (1.0, 0.2, 1.177, 0.863),
    ];
    let mut answer = Vec::new();
    for (share, rise, crest, trough) in rows {
        let [high, low] = RESONANCE.ratios(&basis, own(share, 0.005, 3), rise).unwrap_or([f64::NAN; 2]);
        let place = format!("H/R {share}, linear wave {rise} R");
        for (name, reference, computed) in [("crest", crest, high), ("trough", trough, low)] {
            let source = (reference, BETWEEN, Reference::SecondFormulation);
            answer.push(row("W6", format!("{place}: {name}"), source, computed, f64::INFINITY));
        }
    }
    Ok(answer)
}

/// A motion of 300 s with periods of 3 to 12 s that grows, lasts and fades, at a step of 0.02 s [m/s²].
fn slow_motion() -> Vec<f64> {
    (0..15_000)
        .map(|i| 0.02 * f64::from(i))
        .map(|t| {
            let envelope = (t / 40.0).min(1.0) * ((300.0 - t) / 150.0).min(1.0);
            // Phases that differ from each other, as those of a record do.
            (0..19).map(|i| (TAU * t / (3.0 + 0.5 * f64::from(i)) + 2.4 * f64::from(i * i)).sin()).sum::<f64>()
                * envelope
        })
        .collect()
}

/// W7: two of the tanks of Tomakomai under motion that gives the waves that were seen there.
fn long_period() -> Answer {
    const SEEN: &str = "Tomakomai 2003, reported as about";
    const SHEET: &str = "η (1 + c η/R) with c of three cycles in resonance by an independent program";
    let mut rows = Vec::new();
    let step = 0.02;
    for (name, diameter, depth, period, wave, factor) in
        [("D 42.7 m, H 19.9 m", 42.7, 19.9, 7.0, 3.0, 0.87), ("D 78.2 m, H 19.8 m", 78.2, 19.8, 12.0, 1.5, 1.64)]
    {
        let radius = 0.5 * diameter;
        let at = |order: usize| Liquid::new(Basis::cylinder(radius, 4, Side::Cosine), own(depth, 0.005, order));
        let [small, large] = [at(1), at(3)];
        let omega = |n| mechanical::sloshing_omega(Plan::Circle, n, radius, depth, GRAVITY);
        let source = (period, SEEN, Reference::Experiment);
        rows.push(Row::new("W7", format!("{name}: first period"), source, TAU / omega(1), (f64::INFINITY, "s")));
        let slow = slow_motion();
        // Waves of the modes at the wall by oscillators, for a motion of the amplitude 1.
        let histories: Vec<Vec<f64>> = (1..=4)
            .map(|n| {
                let factor = radius * mechanical::wave_factor(Plan::Circle, n) * omega(n).powi(2) / GRAVITY;
                sdof::exact(&slow, step, omega(n), 0.005).u.iter().map(|u| factor * u).collect()
            })
            .collect();
        let sum: Vec<f64> = (0..slow.len()).map(|i| histories.iter().map(|h| h[i]).sum()).collect();
        let most = |values: &[f64]| values.iter().fold(0.0_f64, |a, v| a.max(v.abs()));
        let scale = wave / most(&sum);
        let record = Sampled::new(step, slow.iter().map(|a| Motion::along_x(scale * a)).collect());
        let highest = |liquid: &Liquid| {
            let found = run(liquid, &record, record.duration(), None, |motion| motion);
            let sides = [radius, -radius].map(|x| found.extremes(liquid, [x, 0.0]));
            let crest = sides[0][0].1.max(sides[1][0].1);
            (crest, crest.max(-sides[0][1].1).max(-sides[1][1].1), found)
        };
        let (_, linear, _) = highest(&small);
        let closed = (wave, "four oscillators, exact steps", Reference::ClosedForm);
        rows.push(Row::new("W7", format!("{name}: largest wave, order 1"), closed, linear, (0.002, "m")));
        let (crest, _, found) = highest(&large);
        let source = (wave * (1.0 + factor * wave / radius), SHEET, Reference::SecondFormulation);
        // 5 % were expected. In a long record the nonlinear wave leaves the frequency at which the linear one grows.
        rows.push(Row::new("W7", format!("{name}: crest, order 3"), source, crest, (f64::INFINITY, "m")));
        let zero = (0.0, "energy", Reference::ClosedForm);
        let what = format!("{name}: largest rest of the energies over the largest");
        rows.push(row("W7", what, zero, found.energy_error(), 1e-2));
        let second = scale * most(&histories[1]);
        let share = mechanical::wave_factor(Plan::Circle, 2) / mechanical::wave_factor(Plan::Circle, 1);
        let source = (share, "of the wave factors, for equal accelerations", Reference::ClosedForm);
        let what = format!("{name}: second mode over the first, waves at the wall");
        rows.push(row("W7", what, source, second / (scale * most(&histories[0])), f64::INFINITY));
    }
    Ok(rows)
}
