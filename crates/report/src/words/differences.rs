//! Where the methods differ from the finite elements, and why.

use crate::number::plain;
use results::compare::{Damping, Difference, Ratio, Reason, THRESHOLD};
use results::nonlinear::Event;
use results::{EngineId, Results};
use tank::Quantity;
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
    let sentences: Vec<String> = difference.reasons.iter().map(|r| reason(r, events)).collect();
    sentences.join(" ")
}

/// One cause. `events` are those of the nonlinear run.
fn reason(reason: &Reason, events: &[Event]) -> String {
    match reason {
        Reason::Discretisation { .. }
        | Reason::TestGauges
        | Reason::TestScatter
        | Reason::SloshingDepth
        | Reason::UniformWall
        | Reason::RigidImpulsiveMass
        | Reason::AllSloshingModes
        | Reason::Coefficient1957
        | Reason::FittedMass => model(reason),
        Reason::FiniteAngleWave { damping }
        | Reason::SpectralPeakWave { damping }
        | Reason::FittedPeriodWave { damping } => wave(reason, *damping),
        Reason::RigidWall { .. }
        | Reason::FirstModeForces { .. }
        | Reason::AnyPeriodForces
        | Reason::FittedPeriodForces
        | Reason::ModalMaxima { .. } => forces(reason),
        _ => nonlinear(reason, events),
    }
}

/// Causes for periods and masses, for tests and for meshes.
fn model(reason: &Reason) -> String {
    let text = match reason {
        Reason::Discretisation { estimated } => {
            let list: Vec<String> = estimated
                .iter()
                .map(|e| format!("{} {:.1} %", super::quantity(e.quantity), 100.0 * e.error))
                .collect();
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
        Reason::TestScatter => {
            "A test value: the difference contains the scatter of the test and its instruments and the assumptions of linear theory \
             (small waves, perfect shell, rigid base)."
        }
        Reason::SloshingDepth => {
            "Both are first-mode formulas of the same potential flow; a difference indicates another liquid depth (slender \
             tanks) or to a rounded constant."
        }
        Reason::UniformWall => {
            "The procedure takes the period from a one-term formula for a uniform wall that ends at the liquid; the engine has \
             the real courses, the wall above the liquid, and the mass of wall and roof."
        }
        Reason::RigidImpulsiveMass => {
            "The procedure counts all liquid that does not slosh as impulsive (rigid wall); the engine's value is the mass of \
             the first structural mode alone, the rest moves with the higher modes and with the ground."
        }
        Reason::AllSloshingModes => {
            "Table A.2 lumps all sloshing modes into one convective mass (m − m_i); the engine's value is the first mode alone."
        }
        Reason::Coefficient1957 => {
            "The 1957 coefficient (0.318 for circular tanks) is 30 % below potential flow (0.4545); the exact coefficient \
             removes this difference."
        }
        _ => "The coefficient 0.230 D/H is a fit to the first mode; the difference is that of the fit.",
    };
    text.into()
}

/// Causes for the wave height.
fn wave(reason: &Reason, damping: f64) -> String {
    let damping = format!("{:.1} %", damping * 100.0);
    match reason {
        Reason::FiniteAngleWave { .. } => format!(
            "Housner's wave has one mode, a constant 25 % below potential flow for small waves, and a finite-angle \
             denominator that raises large ones; the engine sums five modes of linear theory at {damping} damping."
        ),
        Reason::SpectralPeakWave { .. } => format!(
            "The code's wave, 0.84 R S_e/g, is the first mode alone at its spectral peak; in the history the second to \
             fifth mode, at {damping} damping like the first, have other phases and may lower or raise the largest wave."
        ),
        _ => format!(
            "0.42 D A_f is the first mode alone, with the ordinate at the code's sloshing period (1.8 K_s √D); the engine \
             has the exact period and five modes at {damping} damping. Where the spectrum is steep, half a percent of \
             period already moves the ordinate."
        ),
    }
}

/// Causes for shear, moments and stresses.
fn forces(reason: &Reason) -> String {
    match *reason {
        Reason::RigidWall { amplification } => format!(
            "Housner's wall is rigid: the impulsive mass moves with the ground. In the engine it moves with the wall, at \
             {amplification:.2} times the peak ground acceleration."
        ),
        Reason::FirstModeForces { above } => format!(
            "The code gives the whole impulsive mass {} and adds the convective maximum to the impulsive one.",
            if above {
                "the acceleration of the first mode"
            } else {
                "one period and one acceleration"
            }
        ),
        Reason::AnyPeriodForces => {
            "The 9th edition takes one acceleration of the impulsive range, whatever the tank's period, and adds maxima."
                .into()
        }
        Reason::ModalMaxima {
            impulsive,
            convective,
            history,
        } => {
            let unit = units::column_unit([impulsive, history], Quantity::BaseShear.dimension());
            let print = |value: f64| units::display_in(value, unit, 3);
            format!(
                "Alone, the first structural mode has a base shear of {}, the first sloshing mode {}; the history, where the \
                 maxima do not coincide and higher modes act against them, peaks at {} ({:.2} of their sum).",
                print(impulsive),
                print(convective),
                print(history),
                history / (impulsive + convective)
            )
        }
        _ => "The code gives the whole impulsive mass one acceleration at a period from a fitted coefficient, and combines the \
              maxima by square roots."
            .into(),
    }
}

/// Causes found in the nonlinear run.
fn nonlinear(reason: &Reason, events: &[Event]) -> String {
    match *reason {
        Reason::LeftModel { time } => {
            format!("The run left its model and was stopped at {time:.2} s: its values are those until then.")
        }
        Reason::Interrupted { time } => {
            format!("The run was interrupted at {time:.2} s: its values are those until then.")
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
            "Yielding bounds the stress there and moves forces to where the wall is still elastic.".into()
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
    let when = if event.time > 0.0 {
        format!("at {:.2} s", event.time)
    } else {
        "in the static state".into()
    };
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
        let modal = Damping::Modal {
            sloshing: 0.005,
            structural: 0.02,
        };
        let estimated = vec![Estimated {
            quantity: Quantity::BaseMoment,
            error: 0.021,
        }];
        for (cause, part) in [
            (Reason::LeavesLinearTheory { events: 1 }, "first crack at 2.31 s (base)"),
            (Reason::NoEquilibrium { time: 7.5 }, "not find equilibrium after 7.50 s"),
            (Reason::Dissipation { energy: 2e3, work: 1e4 }, "20 %"),
            (Reason::Discretisation { estimated }, "error: base moment 2.1 %."),
            (Reason::RigidWall { amplification: 2.344 }, "at 2.34 times"),
            (Reason::SpectralPeakWave { damping: 0.005 }, "at 0.5 % damping"),
            (
                Reason::ModalMaxima {
                    impulsive: 6e4,
                    convective: 2e4,
                    history: 6.4e4,
                },
                "peaks at 64.0 kN (0.80 of their sum)",
            ),
            (
                Reason::Damping {
                    linear: modal,
                    nonlinear: Damping::MassProportional { ratio: 0.001 },
                },
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
            assert!(
                crate::words::quantity(q).starts_with(&q.id().replace('_', " ")),
                "{q:?}"
            );
        }
    }
}
