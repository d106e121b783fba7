//! UNAM (Mexico), `ARCHIVO ESTANDAR DE ACELERACION` 2.0: a header of lines `KEY : value` in Spanish with a value for every channel, then their
//! columns.

use super::block::{lines, place};
use super::draft::{Draft, choose, printable, settle_dt, settle_unit};
use super::header::unknown_unit;
use super::keyed::Keyed;
use super::number::parse;
use crate::input::diagnostic::{Fault, Faults};
use crate::input::records::{AccelerationUnit, ReadOptions};
use files::code::Code;

/// Lines within which the title stands.
const TITLE: usize = 20;

/// Whether the text is one.
pub(super) fn sniff(text: &str) -> bool {
    text.lines()
        .take(TITLE)
        .any(|line| line.trim_start().to_ascii_uppercase().starts_with("ARCHIVO ESTANDAR DE ACELERACION"))
}

/// The value of a channel in `/0.005/0.005/0.005`.
fn of_channel(text: &str, channel: usize) -> &str {
    text.trim_start_matches('/').split('/').nth(channel).unwrap_or_default().trim()
}

/// Reads the text; call [`sniff`] before.
pub(super) fn read(text: &str, options: &ReadOptions) -> Result<Draft, Faults> {
    let lines = lines(text);
    let header = Keyed { lines: &lines, what: "UNAM" };
    let (at, directions) = header.get("ORIENTACION C1-C6")?;
    let names: Vec<String> =
        directions.trim_start_matches('/').split('/').map(printable).filter(|n| !n.is_empty()).collect();
    if names.is_empty() {
        return Err(Fault::new(Code::CutOff, "this UNAM file does not name its channels").at(place(at)).into());
    }
    let wanted = choose(&names, options)?;
    let step = header.positive("INTERVALO DE MUESTREO, C1-C6", |v| of_channel(v, wanted))?;
    let (_, samples) = header.get("NUM. TOTAL DE MUESTRAS, C1-C6")?;
    let samples = parse(of_channel(samples, wanted)).unwrap_or_default();
    let (at, written) = header.get("UNIDADES DE LOS DATOS")?;
    let bare = written.split('(').next().unwrap_or_default();
    let unit = AccelerationUnit::parse(bare).ok_or_else(|| unknown_unit(written).at(place(at)))?;
    let (unit, unit_source) = settle_unit(Some((unit, format!("header, `{}`", printable(at.1)))), options, "")?;
    let dt = settle_dt(Some(step), options)?.unwrap_or(step);
    // The second ruler behind the title ends the names of the columns.
    let title = lines.iter().position(|l| l.1.to_ascii_uppercase().starts_with("DATOS DE ACELERACION"));
    let mut rulers =
        lines.iter().enumerate().skip(title.unwrap_or(lines.len())).filter(|(_, l)| l.1.starts_with("----"));
    let first = rulers.nth(1).map(|(i, _)| i + 1).ok_or_else(|| {
        Fault::new(Code::CutOff, "this UNAM file ends before its accelerations").help("the file may have been cut off")
    })?;
    let (values, places) = header.column(first, (wanted, names.len()), samples)?;
    let of = |key: &str| header.get(key).map(|(_, v)| printable(v)).unwrap_or_default();
    Ok(Draft {
        title: Some(format!("{} {} {}", of("CLAVE DE LA ESTACION"), names[wanted], of("FECHA DEL SISMO"))),
        format: format!("UNAM (channel {} of {}, {samples} samples)", wanted + 1, names.len()),
        channel: (names.len() > 1).then(|| names[wanted].clone()),
        unit,
        unit_source,
        dt,
        values,
        places,
        notes: Vec::new(),
        low_cut: None,
    })
}
