//! Hoop force and bending of the wall under the pressures of the code.

use std::f64::consts::PI;

use tank::Shape as Plan;
use tank::assessment::Profile;
use tank::quantity::Quantity;
use tank::units::Dimension::{Dimensionless, Length, LineForce, LineMoment, Stress};

use super::pressure::{Field, Shape, falls_below_zero};
use super::{Action, Clauses, Masses, Rules, Work};
use crate::ec8::wall_bending::{Plan as WallPlan, State, Wall};

/// Stresses per acceleration, for the ingredients.
#[derive(Default)]
pub(super) struct Stresses {
    /// Largest hoop stress of a cylinder.
    pub hoop: Option<Hoop>,
    /// 1/W of a cylinder [1/m³].
    pub axial: f64,
}

/// Hoop stresses per acceleration [Pa·s²/m].
pub(super) struct Hoop {
    /// Impulsive part with the inertia of the wall, at the place of the largest stress.
    pub impulsive: f64,
    /// Convective part there.
    pub convective: f64,
    /// Stress of the vertical motion there [Pa].
    pub vertical: f64,
    /// Heights [m] with both parts.
    pub along: Vec<(f64, f64, f64)>,
}

/// States of the wall under the impulsive and convective pressure of 1 m/s², and under the liquid at rest of 1 m/s² upwards.
struct States<'a> {
    impulsive: State<'a>,
    convective: State<'a>,
    vertical: State<'a>,
}

impl Work<'_> {
    /// Pressures and forces of the wall with their lines, profiles and quantities.
    pub(super) fn wall(&mut self, rules: &dyn Rules, masses: &Masses, action: &Action, share: f64) -> Stresses {
        let case = self.case;
        let field = Field::new(self, rules.pressures(), masses);
        let (depth, density) = (case.liquid.fill_height, case.liquid.density);
        // The wall's own inertia, where it is wet or dry.
        let own = |z: f64| {
            let course = case.tank.course_at(z);
            share * course.material.density * course.thickness
        };
        let still = |z: f64| density * (depth - z).max(0.0);
        self.pressures(rules, masses, share);
        let [a_i, a_c] = [&action.impulsive, &action.convective].map(|ordinate| ordinate.value());
        let heights = case.tank.profile_heights(depth);
        let total = |z: f64| {
            let impulsive = (field.impulsive(z) + own(z)) * a_i;
            impulsive.hypot(field.convective(z) * a_c).hypot(still(z) * action.vertical)
        };
        let of = |value: &dyn Fn(f64) -> f64| heights.iter().map(|&z| value(z)).collect::<Vec<f64>>();
        for (id, title, values) in [
            ("pressure_impulsive", "Impulsive pressure", of(&|z| field.impulsive(z) * a_i)),
            ("pressure_convective", "Convective pressure", of(&|z| field.convective(z) * a_c)),
            ("pressure_dynamic", "Dynamic pressure", of(&total)),
        ] {
            self.profile(id, title, &heights, values);
        }
        let plan = match case.tank.shape {
            Plan::Cylinder { radius } => WallPlan::Cylinder { radius, base: case.tank.wall_base },
            Plan::Rectangle { strip: true, .. } => WallPlan::Strip,
            Plan::Rectangle { breadth, .. } => WallPlan::Box { half_width: 0.5 * breadth },
        };
        let wall = Wall::new(&case.tank.courses, plan);
        let states = States {
            impulsive: wall.under(|z| field.impulsive(z) + own(z)),
            convective: wall.under(|z| field.convective(z)),
            vertical: wall.under(still),
        };
        let accelerations = [a_i, a_c, action.vertical];
        self.sheet.section("Forces of the wall");
        self.bending(&states, accelerations);
        match case.tank.shape {
            Plan::Cylinder { radius } => self.hoop(&states, accelerations, &heights, radius),
            Plan::Rectangle { .. } => Stresses::default(),
        }
    }

    fn profile(&mut self, id: &str, title: &str, z: &[f64], values: Vec<f64>) {
        let (id, title) = (id.into(), title.into());
        self.out.profiles.push(Profile { id, title, dimension: Stress, z: z.to_vec(), values });
    }

    /// Lines of the pressures at the base.
    fn pressures(&mut self, rules: &dyn Rules, masses: &Masses, share: f64) {
        let course = self.case.tank.course_at(0.0);
        let clauses: &Clauses = rules.clauses();
        let circle = self.breadth() == 0.0;
        let linear = rules.pressures() == Shape::Linear;
        let below = falls_below_zero(&masses.convective, self.case.liquid.fill_height);
        let impulsive = match (linear, circle) {
            (true, true) => "A_i·g·m_i/2·(4·H - 6·h_i)/H²·4/(π·D)",
            (true, false) => "A_i·g·m_i/2·(4·H - 6·h_i)/H²/B",
            (false, _) => "0.866·tanh(0.866·r)·A_i·ρ·g·H",
        };
        let convective = match (linear, circle) {
            (true, _) if below => "0 MPa",
            (true, true) => "A_c·g·m_c/2·(4·H - 6·h_c)/H²·32/(9·π·D)",
            (true, false) => "A_c·g·m_c/2·(4·H - 6·h_c)/H²/B",
            (false, true) => "0.5625·(1 - 1/3)/cosh(3.674/r)·A_c·ρ·g·D",
            (false, false) => "0.4165/cosh(3.162/r)·A_c·ρ·g·L",
        };
        let sheet = &mut self.sheet;
        sheet.section("Pressures on the wall at its base");
        sheet.given(&[("ε", share, Dimensionless)]);
        sheet.input("t", "thickness of the wall at the base", course.thickness, Length, "input");
        let name = "density of the wall at the base";
        sheet.input("ρ_w", name, course.material.density, tank::units::Dimension::Density, "input");
        sheet.calc("p_i", "impulsive", impulsive, Stress, clauses.pressures);
        sheet.calc("p_c", "convective", convective, Stress, clauses.pressures);
        sheet.calc("p_w", "inertia of the wall", "A_i·ε·ρ_w·t·g", Stress, clauses.pressures);
        sheet.calc("p_v", "vertical motion", "A_v·ρ·g·H", Stress, clauses.pressures);
        sheet.calc("p", "all", "√((p_i + p_w)² + p_c² + p_v²)", Stress, clauses.combination);
    }

    /// Lines of bending at the base; none of a wall that turns freely there.
    fn bending(&mut self, states: &States, [a_i, a_c, a_v]: [f64; 3]) {
        let base = |part: fn(&(f64, f64)) -> f64| {
            let [i, c, v] = [&states.impulsive, &states.convective, &states.vertical].map(|state| part(&state.base));
            (i * a_i).hypot(c * a_c).hypot(v * a_v)
        };
        let source = "shell or plate under the pressures, parts by SRSS";
        let name = "shear of the wall at its base, seismic part";
        self.sheet.look_up("v_z", name, source, base(|b| b.1), LineForce, "statics");
        if matches!(self.case.tank.shape, Plan::Cylinder { .. }) && !self.case.tank.wall_base.holds().1 {
            return;
        }
        let name = "bending moment of the wall at its base, seismic part";
        self.sheet.look_up("m_z", name, source, base(|b| b.0), LineMoment, "statics");
        let thickness = self.case.tank.course_at(0.0).net_thickness();
        self.sheet.given(&[("t", thickness, Length)]);
        let stress = self.sheet.calc("σ_b", "bending stress at the base", "6·m_z/t²", Stress, "statics");
        self.out.values.insert(Quantity::BendingStress, stress);
    }

    /// Lines of the largest hoop force and the axial stress of the moment.
    fn hoop(&mut self, states: &States, [a_i, a_c, a_v]: [f64; 3], heights: &[f64], radius: f64) -> Stresses {
        let tank = &self.case.tank;
        let at = |state: &State, z: f64| state.hoop(z) / tank.course_at(z).net_thickness();
        let along: Vec<(f64, f64, f64)> =
            heights.iter().map(|&z| (z, at(&states.impulsive, z), at(&states.convective, z))).collect();
        let vertical: Vec<f64> = heights.iter().map(|&z| at(&states.vertical, z) * a_v).collect();
        let stress: Vec<f64> =
            (along.iter().zip(&vertical)).map(|((_, i, c), v)| (i * a_i).hypot(c * a_c).hypot(*v)).collect();
        let place = (0..stress.len()).max_by(|&a, &b| stress[a].total_cmp(&stress[b])).unwrap_or(0);
        let (z, impulsive, convective) = along[place];
        let (name, source) = ("height of the largest hoop stress", "largest of the profile over the height");
        self.sheet.look_up("z", name, source, z, Length, "profile");
        let (name, source) = ("hoop force there, seismic part", "shell under the pressures, parts by SRSS");
        let net = tank.course_at(z).net_thickness();
        self.sheet.look_up("n_θ", name, source, stress[place] * net, LineForce, "statics");
        self.sheet.given(&[("t", net, Length)]);
        let largest = self.sheet.calc("σ_θ", "largest hoop stress", "n_θ/t", Stress, "statics");
        let net = tank.course_at(0.0).net_thickness();
        self.sheet.given(&[("t", net, Length)]);
        let name = "axial membrane stress of the moment at the base";
        let axial = self.sheet.calc("σ_z", name, "M/(π·D²·t/4)", Stress, "statics");
        self.out.values.extend([(Quantity::HoopStress, largest), (Quantity::AxialMembraneStress, axial)]);
        self.profile("hoop_stress", "Hoop stress", heights, stress);
        let hoop = Hoop { impulsive, convective, vertical: vertical[place], along };
        Stresses { hoop: Some(hoop), axial: 1.0 / (PI * radius * radius * net) }
    }
}
