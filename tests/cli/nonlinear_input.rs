//! Input of the nonlinear engine: layered walls, behaviour of materials, options; values as read, and messages for faults.

use std::path::{Path, PathBuf};
use std::process::Command;

use engines::nonlinear::{Contact, Damping, MassProportionalAt, ThicknessRule, WallElements};
use tank::{BarDirection, Behaviour, ConcreteLaw, LayerKind, Softening};
use tankcheck::input::TankFile;
use tankcheck::input::diagnostic::Source;
use tankcheck::input::tank::parse;

use super::bad_tank::has;

/// A valid file; the cases below spoil it in one place.
pub(crate) const GOOD: &str = r#"{
  "name": "sandwich",
  "tank": {
    "shape": "cylinder",
    "radius": "10 m",
    "support": "anchored",
    "courses": [
      { "height": "6 m",
        "layers": [
          { "kind": "shell", "thickness": "6 mm", "material": "liner" },
          { "kind": "interlayer", "thickness": "5 cm", "material": "foam" },
          { "kind": "shell", "thickness": "25 cm", "material": "concrete",
            "reinforcement": [
              { "direction": "hoop", "area": "15 cm2/m", "from_outer": "4 cm", "material": "bars" }
            ] }
        ] }
    ]
  },
  "liquid": { "density": "1000 kg/m3", "fill_height": "5.5 m" },
  "materials": {
    "liner": { "grade": "S355" },
    "foam": { "density": "40 kg/m3", "behaviour": { "interlayer": { "e_normal": "10 MPa", "tension": false } } },
    "concrete": {
      "youngs_modulus": "33 GPa", "poisson_ratio": 0.2, "density": "2500 kg/m3",
      "behaviour": { "concrete": { "compressive_strength": "38 MPa", "tensile_strength": "2.9 MPa" } }
    },
    "bars": { "grade": "BSt500" }
  },
  "analysis": { "nonlinear": { "elements": { "height": 24, "circumference": 192 }, "contact": "opening" } }
}
"#;

pub(crate) fn read(text: &str) -> TankFile {
    let source = Source::new("tank.json", text);
    parse(&source).unwrap_or_else(|faults| panic!("{}", faults.render(&source, false)))
}

/// The good file with one passage replaced.
pub(crate) fn changed(from: &str, to: &str) -> String {
    assert_eq!(GOOD.matches(from).count(), 1, "`{from}` must stand once in the good file");
    GOOD.replace(from, to)
}

/// The message for the good file with one passage replaced, without running the program.
pub(crate) fn spoiled(from: &str, to: &str) -> String {
    let source = Source::new("tank.json", changed(from, to));
    let faults = parse(&source).expect_err("a fault");
    let text = faults.render(&source, false);
    assert!(text.contains("tank.json:"), "{text}");
    // One cause, one message.
    assert!(text.contains("error: 1 fault in tank.json"), "{text}");
    text
}

fn example(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("examples").join(name).join("tank.json")
}

#[test]
fn what_the_good_file_means() {
    let file = read(GOOD);
    let course = &file.case.tank.courses[0];
    let kinds: Vec<LayerKind> = course.layers.iter().map(|l| l.kind).collect();
    assert_eq!(kinds, [LayerKind::Shell, LayerKind::Interlayer, LayerKind::Shell]);
    let Behaviour::Steel(steel) = course.layers[0].material.behaviour else { panic!("not steel") };
    // EN 1993-1-1, table 3.1.
    assert_eq!((steel.yield_strength, steel.ultimate_strength), (355e6, Some(490e6)));
    assert_eq!(steel.kinematic_share, 1.0);
    assert_eq!(course.layers[0].material.yield_strength, Some(355e6));
    let Behaviour::Interlayer(foam) = course.layers[1].material.behaviour else { panic!("not an interlayer") };
    assert_eq!((foam.e_normal, foam.shear_modulus, foam.tension), (10e6, 0.0, false));
    let Behaviour::Concrete(concrete) = course.layers[2].material.behaviour else { panic!("not concrete") };
    assert_eq!(concrete.law, ConcreteLaw::Cracked);
    assert_eq!((concrete.compressive_strength, concrete.tensile_strength), (38e6, 2.9e6));
    // 73 · 38^0.18, four digits by hand.
    let Softening::FractureEnergy(energy) = concrete.softening else { panic!("no fracture energy") };
    assert!((energy - 140.5).abs() < 0.05, "{energy}");
    let bars = &course.layers[2].reinforcement[0];
    assert_eq!(bars.direction, BarDirection::Hoop);
    assert!((bars.area - 15e-4).abs() < 1e-18 && (bars.depth - 0.21).abs() < 1e-12);
    assert!(matches!(bars.material.behaviour, Behaviour::Reinforcement(b) if b.yield_strength == 500e6));
    let options = &file.nonlinear;
    assert_eq!(options.elements, Some(WallElements { height: 24, circumference: 192 }));
    assert_eq!(options.contact, Contact::Opening);
    assert!(options.symmetry && options.self_weight && options.follower_pressure);
    // The equivalent wall is concrete by its modulus: 5 % of damping.
    assert_eq!(options.damping, Damping::ByGroup { wall: 0.05, sloshing: 0.005 });
    // Values from grades are in the list of defaults.
    for (path, text) in [
        ("materials.liner.youngs_modulus", "210"),
        ("materials.liner.behaviour.steel.ultimate_strength", "490"),
        ("materials.bars.yield_strength", "500"),
    ] {
        let line = file.echo.iter().find(|e| e.path == path);
        let line = line.unwrap_or_else(|| panic!("{path} is not echoed"));
        assert!(line.default && line.source.contains("grade"), "{line:?}");
        assert!(line.text.contains(text), "{line:?}");
    }
    assert!(file.remarks.is_empty(), "{:?}", file.remarks);
}

#[test]
fn fields_override_the_grade_and_elastic_switches_it_off() {
    let file = read(&changed(
        "{ \"grade\": \"S355\" }",
        "{ \"grade\": \"s 355\", \"yield_strength\": \"345 MPa\", \"behaviour\": { \"steel\": { \"kinematic_share\": 0 } } }",
    ));
    let material = &file.case.tank.courses[0].layers[0].material;
    assert_eq!(material.yield_strength, Some(345e6));
    assert!(
        matches!(material.behaviour, Behaviour::Steel(s) if s.yield_strength == 345e6 && s.kinematic_share == 0.0),
        "{material:?}"
    );
    let file = read(&changed("{ \"grade\": \"S355\" }", "{ \"grade\": \"S355\", \"behaviour\": \"elastic\" }"));
    assert!(file.case.tank.courses[0].layers[0].material.behaviour.is_elastic());
}

#[test]
fn strip_of_the_dissertation() {
    let file = tankcheck::input::read_tank(&example("06_sandwich_strip")).unwrap();
    let course = &file.case.tank.courses[0];
    // By hand: A = 0.006·210 + 0.3·34 = 11.46 GN/m, 12 D = 34·0.3³ + 210·0.006³ = 0.91804536 GN·m;
    // t = √(0.91804536/11.46) = 0.28303 m; the masses are 48 + 75 + 762 = 885 kg/m².
    assert!((course.thickness - 0.28303).abs() < 5e-6, "{}", course.thickness);
    assert!((course.material.youngs_modulus * course.thickness - 11.46e9).abs() < 1.0);
    assert!((course.material.density * course.thickness - 885.0).abs() < 1e-9);
    assert!((course.total_thickness() - 0.356).abs() < 1e-12);
    let depths: Vec<f64> = course.layers[2].reinforcement.iter().map(|b| b.depth).collect();
    assert!((depths[0] - 0.035).abs() < 1e-12 && (depths[1] - 0.265).abs() < 1e-12);
    let options = &file.nonlinear;
    assert_eq!(options.time_step, Some(0.0025));
    assert_eq!(options.damping, Damping::MassProportional { ratio: 0.022, at: MassProportionalAt::Frequency(2.39) });
    assert_eq!(options.integration.concrete, ThicknessRule::MidPoint(20));
    assert_eq!(options.elements, Some(WallElements { height: 40, circumference: 1 }));
    assert!(file.remarks.iter().any(|r| r.contains("almost undamped")));
}

/// The code procedures run on the equivalent wall and note it.
#[test]
fn check_shows_the_layers() {
    let folder = tempfile::tempdir().unwrap();
    for (name, say) in [
        ("07_steel_cylinder", ""),
        ("08_concrete_cylinder", "course 1: 200 mm concrete (concrete; hoop 15.0 cm²/m at 40.0 mm of bars"),
    ] {
        let out = folder.path().join(name);
        let output = Command::new(env!("CARGO_BIN_EXE_tankcheck"))
            .args(["check".as_ref(), example(name).as_os_str(), "--out".as_ref(), out.as_os_str()])
            .output()
            .unwrap();
        let text = String::from_utf8_lossy(&output.stdout);
        let code = output.status.code();
        assert!(matches!(code, Some(0 | 1 | 4)), "{name}: {code:?} {}", String::from_utf8_lossy(&output.stderr));
        has(&text, &[say]);
        let report = std::fs::read_to_string(out.join("report.html")).unwrap();
        let layered = !say.is_empty();
        assert_eq!(report.contains("Layers from inside to outside"), layered, "{name}");
        assert_eq!(report.contains("Layered wall: a homogeneous one"), layered, "{name}");
    }
}

#[test]
fn layers() {
    let interlayer = "{ \"kind\": \"interlayer\", \"thickness\": \"5 cm\", \"material\": \"foam\" },\n";
    let liner = "{ \"kind\": \"shell\", \"thickness\": \"6 mm\", \"material\": \"liner\" },\n";
    has(
        &spoiled(liner, ""),
        &[
            "tank.courses[0].layers[0]",
            "an interlayer must be between two shells",
            "without a shell inside",
            "shell, interlayer, shell",
        ],
    );
    has(
        &spoiled(interlayer, &format!("{interlayer}{interlayer}")),
        &["tank.courses[0].layers[1]", "an interlayer next to it"],
    );
    has(
        &spoiled(liner, &format!("{liner}{interlayer}{liner}")),
        &["tank.courses[0].layers", "2 interlayers", "at most one"],
    );
    has(
        &spoiled("{ \"height\": \"6 m\",", "{ \"height\": \"6 m\", \"thickness\": \"30 cm\","),
        &[
            "tank.courses[0].thickness",
            "thickness does not apply to a course with layers",
            "either thickness and material, or layers",
        ],
    );
    has(
        &spoiled("\"interlayer\", \"thickness\"", "\"core\", \"thickness\""),
        &["tank.courses[0].layers[1].kind", "\"shell\" or \"interlayer\""],
    );
    has(
        &spoiled("\"material\": \"foam\"", "\"material\": \"bars\""),
        &[
            "tank.courses[0].layers[1].material",
            "`bars` is reinforcement",
            "an elastic material or one with the behaviour interlayer",
        ],
    );
    has(
        &spoiled(
            "\"support\": \"anchored\",",
            "\"support\": \"anchored\", \"roof\": { \"mass\": \"1 t\", \"layers\": [] },",
        ),
        &["tank.roof.layers", "unknown key `layers`", "type, mass, height, rise, columns"],
    );
    has(&spoiled("\"25 cm\"", "\"25 kg\""), &["tank.courses[0].layers[2].thickness", "a mass", "found \"25 kg\""]);
}

#[test]
fn bars() {
    has(
        &spoiled("\"from_outer\": \"4 cm\"", "\"from_outer\": \"26 cm\""),
        &[
            "tank.courses[0].layers[2].reinforcement[0].from_outer",
            "outside their shell",
            "found \"26 cm\"",
            "less than 25.00 cm",
        ],
    );
    has(
        &spoiled("\"from_outer\": \"4 cm\"", "\"from_outer\": \"4 cm\", \"from_inner\": \"4 cm\""),
        &["reinforcement[0]", "either from_inner or from_outer"],
    );
    has(&spoiled("\"15 cm2/m\"", "\"15 cm2\""), &["reinforcement[0].area", "an area per length such as \"7.0 cm2/m\""]);
    has(
        &spoiled(
            "\"material\": \"liner\" },",
            "\"material\": \"liner\", \"reinforcement\": [\n{ \"direction\": \"vertical\", \"area\": \"1 cm2/m\", \
             \"from_inner\": \"3 mm\", \"material\": \"bars\" } ] },",
        ),
        &["tank.courses[0].layers[0].reinforcement", "bars in a layer of steel", "bars in shells of concrete only"],
    );
    has(
        &spoiled(
            "\"from_outer\": \"4 cm\", \"material\": \"bars\"",
            "\"from_outer\": \"4 cm\", \"material\": \"concrete\"",
        ),
        &["reinforcement[0].material", "`concrete` is concrete, which cannot be used for bars"],
    );
}

#[test]
fn impossible_materials() {
    has(
        &spoiled("\"2.9 MPa\"", "\"39 MPa\""),
        &[
            "materials.concrete.behaviour.concrete.tensile_strength",
            "weaker in tension",
            "found \"39 MPa\"",
            "less than the compressive strength, 38.00 MPa",
        ],
    );
    has(&spoiled("\"38 MPa\"", "\"38 kPa\""), &["compressive_strength", "too small", "greater than 1 MPa"]);
    has(
        &spoiled("\"2.9 MPa\"", "\"2.9 MPa\", \"softening_strain\": 1e-5"),
        &["softening_strain", "snap-back", "found 1e-5", "8.97e-5"],
    );
    has(
        &spoiled("\"2.9 MPa\"", "\"2.9 MPa\", \"brittle\": true, \"fracture_energy\": \"100 N/m\""),
        &["one softening", "one of fracture_energy, softening_strain and \"brittle\": true"],
    );
    let steel =
        |parameters: &str| format!("{{ \"grade\": \"S355\", \"behaviour\": {{ \"steel\": {{ {parameters} }} }} }}");
    let liner = "{ \"grade\": \"S355\" }";
    has(
        &spoiled(liner, &steel("\"tangent_modulus\": \"-1 GPa\"")),
        &["materials.liner.behaviour.steel.tangent_modulus", "must not be negative"],
    );
    has(
        &spoiled(liner, &steel("\"tangent_modulus\": \"210 GPa\"")),
        &["slope after yielding", "less than Young's modulus, 210.0 GPa"],
    );
    has(
        &spoiled(liner, &steel("\"tangent_modulus\": \"1 GPa\", \"hardening_modulus\": \"1 GPa\"")),
        &["two slopes", "either tangent_modulus or hardening_modulus"],
    );
    has(&spoiled(liner, &steel("\"ultimate_strength\": \"300 MPa\"")), &["not above the yield strength", "355.0 MPa"]);
    has(&spoiled(liner, &steel("\"kinematic_share\": 1.5")), &["kinematic_share", "at least 0, at most 1"]);
    has(
        &spoiled(
            liner,
            "{ \"youngs_modulus\": \"210 GPa\", \"poisson_ratio\": 0.3, \"density\": \"7850 kg/m3\", \"behaviour\": { \
             \"steel\": {} } }",
        ),
        &["the key `yield_strength` is missing", "materials.liner.behaviour.steel.yield_strength"],
    );
    has(
        &spoiled(
            "{ \"grade\": \"BSt500\" }",
            "{ \"grade\": \"BSt500\", \"behaviour\": { \"reinforcement\": { \"rupture_strain\": 1e-3 } } }",
        ),
        &["rupture_strain", "break before they yield", "2.38e-3"],
    );
}

#[test]
fn grades_and_behaviours() {
    has(
        &spoiled("\"S355\"", "\"S356\""),
        &["materials.liner.grade", "unknown grade `S356`", "did you mean \"S355\"?", "S235"],
    );
    has(
        &spoiled("{ \"grade\": \"S355\" }", "{ \"grade\": \"S355\", \"behaviour\": { \"concrete\": {} } }"),
        &["materials.liner.behaviour", "the grade S355 is steel", "\"elastic\" or steel"],
    );
    has(
        &spoiled("{ \"grade\": \"S355\" }", "{ \"grade\": \"S355\", \"behaviour\": \"steel\" }"),
        &["unknown behaviour `steel`", "write { \"steel\": { … } }"],
    );
    has(
        &spoiled("{ \"grade\": \"S355\" }", "{ \"grade\": \"S355\", \"behaviour\": {} }"),
        &["not exactly one behaviour"],
    );
    has(
        &spoiled("\"youngs_modulus\": \"33 GPa\",", ""),
        &["the key `youngs_modulus` is missing", "materials.concrete.youngs_modulus"],
    );
    has(
        &spoiled("\"e_normal\": \"10 MPa\"", "\"e_normal\": \"10 Mpa\""),
        &["e_normal", "unknown unit `Mpa`", "did you mean `MPa`?"],
    );
    has(
        &spoiled("\"density\": \"40 kg/m3\"", "\"density\": \"40 kg/m3\", \"poisson_ratio\": 0.3"),
        &["materials.foam.poisson_ratio", "poisson_ratio does not apply to an interlayer"],
    );
}

/// 3.0e9 kN/m² for 3.0e9 N/m²: a warning, no fault.
#[test]
fn stiff_interlayer_is_a_slip_of_the_unit() {
    let file = read(&changed("\"10 MPa\"", "\"3.0e9 kN/m2\""));
    let [remark] = file.remarks.as_slice() else { panic!("{:?}", file.remarks) };
    has(remark, &["materials.foam.behaviour.interlayer.e_normal", "3.0e9 kN/m2", "1e8 kN/m2"]);
    assert!(read(&changed("\"10 MPa\"", "\"3.0e9 N/m2\"")).remarks.is_empty());
}
