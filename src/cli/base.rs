//! `tankcheck base`: uplift of the bottom plate and the moment that the base holds, statically.

use std::path::{Path, PathBuf};

use ::base::{Base, BaseError, Lifted, Missing, Origin, Point, Rocking, Suction, Top, Turn};
use serde_json::{Value, json};
use tank::units::{Dimension, UnitError, display, parse};

use crate::cli::global::{Format, Global, show};
use crate::cli::table::Table;
use crate::cli::terminal::warn;
use crate::error::{EXIT_OK, Error};
use crate::input;
use files::code::{Code, Warning};
use files::text;
use report::words::base as words;

/// Largest uplift and settlement of the rim over the radius: strips side by side are for deflections that are small against it.
const REACH: f64 = 0.2;
/// Largest rotation [rad].
const ROTATION: f64 = 0.05;
/// Uplifts without `--uplift` [m].
const UPLIFTS: [f64; 6] = [1e-3, 10e-3, 20e-3, 50e-3, 100e-3, 200e-3];
/// Rotations without `--rotation` [rad].
const ROTATIONS: [f64; 5] = [2e-4, 5e-4, 1e-3, 2e-3, 5e-3];
/// Parts of the half circumference at which the rim of a rotation is given.
const PLACES: u32 = 36;
/// Factors on the modulus of the ground.
const BAND: [f64; 3] = [1.0 / 3.0, 1.0, 3.0];

/// Arguments.
#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  tankcheck base tank.json
  tankcheck base tank.json --uplift 1mm,10mm,50mm --rotation 5e-4,1e-3 --format json
  tankcheck base tank.json --elastic --bottom-pressure 40kPa

The strip is a metre of the bottom plate at the rim: what it takes to lift it. Moment and rotation are those of the whole
base, strips side by side around a foot that warps as the rim of the wall lets it (`tank.roof.holds`, `tank.rings`). Both are
given on the ground of the file, and on ground three times softer and stiffer.")]
pub(crate) struct Args {
    /// The tank (`-` reads standard input).
    #[arg(value_name = "TANK")]
    tank: PathBuf,
    /// Uplifts of the rim, as `10mm`, separated by commas; below 0 it sinks.
    #[arg(long, value_name = "LIST", value_delimiter = ',', allow_hyphen_values = true)]
    uplift: Option<Vec<String>>,
    /// Rotations of the base [rad], separated by commas.
    #[arg(long, value_name = "LIST", value_delimiter = ',', allow_hyphen_values = true)]
    rotation: Option<Vec<String>>,
    /// Leave the bottom plate elastic.
    #[arg(long)]
    elastic: bool,
    /// Hydrodynamic pressure on the bottom at the rim, suction on the lifted side, varying with the cosine [default: none].
    #[arg(long, value_name = "PRESSURE", allow_hyphen_values = true)]
    bottom_pressure: Option<String>,
    /// Form of the output.
    #[arg(long, value_enum, default_value_t = Format::Human)]
    format: Format,
}

/// What is computed on one ground.
struct OnGround {
    factor: f64,
    base: Base,
    rest: Point,
    strip: Vec<Result<Point, (f64, BaseError)>>,
    turns: Vec<Result<Turn, (f64, BaseError)>>,
}

/// Runs the subcommand; returns the exit code.
pub(crate) fn run(args: Args, _global: &Global) -> Result<u8, Error> {
    let tank = input::read_tank(&args.tank)?;
    for warning in &tank.warnings {
        warn("", warning);
    }
    if tank.case.tank.staging.is_some() {
        return Err(elevated(&args.tank));
    }
    let base = Base::of(&tank.case).map_err(|missing| absent(&args.tank, missing))?;
    let base = if args.elastic { base.elastic() } else { base };
    if !base.yields() && !args.elastic {
        warn("", &Warning::new(Code::BaseModel, words::ELASTIC));
    }
    if tank.case.tank.corrodes() {
        warn("", &Warning::new(Code::BaseModel, words::AS_BUILT));
    }
    if tank.case.tank.anchors.is_some() {
        warn("", &Warning::new(Code::BaseModel, words::ANCHORS));
    }
    let suction = pressure(args.bottom_pressure.as_deref(), base.pressure)?;
    let uplifts = list(
        "--uplift",
        args.uplift.as_deref(),
        &UPLIFTS,
        Dimension::Length,
        [-REACH * base.radius, REACH * base.radius],
    )?;
    let rotations = list("--rotation", args.rotation.as_deref(), &ROTATIONS, Dimension::Angle, [0.0, ROTATION])?;
    let grounds = BAND.map(|factor| on_ground(factor, &base, suction, &uplifts, &rotations));
    let grounds = grounds.into_iter().collect::<Result<Vec<_>, _>>()?;
    let name = &tank.case.name;
    let limit = base.suction(suction).filter(|_| !rotations.is_empty());
    if let Some(exceeded) = limit.filter(|limit| !limit.holds()) {
        warn("", &Warning::new(Code::LimitExceeded, words::softened(&exceeded.lifts_too_far())));
    }
    show(
        args.format,
        || human(name, &base, suction, &grounds),
        || document(name, &base, (suction, limit), &grounds),
        || Ok(csv(&grounds)),
    )?;
    Ok(EXIT_OK)
}

fn absent(file: &Path, missing: Missing) -> Error {
    unsupported(file, words::absent(missing == Missing::Cylinder, missing == Missing::Plate))
}

fn elevated(file: &Path) -> Error {
    unsupported(file, words::ELEVATED)
}

fn unsupported(file: &Path, (found, help): (&str, &str)) -> Error {
    Error::input(Code::Unsupported, format!("{found}\n  --> {}\n  help: {help}", text::line(&file.to_string_lossy())))
}

fn pressure(given: Option<&str>, rest: f64) -> Result<f64, Error> {
    let Some(given) = given else { return Ok(0.0) };
    let value = parse(given, Dimension::Stress).map_err(|e| unreadable("--bottom-pressure", given, &e))?;
    // Curves are kept down to half of the pressure at rest.
    if (0.0..=base::FOLLOWED * rest).contains(&value) {
        return Ok(value);
    }
    let allowed = format!("0 to {}, half of the pressure at rest", display(0.5 * rest, Dimension::Stress));
    Err(usage("--bottom-pressure", given, &allowed))
}

fn usage(option: &str, found: &str, allowed: &str) -> Error {
    Error::value(format!("{option}: found `{}`, expected {allowed}", text::line(found)))
}

/// A value that is not a quantity of its dimension.
fn unreadable(option: &str, found: &str, error: &UnitError) -> Error {
    let help = error.help().map_or(String::new(), |help| format!("\n  help: {help}"));
    let found = text::line(found);
    Error::value(format!("{option}: found `{found}`: {error}{help}"))
}

fn list(
    option: &str,
    given: Option<&[String]>,
    default: &[f64],
    dimension: Dimension,
    [low, high]: [f64; 2],
) -> Result<Vec<f64>, Error> {
    let Some(given) = given else { return Ok(default.iter().copied().filter(|v| *v <= high).collect()) };
    let mut values = Vec::with_capacity(given.len());
    for text in given {
        let bare = (dimension == Dimension::Angle).then(|| text.trim().parse().ok()).flatten();
        let value = match bare {
            Some(value) => value,
            None => parse(text, dimension).map_err(|e| unreadable(option, text, &e))?,
        };
        if !(low..=high).contains(&value) {
            let allowed = format!("{} to {}", display(low, dimension), display(high, dimension));
            return Err(usage(option, text, &allowed));
        }
        values.push(value);
    }
    values.sort_by(f64::total_cmp);
    values.dedup();
    Ok(values)
}

fn on_ground(factor: f64, base: &Base, suction: f64, uplifts: &[f64], rotations: &[f64]) -> Result<OnGround, Error> {
    let base = base.on(factor * base.modulus);
    let strip = base.strip(base.pressure - suction)?;
    let rest = Lifted::at_rest(&strip, base.weight)?;
    let mut points = Vec::with_capacity(uplifts.len());
    // Both ways from rest: a plate that yields remembers its way.
    let (mut up, mut down) = (rest.clone(), rest.clone());
    for &w in uplifts.iter().rev().filter(|w| **w < rest.uplift()) {
        points.push(down.lift_to(w).map(|()| down.point()).map_err(|e| (w, e)));
    }
    points.reverse();
    for &w in uplifts.iter().filter(|w| **w >= rest.uplift()) {
        points.push(up.lift_to(w).map(|()| up.point()).map_err(|e| (w, e)));
    }
    let largest = rotations.iter().copied().fold(0.0, f64::max);
    let rocking =
        (!rotations.is_empty()).then(|| rocking(&base, largest, suction, rest.uplift().min(0.0))).transpose()?;
    let turns =
        rocking.map_or(Vec::new(), |r| rotations.iter().map(|&psi| r.at(psi, suction).map_err(|e| (psi, e))).collect());
    Ok(OnGround { factor, rest: rest.point(), base, strip: points, turns })
}

/// * `rest`: displacement of the rim at rest [m], below 0 where the ground gives way
fn rocking(base: &Base, rotation: f64, suction: f64, rest: f64) -> Result<Rocking, BaseError> {
    let reach = (rotation * base.radius).min(REACH * base.radius / 2.0);
    // The centre stays near the ground.
    base.rocking(rest - reach - 0.02, base.rise() * reach + 0.02, suction > 0.0)
}

fn origin(origin: Origin) -> &'static str {
    match origin {
        Origin::Given => "given",
        Origin::Waves => "shear_wave_velocity",
        Origin::Assumed(_) => "assumed",
    }
}

fn rim(top: Option<Top>) -> Option<&'static str> {
    top.map(|top| match top {
        Top::Round => "round",
        Top::Rings => "rings",
        Top::Free => "free",
    })
}

fn point(p: &Point) -> Value {
    json!({
        "uplift_m": p.uplift,
        "hold_down_N_per_m": p.hold_down,
        "rotation_rad": p.rotation,
        "rim_moment_Nm_per_m": p.rim_moment,
        "axial_force_N_per_m": p.axial_force,
        "lifted_width_m": p.lifted_width,
        "plastic_rotation_rad": p.plastic_rotation,
    })
}

/// * `radius`: R [m]; angles of its rim are from the lifted side
fn turn(t: &Turn, thickness: f64, radius: f64) -> Value {
    json!({
        "rotation_rad": t.rotation,
        "moment_Nm": t.moment,
        "uplift_m": t.uplift,
        "toe_force_N_per_m": t.toe_force,
        "toe_stress_Pa": t.toe_force / thickness,
        "lifted_angle_rad": 2.0 * t.lifted_angle(radius),
        "rim": (0..=PLACES).map(|i| f64::from(i) * 180.0 / f64::from(PLACES)).map(|degrees| json!({
            "angle_deg": degrees,
            "uplift_m": t.rim(radius, degrees.to_radians()),
        })).collect::<Vec<_>>(),
    })
}

fn ground(on: &OnGround) -> Value {
    let thickness = on.base.wall_thickness();
    let strip = on.strip.iter().map(|p| match p {
        Ok(p) => point(p),
        Err((w, e)) => json!({ "uplift_m": w, "error": e.to_string() }),
    });
    let turns = on.turns.iter().map(|t| match t {
        Ok(t) => turn(t, thickness, on.base.radius),
        Err((psi, e)) => json!({ "rotation_rad": psi, "error": e.to_string() }),
    });
    json!({
        "factor": on.factor,
        "modulus_N_per_m3": on.base.modulus,
        "rest": point(&on.rest),
        "strip": strip.collect::<Vec<_>>(),
        "moment_rotation": turns.collect::<Vec<_>>(),
    })
}

fn document(name: &str, base: &Base, (suction, limit): (f64, Option<Suction>), grounds: &[OnGround]) -> Value {
    let band: Vec<Value> = grounds.iter().map(ground).collect();
    let own = grounds.iter().position(|g| g.factor == 1.0).map_or(&Value::Null, |i| &band[i]);
    json!({
        "name": name,
        "radius_m": base.radius,
        "plate_thickness_m": base.plate().thickness,
        "plate_yields": base.yields(),
        "wall_thickness_m": base.wall_thickness(),
        "wall_weight_N_per_m": base.weight,
        "pressure_at_rest_Pa": base.pressure,
        "bottom_pressure_Pa": suction,
        "bottom_pressure_limit": limit.map(|limit| json!({
            "share": limit.share,
            "limit": limit.limit,
            "holds": limit.holds(),
        })),
        "modulus_N_per_m3": base.modulus,
        "modulus_origin": origin(base.origin),
        "rim": rim(base.top()),
        "rest": own["rest"],
        "strip": own["strip"],
        "moment_rotation": own["moment_rotation"],
        "band": band,
    })
}

fn csv(grounds: &[OnGround]) -> String {
    let mut text = String::from(
        "kind,modulus_N_per_m3,uplift_m,hold_down_N_per_m,rotation_rad,rim_moment_Nm_per_m,axial_force_N_per_m,lifted_width_m,plastic_rotation_rad,moment_Nm,toe_force_N_per_m,toe_stress_Pa\n",
    );
    for on in grounds {
        let k = on.base.modulus;
        for p in on.strip.iter().flatten() {
            text += &format!(
                "strip,{k},{},{},{},{},{},{},{},,,\n",
                p.uplift, p.hold_down, p.rotation, p.rim_moment, p.axial_force, p.lifted_width, p.plastic_rotation
            );
        }
        for t in on.turns.iter().flatten() {
            let stress = t.toe_force / on.base.wall_thickness();
            text += &format!("base,{k},{},,{},,,,,{},{},{stress}\n", t.uplift, t.rotation, t.moment, t.toe_force);
        }
    }
    text
}

fn human(name: &str, base: &Base, suction: f64, grounds: &[OnGround]) -> String {
    let assumed = matches!(base.origin, Origin::Assumed(_));
    let mut out = format!("{}\n\n", text::line(name));
    out += &words::strip(base.plate().thickness, base.pressure - suction, base.weight, base.yields());
    out += "\n";
    out += &words::ground(base.modulus, assumed, base.origin == Origin::Waves);
    out += "\n";
    out += base.foot();
    out += "\n\n";
    let on = grounds.iter().find(|g| g.factor == 1.0).unwrap_or(&grounds[0]);
    let mut table = Table::new(words::STRIP_HEAD);
    for p in &on.strip {
        match p {
            Ok(p) => table.row([
                format!("{:.1}", 1e3 * p.uplift),
                format!("{:.2}", p.hold_down / 1e3),
                format!("{:.4}", p.rotation),
                format!("{:.2}", p.rim_moment / 1e3),
                format!("{:.1}", p.axial_force / 1e3),
                format!("{:.3}", p.lifted_width),
                format!("{:.3}", p.plastic_rotation),
            ]),
            Err((w, _)) => {
                table.row(std::iter::once(format!("{:.1}", 1e3 * w)).chain((0..6).map(|_| words::NONE.to_owned())))
            }
        };
    }
    out += &format!("{table}{}\n", words::STRIP_HEADS);
    for (w, error) in on.strip.iter().filter_map(|p| p.as_ref().err()) {
        out += &format!("{}\n", words::no_uplift(*w, &error.to_string()));
    }
    if !on.turns.is_empty() {
        let mut table = Table::new(words::TURN_HEAD);
        for i in 0..on.turns.len() {
            table.row(turn_row(grounds, i));
        }
        out += &format!("\n{table}{}\n", words::TURN_HEADS);
        for g in grounds {
            // Larger rotations fail for the same reason.
            if let Some((psi, error)) = g.turns.iter().find_map(|t| t.as_ref().err()) {
                out += &format!("{}\n", words::no_turn(*psi, g.base.modulus, &error.to_string()));
            }
        }
    }
    out
}

/// A rotation: moment, lift and stress on the three grounds.
fn turn_row(grounds: &[OnGround], i: usize) -> Vec<String> {
    let psi = match &grounds[0].turns[i] {
        Ok(t) => t.rotation,
        Err((psi, _)) => *psi,
    };
    let cells = |value: &dyn Fn(&Turn, &Base) -> String| -> String {
        let each = grounds.iter().map(|g| match &g.turns[i] {
            Ok(t) => value(t, &g.base),
            Err(_) => words::NONE.to_owned(),
        });
        each.collect::<Vec<_>>().join(" / ")
    };
    vec![
        format!("{:.2}", 1e3 * psi),
        cells(&|t, _| format!("{:.1}", t.moment / 1e6)),
        cells(&|t, _| format!("{:.1}", 1e3 * t.uplift)),
        cells(&|t, base| format!("{:.1}", t.toe_force / base.wall_thickness() / 1e6)),
    ]
}
