//! The model as lines of the calculation sheet: each value is computed by the formula that is printed, from the values of
//! the lines above it.
//!
//! Housner's model of a tank on a rigid base under horizontal motion.
//!
//! Squat tanks (H/a ≤ 1.5), with the constants of [`Coefficients`](super::coefficients::Coefficients):
//!
//! ```text
//! q = √3 a/H      r = tanh(q)/q      m_i = m r       P_i = a_B m_i
//! x = k H/a       ω² = (k g/a) tanh x                m_k = m c_m (a/H) tanh x
//! θ_h = c_t (A₁/a) tanh x            P_k = c_p m_k g θ_h  (= m_k S_a)
//! h_i = 3/8 H                        h_i′ = H (1/(2r) − 1/8)
//! h_k = H [1 − (cosh x − 1)/(x sinh x)]      h_k′ = H [1 − (cosh x − 2)/(x sinh x)]
//! d_max = c_d a coth(x)/(g/(ω² θ_h a) − 1)
//! ```
//!
//! Slender tanks: [`super::slender`].
//!
//! Source: Housner 1957, 1963; TID-7024 (1963); dissertation table D.1. `h_i′` and the 2 in `h_k′` re-derived.
//!
//! Check: R = 1.83 m, H = 1.525 m, m = 16.3 t, a_B = 0.5 g, S_v = 0.80 m/s, constants of 1957: P_i = 37.28 kN,
//! P_k = 13.59 kN, d_max = 0.425 m, moment above the base 33.33 kNm.

use super::model::{Input, InputError, Response, Resultant, SLENDER_LIMIT, Wave, check, not_negative};
use crate::mechanical::Plan;
use crate::sheet::Sheet;
use tank::case::Combination;
use tank::units::Dimension::{
    self, Acceleration, Angle, AngularFrequency, Dimensionless, Force, Length, Mass, Moment, Time, Velocity,
};

/// Clause of the slender branch.
pub(super) const SLENDER: &str = "TID-7024 (1963) ch. 6, H/a > 1.5; Brüggemann 2002 8.3";
/// Source of the printed constants.
const PRINTED: &str = "TID-7024 (1963) ch. 6";

/// Pseudo-acceleration of the sloshing mode.
pub(super) struct Ordinate {
    /// S_a [m/s²].
    pub value: f64,
    /// Its source, for the sheet.
    pub look_up: String,
    /// Its clause.
    pub clause: String,
}

/// Base shear [N], moments just above and below the base plate [N·m], parts combined.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Totals {
    pub shear: f64,
    pub moment: f64,
    pub overturning: f64,
}

/// The lines under way.
pub(super) struct Lines<'a> {
    pub(super) input: &'a Input,
    plan: Plan,
    /// Whether the convective constants are the exact ones.
    pub(super) exact: bool,
    combination: Combination,
    pub(super) sheet: &'a mut Sheet,
}

/// Wave, forces and moments of an angle, a depth and the impulsive part.
struct Convective {
    x: f64,
    omega: f64,
    period: f64,
    mass: f64,
    acceleration: f64,
    displacement: f64,
    angle: f64,
    force: f64,
    lever: f64,
    lever_with_base: f64,
}

impl<'a> Lines<'a> {
    /// Lines with the printed constants; [`Lines::exact`] switches to the exact ones.
    pub(super) fn new(input: &'a Input, plan: Plan, combination: Combination, sheet: &'a mut Sheet) -> Lines<'a> {
        Lines { input, plan, exact: false, combination, sheet }
    }

    /// All lines of the model.
    ///
    /// * `ground`: where the peak ground acceleration comes from
    /// * `ordinate`: S_a for the sloshing frequency [rad/s] and period [s]
    ///
    /// Error: inadmissible numbers.
    pub(super) fn respond(
        mut self,
        ground: &str,
        ordinate: impl FnOnce(f64, f64) -> Ordinate,
    ) -> Result<(Response, Totals), InputError> {
        check(self.input)?;
        self.inputs(ground);
        let split = self.split();
        let impulsive = self.impulsive();
        let convective = self.convective(ordinate)?;
        let wave = self.wave(convective.angle > 0.0);
        let (resultants, totals) = self.resultants();
        let response = Response {
            slender: self.slender(),
            sloshing_depth: split.sloshing_depth,
            sloshing_mass: split.sloshing_mass,
            rigid_depth: split.rigid_depth,
            rigid_mass: split.rigid_mass,
            x: convective.x,
            omega: convective.omega,
            period: convective.period,
            convective_mass: convective.mass,
            displacement: convective.displacement,
            acceleration: convective.acceleration,
            angle: convective.angle,
            convective_lever: convective.lever,
            convective_lever_with_base: convective.lever_with_base,
            convective_force: convective.force,
            impulsive: resultants[0],
            convective: resultants[1],
            wave,
            ..impulsive
        };
        Ok((response, totals))
    }

    /// Whether the lower part of the liquid is constrained.
    pub(super) fn slender(&self) -> bool {
        self.input.depth > SLENDER_LIMIT * self.input.half_length
    }

    /// Symbol of the length a.
    pub(super) fn length(&self) -> &'static str {
        match self.plan {
            Plan::Circle => "R",
            Plan::Rectangle => "L",
        }
    }

    /// Symbol of the depth that can slosh.
    fn depth(&self) -> &'static str {
        if self.slender() { "H_b" } else { "H" }
    }

    /// Symbol of the mass that can slosh.
    fn mass(&self) -> &'static str {
        if self.slender() { "m_b" } else { "m" }
    }

    /// Where the formulas stand.
    fn source(&self) -> &'static str {
        match self.plan {
            Plan::Circle => "Housner 1957; Brüggemann 2002 D.1",
            Plan::Rectangle => "Housner 1957; Brüggemann 2002 8.4.2",
        }
    }

    /// Source of the convective constants.
    fn constants(&self) -> &'static str {
        match (self.exact, self.plan) {
            (true, Plan::Circle) => "potential flow: λ₁ of J₁′ and 2/(λ₁ (λ₁² − 1))",
            (true, Plan::Rectangle) => "potential flow: π/2 and 16/π³",
            (false, _) => PRINTED,
        }
    }

    fn inputs(&mut self, ground: &str) {
        let a = self.length();
        let Input { half_length, depth, mass, ground_acceleration, gravity, .. } = *self.input;
        self.sheet.section("Tank and ground motion");
        let what = match self.plan {
            Plan::Circle => "inner radius",
            Plan::Rectangle => "half length in the direction of motion",
        };
        self.sheet.input(a, what, half_length, Length, "input");
        self.sheet.input("H", "liquid depth", depth, Length, "input");
        self.sheet.input("m", "liquid mass", mass, Mass, "input");
        self.sheet.input("g", "acceleration of free fall", gravity, Acceleration, "input");
        let name = "peak ground acceleration";
        self.sheet.input("a_B", name, ground_acceleration, Acceleration, ground);
        let ratio = match self.plan {
            Plan::Circle => "H/R",
            Plan::Rectangle => "H/L",
        };
        self.sheet.calc(ratio, "slenderness; squat up to 1.5", ratio, Dimensionless, SLENDER);
    }

    /// The impulsive part of a response; the rest of it is zero.
    fn impulsive(&mut self) -> Response {
        let (a, h, m, source) = (self.length(), self.depth(), self.mass(), self.source());
        self.sheet.section("Impulsive part");
        let q = self.sheet.calc("q", "argument", &format!("√3·{a}/{h}"), Dimensionless, source);
        let r = self.sheet.calc("r", "impulsive share", "tanh(q)/q", Dimensionless, source);
        let impulsive_mass = self.sheet.calc("m_i", "impulsive mass", &format!("{m}·r"), Mass, source);
        let impulsive_force = self.sheet.calc("P_i", "impulsive force", "a_B·m_i", Force, source);
        let formula = format!("3/8·{h}");
        let impulsive_lever = self.sheet.calc("h_i", "its lever, wall pressure only", &formula, Length, source);
        let formula = format!("{h}·(1/(2·r) − 1/8)");
        let impulsive_lever_with_base =
            self.sheet.calc("h_i′", "its lever with base pressure", &formula, Length, source);
        let rigid_force = if self.slender() {
            let name = "force of the constrained part, at H_r/2";
            self.sheet.calc("P_r", name, "a_B·m_r", Force, SLENDER)
        } else {
            0.0
        };
        Response {
            q,
            r,
            impulsive_mass,
            impulsive_force,
            impulsive_lever,
            impulsive_lever_with_base,
            rigid_force,
            ..Response::default()
        }
    }

    fn convective(&mut self, ordinate: impl FnOnce(f64, f64) -> Ordinate) -> Result<Convective, InputError> {
        let (a, h, m, source) = (self.length(), self.depth(), self.mass(), self.source());
        let (c, constants) = (self.input.coefficients, self.constants());
        self.sheet.section("Convective part");
        self.sheet.input("k", "frequency constant", c.frequency, Dimensionless, constants);
        self.sheet.input("c_m", "mass constant", c.mass, Dimensionless, constants);
        self.sheet.input("c_t", "angle constant", c.angle, Dimensionless, PRINTED);
        if self.exact {
            self.sheet.calc("c_p", "force constant", "k/c_t", Dimensionless, "P_k = m_k·S_a");
        } else {
            self.sheet.input("c_p", "force constant", c.force, Dimensionless, constants);
        }
        let x = self.sheet.calc("x", "argument", &format!("k·{h}/{a}"), Dimensionless, source);
        let formula = format!("√(k·g/{a}·tanh(x))");
        let omega = self.sheet.calc("ω", "sloshing frequency", &formula, AngularFrequency, source);
        let period = self.sheet.calc("T", "sloshing period", "2·π/ω", Time, source);
        let formula = format!("{m}·c_m·{a}/{h}·tanh(x)");
        let mass = self.sheet.calc("m_k", "convective mass", &formula, Mass, source);
        let read = ordinate(omega, period);
        not_negative("the spectral acceleration", read.value)?;
        let name = "pseudo-acceleration at T";
        let acceleration = self.sheet.look_up("S_a", name, &read.look_up, read.value, Acceleration, &read.clause);
        self.sheet.calc("S_v", "pseudo-velocity", "S_a/ω", Velocity, source);
        let displacement = self.sheet.calc("A_1", "spectral displacement", "S_v/ω", Length, source);
        let formula = format!("c_t·A_1/{a}·tanh(x)");
        let angle = self.sheet.calc("θ_h", "angle of the surface", &formula, Angle, source);
        let force = self.sheet.calc("P_k", "convective force", "c_p·m_k·g·θ_h", Force, source);
        // Table D.1 of [B02] prints 1.47 m for its tank; its own formula gives 0.884 m.
        let name = "its lever, wall pressure only";
        let formula = format!("{h}·(1 − (cosh(x) − 1)/(x·sinh(x)))");
        let lever = self.sheet.calc("h_k", name, &formula, Length, source);
        let name = "its lever with base pressure";
        let formula = format!("{h}·(1 − (cosh(x) − 2)/(x·sinh(x)))");
        let lever_with_base = self.sheet.calc("h_k′", name, &formula, Length, "Housner 1957; constant 2 exact");
        Ok(Convective { x, omega, period, mass, acceleration, displacement, angle, force, lever, lever_with_base })
    }

    /// * `moves`: without a wave there is no angle, and no limit to it
    fn wave(&mut self, moves: bool) -> Wave {
        let (a, source, c) = (self.length(), self.source(), self.input.coefficients);
        self.sheet.section("Wave at the wall");
        let linear_source = if self.exact { "potential flow, first mode" } else { "c_d·c_t of TID-7024 (1963)" };
        self.sheet.input("w", "linear wave factor", c.wave_linear, Dimensionless, linear_source);
        let formula = format!("w·{a}·S_a/g");
        let linear = self.sheet.calc("d_lin", "linear value", &formula, Length, linear_source);
        let ratio = if moves {
            let name = "must exceed 1 for the formula to hold";
            self.sheet.calc("κ", name, &format!("g/(ω²·θ_h·{a})"), Dimensionless, source)
        } else {
            f64::INFINITY
        };
        self.sheet.input("c_d", "wave constant", c.wave, Dimensionless, PRINTED);
        let finite = if ratio > 1.0 {
            let name = "largest rise, with the finite-angle term";
            let formula = format!("c_d·{a}/tanh(x)/(g/(ω²·θ_h·{a}) − 1)");
            Some(self.sheet.calc("d_max", name, &formula, Length, source))
        } else {
            let name = "largest rise: sloshing amplitude outside Housner's theory, linear value";
            self.sheet.calc("d_max", name, "d_lin", Length, linear_source);
            None
        };
        Wave { ratio, finite, linear }
    }

    /// Impulsive and convective resultants, and both combined.
    fn resultants(&mut self) -> ([Resultant; 2], Totals) {
        let slender = self.slender();
        let clause = if slender { SLENDER } else { self.source() };
        let with_base = if slender {
            "extension: Housner defines no base pressure for slender tanks"
        } else {
            "Housner 1963; TID-7024 ch. 6, with base pressure"
        };
        let impulsive = |lever: &str| match slender {
            true => format!("P_i·(H_r + {lever}) + P_r·H_r/2"),
            false => format!("P_i·{lever}"),
        };
        let convective = |lever: &str| if slender { format!("P_k·(H_r + {lever})") } else { format!("P_k·{lever}") };
        let total = if slender { "P_i + P_r" } else { "P_i" };
        self.sheet.section("Forces and moments at the base");
        let q_i = self.sheet.calc("Q_i", "impulsive base shear", total, Force, clause);
        let q_k = self.sheet.calc("Q_k", "convective base shear", "P_k", Force, clause);
        let shear = self.combined("Q", "base shear", ["Q_i", "Q_k"], Force, clause);
        let name = "impulsive moment above the base";
        let m_i = self.sheet.calc("M_i", name, &impulsive("h_i"), Moment, clause);
        let name = "convective moment above the base";
        let m_k = self.sheet.calc("M_k", name, &convective("h_k"), Moment, clause);
        let moment = self.combined("M", "moment above the base", ["M_i", "M_k"], Moment, clause);
        let name = "impulsive moment below the base plate";
        let m_ib = self.sheet.calc("M_i′", name, &impulsive("h_i′"), Moment, with_base);
        let name = "convective moment below the base plate";
        let m_kb = self.sheet.calc("M_k′", name, &convective("h_k′"), Moment, with_base);
        let overturning = self.combined("M′", "overturning moment", ["M_i′", "M_k′"], Moment, with_base);
        let part = |force, wall_moment, base_moment| Resultant { force, wall_moment, base_moment };
        let totals = Totals { shear, moment, overturning };
        ([part(q_i, m_i, m_ib), part(q_k, m_k, m_kb)], totals)
    }

    /// The line that combines an impulsive and a convective part.
    fn combined(
        &mut self,
        symbol: &'static str,
        name: &str,
        [i, k]: [&str; 2],
        dimension: Dimension,
        clause: &str,
    ) -> f64 {
        let (formula, rule) = match self.combination {
            Combination::Abs => (format!("{i} + {k}"), "sum of absolute values"),
            Combination::Srss => (format!("√({i}² + {k}²)"), "SRSS"),
        };
        self.sheet.calc(symbol, &format!("{name}, {rule}"), &formula, dimension, clause)
    }
}
