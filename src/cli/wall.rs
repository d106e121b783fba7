//! The build-up of layered walls in words, for the summary of `check`.

use tank::units::{Dimension, display};
use tank::words::Words;
use tank::{Behaviour, Layer, Tank};

use files::text::line;
use report::words::terminal as words;

/// One line per layered course: `course 1: 6.00 mm liner (steel) | 250 mm wall (concrete; hoop 15.0 cm²/m at 40.0 mm
/// of bars)`.
pub(crate) fn lines(tank: &Tank) -> Vec<String> {
    let layered = tank.courses.iter().enumerate().filter(|(_, c)| !c.layers.is_empty());
    layered
        .map(|(i, course)| {
            let layers: Vec<String> = course.layers.iter().map(layer).collect();
            words::course(i + 1, &layers, course.thickness, course.material.youngs_modulus)
        })
        .collect()
}

fn layer(layer: &Layer) -> String {
    let bars: String = (layer.reinforcement.iter())
        .map(|bar| {
            format!(
                "; {} {} at {} of {}",
                bar.direction.word(),
                display(bar.area, Dimension::LineArea),
                display(bar.depth, Dimension::Length),
                line(&bar.material.name)
            )
        })
        .collect();
    let kind = match layer.material.behaviour {
        Behaviour::Interlayer(l) if l.shear_modulus == 0.0 => words::NO_SHEAR,
        ref behaviour => behaviour.kind(),
    };
    format!("{} {} ({kind}{bars})", display(layer.thickness, Dimension::Length), line(&layer.material.name))
}
