//! Calculation sheets: symbol = formula = numbers = value, or symbol from table = value; unit, clause. The sheet of a procedure on the spectrum of the
//! site shows in the full report only the lines that differ from its sheet on the record. Below the full level there are only the sheets of the
//! engines and of the procedures that decide (of all procedures where none does), each of them whole: formula, numbers, result, each formula on one line.
//! Values that are given or looked up follow one another as far as they are of one clause, and the same of them for several grounds are set as one.
//! An engine that does not decide has its assumptions and remarks there; its lines are only counted.

use std::collections::BTreeSet;

use serde::Serialize;
use tank::assessment::{Check, Excitation};
use tank::formula::Formula;

use super::{Section, Source};
use crate::level::Level;
use crate::math;
use crate::methods::excitation;
use crate::number::parts;
use crate::template::Templates;
use crate::words::verdict::LIQUID_PARTED;
use crate::words::{outcome, sections, sheets as words};
use files::error::Error;
use results::compare::MEASURED;
use results::nonlinear::End;
use results::{EngineId, Method, Run, Status};
use tank::assessment::Step;
use tank::units::{System, converted};

#[derive(Serialize)]
struct Sheet {
    id: String,
    /// Id of the method.
    #[serde(skip)]
    method: String,
    title: String,
    excitation: &'static str,
    not_applicable: Vec<String>,
    /// How many lines are left out because the sheet for the record has them, and its id.
    shared: String,
    base: String,
    /// How many lines are in the full report alone.
    left: String,
    parts: Vec<Part>,
    assumptions: Vec<String>,
    /// What it also assumes, as an earlier sheet says: a sentence up to the link to it, the id of that sheet, its title.
    as_before: String,
    before: String,
    before_title: String,
    notes: Vec<String>,
    /// Document that clauses without a name are of; empty where each names its own.
    document: String,
}

#[derive(Serialize)]
struct Part {
    title: String,
    /// Clause of most of its lines, which then do not name it; empty without one.
    clause: String,
    blocks: Vec<Block>,
}

/// A line, or values without formula that follow one another and are of one clause.
#[derive(Serialize)]
struct Block {
    clause: String,
    /// Source of all its values; empty where each has its own.
    look_up: String,
    lines: Vec<LineView>,
}

#[derive(Serialize)]
struct LineView {
    /// Number of the line in the whole sheet, which does not depend on the level of the report.
    number: usize,
    name: String,
    /// MathML, made by [`math`].
    symbol: String,
    formula: String,
    substitution: String,
    /// Source of a value without formula, as HTML.
    look_up: String,
    value: String,
    unit: &'static str,
    clause: String,
    /// Whether the value is given, not computed.
    short: bool,
}

/// Makes the section.
pub(super) fn make(source: &Source) -> Result<Option<Section>, Error> {
    let full = source.level == Level::Full;
    let verdict = &source.results.verdict;
    // What an engine assumes and where it left its model stands at every level that has its numbers.
    let all = full || !source.results.methods.iter().any(|m| !m.is_run() && verdict.decides(m));
    let shown = |m: &&Method| {
        let said = !m.steps.is_empty() || !m.assumptions.is_empty() || !m.notes.is_empty();
        m.id != MEASURED && (said || m.status != Status::Computed) && (all || m.is_run() || verdict.decides(m))
    };
    let methods: Vec<&Method> = source.results.methods.iter().filter(shown).collect();
    let base = |method: &Method| methods.iter().copied().find(|r| full && is_base(r, method));
    let lines = |m: &Method| all || verdict.decides(m);
    let mut sheets: Vec<Sheet> = methods.iter().map(|m| sheet(m, base(m), full, lines(m))).collect();
    let column = EngineId::Nonlinear.beside();
    if let (Some(run), Some(sheet)) =
        (source.results.beside(EngineId::Nonlinear), sheets.iter_mut().find(|s| s.method == column))
    {
        sheet.notes.splice(0..0, remarks(run));
    }
    group(&mut sheets);
    if sheets.is_empty() {
        return Ok(None);
    }
    let mut section = Section::new("sheets");
    section.set("sheets", &sheets);
    section.set("full", &full);
    section.set("clauses", &words::CLAUSES);
    // The constants of the codes' formulas hold in SI.
    let substituted = if System::current() == System::Si { "" } else { words::SUBSTITUTED };
    section.set("substituted", &substituted);
    Ok(Some(section))
}

/// The sheet of one method as a piece of a page, every line with its numbers.
///
/// * `check`: a check of the method, of which there are only the lines that its demand and its capacity come from; none for all, with
///   assumptions and remarks
///
/// Errors: a template that fails.
pub fn alone(method: &Method, check: Option<&Check>, templates: &Templates) -> Result<String, Error> {
    let mut sheet = sheet(method, None, true, true);
    if let Some(check) = check {
        let behind = behind(&method.steps, check);
        for part in &mut sheet.parts {
            part.blocks.retain(|block| block.lines.iter().all(|line| behind.contains(&(line.number - 1))));
        }
        sheet.parts.retain(|part| !part.blocks.is_empty());
        (sheet.assumptions, sheet.notes) = (Vec::new(), Vec::new());
    }
    let mut section = Section::new("sheets");
    section.set("sheets", &[sheet]);
    section.set("full", &true);
    section.set("clauses", &"");
    section.set("substituted", &if System::current() == System::Si { "" } else { words::SUBSTITUTED });
    templates.render(&templates.of_section(section.id), &section.context)
}

/// Places of the lines that a check comes from: those with its demand and its capacity, and for each symbol of their formulas the nearest
/// line above that gives it.
fn behind(steps: &[Step], check: &Check) -> BTreeSet<usize> {
    let ends = |value: Option<f64>| value.and_then(|value| steps.iter().rposition(|step| same(step.value, value)));
    let mut open: Vec<usize> = [ends(check.demand), ends(check.capacity)].into_iter().flatten().collect();
    let mut found = BTreeSet::new();
    while let Some(place) = open.pop() {
        if !found.insert(place) {
            continue;
        }
        let Ok(formula) = Formula::parse(&steps[place].formula) else { continue };
        let above = |symbol: &str| steps[..place].iter().rposition(|step| step.symbol == symbol);
        open.extend(formula.symbols().filter_map(above));
    }
    found
}

/// Whether two values are one that was kept with fewer digits.
fn same(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-9 * a.abs().max(b.abs())
}

/// Leaves out assumptions that the sheet of the same procedure or of another engine above has; three or more of them, else the sentence takes
/// as much room as they do.
fn group(sheets: &mut [Sheet]) {
    for i in 1..sheets.len() {
        let (above, rest) = sheets.split_at_mut(i);
        let Some(sheet) = rest.first_mut() else { continue };
        let common = |other: &Sheet| sheet.assumptions.iter().filter(|a| other.assumptions.contains(a)).count();
        let Some(best) = above.iter().max_by_key(|other| common(other)) else { continue };
        let count = common(best);
        if count < 3 {
            continue;
        }
        sheet.as_before = words::as_before(count);
        sheet.before.clone_from(&best.id);
        sheet.before_title = format!("{} ({})", best.title, best.excitation);
        sheet.assumptions.retain(|a| !best.assumptions.contains(a));
    }
}

/// Remarks on a nonlinear run.
fn remarks(run: &Run) -> Vec<String> {
    let mut remarks = Vec::new();
    if let End::Left { departure, .. } = &run.end {
        remarks.push(outcome::stopped_remark(departure));
    }
    let departures = run.nonlinear.iter().flat_map(|n| &n.departures);
    let passed = departures.filter(|d| !d.kind.stops());
    remarks.extend(passed.map(outcome::remark));
    remarks.extend(run.parted().then(|| LIQUID_PARTED.to_owned()));
    remarks
}

fn sheet_id(method: &Method) -> String {
    format!("sheet-{}-{}", method.id, excitation(method))
}

/// Whether `base` is the same procedure as `method` on the record, where `method` is on the spectrum of the site.
fn is_base(base: &Method, method: &Method) -> bool {
    base.id == method.id && base.excitation == Excitation::Record && method.excitation == Excitation::Site
}

/// A line of a sheet; `built`: with fractions as they are written by hand, else its formula on one line.
fn line(number: usize, step: &Step, document: &str, built: bool) -> LineView {
    let (value, unit) = parts(step.value, step.dimension);
    let math = if built { math::formula } else { math::line };
    let set = |text: &str, shown: bool| match text {
        text if shown && !text.is_empty() => math(text),
        _ => String::new(),
    };
    // Not "H/R = H/R".
    let formula = !step.formula.is_empty() && step.formula != step.symbol;
    let substitution = step.substitution != step.formula;
    LineView {
        number,
        name: in_units(&step.name),
        symbol: math(&step.symbol),
        formula: set(&step.formula, formula),
        substitution: set(&step.substitution, substitution),
        look_up: if step.look_up.is_empty() { String::new() } else { math::words(&in_units(&step.look_up)) },
        value,
        unit,
        clause: within(&step.clause, document).to_owned(),
        short: !formula,
    }
}

/// * `alone`: whether every line stands alone
/// * `lines`: whether there are lines at all
fn sheet(method: &Method, base: Option<&Method>, alone: bool, lines: bool) -> Sheet {
    let known = base.map_or(&[][..], |b| &b.steps);
    let document = document(&method.steps);
    let mut shared = 0;
    let mut found: Vec<(String, Vec<LineView>)> = Vec::new();
    for (number, step) in (1..).zip(&method.steps).filter(|_| lines) {
        if known.contains(step) {
            shared += 1;
            continue;
        }
        if found.last().is_none_or(|(title, _)| *title != step.section) {
            found.push((step.section.clone(), Vec::new()));
        }
        if let Some((_, lines)) = found.last_mut() {
            lines.push(line(number, step, document, alone));
        }
    }
    let parts = found.into_iter().map(|(title, lines)| if alone { whole(title, lines) } else { part(title, lines) });
    Sheet {
        id: sheet_id(method),
        method: method.id.clone(),
        title: method.title.clone(),
        excitation: excitation(method),
        not_applicable: match &method.status {
            Status::Computed => Vec::new(),
            Status::NotApplicable { clause, reason } => vec![format!("{clause}: {reason}")],
        },
        shared: sections::shared(shared),
        base: base.map_or(String::new(), sheet_id),
        left: if lines { String::new() } else { words::left(method.steps.len()) },
        parts: parts.collect(),
        assumptions: method.assumptions.clone(),
        as_before: String::new(),
        before: String::new(),
        before_title: String::new(),
        notes: method.notes.clone(),
        document: match document {
            "" => String::new(),
            document => sections::clauses_of(document),
        },
    }
}

/// A text with its values in the units of the report; beside a formula the finished page is not converted.
fn in_units(text: &str) -> String {
    converted(text, System::current(), 3).into_owned()
}

/// A part of which each line stands alone and names its clause.
fn whole(title: String, lines: Vec<LineView>) -> Part {
    let block = |line: LineView| Block { clause: line.clause.clone(), look_up: String::new(), lines: vec![line] };
    Part { title, clause: String::new(), blocks: lines.into_iter().map(block).collect() }
}

/// A part whose values of one clause that follow one another are one block; the clause of most lines stands beside its title.
fn part(title: String, lines: Vec<LineView>) -> Part {
    let clause = if title.is_empty() { String::new() } else { common(&lines) };
    let mut blocks: Vec<Block> = Vec::new();
    for line in merged(lines) {
        let with = |block: &&mut Block| {
            line.short && block.clause == line.clause && block.lines.iter().all(|known| known.short)
        };
        match blocks.last_mut().filter(with) {
            Some(block) => block.lines.push(line),
            None => {
                blocks.push(Block { clause: line.clause.clone(), look_up: String::new(), lines: vec![line] });
            }
        }
    }
    for block in &mut blocks {
        let source = block.lines[0].look_up.clone();
        if block.lines.len() > 1 && block.lines.iter().all(|line| line.look_up == source) {
            block.lines.iter_mut().for_each(|line| line.look_up.clear());
            block.look_up = source;
        }
        if block.clause == clause {
            block.clause.clear();
        }
    }
    Part { title, clause, blocks }
}

/// The clause of more than half of the lines; empty without one.
fn common(lines: &[LineView]) -> String {
    let of = |clause: &str| lines.iter().filter(|line| line.clause == clause).count();
    let most = lines.iter().map(|line| &line.clause).find(|clause| 2 * of(clause) > lines.len());
    most.filter(|_| lines.len() > 1).cloned().unwrap_or_default()
}

/// Lines of a part, those that repeat set as one: three or more without formula with the same symbol and unit, whose names or sources differ in one word.
fn merged(lines: Vec<LineView>) -> Vec<LineView> {
    let alike = |a: &LineView, b: &LineView| {
        let same = a.symbol == b.symbol && a.unit == b.unit && a.clause == b.clause;
        a.short
            && b.short
            && same
            && varied(&[&a.name, &b.name]).is_some()
            && varied(&[&a.look_up, &b.look_up]).is_some()
    };
    let mut groups: Vec<Vec<LineView>> = Vec::new();
    for line in lines {
        match groups.iter_mut().find(|g| g.iter().all(|known| alike(known, &line))) {
            Some(group) => group.push(line),
            None => groups.push(vec![line]),
        }
    }
    let mut out = Vec::new();
    for group in groups {
        let of = |text: fn(&LineView) -> &str| varied(&group.iter().map(text).collect::<Vec<_>>());
        match (of(|l| &l.name), of(|l| &l.look_up)) {
            (Some(name), Some(look_up)) if group.len() > 2 => {
                let values: Vec<&str> = group.iter().map(|l| l.value.as_str()).collect();
                let value = values.join("; ");
                out.extend(group.into_iter().next().map(|first| LineView { name, look_up, value, ..first }));
            }
            _ => out.extend(group),
        }
    }
    out.sort_by_key(|line| line.number);
    out
}

/// Texts that are the same except for one word, as one text with all these words; `None` if they differ in more.
fn varied(texts: &[&str]) -> Option<String> {
    let split: Vec<Vec<&str>> = texts.iter().map(|t| t.split(' ').collect()).collect();
    let first = split.first()?;
    if split.iter().any(|words| words.len() != first.len()) {
        return None;
    }
    let differ: Vec<usize> = (0..first.len()).filter(|&i| split.iter().any(|words| words[i] != first[i])).collect();
    let mut words: Vec<String> = first.iter().map(|word| (*word).to_owned()).collect();
    match differ.as_slice() {
        [] => {}
        [i] => words[*i] = split.iter().map(|w| w[*i]).collect::<Vec<_>>().join("; "),
        _ => return None,
    }
    Some(words.join(" "))
}

/// The document that most of the clauses name, `EN 1998-4:2006` of `EN 1998-4:2006 A.3.2.1`; empty if that is less than a third of the lines.
fn document(steps: &[Step]) -> &str {
    let of = |clause: &'_ str| clause.rfind(' ').map(|end| clause[..end].to_owned());
    let mut found: Vec<(String, usize, &str)> = Vec::new();
    for step in steps {
        let Some(name) = of(&step.clause).filter(|name| name.contains(|c: char| c.is_ascii_digit())) else { continue };
        match found.iter_mut().find(|f| f.0 == name) {
            Some(f) => f.1 += 1,
            None => found.push((name.clone(), 1, &step.clause[..name.len()])),
        }
    }
    let most = found.into_iter().max_by_key(|f| f.1);
    most.filter(|f| 3 * f.1 > steps.len()).map_or("", |f| f.2)
}

/// A clause without the name of the document.
fn within<'a>(clause: &'a str, document: &str) -> &'a str {
    match clause.strip_prefix(document).and_then(|rest| rest.strip_prefix(' ')) {
        Some(rest) if !document.is_empty() => rest,
        _ => clause,
    }
}

#[cfg(test)]
mod tests;
