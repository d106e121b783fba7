//! What a comparable quantity of a procedure is made of, so that its difference from an engine can be computed: every
//! ingredient can be exchanged alone, and the value follows from them.
//!
//! ```text
//! part        X_p = s A Σ_k m_k a_k / (1 − ε A)     k: liquid, wall, roof, floor
//! ordinate    A   = S(T, ξ) Π f                     importance, behaviour factor, …
//! quantity    X   = |X_i| + |X_c|   or   √(X_i² + X_c²)
//! stress      σ   = |x X| + |σ_v|   or   √((x X)² + σ_v²)       with vertical motion
//! ```
//!
//! For a base shear the arms `a_k` are 1, for moments they are heights. A wave has the convective part alone: its `m` is the
//! rise of the surface per acceleration [s²] and ε the term of finite angles of Housner's formula; ε is zero elsewhere.
//!
//! The scale `s` is 1 but for stresses. An axial stress is a base moment times s = 1/W [1/m³]; a hoop stress has Σ m a = 1, and
//! s is the stress per acceleration, a pressure coefficient times R/t [Pa·s²/m]. It depends on the height: s is that where the hoop
//! stress of the procedure is largest, `along` has the others.

use crate::case::Combination;
use crate::factor::Factor;
use crate::quantity::Quantity;

/// The ingredients of a quantity.
#[derive(Clone, Debug, PartialEq)]
pub struct Ingredients {
    /// The quantity.
    pub quantity: Quantity,
    /// How its value follows.
    pub recipe: Recipe,
}

/// How the value of a quantity follows from its ingredients.
#[derive(Clone, Debug, PartialEq)]
pub enum Recipe {
    /// Masses times spectral accelerations.
    Response(Box<Response>),
    /// Values on the way from the exact model of the tank to the procedure, each with what it exchanges.
    Ladder(Vec<Rung>),
    /// The period of a uniform wall by a formula.
    UniformWall {
        /// Its thickness [m].
        thickness: f64,
        /// Its modulus [Pa].
        modulus: f64,
        /// The period [s].
        period: f64,
    },
}

/// A value on the way from one model to another.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rung {
    /// What is exchanged.
    pub factor: Factor,
    /// Value thereafter, in the SI unit of the quantity.
    pub value: f64,
}

impl Ingredients {
    /// The quantity as a response.
    pub fn response(quantity: Quantity, response: Response) -> Ingredients {
        Ingredients { quantity, recipe: Recipe::Response(Box::new(response)) }
    }

    /// The quantity as a ladder.
    pub fn ladder(quantity: Quantity, rungs: &[(Factor, f64)]) -> Ingredients {
        let rung = |&(factor, value): &(Factor, f64)| Rung { factor, value };
        Ingredients { quantity, recipe: Recipe::Ladder(rungs.iter().map(rung).collect()) }
    }

    /// Another quantity that is this response times a constant; `None` for what is no response.
    pub fn scaled(&self, quantity: Quantity, scale: f64) -> Option<Ingredients> {
        let Recipe::Response(response) = &self.recipe else { return None };
        let mut response = (**response).clone();
        for part in response.impulsive.iter_mut().chain(&mut response.convective) {
            part.scale *= scale;
        }
        Some(Ingredients::response(quantity, response))
    }

    /// The value in SI that follows from the ingredients; `None` for a ladder without rungs.
    pub fn value(&self) -> Option<f64> {
        match &self.recipe {
            Recipe::Response(response) => Some(response.value()),
            Recipe::Ladder(rungs) => rungs.last().map(|rung| rung.value),
            Recipe::UniformWall { period, .. } => Some(*period),
        }
    }
}

/// A quantity as maxima of an impulsive and a convective part.
#[derive(Clone, Debug, PartialEq)]
pub struct Response {
    /// Impulsive part; none for a wave.
    pub impulsive: Option<Part>,
    /// Convective part.
    pub convective: Option<Part>,
    /// How they are combined.
    pub combination: Combination,
    /// Stress of the vertical motion; none without it, and for all that is no hoop stress.
    pub vertical: Option<Vertical>,
}

/// Stress of the vertical motion beside that of the horizontal one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vertical {
    /// Factor of the horizontal motion.
    pub horizontal: f64,
    /// Stress of the vertical motion with its factor [Pa].
    pub value: f64,
    /// How both are combined.
    pub combination: Combination,
}

/// Two values combined.
fn combined(combination: Combination, a: f64, b: f64) -> f64 {
    match combination {
        Combination::Abs => a.abs() + b.abs(),
        Combination::Srss => a.hypot(b),
    }
}

impl Response {
    /// A hoop stress: stresses per acceleration of both parts [Pa·s²/m].
    pub fn hoop(impulsive: (Ordinate, f64), convective: (Ordinate, f64), combination: Combination) -> Response {
        let part = |(ordinate, scale)| Part { scale, ..Part::liquid(ordinate, Share::new(1.0, 1.0)) };
        Response { impulsive: Some(part(impulsive)), convective: Some(part(convective)), combination, vertical: None }
    }

    /// The same with the stresses per acceleration of both parts at other heights.
    ///
    /// * `heights`: height [m], impulsive and convective stress per acceleration [Pa·s²/m]; ascending
    #[must_use]
    pub fn along(mut self, heights: &[(f64, f64, f64)]) -> Response {
        if let Some(part) = &mut self.impulsive {
            part.along = heights.iter().map(|&(z, impulsive, _)| (z, impulsive)).collect();
        }
        if let Some(part) = &mut self.convective {
            part.along = heights.iter().map(|&(z, _, convective)| (z, convective)).collect();
        }
        self
    }

    /// The value in SI.
    pub fn value(&self) -> f64 {
        let part = |part: &Option<Part>| part.as_ref().map_or(0.0, Part::value);
        let value = combined(self.combination, part(&self.impulsive), part(&self.convective));
        match self.vertical {
            Some(vertical) => combined(vertical.combination, vertical.horizontal * value, vertical.value),
            None => value,
        }
    }
}

/// Masses that have one acceleration.
#[derive(Clone, Debug, PartialEq)]
pub struct Part {
    /// Their acceleration.
    pub ordinate: Ordinate,
    /// Liquid.
    pub liquid: Share,
    /// Wall.
    pub wall: Share,
    /// Roof.
    pub roof: Share,
    /// Floor.
    pub floor: Share,
    /// ε of Housner's finite angles [s²/m]; 0 elsewhere.
    pub finite_angle: f64,
    /// Stress per moment [1/m³] or per acceleration [Pa·s²/m]; 1 for all that is no stress.
    pub scale: f64,
    /// Heights of a hoop stress [m], ascending, with the stress per acceleration there.
    pub along: Vec<(f64, f64)>,
}

impl Part {
    /// Liquid alone.
    pub fn liquid(ordinate: Ordinate, liquid: Share) -> Part {
        Part {
            ordinate,
            liquid,
            wall: Share::default(),
            roof: Share::default(),
            floor: Share::default(),
            finite_angle: 0.0,
            scale: 1.0,
            along: Vec::new(),
        }
    }

    /// The scale at a height [m], linear between those given; `None` where none is positive.
    pub fn scale_at(&self, z: f64) -> Option<f64> {
        let above = self.along.partition_point(|(height, _)| *height <= z);
        let (low, from) = *self.along.get(above.checked_sub(1)?)?;
        let scale = match self.along.get(above) {
            Some((high, to)) => from + (z - low) / (high - low) * (to - from),
            None => from,
        };
        (scale > 0.0).then_some(scale)
    }

    /// The value in SI.
    pub fn value(&self) -> f64 {
        let a = self.ordinate.value();
        let shares = [self.liquid, self.wall, self.roof, self.floor];
        let sum: f64 = shares.iter().map(|s| s.mass * s.arm).sum();
        self.scale * a * sum / (1.0 - self.finite_angle * a)
    }
}

/// A mass and its arm.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Share {
    /// Mass [kg]; for a wave, rise of the surface per acceleration [s²].
    pub mass: f64,
    /// Height above the base [m]; 1 for shear and wave.
    pub arm: f64,
}

impl Share {
    /// A mass and its arm.
    pub fn new(mass: f64, arm: f64) -> Share {
        Share { mass, arm }
    }
}

/// How a procedure comes from a period to an ordinate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rule {
    /// The ordinate at a period.
    At,
    /// The acceleration of the ground.
    Ground,
    /// The largest ordinate of a range.
    Plateau,
}

/// A spectral acceleration with all that makes it.
#[derive(Clone, Debug, PartialEq)]
pub struct Ordinate {
    /// How the period leads to it.
    pub rule: Rule,
    /// Period [s], 0 for the ground; `None` if the procedure asks for none.
    pub period: Option<f64>,
    /// Damping ratio of the spectrum.
    pub damping: f64,
    /// Ordinate of the spectrum before the factors [m/s²].
    pub base: f64,
    /// Factors on it.
    pub factors: Vec<(Factor, f64)>,
}

impl Ordinate {
    /// An ordinate of a record's spectrum: period [s], damping ratio, acceleration [m/s²].
    pub fn at(period: f64, damping: f64, base: f64) -> Ordinate {
        Ordinate { rule: Rule::At, period: Some(period), damping, base, factors: Vec::new() }
    }

    /// The acceleration of the ground [m/s²], which no damping changes.
    pub fn ground(base: f64) -> Ordinate {
        Ordinate { rule: Rule::Ground, ..Ordinate::at(0.0, 0.0, base) }
    }

    /// The same acceleration with factors taken out of its base: what they do not explain stays in the base.
    pub fn split(self, factors: &[(Factor, f64)]) -> Ordinate {
        let product: f64 = factors.iter().map(|f| f.1).product();
        Ordinate { base: self.base / product, factors: factors.to_vec(), ..self }
    }

    /// A factor; 1 if it has none of this kind.
    pub fn factor(&self, factor: Factor) -> f64 {
        self.factors.iter().filter(|f| f.0 == factor).map(|f| f.1).product()
    }

    /// The acceleration [m/s²].
    pub fn value(&self) -> f64 {
        self.base * self.factors.iter().map(|f| f.1).product::<f64>()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// By hand: A = 2·1.5/1.2 = 2.5 m/s²; (3·2 + 1·4)·2.5 = 25, 4·1.5·1 = 6; 25 + 6 = 31, √(25² + 6²) = 25.7099.
    #[test]
    fn value_by_hand() {
        let ordinate =
            Ordinate::at(0.2, 0.05, 2.5).split(&[(Factor::Importance, 1.5), (Factor::BehaviourFactor, 1.0 / 1.2)]);
        assert!((ordinate.base - 2.0).abs() < 1e-12);
        let mut response = Response {
            impulsive: Some(Part { wall: Share::new(1.0, 4.0), ..Part::liquid(ordinate, Share::new(3.0, 2.0)) }),
            convective: Some(Part::liquid(Ordinate::at(4.0, 0.005, 1.0), Share::new(4.0, 1.5))),
            combination: Combination::Abs,
            vertical: None,
        };
        assert!((response.value() - 31.0).abs() < 1e-12);
        response.combination = Combination::Srss;
        assert!((response.value() - 661.0_f64.sqrt()).abs() < 1e-12);
    }

    /// By hand: 3·2 = 6 and 4·2 = 8 give 10 by SRSS; with 0.3 of it and 9 of the vertical motion 12, or √(9 + 81).
    #[test]
    fn stress_by_hand() {
        let at = |scale| (Ordinate::at(1.0, 0.05, 2.0), scale);
        let mut response = Response::hoop(at(3.0), at(-4.0), Combination::Srss);
        assert!((response.value() - 10.0).abs() < 1e-12);
        for (combination, expected) in [(Combination::Abs, 12.0), (Combination::Srss, 90.0_f64.sqrt())] {
            response.vertical = Some(Vertical { horizontal: 0.3, value: 9.0, combination });
            assert!((response.value() - expected).abs() < 1e-12);
        }
        let moment = Ingredients::response(Quantity::BaseMoment, Response { vertical: None, ..response });
        let axial = moment.scaled(Quantity::AxialMembraneStress, 0.25).and_then(|i| i.value());
        assert!((axial.unwrap() - 2.5).abs() < 1e-12);
    }

    /// By hand: 8 at 1 m and 4 at 3 m are 6 at 2 m; a joint at 3 m has both sides; a height below the first has none.
    #[test]
    fn scale_at_a_height() {
        let at = |scale| (Ordinate::at(1.0, 0.05, 2.0), scale);
        let heights = [(1.0, 8.0, 1.0), (3.0, 4.0, 1.0), (3.0, 7.0, 1.0), (4.0, 0.0, 1.0)];
        let response = Response::hoop(at(8.0), at(1.0), Combination::Srss).along(&heights);
        let part = response.impulsive.unwrap();
        let found = [0.5, 1.0, 2.0, 3.0, 3.5, 4.0].map(|z| part.scale_at(z));
        assert_eq!(found, [None, Some(8.0), Some(6.0), Some(7.0), Some(3.5), None]);
        assert_eq!(response.convective.unwrap().scale_at(2.0), Some(1.0));
    }

    /// The order of exchange is that of the list.
    #[test]
    fn factors_are_in_order() {
        assert!(Factor::ALL.windows(2).all(|pair| pair[0] < pair[1]));
    }
}
