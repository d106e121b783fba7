//! Free vibration after the record.

use serde::{Deserialize, Serialize};

/// Length of the free vibration that a history continues with after its record.
///
/// Long sloshing may peak after the ground has come to rest.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum AfterRecord {
    /// Periods of the first sloshing mode.
    Periods(f64),
    /// Time [s]; 0 ends the history with the record.
    Time(f64),
}

impl AfterRecord {
    /// That of the linear engines: a full swing to either side after the last pulse of the ground, and one more.
    pub const DEFAULT: AfterRecord = AfterRecord::Periods(2.0);
    /// The history ends with its record.
    pub const NONE: AfterRecord = AfterRecord::Time(0.0);

    /// Duration [s].
    ///
    /// * `period`: of the first sloshing mode [s]; 0 without one
    pub fn duration(self, period: f64) -> f64 {
        match self {
            AfterRecord::Periods(count) => count * period,
            AfterRecord::Time(time) => time,
        }
    }
}

impl Default for AfterRecord {
    fn default() -> Self {
        AfterRecord::DEFAULT
    }
}

crate::value::own!(AfterRecord);

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn durations() {
        assert_eq!(AfterRecord::DEFAULT.duration(3.0), 6.0);
        assert_eq!(AfterRecord::NONE.duration(3.0), 0.0);
        assert_eq!(AfterRecord::Time(12.5).duration(3.0), 12.5);
    }
}
