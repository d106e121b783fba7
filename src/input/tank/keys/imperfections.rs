//! `analysis.imperfections`: deviations of a cylinder's wall from the perfect shape, as waves or as a table.

use files::code::Code;
use std::collections::BTreeMap;
use std::f64::consts::{PI, TAU};
use std::path::Path;

use tank::imperfection::{self, Imperfections, Profile, Table, Wave};
use tank::units::Dimension;
use tank::{Shape, Tank};

use crate::input::csv;
use crate::input::diagnostic::{Faults, Source};
use crate::input::tank::read::{Field, FromNode, Opt, object, other_kind, wrong_kind, wrong_value};
use crate::input::tank::resolver::{Resolver, like_field, range_fault};
use crate::input::tank::shape::{Book, Shape as Looks};
use crate::input::tank::syntax::{Kind, Node};
use crate::input::tank::values::{Angle, Length, Number, Whole, quantity};
use results::InputValue;
use tank::keys::{Absent, Limits, default};

/// Largest deviation over the radius: far beyond every tolerance, and of what a shell with this radius can be.
const LARGEST: f64 = 0.05;
/// Most half waves over the height.
const MOST_HALF_WAVES: u32 = 20;
/// Most points of a profile.
const MOST_POINTS: usize = 200;
/// Fewest angles of a table, and the widest gap between two of them [rad].
const ANGLES: (usize, f64) = (8, PI / 3.0);
/// Words of a profile.
const WORDS: &str = "\"constant\", \"linear\", \"half_sine\" or \"sine_k\" with k from 1 to 20, or a list of at least two pairs [height, \
                     factor] such as [[\"0 m\", 0], [\"8 m\", 1]], heights ascending";

object! {
    /// A deviation of the wall from the perfect cylinder, outwards positive: either a wave w = amplitude · shape(z) · cos n(θ −
    /// phase), or a table.
    Imperfection {
        /// Number of waves around the tank.
        n (5): Opt<Whole> [Limits::count(0, 100)],
        /// Amplitude, outwards positive where the cosine is; at most a twentieth of the radius.
        amplitude ("3 mm"): Opt<Length> [Limits::from(-10.0).to(10.0)],
        /// Shape over the height z of the wall: "constant", "linear" (zero at the base, one at the top), "half_sine", "sine_k" with k half
        /// waves, or pairs [height, factor] with a smooth curve between them, constant beyond the ends.
        shape: Opt<Over> = Absent::Follows("constant"),
        /// Angle of a crest from the direction of shaking.
        phase ("30 deg"): Opt<Angle> [Limits::from(-TAU).to(TAU)] = default(Angle(0.0)),
        /// Instead of a wave: a CSV file with the columns theta_deg or theta_rad, z_m or z_mm, w_m or w_mm and a row for every angle at
        /// every height; relative to the tank file.
        table ("roundness.csv"): Opt<String>,
        /// Factor on the deviations of the table.
        factor (1.0): Opt<Number> [Limits::from(-1000.0).to(1000.0)] = default(Number(1.0)),
    }
}

/// A shape over the height.
#[derive(Clone, Debug)]
pub(crate) struct Over(Profile);

impl FromNode for Over {
    fn from_node(node: &Node, faults: &mut Faults) -> Option<Self> {
        match &node.kind {
            Kind::Text(text) => {
                let profile = match text.as_str() {
                    "constant" => Some(Profile::Constant),
                    "linear" => Some(Profile::Linear),
                    "half_sine" => Some(Profile::Sine(1)),
                    other => other
                        .strip_prefix("sine_")
                        .and_then(|k| k.parse().ok())
                        .filter(|k| (1..=MOST_HALF_WAVES).contains(k))
                        .map(Profile::Sine),
                };
                if profile.is_none() {
                    faults.push(wrong_value(Code::BadForm, node, "not a shape over the height", WORDS));
                }
                profile.map(Over)
            }
            Kind::List(pairs) => points(node, pairs, faults).map(|p| Over(Profile::Points(p))),
            _ => {
                faults.push(wrong_kind(node, WORDS));
                None
            }
        }
    }
    fn allowed() -> String {
        WORDS.into()
    }
    fn example() -> String {
        "\"linear\"".into()
    }
    fn shape(book: &mut Book) -> Looks {
        Looks::Either("linear", Box::new(Looks::List(Box::new(Pair::shape(book)))))
    }
}

/// A pair of height and factor.
struct Pair([f64; 2]);

impl FromNode for Pair {
    fn from_node(node: &Node, faults: &mut Faults) -> Option<Self> {
        if let Kind::List(items) = &node.kind
            && let [z, factor] = items.as_slice()
        {
            let z = quantity(z, Dimension::Length, faults)?;
            return Some(Pair([z, quantity(factor, Dimension::Dimensionless, faults)?]));
        }
        other_kind(node, faults)
    }
    fn allowed() -> String {
        "a pair [height, factor] such as [\"4 m\", 0.5]".into()
    }
    fn example() -> String {
        "[\"4 m\", 0.5]".into()
    }
    fn shape(_: &mut Book) -> Looks {
        Looks::List(Box::new(Looks::Text))
    }
}

fn points(node: &Node, pairs: &[Node], faults: &mut Faults) -> Option<Vec<[f64; 2]>> {
    let points: Option<Vec<[f64; 2]>> = pairs.iter().map(|p| Pair::from_node(p, faults).map(|p| p.0)).collect();
    let points = points?;
    let ascending = points.windows(2).all(|p| p[0][0] < p[1][0]) && points.iter().flatten().all(|v| v.is_finite());
    if ascending && (2..=MOST_POINTS).contains(&points.len()) {
        return Some(points);
    }
    faults.push(wrong_value(Code::BadForm, node, "not a shape over the height", WORDS));
    None
}

/// The imperfections; those that are faulty are left out.
///
/// * `folder`: of the tank file
pub(super) fn imperfections(
    r: &mut Resolver<'_>,
    given: Option<&Opt<Vec<Field<Imperfection>>>>,
    tank: Option<&Tank>,
    folder: &Path,
) -> Imperfections {
    let Some(field) = given.and_then(|option| option.given.as_ref()) else { return Imperfections::NONE };
    r.sized(field, "imperfections");
    let given = field.value.iter().flatten();
    let parts: Vec<_> = given.filter_map(|item| one(r, item, item.value.as_ref()?, folder)).collect();
    let all = Imperfections { parts };
    if let Some(tank) = tank {
        let Shape::Cylinder { radius } = tank.shape else {
            let message = "a rectangle has no waves around it";
            let allowed = "a tank of shape \"cylinder\"";
            let fault = range_fault(Code::DoesNotApply, field, message, allowed);
            r.faults.push(fault.help("remove analysis.imperfections"));
            return Imperfections::NONE;
        };
        let (largest, ..) = all.largest(tank.wall_height());
        if largest > LARGEST * radius {
            let limit = like_field(field, LARGEST * radius);
            let message = "the wall deviates by more than a twentieth of its radius";
            let allowed = format!("at most {limit} in all");
            let fault = range_fault(Code::OutOfRange, field, message, &allowed);
            r.faults.push(fault.found(like_field(field, largest)));
        }
    }
    all
}

fn one(
    r: &mut Resolver<'_>,
    field: &Field<Imperfection>,
    given: &Imperfection,
    folder: &Path,
) -> Option<imperfection::Imperfection> {
    let (n, amplitude) = (&given.n.given, &given.amplitude.given);
    let n = n.as_ref().and_then(|n| r.count(n));
    let amplitude = amplitude.as_ref().map(|a| r.number(a));
    if let Some(shape) = &given.shape.given {
        r.echo_given(shape);
    }
    let (phase, factor) = (r.or_default(&given.phase), r.or_default(&given.factor));
    let wave = [given.n.place(), given.amplitude.place(), given.shape.place(), given.phase.place()];
    match (&given.table.given, wave.into_iter().flatten().next()) {
        (Some(_), Some(place)) => {
            let message = "a table and a wave exclude each other";
            let allowed = "one of them";
            r.refuse(Code::Exclusive, &place, message, allowed);
            None
        }
        (Some(name), None) => table(r, name, factor, folder).map(imperfection::Imperfection::Table),
        (None, _) => {
            let missing = match (&given.n.given, &given.amplitude.given) {
                (Some(_), Some(_)) => "",
                (None, Some(_)) => "no n",
                (Some(_), None) => "no amplitude",
                (None, None) => "neither n and amplitude nor table",
            };
            if !missing.is_empty() {
                let message = "an incomplete imperfection";
                let allowed = "n and amplitude, or table";
                let fault = range_fault(Code::Incomplete, field, message, allowed);
                r.faults.push(fault.found(missing));
                return None;
            }
            if let Some(place) = given.factor.place() {
                let message = "this belongs to `table`";
                let allowed = "amplitude alone for a wave";
                r.refuse(Code::DoesNotApply, &place, message, allowed);
            }
            let profile = match &given.shape.given {
                Some(shape) => shape.value.clone()?.0,
                None => Profile::Constant,
            };
            Some(imperfection::Imperfection::Wave(Wave {
                n: n?,
                amplitude: amplitude.filter(|a| a.is_finite())?,
                profile,
                phase,
            }))
        }
    }
}

/// The table of a CSV file; its first fault is reported at the key, with the line of the file.
fn table(r: &mut Resolver<'_>, file: &Field<String>, factor: f64, folder: &Path) -> Option<Table> {
    let name = r.text(file)?;
    let read = csv::text(&folder.join(&name)).and_then(|source| {
        let table = grid(&source, factor)?;
        Ok((source, table))
    });
    match read {
        Ok((source, table)) => {
            let hash = csv::short_hash(&source);
            let largest = table.w.iter().flatten().fold(0.0_f64, |m, w| m.max(w.abs()));
            r.echo.push(InputValue {
                path: format!("{} (sha256 {hash}…)", file.path),
                text: format!(
                    "{} angles at {} heights, largest deviation {:.4} mm",
                    table.theta.len(),
                    table.z.len(),
                    1e3 * largest
                ),
                default: false,
                source: String::new(),
            });
            Some(table)
        }
        Err(message) => {
            let fault = range_fault(
                Code::TableShape,
                file,
                &message,
                "a CSV file with theta_deg,z_m,w_mm (or theta_rad, z_mm, w_m), a row for every angle at every height, angles from \
                 0 to below 360° in at least 8 places at most 60° apart",
            );
            r.faults.push(fault);
            None
        }
    }
}

/// The grid of a CSV text, or what is wrong with it and in which line.
fn grid(source: &Source, factor: f64) -> Result<Table, String> {
    let at = |place: usize, what: &str| format!("{}:{}: {what}", source.name, source.line_column(place).0);
    let rows = csv::rows(source).map_err(|what| format!("{}: {what}", source.name))?;
    let Some((head, rows)) = rows.split_first() else { return Err(format!("{}: an empty file", source.name)) };
    let unit = |(i, cell): (usize, &csv::Cell)| match (i, cell.text.as_str()) {
        (0, "theta_deg") => Ok(PI / 180.0),
        (0, "theta_rad") | (1, "z_m") | (2, "w_m") => Ok(1.0),
        (1, "z_mm") | (2, "w_mm") => Ok(1e-3),
        (_, name) => Err(at(cell.span.start, &format!("unexpected column `{name}`"))),
    };
    let units: Vec<f64> = head.iter().enumerate().map(unit).collect::<Result<_, _>>()?;
    if head.len() != 3 {
        return Err(at(0, "other than three columns"));
    }
    // Angles and heights are told apart to a millionth of a radian and of a metre.
    let key = |value: f64| (value * 1e6).round() as i64;
    let mut found: BTreeMap<(i64, i64), (f64, f64, f64)> = BTreeMap::new();
    for row in rows {
        let start = csv::span(row).start;
        if row.len() != 3 {
            return Err(at(start, "a row with another number of cells than the head"));
        }
        let mut numbers = [0.0; 3];
        for ((number, cell), unit) in numbers.iter_mut().zip(row).zip(&units) {
            let read: Option<f64> = cell.text.parse().ok().filter(|v: &f64| v.is_finite());
            let fault = || at(cell.span.start, &format!("`{}` is not a number", cell.text));
            *number = unit * read.ok_or_else(fault)?;
        }
        let [theta, z, w] = numbers;
        if !(0.0..TAU - 1e-6).contains(&theta) || z < 0.0 {
            let what = "an angle outside 0 to below 360°, or a height below the base";
            return Err(at(start, what));
        }
        if found.insert((key(z), key(theta)), (z, theta, factor * w)).is_some() {
            return Err(at(start, "an angle twice at one height"));
        }
    }
    let mut out = Table { theta: Vec::new(), z: Vec::new(), w: Vec::new() };
    let mut last = None;
    for ((level, _), (z, theta, w)) in found {
        if last != Some(level) {
            last = Some(level);
            out.z.push(z);
            out.w.push(Vec::new());
        }
        if out.w.len() == 1 {
            out.theta.push(theta);
        }
        let row = out.w.last_mut().map_or(0, |row| {
            row.push(w);
            row.len()
        });
        if out.theta.get(row - 1).is_none_or(|t| key(*t) != key(theta)) {
            return Err(format!("{}: other angles at z = {z} m than at the lowest height", source.name));
        }
    }
    let gaps = out.theta.windows(2).map(|t| t[1] - t[0]);
    let widest = gaps.chain(out.theta.first().zip(out.theta.last()).map(|(a, b)| a + TAU - b)).fold(0.0, f64::max);
    if out.theta.len() < ANGLES.0 || widest > ANGLES.1 + 1e-6 || out.w.iter().any(|w| w.len() != out.theta.len()) {
        return Err(format!(
            "{}: found {} angles, at most {:.0}° apart, not all at every height",
            source.name,
            out.theta.len(),
            widest.to_degrees()
        ));
    }
    Ok(out)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Result<Table, String> {
        grid(&Source::new("w.csv", text), 1.0)
    }

    #[test]
    fn a_grid_in_any_order_is_read_in_si() {
        let mut text = "theta_deg,z_m,w_mm\n".to_owned();
        for k in (0..8).rev() {
            for z in [2.0, 0.0] {
                text += &format!("{},{z},{}\n", 45 * k, f64::from(k) * z);
            }
        }
        let table = read(&text).unwrap();
        assert_eq!((table.theta.len(), table.z.clone()), (8, vec![0.0, 2.0]));
        assert!((table.theta[3] - 0.75 * PI).abs() < 1e-12 && (table.w[1][3] - 0.006).abs() < 1e-12);
        for (bad, what) in [
            ("theta_deg,z_m,w_mm\n0,0,1\n", "found 1 angles"),
            ("theta_deg,z_m,w\n", "unexpected column `w`"),
            ("theta_deg,z_m,w_mm\n0,0,x\n", "w.csv:2: `x` is not a number"),
            ("theta_deg,z_m,w_mm\n360,0,1\n", "outside 0 to below 360"),
            ("theta_deg,z_m,w_mm\n0,0,1\n0,0,2\n", "w.csv:3: an angle twice"),
            (&text.replace("45,2,2\n", ""), "not all at every height"),
        ] {
            let message = read(bad).unwrap_err();
            assert!(message.contains(what) || message.contains("other angles"), "{message}");
        }
    }
}
