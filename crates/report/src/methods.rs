//! How methods are named and drawn: short labels, palette classes and report order. Each method brings its own.

use results::compare::MEASURED;
use results::{FE, Method, Results};
use tank::assessment::{Excitation, Step};
use tank::units::Dimension;

/// Label, palette class and excitation of a method.
#[derive(Clone, Debug, PartialEq)]
pub struct Look {
    /// Short label.
    pub label: String,
    /// Palette class of `templates/figure.css`: colour and dash.
    pub class: String,
    /// True for the column on the design spectrum of the site.
    pub site: bool,
    /// True for the column to which all ratios refer.
    pub reference: bool,
}

/// The look of a method.
pub fn look(method: &Method) -> Look {
    let label = match method.label.as_str() {
        "" => &method.title,
        _ => &method.label,
    };
    Look {
        label: label.clone(),
        class: method.figure_key.clone(),
        site: method.excitation == Excitation::Site,
        reference: method.id == FE,
    }
}

impl Look {
    /// Label with the excitation where it is the site's.
    pub fn full_label(&self) -> String {
        if self.site { format!("{}, site", self.label) } else { self.label.clone() }
    }

    /// Classes of a curve: the site's spectrum draws thinner.
    pub fn line_class(&self) -> String {
        if self.site { format!("{} site", self.class) } else { self.class.clone() }
    }
}

/// How the names of the factors begin by which a code divides the forces of an elastic tank.
const DIVISORS: [&str; 3] = ["response modification", "response reduction", "behaviour factor"];

/// Whether quantities of this dimension are divided by them: not periods, masses and waves.
pub fn divides(dimension: Dimension) -> bool {
    use Dimension::{Force, LineForce, Moment, Stress};
    matches!(dimension, Force | LineForce | Moment | Stress)
}

/// Factors by which a method divides the forces of an elastic tank: "R_wi = 4, R_wc = 2"; empty without one. The modes of an engine have those
/// of the procedure whose spectrum they see.
pub fn divided(results: &Results, method: &Method) -> String {
    if method.excitation != Excitation::Site {
        return String::new();
    }
    let reduced = |line: &results::InputValue| line.path == "analysis.spectrum.reduced" && line.text == "false";
    let source = match method.is_run() {
        false => Some(method),
        true if results.input.iter().any(reduced) => None,
        true => (results.methods.iter())
            .find(|m| !m.is_run() && m.excitation == Excitation::Site && method.title.ends_with(&m.id)),
    };
    let divides = |step: &&Step| step.value != 1.0 && DIVISORS.iter().any(|name| step.name.starts_with(name));
    let mut factors: Vec<String> = Vec::new();
    for step in source.iter().flat_map(|method| &method.steps).filter(divides) {
        let factor = format!("{} = {}", step.symbol, step.value);
        if !factors.contains(&factor) {
            factors.push(factor);
        }
    }
    factors.join(", ")
}

/// The methods of a list that divide, a sentence each.
pub fn dividing(results: &Results, order: &[usize]) -> Vec<String> {
    let methods = order.iter().filter_map(|&i| results.methods.get(i));
    let of = |method: &Method| match divided(results, method) {
        by if by.is_empty() => None,
        by => Some(crate::words::figures::divided(&look(method).label, &by)),
    };
    methods.filter_map(of).collect()
}

/// The excitation in a word.
pub fn excitation(method: &Method) -> &'static str {
    match method.id.as_str() {
        MEASURED => "test",
        _ => method.excitation.word(),
    }
}

/// Indices of the methods for figures: finite elements, other engines, measurement, procedures on the record; the same on the spectrum
/// of the site.
pub fn figure_order(results: &Results) -> Vec<usize> {
    let rank = |m: &Method| match (m.id.as_str(), m.excitation) {
        (FE, Excitation::Record) => 0,
        (_, Excitation::Record) if m.is_run() => 1,
        (MEASURED, _) => 2,
        (_, Excitation::Record) => 3,
        (FE, Excitation::Site) => 4,
        _ if m.is_run() => 5,
        (_, Excitation::Site) => 6,
    };
    let mut order: Vec<usize> = (0..results.methods.len()).collect();
    order.sort_by_key(|&i| rank(&results.methods[i]));
    order
}
