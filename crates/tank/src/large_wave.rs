//! Crest and trough of a wave that is not small, from the wave of linear theory.
//!
//! ```text
//! crest = η (1 + c η/R)      trough = η (1 − 0.7 c η/R)      c(H/R) from order-3 potential flow
//! ```
//!
//! η is the largest linear wave at the wall, R the radius or half the length. The factors were computed by
//! `cargo run --release -p fem --example large_wave -- factors` (three cycles in resonance, damping 0.5 %; the larger of
//! those of crests a tenth and a fifth above the linear wave). For c η/R ≤ 0.25 the crest holds to 3 %, that of a strip shallower than
//! 0.35 to 4 %; above it the factor is too low, and waves break.

use crate::{Case, Quantity, Shape};

/// c η/R up to which the crest is at most a tenth higher than the linear wave: above it a wave is not small.
pub const SMALL: f64 = 0.1;

/// c η/R up to which the crest holds to 3 %: above it the crest is a lower bound.
const FITTED: f64 = 0.25;

/// (H/R, c of a cylinder, c of a strip over 2H/L).
const FACTORS: [(f64, f64, f64); 19] = [
    (0.2, 5.74, 17.90),
    (0.25, 4.75, 12.62),
    (0.3, 4.19, 8.21),
    (0.35, 3.49, 5.84),
    (0.4, 2.56, 4.66),
    (0.45, 2.10, 3.59),
    (0.5, 1.89, 2.61),
    (0.55, 1.67, 2.12),
    (0.6, 1.43, 1.92),
    (0.65, 1.22, 1.82),
    (0.7, 1.07, 1.70),
    (0.75, 1.00, 1.54),
    (0.8, 0.94, 1.37),
    (0.9, 0.86, 1.11),
    (1.0, 0.81, 0.99),
    (1.25, 0.76, 0.85),
    (1.5, 0.75, 0.81),
    (2.0, 0.74, 0.79),
    (3.0, 0.74, 0.78),
];

/// The factor of a tank.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LargeWave {
    /// c.
    pub factor: f64,
    /// R, or half the length [m].
    pub half_length: f64,
    /// Whether H/R lies below the table: c is then the power of H/R that its first two rows have. Above the table it is the last value.
    shallow: bool,
}

impl LargeWave {
    /// The factor of the tank of a case.
    pub fn of(case: &Case) -> LargeWave {
        LargeWave::new(case.tank.shape, case.liquid.fill_height)
    }

    /// The factor of liquid of a depth [m] in a tank of a shape.
    pub fn new(shape: Shape, depth: f64) -> LargeWave {
        let column = |row: &(f64, f64, f64)| if matches!(shape, Shape::Cylinder { .. }) { row.1 } else { row.2 };
        let half_length = shape.half_length();
        let share = depth / half_length;
        let last = FACTORS[FACTORS.len() - 1];
        // Two rows of the table around H/R, or its first two; c is nearly a power of H/R between them.
        let pair = FACTORS.windows(2).find(|pair| share <= pair[1].0);
        let factor = pair.map_or(column(&last), |pair| {
            let [a, b] = [&pair[0], &pair[1]];
            column(a) * (share / a.0).powf((column(b) / column(a)).ln() / (b.0 / a.0).ln())
        });
        LargeWave { factor, half_length, shallow: share < FACTORS[0].0 }
    }

    /// c η/R of a linear wave η [m].
    pub fn excess(&self, linear: f64) -> f64 {
        self.factor * linear / self.half_length
    }

    /// Crest over a linear wave η [m].
    pub fn crest(&self, linear: f64) -> f64 {
        linear * (1.0 + self.excess(linear))
    }

    /// Trough under a linear wave η [m], at least half of it.
    pub fn trough(&self, linear: f64) -> f64 {
        linear * (1.0 - 0.7 * self.excess(linear)).max(0.5)
    }

    /// c η/R up to which the factor is exact to 3 %; of a liquid shallower than the table only that of small waves.
    pub fn fitted(&self) -> f64 {
        if self.shallow { SMALL } else { FITTED }
    }

    /// The linear wave up to which waves are small [m].
    pub fn small(&self) -> f64 {
        SMALL * self.half_length / self.factor
    }

    /// Both as quantities.
    pub fn quantities(&self, linear: f64) -> [(Quantity, f64); 2] {
        [(Quantity::SloshingCrest, self.crest(linear)), (Quantity::SloshingTrough, self.trough(linear))]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Crest and trough over the linear wave by an independent program (order 3, 16 modes), printed with two decimals: (H/R, η/R, crest, trough).
    const SHEET: [(f64, f64, f64, f64); 12] = [
        (0.2, 0.025, 1.13, 0.91),
        (0.4, 0.025, 1.05, 0.95),
        (0.4, 0.05, 1.12, 0.90),
        (0.6, 0.05, 1.06, 0.95),
        (0.6, 0.1, 1.14, 0.90),
        (0.75, 0.05, 1.05, 0.96),
        (0.75, 0.1, 1.10, 0.92),
        (0.75, 0.2, 1.20, 0.85),
        (1.5, 0.1, 1.07, 0.93),
        (1.5, 0.2, 1.15, 0.88),
        (2.0, 0.1, 1.07, 0.93),
        (2.0, 0.2, 1.15, 0.88),
    ];

    #[test]
    fn crests_are_those_of_an_independent_program() {
        for (share, rise, crest, trough) in SHEET {
            let large = LargeWave::new(Shape::Cylinder { radius: 4.0 }, 4.0 * share);
            let wave = 4.0 * rise;
            assert!(large.excess(wave) <= large.fitted(), "{share} {rise}");
            let [high, low] = [large.crest(wave), large.trough(wave)].map(|value| value / wave);
            assert!(
                (high / crest - 1.0).abs() < 0.03 && (low / trough - 1.0).abs() < 0.03,
                "{share} {rise}: {high} {low}"
            );
        }
    }

    /// Shallower liquid has sharper crests, deep liquid the same at any depth; R of a rectangle is half its length.
    #[test]
    fn outside_the_table() {
        let of = |depth: f64| LargeWave::new(Shape::Cylinder { radius: 10.0 }, depth);
        assert!(of(1.0).factor > of(2.0).factor && of(1.0).fitted() < of(2.0).fitted());
        assert_eq!(of(30.0), of(80.0));
        let strip = LargeWave::new(Shape::Rectangle { length: 20.0, breadth: 3.0, strip: true }, 10.0);
        assert!((strip.small() - 1.0 / strip.factor).abs() < 1e-12);
        assert!(strip.trough(20.0) == 10.0);
    }
}
