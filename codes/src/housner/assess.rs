//! The procedure `housner`: runs the model on a case and writes its calculation sheet.

use super::coefficients::Coefficients;
use super::model::{Arms, Input, Response, Spectral, respond};
use super::motion::{self, Motion, SOURCE};
use super::stress::{self, Pressures};
use super::{notes, slender};
use crate::mechanical::Plan;
use crate::procedure::{CodeError, Label, Procedure};
use crate::sheet::Sheet;
use tank::Shape;
use tank::assessment::{Assessment, Excitation, NotApplicable, Profile};
use tank::case::{Case, Combination};
use tank::quantity::Quantity;
use tank::units::Dimension::{Force, Length, Moment, Stress};

/// Housner's procedure for upright circular and rectangular tanks with rigid walls.
#[derive(Clone, Copy, Debug)]
pub struct Housner;

/// Clause of the slender branch.
pub(super) const SLENDER: &str = "TID-7024 (1963) ch. 6, H/a > 1.5; dissertation 8.3";
/// Clause of the stresses.
const STRESS: &str = "dissertation Anhang D, σ = M/W";

impl Procedure for Housner {
    fn id(&self) -> &'static str {
        "housner"
    }

    fn label(&self) -> Label {
        Label {
            title: "Housner (1957, 1963)",
            short: "Housner",
            figure_key: "k-housner",
        }
    }

    fn applies(&self, case: &Case, excitation: Excitation) -> Result<(), NotApplicable> {
        motion::available(case, excitation)
    }

    fn assess(&self, case: &Case, excitation: Excitation) -> Result<Assessment, CodeError> {
        let plan = Plan::from(case.tank.shape);
        let coefficients = Coefficients::choose(plan, case.procedures.housner_convective);
        let a = case.tank.shape.half_length();
        let depth = case.liquid.fill_height;
        let mass = case.liquid_mass();
        let sloshing_depth = slender::split(depth, a, mass).sloshing_depth;
        let period = std::f64::consts::TAU / coefficients.omega(a, sloshing_depth, case.gravity);
        let motion = motion::motion(case, excitation, period)?;
        let input = Input {
            half_length: a,
            depth,
            mass,
            ground_acceleration: motion.ground,
            spectral: Spectral::Acceleration(motion.sloshing),
            gravity: case.gravity,
            coefficients,
        };
        let response = respond(&input).map_err(|fault| CodeError::Data {
            clause: SOURCE.into(),
            reason: fault.to_string(),
        })?;
        let run = Run {
            case,
            plan,
            input,
            response,
            motion,
            combination: case.procedures.housner_combination,
        };
        Ok(run.assessment())
    }
}

/// One run of the procedure.
pub(super) struct Run<'a> {
    pub(super) case: &'a Case,
    pub(super) plan: Plan,
    pub(super) input: Input,
    pub(super) response: Response,
    pub(super) motion: Motion,
    pub(super) combination: Combination,
}

impl Run<'_> {
    fn assessment(&self) -> Assessment {
        let mut sheet = Sheet::new();
        self.inputs(&mut sheet);
        self.impulsive(&mut sheet);
        self.convective(&mut sheet);
        self.wave(&mut sheet);
        let mut out = Assessment::default();
        self.resultants(&mut sheet, &mut out);
        self.stresses(&mut sheet, &mut out);
        let r = &self.response;
        for (quantity, value) in [
            (Quantity::SloshingPeriod, r.period),
            (Quantity::SloshingHeight, r.wave.height()),
            (Quantity::ImpulsiveMass, r.impulsive_mass + r.rigid_mass),
            (Quantity::ConvectiveMass, r.convective_mass),
        ] {
            out.values.insert(quantity, value);
        }
        out.profiles = self.profiles();
        out.assumptions = notes::assumptions(self);
        out.notes = notes::notes(self);
        out.steps = sheet.into_steps();
        out
    }

    fn resultants(&self, sheet: &mut Sheet, out: &mut Assessment) {
        let r = &self.response;
        let terms = [
            ("P_i", r.impulsive_force, Force),
            ("P_r", r.rigid_force, Force),
            ("P_k", r.convective_force, Force),
            ("H_r", r.rigid_depth, Length),
            ("h_i", r.impulsive_lever, Length),
            ("h_i′", r.impulsive_lever_with_base, Length),
            ("h_k", r.convective_lever, Length),
            ("h_k′", r.convective_lever_with_base, Length),
            ("Q_i", r.impulsive.force, Force),
            ("Q_k", r.convective.force, Force),
            ("M_i", r.impulsive.wall_moment, Moment),
            ("M_k", r.convective.wall_moment, Moment),
            ("M_i′", r.impulsive.base_moment, Moment),
            ("M_k′", r.convective.base_moment, Moment),
        ];
        let impulsive = |lever: &str| match r.slender {
            true => format!("P_i·(H_r + {lever}) + P_r·H_r/2"),
            false => format!("P_i·{lever}"),
        };
        let convective = |lever: &str| match r.slender {
            true => format!("P_k·(H_r + {lever})"),
            false => format!("P_k·{lever}"),
        };
        let clause = if r.slender { SLENDER } else { self.source() };
        let with_base = if r.slender {
            "extension: Housner defines no base pressure for slender tanks"
        } else {
            "Housner 1963; TID-7024 ch. 6, with base pressure"
        };
        let (combine, rule) = match self.combination {
            Combination::Abs => ("{i} + {k}", "sum of absolute values"),
            Combination::Srss => ("√({i}² + {k}²)", "SRSS"),
        };
        let combined = |i: &str, k: &str| combine.replace("{i}", i).replace("{k}", k);
        let shear = r.base_shear(self.combination);
        let moment = r.moment(Arms::Wall, self.combination);
        let overturning = r.moment(Arms::WallAndBase, self.combination);
        sheet.section("Forces and moments at the base");
        let total_i = if r.slender { "P_i + P_r" } else { "P_i" };
        for (symbol, name, formula, value, dimension, clause) in [
            (
                "Q_i",
                "impulsive base shear".to_string(),
                total_i.to_string(),
                r.impulsive.force,
                Force,
                clause,
            ),
            (
                "Q_k",
                "convective base shear".into(),
                "P_k".into(),
                r.convective.force,
                Force,
                clause,
            ),
            (
                "Q",
                format!("base shear, {rule}"),
                combined("Q_i", "Q_k"),
                shear,
                Force,
                clause,
            ),
            (
                "M_i",
                "impulsive moment above the base".into(),
                impulsive("h_i"),
                r.impulsive.wall_moment,
                Moment,
                clause,
            ),
            (
                "M_k",
                "convective moment above the base".into(),
                convective("h_k"),
                r.convective.wall_moment,
                Moment,
                clause,
            ),
            (
                "M",
                format!("moment above the base, {rule}"),
                combined("M_i", "M_k"),
                moment,
                Moment,
                clause,
            ),
            (
                "M_i′",
                "impulsive moment below the base plate".into(),
                impulsive("h_i′"),
                r.impulsive.base_moment,
                Moment,
                with_base,
            ),
            (
                "M_k′",
                "convective moment below the base plate".into(),
                convective("h_k′"),
                r.convective.base_moment,
                Moment,
                with_base,
            ),
            (
                "M′",
                format!("overturning moment, {rule}"),
                combined("M_i′", "M_k′"),
                overturning,
                Moment,
                with_base,
            ),
        ] {
            sheet.calc(symbol, &name, &formula, &terms, value, dimension, clause);
        }
        out.values.insert(Quantity::BaseShear, shear);
        out.values.insert(Quantity::BaseMoment, moment);
        out.values.insert(Quantity::OverturningMoment, overturning);
    }

    fn stresses(&self, sheet: &mut Sheet, out: &mut Assessment) {
        let moment = self.response.moment(Arms::Wall, self.combination);
        let thickness = self.case.tank.course_at(0.0).thickness;
        sheet.section("Stresses");
        sheet.input("s", "wall thickness at the base", thickness, Length, "input");
        match self.case.tank.shape {
            Shape::Cylinder { radius } => {
                let diameter = 2.0 * radius;
                let modulus = stress::section_modulus_circle(diameter, thickness);
                let sigma = moment / modulus;
                let terms = [("D", diameter, Length), ("s", thickness, Length), ("M", moment, Moment)];
                sheet.calc(
                    "D",
                    "diameter",
                    "2·R",
                    &[("R", radius, Length)],
                    diameter,
                    Length,
                    "input",
                );
                sheet.calc(
                    "σ_x",
                    "axial membrane stress at the base",
                    "M/(π·D²·s/4)",
                    &terms,
                    sigma,
                    Stress,
                    STRESS,
                );
                out.values.insert(Quantity::AxialMembraneStress, sigma);
                let z = self.heights();
                let hoop = |z: f64| self.hoop(z);
                let highest = z
                    .iter()
                    .copied()
                    .max_by(|&p, &q| hoop(p).total_cmp(&hoop(q)))
                    .unwrap_or(0.0);
                let course = self.case.tank.course_at(highest);
                let terms = [
                    ("R", radius, Length),
                    ("p", self.pressure(highest), Stress),
                    ("s", course.thickness, Length),
                ];
                sheet.input("z", "height of the largest hoop stress", highest, Length, "profile");
                sheet.input(
                    "p",
                    "dynamic pressure there",
                    self.pressure(highest),
                    Stress,
                    "Housner 1957",
                );
                sheet.calc(
                    "σ_φ",
                    "largest hoop stress",
                    "p·R/s",
                    &terms,
                    hoop(highest),
                    Stress,
                    "membrane theory",
                );
                out.values.insert(Quantity::HoopStress, hoop(highest));
            }
            Shape::Rectangle { breadth, .. } => {
                let sigma = 0.5 * moment / stress::section_modulus_wall(breadth, thickness);
                let terms = [("M", moment, Moment), ("b", breadth, Length), ("s", thickness, Length)];
                sheet.input("b", "breadth across the motion", breadth, Length, "input");
                let clause = "dissertation 8.4.2: each wall carries half the moment as a cantilever";
                sheet.calc(
                    "σ_b",
                    "bending stress at the base",
                    "M/2/(b·s²/6)",
                    &terms,
                    sigma,
                    Stress,
                    clause,
                );
                out.values.insert(Quantity::BendingStress, sigma);
            }
        }
    }

    /// Heights of the profiles: 48 steps over the depth, the bottom of the sloshing part, and both sides of every joint of
    /// courses below the surface.
    fn heights(&self) -> Vec<f64> {
        let depth = self.input.depth;
        let mut z: Vec<f64> = (0..=48).map(|i| depth * f64::from(i) / 48.0).collect();
        let mut breaks = vec![self.response.rigid_depth];
        let mut joint = 0.0;
        for course in &self.case.tank.courses {
            joint += course.height;
            breaks.push(joint);
        }
        for joint in breaks {
            if joint > 0.0 && joint < depth * (1.0 - 1e-6) {
                z.extend([joint * (1.0 - 1e-6), joint]);
            }
        }
        z.sort_by(f64::total_cmp);
        z.dedup();
        z
    }

    fn pressures(&self) -> Pressures<'_> {
        Pressures {
            response: &self.response,
            plan: self.plan,
            half_length: self.input.half_length,
            breadth: match self.case.tank.shape {
                Shape::Rectangle { breadth, .. } => breadth,
                Shape::Cylinder { .. } => 0.0,
            },
        }
    }

    /// Dynamic pressure at height z, parts combined [Pa].
    fn pressure(&self, z: f64) -> f64 {
        let p = self.pressures();
        super::model::combine(p.impulsive(z), p.convective(z), self.combination)
    }

    fn hoop(&self, z: f64) -> f64 {
        stress::hoop(
            self.pressure(z),
            self.input.half_length,
            self.case.tank.course_at(z).thickness,
        )
    }

    fn profiles(&self) -> Vec<Profile> {
        let z = self.heights();
        let p = self.pressures();
        let profile = |id: &str, title: &str, value: &dyn Fn(f64) -> f64| Profile {
            id: id.into(),
            title: title.into(),
            dimension: Stress,
            z: z.clone(),
            values: z.iter().map(|&z| value(z)).collect(),
        };
        let moment = |z: f64| {
            super::model::combine(
                p.impulsive_moment_above(z),
                p.convective_moment_above(z),
                self.combination,
            )
        };
        let thickness = |z: f64| self.case.tank.course_at(z).thickness;
        let mut profiles = vec![
            profile("pressure_impulsive", "Impulsive pressure", &|z| p.impulsive(z)),
            profile("pressure_convective", "Convective pressure", &|z| p.convective(z)),
            profile("pressure_dynamic", "Dynamic pressure", &|z| self.pressure(z)),
        ];
        match self.case.tank.shape {
            Shape::Cylinder { radius } => {
                profiles.push(profile("hoop_stress", "Hoop stress", &|z| self.hoop(z)));
                profiles.push(profile("axial_membrane_stress", "Axial membrane stress", &|z| {
                    moment(z) / stress::section_modulus_circle(2.0 * radius, thickness(z))
                }));
            }
            Shape::Rectangle { breadth, .. } => {
                profiles.push(profile("bending_stress", "Bending stress", &|z| {
                    0.5 * moment(z) / stress::section_modulus_wall(breadth, thickness(z))
                }));
            }
        }
        profiles
    }
}

#[cfg(test)]
mod tests;
