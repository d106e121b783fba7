//! `--lang` and `--report-units`: language and units of a report.

use report::style::{self, Wish, Wished};
use results::Results;
use tank::units::{Dimension, Scope, System, Unit, converted, in_unit};
use tank::{Language, Project};

/// Options of all commands that write a report.
#[derive(clap::Args, Clone, Copy, Debug)]
pub(crate) struct StyleArg {
    /// Language of the report, instead of `project.language`; terminal and JSON stay English.
    #[arg(long, value_enum, value_name = "LANGUAGE")]
    lang: Option<LanguageArg>,
    /// Units of the report, the terminal and CSV, instead of `project.units`; JSON stays in SI.
    #[arg(long, value_enum, value_name = "SYSTEM")]
    report_units: Option<UnitsArg>,
}

impl StyleArg {
    /// Reports follow the options while the value lives.
    #[must_use]
    pub(crate) fn apply(self) -> Wished {
        style::wish(Wish {
            language: self.lang.map(|l| match l {
                LanguageArg::En => Language::English,
                LanguageArg::De => Language::German,
            }),
            units: self.report_units.map(|u| match u {
                UnitsArg::Si => System::Si,
                UnitsArg::Us => System::Us,
                UnitsArg::Both => System::Both,
            }),
        })
    }
}

/// While it lives, the terminal is in the units that are asked for.
#[must_use]
pub(crate) fn terminal(project: Option<&Project>) -> Scope {
    Scope::of(style::units(project))
}

/// A sentence of the terminal, whose values may be in SI, in the units of [`terminal`].
pub(crate) fn sentence(text: &str) -> String {
    converted(text, System::current(), 3).into_owned()
}

/// The unit of a row of CSV whose largest value this is: of SI, but for results that are asked for in US customary units.
pub(crate) fn unit(results: &Results, value: f64, dimension: Dimension) -> &'static Unit {
    match style::units(results.project.as_ref()) {
        System::Us if System::Us.differs(dimension) => System::Us.unit_for(value, dimension),
        System::Si | System::Us | System::Both => dimension.si_unit(),
    }
}

/// A value (SI) in a unit of [`unit`], and how CSV writes the unit.
pub(crate) fn in_csv(value: f64, unit: &'static Unit) -> (f64, &'static str) {
    if unit.factor() == 1.0 { (value, unit.dimension.si_symbol()) } else { (in_unit(value, unit), unit.text) }
}

/// A language.
#[derive(clap::ValueEnum, Clone, Copy, Debug)]
enum LanguageArg {
    /// English.
    En,
    /// German, with the terms of DIN EN 1998-4.
    De,
}

/// A system of units.
#[derive(clap::ValueEnum, Clone, Copy, Debug)]
enum UnitsArg {
    /// SI.
    Si,
    /// US customary: ft, in, lb, kip, psf, psi, ksi.
    Us,
    /// SI with US customary units in brackets.
    Both,
}
