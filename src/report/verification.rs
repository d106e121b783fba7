//! The figure of the verification manual.

use codes::units::Dimension;

use crate::error::Error;
use crate::report::figure::chart::{Axis, Chart, Line};
use crate::report::figure::{Figure, Room};
use crate::report::table::{Column, Table};

/// Relative errors of the first three sloshing frequencies over the refinement of the mesh, both logarithmic, as a
/// stand-alone SVG; `points` holds (refinement, errors).
///
/// Errors: a drawing that fails.
pub fn convergence(points: &[(f64, [f64; 3])]) -> Result<String, Error> {
    let place = |refine: f64, error: f64| (refine.log2(), error.abs().max(1e-16).log10());
    let line = |n: usize| Line {
        points: points
            .iter()
            .map(|(refine, errors)| place(*refine, errors[n]))
            .collect(),
        class: format!("k-s{}", n + 1),
        label: format!("mode {}", n + 1),
    };
    let lines: Vec<Line> = (0..3).map(line).collect();
    let all = || lines.iter().flat_map(|l| &l.points);
    let mut chart = Chart::new(
        (520.0, 360.0),
        Axis::linear(
            "log₂ of the refinement",
            Dimension::Dimensionless,
            all().map(|p| p.0),
            4,
        ),
        Axis::linear(
            "log₁₀ of the relative error",
            Dimension::Dimensionless,
            all().map(|p| p.1),
            7,
        ),
    );
    // Order 4: the slope that quadratic elements owe to an eigenvalue.
    if let Some((refine, errors)) = points.first() {
        let start = place(*refine, errors[2]);
        let steps = points.last().map_or(0.0, |(last, _)| (last / refine).log2());
        let fall = 4.0 * 2.0_f64.log10() * steps;
        chart.lines.push(Line {
            points: vec![start, (start.0 + steps, start.1 - fall)],
            class: "k-other thin".into(),
            label: "order 4".into(),
        });
    }
    chart.lines.extend(lines);
    let mut table = Table::new(vec![Column::numbers("Refinement", ""), Column::numbers("Mode 1", "")]);
    for (refine, errors) in points {
        table.row(vec![format!("{refine}"), format!("{:.2e}", errors[0])]);
    }
    let figure = Figure {
        id: "convergence".into(),
        title: "Convergence of the sloshing frequencies".into(),
        caption: String::new(),
        titled: true,
        description:
            "Relative error of the first three sloshing frequencies of tank 8.1 against the closed form, falling \
                      with the fourth power of the element size."
                .into(),
        size: chart.size,
        markup: chart.draw()?,
        table,
        room: Room::Wide,
    };
    Ok(figure.standalone(include_str!("../../templates/figure.css")))
}
