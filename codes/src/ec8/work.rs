//! Shared by the sheets of cylinders and rectangles: the case, the growing sheet, masses, resultants, wave height.

use super::demand::{Demand, Edition};
use super::limit_states;
use crate::base_state::BaseState;
use crate::corrosion;
use crate::limit_state::{LimitStateDef, Part};
use crate::mechanical::Lumped;
use crate::procedure::CodeError;
use crate::roof::{self, LiveLoad};
use crate::sheet::Sheet;
use tank::Shape;
use tank::assessment::{Assessment, Check, CheckStatus, Profile};
use tank::case::{Case, Combination};
use tank::quantity::Quantity;
use tank::units::Dimension::{self, *};

/// An assessment under way.
pub(super) struct Work<'a> {
    pub case: &'a Case,
    pub edition: Edition,
    pub demand: Demand<'a>,
    pub sheet: Sheet,
    pub out: Assessment,
    /// Mass of the liquid m [kg], once it stands on the sheet.
    pub mass: f64,
    /// Wave height that the freeboard has to hold [m], once it is known.
    pub wave: Option<f64>,
    /// What the base does, once it is known.
    pub base: BaseState,
    /// Compression at the toe of a cylinder whose wall does not lift [N/m], once it is known.
    pub rim: Option<f64>,
    /// Why the user's spectrum does not cover the tank.
    pub uncovered: Option<CodeError>,
}

/// Masses [kg] and levers [m] of a resultant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Masses {
    pub impulsive: Lumped,
    pub convective: Lumped,
}

/// A ratio that the sheet looks up: its symbol and its source.
#[derive(Clone, Copy)]
pub(super) struct Ratio<'a> {
    pub symbol: &'a str,
    pub source: &'a str,
    pub value: f64,
}

/// Sum of absolute values, or root of the sum of squares.
pub(super) fn combined(method: Combination, impulsive: f64, convective: f64) -> f64 {
    match method {
        Combination::Abs => impulsive.abs() + convective.abs(),
        Combination::Srss => impulsive.hypot(convective),
    }
}

/// Why a limit state is not checked.
pub(super) fn missing_input(input: &str) -> String {
    format!("`{input}` is missing")
}

/// What a ratio is a share of: symbol and dimension.
pub(super) type Whole = (&'static str, Dimension);
/// The mass of the liquid.
pub(super) const MASS: Whole = ("m", Mass);
/// The depth of the liquid.
pub(super) const DEPTH: Whole = ("H", Length);

impl Work<'_> {
    /// Section on tank and liquid; `symbol` is R or L. Returns the slenderness γ.
    pub(super) fn tank(&mut self, symbol: &str, name: &str, half_length: f64) -> f64 {
        let case = self.case;
        let depth = case.liquid.fill_height;
        if case.tank.corrodes() {
            corrosion::lines(&mut self.sheet, &case.tank, "s", "definition");
            self.out.assumptions.push(corrosion::ASSUMPTION.into());
        }
        let sheet = &mut self.sheet;
        sheet.section("Tank and liquid");
        sheet.input(symbol, name, half_length, Length, "input");
        sheet.input("H", "depth of the liquid", depth, Length, "input");
        let formula = format!("H/{symbol}");
        let gamma = sheet.calc("γ", "slenderness", &formula, Dimensionless, "definition");
        sheet.input("ρ", "density of the liquid", case.liquid.density, Density, "input");
        let (formula, breadth) = match case.tank.shape {
            Shape::Cylinder { .. } => ("ρ·π·R²·H", 0.0),
            Shape::Rectangle { breadth, .. } => ("ρ·2·L·b·H", breadth),
        };
        sheet.given(&[("b", breadth, Length)]);
        self.mass = sheet.calc("m", "mass of the liquid", formula, Mass, "definition");
        sheet.input("m_w", "mass of the wall", case.tank.wall_mass(), Mass, "input");
        sheet.input("h_w", "height of its centre", case.tank.wall_centroid(), Length, "input");
        roof::mass_lines(sheet, case);
        sheet.input("h_r", "height of its centre", case.tank.roof_height(), Length, "input");
        roof::line(sheet, &case.tank);
        self.out.assumptions.extend(roof::assumptions(&case.tank, &LiveLoad::Eurocode));
        let sheet = &mut self.sheet;
        sheet.input("g", "acceleration of free fall", case.gravity, Acceleration, "input");
        let [i, c] = [case.damping.impulsive, case.damping.sloshing];
        let clause = self.edition.main("2.3.3");
        self.sheet.input("ξ_i", "damping ratio of the impulsive part", i, Dimensionless, &clause);
        self.sheet.input("ξ_c", "damping ratio of sloshing", c, Dimensionless, &clause);
        gamma
    }

    /// Acceleration of the impulsive part [m/s²] at a period [s]; adds its line.
    pub(super) fn impulsive(&mut self, symbol: &str, period: f64) -> f64 {
        self.cover("impulsive", period);
        let (sheet, notes) = (&mut self.sheet, &mut self.out.notes);
        self.demand.impulsive(sheet, notes, symbol, period, self.case.damping.impulsive)
    }

    /// Acceleration of a sloshing mode [m/s²] at a period [s]; adds its line.
    pub(super) fn convective(&mut self, symbol: &str, period: f64) -> f64 {
        self.cover("sloshing", period);
        let (sheet, notes) = (&mut self.sheet, &mut self.out.notes);
        self.demand.convective(sheet, notes, symbol, period, self.case.damping.sloshing)
    }

    /// Keeps the first period [s] that the user's spectrum does not cover; the assessment is refused in the end.
    fn cover(&mut self, what: &str, period: f64) {
        if let (None, Err(refusal)) = (&self.uncovered, self.demand.covers(what, period)) {
            self.uncovered = Some(refusal);
        }
    }

    /// A line for a ratio that is looked up and one for its product with `whole`. Returns the product.
    pub(super) fn share(&mut self, (symbol, name): (&str, &str), whole: Whole, ratio: Ratio, clause: &str) -> f64 {
        let (of, dimension) = whole;
        let what = format!("{name}, share of {of}");
        let Ratio { symbol: share, source, value } = ratio;
        self.sheet.look_up(share, &what, source, value, Dimensionless, clause);
        let formula = format!("{of}·{share}");
        self.sheet.calc(symbol, name, &formula, dimension, clause)
    }

    /// Lines of the impulsive part of a rigid tank: mass, and levers without and with the base. `series` are the sources of
    /// their ratios to liquid mass and depth.
    pub(super) fn rigid_part(&mut self, rigid: Lumped, series: [&str; 3], clause: &str) -> Lumped {
        self.sheet.section("Liquid in a rigid tank");
        let [m, lever, lever_with_base] = series;
        let ratio = |symbol, source, value| Ratio { symbol, source, value };
        let m = ratio("μ_i", m, rigid.mass);
        let lever = ratio("χ_i", lever, rigid.lever);
        let lever_with_base = ratio("χ_i′", lever_with_base, rigid.lever_with_base);
        Lumped {
            mass: self.share(("m_i", "impulsive mass"), MASS, m, clause),
            lever: self.share(("h_i", "impulsive lever, wall only"), DEPTH, lever, clause),
            lever_with_base: self.share(("h_i′", "impulsive lever, wall and base"), DEPTH, lever_with_base, clause),
        }
    }

    /// Wave height `d = c·a·S_e(T_c1)/g` [m]; with the second mode for information. Adds the quantity.
    ///
    /// * `factors`: c of the first and the second mode, as written
    pub(super) fn wave(&mut self, symbol: &str, factors: [&str; 2], clause: &str, s_1: f64, s_2: f64) -> f64 {
        let clause = self.edition.clause(clause);
        self.sheet.section("Wave height");
        self.sheet.given(&[("S_1", s_1, Acceleration), ("S_2", s_2, Acceleration)]);
        let [first, second] = factors;
        let name = "wave height, S_1 = S_e(T_c1)";
        let formula = format!("{first}·{symbol}·S_1/g");
        let height = self.sheet.calc("d_max", name, &formula, Length, &clause);
        let name = "wave height with the second mode, for information";
        let formula = format!("{symbol}·√(({first}·S_1/g)² + ({second}·S_2/g)²)");
        self.sheet.calc("d_2", name, &formula, Length, &clause);
        self.out.values.insert(Quantity::SloshingHeight, height);
        height
    }

    /// Freeboard check.
    ///
    /// * `height`: of the wave that it has to hold [m]
    /// * `why`: why it is not the sloshing height, or nothing
    pub(super) fn freeboard(&mut self, height: f64, clause: &str, why: &str) {
        self.wave = Some(height);
        let clause = self.edition.clause(clause);
        let mut note =
            String::from("the wave needs this freeboard if the liquid must neither spill nor strike the roof");
        if !why.is_empty() {
            note += "; ";
            note += why;
        }
        let freeboard = self.case.freeboard();
        self.check(limit_states::FREEBOARD, height, freeboard, &clause, &note);
    }

    /// Base shear and moments; adds lines and quantities. Returns the moment just above the base plate [N·m].
    pub(super) fn resultants(&mut self, masses: &Masses, a_i: f64, a_c: f64, clause: &str) -> f64 {
        let case = self.case;
        let (i, c) = (masses.impulsive, masses.convective);
        let method = case.procedures.ec8_combination;
        let combination = self.edition.clause("2.1");
        self.sheet.given(&[
            ("m_c", c.mass, Mass),
            ("h_c", c.lever, Length),
            ("h_c′", c.lever_with_base, Length),
            ("A_i", a_i, Acceleration),
            ("A_c", a_c, Acceleration),
        ]);
        self.sheet.section("Base shear and moments");
        let mut moment = 0.0;
        for (symbol, name, quantity, dimension, impulsive, convective) in [
            ("Q", "base shear", Quantity::BaseShear, Force, "(m_i + m_w + m_r)·A_i", "m_c·A_c"),
            (
                "M",
                "moment just above the base plate",
                Quantity::BaseMoment,
                Moment,
                "(m_i·h_i + m_w·h_w + m_r·h_r)·A_i",
                "m_c·h_c·A_c",
            ),
            (
                "M′",
                "moment below the base plate",
                Quantity::OverturningMoment,
                Moment,
                "(m_i·h_i′ + m_w·h_w + m_r·h_r)·A_i",
                "m_c·h_c′·A_c",
            ),
        ] {
            let mut part = |index: &str, what: &str, formula: &str| {
                let (symbol, name) = (format!("{symbol}_{index}"), format!("{name}, {what}"));
                self.sheet.calc(&symbol, &name, formula, dimension, clause);
                symbol
            };
            let (i, c) = (part("i", "impulsive", impulsive), part("c", "convective", convective));
            let formula = match method {
                Combination::Abs => format!("{i} + {c}"),
                Combination::Srss => format!("√({i}² + {c}²)"),
            };
            let value = self.sheet.calc(symbol, name, &formula, dimension, &combination);
            self.out.values.insert(quantity, value);
            if quantity == Quantity::BaseMoment {
                moment = value;
            }
        }
        self.out.values.insert(Quantity::ImpulsiveMass, i.mass);
        self.out.values.insert(Quantity::ConvectiveMass, c.mass);
        moment
    }

    /// Adds a check of a limit state.
    pub(super) fn check(&mut self, state: LimitStateDef, demand: f64, capacity: f64, clause: &str, note: &str) {
        self.out.checks.push(state.check().of(demand, capacity, clause, note));
    }

    /// Adds one of the checks in which a limit state ends.
    pub(super) fn part(&mut self, (state, part): (LimitStateDef, Part), demand: f64, capacity: f64, note: &str) {
        let clause = self.edition.alike(state.clause);
        let check = part.of(demand, capacity, &clause, note);
        self.out.checks.push(check.of(state.id));
    }

    /// Ends a limit state without a comparison.
    pub(super) fn without_comparison(&mut self, id: &str, status: CheckStatus, reason: &str, input: Option<&str>) {
        let states = limit_states::all(self.case, self.edition);
        if let Some(state) = states.iter().find(|state| state.id == id) {
            self.out.checks.push(Check::without_comparison(state, status, reason, input));
        }
    }

    /// A limit state whose `input` is missing.
    pub(super) fn missing(&mut self, id: &str, input: &str) {
        self.without_comparison(id, CheckStatus::NotChecked, &missing_input(input), Some(input));
    }

    /// Adds a profile over the heights `z`.
    pub(super) fn profile(
        &mut self,
        id: &str,
        title: &str,
        dimension: Dimension,
        z: &[f64],
        value: impl Fn(f64) -> f64,
    ) {
        let values = z.iter().map(|z| value(*z)).collect();
        self.profile_of((id, title, dimension), z, values);
    }

    /// A profile of values at the heights `z` [m].
    pub(super) fn profile_of(&mut self, (id, title, dimension): (&str, &str, Dimension), z: &[f64], values: Vec<f64>) {
        self.out.profiles.push(Profile { id: id.into(), title: title.into(), dimension, z: z.to_vec(), values });
    }

    /// Heights of the profiles: 40 steps over the depth, and both sides of every joint of courses below the surface.
    pub(super) fn heights(&self) -> Vec<f64> {
        let depth = self.case.liquid.fill_height;
        let mut z: Vec<f64> = (0..=40).map(|i| depth * f64::from(i) / 40.0).collect();
        let mut joint = 0.0;
        for course in &self.case.tank.courses {
            joint += course.height;
            if joint < depth * (1.0 - 1e-6) {
                z.extend([joint - 1e-6 * depth, joint]);
            }
        }
        z.sort_by(f64::total_cmp);
        z.dedup();
        z
    }
}
