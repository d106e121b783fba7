//! Examples 8.1 to 8.3 of the dissertation with its meshes A to D in three dimensions, its damping, and with damping by kind.
//!
//! The document is made from the accelerograms it names; no parameter is fitted to a printed number. The element
//! heights of the dissertation's refined mesh (figure 8.2) are not printed; equal heights replace them.

mod broad;
mod model;
mod sheet;
mod slender;

use super::as_described;
use crate::{Error, Failure, Records};

/// Accelerograms of table 8.3: name, file.
const RECORDS: [(&str, &str); 3] = [
    ("El Centro", crate::records::EL_CENTRO),
    ("Parkfield", crate::records::PARKFIELD),
    ("Pacoima Dam", crate::records::PACOIMA),
];

/// The page, from the accelerograms of table 8.3.
///
/// Errors: a record that is not among `records`, a failure of an engine.
pub fn page(records: &Records) -> Result<String, Error> {
    document(records).map_err(|what| Error::Benchmark { benchmark: "dissertation".into(), what: what.to_string() })
}

fn document(records: &Records) -> Result<String, Failure> {
    let mut described = Vec::new();
    for (name, file) in RECORDS {
        let original = records.get(file)?.clone();
        let record = as_described(&original);
        described.push((name, original, record));
    }
    let mut text = String::from(HEAD);
    text.push_str(&broad::section(&described)?);
    text.push_str(&model::section()?);
    text.push_str(&slender::section(&described[0].2)?);
    text.push_str(REASONS);
    Ok(text)
}

const HEAD: &str = "# The dissertation's examples in three dimensions\n\n\
Made by `cargo run --release -p verification -- --slow --records FOLDER --write docs/verification`. Records: Caltech versions of El Centro NS \
(0.348 g) and Cholame-Shandon 5 N85E (0.434 g; table 8.3 prints 0.343 g, its peak is another or a slip), Pacoima Dam S16E \
(1.219 g in the version at hand, 1.170 g there), each scaled to 0.5 g and compressed by √3 as the dissertation describes. \
Meshes of its table 8.1 with equal element heights (its own refinement towards the base, figure 8.2, has no printed \
numbers), ρ = 10/9.81 t/m³. `printed` is the dissertation's simulation, `test` the measurement it cites, `converged` the \
harmonic engine.\n\n";

const REASONS: &str = "## Why the columns differ\n\n\
* **Printed against meshes, displacement and hoop force.** The printed values are 11 to 14 % low. The dissertation blames \
the coarse base; the shell of this engine on the same division does not show the deficit, because its membrane shear is \
taken at the centre. With the shear at all points (plain MITC4) 32 facets give the printed numbers within 1.5 %, 16 facets 14 % less: \
the printed numbers are membrane locking of 32 facets, the 16 elements of table 8.1 over half of the tank (shell-tank-static.md, table-8.2).\n\
* **C and D against A and B in the statics.** Equal elements of 9 cm at the clamped base are one and a half times √(R t): they \
overshoot by 12 % in displacement and hoop force; A and B happen to meet the converged value with 15 cm. The mesh rule of \
the engine starts with 2 cm.\n\
* **Hoop stress at 5 cm.** The printed 4.83 N/mm² is met at 10 cm (5.04 converged), not at 5 cm: the stress of a coarse \
element belongs to its middle.\n\
* **Moment at the base.** Printed values are those of the first integration point; here they are reactions of the edge.\n\
* **Meshes against converged.** 16 sectors leave a polygon error of ½ (π/16)² = 2 % in what the circumference carries \
and lower the liquid's mass; 12 to 20 equal elements over the height are three to five times as long as √(R t) = 61 mm, in \
which the edge bending lives. Mesh B with 18 sectors shows the first, C and D against A the second.\n\
* **Damping.** The printed pair gives the first mode of wall and liquid more than its critical damping and modes below \
2.14 rad/s a negative one; axial and bending stress then follow the ground nearly statically. With 2 % they are about \
twice as large.\n\
* **Wave of El Centro.** The printed wave belongs to the original record (input, see above). Parkfield and Pacoima Dam do \
not show this.\n\
* **Example 8.2.** Frequencies of the meshes lie 0.4 to 0.9 % above the converged ones (12 to 20 elements over the wall, of \
which only those below the surface carry the liquid), the waves within 0.4 %. The test lies 4 to 9 % below potential theory at \
every depth, which no mesh or damping explains. At 100 s the start has decayed to a quarter and still beats with the steady \
state of 3.8 mm: printed and measured 6 mm are peaks after the start.\n\
* **Example 8.3.** The wave of the printed table is that of the original record again (tank 8.1); the axial stress depends on \
the damping of the wall mode, which the printed pair makes nearly critical.\n";
