//! Patch tests of Bilder 5.14 to 5.19: K = 2.06·10⁶ kPa, K_rot = 206 kPa, stresses of −10 kPa prescribed through the
//! displacements of the outer nodes.
//!
//! The dissertation does not print its meshes. Plane and spatial distorted patches are those of MacNeal & Harder 1985
//! (five quadrilaterals, seven hexahedra); the regular one has 3 × 3 × 1 cells with an inner plane of nodes moved
//! nowhere. The spatial patch *fails* with one-point volume quadrature: ∂N/∂x · det J is not linear in a hexahedron that
//! is not a parallelepiped, so the nodal forces of a constant pressure do not cancel. With the mean dilatation they do.

use std::sync::Arc;

use super::{BULK_MODULUS, Source};
use crate::elements::Fluid4;
use crate::{Answer, Benchmark, Failure, Part, Reference};
use fem::assembly::Assembler;
use fem::chart::Chart;
use fem::element::{Element, Fluid8, Inspect, LiquidProperties, RotationPart, VolumePart};
use fem::linalg::{Kind, Ordering, Symbolic};
use fem::mesh::{Face, Hexahedron, Rectangle};
use fem::model::{Builder, Model};

/// The page.
pub(crate) const BENCHMARK: Benchmark = Benchmark {
    id: "fluid-patch",
    title: "Patch tests of the displacement fluid elements",
    model: "Regular and distorted patches (MacNeal & Harder 1985), K = 2.06·10⁶ kPa, K_rot = 206 kPa, pressure \
            of 10 kPa prescribed through the displacements of the outer nodes; Cartesian and cylindrical chart.",
    ids: &[
        ("figure-5.15", "plane regular patch, dissertation figure 5.15"),
        ("figure-5.17", "distorted patch, dissertation figure 5.17"),
        ("figure-5.19", "regular patch in space, dissertation figure 5.19"),
        ("K2", "distorted patches with mean dilatation, both charts"),
    ],
    parts: &[Part::Fast(patch_tests)],
};

const PENALTY: f64 = 206.0;

const STRESS: f64 = -10.0;

const SOURCE: Source = Source { source: "constant state, exact", kind: Reference::ClosedForm };

/// Inner corners of the seven hexahedra of MacNeal & Harder 1985 (their figure 2), nodes 1 to 8.
const INNER: [[f64; 3]; 8] = [
    [0.249, 0.342, 0.192],
    [0.826, 0.288, 0.288],
    [0.850, 0.649, 0.263],
    [0.273, 0.750, 0.230],
    [0.320, 0.186, 0.643],
    [0.677, 0.305, 0.683],
    [0.788, 0.693, 0.644],
    [0.165, 0.745, 0.702],
];

/// The unit cube around them.
const OUTER: [[f64; 3]; 8] = [
    [0.0, 0.0, 0.0],
    [1.0, 0.0, 0.0],
    [1.0, 1.0, 0.0],
    [0.0, 1.0, 0.0],
    [0.0, 0.0, 1.0],
    [1.0, 0.0, 1.0],
    [1.0, 1.0, 1.0],
    [0.0, 1.0, 1.0],
];

/// Plane patch of MacNeal & Harder 1985 (their figure 1), 0.24 × 0.12: the first four nodes are outer.
const PLANE: [[f64; 2]; 8] =
    [[0.0, 0.0], [0.24, 0.0], [0.24, 0.12], [0.0, 0.12], [0.04, 0.02], [0.18, 0.03], [0.16, 0.08], [0.08, 0.08]];

const PLANE_CELLS: [[usize; 4]; 5] = [[0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7], [4, 5, 6, 7]];

/// Nodes of a patch: chart coordinates, and whether they are outer.
struct Patch {
    places: Vec<[f64; 3]>,
    cells: Vec<[usize; 8]>,
    outer: usize,
    chart: Chart,
}

/// Nodes 0 … 7 outer, 8 … 15 inner, places given by `map` of the cube.
fn seven(chart: Chart, map: impl Fn([f64; 3]) -> [f64; 3]) -> Patch {
    // Each face of the inner hexahedron, joined to the outer face opposite; the last cell is the inner one.
    let sides = [[0, 1, 2, 3], [4, 5, 6, 7], [0, 1, 5, 4], [3, 2, 6, 7], [0, 3, 7, 4], [1, 2, 6, 5]];
    // Orientation: the first four corners must turn left seen from the other four.
    let outer_first = [true, false, false, true, true, false];
    let mut cells: Vec<[usize; 8]> = sides
        .iter()
        .zip(outer_first)
        .map(|(s, outer)| {
            let (near, far) = if outer { (0, 8) } else { (8, 0) };
            std::array::from_fn(|k| s[k % 4] + if k < 4 { near } else { far })
        })
        .collect();
    cells.push(std::array::from_fn(|k| 8 + k));
    Patch { places: OUTER.iter().chain(&INNER).map(|&p| map(p)).collect(), cells, outer: 8, chart }
}

impl Patch {
    fn model(&self, liquid: LiquidProperties) -> Result<(Model, Vec<Fluid8>), Failure> {
        let mut builder = Builder::new();
        for &x in &self.places {
            builder.node(self.chart.position(x));
        }
        let mut elements = Vec::new();
        for nodes in &self.cells {
            let cell = Hexahedron { nodes: *nodes, chart: nodes.map(|n| self.places[n]) };
            elements.push(Fluid8::new(&cell, self.chart, liquid)?);
        }
        elements.iter().for_each(|e| {
            builder.element("liquid", e.clone());
        });
        Ok((builder.build()?, elements))
    }
}

/// Displacements of all unknowns when those of the nodes for which `outer` holds follow `field` and the rest is free.
fn solve(
    model: &Model,
    outer: impl Fn(usize) -> bool,
    field: impl Fn([f64; 3]) -> [f64; 3],
) -> Result<Vec<f64>, Failure> {
    let assembler = Assembler::new(model);
    let k = assembler.stiffness(model)?;
    let mut u = model.vector(|node| {
        let [x, y, z] = field(model.nodes()[node]);
        [x, y, z, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]
    });
    let free: Vec<usize> = (0..u.len()).filter(|&e| !outer(model.dofs().unknown(e).0)).collect();
    free.iter().for_each(|&e| u[e] = 0.0);
    let load = k.times(&u);
    let inner = k.submatrix(&free);
    let symbolic = Arc::new(Symbolic::new(inner.pattern.clone(), &Ordering::MinimumDegree)?);
    let right: Vec<f64> = free.iter().map(|&e| -load[e]).collect();
    let found = symbolic.factor(&inner, Kind::Definite)?.solve_vector(&right)?;
    free.iter().zip(found).for_each(|(&e, v)| u[e] = v);
    Ok(u)
}

/// Local displacements of an element.
fn gather(model: &Model, element: &dyn Element, u: &[f64]) -> Vec<f64> {
    let mut out = Vec::new();
    for (a, &node) in element.nodes().iter().enumerate() {
        let all = model.at_node(u, node);
        out.extend(element.dofs(a).iter().map(|d| all[d.index()]));
    }
    out
}

fn product(row: &[f64], u: &[f64]) -> f64 {
    row.iter().zip(u).map(|(r, v)| r * v).sum()
}

/// The value farthest from `expected`.
fn worst(values: &[f64], expected: f64) -> f64 {
    let distance = |v: &f64| (v - expected).abs();
    values.iter().copied().max_by(|a, b| distance(a).total_cmp(&distance(b))).unwrap_or(f64::NAN)
}

fn liquid(volume: VolumePart) -> LiquidProperties {
    LiquidProperties { density: 1.0, bulk_modulus: BULK_MODULUS, volume, rotation: RotationPart::Full(PENALTY) }
}

/// Pressures K e of all elements under a uniform expansion.
fn pressures(patch: &Patch, volume: VolumePart) -> Result<Vec<f64>, Failure> {
    let (model, elements) = patch.model(liquid(volume))?;
    let rate = STRESS / BULK_MODULUS / 3.0;
    let u = solve(&model, |n| n < patch.outer, |x| x.map(|v| rate * v))?;
    // The dissertation's sign: p = K e.
    Ok(elements.iter().map(|e| -product(&e.samples()[0].row, &gather(&model, e, &u))).collect())
}

/// K_rot ω_ij of all elements under the rotation that makes it −10, for ij = 12, 13, 23.
fn rotations(patch: &Patch, volume: VolumePart) -> Result<Vec<f64>, Failure> {
    let (model, elements) = patch.model(liquid(volume))?;
    let mut out = Vec::new();
    for (k, (i, j)) in [(0, 1), (0, 2), (1, 2)].into_iter().enumerate() {
        // u_i = ω x_j, u_j = −ω x_i: ω_ij = ω.
        let omega = STRESS / PENALTY;
        let field = |x: [f64; 3]| {
            let mut u = [0.0; 3];
            (u[i], u[j]) = (omega * x[j], -omega * x[i]);
            u
        };
        let u = solve(&model, |n| n < patch.outer, field)?;
        out.extend(elements.iter().map(|e| PENALTY * product(&e.rotation_rows()[k], &gather(&model, e, &u))));
    }
    Ok(out)
}

/// (pressures, rotations) of the plane patch.
fn plane(volume: VolumePart) -> Result<(Vec<f64>, Vec<f64>), Failure> {
    let mut builder = Builder::new();
    for [x, z] in PLANE {
        builder.node([x, 0.0, z]);
    }
    let mut elements = Vec::new();
    for nodes in PLANE_CELLS {
        let face = Face { nodes, chart: nodes.map(|n| [PLANE[n][0], 0.0, PLANE[n][1]]) };
        let element = Fluid4::new(&face, Chart::Cartesian, 1.0, liquid(volume))?;
        builder.element("liquid", element.clone());
        elements.push(element);
    }
    let model = builder.build()?;
    let rate = STRESS / BULK_MODULUS / 2.0;
    let expansion = solve(&model, |n| n < 4, |x| x.map(|v| rate * v))?;
    let omega = STRESS / PENALTY;
    let turn = solve(&model, |n| n < 4, |[x, _, z]| [omega * z, 0.0, -omega * x])?;
    Ok((
        elements.iter().map(|e| -product(&e.samples()[0].row, &gather(&model, e, &expansion))).collect(),
        elements.iter().map(|e| PENALTY * product(&e.rotation_row(), &gather(&model, e, &turn))).collect(),
    ))
}

/// The plane patch in (r, z), drawn over three sectors of the cylindrical chart: 1 < r < 1.24.
fn extruded() -> Patch {
    let levels = [0.0, 0.3, 0.5, 0.8];
    let outer = |n: usize, level: usize| n < 4 || level == 0 || level == 3;
    let mut order: Vec<(usize, usize)> = (0..8).flat_map(|n| (0..4).map(move |l| (n, l))).collect();
    order.sort_by_key(|&(n, l)| !outer(n, l));
    let mut position = [[0; 4]; 8];
    order.iter().enumerate().for_each(|(k, &(n, l))| position[n][l] = k);
    let mut cells = Vec::new();
    for l in 0..3 {
        for [a, b, c, d] in PLANE_CELLS {
            let corners = [(a, l), (b, l), (b, l + 1), (a, l + 1), (d, l), (c, l), (c, l + 1), (d, l + 1)];
            cells.push(corners.map(|(n, l)| position[n][l]));
        }
    }
    Patch {
        places: order.iter().map(|&(n, l)| [1.0 + PLANE[n][0], levels[l], PLANE[n][1]]).collect(),
        cells,
        outer: order.iter().filter(|&&(n, l)| outer(n, l)).count(),
        chart: Chart::Cylindrical,
    }
}

/// Regular patch of Bild 5.18, with two layers so that there are inner nodes.
fn regular() -> Result<Patch, Failure> {
    let thirds = vec![0.0, 1.0 / 3.0, 2.0 / 3.0, 1.0];
    let block = Rectangle { x: thirds.clone(), y: thirds, z: vec![0.0, 0.5, 1.0] }.block()?;
    let inner = |p: &[f64; 3]| p.iter().all(|v| *v > 1e-9 && *v < 1.0 - 1e-9);
    // Outer nodes first.
    let mut order: Vec<usize> = (0..block.nodes.len()).collect();
    order.sort_by_key(|&n| inner(&block.nodes[n]));
    let mut position = vec![0; order.len()];
    order.iter().enumerate().for_each(|(new, &old)| position[old] = new);
    Ok(Patch {
        places: order.iter().map(|&n| block.nodes[n]).collect(),
        cells: block.cells.iter().map(|c| c.nodes.map(|n| position[n])).collect(),
        outer: block.nodes.iter().filter(|p| !inner(p)).count(),
        chart: Chart::Cartesian,
    })
}

/// The patch tests: every row is the worst element.
///
/// Tolerance 10⁻⁹: rounding 10⁻¹⁶ times the ratio K/K_rot = 10⁴ that separates the two parts of the system, with a margin.
///
/// Errors: none to be expected.
pub(crate) fn patch_tests() -> Answer {
    let cube = seven(Chart::Cartesian, |p| p);
    let regular = regular()?;
    let mut rows = Vec::new();
    let mut push = |id: &str, what: String, values: &[f64]| {
        rows.push(SOURCE.row(id, what, (STRESS, worst(values, STRESS)), 1e-9, "kPa"));
    };
    for (name, volume) in
        [("one-point volume part", VolumePart::OnePoint), ("mean dilatation", VolumePart::MeanDilatation)]
    {
        let (expansion, turn) = plane(volume)?;
        push("figure-5.15", format!("plane, expansion, {name}"), &expansion);
        push("figure-5.15", format!("plane, rotation, {name}"), &turn);
        push("figure-5.17", format!("distorted, rotations, {name}"), &rotations(&cube, volume)?);
        push("figure-5.19", format!("regular, expansion, {name}"), &pressures(&regular, volume)?);
        push("figure-5.19", format!("regular, rotations, {name}"), &rotations(&regular, volume)?);
    }
    let mean = VolumePart::MeanDilatation;
    push("K2", "distorted, expansion, mean dilatation".to_owned(), &pressures(&cube, mean)?);
    let what = "distorted in r and z, plane sectors, expansion, mean dilatation".to_owned();
    push("K2", what, &pressures(&extruded(), mean)?);
    let skew = Source { source: "constant state; two-point quadrature of 1/r", ..SOURCE };
    // The same seven cells drawn in (r, θ, z), 1 < r < 2 and one radian: the covariant u_θ brings ∂N/∂θ/r, which two
    // points do not integrate exactly once the cells are skew in θ. Shown; tank meshes have plane sectors.
    let ring = pressures(&seven(Chart::Cylindrical, |[x, y, z]| [1.0 + x, y, z]), mean)?;
    let pair = (STRESS, worst(&ring, STRESS));
    rows.push(skew.row("K2", "skew in θ, expansion, mean dilatation", pair, f64::INFINITY, "kPa"));
    // The test that fails in the dissertation, by how much depends on the mesh.
    let script = Source {
        source: "the same seven elements in an independent script (numpy)",
        kind: Reference::SecondFormulation,
    };
    let reason = "its mesh is not printed; the constant state, −10 kPa, is missed on any mesh of skew hexahedra";
    let failing = pressures(&cube, VolumePart::OnePoint)?;
    let (low, high) = failing.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), &v| (l.min(v), h.max(v)));
    let what = |end: &str| format!("distorted, expansion, one-point volume part: {end} (exact: −10)");
    // Half of the script's last digit, and rounding as above.
    for (end, reference, found, printed) in
        [("least pressure", -1.185_323_2, low, -10.45), ("greatest pressure", -0.769_370_8, high, -9.1)]
    {
        let row = script.row("figure-5.17", what(end), (reference, found), 1e-7, "kPa");
        rows.push(row.printed(printed, reason));
    }
    Ok(rows)
}

#[cfg(test)]
mod tests {
    use super::*;
    use fem::dofs::Dof;

    /// The dissertation's element misses the constant pressure by far more than rounding.
    #[test]
    fn one_point_volume_part_fails_on_distorted_hexahedra() {
        let cube = seven(Chart::Cartesian, |p| p);
        let values = pressures(&cube, VolumePart::OnePoint).unwrap();
        assert!((worst(&values, STRESS) / STRESS - 1.0).abs() > 0.05, "{values:?}");
    }

    /// The nodes are unknowns of the model in the order x, y, z.
    #[test]
    fn prescribed_field_is_taken() {
        let (model, _) = seven(Chart::Cartesian, |p| p).model(liquid(VolumePart::Full)).unwrap();
        assert_eq!(model.dofs().equation(1, Dof::Uy), Some(4));
        let u = solve(&model, |n| n < 8, |x| [x[0], 2.0 * x[1], 0.0]).unwrap();
        assert_eq!(&u[3..6], &[1.0, 0.0, 0.0]);
        assert_eq!(&u[18..21], &[1.0, 2.0, 0.0]);
    }
}
