//! Writes the mutants of a sample into the source, each behind its switch, and builds until the compiler is content.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;
use std::path::Path;
use std::process::Command;

use serde_json::{Value, json};
use syn::spanned::Spanned;
use syn::visit::{self, Visit};

use crate::sample::{self, Mutant};

/// Appended to the crate's root. The environment variable `MUTANT` names the switch that is on; the first panic ends the
/// process then, so that a caught mutant costs no more than the test that catches it.
const SWITCH: &str = r#"
#[doc(hidden)]
#[allow(missing_docs)]
pub mod mutation_switch {
    use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};
    const UNKNOWN: usize = usize::MAX;
    static ACTIVE: AtomicUsize = AtomicUsize::new(UNKNOWN);
    #[inline(always)]
    pub fn on(mutant: usize) -> bool {
        let active = ACTIVE.load(Relaxed);
        active == mutant || (active == UNKNOWN && first(mutant))
    }
    #[cold]
    #[inline(never)]
    fn first(mutant: usize) -> bool {
        let active = std::env::var("MUTANT").ok().and_then(|m| m.parse().ok()).unwrap_or(0);
        ACTIVE.store(active, Relaxed);
        if active != 0 {
            std::panic::set_hook(Box::new(|_| std::process::exit(101)));
        }
        active == mutant
    }
}
"#;

/// Rounds of removing mutants that do not compile.
const ROUNDS: usize = 40;

/// A place in the source where switches stand: an expression with the texts that replace it, or a point where text enters.
enum Site {
    Expression { range: Range<usize>, mutants: Vec<(usize, String)> },
    Insertion { at: usize, mutant: usize, text: String },
}

impl Site {
    fn start(&self) -> usize {
        match self {
            Site::Expression { range, .. } => range.start,
            Site::Insertion { at, .. } => *at,
        }
    }
}

/// Byte offsets of line and column.
struct Lines<'a> {
    text: &'a str,
    starts: Vec<usize>,
}

impl<'a> Lines<'a> {
    fn new(text: &'a str) -> Lines<'a> {
        let starts = std::iter::once(0).chain(text.match_indices('\n').map(|(i, _)| i + 1)).collect();
        Lines { text, starts }
    }

    /// Line from 1, column from 0, in characters.
    fn offset(&self, line: usize, column: usize) -> usize {
        let start = self.starts[line - 1];
        self.text[start..].char_indices().nth(column).map_or(self.text.len(), |(i, _)| start + i)
    }

    fn range(&self, span: proc_macro2::Span) -> Range<usize> {
        let (a, b) = (span.start(), span.end());
        self.offset(a.line, a.column)..self.offset(b.line, b.column)
    }
}

/// Expressions around which a switch may stand, arms, and the chains of operators.
struct Finder<'a> {
    lines: &'a Lines<'a>,
    /// Expressions that hold operators next to each other without parentheses: the whole is one site.
    chains: Vec<Range<usize>>,
    guards: Vec<Range<usize>>,
    structs: Vec<Range<usize>>,
    /// Whole arm, and the end of its pattern.
    arms: Vec<(Range<usize>, usize)>,
    /// Depth of operators above the present expression.
    inside: bool,
}

fn holds_let(e: &syn::Expr) -> bool {
    match e {
        syn::Expr::Let(_) => true,
        syn::Expr::Binary(b) => holds_let(&b.left) || holds_let(&b.right),
        _ => false,
    }
}

impl<'a, 'ast> Visit<'ast> for Finder<'a> {
    fn visit_expr(&mut self, e: &'ast syn::Expr) {
        let outer = self.inside;
        // `&(a + b)` as a whole borrows from inside the switch; as an operand the reference is part of the chain.
        let operator = match e {
            syn::Expr::Binary(_) | syn::Expr::Unary(_) | syn::Expr::Cast(_) => true,
            syn::Expr::Reference(_) => outer,
            _ => false,
        };
        if operator && !outer && !holds_let(e) {
            self.chains.push(self.lines.range(e.span()));
        }
        self.inside = operator && (outer || !holds_let(e));
        // Operands continue the chain; an expression in brackets begins a new one.
        match e {
            syn::Expr::Binary(b) => {
                let chain = self.inside;
                self.visit_expr(&b.left);
                self.inside = chain;
                self.visit_expr(&b.right);
            }
            syn::Expr::Unary(u) => self.visit_expr(&u.expr),
            syn::Expr::Cast(c) => self.visit_expr(&c.expr),
            syn::Expr::Reference(r) if outer => self.visit_expr(&r.expr),
            _ => {
                self.inside = false;
                visit::visit_expr(self, e);
            }
        }
        self.inside = outer;
    }

    fn visit_expr_struct(&mut self, e: &'ast syn::ExprStruct) {
        self.structs.push(self.lines.range(e.span()));
        visit::visit_expr_struct(self, e);
    }

    fn visit_arm(&mut self, a: &'ast syn::Arm) {
        let pattern = self.lines.range(a.pat.span());
        self.arms.push((self.lines.range(a.span()), pattern.end));
        if let Some((_, guard)) = &a.guard {
            self.guards.push(self.lines.range(guard.span()));
        }
        visit::visit_arm(self, a);
    }
}

/// Text with switches, and which part of it belongs to which mutants (innermost last).
struct Woven {
    text: String,
    regions: Vec<(Range<usize>, Vec<usize>)>,
}

fn weave(text: &str, mutants: &[&Mutant], skipped: &mut BTreeMap<usize, String>) -> Result<Woven, String> {
    let file = syn::parse_file(text).map_err(|e| e.to_string())?;
    let lines = Lines::new(text);
    let mut finder =
        Finder { lines: &lines, chains: vec![], guards: vec![], structs: vec![], arms: vec![], inside: false };
    finder.visit_file(&file);
    let smallest = |ranges: &[Range<usize>], span: &Range<usize>| {
        ranges.iter().filter(|r| r.start <= span.start && span.end <= r.end).min_by_key(|r| r.len()).cloned()
    };
    let mut expressions: BTreeMap<(usize, usize), Vec<(usize, String)>> = BTreeMap::new();
    let mut sites = Vec::new();
    for m in mutants {
        let span = lines.offset(m.start.0, m.start.1 - 1)..lines.offset(m.end.0, m.end.1 - 1);
        let around = match m.genre.as_str() {
            "FnValue" => {
                sites.push(Site::Insertion {
                    at: span.start,
                    mutant: m.id,
                    text: format!("if crate::mutation_switch::on({}) {{ return {}; }} ", m.id, m.replacement),
                });
                continue;
            }
            "MatchArm" => {
                let arm = finder.arms.iter().find(|(arm, _)| arm.start == span.start);
                match arm {
                    Some((_, end)) => sites.push(Site::Insertion {
                        at: *end,
                        mutant: m.id,
                        text: format!(" if !crate::mutation_switch::on({})", m.id),
                    }),
                    None => drop(skipped.insert(m.id, "arm not found".into())),
                }
                continue;
            }
            "MatchArmGuard" => smallest(&finder.guards, &span),
            "StructField" => smallest(&finder.structs, &span),
            _ => smallest(&finder.chains, &span),
        };
        let Some(around) = around else {
            skipped.insert(m.id, "no expression to switch".into());
            continue;
        };
        let mutated = format!("{}{}{}", &text[around.start..span.start], m.replacement, &text[span.end..around.end]);
        expressions.entry((around.start, around.end)).or_default().push((m.id, mutated));
    }
    sites
        .extend(expressions.into_iter().map(|((start, end), mutants)| Site::Expression { range: start..end, mutants }));
    // Outer sites before inner ones; insertions before expressions that begin at the same place.
    sites.sort_by_key(|s| match s {
        Site::Insertion { at, .. } => (*at, 0, 0),
        Site::Expression { range, .. } => (range.start, 1, usize::MAX - range.len()),
    });
    let mut woven = Woven { text: String::with_capacity(2 * text.len()), regions: vec![] };
    let mut rest = &sites[..];
    write(text, 0..text.len(), &mut rest, &mut woven);
    Ok(woven)
}

/// Writes a range of the source with the sites inside it.
fn write(text: &str, range: Range<usize>, sites: &mut &[Site], out: &mut Woven) {
    let mut at = range.start;
    while let Some((site, rest)) = sites.split_first() {
        if site.start() >= range.end {
            break;
        }
        *sites = rest;
        out.text.push_str(&text[at..site.start()]);
        let begin = out.text.len();
        match site {
            Site::Insertion { at: point, mutant, text } => {
                out.text.push_str(text);
                out.regions.push((begin..out.text.len(), vec![*mutant]));
                at = *point;
            }
            Site::Expression { range, mutants } => {
                out.text.push('(');
                for (mutant, mutated) in mutants {
                    let from = out.text.len();
                    out.text.push_str(&format!("if crate::mutation_switch::on({mutant}) {{ {mutated} }} else "));
                    out.regions.push((from..out.text.len(), vec![*mutant]));
                }
                out.text.push_str("{ ");
                write(text, range.clone(), sites, out);
                out.text.push_str(" })");
                let all = mutants.iter().map(|(m, _)| *m).collect();
                out.regions.push((begin..out.text.len(), all));
                at = range.end;
            }
        }
    }
    out.text.push_str(&text[at..range.end]);
}

/// Mutants that the compiler's errors point at, with the reason; and the errors that point at none.
fn blamed(messages: &str, woven: &BTreeMap<String, Woven>) -> (BTreeMap<usize, String>, Vec<String>) {
    let mut found = BTreeMap::new();
    let mut elsewhere = Vec::new();
    for line in messages.lines() {
        let Ok(value) = serde_json::from_str::<Value>(line) else { continue };
        let message = &value["message"];
        if value["reason"] != "compiler-message" || message["level"] != "error" {
            continue;
        }
        let text = message["message"].as_str().unwrap_or_default();
        let code = message["code"]["code"].as_str().unwrap_or_default();
        let Some(spans) = message["spans"].as_array() else { continue };
        // The innermost region around each span; of several the one with the fewest mutants.
        let around = |span: &Value| {
            let file = span["file_name"].as_str()?;
            let (_, w) = woven.iter().find(|(f, _)| file.ends_with(f.as_str()))?;
            let (start, end) = (span["byte_start"].as_u64()? as usize, span["byte_end"].as_u64()? as usize);
            w.regions
                .iter()
                .filter(|(r, _)| r.start <= start && end <= r.end)
                .min_by_key(|(r, _)| r.len())
                .map(|(_, mutants)| mutants)
        };
        let placed = spans.iter().filter_map(around).min_by_key(|mutants| mutants.len());
        if let Some(mutants) = placed {
            let why = match (code, mutants.len()) {
                ("E0015", _) => "constant".to_string(),
                (_, 1) => format!("unviable: {text}"),
                _ => format!("not switchable: {text}"),
            };
            for m in mutants {
                found.insert(*m, why.clone());
            }
        }
        if placed.is_none() && !spans.is_empty() {
            elsewhere.push(message["rendered"].as_str().unwrap_or(text).to_string());
            // For example a function whose type is that of its body: the switch next to the error.
            let next = spans.iter().find_map(|span| {
                let file = span["file_name"].as_str()?;
                let (_, w) = woven.iter().find(|(f, _)| file.ends_with(f.as_str()))?;
                let at = span["byte_start"].as_u64()? as usize;
                w.regions.iter().min_by_key(|(r, _)| r.start.abs_diff(at)).map(|(_, m)| m)
            });
            for m in next.into_iter().flatten() {
                found.entry(*m).or_insert_with(|| format!("not switchable: {text}"));
            }
        }
    }
    (found, elsewhere)
}

/// Weaves the sample into the tree at `root`, compiles, removes the rejected mutants, and repeats. Writes the
/// removed mutants and the test binaries to `state`.
pub fn build(root: &Path, sample: &Path, state: &Path, cargo: &[String]) -> Result<(), String> {
    let mutants = sample::read(sample)?;
    let mut skipped: BTreeMap<usize, String> = BTreeMap::new();
    let files: BTreeSet<&str> = mutants.iter().map(|m| m.file.as_str()).collect();
    let fail = |path: &Path, e: std::io::Error| format!("{}: {e}", path.display());
    let mut original = BTreeMap::new();
    for file in &files {
        let path = root.join(file);
        original.insert(*file, std::fs::read_to_string(&path).map_err(|e| fail(&path, e))?);
    }
    let crate_root = files
        .first()
        .map(|f| f.split_once("/src/").map_or(String::new(), |(c, _)| format!("{c}/")) + "src/lib.rs")
        .ok_or("the sample is empty")?;
    let root_path = root.join(&crate_root);
    let root_text = match original.get(crate_root.as_str()) {
        Some(text) => text.clone(),
        None => std::fs::read_to_string(&root_path).map_err(|e| fail(&root_path, e))?,
    };
    for round in 1..=ROUNDS {
        let mut woven = BTreeMap::new();
        for (file, text) in &original {
            let own: Vec<&Mutant> =
                mutants.iter().filter(|m| m.file == *file && !skipped.contains_key(&m.id)).collect();
            let w = weave(text, &own, &mut skipped).map_err(|e| format!("{file}: {e}"))?;
            woven.insert((*file).to_string(), w);
        }
        for (file, w) in &woven {
            let path = root.join(file);
            std::fs::write(&path, &w.text).map_err(|e| fail(&path, e))?;
        }
        let top = woven.get(&crate_root).map_or(root_text.as_str(), |w| w.text.as_str());
        std::fs::write(&root_path, format!("{top}{SWITCH}")).map_err(|e| fail(&root_path, e))?;
        let compile = |command: &str, extra: &[&str]| {
            Command::new("cargo")
                .current_dir(root)
                .arg(command)
                .args(extra)
                .args(["--message-format=json"])
                .args(cargo)
                .output()
                .map_err(|e| format!("cargo: {e}"))
        };
        let checked = compile("test", &["--no-run"])?;
        let text = String::from_utf8_lossy(&checked.stdout);
        let (found, elsewhere) = blamed(&text, &woven);
        println!("round {round}: {} mutants in, {} taken out", mutants.len() - skipped.len(), found.len());
        if checked.status.success() {
            return finish(state, &skipped, &text);
        }
        if found.is_empty() {
            return Err(format!(
                "the woven source does not compile and no mutant is to blame:\n{}\n{}",
                elsewhere.join("\n"),
                String::from_utf8_lossy(&checked.stderr)
            ));
        }
        skipped.extend(found);
    }
    Err(format!("still errors after {ROUNDS} rounds"))
}

fn finish(state: &Path, skipped: &BTreeMap<usize, String>, messages: &str) -> Result<(), String> {
    let binaries: Vec<String> = messages
        .lines()
        .filter_map(|l| serde_json::from_str::<Value>(l).ok())
        .filter(|v| v["reason"] == "compiler-artifact" && v["profile"]["test"] == true)
        .filter_map(|v| v["executable"].as_str().map(str::to_string))
        .collect();
    let skipped: BTreeMap<String, &String> = skipped.iter().map(|(id, why)| (id.to_string(), why)).collect();
    let text = serde_json::to_string_pretty(&json!({ "skipped": skipped, "binaries": binaries }))
        .map_err(|e| e.to_string())?;
    std::fs::write(state, text).map_err(|e| format!("{}: {e}", state.display()))
}
