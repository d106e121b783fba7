//! Waves: strips on shaking tables, oil tanks, and steel cylinders of another program.

use std::f64::consts::{PI, TAU};

use fem::liquid::large_wave::{Basis, Liquid, Motion, Properties, run};
use oscillator::record::Record;
use results::channel::OnWall;
use tank::Case;

use super::{TIME, VALUE, example, experiment, experimental, extreme, history, judged, motion, peak, shaken};
use crate::records::EL_CENTRO_NGA;
use crate::{Answer, Records, Reference, Row};
use engines::{FeError, Options, Simulation};

/// First sloshing frequencies of a tank, ascending [rad/s].
fn sloshing(tank: &Case, count: usize) -> Result<Vec<f64>, FeError> {
    let modes = engines::modes(tank, &Options::default(), &[1], count)?;
    let omega: Vec<f64> = modes.iter().filter(|mode| mode.kind == "sloshing").map(|mode| mode.omega).collect();
    if omega.len() < count { Err(FeError::Analysis("too few sloshing modes".into())) } else { Ok(omega) }
}

/// Liquid of third order in the rigid strip of a case.
fn rigid(case: &Case) -> Liquid {
    let own = Properties {
        depth: case.liquid.fill_height,
        density: case.liquid.density,
        gravity: case.gravity,
        damping: case.damping.sloshing,
        order: 3,
    };
    Liquid::new(Basis::strip(2.0 * case.tank.shape.half_length(), 1.0, 16), own)
}

/// The strip of Faltinsen et al.: when crests and troughs pass, which does not depend on the amplitude of a linear wave, and their ratios.
pub(super) fn faltinsen() -> Answer {
    const SOURCE: &str =
        "Faltinsen, Rognebakke, Lukovsky & Timokha 2000, figure 7, digitised (PySPH), gauge 5 cm from the wall";
    const START: &str = "the first wave comes a tenth of a second late, all later ones on time: x = a cos ωt begins with a step of acceleration, which \
                         no table makes";
    const SYMMETRIC: &str = "crests and troughs of a linear wave are equally high; see the row of third order";
    const AMPLITUDE: &str = "open: the printed amplitude was not seen (the paper is in public text by its first page alone); ratios of high waves depend on it";
    // The amplitude is that of PySPH's example; the printed one was not seen. The gauge of the test stands at −x, that of the file at +x.
    let (amplitude, omega, dt) = (0.032, TAU / 1.3, 0.0025);
    let acceleration = |t: f64| amplitude * omega * omega * (omega * t).cos();
    let file = example("experiments/faltinsen_2000.json")?;
    let liquid = rigid(&file.case);
    let place = [file.fe.gauges[0], 0.0];
    let found = shaken(&file.case, motion(dt, 4000, acceleration), file.fe)?;
    let linear = history(&found, "wave_height_r_0.815")?;
    let large = run(&liquid, &|t: f64| Motion::along_x(acceleration(t)), 10.0, None, |motion| motion);
    let values = liquid.values(place);
    let third: Vec<f64> = (0..=4000).map(|k| large.wave_at(&values, dt * f64::from(k))).collect();

    let mut rows = Vec::new();
    // (crest, time, value) as digitised; windows of about a period around them.
    let measured = [
        (true, 1.1629, 75.4),
        (false, 1.9253, 88.0),
        (true, 2.5735, 142.1),
        (false, 3.2671, 92.5),
        (true, 4.0403, 109.3),
        (false, 4.7113, 45.4),
        (true, 7.7074, 124.8),
        (true, 9.1586, 141.4),
    ];
    let within = |time: f64| [time - 0.4, time + 0.4];
    let at = |history: &[f64], (crest, time, _): (bool, f64, f64)| {
        extreme(history, dt, within(time), if crest { 1.0 } else { -1.0 })
    };
    for (engine, history) in [("linear", linear), ("third order", third.as_slice())] {
        for passing in measured {
            let name = if passing.0 { "crest" } else { "trough" };
            let row = Row::new(
                "X4",
                format!("{engine}: time of the {name} at {:.2} s", passing.1),
                experiment(passing.1, SOURCE),
                at(history, passing)[0],
                (TIME, "s"),
            );
            rows.push(judged(row, START));
        }
        let ratio = |a: usize, b: usize| at(history, measured[a])[1] / at(history, measured[b])[1];
        for (what, a, b) in [
            ("second crest over the first", 2, 0),
            ("third crest over the second", 4, 2),
            ("second trough over the second crest", 3, 2),
        ] {
            let source = experiment(measured[a].2 / measured[b].2, SOURCE);
            let row = Row::new("X4", format!("{engine}: {what}"), source, ratio(a, b), (VALUE, "1"));
            rows.push(judged(row, if engine == "linear" { SYMMETRIC } else { AMPLITUDE }));
        }
    }
    Ok(rows)
}

/// The shallow strip of Chen et al.
pub(super) fn chen() -> Answer {
    const SOURCE: &str = "Chen et al. 2007, file slo_exp_09.dat of whtsao/Sloshing-ALE-FEM, first 8.92 s";
    const HEIGHT: &str = "open: see the steady wave; the free wave, 1.1 % faster than by potential flow, takes 3 % away here and 10 % later; the gauge's \
                          step is 0.066 mm";
    const START: &str = "the measured wave starts later than x = a sin ωt with its velocity at once; from the third trough on it is on time";
    let tank = experimental("chen_2007")?;
    let omega = 0.9 * sloshing(&tank, 1)?[0];
    let (amplitude, dt) = (0.0005, 0.005);
    // x = a sin ωt begins with the velocity aω: a triangle of two steps, whose first half is before the record.
    let pulse = 2.0 * amplitude * omega / dt;
    let record = motion(dt, 1784, |t| if t == 0.0 { pulse } else { -amplitude * omega * omega * (omega * t).sin() });
    let found = shaken(&tank, record, Options::default())?;
    let wave = history(&found, "wave_height_theta_0")?;
    let mut rows = Vec::new();
    let passing = [
        ("second trough", -1.0, 3.65, 1.245),
        ("third crest", 1.0, 4.62, 1.245),
        ("third trough", -1.0, 5.35, 1.376),
        ("fourth crest", 1.0, 6.06, 1.442),
        ("fourth trough", -1.0, 7.05, 1.573),
        ("fifth crest", 1.0, 7.89, 1.704),
    ];
    for (name, sign, time, value) in passing {
        let [at, height] = extreme(wave, dt, [time - 0.6, time + 0.6], sign);
        let row = Row::new("X5", format!("{name}: height"), experiment(value, SOURCE), 1e3 * height, (VALUE, "mm"));
        rows.push(judged(row, HEIGHT));
        let row = Row::new("X5", format!("{name}: time"), experiment(time, SOURCE), at, (TIME, "s"));
        rows.push(judged(row, START));
    }
    rows.extend(two_tones(&tank));
    Ok(rows)
}

/// What the whole of that file says: the wave of the motion and the free one that decays, apart.
fn two_tones(tank: &Case) -> [Row; 3] {
    const SOURCE: &str =
        "Chen et al. 2007, slo_exp_09.dat: two tones and their decay, fitted to 1 to 17.4 s and 31.3 to 39.6 s";
    const PINNED: &str = "a contact line that stays where it is stiffens the wave by 2 l/L at the ends, l = √(σ/(ρ g)) = 2.7 mm, and by l/B at the sides, \
                          whose distance B was not seen; 2.5 mm more of water have the same effect. A wave of 1 mm turns the angle of contact by 21°, \
                          less than it takes to move the line, so that the line has no friction either";
    const STEADY: &str = "open: both the steady and the free wave are 0.8 of what the motion of 0.5 mm gives. Not damping: 1 % of critical changes a wave at 0.9 of \
                          its frequency by 0.5 %. Not the frequency, which is the measured one here. What is left is the motion of the table, which is not in \
                          the file, or the gauge";
    const DECAY: &str = "laminar layers of floor and ends (Keulegan 1959) in water of 20 °C; the sides add 0.04 %·m/B, a surface that a film holds 0.19 %";
    let (length, depth) = (2.0 * tank.tank.shape.half_length(), tank.liquid.fill_height);
    let capillary = (0.0728 / (tank.liquid.density * tank.gravity)).sqrt();
    let wave = |n: f64| n * PI / length;
    let square = |k: f64| tank.gravity * k * (k * depth).tanh();
    let first = square(wave(1.0));
    // The fit: the motion at 0.900, the free wave at 1.011 of the first frequency.
    let (motion, free) = (0.81 * first, 1.011_f64.powi(2));
    let part = |n: f64| 4.0 / (length * wave(n)) * (wave(n) * depth).tanh() / (free * square(wave(n)) / motion - 1.0);
    let steady: f64 = [1.0, 3.0, 5.0, 7.0].map(part).iter().sum();
    let k = wave(1.0);
    let layer = 0.5 * (1e-6 / (2.0 * first.sqrt())).sqrt();
    let twice = 2.0 * k * depth;
    let floor = 2.0 * k / twice.sinh();
    let ends = 2.0 / length * (1.0 - twice / twice.sinh());
    let row = |what: &str, measured: f64, own: f64, (tolerance, unit): (f64, &'static str)| {
        Row::new("X5", what, experiment(measured, SOURCE), own, (tolerance, unit))
    };
    let frequency = row(
        "free wave: frequency over that of potential flow, line of contact held at the ends",
        1.011,
        1.0 + 2.0 * capillary / length,
        (TIME, "1"),
    );
    let steady = row("steady wave of the motion, with the measured frequencies", 0.73, 0.5 * steady, (VALUE, "mm"));
    let decay =
        row("decay of the free wave over critical, laminar layers", 0.0055, layer * (floor + ends), (VALUE, "1"));
    [frequency.remarked(PINNED), judged(steady, STEADY), judged(decay, DECAY)]
}

/// Frequencies, periods and decay of free waves.
pub(super) fn free() -> Answer {
    let mut rows = Vec::new();
    let own = sloshing(&experimental("baeuerlein_2021")?, 1)?[0];
    let source = experiment(7.86, "Bäuerlein & Avila 2021, 0.500 × 0.400 m: 7.86 ± 0.10 rad/s");
    rows.push(Row::new("X6", "first sloshing frequency", source, own, (0.10 / 7.86, "rad/s")));
    let source = experiment(0.065, "Bäuerlein & Avila 2021: 0.065 ± 0.015 1/s");
    let decay = Row::new("X6", "decay of the free wave", source, 0.005 * own, (0.015 / 0.065, "1/s"));
    rows.push(judged(
        decay,
        "0.5 % of critical is a convention of codes for large tanks; the boundary layers of this one give 0.0434 1/s, the test 0.83 %",
    ));
    for (name, period, source) in [
        ("tomakomai_42m", 7.0, "Tomakomai, 2003 Tokachi-oki earthquake: about 7 s"),
        ("tomakomai_78m", 12.0, "Tomakomai, 2003 Tokachi-oki earthquake: about 12 s"),
    ] {
        let tank = experimental(name)?;
        let own = sloshing(&tank, 1)?[0];
        // Printed without a decimal.
        let what = format!("tank of {} m: first sloshing period", 2.0 * tank.tank.shape.half_length());
        let row = Row::new("X7", what, experiment(period, source), TAU / own, (0.5 / period, "s"));
        rows.push(judged(row, "the depth was not seen; 12 s belong to 14.5 m, 70 % of the nominal volume"));
    }
    let own = sloshing(&experimental("spheric_10")?, 1)?[0];
    let source =
        (1.635 / 0.85, "SPHERIC test case 10: roll of 1.63 to 1.64 s at 0.85 of the period", Reference::Published);
    // 0.85 has two digits.
    rows.push(Row::new("X9", "first sloshing period", source, TAU / own, (0.01, "s")));
    Ok(rows)
}

/// The pitching strip of Akyildiz & Unal, 4° at 2 rad/s about the middle of the floor, in its steady state.
pub(super) fn pitching() -> Answer {
    const SOURCE: &str = "Akyildiz & Unal 2006, figure 5, digitised (PySPH), mean of three periods";
    let (angle, omega) = (4.0_f64.to_radians(), 2.0);
    let tank = experimental("akyildiz_2006")?;
    let liquid = rigid(&tank);
    let (ramp, last) = (40.0, 100.0);
    // θ sin ωt within a rise of sin² over `ramp`, whose derivatives are 1 % of those of the motion and are left out.
    let drive = |t: f64| {
        let share = if t < ramp { (0.5 * PI * t / ramp).sin().powi(2) } else { 1.0 };
        let tilt = share * angle * (omega * t).sin();
        Motion { tilt: [tilt, 0.0], angular: [-omega * omega * tilt, 0.0], ..Motion::default() }
    };
    let found = run(&liquid, &drive, last, None, |motion| motion);
    let range = |above: f64| {
        let probe = liquid.probe([tank.tank.shape.half_length(), 0.0], above - tank.liquid.fill_height);
        let steady = found.frames().filter(|frame| frame.time > last - 2.0 * TAU / omega);
        let pressures = steady.map(|frame| 1e-3 * probe.pressure(&liquid, &frame));
        pressures.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], p| [low.min(p), high.max(p)])
    };
    let ([low, high], [_, top]) = (range(0.17), range(0.45));
    // Crests 3.591, 3.578, 3.591 and troughs 2.797, 2.823, 2.866 kPa; 0.758, 0.768, 0.742 kPa where the dry gauge reads 0.245 kPa.
    Ok(vec![
        Row::new(
            "X10",
            "0.17 m above the floor: half the range of the pressure",
            experiment(0.379, SOURCE),
            0.5 * (high - low),
            (VALUE, "kPa"),
        ),
        Row::new(
            "X10",
            "0.45 m above the floor: largest pressure above the reading of the dry gauge",
            experiment(0.511, SOURCE),
            top,
            (VALUE, "kPa"),
        ),
    ])
}

/// The steel cylinder of MASTODON's examples 12a and 12b under a record.
fn steel_cylinder(record: Record) -> Result<Simulation, FeError> {
    let file = example("experiments/mastodon_12a.json")?;
    shaken(&file.case, record, file.fe)
}

/// Largest wave at r = 0.71 m [mm] and pressure at the foot [kPa].
fn wave_and_pressure(found: &Simulation) -> Result<[f64; 2], FeError> {
    let line = found.result.envelopes.iter().find(|line| line.id == OnWall::Pressure.id());
    let line = line.ok_or_else(|| FeError::Analysis("no envelope of the pressure".into()))?;
    let foot = line.max.first().zip(line.min.first()).map_or(f64::NAN, |(max, min)| max.max(-min));
    Ok([1e3 * peak(found, "wave_height_r_0.71")?, 1e-3 * foot])
}

/// Two cycles of sine.
pub(super) fn mastodon() -> Answer {
    const SOURCE: &str = "MASTODON example 12a (reference of Yu & Whittaker 2020), figure of the comparison";
    let record = motion(0.005, 800, |t| 0.025 * 9.81 * (PI * t).sin());
    let [wave, pressure] = wave_and_pressure(&steel_cylinder(record)?)?;
    let reference = |value| (value, SOURCE, Reference::Published);
    // Read from a figure to 1 mm; the pressure has one digit.
    Ok(vec![
        Row::new(
            "X2",
            "two cycles of 0.025 g at 0.5 Hz: largest wave at r = 0.71 m",
            reference(47.0),
            wave,
            (0.05, "mm"),
        ),
        Row::new("X2", "the same: largest pressure at the foot", reference(0.2), pressure, (0.25, "kPa")),
    ])
}

/// El Centro at 0.2 g, its time axis divided by √10, without its first half second.
pub(super) fn el_centro(records: &Records) -> Answer {
    const PREDICTED: &str = "predicted for MASTODON example 12b before its printed values were at hand";
    let original = records.get(EL_CENTRO_NGA)?;
    let factor = 0.2 * 9.81 / original.pga();
    let first = (0.5 / original.dt).round() as usize;
    let last = (22.64 / original.dt).round() as usize;
    let record = Record {
        name: "El Centro".into(),
        dt: original.dt / 10.0_f64.sqrt(),
        acceleration: original.acceleration[first..=last].iter().map(|a| factor * a).collect(),
        processing: Vec::new(),
    };
    let [wave, pressure] = wave_and_pressure(&steel_cylinder(record)?)?;
    let predicted = |value| (value, PREDICTED, Reference::Regression);
    Ok(vec![
        Row::new("X3", "El Centro at 0.2 g: largest wave at r = 0.71 m", predicted(19.3540), wave, (1e-3, "mm")),
        Row::new("X3", "the same: largest pressure at the foot", predicted(1.51125), pressure, (1e-3, "kPa")),
    ])
}
