//! Questions that are answered within the process, in milliseconds.

use std::path::{Path, PathBuf};

use serde::Deserialize;
use serde_json::Value;

/// Who answers: the program, with its readers, codes and reports.
pub trait Office: Send + Sync {
    /// The answer, as `docs/desk.md` has it.
    ///
    /// Errors: a question that has no answer; faults of a tank file are an answer.
    fn answer(&self, question: Question) -> Result<Value, Refused>;

    /// Whether the desk may run a command with these arguments; returns the files and folders that they name.
    ///
    /// Errors: a command or an option that there is not, or that is not for the desk.
    fn admit(&self, command: &str, arguments: &[String]) -> Result<Vec<PathBuf>, Refused>;

    /// The files that a tank, set, study or plan names, with each file that a pattern matches; none for any other text.
    ///
    /// * `from`: the file itself, from whose folder on they are found
    fn named(&self, from: &Path, text: &str) -> Vec<Named>;

    /// The German of a refusal or of its help, if the catalogue has it.
    fn german(&self, text: &str) -> Option<String>;
}

/// A file that another one names.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Named {
    /// Path of the value in the file, `records[0].along`.
    pub at: String,
    /// The value as written.
    pub text: String,
    /// The file.
    pub file: PathBuf,
}

/// A refusal with its reason.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Refused {
    /// What is wrong, as on a terminal.
    pub message: String,
    /// What to do about it.
    pub help: Option<String>,
}

impl Refused {
    /// With a message, of which lines `help: …` are the help.
    pub fn new(text: impl AsRef<str>) -> Refused {
        let (message, help) = match text.as_ref().split_once("\n  help: ") {
            Some((message, help)) => (message, Some(help.to_owned())),
            None => (text.as_ref(), None),
        };
        Refused { message: message.trim_end().to_owned(), help }
    }
}

/// A question.
#[derive(Clone, Debug)]
pub enum Question {
    /// The JSON Schema of tank files, its descriptions in a language: `en` or `de`, English without.
    Schema(Option<String>),
    /// Tank files to start from.
    Templates,
    /// The codes' verdict on a tank, or the faults of its file.
    Check(Tank),
    /// The calculation sheet of a check, with its numbers.
    Sheet {
        /// The tank.
        tank: Tank,
        /// Place of the method among those of the results.
        method: usize,
        /// The check; none for the whole sheet.
        check: Option<String>,
    },
    /// The text of a tank file with another value.
    Edit {
        /// The text.
        text: String,
        /// Path of the value, `tank.courses[0].thickness`.
        path: String,
        /// The value; none removes it.
        value: Option<Value>,
    },
    /// The largest or smallest value at which no check fails.
    Solve {
        /// The tank.
        tank: Tank,
        /// As of `check --solve`.
        variable: String,
    },
    /// A record, its measures and its response spectrum.
    Record(RecordChoice),
}

/// A tank file that need not be saved.
#[derive(Clone, Debug, Default, Deserialize)]
pub struct Tank {
    /// Its text.
    pub text: String,
    /// Its name below the folder.
    #[serde(default)]
    pub name: Option<String>,
    /// The opened folder; files that the tank names are found from its name on.
    #[serde(skip)]
    pub folder: PathBuf,
    /// The record it stands under.
    #[serde(default)]
    pub record: Option<RecordChoice>,
    /// `en` or `de`; that of the project without.
    #[serde(default)]
    pub language: Option<String>,
    /// `si` or `us`; those of the project without.
    #[serde(default)]
    pub units: Option<String>,
}

/// A record, and how it is read where its file does not say.
#[derive(Clone, Debug, Default, Deserialize)]
pub struct RecordChoice {
    /// Below the folder; the whole path where a question is answered.
    pub path: String,
    /// Unit of the accelerations.
    #[serde(default)]
    pub units: Option<String>,
    /// Time step [s].
    #[serde(default)]
    pub dt: Option<f64>,
    /// Channel.
    #[serde(default)]
    pub channel: Option<String>,
    /// Lines at its beginning that are not read.
    #[serde(default)]
    pub skip_lines: Option<usize>,
    /// Columns of a table, as of `--columns`.
    #[serde(default)]
    pub columns: Option<String>,
    /// Language of what is said about it, as of a tank; English without.
    #[serde(default)]
    pub language: Option<String>,
}
