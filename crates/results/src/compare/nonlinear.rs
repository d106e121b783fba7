//! Where the nonlinear engine differs from the linear one, and the events of the wall that explain it.

use tank::Quantity;

use super::difference::ratios;
use super::{Context, Difference, Happened, Reason};
use crate::nonlinear::End;
use crate::{ComparisonRow, EngineId, Method};

/// Without yielding and cracks, a mesh of shells or beams stays within this of the linear engine.
const THRESHOLD: f64 = 0.05;
/// Most events in the sentence; the report lists all.
const TOLD: usize = 6;

/// At most one difference.
pub(super) fn attribute(methods: &[Method], rows: &[ComparisonRow], context: &Context) -> Option<Difference> {
    let column = methods.iter().position(|m| m.id == EngineId::Nonlinear.beside())?;
    let ratios = ratios(rows, column, THRESHOLD, &Quantity::ALL);
    ratios.first()?;
    Some(Difference {
        method: EngineId::Nonlinear.beside().into(),
        ratios,
        reasons: context.nonlinear.as_ref().map_or_else(Vec::new, reasons),
    })
}

/// The causes that the run itself names.
fn reasons(run: &Happened) -> Vec<Reason> {
    let mut reasons = Vec::new();
    reasons.extend(match run.end {
        End::Completed => None,
        End::Left { time, .. } => Some(Reason::LeftModel { time }),
        End::Interrupted { time } => Some(Reason::Interrupted { time }),
        End::Collapsed { time, .. } if time < 0.0 => Some(Reason::NotCarriedAtRest),
        End::Collapsed { time, .. } => Some(Reason::NoEquilibrium { time }),
    });
    reasons.push(match run.events.len() {
        0 => Reason::StaysLinear,
        all => Reason::LeavesLinearTheory { events: all.min(TOLD) },
    });
    if let Some([linear, nonlinear]) = run.damping.filter(|[a, b]| a != b) {
        reasons.push(Reason::Damping { linear, nonlinear });
    }
    if run.events.iter().any(|e| e.kind.cracks()) {
        reasons.push(Reason::Cracking);
    }
    if run.events.iter().any(|e| e.kind.yields()) {
        reasons.push(Reason::Yielding);
    }
    if run.hysteretic > 0.0 && run.input > 0.0 {
        reasons.push(Reason::Dissipation { energy: run.hysteretic, work: run.input });
    }
    reasons
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use tank::assessment::Excitation;
    use tank::units::Dimension;

    use super::super::{Damping, compare};
    use super::*;
    use crate::nonlinear::{Event, EventKind};
    use crate::{FE, Value};

    fn method(id: &str, moment: f64) -> Method {
        Method {
            quantities: BTreeMap::from([(
                Quantity::BaseMoment.id().to_owned(),
                Value { value: moment, dimension: Dimension::Moment },
            )]),
            ..Method::new(id, id, Excitation::Record)
        }
    }

    const MODAL: Damping = Damping::Modal { sloshing: 0.005, structural: 0.02 };

    fn run() -> Happened {
        Happened {
            end: End::Completed,
            events: vec![Event {
                kind: EventKind::FirstCrack,
                title: "first crack".into(),
                time: 2.314,
                place: "base".into(),
                note: String::new(),
            }],
            hysteretic: 2e3,
            input: 1e4,
            damping: Some([MODAL; 2]),
        }
    }

    #[test]
    fn what_happened_is_the_cause() {
        let of = |moment, nonlinear| {
            let context = Context { nonlinear: Some(nonlinear), ..Context::default() };
            compare(&[method(FE, 10.0), method(EngineId::Nonlinear.beside(), moment)], &context, vec![]).differences
        };
        assert!(of(10.4, run()).is_empty());
        let difference = of(8.0, run()).remove(0);
        assert_eq!(difference.method, EngineId::Nonlinear.beside());
        assert_eq!((difference.ratios.len(), difference.ratios[0].ratio), (1, 0.8));
        assert_eq!(
            difference.reasons,
            [
                Reason::LeavesLinearTheory { events: 1 },
                Reason::Cracking,
                Reason::Dissipation { energy: 2e3, work: 1e4 }
            ]
        );
        let mut collapsed = run();
        collapsed.events.clear();
        let group = Damping::ByGroup { wall: 0.02, sloshing: 0.005 };
        collapsed.damping = Some([MODAL, group]);
        collapsed.end = End::Collapsed { time: 7.5, load_factor: None, reason: String::new(), place: String::new() };
        let damping = Reason::Damping { linear: MODAL, nonlinear: group };
        assert_eq!(
            of(8.0, collapsed).remove(0).reasons[..3],
            [Reason::NoEquilibrium { time: 7.5 }, Reason::StaysLinear, damping]
        );
    }
}
