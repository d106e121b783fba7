//! Mode shapes: section through the tank at θ = 0 and θ = π with the wall's displacement and the liquid's surface.

use super::svg::Svg;
use results::Mode;

/// Width of a picture, its greatest height, and the largest displacement drawn.
const WIDTH: f64 = 230.0;
const HIGHEST: f64 = 210.0;
const AMPLITUDE: f64 = 20.0;

/// Draws a mode of a tank of this half length, wall height and depth [m]; returns size and markup.
///
/// The shape is scaled so that its largest displacement is the same in every picture.
pub fn draw(mode: &Mode, half_length: f64, wall_height: f64, depth: f64) -> ((f64, f64), String) {
    let mut svg = Svg::new();
    let tallest = wall_height.max(depth);
    let above = AMPLITUDE + 6.0;
    let scale = ((WIDTH - 2.0 * AMPLITUDE - 20.0) / (2.0 * half_length)).min((HIGHEST - above - 8.0) / tallest);
    let centre = WIDTH / 2.0;
    let ground = above + tallest * scale;
    let size = (WIDTH, ground + 8.0);
    let amplitude = AMPLITUDE;
    // cos mθ at θ = π.
    let sign = if mode.harmonic.is_multiple_of(2) { 1.0 } else { -1.0 };
    let x = |r: f64| centre + r * scale;
    let y = |z: f64| ground - z * scale;

    // Undeformed.
    svg.path(
        &[(x(-half_length), y(depth)), (x(half_length), y(depth)), (x(half_length), y(0.0)), (x(-half_length), y(0.0))],
        true,
        "liq",
    );
    for side in [-1.0, 1.0] {
        svg.line((x(side * half_length), y(0.0)), (x(side * half_length), y(wall_height)), "rest");
    }
    svg.line((x(-half_length), y(depth)), (x(half_length), y(depth)), "rest");
    svg.line((x(-half_length) - 14.0, ground), (x(half_length) + 14.0, ground), "gd");

    // Surface: given over the radius, or over the whole length.
    let whole = mode.shape.r.first().is_some_and(|r| *r < -1e-9 * half_length);
    let mut surface: Vec<(f64, f64)> = Vec::new();
    if !whole {
        for (r, eta) in mode.shape.r.iter().zip(&mode.shape.surface).rev() {
            surface.push((x(-r), y(depth) - sign * amplitude * eta));
        }
    }
    for (r, eta) in mode.shape.r.iter().zip(&mode.shape.surface) {
        surface.push((x(*r), y(depth) - amplitude * eta));
    }
    svg.curve(&surface, "ln k-water");
    for side in [-1.0, 1.0] {
        // Outward displacement; on the left outward is −x.
        let factor = if side > 0.0 { amplitude } else { -sign * amplitude };
        let wall: Vec<(f64, f64)> = mode
            .shape
            .z
            .iter()
            .zip(&mode.shape.wall)
            .map(|(z, w)| (x(side * half_length) + factor * w, y(*z)))
            .collect();
        svg.curve(&wall, "ln k-fe");
    }
    (size, svg.into_markup())
}
