//! The element of the dissertation in the product: tank 8.1 with `analysis.solid.rotation_penalty`, on mesh C of table 8.1 around the whole tank.

use engines::Options;
use engines::solid::{self, Liquid, MeshSize, SolidOptions};
use fem::progress::Silent;
use tank::reference::broad;

use crate::fluid::cylinder::printed_element;
use crate::tanks::G;
use crate::{Answer, Reference, Row};

/// First sloshing frequencies of cos θ and cos 2θ with K_rot = 100 kPa.
///
/// Tolerance: the elastic wall, which lowers them by less than 0.1 %, and the rows of the wall's mesh above the surface.
///
/// Errors: a failure of the engine.
pub(super) fn rows() -> Answer {
    let case = broad(1e4 / G);
    let form = SolidOptions {
        liquid: Liquid::Displacement,
        rotation_penalty: Some(100e3),
        mesh: Some(MeshSize { radial: 12, sectors: 16, vertical: 23 }),
        ..SolidOptions::default()
    };
    let found = solid::modes(&case, &Options::default(), &form, 4, &Silent)?;
    let mut rows = Vec::new();
    for (harmonic, printed) in [(1, 3.02), (2, 4.13)] {
        let mode = found.iter().find(|m| m.harmonic == harmonic && m.kind == "sloshing");
        let reference =
            (printed_element(harmonic)?, "the same elements between rigid walls", Reference::SecondFormulation);
        let what = format!(
            "tank 8.1 by the product, K_rot = 100 kPa, one-point volume and full rotation part, m = {harmonic}: ω₁"
        );
        let row = Row::new("element-8.1", what, reference, mode.map_or(f64::NAN, |m| m.omega), (5e-3, "rad/s"));
        rows.push(
            row.printed(
                printed,
                "met by the rotation part at one point (K5), not by the full one that the text states",
            ),
        );
    }
    Ok(rows)
}
