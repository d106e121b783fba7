//! Whole results of single rows: histories and report, as `compare` gives them, of the worst row of each tank.

use fem::progress::Progress;
use files::code::Code;

use super::damage::Worst;
use super::plan::Plan;
use super::task;
use crate::error::Error;
use crate::input::study::StudyInput;
use crate::pipeline::{self, Outcome};
use results::Results;

/// Runs a row again, with everything that a report shows.
///
/// * `tank`: its name
///
/// Errors: a tank or record that is not in the plan, or not as it was; an engine that fails.
pub fn run(
    study: &StudyInput,
    plan: &Plan,
    tank: &str,
    row: &Worst,
    progress: &dyn Progress,
) -> Result<Outcome, Error> {
    let number = plan.tanks.iter().position(|known| known.id == tank);
    let record = plan.records.iter().position(|known| known.id == row.record);
    let (Some(number), Some(record)) = (number, record) else {
        let text = format!("the tank `{tank}` or the record `{}` is not in the plan", row.record);
        return Err(Error::input(Code::UnknownId, text));
    };
    let job = task::single(study, plan, (number, row.sample), record, row.factor)?;
    let mut outcome = pipeline::run(&job, progress)?;
    name(&mut outcome.results, tank, row);
    pipeline::draw(&job, &mut outcome.results)?;
    Ok(outcome)
}

/// Says which row it is.
fn name(results: &mut Results, tank: &str, row: &Worst) {
    let sample = match row.sample {
        0 => String::new(),
        sample => format!(", sample {sample}"),
    };
    results.name = format!("{tank}{sample} under {} × {:.4}", row.record, row.factor);
}

/// Name of the folder of a tank: its number in the plan, and its name with `_` for what is not a letter, a digit, `-` or `_`.
pub fn folder(plan: &Plan, tank: &str) -> String {
    let number = plan.tanks.iter().position(|known| known.id == tank).map_or(0, |i| i + 1);
    let plain = |c: char| if c.is_ascii_alphanumeric() || matches!(c, '-' | '_') { c } else { '_' };
    format!("{number}-{}", tank.chars().map(plain).collect::<String>())
}
