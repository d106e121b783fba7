//! The plate and its section: fibres through the thickness.
//!
//! ```text
//! ε(ζ) = ε₀ − ζ κ ,  κ = w″          N = ∫ σ dζ ,  M = −∫ σ ζ dζ          elastic: N = E′ t ε₀ ,  M = D κ ,  E′ = E/(1 − ν²)
//! fibre: |σ − X| ≤ f_y ,  X = H ε_p ,  H = E′ E_t/(E′ − E_t)
//! ```
//!
//! A long strip does not contract sideways, hence E′. Its yield stress in plane strain would be 2/√3 f_y; f_y is used, which is the
//! rule of the codes and 3 % lower in the hold-down force. Hardening is kinematic, so that a rim that is lifted and set down closes
//! a loop.

use crate::error::{BaseError, positive};

/// Fibres of a section.
const FIBRES: usize = 20;
/// Fibres that are computed side by side.
const LANES: usize = 4;

/// Tangent modulus beyond yield over E′.
const TANGENT: f64 = 0.01;

/// A plate of one thickness and steel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plate {
    /// Thickness t [m].
    pub thickness: f64,
    /// Young's modulus E [Pa].
    pub young_modulus: f64,
    /// Poisson's ratio ν.
    pub poisson_ratio: f64,
    /// Yield stress f_y [Pa]; without one the plate stays elastic.
    pub yield_stress: Option<f64>,
}

impl Plate {
    /// E′ = E/(1 − ν²) [Pa].
    pub fn plane_modulus(&self) -> f64 {
        self.young_modulus / (1.0 - self.poisson_ratio * self.poisson_ratio)
    }

    /// D = E′ t³/12 [N m].
    pub fn bending_stiffness(&self) -> f64 {
        self.plane_modulus() * self.thickness.powi(3) / 12.0
    }

    /// M_p = f_y t²/4 [N], moment of a plastic hinge per metre, where the plate has a yield stress.
    pub fn plastic_moment(&self) -> Option<f64> {
        self.yield_stress.map(|f| f * self.thickness * self.thickness / 4.0)
    }

    pub(crate) fn check(&self) -> Result<(), BaseError> {
        positive("thickness of the plate", self.thickness)?;
        positive("Young's modulus of the plate", self.young_modulus)?;
        if !(0.0..0.5).contains(&self.poisson_ratio) {
            return Err(BaseError::Parameter {
                name: "Poisson's ratio of the plate",
                value: self.poisson_ratio,
                allowed: "from 0 to less than 0.5",
            });
        }
        self.yield_stress.map_or(Ok(()), |f| positive("yield stress of the plate", f).map(drop))
    }

    /// The same plate without a yield stress.
    pub fn elastic(self) -> Plate {
        Plate { yield_stress: None, ..self }
    }

    pub(crate) fn fibres(&self) -> usize {
        if self.yield_stress.is_some() { FIBRES } else { 0 }
    }

    /// Forces and tangents of a section with strain `e` and curvature `k`; `old` are the plastic strains of its fibres, `new` receives
    /// those of this state. With either stands whether one of them is not zero: most sections never yield, and their fibres are not looked at.
    #[inline(always)]
    pub(crate) fn respond(&self, e: f64, k: f64, old: (&[f64], bool), new: (&mut [f64], &mut bool)) -> Section {
        let (modulus, t) = (self.plane_modulus(), self.thickness);
        let elastic = Section {
            n: modulus * t * e,
            m: self.bending_stiffness() * k,
            ee: modulus * t,
            ek: 0.0,
            kk: self.bending_stiffness(),
        };
        let Some(limit) = self.yield_stress else { return elastic };
        let ((old, yielded), (new, yields)) = (old, new);
        if !yielded && modulus * (e.abs() + (t / 2.0 * k).abs()) <= limit {
            if *yields {
                new.fill(0.0);
                *yields = false;
            }
            return elastic;
        }
        let area = t / FIBRES as f64;
        let hardening = modulus * TANGENT / (1.0 - TANGENT);
        let give = 1.0 / (modulus + hardening);
        // What a fibre that flows takes from the tangent.
        let softer = modulus * modulus * give;
        // Sums of every LANES-th fibre, beside each other.
        let mut sums = [[0.0; LANES]; 5];
        let mut flowed = [false; LANES];
        let chunks = old.chunks_exact(LANES).zip(new.chunks_exact_mut(LANES));
        for ((old, new), depths) in chunks.zip(DEPTHS.chunks_exact(LANES)) {
            for lane in 0..LANES {
                let z = t * depths[lane];
                let trial = modulus * (e - z * k - old[lane]);
                let moved = trial - hardening * old[lane];
                let flow = give * (moved - moved.clamp(-limit, limit));
                let tangent = modulus - if flow == 0.0 { 0.0 } else { softer };
                new[lane] = old[lane] + flow;
                flowed[lane] |= new[lane] != 0.0;
                let stress = trial - modulus * flow;
                sums[0][lane] += stress;
                sums[1][lane] -= z * stress;
                sums[2][lane] += tangent;
                sums[3][lane] -= z * tangent;
                sums[4][lane] += z * z * tangent;
            }
        }
        *yields = flowed.contains(&true);
        let [n, m, ee, ek, kk] = sums.map(|lanes| area * lanes.iter().sum::<f64>());
        Section { n, m, ee, ek, kk }
    }
}

/// Depths of the fibres above the middle over the thickness: middles of slices, moved outwards by 1/√(1 − 1/n²), which makes the second moment exact.
static DEPTHS: std::sync::LazyLock<[f64; FIBRES]> = std::sync::LazyLock::new(|| {
    let n = FIBRES as f64;
    std::array::from_fn(|i| ((i as f64 + 0.5) / n - 0.5) / (1.0 - 1.0 / (n * n)).sqrt())
});

/// Forces of a section and their derivatives.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Section {
    /// N [N/m].
    pub(crate) n: f64,
    /// M [N].
    pub(crate) m: f64,
    /// dN/dε [N/m].
    pub(crate) ee: f64,
    /// dN/dκ = dM/dε [N].
    pub(crate) ek: f64,
    /// dM/dκ [N m].
    pub(crate) kk: f64,
}

/// Plates from the rim inwards: an annular plate of given width, then the sketch plates.
#[derive(Clone, Debug, PartialEq)]
pub struct Bands {
    rim: Plate,
    inner: Option<(f64, Plate)>,
}

impl Bands {
    /// One plate all over.
    pub fn uniform(plate: Plate) -> Bands {
        Bands { rim: plate, inner: None }
    }

    /// An annular plate `rim` of `width` [m] from the inside of the wall, `sketch` plates beyond it.
    pub fn annular(rim: Plate, width: f64, sketch: Plate) -> Bands {
        Bands { rim, inner: Some((width, sketch)) }
    }

    /// The plate under the wall.
    pub fn rim(&self) -> &Plate {
        &self.rim
    }

    /// The plate at `distance` from the rim [m].
    pub fn at(&self, distance: f64) -> &Plate {
        match &self.inner {
            Some((width, plate)) if distance > *width => plate,
            _ => &self.rim,
        }
    }

    /// Where the thickness changes [m from the rim].
    pub(crate) fn width(&self) -> Option<f64> {
        self.inner.as_ref().map(|(width, _)| *width)
    }

    /// The same plates without yield stresses.
    pub fn elastic(&self) -> Bands {
        Bands { rim: self.rim.elastic(), inner: self.inner.as_ref().map(|(width, plate)| (*width, plate.elastic())) }
    }

    pub(crate) fn check(&self) -> Result<(), BaseError> {
        self.rim.check()?;
        match &self.inner {
            Some((width, plate)) => positive("width of the annular plate", *width).and_then(|_| plate.check()),
            None => Ok(()),
        }
    }
}
