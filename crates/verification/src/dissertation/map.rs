//! The map of the dissertation: its systems, where the program has them, and the command that shows each.
//!
//! `docs/theory/dissertation.md` is this map beside the rows of the manual: how many stand behind a command and how many hold.

mod lines;

use std::fmt::Write as _;

use crate::manual::cell;
use crate::{Choice, Entry, Pace, Pattern};

/// A table of the map.
struct Chapter {
    title: &'static str,
    lines: &'static [Line],
    /// A paragraph below the table, or nothing.
    note: &'static str,
}

/// A system of the dissertation.
pub struct Line {
    /// The system, with its place in [B02].
    pub system: &'static str,
    /// Where the program has it.
    pub program: &'static str,
    /// What shows it.
    pub shown: &'static [Shown],
}

/// What shows a system.
#[derive(Clone, Copy, Debug)]
pub enum Shown {
    /// Rows of the manual, by a pattern of `verification`.
    Rows(&'static str),
    /// A run of the program: the arguments of `tankcheck`, from the root of the repository.
    Run(&'static str),
    /// Tests: the arguments of `cargo test`.
    Test(&'static str),
    /// A file of `docs/theory`.
    Page(&'static str),
}

/// The lines of all tables.
pub fn lines() -> impl Iterator<Item = &'static Line> {
    lines::CHAPTERS.iter().flat_map(|chapter| chapter.lines)
}

/// The page, from the rows of the manual.
pub fn page(rows: &[Entry]) -> String {
    let mut text = String::from(HEAD);
    for chapter in &lines::CHAPTERS {
        let _ = writeln!(text, "\n## {}\n\n| system | in the program | shown by |\n|---|---|---|", chapter.title);
        for line in chapter.lines {
            let shown: Vec<String> = line.shown.iter().map(|shown| shown.cell(rows)).collect();
            let _ = writeln!(text, "| {} | {} | {} |", cell(line.system), cell(line.program), shown.join("<br>"));
        }
        if !chapter.note.is_empty() {
            let _ = writeln!(text, "\n{}", chapter.note);
        }
    }
    text.push_str(LEFT_OUT);
    text
}

impl Shown {
    fn cell(self, rows: &[Entry]) -> String {
        match self {
            Shown::Rows(pattern) => behind(pattern, rows),
            Shown::Run(arguments) => format!("`tankcheck {arguments}`"),
            Shown::Test(arguments) => format!("`cargo test {arguments}`"),
            Shown::Page(file) => format!("[{}]({file})", file.trim_end_matches(".md")),
        }
    }
}

/// The command of a pattern with its options, and how many of its rows hold.
fn behind(text: &str, rows: &[Entry]) -> String {
    let Some(pattern) = Pattern::new(text) else { return format!("`verify {text}`: unknown") };
    let choice = Choice { pattern: Some(&pattern), ..Choice::default() };
    let paces: Vec<Pace> = choice.benchmarks().flat_map(|benchmark| benchmark.paces()).collect();
    let selected: Vec<&Entry> = rows.iter().filter(|row| pattern.selects(row)).collect();
    let needs = |wanted: &[Pace]| {
        selected.iter().any(|row| wanted.contains(&row.pace)) && paces.iter().any(|p| wanted.contains(p))
    };
    let slow = if needs(&[Pace::Slow, Pace::Tested]) { " --slow" } else { "" };
    let records = if needs(&[Pace::Record]) { " --records FOLDER" } else { "" };
    let quoted = if text.contains(['*', '?', '(']) { format!("'{text}'") } else { text.to_owned() };
    let judged: Vec<&&Entry> = selected.iter().filter(|row| !row.compares()).collect();
    let held = judged.iter().filter(|row| row.holds()).count();
    format!("`verify {quoted}{slow}{records}` ({held} of {} rows hold)", judged.len())
}

const HEAD: &str = "# The systems of the dissertation

Generated from the benchmarks and their rows; do not edit: `TANKCHECK_BLESS=\"reason\" cargo test --workspace --test models map` writes this page.

The procedures, elements, laws and analyses of [B02] ([references](../references.md)), where the program has them, and the commands that show
them. `verify X` stands for `cargo run --release -p verification -- X`; rows for comparison only are not counted. Tank files are in `examples/`,
keys are those of [`tank.json`](../input.md). `--records FOLDER`: rows under the Caltech version of El Centro, which may not be redistributed; the
[verification manual](../verification/README.md) holds their last results. All printed numbers of [B02] beside ours:
[verify dissertation](../verification/dissertation.md).
";

/// What the program does not have, and why.
const LEFT_OUT: &str = "
## Left out

Computed in [B02], reachable in parts:

| system | what is missing | reason |
|---|---|---|
| damping by single dashpots (3.12) | one dashpot at an angle; rings of them are `analysis.damping.dashpots` | a single one couples the harmonics around the tank, which the engines keep apart; no tank of [B02] has one |
| Drucker-Prager with kinematic hardening (4.93) in a wall | law at a point only | (6.2) uses the ideally plastic cone; the hardening has no bound |
| two-surface plasticity and fracturing solid in bricks | layers of shells take them (verify shell-concrete-patch) | [B02] names them without parameters and computes no brick of concrete with them |

Described in [B02] but not computed there:

| system | reason |
|---|---|
| explicit and multi-step methods; Houbolt, Park, Wilson-θ (3.4.1) | Newmark's method and the generalised-α method contain what [B02] uses |
| hybrid frequency-time methods, random vibration (3.4.4) | [B02] itself calls them unimportant for earthquakes; nonlinear runs are in time |
| Eulerian, ALE and boundary-element liquids (2.1.2, 5.1) | ideal liquid; large waves by the modes of the tank ([large-waves](large-waves.md)), breaking ones are a limit of validity |
| six-parameter shell (6.2) | [B02] found no advantage and difficulties at folds |
| Ogden, Mooney-Rivlin and neo-Hookean elastomers (4.4.2) | [B02] keeps the elastomer linear |
| endochronic theory, microplanes, rotating and embedded cracks (2.1.4) | surveyed there, not chosen |
| viscous liquid; compressible liquid in histories | damping by mode stands for viscosity; whether compressibility matters is checked as a limit of validity |
| wind (3.1.1) | a static check by the codes of wind, as [B02] says; tanks hardly vibrate in it |
| torn walls (3.2) | a wall that yields or buckles is followed, a wall that opens is not |
";
