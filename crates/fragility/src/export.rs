//! Files for other programs.
//!
//! | program | file | parameters |
//! |---|---|---|
//! | pelicun and its damage and loss model library | CSV of components | θ and β of `lognormal` families |
//! | OpenQuake | NRML 0.5, `fragilityModel` | **mean and standard deviation** of the variable, not θ and β |
//!
//! OpenQuake turns them back with σ² = ln(1 + sd²/mean²) and μ = ln mean − σ²/2.

use std::fmt::Write;

use files::text::{cell, xml};

use crate::Lognormal;

/// The curves of a component from mild to severe, by name.
#[derive(Clone, Debug, PartialEq)]
pub struct Component {
    /// Id.
    pub id: String,
    /// Names and curves.
    pub states: Vec<(String, Lognormal)>,
}

/// A name in a list separated by blanks.
fn word(name: &str) -> String {
    xml(&name.split_whitespace().collect::<Vec<_>>().join("_"))
}

/// Components for pelicun. All have the columns of the one with the most states.
///
/// * `demand`, `unit`: type and unit of the demand, such as `Peak Ground Acceleration` and `mps2`
pub fn pelicun(components: &[Component], demand: &str, unit: &str) -> String {
    let most = components.iter().map(|c| c.states.len()).max().unwrap_or(0);
    let mut text = String::from("ID,Incomplete,Demand-Type,Demand-Unit,Demand-Offset,Demand-Directional");
    for i in 1..=most {
        let _ = write!(text, ",LS{i}-Family,LS{i}-Theta_0,LS{i}-Theta_1,LS{i}-DamageStateWeights");
    }
    text.push('\n');
    for component in components {
        let _ = write!(text, "{},0,{},{},0,0", cell(&component.id), cell(demand), cell(unit));
        for i in 0..most {
            match component.states.get(i) {
                Some((_, curve)) => {
                    let _ = write!(text, ",lognormal,{},{},", curve.median, curve.dispersion);
                }
                None => text.push_str(",,,,"),
            }
        }
        text.push('\n');
    }
    text
}

/// A fragility model in NRML 0.5.
///
/// * `imt`: intensity measure as OpenQuake writes it, `PGA` or `SA(0.3)`; accelerations in g
/// * `scale`: unit of the curves in that of the measure
/// * `range`: smallest and largest intensity
pub fn nrml(components: &[Component], imt: &str, scale: f64, range: [f64; 2]) -> String {
    let mut states: Vec<&str> = Vec::new();
    for (name, _) in components.iter().flat_map(|c| &c.states) {
        if !states.contains(&name.as_str()) {
            states.push(name);
        }
    }
    let mut text = String::from(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<nrml xmlns=\"http://openquake.org/xmlns/nrml/0.5\">\n  <fragilityModel id=\"tanks\" \
         assetCategory=\"structures\" lossCategory=\"structural\">\n    <description>Liquid storage tanks</description>\n",
    );
    let names: Vec<String> = states.iter().map(|s| word(s)).collect();
    let _ = writeln!(text, "    <limitStates>{}</limitStates>", names.join(" "));
    for component in components {
        let _ = writeln!(
            text,
            "    <fragilityFunction id=\"{}\" format=\"continuous\" shape=\"logncdf\">\n      <imls imt=\"{}\" noDamageLimit=\"{}\" minIML=\"{}\" maxIML=\"{}\"/>",
            xml(&component.id),
            xml(imt),
            range[0] * scale,
            range[0] * scale,
            range[1] * scale
        );
        for (name, curve) in &component.states {
            let _ = writeln!(
                text,
                "      <params ls=\"{}\" mean=\"{}\" stddev=\"{}\"/>",
                word(name),
                curve.mean() * scale,
                curve.standard_deviation() * scale
            );
        }
        text.push_str("    </fragilityFunction>\n");
    }
    text.push_str("  </fragilityModel>\n</nrml>\n");
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    fn components() -> Vec<Component> {
        let curve = |median, dispersion| Lognormal { median, dispersion };
        vec![
            Component {
                id: "T1".into(),
                states: vec![("DS1".into(), curve(2.0, 0.4)), ("DS2".into(), curve(4.0, 0.5))],
            },
            Component {
                id: "T<2>".into(),
                states: vec![("DS1".into(), curve(3.0, 0.3)), ("big  <leak>".into(), curve(5.0, 0.3))],
            },
        ]
    }

    #[test]
    fn every_row_of_pelicun_has_the_columns_of_the_head() {
        let text = pelicun(&components(), "Peak Ground Acceleration", "mps2");
        let columns: Vec<usize> = text.lines().map(|line| line.split(',').count()).collect();
        assert_eq!(columns, [14, 14, 14]);
        assert!(text.lines().nth(1).unwrap().starts_with("T1,0,Peak Ground Acceleration,mps2,0,0,lognormal,2,0.4,"));
    }

    /// What OpenQuake computes from mean and deviation are θ and β again.
    #[test]
    fn nrml_gives_the_curve_back() {
        let text = nrml(&components(), "PGA", 1.0 / 9.80665, [0.5, 9.0]);
        assert!(text.contains("id=\"T&lt;2&gt;\""));
        // A list has blanks between its names, not in them.
        assert!(text.contains("<limitStates>DS1 DS2 big_&lt;leak&gt;</limitStates>"));
        let line = text.lines().find(|l| l.contains("params")).unwrap();
        let number = |key: &str| -> f64 {
            let rest = line.split_once(&format!("{key}=\"")).unwrap().1;
            rest.split_once('"').unwrap().0.parse().unwrap()
        };
        let (mean, deviation) = (number("mean"), number("stddev"));
        let sigma = (1.0 + (deviation / mean).powi(2)).ln().sqrt();
        assert!((sigma - 0.4).abs() < 1e-12);
        assert!(((mean.ln() - 0.5 * sigma * sigma).exp() * 9.80665 - 2.0).abs() < 1e-12);
    }
}
