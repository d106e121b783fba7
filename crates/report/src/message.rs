//! Texts of messages: Fluent files beside their subjects, one a language. A number is printed once, from f64, in the units of the page.
//!
//! A text has variables (`{ $mass }`), choices by a word or a count (`{ $kind -> [pendulum] … *[other] … }`) and references to other
//! messages (`{ ratio }`), which is what the tests allow in the files.

use std::collections::HashMap;
use std::sync::LazyLock;

use fluent_syntax::ast::{Entry, Expression, InlineExpression, Pattern, PatternElement, Variant, VariantKey};
use tank::units::Dimension;
use tank::{Language, Quantity};

use crate::language;
use crate::language::made::made;
use crate::number::{fixed, given, percent, significant, with_unit};
use crate::style;
use results::part::{Amount, Fact, Form, Message};

/// The files below `crates/`, in both languages.
macro_rules! texts {
    ($($room:literal),+ $(,)?) => {
        [
            &[$(include_str!(concat!("../../", $room, "/en.ftl"))),+],
            &[$(include_str!(concat!("../../", $room, "/de.ftl"))),+],
        ]
    };
}

/// English and German.
const TEXTS: [&[&str]; 2] = texts![
    "report/src/message",
    "engines/src/linear/isolation",
    "engines/src/linear/large_wave",
    "engines/src/linear/soil",
    "engines/src/linear/tilt",
    "engines/src/linear/transfer",
    "results/src/roof_wave",
    "results/src/standing",
];

/// Patterns by the ids of their messages.
type Texts = HashMap<&'static str, Pattern<&'static str>>;

static READ: LazyLock<[Texts; 2]> =
    LazyLock::new(|| TEXTS.map(|files| files.iter().flat_map(|file| read(file)).collect()));

/// Nothing in a table.
pub(crate) const NONE: &str = "–";

/// The messages of a file; what does not parse is left out, and a test allows none.
fn read(file: &'static str) -> Vec<(&'static str, Pattern<&'static str>)> {
    let resource = fluent_syntax::parser::parse(file).unwrap_or_else(|(read, _)| read);
    let message = |entry| match entry {
        Entry::Message(message) => Some((message.id.name, message.value?)),
        _ => None,
    };
    resource.body.into_iter().filter_map(message).collect()
}

fn found(id: &str) -> Option<&'static Pattern<&'static str>> {
    READ[usize::from(style::language() == Language::German)].get(id)
}

/// The text of a message in the language and units of the page.
pub fn text(message: &Message) -> String {
    match found(&message.id) {
        // What was written in English finds its translation as ever.
        Some(pattern) if message.id == "verbatim" => made(language::say(&set(pattern, message)).into_owned()),
        Some(pattern) => made(set(pattern, message)),
        None => language::lacks(&message.id),
    }
}

/// The title of something in a block of a part: `part-block-id`, else `part-id`, else `id`, else that of the quantity.
pub(crate) fn title(part: &str, block: &str, id: &str) -> String {
    let ids = [format!("{part}-{block}-{id}"), format!("{part}-{id}"), id.to_owned()];
    let own = ids.iter().find_map(|id| found(id).map(|pattern| (id, pattern)));
    match (own, Quantity::from_id(id)) {
        (Some((id, pattern)), _) => made(set(pattern, &Message::new(id))),
        (None, Some(quantity)) => quantity.title().to_owned(),
        (None, None) => language::lacks(&ids[0]),
    }
}

/// The title of a block, if it has one.
pub(crate) fn caption(part: &str, block: &str) -> Option<String> {
    let id = format!("{part}-{block}");
    found(&id).map(|pattern| made(set(pattern, &Message::new(&id))))
}

/// A number with its unit, with a decimal comma where the language has one.
pub fn amount(amount: &Amount) -> String {
    let (value, unit) = (amount.value, amount.unit);
    let with_symbol = |number: String| match unit {
        Dimension::Dimensionless => number,
        unit => format!("{number}\u{a0}{}", unit.si_symbol()),
    };
    let number = match amount.form {
        Form::Usual | Form::Words => with_unit(value, unit),
        Form::Given => given(value, unit),
        Form::Fixed(decimals) => with_symbol(fixed(value, decimals.into())),
        Form::Significant(digits) => with_symbol(significant(value, digits.into())),
        Form::Percent => percent(value),
        Form::Degrees(decimals) => format!("{}°", fixed(value.to_degrees(), decimals.into())),
    };
    language::decimal(number)
}

/// A pattern with the facts of a message in it.
fn set(pattern: &Pattern<&'static str>, message: &Message) -> String {
    let piece = |element: &PatternElement<&'static str>| match element {
        PatternElement::TextElement { value } => value.replace('\n', " "),
        PatternElement::Placeable { expression } => placed(expression, message),
    };
    pattern.elements.iter().map(piece).collect()
}

fn placed(expression: &Expression<&'static str>, message: &Message) -> String {
    match expression {
        Expression::Inline(inline) => inlined(inline, message),
        Expression::Select { selector, variants } => chosen(selector, variants, message),
    }
}

fn inlined(inline: &InlineExpression<&'static str>, message: &Message) -> String {
    match inline {
        InlineExpression::StringLiteral { value } | InlineExpression::NumberLiteral { value } => (*value).to_owned(),
        InlineExpression::MessageReference { id, .. } => match found(id.name) {
            Some(pattern) => set(pattern, message),
            None => language::lacks(id.name),
        },
        InlineExpression::Placeable { expression } => placed(expression, message),
        InlineExpression::VariableReference { id } => match message.args.get(id.name) {
            Some(fact) => said(fact),
            None => language::lacks(&format!("{} ${}", message.id, id.name)),
        },
        _ => language::lacks(&message.id),
    }
}

/// A fact within a sentence.
fn said(fact: &Fact) -> String {
    match fact {
        Fact::None => NONE.into(),
        Fact::Number(count) => language::decimal(given(*count, Dimension::Dimensionless)),
        Fact::Word(word) => word.clone(),
        Fact::Amount(own) => amount(own),
        Fact::Message(own) => text(own),
    }
}

/// The variant of a word, or of a count: 1 is `one`.
fn chosen(selector: &InlineExpression<&'static str>, variants: &[Variant<&'static str>], message: &Message) -> String {
    let wanted = match selector {
        InlineExpression::VariableReference { id } => match message.args.get(id.name) {
            Some(Fact::Number(1.0)) => "one".to_owned(),
            Some(fact) => said(fact),
            None => String::new(),
        },
        _ => String::new(),
    };
    let key = |variant: &&Variant<&'static str>| match variant.key {
        VariantKey::Identifier { name } | VariantKey::NumberLiteral { value: name } => name == wanted,
    };
    let variant = variants.iter().find(key).or_else(|| variants.iter().find(|v| v.default));
    variant.map_or_else(String::new, |variant| set(&variant.value, message))
}

#[cfg(test)]
mod tests;
