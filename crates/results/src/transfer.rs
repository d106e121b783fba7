//! Transfer functions: the steady state under harmonic horizontal motion of the ground, as a part.

use serde::Deserialize;
use tank::options::frequency::FrequencyDamping;
use tank::units::Dimension;

use crate::part::{Amount, Axis, Block, Chart, Fact, Form, Line, Look, Message, Part, Room, Scale, Table};

/// Decades below the largest amplification that are drawn at most.
const DECADES: u8 = 5;
/// Modes of each kind that are marked.
const MARKED: usize = 3;

/// Amplitudes per unit of ground acceleration a(t) = cos Ωt: y(t) = |H| cos(Ωt + φ).
#[derive(Clone, Debug, Deserialize)]
pub struct Transfer {
    /// Damping.
    pub damping: FrequencyDamping,
    /// Frequencies Ω/2π [Hz], ascending.
    pub frequency: Vec<f64>,
    /// Modes of the engine.
    pub modes: Vec<TransferMode>,
    /// Wave, base shear and overturning moment.
    pub functions: Vec<TransferFunction>,
}

/// A mode of the engine that the transfer functions contain.
#[derive(Clone, Debug, Deserialize)]
pub struct TransferMode {
    /// Kind: `sloshing`, `structural`, `rotational`.
    pub kind: String,
    /// Number within its kind, from 1.
    pub number: usize,
    /// Frequency [Hz].
    pub frequency: f64,
    /// Damping ratio.
    pub damping: f64,
}

/// One transfer function.
#[derive(Clone, Debug, Deserialize)]
pub struct TransferFunction {
    /// Id, the beginning of its columns: `wave_height`, `base_shear`, `overturning_moment`.
    pub id: String,
    /// Unit in words for the heads of columns: `m_per_m_s2`, `n_per_m_s2`, `nm_per_m_s2`.
    pub unit: String,
    /// Quasi-static response, Ω → 0, with its sign [unit].
    pub static_value: f64,
    /// |H| [unit].
    pub magnitude: Vec<f64>,
    /// φ [rad], −π to π.
    pub phase: Vec<f64>,
}

impl Transfer {
    /// What is reported; the series `transfer` has a row a frequency.
    pub fn part(&self) -> Part {
        let plain = |id, form| (id, Dimension::Dimensionless, form);
        let modes = self.modes.iter().map(|mode| {
            let (kind, number) = (mode.kind.as_str(), mode.number as f64);
            vec![kind.into(), number.into(), mode.frequency.into(), mode.damping.into()]
        });
        let of_modes = [
            plain("kind", Form::Words),
            plain("number", Form::Usual),
            ("frequency", Dimension::Frequency, Form::Usual),
            plain("damping", Form::Usual),
        ];
        let peaks = [
            plain("quantity", Form::Words),
            plain("unit", Form::Words),
            plain("static", Form::Significant(4)),
            plain("largest", Form::Significant(4)),
            plain("amplification", Form::Significant(4)),
            ("frequency", Dimension::Frequency, Form::Significant(4)),
        ];
        let mut blocks = vec![Block::Note(Message::new("transfer-meaning"))];
        let charts = self.functions.iter().filter_map(|function| self.chart(function));
        blocks.extend(charts.map(Block::Chart));
        let rows = self.functions.iter().filter_map(|function| self.peak(function)).collect();
        blocks.push(Block::Table(Table::new("peaks", &peaks, rows)));
        blocks.push(Block::Note(Message::new("transfer-linear")));
        blocks.push(Block::Series(self.series()));
        blocks.push(Block::Series(Table::new("modes", &of_modes, modes.collect())));
        Part { id: "transfer".into(), blocks }
    }

    /// Amplification by frequency [Hz], point by point.
    fn amplification(&self, function: &TransferFunction) -> Vec<[f64; 2]> {
        let points = self.frequency.iter().zip(&function.magnitude);
        points
            .map(|(f, h)| [*f, h / function.static_value.abs()])
            .filter(|[f, a]| f.is_finite() && *f > 0.0 && a.is_finite() && *a > 0.0)
            .collect()
    }

    fn chart(&self, function: &TransferFunction) -> Option<Chart> {
        let points = self.amplification(function);
        let id = function.id.as_str();
        let kinds = ["sloshing", "structural"];
        let marked = |mode: &&TransferMode| mode.number <= MARKED && kinds.contains(&mode.kind.as_str());
        let mark = |mode: &TransferMode| {
            let kind = if mode.kind == kinds[0] { "c" } else { "i" };
            (mode.frequency, format!("f_{kind}{}", mode.number))
        };
        let damping = match self.damping {
            FrequencyDamping::AsEngine => "viscous",
            FrequencyDamping::Hysteretic => "hysteretic",
        };
        let x = Axis::new("frequency", Dimension::Frequency, Scale::Log);
        let y = Axis::new(&format!("ratio-{id}"), Dimension::Dimensionless, Scale::Decades(DECADES));
        (!points.is_empty()).then(|| Chart {
            caption: Some(
                Message::new("transfer-caption")
                    .with("static", Amount::ratio(function.static_value.abs()).form(Form::Significant(4)))
                    .with("unit", function.unit.as_str())
                    .with("damping", damping),
            ),
            room: Room::Wide,
            marks: self.modes.iter().filter(marked).map(mark).collect(),
            ..Chart::new(id, x, y, vec![Line::new(Fact::None, Look::Thin, points)])
        })
    }

    /// The largest value: a row of its table.
    fn peak(&self, function: &TransferFunction) -> Option<Vec<Fact>> {
        let points = self.amplification(function);
        let [frequency, ratio] = *points.iter().max_by(|a, b| a[1].total_cmp(&b[1]))?;
        let at_rest = function.static_value;
        let words = [function.id.as_str(), function.unit.as_str()].map(Fact::from);
        let numbers = [at_rest, ratio * at_rest.abs(), ratio, frequency].map(Fact::from);
        Some(words.into_iter().chain(numbers).collect())
    }

    /// Frequency, then magnitude and phase of each function.
    fn series(&self) -> Table {
        let mut heads = vec!["frequency_hz".to_owned()];
        for function in &self.functions {
            heads.push(format!("{}_magnitude_{}", function.id, function.unit));
            heads.push(format!("{}_phase_rad", function.id));
        }
        let columns: Vec<_> = heads.iter().map(|head| (head.as_str(), Dimension::Dimensionless, Form::Usual)).collect();
        let row = |i: usize| {
            let own = self.functions.iter().flat_map(|f| [f.magnitude[i], f.phase[i]]);
            std::iter::once(self.frequency[i]).chain(own).map(Fact::from).collect()
        };
        let whole = |f: &TransferFunction| f.magnitude.len().min(f.phase.len());
        let count = self.functions.iter().map(whole).fold(self.frequency.len(), usize::min);
        Table::new("transfer", &columns, (0..count).map(row).collect())
    }
}

/// A series of numbers as CSV: the first column with 9 significant digits, the others with 7.
pub(crate) fn csv(table: &Table) -> String {
    use std::fmt::Write;
    let heads: Vec<&str> = table.columns.iter().map(|column| column.id.as_str()).collect();
    let mut text = heads.join(",");
    text.push('\n');
    for row in &table.rows {
        for (i, value) in row.iter().filter_map(Fact::value).enumerate() {
            let _ = match i {
                0 => write!(text, "{value:.8e}"),
                _ => write!(text, ",{value:.6e}"),
            };
        }
        text.push('\n');
    }
    text
}
