//! Lines of sheets: order, blocks of given values, sources.

use super::*;

fn line(number: usize, symbol: &str, name: &str, value: &str) -> LineView {
    LineView {
        number,
        name: name.into(),
        symbol: symbol.into(),
        formula: String::new(),
        substitution: String::new(),
        look_up: String::new(),
        value: value.into(),
        unit: "mm",
        clause: "A.9".into(),
        short: true,
    }
}

/// Two lines for one symbol: the formula takes the nearer one. A line that leads nowhere is not part of the check.
#[test]
fn a_check_has_the_lines_that_lead_to_it() {
    let step = |symbol: &str, formula: &str, value: f64| Step {
        symbol: symbol.into(),
        formula: formula.into(),
        value,
        ..Step::default()
    };
    let steps = [
        step("t", "", 1.0),
        step("x", "", 7.0),
        step("t", "", 2.0),
        step("N", "3·t", 6.0),
        step("s", "N/t", 3.0),
        step("R", "2·t", 4.0),
        step("u", "s + R", 7.5),
    ];
    let check = Check::new("c", "c", 3.0, 4.0, tank::units::Dimension::Force, "", "");
    assert_eq!(behind(&steps, &check).into_iter().collect::<Vec<_>>(), [2, 3, 4, 5]);
}

#[test]
fn lines_for_several_grounds_are_one_and_no_value_is_lost() {
    let grounds = ["33", "100", "300"];
    let mut lines = Vec::new();
    for (i, ground) in grounds.iter().enumerate() {
        lines.push(line(2 * i + 1, "w", &format!("uplift on {ground} MN/m³"), &format!("{i}.5")));
        lines.push(line(2 * i + 2, "L", &format!("length on {ground} MN/m³"), &format!("{i}.7")));
    }
    lines.push(line(7, "w", "another uplift", "9"));
    let found = merged(lines);
    let texts: Vec<(&str, &str)> = found.iter().map(|l| (l.name.as_str(), l.value.as_str())).collect();
    assert_eq!(
        texts,
        [
            ("uplift on 33; 100; 300 MN/m³", "0.5; 1.5; 2.5"),
            ("length on 33; 100; 300 MN/m³", "0.7; 1.7; 2.7"),
            ("another uplift", "9"),
        ]
    );
}

/// Given values share a line as long as they are of one clause; a formula stands alone.
#[test]
fn given_values_of_one_clause_are_one_block() {
    let of = |number: usize, clause: &str, short: bool| LineView {
        clause: clause.into(),
        short,
        ..line(number, &format!("x_{number}"), "a value", "1")
    };
    let lines = || {
        vec![of(1, "input", true), of(2, "input", true), of(3, "A.9", true), of(4, "A.9", false), of(5, "A.9", true)]
    };
    let numbers = |part: &Part| -> Vec<Vec<usize>> {
        part.blocks.iter().map(|b| b.lines.iter().map(|l| l.number).collect()).collect()
    };
    let clauses = |part: &Part| -> Vec<String> { part.blocks.iter().map(|b| b.clause.clone()).collect() };
    let standard = part("Uplift".into(), lines());
    assert_eq!(numbers(&standard), [vec![1, 2], vec![3], vec![4], vec![5]]);
    assert_eq!(
        (standard.clause.as_str(), clauses(&standard)),
        ("A.9", ["input", "", "", ""].map(str::to_owned).into())
    );
    let full = whole("Uplift".into(), lines());
    assert_eq!(numbers(&full), [vec![1], vec![2], vec![3], vec![4], vec![5]]);
    assert_eq!(
        (full.clause.as_str(), clauses(&full)),
        ("", ["input", "input", "A.9", "A.9", "A.9"].map(str::to_owned).into())
    );
}

/// A source that several values have in common stands behind them, once.
#[test]
fn a_common_source_is_named_once() {
    let of = |number: usize, source: &str| LineView {
        look_up: source.into(),
        ..line(number, &format!("x_{number}"), "a value", "1")
    };
    let same = part("Uplift".into(), vec![of(1, "table A.2"), of(2, "table A.2")]);
    assert_eq!(same.blocks[0].look_up, "table A.2");
    assert!(same.blocks[0].lines.iter().all(|l| l.look_up.is_empty()));
    let apart = part("Uplift".into(), vec![of(1, "table A.2"), of(2, "table A.3")]);
    assert_eq!(apart.blocks[0].look_up, "");
    assert_eq!(apart.blocks[0].lines[1].look_up, "table A.3");
}

#[test]
fn two_lines_with_one_symbol_stay_two() {
    let lines = vec![line(1, "S", "first mode", "1"), line(2, "S", "second mode", "2")];
    assert_eq!(merged(lines).len(), 2);
}
