//! The base of an unanchored tank under a moment of a code, on the ground of the file and on ground three times softer and stiffer.
//!
//! What the rim does is that of [`base::Stands`], strips of the bottom plate with membrane force, plastic hinges, ground without tension
//! and the edge of the wall; plates and wall less corrosion. All sheets of a tank ask the same curves, so the last ones are kept: an
//! answer does not depend on what was asked before.

use std::cell::RefCell;

use base::model::CONCRETE;
use base::{Base, Origin, PlatePoint, Stand, Stands, Suction};
use tank::Case;
use tank::units::Dimension::{Angle, Length, Moment, Stress};

use crate::sheet::{Sheet, number};

/// Factors on the modulus of the ground.
const BAND: [f64; 3] = [1.0 / 3.0, 1.0, 3.0];
/// Grounds whose curves are kept: those of two tanks.
const KEPT: usize = 8;
/// Steps of a curve in a figure.
const SAMPLES: u32 = 16;
/// Ends of a curve in a figure over the moment: the first that the base holds.
const SHARES: [f64; 5] = [1.0, 0.8, 0.6, 0.4, 0.2];
/// Halvings of the moment that a base holds: a thousandth of it.
const HALVINGS: u32 = 10;

thread_local! {
    static CURVES: RefCell<Vec<Stands>> = const { RefCell::new(Vec::new()) };
}

/// The base of a tank on one of its grounds.
pub(crate) struct Ground {
    /// The base there.
    pub(crate) base: Base,
    /// Whether a check is decided there. Where the file gives the stiffness of the ground, that ground alone decides and the others show
    /// how much it matters; where it is assumed, the least favourable of all decides.
    pub(crate) decides: bool,
}

impl Ground {
    /// Modulus as on the sheet, with its unit.
    pub(crate) fn modulus(&self) -> String {
        format!("{} MN/m³", grouped(&number(self.base.modulus / 1e6)))
    }
}

/// A number with its thousands grouped from 10 000 on, as the report prints it.
fn grouped(number: &str) -> String {
    let whole = number.split('.').next().unwrap_or_default();
    match (whole.len() > 4 && whole.bytes().all(|b| b.is_ascii_digit())).then(|| whole.len() - 3) {
        Some(at) if at <= 3 => format!("{}\u{202f}{}", &number[..at], &number[at..]),
        _ => number.to_owned(),
    }
}

/// The grounds of a tank, the softest first; none without a metal bottom plate.
///
/// Where nothing is known about the foundation, concrete under the rim is among them: it lifts less than soil and presses more at the toe.
pub(crate) fn grounds(case: &Case) -> Option<Vec<Ground>> {
    let own = Base::net(case).ok()?;
    let assumed = matches!(own.origin, Origin::Assumed(_));
    let mut moduli = BAND.map(|factor| (factor * own.modulus, assumed || factor == 1.0)).to_vec();
    if case.tank.foundation.is_none() && assumed {
        moduli.push((CONCRETE, true));
    }
    let ground = |(modulus, decides)| Ground { base: own.on(modulus), decides };
    Some(moduli.into_iter().map(ground).collect())
}

/// A base under a moment M [N·m]; none where it does not hold it.
///
/// * `weight`: w_t that holds the wall down [N/m]
pub(crate) fn under(base: &Base, moment: f64, weight: f64) -> Option<Stand> {
    asked(base, |stands| stands.under(moment, weight, 0.0))
}

/// The moment at which the rim of a base leaves the ground [N·m]; none where it stands off it at rest.
fn leaving(base: &Base, weight: f64) -> Option<f64> {
    let turn = asked(base, |stands| stands.leaving(weight))?.turn;
    (turn.rotation > 0.0).then_some(turn.moment)
}

fn asked<T>(base: &Base, question: impl FnOnce(&mut Stands) -> Option<T>) -> Option<T> {
    CURVES.with_borrow_mut(|curves| {
        let known = curves.iter().position(|kept| kept.base() == base);
        let mut stands = known.map_or_else(|| Stands::of(base.clone()), |i| curves.remove(i));
        let stand = question(&mut stands);
        if curves.len() >= KEPT {
            curves.remove(0);
        }
        curves.push(stands);
        stand
    })
}

/// The largest moment that a base holds [N·m], below one that it does not; to a thousandth of the latter, from below.
pub(crate) fn held(base: &Base, beyond: f64, weight: f64) -> f64 {
    let (mut low, mut high) = (0.0, beyond);
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        match under(base, middle, weight) {
            Some(_) => low = middle,
            None => high = middle,
        }
    }
    low
}

/// Lines of the base under the moment of a code that has another model of uplift; they decide nothing. Notes on the foot of the wall, and where a
/// ground does not hold the moment.
///
/// * `moment`: M [N·m], named `symbol` on the sheet
/// * `weight`: w_t that holds the wall down [N/m]
pub(crate) fn information(
    sheet: &mut Sheet,
    case: &Case,
    (symbol, moment): (&str, f64),
    weight: f64,
    clause: &str,
) -> Vec<String> {
    let Some(grounds) = grounds(case) else { return Vec::new() };
    let mut notes: Vec<String> = grounds.first().map(|ground| ground.base.foot().into()).into_iter().collect();
    sheet.section("Uplift by strips of the bottom plate (for information)");
    let own = "own calculation";
    for ground in &grounds {
        let (base, modulus) = (&ground.base, ground.modulus());
        let Some(stand) = under(base, moment, weight) else {
            notes.push(format!(
                "{clause}: for information, strips of the bottom plate on {modulus} do not hold the moment {symbol}."
            ));
            return notes;
        };
        let source = format!("strips side by side under {symbol}, subgrade modulus {modulus}");
        let turn = &stand.turn;
        let toe = turn.toe_force.max(0.0) / base.wall_thickness();
        for (symbol, name, value, dimension) in [
            ("ψ", "rotation of the shell", turn.rotation, Angle),
            ("w", "largest uplift", turn.uplift.max(0.0), Length),
            ("l", "lifted length", stand.rim.lifted_width, Length),
            ("σ_t", "compression at the toe", toe, Stress),
        ] {
            sheet.look_up(symbol, name, &source, value, dimension, own);
        }
        if let Some(leaving) = leaving(base, weight) {
            let name = "moment at which the rim leaves the ground";
            sheet.look_up("M_0", name, &source, leaving, Moment, own);
        }
    }
    if let Some(suction) = softened(case, moment) {
        notes.push(format!(
            "{clause}: for information, strips of the bottom plate do not hold: {}.",
            suction.left_out()
        ));
    }
    notes
}

/// The bottom pressure that goes with a moment [N·m] all of which is that of impulsive liquid, where strips, which leave it out, do not hold; also where they
/// say that all of the rim bears.
pub fn softened(case: &Case, moment: f64) -> Option<Suction> {
    Base::net(case).ok()?.suction_with(moment).filter(|suction| !suction.holds())
}

/// The base of a tank on one of its grounds, for figures.
#[derive(Clone, Debug, PartialEq)]
pub struct Drawing {
    /// Modulus of the ground [N/m³].
    pub modulus: f64,
    /// Whether checks are decided on this ground.
    pub decides: bool,
    /// Rotation [rad] and moment of the base [N m], both rising, from rest to the moment, or to the part of it that the base holds.
    pub curve: Vec<[f64; 2]>,
    /// What the base does under the moment, with the plate at the lifted side from the centre outwards; none where it does not hold it.
    pub stand: Option<(Stand, Vec<PlatePoint>)>,
}

/// The bases of an unanchored tank under a moment, the softest ground first; empty without a metal bottom plate.
///
/// * `moment`: just above the bottom plate [N·m]
/// * `weight`: that holds the wall down, as the sheet of the moment takes it [N/m]
pub fn drawings(case: &Case, moment: f64, weight: f64) -> Vec<Drawing> {
    let drawing = |ground: Ground| {
        let (base, decides) = (&ground.base, ground.decides);
        let ends = SHARES.iter().map(|share| (share, under(base, share * moment, weight)));
        let (share, end) = ends.into_iter().find_map(|(share, end)| Some((*share, end?)))?;
        // The moment grows with a root of the rotation: close steps at its begin.
        let step = |i: u32| end.turn.rotation * (f64::from(i) / f64::from(SAMPLES)).powi(2);
        let rotations: Vec<f64> = (0..=SAMPLES).map(step).collect();
        let turns = asked(base, |stands| Some(stands.at(&rotations, weight)))?;
        let plate = || asked(base, |stands| stands.plate(end.turn.uplift));
        Some(Drawing {
            modulus: base.modulus,
            decides,
            curve: turns.iter().map(|turn| [turn.rotation, turn.moment]).collect(),
            stand: if share < 1.0 { None } else { plate().map(|plate| (end, plate)) },
        })
    };
    grounds(case).unwrap_or_default().into_iter().filter_map(drawing).collect()
}

#[cfg(test)]
mod tests {
    use super::grouped;

    #[test]
    fn thousands_are_grouped_from_ten_thousand_on() {
        for (number, shown) in [
            ("33.333", "33.333"),
            ("3333.3", "3333.3"),
            ("10000", "10\u{202f}000"),
            ("30000.5", "30\u{202f}000.5"),
            ("100000", "100\u{202f}000"),
        ] {
            assert_eq!(grouped(number), shown);
        }
    }
}
