//! The dissertation [B02]: its printed numbers beside ours, and the map of its systems.
//!
//! A row is of the dissertation if its reference is a printed number ([`Reference::Dissertation`](crate::Reference)), or if it has such a number
//! beside another reference and says why ([`Row::printed`](crate::Row::printed)). Such a row can fail: where no reference judges our number, the printed one
//! is listed on the page, with the reason, and does not count as a row. Rows stay on the pages of their models; this page has those of the code procedures, and
//! lists all. `verification dissertation` runs them all.

mod analytic;
mod appendix;
mod element;
pub mod map;
pub(crate) mod page;
mod record;

use crate::records::EL_CENTRO;
use crate::{Benchmark, Part};

/// Id of the page.
pub const ID: &str = "dissertation";

/// Pages of other models with rows of the dissertation.
pub const PAGES: [&str; 15] = [
    "shell-tank-static",
    "brick-cantilever",
    "fluid-rank",
    "fluid-patch",
    "fluid-rectangle",
    "fluid-cylinder",
    "fluid-disc",
    "rayleigh-damping",
    "strip-at-rest",
    "shell-concrete-beams",
    "responses-of-the-harmonic-engine",
    "liquid-separation",
    "strip-linear-response",
    "strip-incremental",
    "strip-chain",
];

/// The page.
pub(crate) const BENCHMARK: Benchmark = Benchmark {
    id: ID,
    title: "The numbers of the dissertation",
    model: "The procedures of `codes` on the tanks of chapter 8 with the ordinates that the dissertation prints, as a spectrum of the user; \
            below, every printed number beside ours.",
    ids: &[
        ("table-D.1", "Housner's procedure for tank 8.1, dissertation tables D.1, 8.4 and 8.5"),
        ("table-D.2", "API 650 for tank 8.1, dissertation tables D.2, 8.4 and 8.5"),
        ("table-D.3", "ENV 1998 for tank 8.1, dissertation tables D.3 and 8.4"),
        ("5.3.3.1", "cylinder of chapter 5"),
        ("element-8.1", "the element of chapter 5 in the product, tank 8.1"),
        ("table-8.3", "the record of El Centro"),
        ("table-8.8", "Housner's frequencies of the model tank"),
        ("table-8.9", "wave of the model tank under a harmonic motion"),
        ("table-8.10", "Housner's procedure for the slender tank"),
        ("table-8.11", "Housner's procedure for strip 8.4"),
    ],
    parts: &[
        Part::Fast(appendix::housner),
        Part::Fast(appendix::api650),
        Part::Fast(appendix::env1998),
        Part::Fast(element::rows),
        Part::Fast(analytic::frequencies),
        Part::Fast(analytic::harmonic_wave),
        Part::Fast(analytic::slender),
        Part::Fast(analytic::strip),
        Part::Records(&[EL_CENTRO], record::rows),
    ],
};
