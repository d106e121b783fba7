//! How methods are named and drawn: short labels, palette classes and report order.

use tank::assessment::Excitation;

use results::{FE, Method, Results};

/// Label, palette class and excitation of a method.
#[derive(Clone, Debug, PartialEq)]
pub struct Look {
    /// Short label.
    pub label: String,
    /// Palette class of `templates/figure.css`: colour and dash.
    pub class: String,
    /// True for the column on the design spectrum of the site.
    pub site: bool,
}

/// The look of a method.
pub fn look(method: &Method) -> Look {
    let (label, class) = match method.id.as_str() {
        FE => ("Finite elements", "k-fe"),
        "fe-solid" => ("3-D elements", "k-fe-solid"),
        "fe-nonlinear" => ("Nonlinear elements", "k-fe-nonlinear"),
        "measured" => ("Measured", "k-measured"),
        "housner" => ("Housner", "k-housner"),
        "ec8-env" => ("ENV 1998-4", "k-ec8-env"),
        "ec8-2006" => ("EN 1998-4:2006", "k-ec8-2006"),
        "api650-1993" => ("API 650, 9th ed.", "k-api650-1993"),
        "api650-2020" => ("API 650 annex E", "k-api650-2020"),
        _ => (method.title.as_str(), "k-other"),
    };
    Look {
        label: label.into(),
        class: class.into(),
        site: method.excitation == Excitation::Site,
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

/// What shakes the tank, in a word.
pub fn excitation(method: &Method) -> &'static str {
    match (method.id.as_str(), method.excitation) {
        ("measured", _) => "test",
        (_, Excitation::Record) => "record",
        (_, Excitation::Site) => "site",
    }
}

/// Indices of the methods for figures: finite elements, the second engine, measurement, procedures on the record, on the site's spectrum.
pub fn figure_order(results: &Results) -> Vec<usize> {
    let rank = |m: &Method| match (m.id.as_str(), m.excitation) {
        (FE, _) => 0,
        _ if m.is_run() => 1,
        ("measured", _) => 2,
        (_, Excitation::Record) => 3,
        (_, Excitation::Site) => 4,
    };
    let mut order: Vec<usize> = (0..results.methods.len()).collect();
    order.sort_by_key(|&i| rank(&results.methods[i]));
    order
}
