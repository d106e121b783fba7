//! Every sentence of the report and of the terminal's summaries, from typed facts.
//!
//! A translation replaces this module, the headings of the templates and the commands' help. A function takes facts and
//! numbers and returns text; it makes no decisions, and its text is never parsed.
//!
//! | module | content |
//! |---|---|
//! | [`differences`] | where methods differ and why |
//! | [`verdict`], [`outcome`] | whether the tank holds, whether the results are complete, how a nonlinear run ended |
//! | [`sections`] | titles of sections and the sentences of their templates |
//! | [`sheets`] | calculation sheets: what stands elsewhere |
//! | [`base`] | the command of that name |
//! | [`datasheet`] | names of the keys of the tank file |
//! | [`after_record`] | where the record ends within a history |
//! | [`labels`] | heads of columns, labels of rows |
//! | [`summary`] | the first page |
//! | [`figures`] | captions and descriptions of figures |
//! | [`facts`] | names of the numbers of a model |
//! | [`internal_forces`] | stations of the wall |
//! | [`ida`], [`push`], [`study`] | the pages of these analyses |
//! | [`site`] | the modes of an engine under the design spectrum |
//! | [`terminal`] | the summaries on the terminal |
//! | [`uplift`] | the base of a tank that lifts or slides |
//! | [`workbook`] | sheets and heads of the workbook |

pub mod after_record;
pub mod apart;
pub mod base;
pub mod datasheet;
pub mod differences;
pub mod factors;
pub mod figures;
pub mod ida;
pub mod internal_forces;
pub mod labels;
pub mod outcome;
pub mod push;
pub mod record_set;
pub mod sections;
pub mod sheets;
pub mod study;
pub mod summary;
pub mod terminal;
pub mod uplift;
pub mod verdict;
pub mod workbook;

use tank::Quantity;

/// A quantity within a sentence: its title without what is said of it beside the name.
pub fn quantity(quantity: Quantity) -> String {
    quantity.title().split([',', '(']).next().unwrap_or_default().trim().to_lowercase()
}

/// First letter in upper case.
pub fn capital(text: &str) -> String {
    let mut chars = text.chars();
    chars.next().map_or(String::new(), |c| c.to_uppercase().collect::<String>() + chars.as_str())
}

/// A limit state or check by its id, in words.
pub fn limit_state(id: &str) -> String {
    match id {
        "buckling_elastic" => "elastic buckling",
        "buckling_elastic_plastic" => "elastic-plastic collapse",
        "hoop_yield" => "hoop stress",
        "sliding_api" => "sliding, API 650",
        "uplift_tension" => "rotation of the bottom plate",
        "piping_uplift" => "pipes, upwards",
        "piping_settlement" => "pipes, downwards",
        "piping_horizontal" => "pipes, horizontally",
        other => return other.replace('_', " "),
    }
    .into()
}
