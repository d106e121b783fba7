//! Pressures and membrane stresses over the height of a cylinder.
//!
//! ```text
//! p_i(z) = ρ H C(ζ) A_i      p_c(z) = ρ R w_1 cosh(λ_1 γ ζ)/cosh(λ_1 γ) A_c       largest at θ = 0
//! n_θ = p R      n_z = M(z)/(π R²)      N_0 = (m_w + f_s m_r above z) g/(2πR)        (membrane; f_s of a roof on columns)
//! n_θ = E s w/R of the shell on its joint with the base where the wall is not a metal shell ([`Shell`])
//! ```
//!
//! M(z) is the moment of wall pressure, wall and roof inertia above z. Horizontal (E_x) and vertical (E_z) motion are combined as
//! E_x + 0.3 E_z and 0.3 E_x + E_z.

use std::f64::consts::PI;

use super::cylinder_vertical::VerticalMotion;
use super::ingredients::Stresses;
use super::vertical;
use super::wall_bending::{Plan as Standing, Wall};
use super::work::{Work, combined};
use crate::mechanical::{ConvectiveField, ImpulsiveField, Plan};
use crate::sheet::with_unit;
use tank::case::Combination;
use tank::ingredients::Vertical;
use tank::quantity::Quantity;
use tank::units::Dimension::*;
use tank::{Liquid, Tank};

/// Seismic state of the wall over the height.
pub(super) struct State<'a> {
    pub tank: &'a Tank,
    liquid: Liquid,
    pub radius: f64,
    pub gravity: f64,
    impulsive: ImpulsiveField,
    convective: ConvectiveField,
    a_i: f64,
    a_c: f64,
    pub combination: Combination,
    motion: VerticalMotion,
    /// Factor of the horizontal components beside the full vertical one.
    beside_vertical: f64,
    /// M just above the base plate [N·m], as the procedure gives it.
    pub base_moment: f64,
    /// Height of the largest hoop stress [m].
    hoop_at: f64,
    /// Hoop forces of a wall that is not a metal shell.
    shell: Option<Shell>,
}

/// Hoop forces of a shell on its joint with the base, tabulated over the wetted wall and linear between.
struct Shell {
    /// Heights [m].
    z: Vec<f64>,
    /// Hoop forces by the impulsive and the convective pressure per acceleration [kg/m], by the vertical motion [N/m].
    forces: Vec<[f64; 3]>,
}

impl Shell {
    fn of(state: &State<'_>) -> Shell {
        let (tank, radius) = (state.tank, state.radius);
        let plan = Standing::Cylinder { radius, base: tank.wall_base };
        let wall = Wall::new(&tank.courses, plan);
        let depth = state.liquid.fill_height;
        let wet = |z: f64, value: f64| if z <= depth { value } else { 0.0 };
        let states = [
            wall.under(|z| wet(z, state.impulsive_coefficient(state.zeta(z)))),
            wall.under(|z| wet(z, state.convective_coefficient(state.zeta(z)))),
            wall.under(|z| wet(z, state.pressure_vertical(z))),
        ];
        let z = tank.profile_heights(depth);
        let forces = z.iter().map(|&z| states.each_ref().map(|s| s.hoop(z).max(0.0)));
        Shell { forces: forces.collect(), z }
    }

    fn at(&self, z: f64) -> [f64; 3] {
        let above = self.z.partition_point(|height| *height <= z);
        let Some((&low, &from)) = above.checked_sub(1).and_then(|i| self.z.get(i).zip(self.forces.get(i))) else {
            return [0.0; 3];
        };
        match self.z.get(above).zip(self.forces.get(above)) {
            Some((high, to)) => std::array::from_fn(|k| from[k] + (z - low) / (high - low) * (to[k] - from[k])),
            None => from,
        }
    }
}

/// Factors of horizontal and vertical motion in one combination.
pub(super) type Factors = (f64, f64);

impl State<'_> {
    fn zeta(&self, z: f64) -> f64 {
        z / self.liquid.fill_height
    }

    pub(super) fn pressure_impulsive(&self, z: f64) -> f64 {
        let zeta = self.zeta(z);
        if zeta >= 1.0 {
            return 0.0;
        }
        self.impulsive_coefficient(zeta) * self.a_i
    }

    pub(super) fn pressure_convective(&self, z: f64) -> f64 {
        let zeta = self.zeta(z);
        if zeta > 1.0 {
            return 0.0;
        }
        self.convective_coefficient(zeta) * self.a_c
    }

    /// Impulsive pressure per acceleration [kg/m²].
    fn impulsive_coefficient(&self, zeta: f64) -> f64 {
        self.liquid.density * self.liquid.fill_height * self.impulsive.wall(zeta)
    }

    /// Convective pressure per acceleration [kg/m²].
    fn convective_coefficient(&self, zeta: f64) -> f64 {
        self.liquid.density * self.radius * self.convective.wall(zeta)
    }

    /// What the membrane stresses are made of.
    pub(super) fn ingredients(&self, vertical: bool) -> Stresses {
        let z = self.hoop_at;
        let per_pressure = |z: f64| self.radius / self.tank.course_at(z).net_thickness();
        let at = |z: f64| {
            if let Some(shell) = &self.shell {
                let [impulsive, convective, _] = shell.at(z).map(|n| n / self.tank.course_at(z).net_thickness());
                return (impulsive, convective);
            }
            let (zeta, per_pressure) = (self.zeta(z), per_pressure(z));
            let wetted = |below: bool, coefficient: f64| if below { coefficient * per_pressure } else { 0.0 };
            let impulsive = wetted(zeta < 1.0, self.impulsive_coefficient(zeta));
            (impulsive, wetted(zeta <= 1.0, self.convective_coefficient(zeta)))
        };
        let (horizontal, factor) = self.governing(z, vertical);
        let (impulsive, convective) = at(z);
        let heights = self.tank.profile_heights(self.liquid.fill_height).into_iter();
        Stresses {
            impulsive,
            convective,
            along: heights.map(|z| (z, at(z).0, at(z).1)).collect(),
            vertical: vertical.then(|| Vertical {
                horizontal,
                value: factor * self.vertical_hoop(z) / self.tank.course_at(z).net_thickness(),
                combination: Combination::Abs,
            }),
            axial: 1.0 / (PI * self.radius * self.radius * self.tank.courses[0].net_thickness()),
        }
    }

    /// Largest interior pressure at z over all combinations [Pa].
    pub(super) fn largest_pressure(&self, z: f64, vertical: bool) -> f64 {
        let combinations = self.combinations(vertical).into_iter();
        let all = combinations.flat_map(|factors| self.gas().into_iter().map(move |gas| (factors, gas)));
        all.map(|(factors, gas)| self.pressure_range(z, factors, gas).1).fold(0.0, f64::max)
    }

    pub(super) fn pressure_horizontal(&self, z: f64) -> f64 {
        combined(self.combination, self.pressure_impulsive(z), self.pressure_convective(z))
    }

    pub(super) fn pressure_vertical(&self, z: f64) -> f64 {
        let zeta = self.zeta(z);
        let scale = self.liquid.density * self.liquid.fill_height;
        let rigid = vertical::rigid_pressure(zeta) * self.motion.ground;
        let breathing = vertical::breathing_pressure(self.motion.factor, zeta) * self.motion.breathing;
        scale * rigid.hypot(breathing)
    }

    pub(super) fn pressure_hydrostatic(&self, z: f64) -> f64 {
        self.liquid.density * self.gravity * (self.liquid.fill_height - z).max(0.0)
    }

    /// Pressures of the gas above the liquid between which it may lie [Pa]: overpressure, and vacuum as a negative number.
    ///
    /// Demand over capacity of A.10 is a falling line over a concave function of this pressure, so that it is largest at one end.
    pub(super) fn gas(&self) -> Vec<f64> {
        let pressure = self.tank.pressure;
        if pressure.is_none() { vec![0.0] } else { vec![pressure.internal, -pressure.vacuum] }
    }

    /// Smallest and largest interior pressure of a combination.
    ///
    /// * `gas`: pressure above the liquid [Pa]
    pub(super) fn pressure_range(&self, z: f64, (x, v): Factors, gas: f64) -> (f64, f64) {
        let still = self.pressure_hydrostatic(z) + gas;
        let seismic = x * self.pressure_horizontal(z) + v * self.pressure_vertical(z);
        (still - seismic, still + seismic)
    }

    pub(super) fn combinations(&self, vertical: bool) -> Vec<Factors> {
        if vertical { vec![(1.0, 0.3), (self.beside_vertical, 1.0)] } else { vec![(1.0, 0.0)] }
    }

    /// Largest seismic pressure over the combinations.
    fn pressure_seismic(&self, z: f64, vertical: bool) -> f64 {
        let combinations = self.combinations(vertical).into_iter();
        combinations.map(|factors| self.pressure_of(z, factors)).fold(0.0, f64::max)
    }

    fn pressure_of(&self, z: f64, (x, v): Factors) -> f64 {
        x * self.pressure_horizontal(z) + v * self.pressure_vertical(z)
    }

    /// Hoop force of the vertical motion [N/m].
    fn vertical_hoop(&self, z: f64) -> f64 {
        match &self.shell {
            Some(shell) => shell.at(z)[2],
            None => self.pressure_vertical(z) * self.radius,
        }
    }

    /// Hoop force of a combination [N/m].
    fn hoop_of(&self, z: f64, (x, v): Factors) -> f64 {
        let horizontal = match &self.shell {
            Some(shell) => {
                let [impulsive, convective, _] = shell.at(z);
                combined(self.combination, impulsive * self.a_i, convective * self.a_c)
            }
            None => self.pressure_horizontal(z) * self.radius,
        };
        x * horizontal + v * self.vertical_hoop(z)
    }

    /// The combination of the largest seismic hoop force.
    fn governing(&self, z: f64, vertical: bool) -> Factors {
        let larger = |best: Factors, next: Factors| match self.hoop_of(z, next) > self.hoop_of(z, best) {
            true => next,
            false => best,
        };
        self.combinations(vertical).into_iter().reduce(larger).unwrap_or_default()
    }

    /// Moment of the wall's cross-section at z [N·m].
    fn moment(&self, z: f64) -> f64 {
        let zeta = self.zeta(z).min(1.0);
        let scale = self.liquid.mass(self.tank.shape) * self.liquid.fill_height;
        let (_, wall) = self.tank.mass_above(z);
        let impulsive = (scale * self.impulsive.moment_above(zeta) + wall) * self.a_i;
        let convective = scale * self.convective.moment_above(zeta) * self.a_c;
        combined(self.combination, impulsive, convective)
    }

    /// Shear of the wall's cross-section at z [N].
    pub(super) fn shear(&self, z: f64) -> f64 {
        let zeta = self.zeta(z).min(1.0);
        let liquid = self.liquid.mass(self.tank.shape);
        let wall = self.tank.mass_above(z).0;
        let impulsive = (liquid * self.impulsive.shear_above(zeta) + wall) * self.a_i;
        combined(self.combination, impulsive, liquid * self.convective.shear_above(zeta) * self.a_c)
    }

    /// Acceleration of the impulsive part [m/s²].
    pub(super) fn impulsive_acceleration(&self) -> f64 {
        self.a_i
    }

    /// Largest seismic axial force per length at z [N/m].
    pub(super) fn axial(&self, z: f64) -> f64 {
        let moment = if z == 0.0 { self.base_moment } else { self.moment(z) };
        moment / (PI * self.radius * self.radius)
    }

    /// Axial force per length of the weight that the wall carries at z [N/m].
    pub(super) fn weight(&self, z: f64) -> f64 {
        self.tank.weight_above(z) * self.gravity / (2.0 * PI * self.radius)
    }

    /// The same at the base without snow, which may be absent: what holds the wall down [N/m].
    pub(super) fn held(&self) -> f64 {
        let mass = self.tank.weight_above(0.0) - self.tank.roof.snow_on_wall();
        mass * self.gravity / (2.0 * PI * self.radius)
    }

    /// `1 ± v A_v/g` on the weight.
    pub(super) fn weight_factor(&self, v: f64) -> f64 {
        1.0 + v * self.motion.ground / self.gravity
    }
}

/// Writes pressures, stresses and profiles; returns the state.
///
/// * `moment`: M just above the base plate [N·m]; `a_i`, `a_c`: accelerations of the impulsive part and of the first sloshing mode
pub(super) fn assess<'a>(
    work: &mut Work<'a>,
    radius: f64,
    moment: f64,
    a_i: f64,
    a_c: f64,
    motion: Option<VerticalMotion>,
) -> State<'a> {
    let case = work.case;
    let gamma = case.liquid.fill_height / radius;
    let mut state = State {
        tank: &case.tank,
        liquid: case.liquid,
        radius,
        gravity: case.gravity,
        impulsive: ImpulsiveField::new(Plan::Circle, gamma),
        convective: ConvectiveField::new(Plan::Circle, gamma, 1),
        a_i,
        a_c,
        combination: case.procedures.ec8_combination,
        motion: motion.unwrap_or_default(),
        beside_vertical: work.demand.beside_vertical(),
        base_moment: moment,
        hoop_at: 0.0,
        shell: None,
    };
    state.shell = (!case.tank.is_metal()).then(|| Shell::of(&state));
    base_pressures(work, &state);
    state.hoop_at = stresses(work, &state, motion.is_some());
    state
}

fn base_pressures(work: &mut Work, state: &State) {
    work.sheet.section("Pressures on the wall at its base");
    work.sheet.given(&[
        ("A_i", state.a_i, Acceleration),
        ("A_c1", state.a_c, Acceleration),
        ("C", state.impulsive.wall(0.0), Dimensionless),
        ("c_1", state.convective.wall(0.0), Dimensionless),
    ]);
    let [impulsive, convective] = ["2.1.2", "2.1.3"].map(|n| work.edition.clause(n));
    let sheet = &mut work.sheet;
    sheet.calc("p_0", "hydrostatic", "ρ·g·H", Stress, "definition");
    let name = "impulsive, C = C_i(ξ = 1, ζ = 0)";
    sheet.calc("p_i", name, "ρ·H·C·A_i", Stress, &impulsive);
    sheet.calc("p_c", "convective, mode 1", "ρ·R·c_1·A_c1", Stress, &convective);
    let formula = match state.combination {
        Combination::Abs => "p_i + p_c",
        Combination::Srss => "√(p_i² + p_c²)",
    };
    let clause = work.edition.clause("2.1");
    work.sheet.calc("p", "horizontal motion", formula, Stress, &clause);
}

/// Profiles and lines of the membrane stresses; returns the height of the largest hoop stress [m].
fn stresses(work: &mut Work, state: &State, vertical: bool) -> f64 {
    let z = work.heights();
    let base = &state.tank.courses[0];
    let pressure: Vec<f64> = z.iter().map(|&z| state.pressure_seismic(z, vertical)).collect();
    let hoop = |&z: &f64| state.hoop_of(z, state.governing(z, vertical)) / state.tank.course_at(z).net_thickness();
    let hoop: Vec<f64> = z.iter().map(hoop).collect();
    let axial = |z: f64| state.axial(z) / state.tank.course_at(z).net_thickness();
    work.profile("pressure_impulsive", "Impulsive pressure", Stress, &z, |z| state.pressure_impulsive(z));
    work.profile("pressure_convective", "Convective pressure", Stress, &z, |z| state.pressure_convective(z));
    work.profile_of(("pressure_dynamic", "Seismic pressure", Stress), &z, pressure);
    work.profile_of(("hoop_stress", "Hoop stress (membrane)", Stress), &z, hoop.clone());
    work.profile("axial_membrane_stress", "Axial membrane stress", Stress, &z, axial);

    work.sheet.section("Membrane stresses (seismic part)");
    let (mut at, mut largest) = (0.0, 0.0);
    for (z, hoop) in z.into_iter().zip(hoop) {
        if hoop > largest {
            (at, largest) = (z, hoop);
        }
    }
    work.sheet.given(&[
        ("p", state.pressure_seismic(at, vertical), Stress),
        ("s", state.tank.course_at(at).net_thickness(), Length),
    ]);
    let name = format!("largest hoop stress, at z = {}", with_unit(at, Length));
    let largest = match &state.shell {
        Some(_) => {
            let source = "shell on its joint with the base, pressure of the meridian all around";
            work.sheet.look_up("σ_θ", &name, source, largest, Stress, "theory of shells")
        }
        None => work.sheet.calc("σ_θ", &name, "p·R/s", Stress, "membrane theory"),
    };
    work.sheet.given(&[("s", base.net_thickness(), Length)]);
    let (name, formula) = ("axial membrane stress at the base", "M/(π·R²·s)");
    let sigma = work.sheet.calc("σ_z", name, formula, Stress, "membrane theory");
    work.out.values.insert(Quantity::HoopStress, largest);
    work.out.values.insert(Quantity::AxialMembraneStress, sigma);
    at
}
