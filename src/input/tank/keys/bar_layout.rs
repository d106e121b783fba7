//! Bars that their concrete cannot hold: outside of it, on each other, or too many of them.
//!
//! Source: EN 1992-1-1:2004 8.2(2) (clear distance), 4.4.1.2 (cover), 9.2.1.1(3) and 9.6.2(1) (largest area), recalled.

use std::f64::consts::PI;

use files::code::Code;
use tank::units::{Dimension, display};
use tank::words::Words;
use tank::{BarDirection, Layer, Reinforcement, Tank};

use crate::input::tank::resolver::Resolver;

/// Least cover and clear distance of bars [m]; a bar's diameter where that is more.
const COVER: f64 = 0.01;
const CLEAR: f64 = 0.02;
/// Largest usual share of bars of one direction in a section.
const SHARE: f64 = 0.04;

/// All layers of bars; what is the same in several courses is told once.
pub(super) fn warn(r: &mut Resolver<'_>, tank: &Tank) {
    let mut told: Vec<String> = Vec::new();
    let layers = tank.courses.iter().flat_map(|course| &course.layers);
    for (code, text) in layers.flat_map(faults) {
        if !told.contains(&text) {
            r.warn(code, format!("tank.courses: {text}"));
            told.push(text);
        }
    }
}

fn faults(layer: &Layer) -> Vec<(Code, String)> {
    let mut found: Vec<(Code, String)> = layer.reinforcement.iter().flat_map(|bars| of(layer, bars)).collect();
    for direction in [BarDirection::Hoop, BarDirection::Vertical] {
        let bars = layer.reinforcement.iter().filter(|bars| bars.direction == direction);
        let share = bars.map(|bars| bars.area).sum::<f64>() / layer.thickness;
        if share > SHARE {
            let text = format!(
                "{} bars are {:.1} % of the section, usual are at most {:.0} %, EN 1992-1-1 9.2.1.1(3)",
                direction.word(),
                100.0 * share,
                100.0 * SHARE
            );
            found.push((Code::UnusualTank, text));
        }
    }
    found
}

/// One layer of bars whose diameter is known.
fn of(layer: &Layer, bars: &Reinforcement) -> Vec<(Code, String)> {
    let Some(diameter) = bars.diameter else { return Vec::new() };
    let length = |value: f64| display(value, Dimension::Length);
    let what = format!("{} bars of {}", bars.direction.word(), length(diameter));
    let cover = bars.depth.min(layer.thickness - bars.depth) - 0.5 * diameter;
    let clear = PI * diameter * diameter / (4.0 * bars.area) - diameter;
    let mut found = Vec::new();
    if cover < 0.0 {
        found.push((Code::Inconsistent, format!("{what} stand out of the concrete")));
    } else if cover < COVER * (1.0 - 1e-9) {
        let text = format!("{what} have a cover of {}, usual are 10 mm and more", length(cover));
        found.push((Code::UnusualTank, text));
    }
    if clear < 0.0 {
        found.push((Code::Inconsistent, format!("{what} overlap")));
    } else if clear < CLEAR.max(diameter) * (1.0 - 1e-9) {
        let text = format!("{what} are {} apart, usual are {} and more", length(clear), length(CLEAR.max(diameter)));
        found.push((Code::UnusualTank, text));
    }
    found
}
