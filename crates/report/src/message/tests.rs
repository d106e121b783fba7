use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use super::*;
use crate::style::Wish;
use tank::units::System;

/// Names of variables and of other messages in an expression; what [`set`] does not set is a fault.
fn names(pattern: &Pattern<&'static str>, found: &mut BTreeSet<String>) {
    for element in &pattern.elements {
        if let PatternElement::Placeable { expression } = element {
            match expression {
                Expression::Inline(inline) => name(inline, found),
                Expression::Select { selector, variants } => {
                    name(selector, found);
                    variants.iter().for_each(|variant| names(&variant.value, found));
                }
            }
        }
    }
}

fn name(inline: &InlineExpression<&'static str>, found: &mut BTreeSet<String>) {
    match inline {
        InlineExpression::VariableReference { id } => found.insert(format!("${}", id.name)),
        InlineExpression::MessageReference { id, attribute: None } => {
            assert!(READ[0].contains_key(id.name), "{}", id.name);
            found.insert(id.name.to_owned())
        }
        InlineExpression::StringLiteral { .. } => true,
        other => panic!("not set: {other:?}"),
    };
}

/// Ids with the names in their texts.
fn content(texts: &Texts) -> BTreeMap<&'static str, BTreeSet<String>> {
    let of = |(id, pattern): (&&'static str, &Pattern<&'static str>)| {
        let mut found = BTreeSet::new();
        names(pattern, &mut found);
        (*id, found)
    };
    texts.iter().map(of).collect()
}

/// Each file parses, no id stands twice, and both languages say the same things with the same facts.
#[test]
fn both_languages_have_every_message() {
    let [english, german] = [content(&READ[0]), content(&READ[1])];
    for (id, names) in &english {
        assert_eq!(german.get(id), Some(names), "`{id}` in German");
    }
    for id in german.keys() {
        assert!(english.contains_key(id), "`{id}` in English");
    }
    for (files, read) in TEXTS.iter().zip(READ.iter()) {
        let mut all = 0;
        for file in *files {
            let parsed = fluent_syntax::parser::parse(*file).unwrap_or_else(|(_, e)| panic!("{e:?} in\n{file}"));
            all += parsed.body.iter().filter(|e| matches!(e, Entry::Message(_))).count();
        }
        assert_eq!(all, read.len(), "an id stands twice");
    }
}

/// Sources below a folder.
fn sources(folder: &Path, found: &mut Vec<String>) {
    for entry in std::fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        match path.extension().and_then(|e| e.to_str()) {
            None if path.is_dir() => sources(&path, found),
            Some("rs") => found.push(std::fs::read_to_string(&path).expect("text")),
            _ => {}
        }
    }
}

/// Every message that a source names has a text.
#[test]
fn every_message_of_the_sources_has_a_text() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let mut all = Vec::new();
    for folder in ["crates/engines/src", "crates/report/src", "crates/results/src", "src", "codes/src"] {
        sources(&root.join(folder), &mut all);
    }
    let named: BTreeSet<&str> = all
        .iter()
        .flat_map(|source| source.split("Message::new(\"").skip(1))
        .filter_map(|rest| rest.split('"').next())
        .collect();
    assert!(named.len() > 5, "{named:?}");
    for id in named {
        assert!(READ[0].contains_key(id), "no text of `{id}`");
    }
}

#[test]
fn numbers_are_set_once_in_units_and_language_of_the_page() {
    let message = Message::new("curve")
        .with("title", "w")
        .with("low", Amount::new(0.3048, Dimension::Length))
        .with("high", Amount::percent(0.25));
    for (language, units, expected) in [
        (Language::English, System::Si, "w, from 304.8\u{a0}mm to 25\u{a0}%."),
        (Language::English, System::Us, "w, from 12.00\u{a0}in to 25\u{a0}%."),
        (Language::German, System::Si, "w, von 304,8\u{a0}mm bis 25\u{a0}%."),
    ] {
        let _wish = style::wish(Wish { language: Some(language), units: Some(units) });
        let _scope = style::of(None);
        language::made::begin();
        assert_eq!(text(&message), expected);
        // The page leaves it alone, within a tag and behind a number.
        let page = format!("<p>{expected}</p>");
        assert_eq!(language::page(page.clone()), page);
    }
}

#[test]
fn choices_follow_words_and_a_missing_text_is_remembered() {
    let isolators = |kind: &str, dampers: &str| {
        let mass = Amount::new(2e6, Dimension::Mass);
        let message = Message::new("isolation-isolators").with("kind", kind).with("dampers", dampers);
        let step = Amount::new(1e-3, Dimension::Time).form(Form::Given);
        text(&message.with("slab", mass).with("mass", mass).with("step", step))
    };
    assert_eq!(
        isolators("lead_rubber", "yes"),
        "Lead-rubber bearings and viscous dampers under a slab of 2000\u{a0}t; 2000\u{a0}t on them in all. Time step 0.001\u{a0}s."
    );
    assert!(isolators("elastomer", "no").starts_with("Linear bearings under"));
    let missing = "no-such-message";
    assert_eq!(text(&Message::new(missing)), missing);
    assert_eq!(language::untranslated(), [missing]);
}
