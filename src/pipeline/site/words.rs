//! The modes of an engine under the design spectrum of the site.

use results::EngineId;
use tank::Quantity;
use tank::options::linear::{ModalCombination, PartCombination, SpectrumOptions};
use tank::outside::Outside;

use tank::units::significant;

/// Heading of the spectral accelerations.
pub(super) const SHEET: &str = "Spectral accelerations of the modes";

/// Source of the spectral accelerations.
pub(super) const CLAUSE: &str = "response-spectrum method";

/// What the column is for.
pub(super) const INFORMATION: &str = "For comparison: no limit state is checked under this excitation; the checks of an engine are those of its \
     time history under the record.";

/// Vertical motion is left out.
pub(super) const NO_VERTICAL: &str = "Horizontal motion only: the procedure of this spectrum adds vertical motion, which raises its hoop stress; \
     this column does not.";

/// Vertical motion is combined; `beside` is the share of the horizontal action where the vertical one leads.
pub(super) fn vertical(beside: f64) -> String {
    format!(
        "Vertical motion: axisymmetric modes of the engine (the breathing wall) under the vertical elastic spectrum at 3 % damping, what is not \
         in the modes kept follows the ground, by the same rule; stresses and pressures are the larger of E_h + 0.3 E_v and {} E_h + E_v \
         (EN 1998-1 4.3.3.5.2).",
        significant(beside, 3)
    )
}

/// Name of the breathing mode, and where its acceleration is read.
pub(super) fn breathing(period: f64) -> (String, String) {
    (
        "axisymmetric (breathing) mode, vertical motion".into(),
        format!("vertical spectrum at T = {} s", significant(period, 4)),
    )
}

/// The same of what follows the ground upwards.
pub(super) fn upward_rest() -> (String, String) {
    ("what follows the ground upwards".into(), "vertical spectrum at T = 0".into())
}

/// Title of the column.
pub(super) fn title(engine: EngineId, code: &str) -> String {
    let space = match engine {
        EngineId::Solid => " in three dimensions",
        EngineId::Harmonic | EngineId::Nonlinear => "",
    };
    format!("Finite elements{space}, response-spectrum method with the spectrum of {code}")
}

/// The named spectrum is not there.
pub(super) fn no_data(code: &str) -> String {
    format!("`site` does not give the data of the design spectrum of `{code}`")
}

/// How modes are combined.
pub(super) fn combination(options: &SpectrumOptions) -> String {
    let rule = match options.combination {
        ModalCombination::Cqc => "complete quadratic combination (CQC)",
        ModalCombination::Srss => "square root of the sum of squares (SRSS)",
        ModalCombination::Abs => "sum of absolute values",
    };
    let parts = match options.parts {
        PartCombination::Modal => "all modes together",
        PartCombination::Srss => "impulsive and convective parts separately, then SRSS of the two",
        PartCombination::Abs => "impulsive and convective parts separately, then their sum",
    };
    let rest = match options.missing_mass {
        true => "the missing mass follows the ground with the acceleration at T = 0",
        false => "the missing mass is left out",
    };
    format!("Largest responses of the modes: {rule}, for each quantity and place; {parts}; {rest}.")
}

/// The quantity with the largest mesh error.
pub(super) fn mesh_error(quantity: &str, error: f64) -> String {
    let title = Quantity::from_id(quantity).map_or(quantity, |q| q.title()).to_lowercase();
    format!("Largest estimated mesh error: {} ({title}).", percent(error))
}

/// Why numbers of the column are outside the model.
pub(super) fn outside(why: Outside) -> &'static str {
    match why {
        Outside::Uplift => {
            "The tank is unanchored and the wall pulls at its base: it lifts off, which the engine does not model; forces and stresses are \
             outside the model."
        }
        Outside::Plates => {
            "The walls of the box bend as plates held at three sides, but the engine models cantilevers: impulsive period, forces and stresses are \
             outside the model."
        }
    }
}

/// Name of a mode, and where its acceleration is read.
pub(super) fn mode(kind: &str, number: usize, period: f64, damping: f64) -> (String, String) {
    (
        format!("{kind} mode {number}"),
        format!("design spectrum at T = {} s; damping of the mode {}", significant(period, 4), percent(damping)),
    )
}

/// The same of what follows the ground.
pub(super) fn rest() -> (String, String) {
    ("what follows the ground".into(), "design spectrum at T = 0".into())
}

/// A share in per cent, with two digits.
fn percent(share: f64) -> String {
    format!("{} %", significant(100.0 * share, 2))
}
