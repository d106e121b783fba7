//! Where the methods part, and why.
//!
//! A parting is reported where a procedure under the *record's* spectrum differs from the finite-element history by more
//! than 10 %: there both saw the same ground motion, so the difference is the procedure's. Quantities that part for the
//! same cause stand together. The two engines are held to 1 %. The causes are those of the theory manual, with the numbers of this case put in.

use tank::Quantity;
use tank::assessment::Excitation;
use tank::units;

use super::{Context, FE, FE_NONLINEAR, FE_SOLID, nonlinear};
use crate::{ComparisonRow, Method, Parting};

/// Differences below this are within what record processing and damping assumptions move (theory manual).
const THRESHOLD: f64 = 0.10;

/// The two engines solve one problem: more than this between them is worth a word.
const ENGINES: f64 = 0.01;

/// Quantities whose differences have one cause.
const GROUPS: [(Cause, &[Quantity]); 6] = [
    (Cause::SloshingPeriod, &[Quantity::SloshingPeriod]),
    (Cause::Wave, &[Quantity::SloshingHeight]),
    (Cause::ImpulsivePeriod, &[Quantity::ImpulsivePeriod]),
    (Cause::ImpulsiveMass, &[Quantity::ImpulsiveMass]),
    (Cause::ConvectiveMass, &[Quantity::ConvectiveMass]),
    (
        Cause::Forces,
        &[
            Quantity::BaseShear,
            Quantity::BaseMoment,
            Quantity::OverturningMoment,
            Quantity::HoopStress,
            Quantity::AxialMembraneStress,
            Quantity::BendingStress,
        ],
    ),
];

/// Why a group of quantities parts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Cause {
    SloshingPeriod,
    Wave,
    ImpulsivePeriod,
    ImpulsiveMass,
    ConvectiveMass,
    Forces,
}

/// One paragraph a cause and method that parts from the engine, causes first.
pub fn explain(methods: &[Method], rows: &[ComparisonRow], context: &Context) -> Vec<Parting> {
    let mut partings = Vec::new();
    let mut modal_maxima = Some(modal_maxima(context));
    partings.extend(engines(methods, rows, context));
    partings.extend(nonlinear::explain(methods, rows, context));
    for (cause, quantities) in GROUPS {
        for (column, method) in methods.iter().enumerate() {
            if method.excitation != Excitation::Record || [FE, FE_SOLID, FE_NONLINEAR].contains(&method.id.as_str()) {
                continue;
            }
            let parted: Vec<(Quantity, f64)> = quantities
                .iter()
                .filter_map(|&quantity| {
                    let row = rows.iter().find(|row| row.quantity == quantity.id())?;
                    let ratio = row.cells[column]?.ratio?;
                    ((ratio - 1.0).abs() > THRESHOLD).then_some((quantity, ratio))
                })
                .collect();
            let Some(&(first, ratio)) = parted.first() else {
                continue;
            };
            let mut why = why(cause, method, ratio, context);
            if cause == Cause::Forces && method.id != "measured" {
                // Once is enough: it holds for all methods.
                why.push_str(&modal_maxima.take().unwrap_or_default());
            }
            partings.push(Parting {
                quantity: first.id().into(),
                what: what(method, &parted),
                why,
            });
        }
    }
    partings
}

/// Where the three-dimensional engine differs from the harmonic one: their meshes.
fn engines(methods: &[Method], rows: &[ComparisonRow], context: &Context) -> Option<Parting> {
    let column = methods.iter().position(|m| m.id == FE_SOLID)?;
    let parted = parted(rows, column, ENGINES);
    let &(first, _) = parted.first()?;
    let estimated: Vec<String> = parted
        .iter()
        .filter_map(|(quantity, _)| {
            let error = context.solid_mesh_error.get(quantity.id())?;
            Some(format!("{} {:.1} %", lower(*quantity), 100.0 * error))
        })
        .collect();
    let mut why = String::from(
        "Both engines solve the same linear problem, so what parts them is discretisation, mostly of the spatial mesh: \
         linear elements over radius, circumference and height against higher-order elements in a Fourier harmonic.",
    );
    if !estimated.is_empty() {
        why.push_str(&format!(
            " Its estimated discretisation error: {}.",
            estimated.join(", ")
        ));
    }
    why.push_str(" A finer --mesh must bring the two together; where it does not, one of them is wrong.");
    Some(Parting {
        quantity: first.id().into(),
        what: what(&methods[column], &parted),
        why,
    })
}

/// Quantities of a column whose ratio to the engine's is off by more than a threshold.
pub(super) fn parted(rows: &[ComparisonRow], column: usize, threshold: f64) -> Vec<(Quantity, f64)> {
    Quantity::ALL
        .into_iter()
        .filter_map(|quantity| {
            let row = rows.iter().find(|row| row.quantity == quantity.id())?;
            let ratio = row.cells[column]?.ratio?;
            ((ratio - 1.0).abs() > threshold).then_some((quantity, ratio))
        })
        .collect()
}

/// Title of a quantity within a sentence, without its symbol.
fn lower(quantity: Quantity) -> String {
    let title = quantity.title();
    let mut letters = title.split(" (").next().unwrap_or(title).chars();
    letters
        .next()
        .map_or(String::new(), |c| c.to_lowercase().chain(letters).collect())
}

/// "EN 1998-4: base shear 1.19, base moment 1.27 times the finite-element value."
pub(super) fn what(method: &Method, parted: &[(Quantity, f64)]) -> String {
    let list: Vec<String> = parted
        .iter()
        .map(|(quantity, ratio)| {
            let decimals = if (ratio - 1.0).abs() < THRESHOLD { 3 } else { 2 };
            format!("{} {ratio:.decimals$}", lower(*quantity))
        })
        .collect();
    format!("{}: {} times the finite-element value.", method.title, list.join(", "))
}

/// The cause of a difference, as far as the theory knows it.
fn why(cause: Cause, method: &Method, ratio: f64, context: &Context) -> String {
    let id = method.id.as_str();
    if id == "measured" {
        return measured(cause).into();
    }
    match cause {
        Cause::SloshingPeriod => "Both are first-mode formulas of the same potential flow; a difference points to another \
                                  liquid depth (slender tanks) or to a rounded constant."
            .into(),
        Cause::Wave => wave(id, context),
        Cause::ImpulsivePeriod => "The procedure takes the period from a one-term formula for a uniform wall that ends at \
                                   the liquid; the engine has the real courses, the wall above the liquid, and the mass \
                                   of wall and roof."
            .into(),
        Cause::ImpulsiveMass => "The procedure counts all liquid that does not slosh as impulsive (rigid wall); the \
                                 engine's value is the mass of the first structural mode alone, the rest moves with the \
                                 higher modes and with the ground."
            .into(),
        Cause::ConvectiveMass => match id {
            "ec8-2006" => "Table A.2 lumps all sloshing modes into one convective mass (m − m_i); the engine's value is \
                           the first mode alone."
                .into(),
            "housner" => "The 1957 coefficient (0.318 for circular tanks) is 30 % below potential flow (0.4545); the exact \
                          coefficient removes this difference."
                .into(),
            _ => "The coefficient 0.230 D/H is a fit to the first mode; the difference is that of the fit.".into(),
        },
        Cause::Forces => forces(id, ratio, context),
    }
}

/// What stands between a test and linear theory.
fn measured(cause: Cause) -> &'static str {
    match cause {
        Cause::Forces => {
            "A test value. It was read at the height of the strain gauges, inside the edge disturbance, while the engine's \
             value is the largest over the height or that of the base; the test wall could uplift and is not a perfect \
             shell. See the remark beside the value."
        }
        _ => {
            "A test value: scatter of the test and of its instruments stands beside the assumptions of linear theory \
             (small waves, perfect shell, rigid base)."
        }
    }
}

/// Causes for the wave height.
fn wave(id: &str, context: &Context) -> String {
    let damping = format!("{:.1} %", context.sloshing_damping * 100.0);
    match id {
        "housner" => format!(
            "Housner's wave has one mode, a constant 25 % below potential flow for small waves, and a finite-angle \
             denominator that raises large ones; the engine sums five modes of linear theory at {damping} damping."
        ),
        "ec8-env" | "ec8-2006" => format!(
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
fn forces(id: &str, ratio: f64, context: &Context) -> String {
    match id {
        "housner" => format!(
            "Housner's wall is rigid: the impulsive mass moves with the ground. In the engine it moves with the wall, at \
             {:.2} times the peak ground acceleration.",
            context.amplification()
        ),
        "ec8-env" | "ec8-2006" => format!(
            "The code gives the whole impulsive mass {} and adds the convective maximum to the impulsive one.",
            if ratio > 1.0 {
                "the acceleration of the first mode"
            } else {
                "one period and one acceleration"
            }
        ),
        "api650-1993" => {
            "The 9th edition takes one acceleration of the impulsive range, whatever the tank's period, and adds maxima."
                .into()
        }
        _ => "The code gives the whole impulsive mass one acceleration at a period from a fitted coefficient, and combines \
              the maxima by square roots."
            .into(),
    }
}

/// The largest shear of the first structural and the first sloshing mode beside that of the history.
fn modal_maxima(context: &Context) -> String {
    let sum = context.impulsive_shear + context.convective_shear;
    if sum <= 0.0 || context.history_shear <= 0.0 {
        return String::new();
    }
    let unit = units::column_unit(
        [context.impulsive_shear, context.history_shear],
        Quantity::BaseShear.dimension(),
    );
    let print = |value: f64| units::display_in(value, unit, 3);
    format!(
        " Alone, the first structural mode has a base shear of {}, the first sloshing mode {}; the history, where the maxima \
         do not coincide and higher modes act against them, peaks at {} ({:.2} of their sum).",
        print(context.impulsive_shear),
        print(context.convective_shear),
        print(context.history_shear),
        context.history_shear / sum
    )
}
