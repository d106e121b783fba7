//! Incremental dynamic analysis of strip 8.4: `strip_ida RECORD.csv [name=value …] SCALE …`, scales in percent.
//!
//! The record is a table of time and acceleration [m/s²] at 0.02 s. Names: `elements`, `layers`, `softening`, `step`, `until`,
//! `radius` (ρ_∞), `points` (2, 3 Gauss; 0 Lobatto), `damping` (0 mass-proportional, 1 by group, 2 Rayleigh at two modes),
//! `ratio`, `threads`; `columns` (elements of a displacement liquid from wall to wall), `opening`, `place` (1: joints open by the pressure at their
//! place), `rotation` (K_rot), `tangential`, `shells`, `elastic` (1: concrete that does not crack). The linear response
//! is `cargo run --release -p verification -- C11 --records FOLDER`.

use std::error::Error;
use std::time::Instant;

use engines::strip::{Contact, LiquidMesh, StripDamping, StripModel, StripQuake};
use fem::analysis::damping::Rayleigh;
use fem::analysis::march::Outcome;
use fem::analysis::newton::Options as Newton;
use fem::analysis::scheme::TimeScheme;
use fem::element::fibre_beam::{Options, Points};
use fem::progress::Silent;
use oscillator::record::Record;
use verification::strip::{elastic_tank, reinforced_tank, with_cracking_shells};

fn record(path: &str) -> Result<Record, Box<dyn Error>> {
    let text = std::fs::read_to_string(path)?;
    let value = |line: &str| line.split(',').nth(1).unwrap_or("").trim().parse::<f64>();
    Ok(Record {
        name: path.into(),
        dt: 0.02,
        acceleration: text.lines().skip(1).map(value).collect::<Result<_, _>>()?,
        processing: Vec::new(),
    })
}

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let (options, scales): (Vec<&String>, Vec<&String>) = arguments.iter().skip(1).partition(|a| a.contains('='));
    let get = |name: &str, default: f64| -> f64 {
        let found = options.iter().find_map(|o| o.strip_prefix(name)?.strip_prefix('='));
        found.and_then(|v| v.parse().ok()).unwrap_or(default)
    };
    let points = match get("points", 2.0) as usize {
        2 => Points::Gauss2,
        3 => Points::Gauss3,
        _ => Points::Lobatto3,
    };
    let ratio = get("ratio", 0.022);
    let damping = match get("damping", 0.0) as usize {
        0 => StripDamping::Rayleigh(Rayleigh::mass_proportional(2.3863, ratio)),
        1 => StripDamping::ByGroup { wall: ratio, sloshing: 0.005 },
        _ => StripDamping::Rayleigh(Rayleigh::fit((2.39, 0.01), (3.53, 0.01), false)?),
    };
    let path = arguments.first().ok_or("no record given")?;
    let record = record(path)?;
    if scales.is_empty() {
        return Err("no scale given".into());
    }
    let mut tank = reinforced_tank(
        get("elements", 15.0) as usize,
        get("layers", 30.0) as usize,
        get("softening", 3e-4),
        Options { points, second_order: false },
    )?;
    if get("elastic", 0.0) > 0.0 {
        tank = elastic_tank(get("elements", 15.0) as usize, tank.options)?;
    }
    if get("shells", 0.0) > 0.0 {
        tank = with_cracking_shells(tank, get("layers", 30.0) as usize, get("softening", 3e-4))
            .map_err(|error| error.to_string())?;
    }
    let columns = get("columns", 0.0) as usize;
    let given = |name: &str| Some(get(name, 0.0)).filter(|v| *v > 0.0);
    if columns > 0 {
        tank.mesh = Some(LiquidMesh {
            rotation_penalty: given("rotation"),
            tangential: get("tangential", 0.0),
            at_place: get("place", 0.0) > 0.0,
            ..LiquidMesh::new(columns, 2.06e9)
        });
    }
    if get("opening", 0.0) > 0.0 {
        tank.contact = Contact::Joined { opens: true, penalty: given("penalty") };
    }
    let strip = StripModel::new(&tank, damping)?;
    println!(
        "{} unknowns, wall mode {:.2} rad/s, damping {:.3} %",
        strip.model.dofs().len(),
        strip.wall_frequency(),
        100.0 * strip.wall_ratio()
    );
    let mut quake = StripQuake::new(record, get("step", 2.5e-3));
    quake.until = Some(get("until", 12.0));
    if get("opening", 0.0) > 0.0 {
        quake.newton = Newton::for_contact();
    }
    quake.scheme = TimeScheme::GeneralizedAlpha { radius: get("radius", 0.9) };
    let scales: Vec<f64> = scales.iter().map(|s| s.parse::<f64>().map(|s| s / 100.0)).collect::<Result<_, _>>()?;
    println!(
        "  scale  top mm  wave m  base kNm  bar MPa  crack to m  first crack: t s, z m, kNm  cuts  steps  imbalance"
    );
    let clock = Instant::now();
    let levels = strip.incremental(&quake, &scales, get("threads", 2.0) as usize, &Silent, |level| {
        eprintln!("{:6.1} s: {:.0} %", clock.elapsed().as_secs_f64(), 100.0 * level.scale);
    })?;
    for level in &levels {
        let d = level.demand();
        let first = d
            .first_crack
            .map_or("-".to_owned(), |c| format!("{:.3}, {:.3}, {:.2}", c.time, c.height, c.base_moment / 1e3));
        let steps: u64 = level.walls.iter().map(|w| w.steps).sum();
        println!(
            "{:6.0} %  {:6.3}  {:.4}  {:8.2}  {:7.1}  {:10.3}  {first:>26}  {:5}  {steps:6}  {:.1e}",
            100.0 * level.scale,
            1e3 * d.deflection,
            d.wave,
            d.base_moment / 1e3,
            d.bar_stress / 1e6,
            d.highest_crack,
            level.halvings(),
            level.imbalance(),
        );
        for (wall, side) in level.walls.iter().zip(["+", "-"]) {
            println!(
                "        {side} {:.3} mm, {:.1} J, {} iterations",
                1e3 * wall.demand.deflection,
                wall.hysteretic,
                wall.iterations
            );
            if wall.outcome != Outcome::Completed {
                println!("        {side} {:?} at {:.3} s", wall.outcome, wall.time);
            }
        }
    }
    println!("{:.1} s in all", clock.elapsed().as_secs_f64());
    Ok(())
}
