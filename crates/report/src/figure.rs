//! Figures: SVG whose looks come from CSS classes alone, so that dark mode, print and colour-blind-safe palettes are one
//! style sheet.
//!
//! Line charts are drawn by plotters on a backend that writes classes instead of colours ([`backend`]); forms that
//! plotters lacks (bars, the sketch of the tank, mode shapes, the four-way grid, scenes in space, maps) are drawn by the small writer [`svg`].

pub mod axis;
pub mod backend;
pub mod bars;
pub mod cells;
pub mod chart;
pub mod cracks;
pub mod decimate;
pub mod emf;
pub mod fourway;
pub mod map;
pub mod perimeter;
pub mod plain;
pub mod rocking;
pub mod scene;
pub mod shapes;
pub mod sketch;
pub mod svg;
pub mod wall;
pub mod waterfall;
pub mod width;

use serde::Serialize;

use crate::table::Table;
use svg::{escape, n};

/// Width of a figure as wide as the text, in user units; 11 units of type are then 7.7 pt on A4.
pub const WIDE: f64 = 720.0;
/// Width of a figure half as wide as the text.
pub const HALF: f64 = 352.0;

/// Pixels of the screen a user unit takes at most.
const SCREEN: f64 = 1.2;

/// How much room a figure takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Room {
    /// The whole width of the text.
    Wide,
    /// Half the width.
    Half,
    /// A third of the width.
    Third,
}

/// A figure with its description and its data.
#[derive(Clone, Debug, PartialEq)]
pub struct Figure {
    /// Id, unique in the report; the name of the file in `figures/`.
    pub id: String,
    /// Title, the first words of the caption.
    pub title: String,
    /// The rest of the caption, may be empty.
    pub caption: String,
    /// Text alternative of the drawing.
    pub description: String,
    /// Size in user units.
    pub size: (f64, f64),
    /// SVG markup without the `svg` element.
    pub markup: String,
    /// The numbers drawn (thinned where there are many).
    pub table: Table,
    /// Room.
    pub room: Room,
}

impl Figure {
    /// A figure without caption, which takes the room of its width.
    pub fn new(
        id: impl Into<String>,
        title: impl Into<String>,
        (size, markup): ((f64, f64), String),
        table: Table,
    ) -> Figure {
        let room = match size.0 {
            wide if wide > HALF => Room::Wide,
            HALF => Room::Half,
            _ => Room::Third,
        };
        let (caption, description) = (String::new(), String::new());
        Figure { id: id.into(), title: title.into(), caption, description, size, markup, table, room }
    }

    /// With the rest of the caption.
    #[must_use]
    pub fn captioned(self, caption: impl Into<String>) -> Figure {
        Figure { caption: caption.into(), ..self }
    }

    /// With the text alternative of the drawing.
    #[must_use]
    pub fn described(self, description: impl Into<String>) -> Figure {
        Figure { description: description.into(), ..self }
    }

    /// The figure as an element for the page.
    pub fn inline(&self) -> String {
        self.element("", "")
    }

    /// The figure as a separate file; `css` is the style sheet of figures.
    pub fn standalone(&self, css: &str) -> String {
        let style = format!("<style>{}</style>", escape(css));
        let mut text = String::from("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
        text.push_str(&self.element(" xmlns=\"http://www.w3.org/2000/svg\"", &style));
        text.push('\n');
        text
    }

    fn element(&self, namespace: &str, style: &str) -> String {
        let id = escape(&self.id);
        let (width, height) = (n(self.size.0), n(self.size.1));
        // A separate figure has a size; inside the page it is as wide as its place, with the same type size.
        let size = if namespace.is_empty() {
            format!(r#" style="max-width:{}px""#, n(SCREEN * self.size.0))
        } else {
            format!(r#" width="{width}" height="{height}""#)
        };
        format!(
            r#"<svg{namespace} class="fig" role="img" aria-labelledby="{id}-t {id}-d" viewBox="0 0 {width} {height}"{size}><title id="{id}-t">{}</title><desc id="{id}-d">{}</desc>{style}{}</svg>"#,
            escape(&self.title),
            escape(&self.description),
            self.markup
        )
    }
}

/// Ticks at round numbers (1, 2, 5 × 10ⁿ) within `[low, high]`, about `target` of them, and the decimals they need.
pub fn ticks(low: f64, high: f64, target: usize) -> (Vec<f64>, usize) {
    let span = high - low;
    if !span.is_finite() || span <= 0.0 {
        return (vec![low], 3);
    }
    let rough = span / target.max(1) as f64;
    let power = 10f64.powf(rough.log10().floor());
    let step =
        [1.0, 2.0, 5.0, 10.0].into_iter().map(|m| m * power).find(|s| *s >= rough * 0.999).unwrap_or(10.0 * power);
    // Steps below anything that is drawn, or below the last digit of the ends: the range is not divided.
    let most = low.abs().max(high.abs()) / step;
    if step < 1e-15 || most.is_nan() || most >= 1e15 {
        return (vec![low], 3);
    }
    let first = (low / step - 1e-9).ceil() as i64;
    let last = (high / step + 1e-9).floor() as i64;
    let decimals = (-step.log10().floor()).max(0.0) as usize;
    ((first..=last).map(|i| i as f64 * step).collect(), decimals)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_are_round() {
        assert_eq!(ticks(0.0, 1.0, 5), (vec![0.0, 0.2, 0.4, 0.6000000000000001, 0.8, 1.0], 1));
        assert_eq!(ticks(-37.0, 52.0, 4).0, vec![0.0, 50.0]);
        assert_eq!(ticks(3.0, 3.0, 4).0, vec![3.0]);
        assert_eq!(ticks(0.0, 5e-324, 4).0, vec![0.0]);
        assert_eq!(ticks(1e20, 1e20 + 16384.0, 4).0, vec![1e20]);
    }
}
