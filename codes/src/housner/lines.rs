//! Lines of the calculation sheet: input, impulsive part, convective part, wave.

use super::assess::{Run, SLENDER};
use super::model::{Input, SLENDER_LIMIT};
use crate::mechanical::Plan;
use crate::sheet::Sheet;
use tank::case::ConvectiveCoefficient;
use tank::units::Dimension::{
    Acceleration, Angle, AngularFrequency, Dimensionless, Force, Length, Mass, Time, Velocity,
};

impl Run<'_> {
    /// Symbols of the length a and of the depth that can slosh.
    fn symbols(&self) -> (&'static str, &'static str) {
        let a = match self.plan {
            Plan::Circle => "R",
            Plan::Rectangle => "L",
        };
        (a, if self.response.slender { "H_b" } else { "H" })
    }

    /// True if the convective constants are the exact ones.
    pub(super) fn exact(&self) -> bool {
        self.case.procedures.housner_convective == ConvectiveCoefficient::Exact
    }

    /// Where the formulas stand.
    pub(super) fn source(&self) -> &'static str {
        match self.plan {
            Plan::Circle => "Housner 1957; dissertation table D.1",
            Plan::Rectangle => "Housner 1957; dissertation 8.4.2",
        }
    }

    /// Source of the convective constants.
    fn constants(&self) -> &'static str {
        match (self.exact(), self.plan) {
            (true, Plan::Circle) => "potential flow: λ₁ of J₁′ and 2/(λ₁ (λ₁² − 1)); printed 1.84 and 0.318",
            (true, Plan::Rectangle) => "potential flow: π/2 and 16/π³; printed 1.58 and 0.527",
            (false, _) => "TID-7024 (1963) ch. 6",
        }
    }

    pub(super) fn inputs(&self, sheet: &mut Sheet) {
        let (a, _) = self.symbols();
        let Input {
            half_length,
            depth,
            mass,
            gravity,
            ..
        } = self.input;
        sheet.section("Tank and ground motion");
        let what = match self.plan {
            Plan::Circle => "inner radius",
            Plan::Rectangle => "half length in the direction of motion",
        };
        sheet.input(a, what, half_length, Length, "input");
        sheet.input("H", "liquid depth", depth, Length, "input");
        sheet.input("m", "liquid mass", mass, Mass, "input");
        sheet.input("g", "acceleration of free fall", gravity, Acceleration, "input");
        sheet.input(
            "a_B",
            "peak ground acceleration",
            self.motion.ground,
            Acceleration,
            &self.motion.ground_source,
        );
        sheet.calc(
            &format!("H/{a}"),
            "slenderness; squat up to 1.5",
            &format!("H/{a}"),
            &[("H", depth, Length), (a, half_length, Length)],
            depth / half_length,
            Dimensionless,
            SLENDER,
        );
        let r = &self.response;
        if r.slender {
            let terms = [
                (a, half_length, Length),
                ("H", depth, Length),
                ("m", mass, Mass),
                ("H_b", r.sloshing_depth, Length),
                ("m_b", r.sloshing_mass, Mass),
            ];
            for (symbol, name, formula, value, dimension) in [
                (
                    "H_b",
                    "depth that can slosh",
                    format!("{SLENDER_LIMIT}·{a}"),
                    r.sloshing_depth,
                    Length,
                ),
                ("m_b", "its mass", "m·H_b/H".into(), r.sloshing_mass, Mass),
                (
                    "H_r",
                    "constrained depth below",
                    "H − H_b".into(),
                    r.rigid_depth,
                    Length,
                ),
                (
                    "m_r",
                    "its mass, moves as a solid",
                    "m − m_b".into(),
                    r.rigid_mass,
                    Mass,
                ),
            ] {
                sheet.calc(symbol, name, &formula, &terms, value, dimension, SLENDER);
            }
        }
    }

    pub(super) fn impulsive(&self, sheet: &mut Sheet) {
        let (a, h) = self.symbols();
        let r = &self.response;
        let m = if r.slender { "m_b" } else { "m" };
        let terms = [
            (a, self.input.half_length, Length),
            (h, r.sloshing_depth, Length),
            (m, r.sloshing_mass, Mass),
            ("q", r.q, Dimensionless),
            ("r", r.r, Dimensionless),
            ("a_B", self.motion.ground, Acceleration),
            ("m_i", r.impulsive_mass, Mass),
            ("m_r", r.rigid_mass, Mass),
        ];
        sheet.section("Impulsive part");
        for (symbol, name, formula, value, dimension) in [
            ("q", "argument", format!("√3·{a}/{h}"), r.q, Dimensionless),
            ("r", "impulsive share", "tanh(q)/q".into(), r.r, Dimensionless),
            ("m_i", "impulsive mass", format!("{m}·r"), r.impulsive_mass, Mass),
            ("P_i", "impulsive force", "a_B·m_i".into(), r.impulsive_force, Force),
            (
                "h_i",
                "its lever, wall pressure only",
                format!("3/8·{h}"),
                r.impulsive_lever,
                Length,
            ),
            (
                "h_i′",
                "its lever with base pressure",
                format!("{h}·(1/(2·r) − 1/8)"),
                r.impulsive_lever_with_base,
                Length,
            ),
        ] {
            sheet.calc(symbol, name, &formula, &terms, value, dimension, self.source());
        }
        if r.slender {
            sheet.calc(
                "P_r",
                "force of the constrained part, at H_r/2",
                "a_B·m_r",
                &terms,
                r.rigid_force,
                Force,
                SLENDER,
            );
        }
    }

    pub(super) fn convective(&self, sheet: &mut Sheet) {
        let (a, h) = self.symbols();
        let r = &self.response;
        let c = self.input.coefficients;
        let m = if r.slender { "m_b" } else { "m" };
        let velocity = r.acceleration / r.omega;
        sheet.section("Convective part");
        sheet.input("k", "frequency constant", c.frequency, Dimensionless, self.constants());
        sheet.input("c_m", "mass constant", c.mass, Dimensionless, self.constants());
        sheet.input("c_t", "angle constant", c.angle, Dimensionless, "TID-7024 (1963) ch. 6");
        sheet.calc(
            "c_p",
            "force constant",
            if self.exact() { "k/c_t" } else { "" },
            &[("k", c.frequency, Dimensionless), ("c_t", c.angle, Dimensionless)],
            c.force,
            Dimensionless,
            if self.exact() {
                "P_k = m_k·S_a"
            } else {
                self.constants()
            },
        );
        let terms = [
            (a, self.input.half_length, Length),
            (h, r.sloshing_depth, Length),
            (m, r.sloshing_mass, Mass),
            ("g", self.input.gravity, Acceleration),
            ("k", c.frequency, Dimensionless),
            ("c_m", c.mass, Dimensionless),
            ("c_t", c.angle, Dimensionless),
            ("c_p", c.force, Dimensionless),
            ("x", r.x, Dimensionless),
            ("ω", r.omega, AngularFrequency),
            ("S_a", r.acceleration, Acceleration),
            ("S_v", velocity, Velocity),
            ("A_1", r.displacement, Length),
            ("m_k", r.convective_mass, Mass),
            ("θ_h", r.angle, Angle),
        ];
        let lever_source = match self.plan {
            Plan::Circle => "Housner 1957; dissertation table D.1 (printed 1.47 m there, 0.884 m by its own formula)",
            Plan::Rectangle => self.source(),
        };
        let mut line = |symbol: &str, name: &str, formula: String, value, dimension, clause: &str| {
            sheet.calc(symbol, name, &formula, &terms, value, dimension, clause);
        };
        line("x", "argument", format!("k·{h}/{a}"), r.x, Dimensionless, self.source());
        line(
            "ω",
            "sloshing frequency",
            format!("√(k·g/{a}·tanh(x))"),
            r.omega,
            AngularFrequency,
            self.source(),
        );
        line("T", "sloshing period", "2·π/ω".into(), r.period, Time, self.source());
        line(
            "m_k",
            "convective mass",
            format!("{m}·c_m·{a}/{h}·tanh(x)"),
            r.convective_mass,
            Mass,
            self.source(),
        );
        line(
            "S_a",
            "pseudo-acceleration at T",
            String::new(),
            r.acceleration,
            Acceleration,
            &self.motion.sloshing_source,
        );
        line(
            "S_v",
            "pseudo-velocity",
            "S_a/ω".into(),
            velocity,
            Velocity,
            self.source(),
        );
        line(
            "A_1",
            "spectral displacement",
            "S_v/ω".into(),
            r.displacement,
            Length,
            self.source(),
        );
        line(
            "θ_h",
            "angle of the surface",
            format!("c_t·A_1/{a}·tanh(x)"),
            r.angle,
            Angle,
            self.source(),
        );
        line(
            "P_k",
            "convective force",
            "c_p·m_k·g·θ_h".into(),
            r.convective_force,
            Force,
            self.source(),
        );
        line(
            "h_k",
            "its lever, wall pressure only",
            format!("{h}·(1 − (cosh(x) − 1)/(x·sinh(x)))"),
            r.convective_lever,
            Length,
            lever_source,
        );
        line(
            "h_k′",
            "its lever with base pressure",
            format!("{h}·(1 − (cosh(x) − 2)/(x·sinh(x)))"),
            r.convective_lever_with_base,
            Length,
            "Housner 1957; constant 2 exact",
        );
    }

    pub(super) fn wave(&self, sheet: &mut Sheet) {
        let (a, _) = self.symbols();
        let r = &self.response;
        let c = self.input.coefficients;
        let terms = [
            (a, self.input.half_length, Length),
            ("g", self.input.gravity, Acceleration),
            ("x", r.x, Dimensionless),
            ("ω", r.omega, AngularFrequency),
            ("θ_h", r.angle, Angle),
            ("S_a", r.acceleration, Acceleration),
            ("c_d", c.wave, Dimensionless),
            ("w", c.wave_linear, Dimensionless),
        ];
        sheet.section("Wave at the wall");
        let linear_source = if self.exact() {
            "potential flow, first mode"
        } else {
            "c_d·c_t of TID-7024 (1963)"
        };
        sheet.input("w", "linear wave factor", c.wave_linear, Dimensionless, linear_source);
        sheet.calc(
            "d_lin",
            "linear value",
            &format!("w·{a}·S_a/g"),
            &terms,
            r.wave.linear,
            Length,
            linear_source,
        );
        if r.wave.ratio.is_finite() {
            sheet.calc(
                "κ",
                "must exceed 1 for the formula to hold",
                &format!("g/(ω²·θ_h·{a})"),
                &terms,
                r.wave.ratio,
                Dimensionless,
                self.source(),
            );
        }
        sheet.input("c_d", "wave constant", c.wave, Dimensionless, "TID-7024 (1963) ch. 6");
        match r.wave.finite {
            Some(height) => sheet.calc(
                "d_max",
                "largest rise, with the finite-angle term",
                &format!("c_d·{a}/tanh(x)/(g/(ω²·θ_h·{a}) − 1)"),
                &terms,
                height,
                Length,
                self.source(),
            ),
            None => sheet.step(
                "d_max",
                "largest rise: sloshing amplitude outside Housner's theory, linear value",
                "d_lin",
                "",
                r.wave.linear,
                Length,
                linear_source,
            ),
        };
    }
}
