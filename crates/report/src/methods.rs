//! How methods are named and drawn: short labels, palette classes and report order. Each method brings its own.

use results::compare::MEASURED;
use results::{FE, Method, Results};
use tank::assessment::Excitation;

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
        if self.site {
            format!("{}, site", self.label)
        } else {
            self.label.clone()
        }
    }

    /// Classes of a curve: the site's spectrum draws thinner.
    pub fn line_class(&self) -> String {
        if self.site {
            format!("{} site", self.class)
        } else {
            self.class.clone()
        }
    }
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
