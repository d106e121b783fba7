//! Tanks that were measured.
//!
//! Source:    named in each row; measured values that were read from another author's table, figure or file name that as well
//! Model:     harmonic engine with its default mesh and damping unless a row says otherwise; nothing is fitted to a measurement
//! Reference: the measured value, or the value of another program where the kind of the row says so
//! Tolerance: set before the values were computed: as the source states it; else 2 % of a frequency or a time of a history (what
//!            three digits and a curve read from a figure are good for), 15 % of a wave, a pressure or a stress. A row outside of it
//!            is shown without a tolerance, and its remark says what was asked for and what is known of the difference.

mod shells;
mod waves;

use std::path::Path;

use oscillator::record::Record;
use tank::Case;
use tank::case::GroundMotion;
use tankcheck::input::TankFile;

use crate::records::{EL_CENTRO, EL_CENTRO_NGA, PACOIMA, PARKFIELD};
use crate::{Benchmark, Part, Reference, Row};
use engines::{FeError, Options, Simulation, simulate};

/// The page.
pub(crate) const BENCHMARK: Benchmark = Benchmark {
    id: "experiments",
    title: "Tanks that were measured",
    model: "Harmonic engine with its default mesh, 0.5 % damping of sloshing and 2 % of the wall unless a row says otherwise; nothing is \
            fitted. Tolerances set beforehand: as the source states it, else 2 % of a frequency or of a time, 15 % of a wave, a pressure \
            or a stress. A row outside of it has none and says what was asked for. Aluminium tank of Manos and Clough (3.66 m across, 1.525 m of water, \
            1 % and 2 % damping, records at 0.5 g with the time axis divided by √3); Perspex cylinder of Pal et al. (9.6 cm); strips of \
            Faltinsen et al. (1.73 × 0.6 m), Chen et al. (0.8 × 0.1 m) and Bäuerlein and Avila (0.5 × 0.4 m) between stiff walls; oil \
            tanks of Tomakomai; and three tanks of other programs (MASTODON, code_aster, SPHERIC). Their files are examples/experiments. \
            Not compared, because the record of its table is public under LGPL alone and is not copied: X1, Mir et al. 2021 (steel cylinder of R \
            0.76 m with 1.62 m of water, 0.13 g, MASTODON example 12c); the linear wave at its gauge is 77.5 mm, with the crest of waves that are not small \
            83 mm, without the rotation of the table of 0.28 rad/s²; 82 mm were measured.",
    ids: &[
        ("X2", "steel cylinder of R 0.79 m under two cycles of 0.025 g, against another program"),
        ("X3", "the same under El Centro, predicted"),
        ("X4", "strip at 0.9 of its sloshing period: crests and troughs in time"),
        ("X5", "shallow strip at 0.9 of its sloshing frequency: heights and times, and its two tones"),
        ("X6", "free decay in a strip"),
        ("X7", "periods of oil tanks under a long-period earthquake"),
        ("X8", "modes of a small cylinder with water, against another program"),
        ("X9", "sloshing period of the box with lateral impact"),
        ("X10", "pitching strip: pressures on the wall"),
        ("manos-clough", "aluminium tank on a shaking table: wave and stresses"),
        ("pal", "Perspex cylinder: sloshing frequencies and wave"),
    ],
    parts: &[
        Part::Fast(shells::pal),
        Part::Fast(shells::modes),
        Part::Fast(waves::faltinsen),
        Part::Fast(waves::chen),
        Part::Fast(waves::free),
        Part::Fast(waves::pitching),
        Part::Fast(waves::mastodon),
        Part::Records(&[EL_CENTRO, PARKFIELD, PACOIMA, EL_CENTRO_NGA], |records| {
            let mut rows = shells::manos_clough(records)?;
            rows.extend(waves::el_centro(records)?);
            Ok(rows)
        }),
    ],
};

/// Asked of a wave, a pressure or a stress, and of a frequency or a time.
const VALUE: f64 = 0.15;
const TIME: f64 = 0.02;

/// A measured value and where it stands.
fn experiment(value: f64, source: &'static str) -> (f64, &'static str, Reference) {
    (value, source, Reference::Experiment)
}

/// The row; where it is outside of the tolerance that was asked for, for comparison only and with what is known of it.
fn judged(row: Row, why: &str) -> Row {
    if row.holds() || !row.computed.is_finite() {
        return row;
    }
    let remark = format!("outside of the {} % that were asked for; {why}", (100.0 * row.tolerance).round());
    Row { tolerance: f64::INFINITY, ..row }.remarked(remark)
}

/// A tank file of the folder `examples`.
fn example(path: &str) -> Result<TankFile, FeError> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples").join(path);
    tankcheck::input::read_tank(&path).map_err(|error| FeError::Analysis(error.to_string()))
}

/// The tank of a file of `examples/experiments`.
fn experimental(name: &str) -> Result<Case, FeError> {
    Ok(example(&format!("experiments/{name}.json"))?.case)
}

/// The harmonic engine under a motion.
fn shaken(case: &Case, record: Record, options: Options) -> Result<Simulation, FeError> {
    let mut case = case.clone();
    case.ground_motion = Some(GroundMotion { horizontal: record, transverse: None, vertical: None });
    simulate(&case, &Options { mesh_error: false, ..options })
}

/// The motion of a function of time, with `count` steps of `dt` [s].
fn motion(dt: f64, count: usize, acceleration: impl Fn(f64) -> f64) -> Record {
    Record {
        name: "motion".into(),
        dt,
        acceleration: (0..=count).map(|k| acceleration(k as f64 * dt)).collect(),
        processing: Vec::new(),
    }
}

/// The history of a channel.
fn history<'a>(found: &'a Simulation, id: &str) -> Result<&'a [f64], FeError> {
    let place = found.series.ids.iter().position(|own| own == id);
    let history = place.and_then(|place| found.series.columns.get(place));
    history.map(Vec::as_slice).ok_or_else(|| FeError::Analysis(format!("no history {id}")))
}

/// Largest absolute value of a channel.
fn peak(found: &Simulation, id: &str) -> Result<f64, FeError> {
    Ok(history(found, id)?.iter().fold(0.0, |most, value| value.abs().max(most)))
}

/// Time and value of the largest value of a history within [s], times `sign`.
fn extreme(values: &[f64], dt: f64, [from, to]: [f64; 2], sign: f64) -> [f64; 2] {
    let within = |k: &usize| (from..=to).contains(&(*k as f64 * dt));
    let larger = |best: [f64; 2], k: usize| {
        if sign * values[k] > best[1] { [k as f64 * dt, sign * values[k]] } else { best }
    };
    (0..values.len()).filter(within).fold([f64::NAN, f64::NEG_INFINITY], larger)
}
