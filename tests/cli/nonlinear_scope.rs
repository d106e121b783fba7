//! Input outside the scope of the nonlinear engine is rejected with its place.

use engines::nonlinear::push;
use engines::{Task, engine};
use results::EngineId;
use tank::refusal::Refusal;
use tankcheck::job;

use super::bad_tank::has;
use super::nonlinear_input::{GOOD, changed, read};

/// The refusals for a file that is valid otherwise; one message for each cause.
fn refused(text: &str, refuses: fn(&Task<'_>) -> Vec<Refusal>) -> String {
    let file = read(text);
    let faults = job::refused(&file, refuses);
    let text = faults.render(&file.source, false);
    assert!(text.contains("error: 1 fault in tank.json; nothing was computed"), "{text}");
    assert!(text.contains("tank.json:"), "{text}");
    text
}

fn history(task: &Task<'_>) -> Vec<Refusal> {
    engine(EngineId::Nonlinear).refuses(task)
}

fn unfit(from: &str, to: &str) -> String {
    refused(&changed(from, to), history)
}

/// The good file as a strip of concrete.
fn strip() -> String {
    GOOD.replace("\"shape\": \"cylinder\"", "\"shape\": \"rectangle\"")
        .replace("\"radius\": \"10 m\"", "\"length\": \"20 m\", \"strip\": true")
        .replace(", \"circumference\": 192", "")
}

#[test]
fn what_fits() {
    for text in [GOOD, &strip()] {
        let file = read(text);
        let faults = job::refused(&file, history);
        assert!(faults.is_empty(), "{}", faults.render(&file.source, false));
    }
}

#[test]
fn elements_on_which_a_crack_snaps_back() {
    // 0.98 · 33e9 · 140.5/2.9e6² = 0.540 m. Rows are finer towards the base, so that more than 6/0.54 are needed; 62.8 m
    // around need 117, half of a tank an even number.
    has(
        &unfit("\"height\": 24", "\"height\": 8"),
        &[
            "analysis.nonlinear.elements.height",
            "the softening of `concrete` is too steep for elements of",
            "found 8",
            "elements of at most 540 mm (0.98 E·G_f/f_t²)",
            "or more",
            "crack_spacing of at most 540 mm",
        ],
    );
    has(
        &unfit("\"circumference\": 192", "\"circumference\": 96"),
        &["analysis.nonlinear.elements.circumference", "654 mm", "118 or more"],
    );
    // Bars that set the crack spacing remove the fault.
    let coarse = changed("\"height\": 24", "\"height\": 8");
    let spaced = coarse.replace("\"2.9 MPa\"", "\"2.9 MPa\", \"crack_spacing\": \"15 cm\"");
    assert!(job::refused(&read(&spaced), history).is_empty());
    // The message for concrete gives the engine's own mesh: 72 sectors of 873 mm.
    has(
        &unfit("\"elements\": { \"height\": 24, \"circumference\": 192 }, ", ""),
        &[
            "materials.concrete.behaviour.concrete",
            "elements of 873 mm",
            "at most 540 mm",
            "set analysis.nonlinear.elements, or a crack_spacing",
        ],
    );
}

/// 1 N/m: 0.98 · 33e9 · 1/2.9e6² = 3.8 mm, finer than 4000 elements of 15.7 mm; 4.08 N/m is enough with them.
#[test]
fn softening_that_no_mesh_resolves() {
    let file = read(&changed("\"2.9 MPa\"", "\"2.9 MPa\", \"fracture_energy\": \"1 N/m\""));
    let text = job::refused(&file, history).render(&file.source, false);
    has(
        &text,
        &[
            "elements.circumference",
            "elements of at most 3.84 mm",
            "more than the limit of 4000",
            "a crack_spacing of at most 3.84 mm; or a fracture_energy of at least 4.09 N/m, with 4000 elements",
            "elements.height",
            "2 faults",
        ],
    );
}

#[test]
fn laws_of_the_other_engine() {
    let law = |name: &str| format!("\"2.9 MPa\", \"law\": \"{name}\"");
    has(
        &unfit("\"2.9 MPa\"", &law("uniaxial")),
        &[
            "materials.concrete.behaviour.concrete.law",
            "found \"uniaxial\"",
            "\"cracked\", \"plastic-fracturing\", \"two-surface\" or \"fracturing\"",
        ],
    );
    has(
        &refused(&strip().replace("\"2.9 MPa\"", &law("plastic-fracturing")), history),
        &["materials.concrete.behaviour.concrete.law", "found \"plastic-fracturing\"", "\"cracked\" or \"uniaxial\""],
    );
    // 2 · 250 · 73 · 38^0.18 · 33e9/38e6² = 1.60 m: it crushes over more than it may crack.
    let coarse = changed("\"circumference\": 192", "\"circumference\": 36");
    has(
        &refused(&coarse.replace("\"2.9 MPa\"", &law("plastic-fracturing")), history),
        &[
            "elements.circumference",
            "the crushing of `concrete` is too brittle for elements of 1.75 m",
            "at most 1.60 m: 40 or more",
        ],
    );
}

/// In the plane of the wall an interlayer is stiff between shells, of a cylinder or of a strip; a wall of fibres has none.
#[test]
fn an_interlayer_with_stiffness_in_its_plane() {
    let foam = "\"e_normal\": \"10 MPa\", \"tension\": false";
    let elastomer = "\"e_normal\": \"10 MPa\", \"e_parallel\": \"10 MPa\", \"shear_modulus\": \"5 MPa\"";
    let shells = strip().replace("\"nonlinear\": {", "\"nonlinear\": { \"wall\": \"shell\",").replace(foam, elastomer);
    for text in [changed(foam, elastomer), shells] {
        let file = read(&text);
        let faults = job::refused(&file, history);
        assert!(faults.is_empty(), "{}", faults.render(&file.source, false));
    }
    has(
        &refused(&strip().replace(foam, elastomer), history),
        &["materials.foam.behaviour.interlayer", "e_parallel 10.0 MPa", "wall to \"shell\"", "a wall of fibres"],
    );
}

#[test]
fn walls_that_are_not_modelled() {
    let foam = "\"e_normal\": \"10 MPa\", \"tension\": false";
    has(
        &unfit(foam, "\"e_normal\": \"10 MPa\", \"shear_modulus\": \"1 MPa\", \"tension\": false"),
        &[
            "materials.foam.behaviour.interlayer",
            "e_normal 10.0 MPa, e_parallel 0 Pa, shear_modulus 1.00 MPa, without tension",
            "e_normal alone",
        ],
    );
    has(
        &unfit(foam, "\"e_normal\": \"10 MPa\", \"e_parallel\": \"2 MPa\", \"tension\": false"),
        &["materials.foam.behaviour.interlayer", "e_parallel 2.00 MPa", "shear_modulus and e_parallel with tension"],
    );
    let course = "{ \"height\": \"6 m\",";
    let second = "{ \"height\": \"1 m\", \"thickness\": \"20 cm\", \"material\": \"concrete\" } ]";
    let text = GOOD.replacen("        ] }\n    ]", &format!("        ] }},\n {second}"), 1);
    assert!(text.contains(second) && text.contains(course));
    has(
        &refused(&text, history),
        &["tank.courses[1]", "equally far apart in all courses", "found one shell", "two shells, 178 mm apart"],
    );
    // Two leaves that both bend.
    let twin = strip().replace("\"6 mm\", \"material\": \"liner\"", "\"25 cm\", \"material\": \"concrete\"");
    let twin = twin.replace("    \"liner\": { \"grade\": \"S355\" },\n", "");
    has(
        &refused(&twin, history),
        &["tank.courses[0].layers", "one bending leaf", "250 mm concrete, 50.0 mm foam, 250 mm concrete"],
    );
    let roof = strip().replace("\"support\":", "\"roof\": { \"mass\": \"1 t\" }, \"support\":");
    has(&refused(&roof, history), &["tank.roof.mass", "does not support a roof mass", "remove `roof`"]);
}

#[test]
fn tanks_of_another_kind() {
    has(&refused(&strip(), push::refuses), &["tank.shape", "found \"rectangle\"", "\"cylinder\""]);
    has(&refused(GOOD, push::refuses), &["tank.courses[0].layers", "6.00 mm liner, 50.0 mm foam, 250 mm concrete"]);
    let four = strip().replace("\"strip\": true", "\"breadth\": \"8 m\"");
    let four = four.replace("\"elements\": { \"height\": 24 }, ", "");
    has(&refused(&four, history), &["tank.shape", "four walls"]);
}
