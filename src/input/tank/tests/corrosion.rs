//! The corrosion allowance of the whole tank is that of each plate which states none of its own.

use super::{read, refused, small};

fn plates(common: &str, course: &str, bottom: &str) -> String {
    small("")
        .replace(
            "\"anchored\",",
            &format!(
                "\"anchored\", {common} \"bottom\": {{ \"thickness\": \"6 mm\", \"material\": \"steel\"{bottom} }},"
            ),
        )
        .replace("\"10 mm\"", &format!("\"10 mm\"{course}"))
}

#[test]
fn it_counts_where_a_plate_states_none() {
    let common = "\"corrosion_allowance\": \"2 mm\",";
    let own = ", \"corrosion_allowance\": \"2 mm\"";
    assert_eq!(read(&plates(common, "", "")).case.tank, read(&plates("", own, own)).case.tank);
    let mixed =
        read(&plates(common, ", \"measured_thickness\": \"9 mm\"", ", \"corrosion_allowance\": \"0 mm\"")).case.tank;
    let corrosion = (mixed.courses[0].corrosion, mixed.bottom.map(|bottom| bottom.corrosion));
    assert!((corrosion.0 - 1e-3).abs() < 1e-15 && corrosion.1 == Some(0.0), "{corrosion:?}");
}

#[test]
fn one_that_takes_a_plate_is_one_fault() {
    let text = refused(&plates("\"corrosion_allowance\": \"20 mm\",", "", ""));
    assert!(text.contains("takes the whole plate") && text.contains("1 fault in"), "{text}");
    assert!(text.contains("less than 10.00 mm"), "{text}");
}
