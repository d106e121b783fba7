//! The join of procedures and engine: quantity × method, ratios to the finite-element column of the same excitation, differences, verdict.
//!
//! All that is found is a typed fact with its numbers; the report puts it into words.

mod apart;
mod attribution;
mod chain;
mod difference;
mod factors;
mod mesh_error;
mod nonlinear;
mod outside;

use std::collections::BTreeMap;

use tank::Quantity;
use tank::assessment::Excitation;

pub use apart::{Apart, Differs, Shaken, Why, apart};
pub use attribution::THRESHOLD;
pub use chain::{CLOSED, Engine, Held, Made, Spectrum};
pub use difference::{Damping, Difference, Estimated, Incomplete, Ratio, Reason};
pub use factors::{Attribution, FactorStep};
pub use mesh_error::{Unusable, unusable};
pub use outside::depends;

use crate::nonlinear::{End, Event};
use crate::{Cell, Comparison, ComparisonRow, FE, Method};

/// Id of the column of measured values.
pub const MEASURED: &str = "measured";

/// Lays the methods side by side.
///
/// `published` are values others have given for this tank; they are carried along, not compared.
pub fn compare(methods: &[Method], context: &Context, published: Vec<tank::case::Reported>) -> Comparison {
    // Under the spectrum of the site its own column of the engine, where there is one: both sides then see the same action.
    let fe = |excitation: Excitation| methods.iter().find(|m| m.id == FE && m.excitation == excitation);
    let reference = |m: &Method| match m.excitation {
        Excitation::Site => fe(Excitation::Site).filter(|fe| !fe.quantities.is_empty()).or(fe(Excitation::Record)),
        Excitation::Record => fe(Excitation::Record),
    };
    let rows: Vec<ComparisonRow> = Quantity::ALL
        .into_iter()
        .filter_map(|quantity| {
            let of = |m: &Method| m.quantities.get(quantity.id()).map(|v| v.value);
            // A quotient that overflows is not a ratio.
            let base = |m: &Method| reference(m).and_then(of).filter(|v| *v != 0.0);
            let cells: Vec<Option<Cell>> = methods
                .iter()
                .map(|m| {
                    of(m).map(|value| Cell {
                        value,
                        ratio: base(m).map(|base| value / base).filter(|ratio| ratio.is_finite()),
                        unusable: false,
                        outside: false,
                    })
                })
                .collect();
            cells.iter().any(Option::is_some).then(|| ComparisonRow {
                quantity: quantity.id().into(),
                title: quantity.title().into(),
                dimension: quantity.dimension(),
                cells,
            })
        })
        .collect();
    let differences = attribution::attribute(methods, &rows, context);
    Comparison { rows, differences, attribution: context.attribution.clone(), published, ..Comparison::default() }
}

/// Facts for the attribution of differences, in addition to the methods' values.
#[derive(Clone, Debug, Default)]
pub struct Context {
    /// Estimated discretisation error of the three-dimensional engine by quantity id, relative.
    pub solid_mesh_error: BTreeMap<String, f64>,
    /// Attributions of the procedures' values.
    pub attribution: Vec<Attribution>,
    /// The course of the nonlinear run.
    pub nonlinear: Option<Happened>,
}

/// The course of a nonlinear run, as far as it explains differences from the linear one.
#[derive(Clone, Debug, PartialEq)]
pub struct Happened {
    /// How it ended.
    pub end: End,
    /// First crack, first yield and the like, by time.
    pub events: Vec<Event>,
    /// Dissipated by the materials until the end of the run [J].
    pub hysteretic: f64,
    /// Work of the loads until then [J].
    pub input: f64,
    /// Damping of the linear and of the nonlinear run, where they are known.
    pub damping: Option<[Damping; 2]>,
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use tank::units::Dimension;

    use super::*;
    use crate::Value;

    fn method(id: &str, shear: f64) -> Method {
        Method {
            quantities: BTreeMap::from([(
                "base_shear".to_string(),
                Value { value: shear, dimension: Dimension::Force },
            )]),
            ..Method::new(id, id, Excitation::Record)
        }
    }

    #[test]
    fn ratios_refer_to_the_finite_element_column() {
        let comparison = compare(&[method("housner", 30.0), method("fe", 40.0)], &Context::default(), vec![]);
        assert_eq!(comparison.rows.len(), 1);
        assert_eq!(comparison.rows[0].cells[0].and_then(|c| c.ratio), Some(0.75));
        assert_eq!(comparison.rows[0].cells[1].and_then(|c| c.ratio), Some(1.0));
    }

    /// A code under the site's spectrum is compared with the engine under it, or with the history where there is none.
    #[test]
    fn each_excitation_has_its_reference() {
        let site = |id: &str, shear: f64| Method { excitation: Excitation::Site, ..method(id, shear) };
        let both = [method("code", 30.0), site("code", 10.0), method("fe", 40.0), site("fe", 20.0)];
        let ratios = |methods: &[Method]| -> Vec<f64> {
            let row = &compare(methods, &Context::default(), vec![]).rows[0];
            row.cells.iter().filter_map(|c| c.as_ref()?.ratio).collect()
        };
        assert_eq!(ratios(&both), [0.75, 0.5, 1.0, 1.0]);
        assert_eq!(ratios(&both[..3]), [0.75, 0.25, 1.0]);
        assert_eq!(ratios(&[site("code", 10.0), site("fe", 20.0)]), [0.5, 1.0]);
    }

    /// Results of earlier versions state causes that were guessed; they are read and not shown.
    #[test]
    fn withdrawn_causes_are_read() {
        for text in [r#"{ "kind": "sloshing-depth" }"#, r#"{ "kind": "rigid-wall", "amplification": 2.3 }"#] {
            let reason: Reason = serde_json::from_str(text).expect("a cause");
            assert_eq!(reason, Reason::Withdrawn);
        }
        let kept: Reason = serde_json::from_str(r#"{ "kind": "test-scatter" }"#).expect("a cause");
        assert_eq!(kept, Reason::TestScatter);
    }

    #[test]
    fn without_an_engine_there_are_values_and_no_ratios() {
        let comparison = compare(&[method("housner", 30.0)], &Context::default(), vec![]);
        assert_eq!(
            comparison.rows[0].cells[0],
            Some(Cell { value: 30.0, ratio: None, unusable: false, outside: false })
        );
    }
}
