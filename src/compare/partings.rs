//! Where the methods part, and why.
//!
//! A parting is reported where a procedure under the *record's* spectrum differs from the finite-element history by more
//! than 10 %: there both saw the same ground motion, so the difference is the procedure's. The causes are those of the
//! theory manual, with the numbers of this case put in.

use codes::Quantity;
use codes::procedure::Excitation;

use super::{Context, FE};
use crate::results::{ComparisonRow, Method, Parting};

/// Differences below this are within what record processing and damping assumptions move (theory manual).
const THRESHOLD: f64 = 0.10;

/// One paragraph a quantity and method that parts from the engine.
pub fn explain(methods: &[Method], rows: &[ComparisonRow], context: &Context) -> Vec<Parting> {
    let mut partings = Vec::new();
    for row in rows {
        let Some(quantity) = Quantity::from_id(&row.quantity) else {
            continue;
        };
        for (method, cell) in methods.iter().zip(&row.cells) {
            let ratio = cell.and_then(|c| c.ratio);
            let Some(ratio) = ratio else { continue };
            if method.excitation != Excitation::Record || method.id == FE || (ratio - 1.0).abs() <= THRESHOLD {
                continue;
            }
            partings.push(Parting {
                quantity: row.quantity.clone(),
                what: format!(
                    "{}: {} gives {:.2} times the finite-element value ({:+.0} %).",
                    quantity.title(),
                    method.title,
                    ratio,
                    (ratio - 1.0) * 100.0
                ),
                why: cause(quantity, method, ratio, context),
            });
        }
    }
    partings
}

/// The cause of a difference, as far as the theory knows it.
fn cause(quantity: Quantity, method: &Method, ratio: f64, context: &Context) -> String {
    let id = method.id.as_str();
    if id == "measured" {
        return "A measured value: scatter of the test, of its instruments and of the table motion stand beside the \
                assumptions of linear theory (small waves, perfect shell, rigid base)."
            .into();
    }
    let amplification = if context.pga > 0.0 {
        context.impulsive_acceleration / context.pga
    } else {
        f64::NAN
    };
    let wall = format!(
        "In the engine the wall is flexible and the liquid that moves with it follows S_a(T_impulsive, {:.1} %) = {:.2} \
         times the peak ground acceleration",
        context.impulsive_damping * 100.0,
        amplification
    );
    match quantity {
        Quantity::SloshingPeriod => "Both are first-mode formulas of the same potential flow; a difference points to \
                                     another liquid depth (slender tanks) or to a rounded constant."
            .into(),
        Quantity::SloshingHeight => sloshing_height(id, context),
        Quantity::ImpulsivePeriod => {
            "The procedure takes the period from a one-term formula for a uniform wall that ends \
                                      at the liquid; the engine has the real courses, the wall above the liquid, the \
                                      wall's and the roof's mass."
                .into()
        }
        Quantity::ImpulsiveMass => {
            "The procedure counts all liquid that does not slosh as impulsive (rigid wall); the \
                                    engine's value is the mass of the first structural mode alone, the rest moves with \
                                    the higher modes and with the ground."
                .into()
        }
        Quantity::ConvectiveMass => match id {
            "ec8-2006" => {
                "Table A.2 lumps all sloshing modes into one convective mass (m − m_i); the engine's value is \
                           the first mode alone."
                    .into()
            }
            "housner" => {
                "The 1957 coefficient 0.318 (circular tank) is 30 % below potential flow (0.4545 at first mode); \
                          select the exact coefficient to remove this difference."
                    .into()
            }
            _ => "The coefficient 0.230 D/H is a fit to the first mode; differences stem from the fit.".into(),
        },
        Quantity::BaseShear
        | Quantity::BaseMoment
        | Quantity::OverturningMoment
        | Quantity::HoopStress
        | Quantity::AxialMembraneStress
        | Quantity::BendingStress => forces(id, ratio, &wall),
    }
}

/// Causes for the wave height.
fn sloshing_height(id: &str, context: &Context) -> String {
    let damping = format!("{:.1} %", context.sloshing_damping * 100.0);
    match id {
        "housner" => format!(
            "Housner's wave has one mode, the constant 0.408 (25 % below potential flow for small waves) and a \
             finite-angle denominator that raises large waves; the engine sums five modes of linear theory at {damping} \
             damping."
        ),
        "ec8-env" | "ec8-2006" => format!(
            "0.84 R S_e/g is the first mode alone at its spectral peak; the engine adds the second to fifth mode with \
             their phases at {damping} damping."
        ),
        _ => format!(
            "0.42 D A_f is the first mode alone with the spectral ordinate at the code's sloshing period (1.8 K_s √D); \
             the engine has the exact period and five modes at {damping} damping. Where the spectrum is steep, half a \
             percent of period already moves the ordinate."
        ),
    }
}

/// Causes for shear, moments and stresses.
fn forces(id: &str, ratio: f64, wall: &str) -> String {
    match id {
        "housner" => format!(
            "Housner's wall is rigid: the impulsive mass moves with the ground. {wall}. Peaks of the impulsive and \
             convective parts are added although they do not coincide."
        ),
        "ec8-env" | "ec8-2006" => {
            let sum = "The code gives the whole impulsive mass one period and one acceleration and adds the convective \
                       maximum to the impulsive one; in the history the higher structural modes have their own \
                       accelerations and the maxima do not coincide.";
            if ratio > 1.0 {
                sum.to_string()
            } else {
                format!("{sum} {wall}.")
            }
        }
        "api650-1993" => format!(
            "The 9th edition takes the largest spectral acceleration of the impulsive range, whatever the tank's period. \
             {wall}."
        ),
        _ => format!(
            "The code takes a period from a fitted coefficient for a uniform wall, one acceleration for the whole \
             impulsive mass, and combines by square roots. {wall}."
        ),
    }
}
