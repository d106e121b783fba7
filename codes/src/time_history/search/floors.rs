//! Lower bounds of a capacity over the pressure.

/// Lower bounds of a capacity that depends monotonously on the pressure: the smaller value at the ends of each of some parts of its range.
pub(super) struct Floors {
    low: f64,
    /// Parts for each pascal; 0 for a single pressure.
    per_pascal: f64,
    parts: [f64; PARTS],
    /// The lowest of all.
    pub(super) lowest: f64,
}

/// Parts of the range of the pressure: few enough to fill for every place, many enough that a bound is within some per cent.
const PARTS: usize = 48;

impl Floors {
    /// * range: least and largest pressure [Pa]
    pub(super) fn new((low, high): (f64, f64), capacity: impl Fn(f64) -> f64) -> Floors {
        let width = high - low;
        let lowest = capacity(low).min(capacity(high));
        if !(width > 0.0 && width.is_finite()) {
            return Floors {
                low,
                per_pascal: 0.0,
                parts: [lowest; PARTS],
                lowest,
            };
        }
        let mut before = capacity(low);
        let parts = std::array::from_fn(|i| {
            let after = capacity(low + width * (i + 1) as f64 / PARTS as f64);
            let floor = before.min(after);
            before = after;
            floor
        });
        Floors {
            low,
            per_pascal: PARTS as f64 / width,
            parts,
            lowest,
        }
    }

    /// At a pressure; next to an edge, where rounding decides, the smaller of both parts.
    pub(super) fn at(&self, pressure: f64) -> f64 {
        let place = (pressure - self.low) * self.per_pascal;
        let part = |place: f64| self.parts[(place.max(0.0) as usize).min(PARTS - 1)];
        part(place - 1e-9).min(part(place + 1e-9))
    }
}
