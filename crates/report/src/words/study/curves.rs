//! Fragility curves of a study: how they are found, their data and remarks.

use super::{first_of, id, of};
use crate::number::{count, percent};
use results::{Study, StudyCurve};

/// Runs at an intensity: in the state, of all, bounds where some are missing.
pub fn counted(n: f64, exceed: f64, bounds: Option<[f64; 2]>) -> String {
    let counts = format!("{exceed:.0} of {n:.0}");
    match bounds {
        Some([low, high]) => format!("{counts} ({}–{})", percent(low), percent(high)),
        None => counts,
    }
}

/// How curves are found.
pub fn method(study: &Study) -> String {
    let how = match study.method.as_str() {
        "cloud" => {
            "by regression of the largest demand over its limit on the intensity, both in logarithms (Jalayer et al. 2017); runs without a \
                    finite demand enter through the logistic regression of their probability"
        }
        "capacities" => {
            "from the intensity at which each record first reaches the state, between two levels linear in logarithms (incremental dynamic \
                         analysis); where records do not reach it, or reach it at their lowest intensity, with the truncated likelihood (Baker 2015)"
        }
        _ => "from the number of runs in the state at each intensity, by maximum likelihood (Baker 2015)",
    };
    format!("Lognormal curves P = Φ(ln(im/θ)/β) {how}. Points: the share of the runs in the state.")
}

/// How bands are found.
pub fn bands(study: &Study) -> String {
    format!(
        "Bands: 5 and 95 % of {} resamples of whole records, whose runs stay together; a resample that identifies no curve is left out, and with fewer than \
         half of them, or fewer than three records, there is no band. Where curves of a tank cross within the data, a fit with one dispersion stands beside them.",
        count(study.resamples)
    )
}

/// Which tanks are drawn.
pub fn drawn(some: usize, all: usize) -> String {
    format!("Drawn: the {} whose worst state comes first; the table has all.", of(some, all))
}

/// Remark on a curve.
pub fn remark(curve: &StudyCurve, text: &dyn Fn(f64) -> String, unit: &str) -> String {
    let Some(reason) = &curve.reason else { return String::new() };
    let bounds = match curve.bounds {
        [Some(low), Some(high)] => format!("; median between {} and {} {unit}", text(low), text(high)),
        [Some(low), None] => format!("; median above {} {unit}", text(low)),
        [None, Some(high)] => format!("; median below {} {unit}", text(high)),
        [None, None] => String::new(),
    };
    format!("{reason}{bounds}")
}

/// What runs that were not judged, and demands that no run has checked, mean for the curves.
pub fn gaps(study: &Study) -> Vec<String> {
    let curves = &study.curves;
    let mut all = Vec::new();
    // Open in some runs of the tank, and checked in others.
    let at_times = |curve: &&StudyCurve| {
        let own = |tanks: &[String]| tanks.iter().any(|tank| curve.tank.as_ref() == Some(tank));
        let mut open = study.gaps.iter().filter(|gap| own(&gap.tanks));
        curve.unjudged > 0 && open.any(|gap| !curve.never_checked.contains(&gap.demand))
    };
    let mut tanks: Vec<&str> = curves.iter().filter(at_times).filter_map(|c| c.tank.as_deref()).collect();
    tanks.dedup();
    if !tanks.is_empty() {
        all.push(format!(
            "{}: a run with an open demand is judged only if another demand reaches the state. Runs in the state are therefore judged more often than others: \
             their share is too large, and bands are too narrow. The range with missing runs shows how far the curve can move.",
            first_of(&tanks)
        ));
    }
    let mut groups: Vec<(Vec<String>, Vec<String>)> = Vec::new();
    for curve in curves.iter().filter(|c| !c.never_checked.is_empty()) {
        let demands: Vec<String> = curve.never_checked.iter().map(|demand| id(demand)).collect();
        let name = format!("{} {}", curve.tank.as_deref().unwrap_or_default(), curve.state);
        match groups.iter_mut().find(|(known, _)| *known == demands) {
            Some((_, names)) => names.push(name),
            None => groups.push((demands, vec![name])),
        }
    }
    let line = |(demands, names): &(Vec<String>, Vec<String>)| {
        format!("{}: without {}, which no run checks.", first_of(names), demands.join(", "))
    };
    all.extend(groups.iter().map(line));
    all
}

/// Remarks of the methods, the same ones together.
pub fn remarks(curves: &[StudyCurve]) -> Vec<String> {
    let mut groups: Vec<(&str, Vec<String>)> = Vec::new();
    for curve in curves {
        let name = [curve.tank.as_deref(), Some(curve.state.as_str())];
        let name = name.into_iter().flatten().collect::<Vec<_>>().join(" ");
        for note in &curve.notes {
            match groups.iter_mut().find(|(known, _)| known == note) {
                Some((_, names)) => names.push(name.clone()),
                None => groups.push((note, vec![name.clone()])),
            }
        }
    }
    groups.iter().map(|(note, names)| format!("{}: {note}.", first_of(names))).collect()
}

/// Caption of the curves of a tank.
pub fn caption(curves: &[&StudyCurve]) -> String {
    let open: Vec<&str> = curves.iter().filter(|c| c.fit.is_none()).map(|c| c.state.as_str()).collect();
    let mut parts = Vec::new();
    if !open.is_empty() {
        parts.push(format!("No curve is identified of {}.", open.join(", ")));
    }
    for pair in curves.windows(2) {
        if pair[0].fit.is_some() && pair[0].fit == pair[1].fit {
            parts.push(format!("The curves of {} and {} coincide.", pair[0].state, pair[1].state));
        }
    }
    parts.join(" ")
}

/// Description of the curves of a tank.
pub fn description(tank: &str, curves: &[&StudyCurve]) -> String {
    let states: Vec<&str> = curves.iter().map(|c| c.state.as_str()).collect();
    format!("Fragility curves of {tank} with bands and data: {}.", states.join(", "))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_with_bounds() {
        assert_eq!(counted(7.0, 3.0, None), "3 of 7");
        assert!(counted(8.0, 3.0, Some([0.3, 0.5])).starts_with("3 of 8 (30"));
    }
}
