//! What the page has below its own rows: the printed numbers of all pages, and those without a row.

use std::fmt::Write as _;

use crate::Entry;
use crate::manual::{cell, cells, printed, remark};

/// Printed numbers that no row judges: place, numbers, reason.
const NOT_COMPARED: [(&str, &str, &str); 10] = [
    (
        "8.1.3, table 8.2",
        "w_v = 0.0427 mm, m_v = 0.002 and −0.007 kNm/m",
        "one digit, between 0.002 and 0.004 and −0.002 and −0.008 by the heights of the lowest elements, which are not printed; \
      16 to 32 facets change w_v by 8 %",
    ),
    (
        "8.1.3, table 8.2",
        "n_v = −0.084 kN/m",
        "wall of γ = 27 kN/m³: 0.0815 by hand, also in ours; the printed one is 3 % more in all its columns",
    ),
    (
        "tables 8.4 to 8.6",
        "Parkfield and Pacoima Dam",
        "accelerograms that are not at hand with every run: `verification --slow --records FOLDER --write` puts all three \
      into dissertation-tanks.md",
    ),
    (
        "table 8.7",
        "bending stress at the base, 5.6 N/mm²",
        "stress at an integration point of the lowest element, whose height is not printed; 10.7 at the edge",
    ),
    (
        "table 8.9",
        "wave of the model tank by finite elements, 6.1 mm",
        "ours 5.7 mm on four meshes and converged (dissertation-tanks.md); its largest value is one of the start, and the length of \
      the printed run is not known",
    ),
    (
        "table 8.10",
        "finite elements: waves of 38 to 40 cm, axial stresses of 6.55 to 22.8 N/mm²",
        "waves are those of the record as recorded; the stresses are 1 to 10 % below ours \
      (dissertation-tanks.md), for which the coefficients of the damping are not printed",
    ),
    ("table 8.13", "top of the wall, vertical 0.05 mm", "weight alone shortens the wall by 0.003 mm; open"),
    ("8.4.2", "bars of 7.0 cm²/m", "design, not analysis: by tables of the time"),
    (
        "table 8.16",
        "deflections from 50 % on",
        "cracks: neighbouring scales are samples (docs/theory/table-8-16.md); the row of the kink judges them together",
    ),
    ("figures", "all but 5.17, 6.9 and 6.13", "pictures without numbers in the text at hand"),
];

/// The part of the page that gathers the rows of all pages.
pub(crate) fn gathered(rows: &[Entry]) -> String {
    let mut text = String::from(
        "\n## All printed numbers\n\nA row compares ours with its reference; where that is not the printed number, the reason stands at the end.\n\n\
         | id | what | printed | reference | computed | error | tolerance | page | run by | |\n|---|---|---:|---:|---:|---:|---:|---|---|---|\n",
    );
    for row in rows.iter().filter(|row| row.of_dissertation().is_some()) {
        let [id, what, reference, computed, error, tolerance, _] = cells(row).map(|text| cell(&text));
        let (page, run, remark) = (&row.page, row.pace.command(), remark(row));
        let printed = printed(row);
        let _ = writeln!(
            text,
            "| {id} | {what} | {printed} | {reference} | {computed} | {error} | {tolerance} | [{page}]({page}.md) | {run} | {remark} |"
        );
    }
    text.push_str("\n## Without a row\n\n| place | printed | why no row judges it |\n|---|---|---|\n");
    for (place, numbers, reason) in NOT_COMPARED {
        let _ = writeln!(text, "| {place} | {numbers} | {reason} |");
    }
    text
}
