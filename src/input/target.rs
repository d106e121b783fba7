//! A target spectrum from a CSV file: the period and one acceleration, with the unit in its name.

use std::path::Path;

use oscillator::STANDARD_GRAVITY;
use tank::hazard::SpectrumTable;

use crate::input::csv;
use crate::input::diagnostic::{Fault, Faults};
use crate::input::records::AccelerationUnit;
use files::code::Code;
use files::error::Error;

/// Names of the column of periods, without unit.
const PERIOD: [&str; 3] = ["period", "t", "tn"];
/// Names of the column of accelerations, without unit.
const ACCELERATION: [&str; 5] = ["acceleration", "sa", "se", "psa", "s_a"];
const ALLOWED: &str = "period_s with acceleration_g or acceleration_m_s2";

/// Words of a head, in lower case: `Sa [m/s2]` is `sa_m_s2`.
fn plain(head: &str) -> String {
    let spaced: String = head.to_lowercase().chars().map(|c| if c.is_alphanumeric() { c } else { ' ' }).collect();
    let words: Vec<&str> = spaced.split_whitespace().collect();
    words.join("_").replace("m_s²", "m_s2").replace("ms2", "m_s2")
}

/// Reads a target spectrum.
///
/// * `unit`: of the accelerations, where their column does not say it
///
/// Errors: a file that cannot be read; other columns; a unit that is missing; rows that do not begin at T = 0 or do not ascend.
pub fn read(path: &Path, unit: Option<AccelerationUnit>) -> Result<SpectrumTable, Error> {
    let table = csv::read(path)?;
    let mut faults = Faults::new();
    let (mut period, mut acceleration) = (None, None);
    for (i, cell) in table.head.iter().enumerate() {
        let name = plain(&cell.text);
        let (bare, factor) = match (name.strip_suffix("_g"), name.strip_suffix("_m_s2")) {
            (Some(bare), _) => (bare.to_owned(), Some(STANDARD_GRAVITY)),
            (_, Some(bare)) => (bare.to_owned(), Some(1.0)),
            _ => (name.clone(), unit.map(AccelerationUnit::si)),
        };
        if period.is_none() && PERIOD.contains(&name.strip_suffix("_s").unwrap_or(&name)) {
            period = Some(i);
        } else if acceleration.is_none() && ACCELERATION.contains(&bare.as_str()) {
            match factor {
                Some(factor) => acceleration = Some((i, factor)),
                None => {
                    let message = format!("the column `{}` does not say its unit", cell.text);
                    let fault = Fault::new(Code::TableColumn, message);
                    let fault = fault.at(cell.span.clone()).allowed("a name that ends with _g or _m_s2");
                    faults.push(fault.help("rename the column, or give --units"));
                    acceleration = Some((i, f64::NAN));
                }
            }
        }
    }
    let (Some(period), Some((acceleration, factor))) = (period, acceleration) else {
        let found: Vec<&str> = table.head.iter().map(|cell| cell.text.as_str()).collect();
        let fault = Fault::new(Code::TableShape, "the table is no spectrum").found(found.join(", ")).allowed(ALLOWED);
        return Err(Faults::from(fault).into_error(&table.source));
    };
    let mut rows = Vec::new();
    for row in &table.rows {
        let mut number = |i: usize| match row[i].text.parse::<f64>() {
            Ok(value) if value.is_finite() => value,
            _ => {
                let fault = Fault::new(Code::TableValue, "not a number").at(row[i].span.clone());
                faults.push(fault.found(row[i].text.clone()).allowed("a finite number"));
                f64::NAN
            }
        };
        rows.push([number(period), factor * number(acceleration)]);
    }
    if !faults.is_empty() {
        return Err(faults.into_error(&table.source));
    }
    SpectrumTable::new(rows).map_err(|wrong| {
        let fault = Fault::new(Code::TableValue, wrong.to_string())
            .allowed("T = 0 first, T ascending, accelerations greater than 0");
        let fault = match wrong.row().and_then(|row| table.rows.get(row)) {
            Some(row) => fault.at(csv::span(row)),
            None => fault,
        };
        Faults::from(fault).into_error(&table.source)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn table(text: &str, unit: Option<AccelerationUnit>) -> Result<SpectrumTable, String> {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("s.csv");
        std::fs::write(&path, text).unwrap();
        read(&path, unit).map_err(|e| e.to_string())
    }

    #[test]
    fn units_stand_in_the_head() {
        let g = STANDARD_GRAVITY;
        for (text, at) in [
            ("period_s,acceleration_g\n0,0.2\n1,0.5\n", 0.35 * g),
            ("T [s],Sa [g]\n0,0.2\n1,0.5\n", 0.35 * g),
            ("Period (s);Se (m/s2)\n0;2\n1;5\n", 3.5),
        ] {
            assert!((table(text, None).unwrap().at(0.5).unwrap() - at).abs() < 1e-12, "{text}");
        }
        let bare = "period,sa\n0,0.2\n1,0.5\n";
        assert!(table(bare, None).unwrap_err().contains("does not say its unit"));
        assert!((table(bare, Some(AccelerationUnit::G)).unwrap().peak() - 0.2 * g).abs() < 1e-12);
    }

    #[test]
    fn faults() {
        assert!(table("a,b\n0,1\n1,2\n", None).unwrap_err().contains("no spectrum"));
        assert!(table("T,sa_g\n0.1,1\n1,2\n", None).is_err(), "no row at T = 0");
        assert!(table("T,sa_g\n0,1\n1,x\n", None).unwrap_err().contains("s.csv:3:3"));
    }
}
