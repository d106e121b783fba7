//! `site.spectrum`: the user's spectrum, as a table or as parameters.

use files::code::Code;
use std::path::Path;

use oscillator::STANDARD_GRAVITY;
use tank::hazard::{SiteSpectrum, SpectrumForm, SpectrumParameters, SpectrumTable, TableFault};

use crate::input::csv;
use crate::input::diagnostic::{Fault, Faults, Source};
use crate::input::tank::choice::choice;
use crate::input::tank::read::{Field, FromNode, Opt, object, other_kind};
use crate::input::tank::resolver::{Resolver, range_fault};
use crate::input::tank::shape::{Book, Shape};
use crate::input::tank::syntax::{Kind, Node};
use crate::input::tank::values::{Acceleration, Number, Seconds};
use ::tank::words;
use results::InputValue;
use tank::keys::{Absent, Limits, default, without};

/// Control periods.
const PERIOD: Limits = Limits::above(0.0).to(100.0);
/// Fewest and most rows of a table.
const ROWS: (usize, usize) = (2, 10_000);
/// Largest acceleration of a row [m/s²].
const LARGEST: f64 = 10.0 * STANDARD_GRAVITY;
/// Usual largest acceleration of a table [m/s²]: 2.5 times that of `ag`, and the soil.
const USUAL: std::ops::RangeInclusive<f64> = 0.05 * STANDARD_GRAVITY..=3.0 * STANDARD_GRAVITY;
/// Longest period of a row [s].
const LONGEST: f64 = 100.0;

object! {
    /// Elastic spectrum of the design earthquake on the ground of the site, for all procedures, in place of those of the codes: a
    /// national annex, a hazard study, another country. Either a table (rows here or a file) or the parameters of the form of EN 1998-1
    /// 3.2.2.2. It is given before importance: EN 1998 multiplies by `ec8.importance`, API 650 by I of the seismic use group. Q of API
    /// 650 is not applied; with mapped accelerations in `api650`, 80 % of their spectrum are the lower limit.
    Spectrum {
        /// Rows [T, S_a] of period in s and horizontal pseudo-acceleration in `unit`, the first at T = 0, periods increasing. Between
        /// the rows S_a is linear in T; the table is not continued beyond its last row, which has to reach the sloshing period.
        table: Opt<Vec<Field<Row>>> [Limits::ANY.items(ROWS.0, ROWS.1)],
        /// Rows of the vertical spectrum, like `table`.
        vertical: Opt<Vec<Field<Row>>> [Limits::ANY.items(ROWS.0, ROWS.1)]
            = Absent::Without("shape of EN 1998-1:2004 3.2.2.3 with vertical_ratio"),
        /// Unit of the accelerations of `table` and `vertical`.
        unit ("m/s2"): Opt<AccelerationUnit>,
        /// Instead of `table`: a CSV file with the columns period_s and acceleration_g or acceleration_m_s2, and optionally vertical_g
        /// or vertical_m_s2; relative to the tank file.
        file ("spectrum.csv"): Opt<String>,
        /// Damping ratio of the table; others follow by η of EN 1998-1 3.2.2.2.
        damping (0.05): Opt<Number> [Limits::from(0.001).to(0.3)] = default(Number(0.05)),
        /// Reference peak ground acceleration a_gR on rock, of the parameters.
        ag ("0.25 g"): Opt<Acceleration>
            [Limits::from(1e-3).to(3.0 * STANDARD_GRAVITY).usual(0.02 * STANDARD_GRAVITY, 0.6 * STANDARD_GRAVITY)],
        /// Soil factor S.
        soil_factor (1.2): Opt<Number> [Limits::above(0.0).to(10.0).usual(0.8, 2.0)],
        /// Control period T_B in seconds.
        tb (0.15): Opt<Seconds> [PERIOD.usual(0.02, 0.5)],
        /// Control period T_C in seconds.
        tc (0.5): Opt<Seconds> [PERIOD.usual(0.1, 2.0)],
        /// Control period T_D in seconds.
        td (2.0): Opt<Seconds> [PERIOD.usual(0.8, 8.0)],
        /// Control period T_E in seconds of the displacement spectrum of EN 1998-1 annex A, beyond 4 s; together with tf.
        te (5.0): Opt<Seconds> [PERIOD] = without("the 1/T² branch has no end, on the safe side"),
        /// Control period T_F in seconds, together with te.
        tf (10.0): Opt<Seconds> [PERIOD] = without("the 1/T² branch has no end, on the safe side"),
        /// Vertical over horizontal peak ground acceleration, where there is no vertical table: over a_g of the parameters, over the
        /// row T = 0 of a table.
        vertical_ratio (0.45): Opt<Number> [Limits::above(0.0).to(2.0).usual(0.4, 1.1)] = default(Number(0.9)),
    }
}

words! {
    /// Unit of the accelerations of a table.
    pub(crate) AccelerationUnit {
        /// Standard gravity, 9.80665 m/s².
        G = "g",
        /// m/s².
        MetrePerSecondSquared = "m/s2",
    }
}

choice!(AccelerationUnit);

impl AccelerationUnit {
    /// In m/s².
    fn factor(self) -> f64 {
        match self {
            AccelerationUnit::G => STANDARD_GRAVITY,
            AccelerationUnit::MetrePerSecondSquared => 1.0,
        }
    }
}

/// A row of a table: two bare numbers.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Row([f64; 2]);

impl FromNode for Row {
    fn from_node(node: &Node, faults: &mut Faults) -> Option<Self> {
        let number = |node: &Node| match &node.kind {
            Kind::Number(text) => text.parse::<f64>().ok(),
            _ => None,
        };
        if let Kind::List(nodes) = &node.kind
            && let [period, acceleration] = nodes.as_slice()
            && let (Some(period), Some(acceleration)) = (number(period), number(acceleration))
        {
            return Some(Row([period, acceleration]));
        }
        other_kind(node, faults)
    }
    fn allowed() -> String {
        "a row [T, S_a] of two numbers without unit, the period in s and the acceleration in `unit`".into()
    }
    fn example() -> String {
        "[0.5, 0.3]".into()
    }
    fn shape(book: &mut Book) -> Shape {
        Shape::List(Box::new(Number::shape(book)))
    }
}

/// Tables in SI: horizontal, and vertical if given.
type Tables = (SpectrumTable, Option<SpectrumTable>);

/// The user's spectrum; none if it is not given, or faulty.
///
/// * `folder`: of the tank file
pub(super) fn spectrum(r: &mut Resolver<'_>, option: &Opt<Spectrum>, folder: &Path) -> Option<SiteSpectrum> {
    let field = option.given.as_ref()?;
    let given = field.value.as_ref()?;
    let damping = r.or_default(&given.damping);
    let vertical_ratio = r.or_default(&given.vertical_ratio);
    let form = match (&given.table.given, &given.file.given) {
        (Some(table), Some(_)) => {
            let message = "table and file exclude each other";
            let allowed = "one of them";
            r.refuse(Code::Exclusive, table, message, allowed);
            return None;
        }
        (None, None) => SpectrumForm::Parameters(parameters(r, field, given)?),
        (rows, file) => {
            alone(r, given)?;
            let (horizontal, vertical) = match (rows, file) {
                (Some(rows), _) => tables(r, given, rows)?,
                (None, Some(file)) => from_file(r, file, given, folder)?,
                (None, None) => return None,
            };
            let largest = horizontal.largest().1;
            if !USUAL.contains(&largest) {
                let found = format!("a largest acceleration of {:.4} g", largest / STANDARD_GRAVITY);
                r.unusual(&field.path, &found, "usual are 0.05 to 3 g");
            }
            SpectrumForm::Table { damping, horizontal, vertical }
        }
    };
    Some(SiteSpectrum { form, vertical_ratio })
}

/// Reports parameters beside a table.
fn alone(r: &mut Resolver<'_>, given: &Spectrum) -> Option<()> {
    let places = [
        given.ag.place(),
        given.soil_factor.place(),
        given.tb.place(),
        given.tc.place(),
        given.td.place(),
        given.te.place(),
        given.tf.place(),
    ];
    let place = places.into_iter().flatten().next();
    match place {
        None => Some(()),
        Some(place) => {
            let message = "a table and parameters exclude each other";
            let allowed = "one of them";
            r.refuse(Code::Exclusive, &place, message, allowed);
            None
        }
    }
}

/// The parameters; all are needed.
fn parameters(r: &mut Resolver<'_>, field: &Field<Spectrum>, given: &Spectrum) -> Option<SpectrumParameters> {
    for place in [given.vertical.place(), given.unit.place()].into_iter().flatten() {
        let message = "this belongs to a table";
        let allowed = "`table` or `file` with it";
        r.refuse(Code::DoesNotApply, &place, message, allowed);
    }
    if let Some(damping) = &given.damping.given {
        let message = "damping and parameters exclude each other";
        let allowed = "no damping: η gives every damping";
        r.refuse(Code::Exclusive, damping, message, allowed);
    }
    let missing: Vec<&str> = [
        ("ag", given.ag.given.is_none()),
        ("soil_factor", given.soil_factor.given.is_none()),
        ("tb", given.tb.given.is_none()),
        ("tc", given.tc.given.is_none()),
        ("td", given.td.given.is_none()),
    ]
    .into_iter()
    .filter_map(|(key, missing)| missing.then_some(key))
    .collect();
    let (ag, soil) = (r.optional(&given.ag), r.optional(&given.soil_factor));
    let [tb, tc, td] = [&given.tb, &given.tc, &given.td].map(|option| r.optional(option));
    let (te, tf) = (r.optional(&given.te), r.optional(&given.tf));
    if !missing.is_empty() {
        let allowed = "`table`, `file`, or all of ag, soil_factor, tb, tc, td";
        let fault = range_fault(Code::Incomplete, field, "an incomplete spectrum", allowed);
        r.faults.push(fault.found(format!("no {}", missing.join(", "))));
        return None;
    }
    let ends: Vec<(&Opt<Seconds>, f64)> = [&given.tb, &given.tc, &given.td, &given.te, &given.tf]
        .into_iter()
        .zip([tb, tc, td, te, tf])
        .filter_map(|(option, value)| Some((option, value?)))
        .collect();
    for pair in ends.windows(2) {
        if let Some(place) = pair[1].0.place()
            && pair[1].1 <= pair[0].1
        {
            let allowed = format!("more than {} s, tb < tc < td < te < tf", pair[0].1);
            r.refuse(Code::Contradiction, &place, "control periods out of order", &allowed);
        }
    }
    if let (Some(place), None) | (None, Some(place)) = (given.te.place(), given.tf.place()) {
        let message = "one control period without the other";
        let allowed = "te and tf together, or neither";
        r.refuse(Code::Incomplete, &place, message, allowed);
    }
    Some(SpectrumParameters {
        ag: ag?,
        soil: soil?,
        corners: [tb?, tc?, td?],
        long_corners: te.zip(tf).map(|(te, tf)| [te, tf]),
    })
}

/// The tables of the tank file.
fn tables(r: &mut Resolver<'_>, given: &Spectrum, rows: &Field<Vec<Field<Row>>>) -> Option<Tables> {
    let Some(unit) = &given.unit.given else {
        let message = "a table without unit";
        let allowed = "\"unit\": \"g\" or \"m/s2\" beside it";
        r.refuse(Code::Incomplete, rows, message, allowed);
        return None;
    };
    r.echo_given(unit);
    let factor = unit.value?.factor();
    let horizontal = table(r, rows, factor);
    let vertical = match &given.vertical.given {
        Some(rows) => Some(table(r, rows, factor)?),
        None => {
            r.not_given(&given.vertical);
            None
        }
    };
    Some((horizontal?, vertical))
}

/// A table of the tank file; its first fault is reported at its row.
///
/// * `factor`: unit of the accelerations [m/s²]
fn table(r: &mut Resolver<'_>, field: &Field<Vec<Field<Row>>>, factor: f64) -> Option<SpectrumTable> {
    let rows = field.value.as_ref()?;
    if !r.sized(field, "rows of a spectrum") {
        return None;
    }
    let values: Option<Vec<[f64; 2]>> = rows.iter().map(|row| row.value.map(|Row([t, a])| [t, factor * a])).collect();
    let values = values?;
    match checked(values) {
        Ok(table) => {
            echo(r, &field.path, &table);
            Some(table)
        }
        Err((row, message)) => {
            let place = row.and_then(|row| rows.get(row));
            let fault = match place {
                Some(place) => Fault::new(Code::TableValue, message).at(place.span.clone()).path(&place.path),
                None => Fault::new(Code::TableValue, message).at(field.span.clone()).path(&field.path),
            };
            let found = place.and_then(|p| p.value).map(|Row([t, a])| format!("[{t}, {a}]"));
            r.faults.push(fault.found(found.unwrap_or_default()).allowed(ALLOWED));
            None
        }
    }
}

/// What is allowed for all rows together.
const ALLOWED: &str = "rows [T, S_a] with T = 0 first, T increasing up to 100 s at most, S_a positive and at most 10 g";

/// The table, or the index of the faulty row and the message.
fn checked(rows: Vec<[f64; 2]>) -> Result<SpectrumTable, (Option<usize>, String)> {
    let beyond = |row: &[f64; 2]| row[0] > LONGEST || row[1] > LARGEST;
    let beyond = rows.iter().position(beyond);
    let table = SpectrumTable::new(rows).map_err(|fault: TableFault| (fault.row(), fault.to_string()))?;
    match beyond {
        Some(row) => Err((Some(row), "a period or acceleration out of range".into())),
        None => Ok(table),
    }
}

/// Echoes a table by its size and range.
fn echo(r: &mut Resolver<'_>, path: &str, table: &SpectrumTable) {
    let (at, largest) = table.largest();
    let text = format!(
        "{} rows up to {} s, {:.4} g at T = 0, largest {:.4} g at {at} s",
        table.rows().len(),
        table.longest(),
        table.peak() / STANDARD_GRAVITY,
        largest / STANDARD_GRAVITY
    );
    r.echo.push(InputValue { path: path.into(), text, default: false, source: String::new() });
}

/// The tables of a CSV file; its first fault is reported at the key, with the line of the file.
fn from_file(r: &mut Resolver<'_>, file: &Field<String>, given: &Spectrum, folder: &Path) -> Option<Tables> {
    for place in [given.vertical.place(), given.unit.place()].into_iter().flatten() {
        let message = "this belongs to `table`; a file has its own columns";
        let allowed = "`file` without it";
        r.refuse(Code::DoesNotApply, &place, message, allowed);
    }
    let name = r.text(file)?;
    let read = csv::text(&folder.join(&name)).and_then(|source| {
        let columns = columns(&source)?;
        Ok((source, columns))
    });
    match read {
        Ok((source, (horizontal, vertical))) => {
            let hash = csv::short_hash(&source);
            echo(r, &format!("{} (sha256 {hash}…)", file.path), &horizontal);
            if let Some(vertical) = &vertical {
                echo(r, &format!("{}, vertical column", file.path), vertical);
            }
            Some((horizontal, vertical))
        }
        Err(message) => {
            let allowed = "a CSV file with period_s,acceleration_g or period_s,acceleration_m_s2";
            r.refuse(Code::TableShape, file, &message, allowed);
            None
        }
    }
}

/// The tables of a CSV text, or what is wrong with it and in which line.
fn columns(source: &Source) -> Result<Tables, String> {
    let at = |place: usize, what: &str| format!("{}:{}: {what}", source.name, source.line_column(place).0);
    let rows = csv::rows(source).map_err(|what| format!("{}: {what}", source.name))?;
    let Some((head, rows)) = rows.split_first() else { return Err(format!("{}: an empty file", source.name)) };
    let mut units = Vec::new();
    for (i, cell) in head.iter().enumerate() {
        let unit = match (i, cell.text.as_str()) {
            (0, "period_s") => 1.0,
            (1, "acceleration_g") | (2, "vertical_g") => STANDARD_GRAVITY,
            (1, "acceleration_m_s2") | (2, "vertical_m_s2") => 1.0,
            (_, name) => return Err(at(cell.span.start, &format!("unexpected column `{name}`"))),
        };
        units.push(unit);
    }
    if head.len() < 2 {
        return Err(at(0, "fewer than two columns"));
    }
    if !(ROWS.0..=ROWS.1).contains(&rows.len()) {
        return Err(format!(
            "{}: found {} rows of numbers, expected {} to {}",
            source.name,
            rows.len(),
            ROWS.0,
            ROWS.1
        ));
    }
    let mut values = Vec::new();
    for row in rows {
        let start = csv::span(row).start;
        if row.len() != head.len() {
            return Err(at(start, "a row with another number of cells than the head"));
        }
        let mut numbers = Vec::new();
        for (cell, unit) in row.iter().zip(&units) {
            let number: f64 =
                cell.text.parse().map_err(|_| at(cell.span.start, &format!("`{}` is not a number", cell.text)))?;
            numbers.push(number * unit);
        }
        values.push((start, numbers));
    }
    let table = |column: usize| {
        let rows = values.iter().map(|(_, n)| [n[0], n[column]]).collect();
        checked(rows).map_err(|(row, what)| at(row.and_then(|row| values.get(row)).map_or(0, |v| v.0), &what))
    };
    let vertical = if head.len() > 2 { Some(table(2)?) } else { None };
    Ok((table(1)?, vertical))
}
