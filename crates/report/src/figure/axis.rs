//! Axes of charts: scale, ticks and labels.

use std::f64::consts::TAU;

use plotters::coord::ranged1d::{DefaultFormatting, KeyPointHint, Ranged};
use tank::units::Dimension;

use super::ticks;
use super::width::{FONT, text_width};
use crate::number::{Scale, plain};
use crate::words::labels::ANGLE_AXIS;

/// An axis. Positions are in drawing space: the value in the printed unit, or its decimal logarithm.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// Title with unit.
    pub title: String,
    scale: Scale,
    log: bool,
    pub(super) range: (f64, f64),
    major: Vec<(f64, String)>,
    minor: Vec<f64>,
}

impl Axis {
    /// A linear axis that holds `values` (SI), with a little air at the ends that are not zero.
    pub fn linear(title: &str, dimension: Dimension, values: impl IntoIterator<Item = f64>, count: usize) -> Axis {
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        for v in values.into_iter().filter(|v| v.is_finite()) {
            low = low.min(v);
            high = high.max(v);
        }
        if low > high {
            (low, high) = (0.0, 1.0);
        }
        if low == high {
            (low, high) = (low.min(0.0), if high > 0.0 { high } else { low.min(0.0) + 1.0 });
        }
        let air = 0.05 * (high - low);
        let low = if low == 0.0 { 0.0 } else { low - air };
        let high = if high == 0.0 { 0.0 } else { high + air };
        Axis::exact(title, dimension, (low, high), count)
    }

    /// A linear axis from `range.0` to `range.1` (SI).
    pub fn exact(title: &str, dimension: Dimension, range: (f64, f64), count: usize) -> Axis {
        let scale = Scale::single(dimension, [range.0, range.1]);
        let (low, high) = (scale.convert(range.0), scale.convert(range.1));
        let (positions, decimals) = ticks(low, high, count);
        Axis {
            title: titled(title, scale.symbol()),
            scale,
            log: false,
            range: (low, high),
            major: positions.into_iter().map(|p| (p, plain(p, decimals))).collect(),
            minor: Vec::new(),
        }
    }

    /// The circumference: 0 to 2π, ticks every 45° in degrees.
    pub fn around() -> Axis {
        let ticks = (0..=8).map(f64::from);
        Axis {
            title: ANGLE_AXIS.into(),
            scale: Scale::single(Dimension::Angle, [TAU]),
            log: false,
            range: (0.0, TAU),
            major: ticks.map(|k| (k * TAU / 8.0, plain(45.0 * k, 0))).collect(),
            minor: Vec::new(),
        }
    }

    /// Whole numbers from 1 to `count`.
    pub fn whole(title: &str, count: usize) -> Axis {
        let every = count.div_ceil(12).max(1);
        let ticks = (1..=count).step_by(every);
        Axis {
            title: title.into(),
            scale: Scale::of(Dimension::Dimensionless, [1.0]),
            log: false,
            range: (0.5, count as f64 + 0.5),
            major: ticks.map(|k| (k as f64, plain(k as f64, 0))).collect(),
            minor: Vec::new(),
        }
    }

    /// A logarithmic axis from `range.0` to `range.1` (SI, both positive), ticks at 1, 2, 5.
    pub fn log(title: &str, dimension: Dimension, range: (f64, f64)) -> Axis {
        let scale = Scale::single(dimension, [1.0]);
        // Only positive values have a decade.
        let decades = |v: f64| v.clamp(1e-300, 1e300).max(1e-300).log10();
        let (low, high) = (decades(scale.convert(range.0)), decades(scale.convert(range.1)));
        let (mut major, mut minor) = (Vec::new(), Vec::new());
        for decade in low.floor() as i32..=high.ceil() as i32 {
            for digit in 1..10 {
                let value = f64::from(digit) * 10f64.powi(decade);
                let position = value.log10();
                if position < low - 1e-9 || position > high + 1e-9 {
                    continue;
                }
                if matches!(digit, 1 | 2 | 5) {
                    major.push((position, plain(value, (-decade).max(0) as usize)));
                } else {
                    minor.push(position);
                }
            }
        }
        Axis { title: titled(title, scale.symbol()), scale, log: true, range: (low, high), major, minor }
    }

    /// The same logarithmic axis with labels at powers of ten alone, for many decades.
    pub fn by_decades(mut self) -> Axis {
        let whole = |p: f64| (p - p.round()).abs() < 1e-9;
        let (major, rest): (Vec<_>, Vec<_>) = self.major.into_iter().partition(|(p, _)| whole(*p));
        self.major = major;
        self.minor.extend(rest.into_iter().map(|(p, _)| p));
        self.minor.sort_by(f64::total_cmp);
        self
    }

    /// Position of a value (SI) in drawing space.
    pub fn position(&self, value: f64) -> f64 {
        let value = self.scale.convert(value);
        if self.log { value.log10() } else { value }
    }

    /// Whether the axis holds this value (SI).
    pub fn holds(&self, value: f64) -> bool {
        let p = self.position(value);
        p >= self.range.0 - 1e-9 && p <= self.range.1 + 1e-9
    }

    pub(super) fn label_at(&self, position: f64) -> String {
        self.major
            .iter()
            .find(|(p, _)| (p - position).abs() < 1e-9 * (1.0 + position.abs()))
            .map_or(String::new(), |(_, text)| text.clone())
    }

    pub(super) fn widest_label(&self) -> f64 {
        self.major.iter().map(|(_, t)| text_width(t)).fold(0.0, f64::max) * FONT
    }
}

/// An axis as plotters sees it.
pub(super) struct Span {
    range: (f64, f64),
    major: Vec<f64>,
    minor: Vec<f64>,
}

impl Span {
    pub(super) fn of(axis: &Axis) -> Span {
        Span { range: axis.range, major: axis.major.iter().map(|(p, _)| *p).collect(), minor: axis.minor.clone() }
    }
}

impl Ranged for Span {
    type FormatOption = DefaultFormatting;
    type ValueType = f64;

    fn map(&self, value: &f64, limit: (i32, i32)) -> i32 {
        // Far off the page it stops: whole pixels, and few enough to step through.
        let part = ((value - self.range.0) / (self.range.1 - self.range.0)).clamp(-100.0, 100.0);
        limit.0 + (part * f64::from(limit.1 - limit.0)).round() as i32
    }

    fn key_points<Hint: KeyPointHint>(&self, hint: Hint) -> Vec<f64> {
        if hint.weight().allow_light_points() { self.minor.clone() } else { self.major.clone() }
    }

    fn range(&self) -> std::ops::Range<f64> {
        self.range.0..self.range.1
    }
}

/// `title [unit]`.
pub fn titled(title: &str, unit: &str) -> String {
    if unit.is_empty() { title.into() } else { format!("{title} [{unit}]") }
}
