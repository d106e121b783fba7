//! Design spectrum of the site that the user gives in place of that of a code.

use serde::{Deserialize, Serialize};

/// Elastic spectrum of the design earthquake on the ground of the site, before any importance factor. All procedures take it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SiteSpectrum {
    /// Its form.
    pub form: SpectrumForm,
    /// Vertical over horizontal peak ground acceleration, where there is no vertical table.
    pub vertical_ratio: f64,
}

/// Form of a [`SiteSpectrum`].
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum SpectrumForm {
    /// Ordinates at periods.
    Table {
        /// Damping ratio of the ordinates.
        damping: f64,
        /// Horizontal spectrum.
        horizontal: SpectrumTable,
        /// Vertical spectrum.
        vertical: Option<SpectrumTable>,
    },
    /// The branches of EN 1998-1 3.2.2.2 with other parameters.
    Parameters(SpectrumParameters),
}

/// Parameters of a spectrum of the form of EN 1998-1 3.2.2.2, at any damping by its η.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct SpectrumParameters {
    /// Peak ground acceleration a_gR on rock [m/s²].
    pub ag: f64,
    /// Soil factor S.
    pub soil: f64,
    /// Control periods T_B, T_C, T_D [s].
    pub corners: [f64; 3],
    /// Control periods T_E, T_F of the displacement spectrum of annex A [s]; without them the 1/T² branch has no end.
    pub long_corners: Option<[f64; 2]>,
}

/// Rows of period [s] and pseudo-acceleration [m/s²]: at least two, periods increasing from 0, accelerations positive. Between the
/// rows the acceleration is linear in the period.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "Vec<[f64; 2]>", into = "Vec<[f64; 2]>")]
pub struct SpectrumTable {
    rows: Vec<[f64; 2]>,
}

/// Why rows are not a spectrum; with the index of the row.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum TableFault {
    /// Fewer than two rows.
    #[error("a spectrum of fewer than two rows")]
    Short,
    /// A period or acceleration that is not a finite number.
    #[error("a number that is not finite")]
    NotFinite(usize),
    /// The first period is not zero.
    #[error("the first row is not that of the period 0, the peak ground acceleration")]
    First,
    /// A period that is not larger than the one before.
    #[error("a period that is not larger than that of the row before")]
    Order(usize),
    /// An acceleration that is not positive.
    #[error("an acceleration that is not positive")]
    NotPositive(usize),
}

impl TableFault {
    /// Index of the faulty row; none for the table as a whole.
    pub fn row(self) -> Option<usize> {
        match self {
            TableFault::Short => None,
            TableFault::First => Some(0),
            TableFault::NotFinite(row) | TableFault::Order(row) | TableFault::NotPositive(row) => Some(row),
        }
    }
}

impl SpectrumTable {
    /// A table of rows (period [s], acceleration [m/s²]).
    ///
    /// Errors: the first fault, see [`TableFault`].
    pub fn new(rows: Vec<[f64; 2]>) -> Result<SpectrumTable, TableFault> {
        if rows.len() < 2 {
            return Err(TableFault::Short);
        }
        for (i, [period, acceleration]) in rows.iter().enumerate() {
            if !(period.is_finite() && acceleration.is_finite()) {
                return Err(TableFault::NotFinite(i));
            }
            if *acceleration <= 0.0 {
                return Err(TableFault::NotPositive(i));
            }
            match i {
                0 if *period != 0.0 => return Err(TableFault::First),
                0 => {}
                _ if *period <= rows[i - 1][0] => return Err(TableFault::Order(i)),
                _ => {}
            }
        }
        Ok(SpectrumTable { rows })
    }

    /// The rows (period [s], acceleration [m/s²]).
    pub fn rows(&self) -> &[[f64; 2]] {
        &self.rows
    }

    /// Acceleration at the period 0, the peak ground acceleration [m/s²].
    pub fn peak(&self) -> f64 {
        self.rows.first().map_or(0.0, |row| row[1])
    }

    /// Period [s] and acceleration [m/s²] of the first largest row.
    pub fn largest(&self) -> (f64, f64) {
        let first = (0.0, self.peak());
        self.rows.iter().fold(first, |best, row| if row[1] > best.1 { (row[0], row[1]) } else { best })
    }

    /// Longest period of the table [s].
    pub fn longest(&self) -> f64 {
        self.rows.last().map_or(0.0, |row| row[0])
    }

    /// Acceleration [m/s²] at a period [s], linear between the rows; none outside of the table.
    pub fn at(&self, period: f64) -> Option<f64> {
        if !(0.0..=self.longest()).contains(&period) {
            return None;
        }
        let next = self.rows.partition_point(|row| row[0] < period).max(1);
        let ([t_0, a_0], [t_1, a_1]) = (self.rows[next - 1], self.rows[next]);
        Some(a_0 + (period - t_0) / (t_1 - t_0) * (a_1 - a_0))
    }
}

impl TryFrom<Vec<[f64; 2]>> for SpectrumTable {
    type Error = TableFault;
    fn try_from(rows: Vec<[f64; 2]>) -> Result<SpectrumTable, TableFault> {
        SpectrumTable::new(rows)
    }
}

impl From<SpectrumTable> for Vec<[f64; 2]> {
    fn from(table: SpectrumTable) -> Vec<[f64; 2]> {
        table.rows
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn linear_between_the_rows_and_nothing_beyond() {
        let table = SpectrumTable::new(vec![[0.0, 1.0], [0.2, 3.0], [1.0, 3.0], [2.0, 1.0]]).unwrap();
        for (period, value) in [(0.0, 1.0), (0.1, 2.0), (0.2, 3.0), (0.7, 3.0), (1.5, 2.0), (2.0, 1.0)] {
            let found = table.at(period).unwrap();
            assert!((found - value).abs() < 1e-15, "{period}: {found}");
        }
        assert_eq!((table.at(2.0 + 1e-9), table.at(-0.1), table.at(f64::NAN)), (None, None, None));
        assert_eq!((table.peak(), table.largest(), table.longest()), (1.0, (0.2, 3.0), 2.0));
    }

    #[test]
    fn faults() {
        for (rows, fault) in [
            (vec![[0.0, 1.0]], TableFault::Short),
            (vec![[0.1, 1.0], [0.2, 1.0]], TableFault::First),
            (vec![[0.0, 1.0], [0.2, 2.0], [0.2, 1.0]], TableFault::Order(2)),
            (vec![[0.0, 1.0], [0.2, -2.0]], TableFault::NotPositive(1)),
            (vec![[0.0, 1.0], [f64::NAN, 2.0]], TableFault::NotFinite(1)),
            (vec![[0.0, 1.0], [1.0, f64::INFINITY]], TableFault::NotFinite(1)),
        ] {
            assert_eq!(SpectrumTable::new(rows), Err(fault));
        }
        assert!(serde_json::from_str::<SpectrumTable>("[[0, 1]]").is_err());
    }
}
