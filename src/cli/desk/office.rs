//! Answers to the questions of the desk.

use std::any::TypeId;
use std::path::{Path, PathBuf};
use std::time::Instant;

use desk::{Named, Office, Question, RecordChoice, Refused, Tank};
use oscillator::spectrum::{Method, spectrum};
use report::style::{self, Wish, Wished};
use serde_json::{Value, json};
use tank::Language;
use tank::units::System;

use crate::cli::inputs::{self, Inputs, Reading};
use crate::cli::{init, quake, solve as solving};
use crate::error::Error;
use crate::input::diagnostic::{Fault, Faults, Source};
use crate::input::named::{Mention, named};
use crate::input::records::{self, AccelerationUnit, Columns};
use crate::input::tank::{edited, json_schema, parse};
use crate::job::Job;
use crate::pipeline;
use crate::solve::{self, Variable};
use fem::progress::Silent;
use files::code::Code;
use files::text;
use report::language;
use results::Results;

/// The program.
pub(super) struct Answers {
    /// Its commands, without its name.
    pub commands: clap::Command,
}

/// Commands that the desk may run.
const COMMANDS: [&str; 11] = [
    "compare",
    "check",
    "push",
    "ida",
    "base",
    "modes",
    "report",
    "quake set",
    "study plan",
    "study run",
    "study merge",
];
/// Name of a tank that is not in a file yet.
const UNNAMED: &str = "tank.json";
/// Damping, number and ends of the periods [s] of the spectrum of a record.
const DAMPING: f64 = 0.05;
const PERIODS: (usize, f64, f64) = (121, 0.02, 20.0);
/// Most samples of a record that are drawn, two in each of as many parts.
const DRAWN: usize = 4_000;

impl Office for Answers {
    fn answer(&self, question: Question) -> Result<Value, Refused> {
        match question {
            Question::Schema(language) => {
                let mut schema = json_schema();
                if language.as_deref() == Some("de") {
                    describe(&mut schema);
                }
                Ok(schema)
            }
            Question::Templates => Ok(templates()),
            Question::Check(tank) => Ok(check(&tank)),
            Question::Sheet { tank, method, check } => sheet(&tank, method, check.as_deref()),
            Question::Edit { text, path, value } => {
                edited(&text, &path, value.as_ref()).map(|text| json!({ "text": text })).map_err(Refused::new)
            }
            Question::Solve { tank, variable } => solution(&tank, &variable),
            Question::Record(choice) => record(&choice),
        }
    }

    fn admit(&self, command: &str, arguments: &[String]) -> Result<Vec<PathBuf>, Refused> {
        admitted(&self.commands, command, arguments)
    }

    fn named(&self, from: &Path, text: &str) -> Vec<Named> {
        let own = |found: Mention| Named { at: found.at, text: found.text, file: found.file };
        named(from, text).into_iter().map(own).collect()
    }

    fn german(&self, text: &str) -> Option<String> {
        language::of_input(text)
    }
}

fn refused(error: &Error) -> Refused {
    Refused::new(error.to_string())
}

fn templates() -> Value {
    let file = |(id, title, text): (String, String, &str)| json!({ "id": id, "title": title, "text": text });
    init::templates().into_iter().map(file).collect()
}

/// Language and units of an answer.
fn wished(language: Option<&str>, units: Option<&str>) -> Wished {
    style::wish(Wish {
        language: match language {
            Some("de") => Some(Language::German),
            Some("en") => Some(Language::English),
            _ => None,
        },
        units: match units {
            Some("us") => Some(System::Us),
            Some("si") => Some(System::Si),
            _ => None,
        },
    })
}

/// What keeps a tank from becoming a job.
enum Unfit {
    /// Faults of the file, in its text.
    Faults(Box<(Faults, Source)>),
    /// What is wrong beyond it: a record, options that do not go together.
    Other(Error),
}

impl From<Error> for Unfit {
    fn from(error: Error) -> Unfit {
        Unfit::Other(error)
    }
}

impl From<Unfit> for Refused {
    fn from(unfit: Unfit) -> Refused {
        match unfit {
            Unfit::Faults(_) => Refused::new("the tank has faults, so that nothing was computed"),
            Unfit::Other(error) => refused(&error),
        }
    }
}

/// The job of a tank, as `check` has it.
fn job(asked: &Tank) -> Result<(Job, Vec<String>), Unfit> {
    let name = asked.name.as_deref().unwrap_or(UNNAMED);
    // Files that it names are beside it.
    let source = Source::new(asked.folder.join(name).to_string_lossy(), asked.text.as_str());
    let file =
        parse(&source).map_err(|faults| Unfit::Faults(Box::new((faults, Source::new(name, asked.text.as_str())))))?;
    let remarks = file.remarks.clone();
    let record = asked.record.as_ref();
    let inputs = Inputs {
        tank: name.into(),
        quake: record.map(|record| PathBuf::from(&record.path)).into_iter().collect(),
        reading: record.map(reading).transpose()?.unwrap_or_default(),
        ..Inputs::default()
    };
    let job = inputs.resolved(file)?;
    inputs::shaken(&job)?;
    Ok((job, remarks))
}

/// How a record is read.
fn reading(record: &RecordChoice) -> Result<Reading, Error> {
    let unit = |text: &String| {
        AccelerationUnit::parse(text).ok_or_else(|| {
            Error::value(format!("found `{text}`, expected a unit: g, %g, mg, m/s2, gal, mm/s2, in/s2 or ft/s2"))
        })
    };
    Ok(Reading {
        units: record.units.as_ref().filter(|text| !text.is_empty()).map(unit).transpose()?,
        dt: record.dt,
        channel: record.channel.clone().filter(|text| !text.is_empty()),
        skip_lines: record.skip_lines.unwrap_or_default(),
        columns: record.columns.as_ref().filter(|text| !text.is_empty()).map(|text| columns(text)).transpose()?,
        ..Reading::default()
    })
}

fn columns(text: &str) -> Result<Columns, Error> {
    text.parse().map_err(|what| Error::value(format!("found the columns `{}`, {what}", text::line(text))))
}

fn check(asked: &Tank) -> Value {
    let started = Instant::now();
    let _wished = wished(asked.language.as_deref(), asked.units.as_deref());
    let found = job(asked).and_then(|(job, remarks)| {
        let outcome = pipeline::run(&job, &Silent)?;
        Ok((job, remarks, outcome.results))
    });
    let mut answer = match found {
        Ok((job, remarks, results)) => {
            let _style = style::of(job.project.as_ref());
            let late = results.warnings.iter().map(|w| warning(w.code().map(|c| c.id()), w.text()));
            let remarks = remarks.iter().map(|text| warning(None, text));
            json!({
                "faults": [],
                "text_faults": "",
                "warnings": late.chain(remarks).collect::<Vec<_>>(),
                "sketch": report::sketch(&results.tank),
                "results": said(results),
            })
        }
        Err(Unfit::Faults(found)) => {
            let _style = style::of(None);
            let (faults, source) = *found;
            let list: Vec<Value> = faults.list().iter().map(|fault| shown(fault, &source)).collect();
            json!({ "faults": list, "text_faults": faults.render(&source, false), "warnings": [], "results": null, "sketch": null })
        }
        Err(Unfit::Other(error)) => {
            let _style = style::of(None);
            let Refused { message, help } = refused(&error);
            let said = german(&message, "", help.as_deref());
            let fault = json!({ "code": error.code().map(|c| c.id()), "message": message, "path": "", "line": 1, "column": 1, "start": 0, "end": 0,
                "found": "", "allowed": "", "help": help, "german": said });
            json!({ "faults": [fault], "text_faults": error.message(), "warnings": [], "results": null, "sketch": null })
        }
    };
    answer["milliseconds"] = json!(started.elapsed().as_secs_f64() * 1e3);
    answer
}

/// A fault with its place in the text as a browser counts.
fn shown(fault: &Fault, source: &Source) -> Value {
    let units = |byte: usize| {
        let whole = source.text.get(..byte.min(source.text.len())).unwrap_or(&source.text);
        whole.encode_utf16().count()
    };
    let span = fault.span.clone().unwrap_or(0..0);
    let (line, column) = source.line_column(span.start);
    let said = match fault.code {
        // A list of keys.
        Code::UnknownKey => {
            let mut said = german(&fault.message, "", fault.help.as_deref());
            said["allowed"] = fault.allowed.replace(" or ", " oder ").into();
            said
        }
        _ => german(&fault.message, &fault.allowed, fault.help.as_deref()),
    };
    json!({
        "code": fault.code.id(),
        "message": text::line(&fault.message),
        "path": &*fault.path,
        "line": line,
        "column": column,
        "start": units(span.start),
        "end": units(span.end),
        "found": text::line(&fault.found),
        "allowed": text::line(&fault.allowed),
        "help": fault.help.as_deref().map(text::line),
        "german": said,
    })
}

/// The German of the texts of a fault on a German page, each where there is one.
fn german(message: &str, allowed: &str, help: Option<&str>) -> Value {
    if style::language() != Language::German {
        return Value::Null;
    }
    let said = |text: &str| language::of_input(&text::line(text));
    json!({ "message": said(message), "allowed": said(allowed), "help": help.and_then(said) })
}

fn warning(code: Option<&str>, message: &str) -> Value {
    json!({ "code": code, "message": message, "german": german(message, "", None) })
}

/// Puts German descriptions into a schema.
fn describe(schema: &mut Value) {
    match schema {
        Value::Object(members) => {
            for (key, value) in members {
                match value {
                    Value::String(text) if key == "description" => {
                        if let Some(german) = language::of_input(text) {
                            *text = german;
                        }
                    }
                    value => describe(value),
                }
            }
        }
        Value::Array(items) => items.iter_mut().for_each(describe),
        _ => {}
    }
}

/// Keys of `results.json` whose texts people read.
const READ: [&str; 8] = ["title", "label", "note", "reason", "unstated", "assumptions", "notes", "warnings"];

/// Results as JSON, without what only a report and sheets need, the texts in the language of the page.
fn said(mut results: Results) -> Value {
    results.input.clear();
    for method in &mut results.methods {
        method.profiles.clear();
        // A sheet is asked for by itself.
        method.steps.clear();
    }
    let mut value = serde_json::to_value(&results).unwrap_or_default();
    if style::language() != Language::English {
        translate(&mut value, false);
    }
    value
}

/// * `read`: whether the value is a text that people read
fn translate(value: &mut Value, read: bool) {
    match value {
        Value::String(text) if read => *text = language::say(text).into_owned(),
        Value::Array(items) => items.iter_mut().for_each(|item| translate(item, read)),
        Value::Object(members) => {
            // The name of a check is a sentence, that of a tank or a person is not.
            let check = members.contains_key("limit_state");
            for (key, value) in members.iter_mut() {
                translate(value, READ.contains(&key.as_str()) || check && key == "name");
            }
        }
        _ => {}
    }
}

fn sheet(asked: &Tank, method: usize, check: Option<&str>) -> Result<Value, Refused> {
    let _wished = wished(asked.language.as_deref(), asked.units.as_deref());
    let (job, _) = job(asked)?;
    let results = pipeline::run(&job, &Silent).map_err(|e| refused(&e))?.results;
    let method = results.methods.get(method).ok_or_else(|| Refused::new("there is no such method"))?;
    let check = check.map(|id| {
        let found = method.checks.iter().find(|check| check.id == id);
        found.ok_or_else(|| Refused::new(format!("{} has no check `{id}`", method.id)))
    });
    let check = check.transpose()?;
    let _style = style::of(job.project.as_ref());
    let html = report::sheet(method, check).map_err(|e| Refused::new(e.to_string()))?;
    Ok(json!({ "html": html }))
}

fn solution(asked: &Tank, variable: &str) -> Result<Value, Refused> {
    let _wished = wished(asked.language.as_deref(), asked.units.as_deref());
    let (job, _) = job(asked)?;
    let variable = Variable::parse(variable).map_err(|e| refused(&e))?;
    let solution = solve::run(&job, variable).map_err(|e| refused(&e))?;
    let path = match variable {
        Variable::FillHeight => "liquid.fill_height".to_owned(),
        Variable::Thickness(course) => format!("tank.courses[{}].thickness", course - 1),
        Variable::Ag if job.case.site.spectrum.is_some() => "site.spectrum.ag".into(),
        Variable::Ag => "site.ec8.ag".into(),
        Variable::Ss => "site.api650.ss".into(),
    };
    // The mapped acceleration is a number of g.
    let stated = solving::stated(&solution).map(|text| match variable {
        Variable::Ss => text.trim_end_matches(" g").parse::<f64>().map_or(Value::from(text.as_str()), Value::from),
        _ => Value::from(text),
    });
    let message = solving::paragraph(&solution);
    let _style = style::of(job.project.as_ref());
    Ok(json!({
        "value": solution.value().map(|(value, _)| value),
        "unit": variable.unit(),
        "text": stated,
        "path": path,
        "found": solution.value().is_some(),
        "german": german(&message, "", None),
        "message": message,
    }))
}

fn record(choice: &RecordChoice) -> Result<Value, Refused> {
    let _wished = wished(choice.language.as_deref(), None);
    let _style = style::of(None);
    let options = reading(choice).map_err(|e| refused(&e))?.options();
    let read = records::read(Path::new(&choice.path), &options).map_err(|e| Refused::new(e.to_string()))?;
    let (count, first, last) = PERIODS;
    let ratio = (last / first).ln() / (count - 1) as f64;
    let periods: Vec<f64> = (0..count).map(|i| first * (ratio * i as f64).exp()).collect();
    let found = spectrum(&read.record, &periods, &[DAMPING], Method::Exact);
    let psa: Vec<f64> = found.ordinates.iter().flatten().map(|ordinates| ordinates.psa).collect();
    let (time, acceleration) = drawn(&read.record.acceleration, read.record.dt);
    let doubts = records::plausible::doubts(&read.record, &records::Processing::default());
    Ok(json!({
        "info": quake::facts(&read),
        "time": time,
        "acceleration": acceleration,
        "spectrum": { "period": periods, "psa": psa, "damping": DAMPING },
        "usable_period": read.usable_period(),
        "notes": read.notes.iter().map(|note| warning(None, note)).collect::<Vec<_>>(),
        "warnings": doubts.iter().map(|w| warning(w.code().map(|c| c.id()), w.text())).collect::<Vec<_>>(),
    }))
}

/// Times and values of a record; of a long one the smallest and the largest value of each part, so that no peak is lost.
fn drawn(values: &[f64], dt: f64) -> (Vec<f64>, Vec<f64>) {
    let place = |i: usize| (dt * i as f64, values[i]);
    if values.len() <= DRAWN {
        return (0..values.len()).map(place).unzip();
    }
    let part = values.len().div_ceil(DRAWN / 2);
    let ends = |start: usize| {
        let part = start..(start + part).min(values.len());
        let by = |a: &usize, b: &usize| values[*a].total_cmp(&values[*b]);
        let (low, high) = (part.clone().min_by(by).unwrap_or(start), part.max_by(by).unwrap_or(start));
        [low.min(high), low.max(high)]
    };
    (0..values.len()).step_by(part).flat_map(ends).map(place).unzip()
}

/// The files and folders that a command names.
///
/// Errors: a command that is not for the desk; arguments that it does not take.
fn admitted(own: &clap::Command, command: &str, arguments: &[String]) -> Result<Vec<PathBuf>, Refused> {
    if !COMMANDS.contains(&command) {
        let known = COMMANDS.map(|name| format!("`{name}`")).join(", ");
        return Err(Refused::new(format!("found the command `{}`, expected one of {known}", text::line(command))));
    }
    let words = || command.split(' ').map(str::to_owned).chain(arguments.iter().cloned());
    let matches = own.clone().try_get_matches_from(words()).map_err(|e| Refused::new(e.to_string()))?;
    // Down to the command itself: its arguments that are paths, as it declares them.
    let (mut declared, mut found) = (own, &matches);
    while let Some((name, inner)) = found.subcommand() {
        let Some(next) = declared.find_subcommand(name) else { break };
        (declared, found) = (next, inner);
    }
    let paths = declared.get_arguments().filter(|a| a.get_value_parser().type_id() == TypeId::of::<PathBuf>());
    let ids: Vec<&str> = paths.map(|argument| argument.get_id().as_str()).collect();
    let values = ids.iter().filter_map(|id| found.try_get_many::<PathBuf>(id).ok().flatten());
    let all: Vec<PathBuf> = values.flatten().cloned().collect();
    match all.iter().any(|path| path == Path::new("-")) {
        true => Err(Refused::new("found `-`, expected a file: the desk has no standard input")),
        false => Ok(all),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn asked(text: &str) -> Tank {
        Tank { text: text.into(), ..Tank::default() }
    }

    /// Faults stand where a browser finds them: after a character that UTF-8 and UTF-16 count differently.
    #[test]
    fn faults_have_their_place_in_units_of_a_browser() {
        let text =
            init::templates()[0].2.replacen("\"name\": \"", "\"name\": \"𝛑 ", 1).replacen("anchored", "anchord", 1);
        let answer = check(&asked(&text));
        let fault = &answer["faults"][0];
        let (start, end) = (fault["start"].as_u64().unwrap() as usize, fault["end"].as_u64().unwrap() as usize);
        let units: Vec<u16> = text.encode_utf16().collect();
        assert!(String::from_utf16(&units[start..end]).unwrap().contains("anchord"), "{answer}");
        assert!(answer["results"].is_null() && answer["text_faults"].as_str().unwrap().contains("tank.json:"));
    }

    #[test]
    fn every_check_that_compares_has_a_sheet() {
        let tank = asked(init::templates()[0].2);
        let answer = check(&tank);
        assert!(answer["sketch"].as_str().unwrap().starts_with("<svg"));
        let mut count = 0;
        for (i, method) in answer["results"]["methods"].as_array().unwrap().iter().enumerate() {
            for check in method["checks"].as_array().unwrap().iter().filter(|c| c["demand"].is_number()) {
                let html = sheet(&tank, i, check["id"].as_str()).unwrap()["html"].as_str().unwrap().to_owned();
                count += usize::from(html.contains("<math"));
            }
        }
        assert!(count > 10, "{count}");
    }

    #[test]
    fn commands_name_their_files_and_others_are_refused() {
        use clap::Args;
        let compare = crate::cli::compare::Args::augment_args(clap::Command::new("compare"));
        let own = clap::Command::new("tankcheck").no_binary_name(true).subcommand(compare);
        let admitted = |command: &str, arguments: &[&str]| {
            admitted(&own, command, &arguments.iter().map(|a| (*a).to_owned()).collect::<Vec<_>>())
        };
        let found = admitted("compare", &["t.json", "--quake", "a.csv", "--quake", "../b.csv", "--out", "o"]).unwrap();
        for path in ["t.json", "a.csv", "../b.csv", "o"] {
            assert!(found.contains(&PathBuf::from(path)), "{path}: {found:?}");
        }
        for (command, arguments) in [
            ("desk", &[][..]),
            ("templates", &["x"]),
            ("compare --help", &[]),
            ("compare", &["t.json", "--nonsense"]),
            ("compare", &["-"]),
            ("compare", &["t.json", "--help"]),
        ] {
            assert!(admitted(command, arguments).is_err(), "{command} {arguments:?}");
        }
    }

    #[test]
    fn a_long_record_keeps_its_peaks() {
        let mut values = vec![0.0; 100_000];
        (values[77_777], values[3]) = (5.0, -6.0);
        let (time, drawn) = drawn(&values, 0.01);
        assert!(drawn.len() <= DRAWN + 2 && time.is_sorted());
        assert!(drawn.contains(&5.0) && drawn.contains(&-6.0));
    }
}
