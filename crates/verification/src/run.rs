//! Choosing benchmarks and running them.

use crate::records::{EL_CENTRO, Records};
use crate::{ALL, Answer, Benchmark, Entry, Error, Pace, Part, dissertation};

/// A selection of benchmarks and rows by name: an id of rows, a page, a part of either, or a glob with `*` and `?`. Letter
/// case does not matter. The page of the dissertation is also the rows of other pages that stand beside its numbers.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Pattern {
    text: String,
    kind: Kind,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Whole,
    Part,
    Glob,
}

impl Pattern {
    /// The pattern of a text: a glob if it has `*` or `?`; the name itself if an id or a page is called so; else a part of
    /// names. `None` if nothing matches.
    pub fn new(text: &str) -> Option<Pattern> {
        let text = text.to_lowercase();
        let kind = match text.contains(['*', '?']) {
            true => Kind::Glob,
            false if names().any(|name| name.to_lowercase() == text) => Kind::Whole,
            false => Kind::Part,
        };
        let pattern = Pattern { text, kind };
        names().any(|name| pattern.matches(name)).then_some(pattern)
    }

    /// Whether a name matches.
    pub fn matches(&self, name: &str) -> bool {
        let name = name.to_lowercase();
        match self.kind {
            Kind::Whole => name == self.text,
            Kind::Part => name.contains(&self.text),
            Kind::Glob => glob(&self.text, &name),
        }
    }

    /// Whether the pattern selects a row.
    pub fn selects(&self, row: &Entry) -> bool {
        self.matches(&row.page) || self.matches(&row.id) || (self.gathers() && row.of_dissertation().is_some())
    }

    /// Whether the pattern is the page that gathers rows of others.
    fn gathers(&self) -> bool {
        self.kind == Kind::Whole && self.text == dissertation::ID
    }

    /// Whether some of the benchmark's rows may be selected.
    fn concerns(&self, benchmark: &Benchmark) -> bool {
        self.matches(benchmark.id)
            || benchmark.ids.iter().any(|id| self.matches(id.0))
            || (self.gathers() && dissertation::PAGES.contains(&benchmark.id))
    }
}

/// Ids of rows and pages.
fn names() -> impl Iterator<Item = &'static str> {
    ALL.iter().flat_map(|benchmark| benchmark.ids.iter().map(|id| id.0).chain([benchmark.id]))
}

/// The ids and pages nearest to a misspelt one, three at most; the words of a page count, too.
pub fn nearest(text: &str) -> Vec<&'static str> {
    let text = text.to_lowercase();
    let length = text.chars().count();
    let distance = |name: &str| {
        let words = name.split('-').chain([name]);
        words.map(|word| strsim::damerau_levenshtein(&text, &word.to_lowercase())).min().unwrap_or(usize::MAX)
    };
    let mut near: Vec<(usize, &str)> =
        names().map(|name| (distance(name), name)).filter(|(distance, _)| distance * 3 <= length).collect();
    near.sort_unstable();
    near.dedup();
    near.into_iter().take(3).map(|(_, name)| name).collect()
}

/// Whether `text` is of the form of `glob`: `*` for any letters, `?` for one.
fn glob(glob: &str, text: &str) -> bool {
    let mut letters = glob.chars();
    match letters.next() {
        None => text.is_empty(),
        Some('*') => {
            let rest = letters.as_str();
            let ends = text.char_indices().map(|(i, _)| i).chain([text.len()]);
            ends.into_iter().any(|i| self::glob(rest, &text[i..]))
        }
        Some(wanted) => {
            let mut found = text.chars();
            let first = found.next();
            first.is_some_and(|c| wanted == '?' || c == wanted) && self::glob(letters.as_str(), found.as_str())
        }
    }
}

/// The benchmarks and rows to run.
#[derive(Clone, Copy, Debug, Default)]
pub struct Choice<'a> {
    /// Which benchmarks and rows; all without one.
    pub pattern: Option<&'a Pattern>,
    /// Whether tested and slow parts run.
    pub slow: bool,
    /// Accelerograms, if there are any.
    pub records: Option<&'a Records>,
}

impl Choice<'_> {
    /// The benchmarks of the pattern.
    pub fn benchmarks(&self) -> impl Iterator<Item = &'static Benchmark> {
        let chosen = |benchmark: &&Benchmark| self.pattern.is_none_or(|pattern| pattern.concerns(benchmark));
        ALL.iter().copied().filter(chosen)
    }

    /// Whether the parts of this pace of the benchmark `page` run.
    pub fn runs(&self, page: &str, pace: Pace) -> bool {
        self.benchmarks().any(|benchmark| benchmark.id == page && self.needs(benchmark, pace).is_none())
    }

    /// Number of parts that [`run`] begins.
    pub fn parts(&self) -> u64 {
        let each = |benchmark: &'static Benchmark| {
            benchmark.parts.iter().filter(|part| self.needs(benchmark, part.pace()).is_none())
        };
        self.benchmarks().flat_map(each).count() as u64
    }

    /// The option that the parts of this pace of a benchmark need and this choice lacks.
    fn needs(&self, benchmark: &Benchmark, pace: Pace) -> Option<String> {
        match pace {
            Pace::Tested | Pace::Slow if !self.slow => Some("--slow".into()),
            Pace::Record => {
                let names = benchmark.parts.iter().flat_map(|part| part.records());
                let given = |name: &str| self.records.is_some_and(|records| records.get(name).is_ok());
                let mut lacking: Vec<&str> = names.copied().filter(|name| !given(name)).collect();
                lacking.dedup();
                (!lacking.is_empty()).then(|| format!("--records FOLDER with {}", lacking.join(", ")))
            }
            Pace::Fast | Pace::Tested | Pace::Slow => None,
        }
    }
}

/// A benchmark with rows that did not run.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NotRun {
    /// Id of the benchmark.
    pub id: String,
    /// Its title.
    pub what: String,
    /// The options that the rows need.
    pub needs: String,
}

/// The rows of a run.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Manual {
    /// Rows that ran.
    pub rows: Vec<Entry>,
    /// Benchmarks with rows that did not.
    pub not_run: Vec<NotRun>,
}

/// Computes the rows of the chosen benchmarks; `begin` is called with the title of each part's benchmark before it runs.
///
/// Errors: [`Error::Benchmark`], a benchmark that fails.
pub fn run(choice: Choice, begin: &dyn Fn(&str)) -> Result<Manual, Error> {
    let mut manual = Manual::default();
    for benchmark in choice.benchmarks() {
        for part in benchmark.parts {
            if let Some(needs) = choice.needs(benchmark, part.pace()) {
                let lacking = NotRun { id: benchmark.id.into(), what: benchmark.title.into(), needs };
                if !manual.not_run.contains(&lacking) {
                    manual.not_run.push(lacking);
                }
                continue;
            }
            begin(benchmark.title);
            let rows = rows(part, choice.records)
                .map_err(|what| Error::Benchmark { benchmark: benchmark.id.into(), what: what.to_string() })?;
            let entries = rows.iter().map(|row| Entry::of(row, benchmark.id, part.pace()));
            manual.rows.extend(entries);
        }
    }
    Ok(manual)
}

fn rows(part: &Part, records: Option<&Records>) -> Answer {
    match part {
        Part::Fast(rows) | Part::Tested(rows) | Part::Slow(rows) => rows(),
        Part::Record(rows) => rows(records.ok_or("no records")?.get(EL_CENTRO)?),
        Part::Records(_, rows) => rows(records.ok_or("no records")?),
    }
}

/// The benchmark with this id.
pub fn find(id: &str) -> Option<&'static Benchmark> {
    ALL.iter().copied().find(|benchmark| benchmark.id == id)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn chosen(pattern: &str) -> Vec<&'static str> {
        let pattern = Pattern::new(pattern);
        let choice = Choice { pattern: pattern.as_ref(), ..Choice::default() };
        match pattern {
            Some(_) => choice.benchmarks().map(|benchmark| benchmark.id).collect(),
            None => Vec::new(),
        }
    }

    #[test]
    fn a_pattern_is_a_name_a_part_of_names_or_a_glob() {
        assert_eq!(chosen("s7"), ["shell-cook"]);
        // F1 is an id: F10 to F17 are not meant.
        assert_eq!(chosen("F1"), ["rigid-tank-sloshing", "potential-liquid"]);
        assert_eq!(chosen("elephant"), ["shell-elephant-foot"]);
        assert_eq!(chosen("M?"), ["materials-steel", "materials-concrete"]);
        assert_eq!(chosen("*-elephant-*"), ["shell-elephant-foot"]);
        assert_eq!(chosen("nothing-of-this-name"), [""; 0]);
        assert_eq!(chosen("C?2"), ["strip-incremental"]);
        // The page of the dissertation brings those whose rows it gathers.
        assert_eq!(chosen("dissertation").len(), 1 + dissertation::PAGES.len());
    }

    #[test]
    fn what_lacks_an_option_is_listed_once() {
        let pattern = Pattern::new("C8").expect("an id");
        let choice = Choice { pattern: Some(&pattern), ..Choice::default() };
        let manual = run(choice, &|_| {}).expect("nothing runs");
        assert!(manual.rows.is_empty());
        assert_eq!(manual.not_run.len(), 1);
        assert!(manual.not_run[0].needs.contains("--records"));
        assert_eq!(choice.parts(), 0);
    }
}
