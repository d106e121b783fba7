//! Where the methods differ from the finite elements, and why.

use crate::number::plain;
use results::compare::{Damping, Difference, FactorStep, Ratio, Reason, THRESHOLD};
use results::nonlinear::Event;
use results::{EngineId, Results};
use tank::assessment::Excitation;
use tank::units::{self, Dimension};

/// "EN 1998-4: base shear 1.19, base moment 1.27 times the finite-element value."
pub fn what(results: &Results, difference: &Difference) -> String {
    let mut methods = results.methods.iter();
    let method = methods.find(|m| m.id == difference.method && m.excitation == Excitation::Record);
    let title = method.map_or(difference.method.as_str(), |m| m.title.as_str());
    let list: Vec<String> = difference.ratios.iter().map(ratio).collect();
    let reference = match difference.method == EngineId::Nonlinear.beside() {
        true => "the linear value",
        false => "the finite-element value",
    };
    format!("{title}: {} times {reference}.", list.join(", "))
}

fn ratio(found: &Ratio) -> String {
    let decimals = if (found.ratio - 1.0).abs() < THRESHOLD { 3 } else { 2 };
    format!("{} {:.decimals$}", super::quantity(found.quantity), found.ratio)
}

/// The causes of a difference, one or more sentences; empty where none is known.
pub fn why(results: &Results, difference: &Difference) -> String {
    let run = results.beside(EngineId::Nonlinear);
    let events = run.map_or(&[][..], |run| &run.events);
    let sentences = difference.reasons.iter().map(|r| reason(r, events));
    let sentences: Vec<String> = sentences.filter(|s| !s.is_empty()).collect();
    sentences.join(" ")
}

/// One cause. `events` are those of the nonlinear run.
fn reason(reason: &Reason, events: &[Event]) -> String {
    match reason {
        Reason::Discretisation { .. } | Reason::TestGauges | Reason::TestScatter => model(reason),
        Reason::Factors { steps } => largest(steps),
        Reason::Withdrawn => String::new(),
        _ => nonlinear(reason, events),
    }
}

/// Causes for tests and for meshes.
fn model(reason: &Reason) -> String {
    let text = match reason {
        Reason::Discretisation { estimated } => {
            let list: Vec<String> =
                estimated.iter().map(|e| format!("{} {:.1} %", super::quantity(e.quantity), 100.0 * e.error)).collect();
            let estimated = match list.is_empty() {
                true => String::new(),
                false => format!(" Its estimated discretisation error: {}.", list.join(", ")),
            };
            return format!(
                "Both engines solve the same linear problem; they differ by discretisation, mostly of the spatial mesh: linear elements \
                 over radius, circumference and height against higher-order elements in a Fourier harmonic.{estimated} The \
                 difference must decrease with a finer --mesh; if it does not, one of the engines is wrong."
            );
        }
        Reason::TestGauges => {
            "A test value. It was read at the height of the strain gauges, inside the edge disturbance, while the engine's \
             value is the largest over the height or that of the base; the test wall could uplift and is not a perfect \
             shell. See the remark on the value."
        }
        _ => {
            "A test value: the difference contains the scatter of the test and its instruments and the assumptions of linear theory \
             (small waves, perfect shell, rigid base)."
        }
    };
    text.into()
}

/// "Largest factors: lever arms 1.31, impulsive period 0.80."
fn largest(steps: &[FactorStep]) -> String {
    let list: Vec<String> = steps.iter().map(|step| format!("{} {:.2}", step.factor_id.name(), step.factor)).collect();
    let what = if steps.len() == 1 { "Largest factor" } else { "Largest factors" };
    format!("{what}: {}.", list.join(", "))
}

/// Causes found in the nonlinear run.
fn nonlinear(reason: &Reason, events: &[Event]) -> String {
    match *reason {
        Reason::LeftModel { time } => {
            format!("The run left its model and was stopped at {time:.2} s; its values end there.")
        }
        Reason::Interrupted { time } => {
            format!("The run was interrupted at {time:.2} s; its values end there.")
        }
        Reason::NotCarriedAtRest => "The wall does not carry weight and static pressure: the run has no history.".into(),
        Reason::NoEquilibrium { time } => format!(
            "The run did not find equilibrium after {time:.2} s; its values are lower bounds."
        ),
        Reason::LeavesLinearTheory { events: count } => {
            let list: Vec<String> = events.iter().take(count).map(told).collect();
            format!("The run leaves linear theory: {}.", list.join("; "))
        }
        Reason::Damping {
            linear,
            nonlinear: other,
        } => format!("Damping differs: linear {}; nonlinear {}.", damping(&linear), damping(&other)),
        Reason::Cracking => "Cracks soften the wall: its period grows, its deflections with it, and the forces follow the \
                             spectrum to the longer period."
            .into(),
        Reason::Yielding => {
            "Yielding limits the stress there and shifts forces to parts of the wall that are still elastic.".into()
        }
        Reason::Dissipation { energy, work } => format!(
            "The materials dissipate {}, {} % of the work of the loads.",
            units::display(energy, Dimension::Energy),
            units::significant(100.0 * energy / work, 2)
        ),
        _ => "The wall does not crack, yield or separate. The remaining causes are mesh, damping, large rotations and the pressure on \
              the deformed wall."
            .into(),
    }
}

/// "first crack at 2.31 s (base, θ = 0°)".
fn told(event: &Event) -> String {
    let when = if event.time > 0.0 { format!("at {:.2} s", event.time) } else { "in the static state".into() };
    format!("{} {when} ({})", event.title, event.place)
}

/// Damping of a run within a sentence.
pub fn damping(damping: &Damping) -> String {
    let percent = |ratio: f64| units::significant(100.0 * ratio, 3);
    match *damping {
        Damping::Modal { sloshing, structural } => format!(
            "modal, {} % in sloshing modes, {} % in structural modes",
            plain(100.0 * sloshing, 3),
            plain(100.0 * structural, 3)
        ),
        Damping::Rayleigh { mass, stiffness } => {
            format!("Rayleigh, C = a_M M + a_K K with a_M = {mass:.5} 1/s, a_K = {stiffness:.6} s")
        }
        Damping::ByGroup { wall, sloshing } => format!(
            "wall {} % at the first mode of wall and liquid, proportional to its initial stiffness, sloshing modes {} % each",
            percent(wall),
            percent(sloshing)
        ),
        Damping::Caughey { pairs, first, last } => format!(
            "Caughey's series through {pairs} ratios, from {} % at {} rad/s to {} % at {} rad/s",
            percent(first[1]),
            units::significant(first[0], 4),
            percent(last[1]),
            units::significant(last[0], 4)
        ),
        Damping::InitialRayleigh { first, second } => format!(
            "Rayleigh on the initial stiffness, {} % at {} rad/s and {} % at {} rad/s",
            percent(first[1]),
            units::significant(first[0], 4),
            percent(second[1]),
            units::significant(second[0], 4)
        ),
        Damping::MassProportional { ratio } => format!("proportional to the mass, {} %", percent(ratio)),
    }
}

#[cfg(test)]
mod tests {
    use results::compare::Estimated;
    use results::nonlinear::EventKind;
    use tank::Quantity;

    use super::*;

    #[test]
    fn causes_name_their_numbers() {
        let event = Event {
            kind: EventKind::FirstCrack,
            title: "first crack".into(),
            time: 2.314,
            place: "base".into(),
            note: String::new(),
        };
        let modal = Damping::Modal { sloshing: 0.005, structural: 0.02 };
        let estimated = vec![Estimated { quantity: Quantity::BaseMoment, error: 0.021 }];
        for (cause, part) in [
            (Reason::LeavesLinearTheory { events: 1 }, "first crack at 2.31 s (base)"),
            (Reason::NoEquilibrium { time: 7.5 }, "not find equilibrium after 7.50 s"),
            (Reason::Dissipation { energy: 2e3, work: 1e4 }, "20 %"),
            (Reason::Discretisation { estimated }, "error: base moment 2.1 %."),
            (
                Reason::Factors {
                    steps: vec![FactorStep { factor_id: tank::factor::Factor::LeverArm, factor: 1.314, value: 2.0 }],
                },
                "Largest factor: lever arms 1.31.",
            ),
            (
                Reason::Damping { linear: modal, nonlinear: Damping::MassProportional { ratio: 0.001 } },
                "nonlinear proportional to the mass, 0.100 %",
            ),
        ] {
            let text = reason(&cause, std::slice::from_ref(&event));
            assert!(text.contains(part), "`{part}` is missing in {text}");
        }
    }

    /// The id of a quantity in words begins its name.
    #[test]
    fn quantities_have_their_names() {
        for q in Quantity::ALL {
            assert!(crate::words::quantity(q).starts_with(&q.id().replace('_', " ")), "{q:?}");
        }
    }
}
