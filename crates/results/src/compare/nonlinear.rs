//! Where the nonlinear engine parts from the linear one, and what happened to the wall that explains it.

use tank::units::{self, Dimension};

use super::partings::{parted, what};
use super::{Context, FE_NONLINEAR, Happened};
use crate::nonlinear::{End, Event};
use crate::{ComparisonRow, Method, Parting};

/// While nothing yields or cracks, a mesh of shells or beams stays within this of the linear engine.
const THRESHOLD: f64 = 0.05;
/// Events told at most; the report lists all.
const TOLD: usize = 6;

/// One paragraph, if a quantity differs.
pub(super) fn explain(methods: &[Method], rows: &[ComparisonRow], context: &Context) -> Option<Parting> {
    let column = methods.iter().position(|m| m.id == FE_NONLINEAR)?;
    let parted = parted(rows, column, THRESHOLD);
    let &(first, _) = parted.first()?;
    Some(Parting {
        quantity: first.id().into(),
        what: what(&methods[column], &parted).replace("the finite-element value", "the linear value"),
        why: context.nonlinear.as_ref().map_or_else(String::new, why),
    })
}

/// The causes that the run itself names.
fn why(run: &Happened) -> String {
    let mut sentences = Vec::new();
    match &run.end {
        End::Completed => {}
        End::Left { time, .. } => sentences.push(format!(
            "The run left its model and was stopped at {time:.2} s: its values are those until then."
        )),
        End::Interrupted { time } => sentences.push(format!(
            "The run was interrupted at {time:.2} s: its values are those until then."
        )),
        End::Collapsed { time, .. } if *time < 0.0 => {
            sentences.push("The wall does not carry weight and pressure at rest: there is no history.".into());
        }
        End::Collapsed { time, .. } => sentences.push(format!(
            "The run finds no equilibrium after {time:.2} s: its values are those until then, lower bounds."
        )),
    }
    if run.events.is_empty() {
        sentences.push(
            "Nothing cracks, yields or separates. What is left between the two is the mesh, the damping, large rotations and \
             the pressure on the deformed wall."
                .into(),
        );
    } else {
        let list: Vec<String> = run.events.iter().take(TOLD).map(told).collect();
        sentences.push(format!("The run leaves linear theory: {}.", list.join("; ")));
    }
    if let Some([linear, nonlinear]) = run.damping.as_ref().filter(|[a, b]| a != b) {
        sentences.push(format!("Damping differs: linear {linear}; nonlinear {nonlinear}."));
    }
    let any = |part: &str| run.events.iter().any(|e| e.id.contains(part));
    if any("crack") {
        sentences.push(
            "Cracks soften the wall: its period grows, its deflections with it, and the forces follow the spectrum to the longer \
             period."
                .into(),
        );
    }
    if any("yield") {
        sentences.push("Yielding bounds the stress there and moves forces to where the wall is still elastic.".into());
    }
    if run.hysteretic > 0.0 && run.input > 0.0 {
        sentences.push(format!(
            "The materials dissipate {}, {} % of the work of the loads.",
            units::display(run.hysteretic, Dimension::Energy),
            units::significant(100.0 * run.hysteretic / run.input, 2)
        ));
    }
    sentences.join(" ")
}

/// "first crack at 2.31 s (base, θ = 0°)".
fn told(event: &Event) -> String {
    let when = if event.time > 0.0 {
        format!("at {:.2} s", event.time)
    } else {
        "at rest".into()
    };
    format!("{} {when} ({})", event.title, event.place)
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use tank::Quantity;
    use tank::assessment::Excitation;

    use super::super::{FE, compare};
    use super::*;
    use crate::{Status, Value};

    fn method(id: &str, moment: f64) -> Method {
        Method {
            id: id.into(),
            title: id.into(),
            excitation: Excitation::Record,
            status: Status::Computed,
            quantities: BTreeMap::from([(
                Quantity::BaseMoment.id().to_owned(),
                Value {
                    value: moment,
                    dimension: Dimension::Moment,
                },
            )]),
            steps: vec![],
            checks: vec![],
            profiles: vec![],
            assumptions: vec![],
            notes: vec![],
        }
    }

    fn run() -> Happened {
        Happened {
            end: End::Completed,
            events: vec![Event {
                id: "first_crack".into(),
                title: "first crack".into(),
                time: 2.314,
                place: "base".into(),
                note: String::new(),
            }],
            hysteretic: 2e3,
            input: 1e4,
            damping: Some(["2 %".into(), "2 %".into()]),
        }
    }

    #[test]
    fn what_happened_is_the_cause() {
        let of = |moment, nonlinear| {
            let context = Context {
                nonlinear: Some(nonlinear),
                ..Context::default()
            };
            compare(&[method(FE, 10.0), method(FE_NONLINEAR, moment)], &context, vec![]).partings
        };
        assert!(of(10.4, run()).is_empty());
        let parting = of(8.0, run()).remove(0);
        assert!(parting.what.contains("0.80 times the linear value"), "{}", parting.what);
        for part in ["first crack at 2.31 s (base)", "Cracks soften", "20 %"] {
            assert!(parting.why.contains(part), "`{part}` is missing in {}", parting.why);
        }
        assert!(!parting.why.contains("Damping differs") && !parting.why.contains("Yielding"));
        let mut collapsed = run();
        collapsed.events.clear();
        collapsed.damping = Some(["2 %".into(), "0.1 %".into()]);
        collapsed.end = End::Collapsed {
            time: 7.5,
            load_factor: None,
            reason: String::new(),
            place: String::new(),
        };
        let parting = of(8.0, collapsed).remove(0);
        for part in [
            "no equilibrium after 7.50 s",
            "lower bounds",
            "Nothing cracks",
            "nonlinear 0.1 %",
        ] {
            assert!(parting.why.contains(part), "`{part}` is missing in {}", parting.why);
        }
    }
}
