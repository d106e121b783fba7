//! Histories of a run: columns of `series.csv`, each a [`Channel`], and their entries in the results.

use oscillator::record::Record;
use tank::case::GroundMotion;

use results::channel::Ground;
use results::{Channel, Series, SeriesInfo};

/// Histories at common times.
#[derive(Default)]
pub(crate) struct Histories {
    /// Entry of each in the results.
    pub info: Vec<SeriesInfo>,
    /// The columns.
    pub series: Series,
}

impl Histories {
    /// None yet, at these times [s].
    pub(crate) fn at(time: Vec<f64>) -> Histories {
        Histories { info: Vec::new(), series: Series { time, ..Series::default() } }
    }

    /// Adds a history.
    pub(crate) fn push(&mut self, info: SeriesInfo, column: Vec<f64>) {
        self.series.ids.push(info.id.clone());
        self.series.columns.push(column);
        self.info.push(info);
    }

    /// Keeps the histories whose channel `keep` holds.
    pub(crate) fn retain(&mut self, keep: impl Fn(Channel) -> bool) {
        let kept = |info: &SeriesInfo| info.channel().is_none_or(&keep);
        let flags: Vec<bool> = self.info.iter().map(kept).collect();
        let mut flag = flags.iter();
        self.series.ids.retain(|_| flag.next().is_none_or(|keep| *keep));
        let mut flag = flags.iter();
        self.series.columns.retain(|_| flag.next().is_none_or(|keep| *keep));
        let mut flag = flags.iter();
        self.info.retain(|_| flag.next().is_none_or(|keep| *keep));
    }

    /// Adds the ground motion: along x, along y, vertical.
    pub(crate) fn push_ground(&mut self, motion: &GroundMotion) {
        type Named = fn(Ground) -> Channel;
        let named: [Named; 3] = [
            |motion| Channel::Ground { motion, vertical: false },
            Channel::GroundY,
            |motion| Channel::Ground { motion, vertical: true },
        ];
        let records = [Some(&motion.horizontal), motion.transverse.as_ref(), motion.vertical.as_ref()];
        for (channel, record) in named.into_iter().zip(records) {
            let Some(record) = record else { continue };
            let columns = ground(record, &self.series.time);
            for (component, column) in columns {
                let channel = channel(component);
                let peak = (0..column.len()).fold(0, |w, i| if column[i].abs() > column[w].abs() { i } else { w });
                let peak = (column[peak].abs(), self.series.time[peak]);
                self.push(SeriesInfo::of(channel, 0.0, peak), column);
            }
        }
    }
}

/// Acceleration, velocity and displacement of the ground at the given times. After the record the ground moves on
/// without acceleration.
fn ground(record: &Record, times: &[f64]) -> [(Ground, Vec<f64>); 3] {
    let motion = record.motion();
    let end = record.acceleration.len() - 1;
    let (v_end, d_end) = (motion.velocity[end], motion.displacement[end]);
    // Sample at or before each time and the share of the next; `None` after the record.
    let places: Vec<Option<(usize, f64)>> = times
        .iter()
        .map(|t| {
            let steps = t / record.dt;
            let nearest = steps.round();
            let steps = if (nearest - steps).abs() < 1e-6 { nearest } else { steps };
            (steps <= end as f64).then_some((steps as usize, steps.fract()))
        })
        .collect();
    let column = |values: &[f64], after: &dyn Fn(f64) -> f64| -> Vec<f64> {
        let value = |(place, t): (&Option<(usize, f64)>, &f64)| match *place {
            Some((i, share)) if share > 0.0 => values[i] + share * (values[i + 1] - values[i]),
            Some((i, _)) => values[i],
            None => after(t - record.duration()),
        };
        places.iter().zip(times).map(value).collect()
    };
    [
        (Ground::Acceleration, column(&record.acceleration, &|_| 0.0)),
        (Ground::Velocity, column(&motion.velocity, &|_| v_end)),
        (Ground::Displacement, column(&motion.displacement, &|t| d_end + v_end * t)),
    ]
}
