//! Closed forms: strips on rigid ground and a round plate.
//!
//! ```text
//! strip      w = V s³/(6 D) − p s⁴/(24 D) from the touch-down inwards ,  F = p l − V ,  M = V l − p l²/2
//! hinged     V = p l/2 ,  F = p l/2 ,    w = p l⁴/(24 D)
//! clamped    V = p l/3 ,  F = 2 p l/3 ,  w = p l⁴/(72 D)
//! hinges     M = −M_p :  V = p l/2 − M_p/l ,  F = p l/2 + M_p/l ;  two of them: V²/(2 p) = M_p ,  F = 2 √(p M_p)
//! round      w = c₀ + c₁ r² + c₂ ln r + c₃ r² ln r − p r⁴/(64 D) ,  w = w′ = w″ = 0 at r = a
//! ```
//!
//! At the touch-down there is a line reaction V: the plate lies flat behind it.

use crate::plate::Plate;

/// A strip of one length: rim hinged, clamped or yielding.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Span {
    /// Uplift of the rim w [m].
    pub uplift: f64,
    /// Hold-down force F [N/m].
    pub hold_down: f64,
    /// Moment at the rim [N].
    pub rim_moment: f64,
}

fn span(plate: &Plate, pressure: f64, length: f64, reaction: f64) -> Span {
    let d = plate.bending_stiffness();
    Span {
        uplift: reaction * length.powi(3) / (6.0 * d) - pressure * length.powi(4) / (24.0 * d),
        hold_down: pressure * length - reaction,
        rim_moment: reaction * length - pressure * length * length / 2.0,
    }
}

/// Rim free to turn; `length` l lifted [m].
pub fn hinged(plate: &Plate, pressure: f64, length: f64) -> Span {
    span(plate, pressure, length, pressure * length / 2.0)
}

/// Rim held in rotation.
pub fn clamped(plate: &Plate, pressure: f64, length: f64) -> Span {
    span(plate, pressure, length, pressure * length / 3.0)
}

/// Lifted width with two plastic hinges over √(M_p/p): 2 + √2.
pub(crate) const MECHANISM: f64 = 2.0 + std::f64::consts::SQRT_2;

/// Hold-down force with two plastic hinges [N/m], 2 √(p M_p) = t √(p f_y), the w_a of API 650 E.6.2.1.1.2.
pub fn two_hinges(plate: &Plate, pressure: f64) -> Option<f64> {
    plate.plastic_moment().map(|m| 2.0 * (pressure * m).sqrt())
}

/// A round plate of radius `rim` lifted evenly outside the radius `contact` [m], rim free to turn, without membrane forces: uplift [m]
/// and hold-down force [N/m].
pub fn round(plate: &Plate, pressure: f64, rim: f64, contact: f64) -> (f64, f64) {
    let (d, nu) = (plate.bending_stiffness(), plate.poisson_ratio);
    let q = pressure / (64.0 * d);
    // Rows over c₀ to c₃ and the particular part, of w, w′ and w″.
    let w = |r: f64| [1.0, r * r, r.ln(), r * r * r.ln(), -q * r.powi(4)];
    let slope = |r: f64| [0.0, 2.0 * r, 1.0 / r, r * (2.0 * r.ln() + 1.0), -4.0 * q * r.powi(3)];
    let bend = |r: f64| [0.0, 2.0, -1.0 / (r * r), 2.0 * r.ln() + 3.0, -12.0 * q * r * r];
    let moment = |r: f64| {
        let (b, s) = (bend(r), slope(r));
        std::array::from_fn(|i| b[i] + nu * s[i] / r)
    };
    let mut rows: [[f64; 5]; 4] = [w(contact), slope(contact), bend(contact), moment(rim)];
    for i in 0..4 {
        let pivot = (i..4).max_by(|&a, &b| rows[a][i].abs().total_cmp(&rows[b][i].abs())).unwrap_or(i);
        rows.swap(i, pivot);
        for j in i + 1..4 {
            let factor = rows[j][i] / rows[i][i];
            for k in i..5 {
                rows[j][k] -= factor * rows[i][k];
            }
        }
    }
    let mut c = [0.0; 5];
    c[4] = 1.0;
    for i in (0..4).rev() {
        let rest: f64 = (i + 1..5).map(|k| rows[i][k] * c[k]).sum();
        c[i] = -rest / rows[i][i];
    }
    let uplift = w(rim).iter().zip(c).map(|(a, c)| a * c).sum();
    // Q = −D (∇²w)′ downwards on the plate outside; ∇²w = 4 c₁ + c₃ (4 ln r + 4) − 16 q r².
    let force = d * (4.0 * c[3] / rim - 32.0 * q * rim);
    (uplift, -force)
}
