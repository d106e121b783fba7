//! The procedure `housner`: runs the model on a case and writes its calculation sheet.

use super::coefficients::Coefficients;
use super::ingredients;
use super::lines::Lines;
use super::model::Input;
use super::motion::{self, Motion, SOURCE};
use super::notes;
use super::run::Run;
use super::stress::{self, Pressures};
use crate::hazard;
use crate::mechanical::Plan;
use crate::modal_action::{ModalAction, Ordinates};
use crate::procedure::{CodeError, Label, Procedure};
use crate::sheet::Sheet;
use tank::Shape;
use tank::assessment::{Assessment, Excitation, NotApplicable, Profile};
use tank::case::{Case, ConvectiveCoefficient};
use tank::quantity::Quantity;
use tank::units::Dimension::{Length, Stress};

/// Housner's procedure for upright circular and rectangular tanks with rigid walls.
#[derive(Clone, Copy, Debug)]
pub struct Housner;

/// Clause of the stresses.
const STRESS: &str = "Brüggemann 2002 annex D, σ = M/W";

impl Procedure for Housner {
    fn id(&self) -> &'static str {
        "housner"
    }

    fn label(&self) -> Label {
        Label { title: "Housner (1957, 1963)", short: "Housner", figure_key: "k-housner" }
    }

    fn modal_action<'a>(&self, case: &'a Case, _reduced: bool) -> Option<Result<ModalAction<'a>, CodeError>> {
        let own = case.site.spectrum.as_ref()?;
        let importance = case.site.ec8.map_or(1.0, |site| site.importance);
        let elastic =
            || -> Ordinates<'a> { Box::new(move |period, damping| hazard::elastic(own, importance, damping)(period)) };
        Some(Ok(ModalAction {
            longest: hazard::longest(own),
            structural: elastic(),
            sloshing: elastic(),
            wave: elastic(),
            assumption: "Modes of the engine under the user's spectrum, at the damping of each mode (η of EN 1998-1), not reduced.".into(),
            vertical: false,
            upwards: None,
        }))
    }

    fn covers(&self, case: &Case, excitation: Excitation) -> Result<(), NotApplicable> {
        motion::available(case, excitation)
    }

    fn run(&self, case: &Case, excitation: Excitation) -> Result<Assessment, CodeError> {
        let plan = Plan::from(case.tank.shape);
        let choice = case.procedures.housner_convective;
        let combination = case.procedures.housner_combination;
        let motion = Motion::new(case, excitation)?;
        let input = Input {
            half_length: case.tank.shape.half_length(),
            depth: case.liquid.fill_height,
            mass: case.liquid_mass(),
            ground_acceleration: motion.ground,
            gravity: case.gravity,
            coefficients: Coefficients::choose(plan, choice),
        };
        let mut sheet = Sheet::new();
        let mut lines = Lines::new(&input, plan, combination, &mut sheet);
        lines.exact = choice == ConvectiveCoefficient::Exact;
        let (response, totals) = lines
            .respond(&motion.ground_source, |_, period| motion.sloshing(period))
            .map_err(|fault| CodeError::Data { clause: SOURCE.into(), reason: fault.to_string() })?;
        motion.covers(response.period)?;
        let run = Run { case, plan, input, response, totals, motion, combination };
        run.assessment(sheet)
    }
}

impl Run<'_> {
    fn assessment(&self, mut sheet: Sheet) -> Result<Assessment, CodeError> {
        let mut out = Assessment::default();
        self.stresses(&mut sheet, &mut out);
        let r = &self.response;
        for (quantity, value) in [
            (Quantity::SloshingPeriod, r.period),
            (Quantity::SloshingHeight, r.wave.height()),
            (Quantity::ImpulsiveMass, r.impulsive_mass + r.rigid_mass),
            (Quantity::ConvectiveMass, r.convective_mass),
            (Quantity::BaseShear, self.totals.shear),
            (Quantity::BaseMoment, self.totals.moment),
            (Quantity::OverturningMoment, self.totals.overturning),
        ] {
            out.values.insert(quantity, value);
        }
        out.profiles = self.profiles();
        out.ingredients = ingredients::of(self);
        out.assumptions = notes::assumptions(self);
        out.notes = notes::notes(self);
        out.steps = sheet.into_steps()?;
        Ok(out)
    }

    fn stresses(&self, sheet: &mut Sheet, out: &mut Assessment) {
        let thickness = self.case.tank.course_at(0.0).thickness;
        sheet.section("Stresses");
        sheet.input("s", "wall thickness at the base", thickness, Length, "input");
        match self.case.tank.shape {
            Shape::Cylinder { .. } => {
                sheet.calc("D", "diameter", "2·R", Length, "input");
                let name = "axial membrane stress at the base";
                let sigma = sheet.calc("σ_x", name, "M/(π·D²·s/4)", Stress, STRESS);
                out.values.insert(Quantity::AxialMembraneStress, sigma);
                let sigma = self.largest_hoop(sheet);
                out.values.insert(Quantity::HoopStress, sigma);
            }
            Shape::Rectangle { breadth, .. } => {
                sheet.input("b", "breadth across the motion", breadth, Length, "input");
                let clause = "Brüggemann 2002 8.4.2: each wall carries half the moment as a cantilever";
                let name = "bending stress at the base";
                let sigma = sheet.calc("σ_b", name, "M/2/(b·s²/6)", Stress, clause);
                out.values.insert(Quantity::BendingStress, sigma);
            }
        }
    }

    /// Lines of the largest hoop stress over the height; returns it [Pa].
    fn largest_hoop(&self, sheet: &mut Sheet) -> f64 {
        let highest = self.hoop_place();
        let (name, source) = ("height of the largest hoop stress", "largest of the profile over the height");
        sheet.look_up("z", name, source, highest, Length, "profile");
        let (name, source) = ("dynamic pressure there", "impulsive and convective profile at z");
        sheet.look_up("p", name, source, self.pressure(highest), Stress, "Housner 1957");
        sheet.given(&[("s", self.case.tank.course_at(highest).thickness, Length)]);
        sheet.calc("σ_φ", "largest hoop stress", "p·R/s", Stress, "membrane theory")
    }

    /// Height of the largest hoop stress [m].
    pub(super) fn hoop_place(&self) -> f64 {
        let z = self.heights().into_iter();
        z.max_by(|&p, &q| self.hoop(p).total_cmp(&self.hoop(q))).unwrap_or(0.0)
    }

    /// Heights of the profiles: 48 steps over the depth, the bottom of the sloshing part, and both sides of every joint of
    /// courses below the surface.
    pub(super) fn heights(&self) -> Vec<f64> {
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

    pub(super) fn pressures(&self) -> Pressures<'_> {
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
        stress::hoop(self.pressure(z), self.input.half_length, self.case.tank.course_at(z).thickness)
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
        let moment =
            |z: f64| super::model::combine(p.impulsive_moment_above(z), p.convective_moment_above(z), self.combination);
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
