//! Result of the reader of a format, and the steps that all readers share: a limit on faults, and the choice of unit and time
//! step from file and options.

use super::options::ReadOptions;
use super::unit::AccelerationUnit;
use crate::input::diagnostic::{Fault, Faults};
use files::code::Code;

/// Reading stops after this many faults.
const MAX_FAULTS: usize = 20;

/// Result of the reader of a format: numbers in the unit of the file.
pub(super) struct Draft {
    pub title: Option<String>,
    pub format: String,
    /// The channel that was read of several.
    pub channel: Option<String>,
    pub unit: AccelerationUnit,
    pub unit_source: String,
    pub dt: f64,
    pub values: Vec<f64>,
    /// Byte of the text at which each value begins.
    pub places: Vec<u32>,
    pub notes: Vec<String>,
    /// Corner of the low-cut filter [Hz], where the file gives it.
    pub low_cut: Option<f64>,
}

/// Bytes of the number or word that begins at `start`.
pub(super) fn token_at(text: &str, start: usize) -> std::ops::Range<usize> {
    let rest = text.get(start..).unwrap_or_default();
    let end = rest.find(|c: char| c.is_whitespace() || c == ',' || c == ';').unwrap_or(rest.len());
    start..start + end
}

/// Collects faults up to the limit.
pub(super) struct Collector {
    faults: Faults,
}

impl Collector {
    pub(crate) fn new() -> Collector {
        Collector { faults: Faults::new() }
    }

    /// Adds a fault; returns true at the limit.
    #[must_use]
    pub(crate) fn push(&mut self, fault: Fault) -> bool {
        self.faults.push(fault);
        if self.faults.list().len() < MAX_FAULTS {
            return false;
        }
        self.faults.push(Fault::new(Code::RecordFormat, format!("reading stopped after {MAX_FAULTS} faults")));
        true
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.faults.is_empty()
    }

    pub(crate) fn finish(self) -> Result<(), Faults> {
        if self.faults.is_empty() { Ok(()) } else { Err(self.faults) }
    }
}

/// The unit of the numbers: that of the file, that of the options, or a fault. `named` is the unit in the file with
/// its source in words.
pub(super) fn settle_unit(
    named: Option<(AccelerationUnit, String)>,
    options: &ReadOptions,
    example: &str,
) -> Result<(AccelerationUnit, String), Fault> {
    match (named, options.unit) {
        (Some((unit, source)), None) => Ok((unit, source)),
        (Some((unit, source)), Some(given)) if unit == given => Ok((unit, source)),
        (Some((unit, source)), Some(given)) => Err(Fault::new(Code::RecordUnit, "the file and --units disagree")
            .found(format!("{unit} in the {source}, --units {given}"))
            .allowed("one unit")
            .help("remove --units, or correct the header")),
        (None, Some(given)) => Ok((given, format!("--units {given}"))),
        (None, None) => Err(Fault::new(Code::RecordUnit, "the file does not give the unit of acceleration")
            .allowed(format!("{example}, or --units with one of {}", AccelerationUnit::ALLOWED))
            .help("give the unit; it is never guessed from the size of the numbers")),
    }
}

/// The channel that is wanted, from 0: the only one, or that of `--channel`, its number or a part of its name.
///
/// Errors: several without a choice; a choice that is none of them, or more than one.
pub(super) fn choose(names: &[String], options: &ReadOptions) -> Result<usize, Fault> {
    let listed = || {
        let all: Vec<String> = names.iter().enumerate().map(|(i, name)| format!("{}: {name}", i + 1)).collect();
        all.join("; ")
    };
    let Some(wanted) = &options.channel else {
        if names.len() == 1 {
            return Ok(0);
        }
        let fault = Fault::new(Code::RecordChannel, "the file has several channels").found(listed());
        return Err(fault.allowed("--channel with the number or the name of one of them, or FILE#CHANNEL"));
    };
    let number = wanted.parse::<usize>().ok().and_then(|n| n.checked_sub(1)).filter(|i| *i < names.len());
    let folded = |text: &str| printable(text).to_lowercase();
    let all = |fits: &dyn Fn(&str) -> bool| -> Vec<usize> {
        (0..names.len()).filter(|i| fits(&folded(&names[*i]))).collect()
    };
    let wanted_name = folded(wanted);
    let equal = all(&|name| name == wanted_name);
    // A number is a whole word of the name, `360` of `Chan 1: 360 Deg`, not a part of `m/s2`.
    let digits = wanted_name.bytes().all(|b| b.is_ascii_digit());
    let within = all(&|name| match digits {
        true => name.split(|c: char| !c.is_alphanumeric()).any(|word| word == wanted_name),
        false => name.contains(&wanted_name),
    });
    match (number, equal.as_slice(), within.as_slice()) {
        (Some(i), ..) => Ok(i),
        (_, [i], _) | (_, [], [i]) => Ok(*i),
        (None, [], []) => Err(Fault::new(Code::RecordChannel, "the file has no such channel")
            .found(format!("--channel {}", printable(wanted)))
            .allowed(listed())),
        _ => Err(Fault::new(Code::RecordChannel, "several channels have such a name")
            .found(format!("--channel {}", printable(wanted)))
            .allowed(listed())),
    }
}

/// The time step: that of the file, that of the options, or `None`.
pub(super) fn settle_dt(named: Option<f64>, options: &ReadOptions) -> Result<Option<f64>, Fault> {
    match (named, options.dt) {
        (Some(dt), Some(given)) if (dt - given).abs() > 1e-6 * dt => {
            Err(Fault::new(Code::TimeStep, "the file and --dt disagree")
                .found(format!("a step of {dt} s in the file, --dt {given}"))
                .help("remove --dt; to stretch the time axis use the time factor"))
        }
        (Some(dt), _) => Ok(Some(dt)),
        (None, given) => Ok(given),
    }
}

/// Without control characters and surplus spaces.
pub(super) fn printable(text: &str) -> String {
    let words: Vec<&str> =
        text.split(|c: char| c.is_whitespace() || c.is_control()).filter(|w| !w.is_empty()).collect();
    words.join(" ")
}
