//! The reference page of `tank.json` (`docs/input.md`), written from the declarations of its keys.

use std::fmt::Write;

use tank::units::Dimension;

use super::keys::TankFile;
use super::read::FromNode;
use super::shape::{Book, KeyInfo, Object, Shape};

const HEAD: &str = "\
# tank.json

All keys of the tank file, with their limits and defaults. `tankcheck init` writes a commented file to start from;
`tankcheck check tank.json` reports all faults of a file at once, each with its place and the expected value.

The file is JSON with comments (`//`, `/* */`) and trailing commas. The order of keys does not matter, a key may occur only
once in an object, and unknown keys are faults. For completion and help while you type, run
`tankcheck schema > tank.schema.json` and put `\"$schema\": \"./tank.schema.json\"` into the file.

This page is written by `tankcheck schema --markdown > docs/input.md`; a test fails when it is out of date.

## Quantities

A value with a dimension is a text with its unit, such as `\"1.83 m\"`. A value without one is a bare number or a
percentage, such as `0.02` or `\"2 %\"`.

| quantity | units | example |
|---|---|---|
";

/// The reference page, in Markdown.
pub fn markdown() -> String {
    let mut book = Book::default();
    let root = TankFile::shape(&mut book);
    let mut sections = Vec::new();
    walk(&root, "", &book, &mut sections);
    let mut page = HEAD.to_owned();
    for dimension in dimensions(&book) {
        let units: Vec<&str> = dimension.units().map(|u| u.text).collect();
        let noun = dimension.noun().split_once(' ').map_or("", |(_, noun)| noun);
        row(&mut page, &[noun, &units.join(", "), &format!("`\"{}\"`", dimension.example())]);
    }
    for section in &sections {
        write_section(&mut page, section, &book, &sections);
    }
    page
}

/// An object of the book with the places where it may occur.
struct Section<'b> {
    object: &'b Object,
    /// In the order of the file; never empty.
    paths: Vec<String>,
}

impl Section<'_> {
    /// Title: the first place.
    fn title(&self) -> &str {
        match self.paths[0].as_str() {
            "" => "The file",
            path => path,
        }
    }
}

/// Collects the objects below a value.
fn walk<'b>(shape: &Shape, path: &str, book: &'b Book, sections: &mut Vec<Section<'b>>) {
    let below = |key: &str| match path {
        "" => key.to_owned(),
        path => format!("{path}.{key}"),
    };
    match shape {
        Shape::List(item) => walk(item, &format!("{path}[]"), book, sections),
        Shape::Named(item) => walk(item, &below("NAME"), book, sections),
        Shape::Either(_, other) => walk(other, path, book, sections),
        Shape::Measured(name) => walk(&Shape::Object(name), &below("QUANTITY"), book, sections),
        Shape::Object(name) => {
            if let Some(known) = sections.iter_mut().find(|s| s.object.name == *name) {
                known.paths.push(path.to_owned());
                return;
            }
            let Some(object) = book.objects.iter().find(|o| o.name == *name) else { return };
            sections.push(Section { object, paths: vec![path.to_owned()] });
            for key in &object.keys {
                walk(&key.shape, &below(key.name), book, sections);
            }
        }
        _ => {}
    }
}

/// Dimensions of the quantities of all keys.
fn dimensions(book: &Book) -> Vec<Dimension> {
    let keys = || book.objects.iter().flat_map(|o| &o.keys);
    let used = |wanted: Dimension| {
        keys().any(|key| match &key.shape {
            Shape::Quantity(d) | Shape::Conventional(d, _) => *d == wanted,
            Shape::List(item) => matches!(item.as_ref(), Shape::Quantity(d) if *d == wanted),
            _ => false,
        })
    };
    let with_unit = |d: &Dimension| *d != Dimension::Dimensionless;
    Dimension::ALL.into_iter().filter(with_unit).filter(|d| used(*d)).collect()
}

fn write_section(page: &mut String, section: &Section<'_>, book: &Book, sections: &[Section<'_>]) {
    let title = match section.title() {
        "The file" => "The file".to_owned(),
        path => format!("`{path}`"),
    };
    // Writing to a text cannot fail.
    let _ = write!(page, "\n## {title}\n\n{}\n", section.object.help);
    if let [_, also @ ..] = section.paths.as_slice()
        && !also.is_empty()
    {
        let also: Vec<String> = also.iter().map(|p| format!("`{p}`")).collect();
        let _ = write!(page, "\nThe same keys apply to {}.\n", also.join(", "));
    }
    page.push_str("\n| key | example | value | if not given | meaning |\n|---|---|---|---|---|\n");
    for key in &section.object.keys {
        let name = format!("`{}`", key.name);
        let otherwise = if key.required { "**required**".to_owned() } else { key.otherwise.clone() };
        row(page, &[&name, &example(key), &value(key, sections), &otherwise, &meaning(key, book)]);
    }
}

/// An example as it stands in the file.
fn example(key: &KeyInfo) -> String {
    let quoted = match &key.shape {
        Shape::Quantity(dimension) => *dimension != Dimension::Dimensionless,
        Shape::Whole | Shape::Bool | Shape::Conventional(..) => false,
        _ => true,
    };
    match (key.example.as_str(), quoted) {
        ("", _) => String::new(),
        (text, true) => format!("`\"{text}\"`"),
        (text, false) => format!("`{text}`"),
    }
}

/// Kind of value with its limits.
fn value(key: &KeyInfo, sections: &[Section<'_>]) -> String {
    let kind = kind(&key.shape, sections);
    match key.allowed() {
        limits if limits.is_empty() => kind,
        limits => format!("{kind}, {limits}"),
    }
}

fn kind(shape: &Shape, sections: &[Section<'_>]) -> String {
    match shape {
        Shape::Object(name) => {
            let section = sections.iter().find(|s| s.object.name == *name);
            let title = section.map_or("", Section::title);
            format!("[object](#{})", anchor(title))
        }
        Shape::Choice(_) => "one of the words".into(),
        Shape::Quantity(Dimension::Dimensionless) => "number".into(),
        Shape::Quantity(dimension) => without_article(dimension.noun()),
        Shape::Conventional(dimension, unit) => {
            format!("number in {unit}, or {}", dimension.noun())
        }
        Shape::Whole => "whole number".into(),
        Shape::Bool => "`true` or `false`".into(),
        Shape::Text => "text".into(),
        Shape::Pattern { noun, .. } => without_article(noun),
        Shape::List(item) => format!("list: {}", kind(item, sections)),
        Shape::Named(item) => format!("objects by name: {}", kind(item, sections)),
        Shape::Either(word, other) => format!("`\"{word}\"` or {}", kind(other, sections)),
        Shape::Measured(name) => format!("objects by quantity: {}", kind(&Shape::Object(name), sections)),
    }
}

/// Meaning of the key and of its words.
fn meaning(key: &KeyInfo, book: &Book) -> String {
    let mut text = key.help.replace("\n\n", "<br>");
    let choice = match &key.shape {
        Shape::List(item) => item.as_ref(),
        shape => shape,
    };
    if let Shape::Choice(name) = choice {
        for (word, meaning) in book.words(name) {
            let _ = write!(text, "<br>`\"{word}\"`: {meaning}");
        }
    }
    text
}

fn without_article(noun: &str) -> String {
    let noun = noun.strip_prefix("a ").or_else(|| noun.strip_prefix("an ")).unwrap_or(noun);
    noun.to_owned()
}

/// The name under which Markdown renderers find a heading.
fn anchor(title: &str) -> String {
    let kept = title.chars().filter(|c| c.is_alphanumeric() || matches!(c, ' ' | '-' | '_'));
    kept.map(|c| if c == ' ' { '-' } else { c.to_ascii_lowercase() }).collect()
}

fn row(page: &mut String, cells: &[&str]) {
    let cells: Vec<String> = cells.iter().map(|c| c.replace('|', "\\|")).collect();
    let _ = writeln!(page, "| {} |", cells.join(" | "));
}
