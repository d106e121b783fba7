//! Sets of records: design value, scatter, spectrum of the set; and records that do not reach the sloshing period.

use tank::check::CheckStatus;
use tank::units::Dimension;

use crate::number::{count, fixed, percent, with_unit};
use results::{Compatibility, Ida, RecordSet, Results, SetPeriod};

/// Heads of the tables.
pub mod heads {
    /// Design value.
    pub const DESIGN: &str = "Design value";
    /// Standard deviation over mean.
    pub const COV: &str = "CoV";
    /// Record of the largest value.
    pub const LARGEST_UNDER: &str = "Largest under";
    /// Significant duration.
    pub const DURATION: &str = "D5–95";
    /// Usable period.
    pub const USABLE: &str = "Usable period";
    /// Limits of validity that are exceeded.
    pub const LIMITS: &str = "Limits exceeded";
    /// Smallest ratio of the spectra.
    pub const RATIO: &str = "Smallest mean/target";
    /// Abscissa of the figures of quantities.
    pub const NUMBER: &str = "Record no.";
    /// Pseudo-acceleration.
    pub const PSA: &str = "Pseudo-acceleration PSA [g]";
}

/// Titles of the tables.
pub mod captions {
    /// Scatter of the quantities.
    pub const QUANTITIES: &str = "Quantities over the records";
    /// Scatter of the checks.
    pub const CHECKS: &str = "Utilisation of the checks of the finite elements over the records";
    /// Record by record.
    pub const RECORDS: &str = "The records and the finite elements under each";
    /// The set against its target.
    pub const SPECTRUM: &str = "Mean spectrum of the set over the target";
}

/// Legend of a figure of spectra.
pub mod legend {
    /// The mean.
    pub const MEAN: &str = "mean of the set";
    /// Design value.
    pub const DESIGN: &str = "design value";
}

/// The design value of a set.
pub fn design(set: &RecordSet) -> String {
    let n = count(set.records.len());
    match set.combine.as_str() {
        "mean" => format!("Set of {n} records: the design value is the mean of the maxima ({}).", set.clause),
        _ => format!("Set of {n} records: the design value is the largest of the maxima ({}).", set.clause),
    }
}

/// What stands for the set and what for one record.
pub fn shown(set: &RecordSet) -> String {
    format!(
        "Quantities and checks under the record are those of the set. Histories, spectra, profiles and sheets are those of the record {}, which has the \
         largest spectral acceleration at the impulsive period.",
        set.shown
    )
}

/// The factor that is in the records.
pub fn factor(set: &RecordSet) -> Option<String> {
    ((set.factor - 1.0).abs() > 0.0).then(|| format!("All records are multiplied by {}.", fixed(set.factor, 4)))
}

/// The record of a section that shows one of several.
pub fn one_of(set: &RecordSet) -> String {
    format!("Of the {} records of the set, this is {}.", count(set.records.len()), set.shown)
}

/// Why the set is not compared with a spectrum.
pub fn no_target(set: &RecordSet) -> String {
    format!("The spectrum of the set is not compared with a target: {}.", set.no_target)
}

/// Which period, in words.
pub fn which(period: &SetPeriod) -> &'static str {
    match period.which.as_str() {
        "impulsive" => "impulsive period",
        "sloshing" => "sloshing period",
        "isolators" => "period of the isolators",
        _ => "given period",
    }
}

/// What the rule for the spectrum of a set says, line by line.
pub fn compatibility(set: &RecordSet, found: &Compatibility) -> Vec<String> {
    let target = match found.target.as_str() {
        "site" => "the spectrum of the site".to_owned(),
        table => format!("the table {table}"),
    };
    let mut lines = vec![format!(
        "{}: the set {} for {target}.",
        found.clause,
        if found.holds { "holds" } else { "does not hold" }
    )];
    if set.records.len() < found.fewest_records {
        lines.push(format!(
            "Too few records: {}, at least {} are asked for.",
            count(set.records.len()),
            count(found.fewest_records)
        ));
    }
    if let Some(zero) = found.mean_zero_period_ratio {
        lines.push(format!(
            "The mean of the peaks is {} of the target at T = 0, which asks for at least 1.",
            fixed(zero, 3)
        ));
    }
    lines.push(format!("One factor for the set with which the rule just holds: {}.", fixed(found.factor, 4)));
    lines
}

/// Title of the figure of a period.
pub fn spectrum_title(period: &SetPeriod) -> String {
    format!("Set against its target around the {}", which(period))
}

/// Caption of the figure of a period.
pub fn spectrum_caption(period: &SetPeriod, share: f64) -> String {
    let component = match period.component.as_str() {
        "y" => "Component along y, whose mean is lower.",
        "largest" => "Maximum over all horizontal directions.",
        _ => "Component along x.",
    };
    format!(
        "Damping {}. The range from {} to {} counts: the mean is at least {} of the target there, at the lowest {} at {}. {component}",
        percent(period.damping),
        with_unit(period.range[0], Dimension::Time),
        with_unit(period.range[1], Dimension::Time),
        percent(share),
        percent(period.smallest_ratio),
        with_unit(period.at_period, Dimension::Time),
    )
}

/// Description of the figure of a period.
pub fn spectrum_description(period: &SetPeriod) -> String {
    format!("Response spectra of the records, their mean and the target spectrum around the {}", which(period))
}

/// The target times its share, in a legend.
pub fn share(share: f64) -> String {
    format!("{} of the target", percent(share))
}

/// Title of the figure of a quantity.
pub fn quantity_title(title: &str) -> String {
    format!("{title} under each record")
}

/// Caption of the figure of a quantity.
pub fn quantity_caption(cov: Option<f64>) -> String {
    match cov {
        Some(cov) => format!("Finite elements; coefficient of variation {}.", percent(cov)),
        None => "Finite elements.".into(),
    }
}

/// A check without a capacity.
pub const NO_CAPACITY: &str = "no capacity";

/// Why a check of a set has no utilisation; none of one that is not required.
pub fn without(status: CheckStatus) -> Option<&'static str> {
    match status {
        CheckStatus::Fails => Some(NO_CAPACITY),
        CheckStatus::NotChecked => Some("not checked"),
        CheckStatus::Accepted => Some("accepted"),
        CheckStatus::Holds | CheckStatus::NotApplicable => None,
    }
}

/// What a table of few records cannot tell.
pub const SCATTER: &str = "CoV: standard deviation of the sample over the mean. Of so few records it is itself uncertain; of n records by about 1/√(2 n).";

/// Limits of validity under other records.
pub const LIMITS: &str = "Limits of validity are those of each record by itself.";

/// What the run of a base that lifts leaves out for the other records.
pub const BASE: &str = "The base that lifts or slides was run on softer and harder ground and under motions slightly apart for the record shown alone.";

/// A usable period and the sloshing period beyond it [s].
fn unreliable(name: &str, usable: f64, sloshing: f64) -> String {
    format!(
        "record {name} is usable up to periods of {}, the corner of its low-cut filter; the sloshing period of the tank is {}: waves under it are \
         not to be relied on",
        with_unit(usable, Dimension::Time),
        with_unit(sloshing, Dimension::Time)
    )
}

/// Records that say nothing of the sloshing period, one line each.
pub fn beyond(results: &Results) -> Vec<String> {
    let of = |m: &results::Method| m.quantities.get("sloshing_period").map(|v| v.value);
    let own = results.methods.iter().filter(|m| m.is_run()).find_map(of);
    let Some(period) = own.or_else(|| results.methods.iter().find_map(of)) else { return Vec::new() };
    match &results.record_set {
        Some(set) => {
            let short = set.records.iter().filter(|r| r.sloshing_beyond_usable);
            short.filter_map(|r| Some(unreliable(&r.id, r.usable_period?, period))).collect()
        }
        None => {
            let short = results.records.iter().filter(|r| r.sloshing_beyond_usable);
            short.filter_map(|r| Some(unreliable(&r.name, r.usable_period?, period))).collect()
        }
    }
}

/// The same of an incremental dynamic analysis.
pub fn beyond_of_ida(ida: &Ida) -> Vec<String> {
    let record = ida.files.iter().find(|f| f.role == "record").map_or("", |f| f.name.as_str());
    let lines = ida.sloshing_beyond_usable.map(|[usable, sloshing]| unreliable(record, usable, sloshing));
    lines.into_iter().collect()
}
