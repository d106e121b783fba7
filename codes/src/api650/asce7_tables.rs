//! Source:    ASCE 7-05 and 7-10 (the tables inside API 650 annex E) and ASCE 7-16, tables 11.4-1 and 11.4-2
//! Goal:      every cell of the site coefficients, the straight lines between the columns, the ends of each row
//! Expected:  the cells as printed; a dash is "site response analysis required" (ASCE 7-16 11.4.8, class F everywhere)
//! Tolerance: 1e-12, rounding of the interpolation

use super::ground_motion::{long_period_coefficient, short_period_coefficient};
use crate::procedure::CodeError;
use tank::case::SiteClass::{self, A, B, C, D, E, F};

type Coefficient = fn(u16, SiteClass, f64) -> Result<f64, CodeError>;

/// Asserts one row: its cells at the columns, halves between neighbours, constant below the first column and, where the
/// row is complete, above the last; an error as soon as the table asks for a study.
fn row(coefficient: Coefficient, asce7: u16, class: SiteClass, columns: &[f64], cells: &[f64]) {
    let what = |x: f64| format!("ASCE 7-{:02}, class {class:?}, at {x} g", asce7 % 100);
    let found = |x: f64| coefficient(asce7, class, x).unwrap_or_else(|e| panic!("{}: {e}", what(x)));
    let near = |x: f64, expected: f64| {
        let value = found(x);
        assert!((value - expected).abs() < 1e-12, "{}: {value} {expected}", what(x));
    };
    for (x, cell) in columns.iter().zip(cells) {
        near(*x, *cell);
    }
    for (x, cell) in columns.windows(2).zip(cells.windows(2)) {
        near(0.5 * (x[0] + x[1]), 0.5 * (cell[0] + cell[1]));
        near(0.75 * x[0] + 0.25 * x[1], 0.75 * cell[0] + 0.25 * cell[1]);
    }
    near(0.01, cells[0]);
    near(0.5 * columns[0], cells[0]);
    let last = columns[cells.len() - 1];
    if cells.len() == columns.len() {
        near(last + 0.01, cells[cells.len() - 1]);
        near(3.0, cells[cells.len() - 1]);
    } else {
        for x in [last + 1e-9, columns[cells.len()], 3.0] {
            let message = coefficient(asce7, class, x).expect_err(&what(x)).to_string();
            assert!(message.contains(&format!("= {last} g")), "{message}");
        }
    }
}

#[test]
fn asce_7_10_table_11_4_1_f_a() {
    let columns = [0.25, 0.50, 0.75, 1.00, 1.25];
    for (class, cells) in [
        (A, [0.8, 0.8, 0.8, 0.8, 0.8]),
        (B, [1.0, 1.0, 1.0, 1.0, 1.0]),
        (C, [1.2, 1.2, 1.1, 1.0, 1.0]),
        (D, [1.6, 1.4, 1.2, 1.1, 1.0]),
        (E, [2.5, 1.7, 1.2, 0.9, 0.9]),
    ] {
        row(short_period_coefficient, 2010, class, &columns, &cells);
    }
}

#[test]
fn asce_7_10_table_11_4_2_f_v() {
    let columns = [0.1, 0.2, 0.3, 0.4, 0.5];
    for (class, cells) in [
        (A, [0.8, 0.8, 0.8, 0.8, 0.8]),
        (B, [1.0, 1.0, 1.0, 1.0, 1.0]),
        (C, [1.7, 1.6, 1.5, 1.4, 1.3]),
        (D, [2.4, 2.0, 1.8, 1.6, 1.5]),
        (E, [3.5, 3.2, 2.8, 2.4, 2.4]),
    ] {
        row(long_period_coefficient, 2010, class, &columns, &cells);
    }
}

#[test]
fn asce_7_16_table_11_4_1_f_a() {
    let columns = [0.25, 0.50, 0.75, 1.00, 1.25, 1.50];
    for (class, cells) in [
        (A, &[0.8, 0.8, 0.8, 0.8, 0.8, 0.8][..]),
        (B, &[0.9, 0.9, 0.9, 0.9, 0.9, 0.9]),
        (C, &[1.3, 1.3, 1.2, 1.2, 1.2, 1.2]),
        (D, &[1.6, 1.4, 1.2, 1.1, 1.0, 1.0]),
        (E, &[2.4, 1.7, 1.3]),
    ] {
        row(short_period_coefficient, 2016, class, &columns, cells);
    }
}

#[test]
fn asce_7_16_table_11_4_2_f_v() {
    let columns = [0.1, 0.2, 0.3, 0.4, 0.5, 0.6];
    for (class, cells) in [
        (A, &[0.8, 0.8, 0.8, 0.8, 0.8, 0.8][..]),
        (B, &[0.8, 0.8, 0.8, 0.8, 0.8, 0.8]),
        (C, &[1.5, 1.5, 1.5, 1.5, 1.5, 1.4]),
        (D, &[2.4, 2.2, 2.0, 1.9, 1.8, 1.7]),
        (E, &[4.2]),
    ] {
        row(long_period_coefficient, 2016, class, &columns, cells);
    }
}

/// Neither edition has a coefficient for class F; the editions are 2010 and 2016.
#[test]
fn class_f_and_other_editions_have_no_coefficients() {
    for coefficient in [short_period_coefficient as Coefficient, long_period_coefficient] {
        for asce7 in [2010, 2016] {
            for x in [0.05, 0.5, 2.0] {
                let message = coefficient(asce7, F, x).unwrap_err().to_string();
                assert!(message.contains("site class F has no F_"), "{message}");
            }
        }
        for asce7 in [0, 2005, 2009, 2011, 2015, 2017, 2022] {
            let message = coefficient(asce7, B, 0.5).unwrap_err().to_string();
            assert!(message.contains("no such edition"), "{message}");
        }
    }
}
