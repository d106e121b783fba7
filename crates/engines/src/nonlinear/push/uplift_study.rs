//! Shells beside strips at one rotation: one assumption changes from row to row. The tank is that of `examples/09_slender_unanchored`.
//!
//! ```text
//! cargo test -p engines --lib uplift_study -- --ignored --nocapture
//! ```

use fem::progress::Silent;
use results::PushPoint;
use tank::options::nonlinear::{ThicknessRule, WallElements};
use tank::reference::{case, material};
use tank::{Behaviour, Bottom, Case, Foundation, FoundationKind, Material, Roof, Shape, Steel, Support};

use super::*;

/// Rotation at which the two are compared [rad].
const ROTATION: f64 = 0.0165;

/// Strength of a steel that does not yield here [Pa].
const NEVER: f64 = 20e9;

/// One row.
#[derive(Clone, Copy)]
struct Variant {
    name: &'static str,
    /// Whether wall and plate yield.
    yields: [bool; 2],
    plane: bool,
    /// Of wall and bottom: rows, sectors, refinement of the rings, points through the thickness.
    mesh: (u32, u32, f64, u32),
    modulus: f64,
    /// Whether the pressure turns with the plates.
    follower: bool,
}

/// The hinge of the wall needs short rows at the foot.
const MESH: (u32, u32, f64, u32) = (60, 24, 1.0, 5);

const fn variant(name: &'static str, yields: [bool; 2], plane: bool) -> Variant {
    Variant { name, yields, plane, mesh: MESH, modulus: 1e8, follower: true }
}

fn steel(yields: bool) -> Material {
    let mut steel = material(205e9, 0.3, 7850.0);
    let yield_strength = if yields { 250e6 } else { NEVER };
    steel.yield_strength = Some(yield_strength);
    steel.behaviour = Behaviour::Steel(Steel {
        yield_strength,
        tangent_modulus: 2.05e9,
        kinematic_share: 1.0,
        ultimate_strength: None,
    });
    steel
}

fn slender(variant: &Variant) -> Case {
    let [wall, plate] = variant.yields.map(steel);
    let courses = [8e-3, 6e-3, 5e-3, 5e-3, 5e-3, 5e-3].map(|t| (2.0, t));
    let mut case = case(Shape::Cylinder { radius: 5.0 }, &courses, &wall, (1000.0, 11.0));
    case.tank.support = Support::Unanchored;
    case.tank.roof = Roof { mass: 4000.0, height: Some(12.5), ..case.tank.roof };
    case.tank.bottom = Some(Bottom {
        thickness: 8e-3,
        corrosion: 0.0,
        width: Some(1.5),
        sketch: Some(6e-3),
        projection: 0.05,
        subgrade_modulus: None,
        material: plate,
    });
    case.tank.foundation = Some(Foundation {
        width: None,
        kind: FoundationKind::Soil,
        stiffness: Some(variant.modulus),
        shear_wave_velocity: None,
        soil_density: 1900.0,
        soil_poisson_ratio: 0.33,
        thickness: None,
        friction: Some(0.4),
    });
    case
}

/// Moment [MN m], uplift [mm]; stress of the wall at the toe, and of the ground's reaction there, of the strips where they settle as the shells do
/// [MPa]; plastic rotation of plate and of wall [rad], of the strips that of the plate and that by [`alike`].
type Values = [f64; 6];

/// Plastic rotation [rad] of a strip at an uplift [m] that has what shells have besides: 2/√3 f_y of plane strain and the suction [Pa] on its pressure.
fn alike(case: &Case, suction: f64, uplift: f64) -> f64 {
    let mut case = case.clone();
    if let Some(bottom) = &mut case.tank.bottom {
        bottom.material.yield_strength = bottom.material.yield_strength.map(|f| f * 2.0 / 3.0_f64.sqrt());
    }
    let base = base::Base::of(&case).unwrap();
    let strip = base.strip(base.pressure - suction).unwrap();
    let mut state = base::Lifted::at_rest(&strip, base.weight).unwrap();
    state.lift_to(uplift).unwrap();
    state.point().plastic_rotation
}

/// Shells and strips at [`ROTATION`], between the states on either side, and the acceleration there over g.
fn at(variant: &Variant) -> Option<(f64, Values, Values)> {
    let case = slender(variant);
    let (height, circumference, bottom_mesh, points) = variant.mesh;
    let mut options = NonlinearOptions {
        elements: Some(WallElements { height, circumference }),
        bottom_mesh,
        follower_pressure: variant.follower,
        ..NonlinearOptions::new(case.damping)
    };
    options.integration.steel = ThicknessRule::Gauss(points);
    let push = PushOptions { plane_foot: variant.plane, ..PushOptions::default() };
    let pushed = pushover(&case, &options, &push, &[], None, &Silent).unwrap();
    let path = &pushed.shells[0].path;
    let rotation = |p: &PushPoint| p.base.map_or(0.0, |b| b.rotation);
    let after = path.iter().position(|p| rotation(p) > ROTATION)?;
    let values = |p: &PushPoint| -> Option<(f64, Values, Values)> {
        let b = p.base?;
        let s = b.strip?;
        let mega = |v: f64| 1e-6 * v;
        let shells = [
            mega(b.moment),
            1e3 * b.uplift,
            mega(b.toe_stress),
            mega(b.toe_reaction),
            b.plastic_rotation,
            b.wall_rotation,
        ];
        let strips =
            [mega(b.strips?), 1e3 * s.uplift, mega(s.toe_stress), mega(s.settled), s.plastic_rotation, f64::NAN];
        Some((p.acceleration / case.gravity, shells, strips))
    };
    let (a, b) = (&path[after.checked_sub(1)?], &path[after]);
    let share = (ROTATION - rotation(a)) / (rotation(b) - rotation(a));
    let (a, b) = (values(a)?, values(b)?);
    let mix = |a: Values, b: Values| -> Values { std::array::from_fn(|i| a[i] + share * (b[i] - a[i])) };
    let (acceleration, shells, mut strips) = (a.0 + share * (b.0 - a.0), mix(a.1, b.1), mix(a.2, b.2));
    let suction = Plan::new(&case, &options, variant.plane).unwrap().plate.unwrap().suction() * case.gravity;
    strips[5] = alike(&case, suction * acceleration, 1e-3 * shells[1]);
    Some((acceleration, shells, strips))
}

/// The rows; `TANKCHECK_STUDY` runs those whose name contains it.
#[test]
#[ignore = "slow: a study, cargo test -p engines --lib uplift_study -- --ignored --nocapture; last result in docs/theory/base.md"]
fn shells_beside_strips() {
    let full = variant("as it is", [true, true], false);
    let held = variant("plate yields, plane foot", [false, true], true);
    let rows = [
        variant("elastic, plane foot", [false, false], true),
        variant("elastic, free top", [false, false], false),
        held,
        variant("plate yields, free top", [false, true], false),
        variant("wall yields, plane foot", [true, false], true),
        variant("both yield, plane foot", [true, true], true),
        full,
        Variant { name: "as it is, rings half as wide", mesh: (60, 24, 2.0, 5), ..full },
        Variant { name: "as it is, 9 points", mesh: (60, 24, 1.0, 9), ..full },
        Variant { name: "as it is, 48 sectors", mesh: (60, 48, 1.0, 5), ..full },
        Variant { name: "as it is, 90 rows", mesh: (90, 24, 1.0, 5), ..full },
        Variant { name: "as it is, ground of 300 MN/m³", modulus: 3e8, ..full },
        Variant { name: "plate yields, plane foot, rings half as wide", mesh: (60, 24, 2.0, 5), ..held },
        Variant { name: "plate yields, plane foot, dead pressure", follower: false, ..held },
        Variant { name: "plate yields, plane foot, 9 points", mesh: (60, 24, 1.0, 9), ..held },
    ];
    let chosen = std::env::var("TANKCHECK_STUDY").unwrap_or_default();
    for row in rows.iter().filter(|row| row.name.contains(&chosen)) {
        let found = at(row);
        println!("{:46} {found:.3?}", row.name);
        let Some((_, shells, strips)) = found else { continue };
        // Strips against shells under the same assumptions: M(ψ) 3 % and hoop forces, with which a plate that lifts evenly by 100 mm holds 10 %
        // more (page base-joint), so 6 % where a part of the rim lifts that far; uplift 5 %; reaction at the toe 10 %, which gathers on an arc of a
        // few elements.
        if row.name == "elastic, plane foot" {
            let (moment, uplift, toe) =
                (shells[0] / strips[0] - 1.0, shells[1] / strips[1] - 1.0, shells[3] / strips[2] - 1.0);
            assert!(moment.abs() < 0.06 && uplift.abs() < 0.05 && toe.abs() < 0.1, "{shells:?} {strips:?}");
        }
        // The reaction is that of the strips at the settlement of the shells, as far as neighbouring meridians leave each other alone: 15 %.
        assert!((shells[3] / strips[3] - 1.0).abs() < 0.15, "{shells:?} {strips:?}");
    }
}
