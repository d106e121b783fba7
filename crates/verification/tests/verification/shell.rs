//! Shells. The rows on fine meshes run with `tankcheck verify --slow`.

use verification::{Row, shell};

fn print(rows: &[Row]) {
    for row in rows {
        println!("{}", row.line());
        for (n, error) in &row.convergence {
            println!("      {n:>6} {error:+.3e}");
        }
    }
}

#[test]
fn shell_rows_hold() {
    let rows = shell::shell().unwrap();
    print(&rows);
    super::assert_rows(&rows);
}

#[test]
fn large_shell_rows_hold() {
    let rows = shell::shell_large().unwrap();
    print(&rows);
    super::assert_rows(&rows);
}

#[test]
fn concrete_beam_rows_hold() {
    let rows = shell::concrete_beams().unwrap();
    print(&rows);
    super::assert_rows(&rows);
}
