//! Sentences of the report stand in `report::words` alone: sections, figures, pages and templates hold labels of two words
//! at most, and the comparison holds none.

use std::path::{Path, PathBuf};

/// Words from which a literal is a sentence.
const SENTENCE: usize = 3;

/// Files below a folder, or the file itself; none for a file of unit tests.
fn sources(path: &Path) -> Vec<PathBuf> {
    if path.is_file() {
        return if path.ends_with("tests.rs") { Vec::new() } else { vec![path.to_owned()] };
    }
    let entries = std::fs::read_dir(path).expect("a folder of sources");
    let mut found: Vec<PathBuf> = entries.flat_map(|e| sources(&e.expect("readable").path())).collect();
    found.sort();
    found
}

/// String literals with the text before them on the line or the line above, up to the tests of the file.
///
/// Comments and raw strings (markup) are left out.
fn literals(source: &str) -> Vec<(String, String)> {
    let code = source.split("#[cfg(test)]\nmod tests").next().unwrap_or(source);
    let characters: Vec<char> = code.chars().collect();
    let mut found = Vec::new();
    let mut i = 0;
    while i < characters.len() {
        let rest = |n: usize| characters[i..].iter().take(n).collect::<String>();
        match characters[i] {
            '/' if rest(2) == "//" => {
                while i < characters.len() && characters[i] != '\n' {
                    i += 1;
                }
            }
            'r' if rest(3) == "r#\"" => {
                i += 3;
                while i < characters.len() && rest_of(&characters, i, 2) != "\"#" {
                    i += 1;
                }
            }
            // A character, not a lifetime.
            '\'' if characters.get(i + 2) == Some(&'\'') => i += 2,
            '\'' if rest(2) == "'\\" => i += 3,
            '"' => {
                let before: String = characters[i.saturating_sub(60)..i].iter().collect();
                let mut text = String::new();
                i += 1;
                while i < characters.len() && characters[i] != '"' {
                    if characters[i] == '\\' {
                        i += 1;
                    }
                    text.push(characters[i]);
                    i += 1;
                }
                found.push((before, text));
            }
            _ => {}
        }
        i += 1;
    }
    found
}

fn rest_of(characters: &[char], i: usize, n: usize) -> String {
    characters[i..].iter().take(n).collect()
}

/// Words of a literal: letters alone, at least two.
fn words(text: &str) -> usize {
    let plain = |w: &&str| w.chars().count() > 1 && w.chars().all(char::is_alphabetic);
    let trimmed = |w: &'_ str| w.trim_matches(|c: char| c.is_ascii_punctuation()).to_owned();
    let all: Vec<String> = text.split_whitespace().map(trimmed).collect();
    all.iter().filter(|w| plain(&w.as_str())).count()
}

fn sentences(path: &Path) -> Vec<String> {
    let source = std::fs::read_to_string(path).expect("text");
    let sentence = |(before, text): (String, String)| {
        // A fault of the results file is a message of the program, markup is not text.
        let other = before.contains("Error::Report(") || text.contains('<');
        (!other && words(&text) >= SENTENCE).then(|| format!("{}: {text}", path.display()))
    };
    literals(&source).into_iter().filter_map(sentence).collect()
}

#[test]
fn sentences_stand_in_words_alone() {
    let crates = Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("crates/");
    let mut found = Vec::new();
    for place in [
        "report/src/sections",
        "report/src/figure",
        "report/src/ida.rs",
        "report/src/push.rs",
        "results/src/compare.rs",
        "results/src/compare",
    ] {
        for file in sources(&crates.join(place)) {
            found.extend(sentences(&file));
        }
    }
    assert!(found.is_empty(), "{}", found.join("\n"));
}

/// Text between tags of a template that is neither code nor style nor a heading: headings and heads of columns may stay.
fn texts(template: &str) -> Vec<String> {
    let mut plain = template.to_owned();
    for (open, close) in [
        ("<style>", "</style>"),
        ("<title>", "</title>"),
        ("<caption>", "</caption>"),
        ("<h1", "</h1>"),
        ("<h2", "</h2>"),
        ("<h3", "</h3>"),
        ("<th", "</th>"),
        ("{%", "%}"),
        ("{{", "}}"),
        ("<", ">"),
    ] {
        while let Some((before, rest)) = plain.split_once(open) {
            let after = rest.split_once(close).map_or("", |(_, after)| after);
            plain = format!("{before}\n{after}");
        }
    }
    plain.lines().map(str::to_owned).collect()
}

#[test]
fn templates_have_no_sentences() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../templates");
    let mut found = Vec::new();
    for file in sources(&root).iter().filter(|f| f.extension().is_some_and(|e| e == "html")) {
        let template = std::fs::read_to_string(file).expect("text");
        let sentences = texts(&template).into_iter().filter(|text| words(text) >= SENTENCE);
        found.extend(sentences.map(|text| format!("{}: {text}", file.display())));
    }
    assert!(found.is_empty(), "{}", found.join("\n"));
    assert_eq!(texts("<p class=\"x\">{{ a }} One more word.</p>")[2], " One more word.");
}

/// The reader of sources finds sentences.
#[test]
fn a_sentence_is_found() {
    let source = "// \"not a sentence here\"\nlet a = \"k-fe hist\"; let b = '\"';\nlet c = \"The wall is stiff.\";\n";
    let found = literals(source);
    assert_eq!(found.len(), 2, "{found:?}");
    assert_eq!((words(&found[0].1), words(&found[1].1)), (1, 4));
    let words = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/words");
    assert!(sources(&words).iter().map(|f| sentences(f).len()).sum::<usize>() > 100);
}
