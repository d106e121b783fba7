//! Reports of the sample results, whatever their numbers.

mod content;
mod form;
mod nonlinear;

use std::sync::OnceLock;

use report::template::Templates;
use report::{Report, build};
use results::{Results, Series};

use crate::sample::{Kind, sample};

/// Title of the sample.
pub(crate) const TITLE: &str = "Broad tank of Manos and Clough, 1982";
/// Every kind of report.
pub(crate) const EVERY: [Kind; 6] =
    [Kind::Compare, Kind::Check, Kind::Rectangle, Kind::Both, Kind::Solid, Kind::Nonlinear];

/// The report of a sample that was changed.
pub(crate) fn rendered(results: &Results, series: &Series) -> Report {
    let templates = Templates::new(None).expect("the embedded templates parse");
    build(results, series, &templates, report::Level::Full).expect("the sample renders")
}

/// The report of a sample, rendered once.
pub(crate) fn report(kind: Kind) -> Report {
    static DONE: [OnceLock<Report>; EVERY.len()] = [const { OnceLock::new() }; EVERY.len()];
    let of = || {
        let (results, series) = sample(kind, TITLE);
        rendered(&results, &series)
    };
    DONE[kind as usize].get_or_init(of).clone()
}

/// Ids of the sections in their order.
pub(crate) fn sections(html: &str) -> Vec<&str> {
    html.split("<section id=\"").skip(1).filter_map(|s| s.split('"').next()).collect()
}

/// The inline figures.
pub(crate) fn figures(html: &str) -> Vec<&str> {
    html.split("<svg ")
        .skip(1)
        .map(|rest| {
            let end = rest.find("</svg>").expect("an svg element is closed");
            let start = rest.as_ptr() as usize - html.as_ptr() as usize - "<svg ".len();
            &html[start..start + "<svg ".len() + end + "</svg>".len()]
        })
        .collect()
}
