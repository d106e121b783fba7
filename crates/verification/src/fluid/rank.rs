//! Table 5.3: how many modes of one element have volume energy, rotation energy, or none.
//!
//! The eigenvectors of K + R of the unit element (K = 2.06·10⁶, K_rot = 100, kPa) are classified by their energies. The
//! counts are ranks: they do not depend on K_rot. The dissertation prints "20 and 3" for variant 4 after its calibration
//! of K_rot; that counts small eigenvalues as zero. The numbers in brackets, 9 and 14, are the ranks.

use nalgebra::DMatrix;

use super::{BULK_MODULUS, Source};
use crate::elements::Fluid4;
use crate::{Answer, Benchmark, Failure, Part, Reference};
use fem::chart::Chart;
use fem::element::{Element, Fluid8, LiquidProperties, RotationPart, VolumePart, reference_stiffness};
use fem::mesh::{Face, Hexahedron};
use fem::shape::{hex8, quad4};

/// The page.
pub(crate) const BENCHMARK: Benchmark = Benchmark {
    id: "fluid-rank",
    title: "Rank of the displacement fluid elements",
    model: "Unit square and unit cube of `fluid4` and `fluid8`, K = 2.06·10⁶ kPa, K_rot = 100 kPa: eigenvectors \
            of the stiffness classified by volume energy, rotation energy or neither, for the four variants of \
            table 5.3.",
    ids: &[("table-5.3", "rank of the element matrices, dissertation table 5.3")],
    parts: &[Part::Fast(rank_table)],
};

const PENALTY: f64 = 100.0;

const SOURCE: Source =
    Source { source: "dissertation, table 5.3 (variant 4: the bracketed ranks)", kind: Reference::Dissertation };

/// Numbers of modes of one element.
struct Counts {
    deformation: usize,
    rigid: usize,
    rotation: usize,
    /// Eigenvalues of the rotation part, descending.
    rotations: Vec<f64>,
}

fn dense(element: &impl Element) -> Result<DMatrix<f64>, Failure> {
    let k = reference_stiffness(element)?;
    Ok(DMatrix::from_column_slice(k.n, k.n, &k.data))
}

/// Classifies the eigenvectors of `whole` = volume part + rotation part by the larger of the two energies.
fn classify(whole: DMatrix<f64>, volume: &DMatrix<f64>) -> Counts {
    let size = whole.nrows();
    let rotation = &whole - volume;
    let eigen = whole.symmetric_eigen();
    // Rounding of eigenvalues of 10⁶ leaves 10⁻⁹; the smallest that is not zero is above 1.
    let zero = 1e-6;
    let (mut deformation, mut rotations) = (0, 0);
    for (value, vector) in eigen.eigenvalues.iter().zip(eigen.eigenvectors.column_iter()) {
        if *value > zero {
            let (volume, rotation) = (vector.dot(&(volume * vector)), vector.dot(&(&rotation * vector)));
            if volume > rotation {
                deformation += 1;
            } else {
                rotations += 1;
            }
        }
    }
    let mut values: Vec<f64> = rotation.symmetric_eigen().eigenvalues.iter().copied().collect();
    values.sort_by(|a, b| b.total_cmp(a));
    values.truncate(rotations);
    Counts { deformation, rigid: size - deformation - rotations, rotation: rotations, rotations: values }
}

fn liquid(volume: VolumePart, rotation: RotationPart) -> LiquidProperties {
    LiquidProperties { density: 1.0, bulk_modulus: BULK_MODULUS, volume, rotation }
}

fn spatial(chart: Chart, volume: VolumePart, rotation: RotationPart) -> Result<Counts, Failure> {
    let cell = Hexahedron {
        nodes: [0, 1, 2, 3, 4, 5, 6, 7],
        // Unit cube; in the cylindrical chart r runs from 1 to 2.
        chart: hex8::CORNERS.map(|c| [1.5 + 0.5 * c[0], 0.5 * c[1], 0.5 * c[2]]),
    };
    let make = |rotation| Fluid8::new(&cell, chart, liquid(volume, rotation));
    Ok(classify(dense(&make(rotation)?)?, &dense(&make(RotationPart::None)?)?))
}

fn plane(volume: VolumePart, rotation: RotationPart) -> Result<Counts, Failure> {
    let face = Face { nodes: [0, 1, 2, 3], chart: quad4::CORNERS.map(|c| [0.5 * c[0], 0.0, 0.5 * c[1]]) };
    let make = |rotation| Fluid4::new(&face, Chart::Cartesian, 1.0, liquid(volume, rotation));
    Ok(classify(dense(&make(rotation)?)?, &dense(&make(RotationPart::None)?)?))
}

/// Table 5.3 for the four variants, 3-D and 2-D; the same for the element used here; eigenvalues of the rotation part.
///
/// Errors: none to be expected.
pub(crate) fn rank_table() -> Answer {
    // More than 80 lines: half of it is the table of references.
    use RotationPart::{Full, None, OnePoint};
    let split = RotationPart::Split { centre: PENALTY, rest: 0.01 * PENALTY };
    let mean = VolumePart::MeanDilatation;
    // (name, parts, 3-D: deformation, rigid, rotation, 2-D: the same)
    let variants = [
        ("variant 1", VolumePart::Full, None, [7, 17, 0], [3, 5, 0]),
        ("variant 2", VolumePart::OnePoint, None, [1, 23, 0], [1, 7, 0]),
        ("variant 3", VolumePart::OnePoint, OnePoint(PENALTY), [1, 20, 3], [1, 6, 1]),
        ("variant 4", VolumePart::OnePoint, Full(PENALTY), [1, 9, 14], [1, 4, 3]),
    ];
    let mut rows = Vec::new();
    let mut push = |against: &Source, name: &str, counts: &Counts, expected: [usize; 3]| {
        let found = [counts.deformation, counts.rigid, counts.rotation];
        for (kind, (expected, found)) in
            ["deformation", "rigid", "rotation"].iter().zip(expected.into_iter().zip(found))
        {
            let pair = (expected as f64, found as f64);
            rows.push(against.row("table-5.3", format!("{name}: {kind} modes"), pair, 0.0, "modes"));
        }
    };
    for (name, volume, rotation, in_space, in_plane) in variants {
        push(&SOURCE, &format!("{name}, 3-D"), &spatial(Chart::Cartesian, volume, rotation)?, in_space);
        push(&SOURCE, &format!("{name}, 2-D"), &plane(volume, rotation)?, in_plane);
    }
    // By hand: mean dilatation has rank one, and the split penalty the rank of the full one.
    let own = Source { source: "rank of one mean and of the full rotation part", kind: Reference::ClosedForm };
    push(&own, "mean dilatation, split penalty, 3-D", &spatial(Chart::Cartesian, mean, split)?, [1, 9, 14]);
    push(&own, "mean dilatation, split penalty, 2-D", &plane(mean, split)?, [1, 4, 3]);
    // In the cylindrical chart u_r/r adds one volume mode to the seven.
    push(&own, "variant 1, 3-D, cylindrical chart", &spatial(Chart::Cylindrical, VolumePart::Full, None)?, [8, 16, 0]);

    // K_rot/2 ∫ |curl u|² of the trilinear functions of the unit cube, by hand: K_rot/18, K_rot/12, K_rot/4, K_rot/2.
    let values = spatial(Chart::Cartesian, VolumePart::OnePoint, Full(PENALTY))?.rotations;
    let expected = [(50.0, 3), (25.0, 2), (100.0 / 12.0, 6), (100.0 / 18.0, 3)];
    let eigenvalues = expected.iter().flat_map(|&(value, times)| vec![value; times]);
    for (number, (expected, found)) in eigenvalues.zip(values).enumerate() {
        let what = format!("rotation part of the unit cube, eigenvalue {}", number + 1);
        rows.push(own.row("table-5.3", what, (expected, found), 1e-9, "kN/m"));
    }
    let values = plane(VolumePart::OnePoint, Full(PENALTY))?.rotations;
    for (number, (expected, found)) in [100.0, 100.0 / 6.0, 100.0 / 6.0].into_iter().zip(values).enumerate() {
        let what = format!("rotation part of the unit square, eigenvalue {}", number + 1);
        rows.push(own.row("table-5.3", what, (expected, found), 1e-9, "kN/m"));
    }
    Ok(rows)
}
