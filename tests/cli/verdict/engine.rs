//! Tanks that the harmonic engine decides under a record: a sine of 2 s at 2.2 Hz, of 0.1 m/s² unless said otherwise.

use results::VerdictStatus::{Fails, Holds, Incomplete};
use serde_json::json;
use tank::assessment::Check;

use super::*;

const FE: &str = "fe";
/// A motion so weak that the static state decides [m/s²].
const WEAK: f64 = 0.1;

/// Limit states of the codes that a run does not check, but for those accepted in the base tank.
const OF_CODES: [&str; 2] = ["shear_transfer", "bearing_api"];

/// The run decides, on a site that is weaker than its motion.
fn decides() -> Value {
    let mut change = accept(&[]);
    merge(
        &mut change,
        &json!({
            "procedures": { "decide": ["fe"] },
            "site": { "ec8": { "ag": "0.001 g" }, "api650": { "ss": 0.003, "s1": 0.001 } }
        }),
    );
    change
}

/// More accepted gaps than those of the base tank and of every run.
pub(super) fn accept(more: &[&str]) -> Value {
    super::accept(&[&OF_CODES, more].concat())
}

/// A site of 0.1 g of Eurocode 8 alone, about ten times the weakest motion.
fn strong_site() -> Value {
    json!({ "site": { "api650": null, "ec8": { "ag": "0.1 g" } } })
}

/// All gaps of the base tank but that of the records.
fn without_records() -> Value {
    let others = ACCEPTED.iter().chain(&OF_CODES).filter(|check| **check != "ground_motion");
    json!({ "accepted": others.map(|check| gap(check)).collect::<Vec<_>>() })
}

pub(super) fn tank(
    name: &'static str,
    why: &'static str,
    (status, first): (VerdictStatus, &'static str),
    changes: Vec<Value>,
) -> Tank {
    let changes = [vec![decides()], changes].concat();
    Tank::new(name, why, Expected::Verdict(status, FE, first), changes).run(WEAK)
}

/// Tanks that must not hold.
pub(super) fn failing() -> Vec<Tank> {
    [walls(), base(), gaps(), plates::failing(), engine_bearing::failing()].into_iter().flatten().collect()
}

fn walls() -> Vec<Tank> {
    vec![
        tank(
            "engine-hoop-yields",
            "static 83.4 kPa x 10 m/3 mm = 278 MPa > 235 MPa at the bottom; the clamped edge takes little of it",
            (Fails, ANY),
            vec![only_ec8(), wall(&[3.0; 4])],
        ),
        tank(
            "engine-hoop-allowable",
            "static 58.8 kPa x 10 m/2.8 mm = 210 MPa at 2.5 m: above 182 MPa, below 235 MPa",
            (Fails, "hoop_stress"),
            vec![only_api(), wall(&[14.0, 2.8, 10.0, 10.0])],
        ),
        tank(
            "engine-axial-compression",
            "6000 t: 58.8 MN/62.8 m/10 mm = 94 MPa in the dry top course; σ_c1 = 126 MPa, σ_p = 67 MPa: 0.19 x 126 + 0.81 x 67 = 78 MPa",
            (Fails, "buckling_elastic"),
            vec![only_ec8(), roof(6000.0)],
        ),
        tank(
            "engine-axial-compression-api",
            "4000 t: 62 MPa in the top course, 83 x 10/(2.5 x 20) MPa + little",
            (Fails, "shell_compression"),
            vec![only_api(), roof(4000.0)],
        ),
        tank(
            "engine-elephant-foot",
            "83.4 kPa x 10 m/4 mm = 208 MPa of 235 MPa leaves 1 - 0.79 of σ_c1 = 50 MPa at the bottom: 500 t press with 20 MPa",
            (Fails, "buckling_elastic_plastic"),
            vec![only_ec8(), wall(&[4.0, 6.0, 6.0, 6.0]), roof(500.0)],
        ),
    ]
}

fn base() -> Vec<Tank> {
    vec![
        tank("engine-freeboard", "filled to the brim", (Fails, "freeboard"), vec![filled(10.0)]),
        tank(
            "engine-sliding",
            "5 m/s² on a liquid that moves with it by half, friction 0.1",
            (Fails, "sliding"),
            vec![
                only_ec8(),
                anchors(90000.0),
                wall(&[28.0, 24.0, 20.0, 20.0]),
                json!({ "site": { "ec8": { "friction": 0.1 } } }),
            ],
        )
        .open(&["sliding"])
        .run(3.0),
        tank(
            "engine-five-anchors",
            "five anchors at which the earthquake pulls: six are needed, and one every 12.6 m is too few",
            (Fails, "anchor_spacing"),
            vec![only_ec8(), json!({ "tank": { "anchors": { "count": 5, "capacity": "90 MN" } } })],
        )
        .run(1.5),
        tank(
            "engine-four-anchors-slim",
            "four anchors 4.71 m apart on a tank of 3 m radius",
            (Fails, "anchor_spacing"),
            vec![only_api(), slim(), json!({ "tank": { "anchors": { "count": 4 } } })],
        ),
        tank(
            "engine-lapped-annular-plates",
            "lap welds in an annular plate of 12 mm",
            (Fails, "annular_weld"),
            vec![
                only_api(),
                unanchored(),
                json!({ "tank": { "bottom": { "thickness": "12 mm", "annular_weld": "lap" } } }),
            ],
        ),
        tank(
            "engine-anchors-weak",
            "anchors of 1 kN every 1.57 m; 1.5 m/s² pull more than the weight of 9 kN/m",
            (Fails, "anchorage"),
            vec![anchors(1.0)],
        )
        .run(1.5),
    ]
}

fn gaps() -> Vec<Tank> {
    vec![
        tank(
            "engine-anchors-missing",
            "the wall pulls, and the anchors are not given",
            (Incomplete, "anchorage"),
            vec![json!({ "tank": { "anchors": null } })],
        )
        .run(1.5),
        tank(
            "engine-unanchored-pulls",
            "the tank lifts, and bending at the joint of the bottom plate is not given",
            (Incomplete, "equivalent_stress_at_base"),
            vec![unanchored(), accept(&["uplift_tension", "hoop_yield", "hoop_stress", "shell_compression"])],
        )
        .run(1.5),
        tank(
            "engine-one-record",
            "one record that is strong enough: EN 1998-1 asks for three",
            (Incomplete, "ground_motion"),
            vec![only_ec8(), without_records()],
        ),
        tank(
            "engine-weak-record",
            "a record of 0.1 m/s² on a site of 0.1 g, 1.2 x 0.98 m/s² at T = 0: a factor of 11.8 at least, which nobody can accept",
            (Fails, "ground_motion"),
            vec![strong_site()],
        ),
        tank(
            "engine-weak-record-api",
            "S_DS = 2/3 x 1.3 x 0.3 = 0.26 g on the plateau",
            (Fails, "ground_motion"),
            vec![only_api(), json!({ "site": { "api650": { "ss": 0.3, "s1": 0.1 } } })],
        ),
        tank(
            "engine-weak-record-table",
            "a table of 0.2 g that ends at 2 s, before twice the sloshing period of 4.9 s: the record is too weak before",
            (Fails, "ground_motion"),
            vec![
                strong_site(),
                json!({ "site": {
                    "ec8": { "ground": null, "spectrum": null, "ag": null },
                    "spectrum": { "table": [[0, 0.2], [2, 0.2]], "unit": "g" }
                } }),
            ],
        ),
        tank(
            "engine-without-site",
            "no site: what the record has to stand for is not known",
            (Incomplete, "ground_motion"),
            vec![
                without_records(),
                json!({ "site": null, "tank": { "foundation": { "kind": "soil", "shear_wave_velocity": "300 m/s" } } }),
                anchors(90000.0),
            ],
        ),
        tank(
            "engine-damage-limitation",
            "the run is one earthquake; the frequent one is not run",
            (Incomplete, "damage_limitation"),
            vec![only_ec8()],
        )
        .open(&["damage_limitation"]),
        tank(
            "engine-shear-transfer",
            "the run does not give the shear of the welds",
            (Incomplete, "shear_transfer"),
            vec![only_api()],
        )
        .open(&["shear_transfer"]),
        tank(
            "engine-bearing-api",
            "the pressure on the ground is that of Eurocode 8",
            (Incomplete, "bearing_api"),
            vec![only_api()],
        )
        .open(&["bearing_api"]),
        tank(
            "engine-plate-of-a-lifted-wall",
            "the run gives the rotation of the joint, not membrane stress and lifted width of the plate",
            (Incomplete, "uplift"),
            vec![only_ec8(), unanchored(), accept(&["uplift_tension", "equivalent_stress_at_base"])],
        )
        .open(&["uplift"])
        .run(1.5),
        tank(
            "engine-snow-unknown",
            "a roof of 30 t, and nothing is said of snow",
            (Incomplete, "snow"),
            vec![only_ec8(), json!({ "tank": { "roof": { "mass": "30 t" } } })],
        ),
        tank(
            "engine-internals-unknown",
            "nothing is said of equipment in the liquid",
            (Incomplete, "internals"),
            vec![only_api(), json!({ "tank": { "internals": null } })],
        ),
        tank(
            "engine-annular-weld-unknown",
            "an annular plate of 12 mm is butt-welded, and nothing is said of its weld",
            (Incomplete, "annular_weld"),
            vec![only_api(), unanchored(), json!({ "tank": { "bottom": { "thickness": "12 mm" } } })],
        ),
        tank("engine-friction-missing", "no friction is given", (Incomplete, "sliding"), vec![only_ec8()])
            .open(&["sliding"]),
        tank(
            "engine-yield-missing",
            "no yield strength is given",
            (Incomplete, ANY),
            vec![only_ec8(), json!({ "materials": { "steel": { "yield_strength": null } } })],
        ),
        tank(
            "engine-concrete",
            "the strength of concrete is not implemented",
            (Incomplete, "wall_strength"),
            vec![only_ec8(), concrete(), anchors(90000.0)],
        ),
        tank(
            "engine-box",
            "the strength of a box is not implemented",
            (Incomplete, "wall_strength"),
            vec![
                only_ec8(),
                plates::broad(),
                accept(&["anchorage", "anchor_count", "anchor_spacing", "other_direction"]),
            ],
        ),
        tank(
            "engine-roof-impact",
            "the wave rises above the wall, under a roof",
            (Fails, "freeboard"),
            vec![filled(9.99), roof(10.0)],
        )
        .run(3.0),
    ]
}

/// Tanks that hold.
pub(super) fn sound() -> Vec<Tank> {
    let mut all = vec![
        tank("engine-sound", "the base tank", (Holds, ANY), vec![]),
        tank("engine-sound-ec8", "one code, stronger motion", (Holds, ANY), vec![only_ec8()]).run(0.5),
        tank("engine-sound-api", "one code", (Holds, ANY), vec![only_api()]),
        tank(
            "engine-sound-unanchored",
            "so weak a motion that the wall does not pull",
            (Holds, ANY),
            vec![unanchored()],
        ),
        tank(
            "engine-sound-friction",
            "friction 0.4",
            (Holds, ANY),
            vec![only_ec8(), json!({ "site": { "ec8": { "friction": 0.4 } } })],
        )
        .open(&["sliding"]),
    ];
    all.extend(plates::sound());
    all.extend(engine_bearing::sound());
    all
}

/// The checks of a column.
fn checks<'a>(results: &'a Results, id: &str) -> &'a [Check] {
    let method = results.methods.iter().find(|m| m.id == id);
    &method.unwrap_or_else(|| panic!("no column {id}")).checks
}

fn found<'a>(results: &'a Results, id: &str, check: &str) -> &'a Check {
    let found = checks(results, id).iter().find(|c| c.id == check);
    found.unwrap_or_else(|| panic!("{id} has no check {check}: {:?}", checks(results, id)))
}

/// Without motion the demands are the static ones. A wall of 8 mm, R = 10 m, 8.5 m of water, clamped:
///
/// ```text
/// N_0 = ρ_s g t h above z      σ_b = 6 M_0/t²,  M_0 = [γ H (1 − 1/(β H)) + ν N_0/R] R t/√(12 (1 − ν²)),  β⁴ = 3 (1 − ν²)/(R t)²
/// σ_θ = γ R/t [H − z − e^−βz (H cos βz + (H − 1/β) sin βz)] − ν N_0/t e^−βz (cos βz + sin βz)
/// ```
///
/// Source: Timoshenko & Woinowsky-Krieger 1959, § 117; the last term because the edge holds w = 0, where σ_θ = ν σ_z.
/// Tolerance 0.5 %: the shell of the engine has terms of order t/R = 0.08 % that the cylinder of the book leaves out, and the largest
/// hoop stress lies between two of its places. At the edge 1.5 %: the curvature of a cubic misses the moment p h²/12 of its element,
/// h = 3/16 √(R t), which is 0.97 % of M_0.
#[test]
fn at_rest_the_demands_are_closed_forms() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let tank = tank("at-rest", "", (Holds, ANY), vec![only_ec8(), wall(&[8.0; 4])]).run(1e-9);
    let results = tank.results(home.path()).expect("the input is good");
    let (t, r, h, g, nu) = (0.008_f64, 10.0_f64, 8.5_f64, 9.80665_f64, 0.3_f64);
    let gamma = 1000.0 * g;
    let beta = (3.0 * (1.0 - nu * nu) / (r * t).powi(2)).powf(0.25);
    let weight = |z: f64| 7850.0 * g * (10.0 - z);
    let close = |check: &str, expected: f64, tolerance: f64| {
        let demand = found(&results, "fe", check).demand.expect("a comparison");
        assert!((demand / expected - 1.0).abs() < tolerance, "{check}: {demand} {expected}");
    };
    close("buckling_elastic_plastic", weight(0.0), 5e-3);
    let pressure = gamma * h * (1.0 - 1.0 / (beta * h)) + nu * weight(0.0) * t / r;
    let moment = pressure * r * t / (12.0 * (1.0 - nu * nu)).sqrt();
    let meridional = 6.0 * moment / (t * t) + weight(0.0);
    close("equivalent_stress_at_base", meridional * (1.0 - nu + nu * nu).sqrt(), 1.5e-2);
    let hoop = |z: f64| {
        let edge = (-beta * z).exp() * (h * (beta * z).cos() + (h - 1.0 / beta) * (beta * z).sin());
        let held = (-beta * z).exp() * ((beta * z).cos() + (beta * z).sin());
        gamma * r / t * (h - z - edge) - nu * weight(z) * held
    };
    let heights = || (0..8500).map(|i| f64::from(i) * 1e-3);
    close("hoop_yield", heights().map(hoop).fold(0.0, f64::max), 5e-3);
    let mises = |z: f64| {
        let (a, b) = (hoop(z), -weight(z));
        (a * a + b * b - a * b).sqrt()
    };
    close("equivalent_stress", heights().map(mises).fold(0.0, f64::max), 5e-3);
}

/// An acceleration that rises and falls in 200 s, a (1 − cos)/2: liquid and wall follow statically, the surface tilts.
///
/// ```text
/// p = ρ a R cos θ over the depth      V = (m + m_w) a      M = a (ρ π R² H²/2 + m_w h/2)
/// σ_z = M/(π R² t)                    σ_θ = p R/t [1 − e^−βz (cos βz + sin βz)]
/// ```
///
/// Tolerance 1 %: the first sloshing period is 4.9 s, 1/(1 − (4.9/200)²) = 1.0006; t/R as at rest; the mesh error of the coarse liquid at
/// the corner of surface and wall, where the tilt is not harmonic in the modes that are kept.
#[test]
fn slow_motion_gives_closed_forms() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let friction = json!({ "site": { "ec8": { "friction": 0.4 } } });
    let tank = tank("slow", "", (Holds, ANY), vec![only_ec8(), wall(&[8.0; 4]), friction]).run(0.4);
    let tank = Tank { motion: (4000, |k| 0.5 * (1.0 - (k * std::f64::consts::TAU / 4000.0).cos())), ..tank };
    let results = tank.results(home.path()).expect("the input is good");
    let (t, r, h, g, nu, a) = (0.008_f64, 10.0_f64, 8.5_f64, 9.80665_f64, 0.3_f64, 0.4_f64);
    let pi = std::f64::consts::PI;
    let (liquid, shell) = (1000.0 * pi * r * r * h, 7850.0 * 2.0 * pi * r * 10.0 * t);
    let weight = |z: f64| 7850.0 * g * (10.0 - z);
    let beta = (3.0 * (1.0 - nu * nu) / (r * t).powi(2)).powf(0.25);
    let close = |check: &str, expected: f64| {
        let demand = found(&results, "fe", check).demand.expect("a comparison");
        assert!((demand / expected - 1.0).abs() < 1e-2, "{check}: {demand} {expected}");
    };
    close("sliding", (liquid + shell) * a);
    let moment = a * (0.5 * liquid * h + 5.0 * shell);
    close("buckling_elastic_plastic", weight(0.0) + moment / (pi * r * r * t));
    let hoop = |z: f64| {
        let held = (-beta * z).exp() * ((beta * z).cos() + (beta * z).sin());
        let edge = (-beta * z).exp() * (h * (beta * z).cos() + (h - 1.0 / beta) * (beta * z).sin());
        1000.0 * r / t * (g * (h - z - edge) + a * r * (1.0 - held)) - nu * weight(z) * held
    };
    let largest = (0..8500).map(|i| hoop(f64::from(i) * 1e-3)).fold(0.0, f64::max);
    close("hoop_yield", largest);
    // The ground goes to θ = 0: the liquid presses against θ = 180°.
    let check = found(&results, "fe", "hoop_yield");
    let (time, theta) = check.time_s.zip(check.theta).expect("a time and an angle");
    assert!((time - 100.0).abs() < 5.0 && (theta - pi).abs() < 1e-9, "{check:?}");
}

/// Demands of static and motion together in the harmonic engine and in another one, each on its default mesh.
///
/// Tolerance 10 %: the seismic part is about half of the compression and a tenth of the hoop stress; the engines differ by their mesh
/// (up to 5 % of stresses at the base) and the nonlinear one by its damping and by the centre of its lowest cell.
fn agrees(engines: &'static [EngineId], beside: &str) {
    let home = tempfile::tempdir().expect("a temporary folder");
    let tank = tank("agreement", "", (Holds, ANY), vec![only_ec8()]).run(1.0);
    let results = Tank { engines, ..tank }.results(home.path()).expect("the input is good");
    for check in ["hoop_yield", "equivalent_stress", "buckling_elastic", "buckling_elastic_plastic"] {
        let [own, other] = ["fe", beside].map(|id| found(&results, id, check));
        let ratio = other.utilisation.zip(own.utilisation).map(|(a, b)| a / b).expect("comparisons");
        assert!((ratio - 1.0).abs() < 0.1, "{beside} {check}: {ratio}, {own:?} {other:?}");
    }
    let [own, other] = ["fe", beside].map(|id| found(&results, id, "freeboard").demand.expect("a comparison"));
    assert!((other / own - 1.0).abs() < 0.15, "{beside}: {other} {own}");
}

#[test]
fn the_linear_engines_agree() {
    agrees(&[EngineId::Harmonic, EngineId::Solid], "fe-solid");
}

#[test]
#[ignore = "slow: cargo test --test cli nonlinear_engine_agrees -- --ignored; last result in docs/verification/slow-tests.md"]
fn the_nonlinear_engine_agrees() {
    agrees(&[EngineId::Harmonic, EngineId::Nonlinear], "fe-nonlinear");
}
