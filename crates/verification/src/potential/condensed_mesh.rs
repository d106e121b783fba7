//! A liquid of potential elements, condensed onto wall displacements and elevations of the surface.
//!
//! The same matrices as [`CondensedLiquid::of_harmonic`], of any mesh: M_f = ρ Fᵀ H⁻¹ F by [`ThreeField`].

use std::sync::Arc;

use super::three_field::ThreeField;
use fem::assembly::{Assembler, order as elimination};
use fem::dofs::Dof;
use fem::element::super_element::SuperElement;
use fem::linalg::{LinalgError, Matrix, Pencil, Symbolic, transposed_product};
use fem::liquid::{CondenseError, CondensedLiquid};
use fem::model::Model;

/// Entries of F below this part of the largest are rounding.
const NOTHING: f64 = 1e-12;
/// Columns that are solved for at once.
const COLUMNS: usize = 64;

/// A liquid of elements, condensed.
#[derive(Clone, Debug, PartialEq)]
pub struct CondensedMesh {
    /// The matrices.
    pub liquid: CondensedLiquid,
    /// Node and dof of each wall displacement.
    pub wall: Vec<(usize, Dof)>,
    /// Node and dof of each elevation.
    pub elevations: Vec<(usize, Dof)>,
}

impl CondensedMesh {
    /// The element over the dofs of the mesh itself: wall displacements and elevations.
    ///
    /// Errors: none but those of the element.
    pub fn element(&self) -> Result<SuperElement, CondenseError> {
        self.liquid.element(&self.wall, &self.elevations, 0.0)
    }
}

/// The liquid of a model that has only potential elements, surfaces and wet faces, with the potential eliminated.
/// The nodes of the wall must be free: dofs that are held in the model of the tank belong in the matrices.
///
/// Where the potential has no fixed value the volume is kept by eliminating the elevation that moves most of it.
///
/// Errors: stiffness that is not that of a surface, a singular liquid, no surface.
pub fn of_mesh(model: &Model) -> Result<CondensedMesh, CondenseError> {
    let assembler = Assembler::new(model);
    let (stiffness, mass) = assembler.stiffness_and_mass(model)?;
    let pattern = assembler.pattern();
    let symbolic = Arc::new(Symbolic::new(pattern.clone(), &elimination(model, pattern))?);
    let phi = model.dofs().of_kind(Dof::Phi);
    let pencil = ThreeField::new(&stiffness, &mass, symbolic, phi.clone())?;
    // Columns of F: which wall displacements the liquid feels at all.
    let mut weight = vec![0.0_f64; mass.size()];
    let mut is_phi = vec![false; mass.size()];
    phi.iter().for_each(|&e| is_phi[e] = true);
    for j in 0..mass.size() {
        for p in pattern.starts[j]..pattern.starts[j + 1] {
            let (i, v) = (pattern.rows[p], mass.values[p].abs());
            match (is_phi[i], is_phi[j]) {
                (true, false) => weight[j] = weight[j].max(v),
                (false, true) => weight[i] = weight[i].max(v),
                _ => {}
            }
        }
    }
    let largest = weight.iter().fold(0.0_f64, |m, v| m.max(*v));
    let kept = pencil.kept();
    let felt = |k: usize| weight[kept[k]] > NOTHING * largest;
    let of = |k: usize| model.dofs().unknown(kept[k]);
    let eta: Vec<usize> = (0..kept.len()).filter(|&k| of(k).1 == Dof::Eta).collect();
    let wall: Vec<usize> = (0..kept.len()).filter(|&k| of(k).1 != Dof::Eta && felt(k)).collect();
    let order: Vec<usize> = wall.iter().chain(&eta).copied().collect();
    let mut basis = Matrix::zeros(kept.len(), order.len());
    order.iter().enumerate().for_each(|(j, &k)| basis.add(k, j, 1.0));
    let mut elevations = eta;
    if pencil.constraints() > 0 {
        basis = keep_volume(&pencil, &mass, model, &order, &mut elevations, wall.len())?;
    }
    let liquid = CondensedLiquid {
        wall: wall.len(),
        mass: projected_mass(&pencil, &basis)?,
        stiffness: transposed_product(&basis, &pencil.stiffness(&basis)),
        omega: Vec::new(),
        rim: Vec::new(),
    };
    Ok(CondensedMesh {
        liquid,
        wall: wall.iter().map(|&k| of(k)).collect(),
        elevations: elevations.iter().map(|&k| of(k)).collect(),
    })
}

/// Bᵀ M B in blocks of columns: each costs solves with as many right-hand sides, over all nodes of the liquid.
fn projected_mass(pencil: &ThreeField<'_>, basis: &Matrix) -> Result<Matrix, LinalgError> {
    let mut out = Matrix::zeros(basis.cols, basis.cols);
    let rows: Vec<usize> = (0..basis.rows).collect();
    let columns: Vec<usize> = (0..basis.cols).collect();
    for block in columns.chunks(COLUMNS) {
        let image = pencil.mass(&basis.select(&rows, block))?;
        let part = transposed_product(basis, &image);
        for (k, &j) in block.iter().enumerate() {
            out.column_mut(j).copy_from_slice(part.column(k));
        }
    }
    Ok(out)
}

/// Basis of the x that keep the volume: one elevation follows from all others.
fn keep_volume(
    pencil: &ThreeField<'_>,
    mass: &fem::linalg::Symmetric,
    model: &Model,
    order: &[usize],
    elevations: &mut Vec<usize>,
    wall: usize,
) -> Result<Matrix, CondenseError> {
    if pencil.constraints() > 1 || elevations.is_empty() {
        return Err(CondenseError::Option {
            what: "liquid",
            found: format!("{} liquids, {} elevations", pencil.constraints(), elevations.len()),
            allowed: "one liquid with a surface; condense several one by one".into(),
        });
    }
    let constant = model.vector(|_| {
        let mut field = [0.0; fem::dofs::KINDS];
        field[Dof::Phi.index()] = 1.0;
        field
    });
    // −H 1 = 0, so that the rows of x are Fᵀ 1.
    let flux = pencil.restrict(&mass.times(&constant));
    let dependent =
        (wall..order.len()).max_by(|&a, &b| flux[order[a]].abs().total_cmp(&flux[order[b]].abs())).unwrap_or(wall);
    let last = order[dependent];
    elevations.remove(dependent - wall);
    let mut t = Matrix::zeros(pencil.kept().len(), order.len() - 1);
    let free = order.iter().filter(|&&k| k != last);
    for (j, &k) in free.enumerate() {
        t.add(k, j, 1.0);
        t.add(last, j, -flux[k] / flux[last]);
    }
    Ok(t)
}

#[cfg(test)]
mod tests {
    use super::*;
    use fem::chart::Chart;
    use fem::element::{Potential8, PotentialSurface, WetFace};
    use fem::linalg::generalized_eigen;
    use fem::mesh::Cylinder;
    use fem::model::Builder;

    const RADIUS: f64 = 2.0;
    const DEPTH: f64 = 1.6;
    const DENSITY: f64 = 1000.0;
    const GRAVITY: f64 = 9.81;

    /// A cylinder of liquid whose wall faces sit on their own nodes.
    fn mesh(rings: usize, sectors: usize, levels: usize) -> Model {
        let uniform = |length: f64, n: usize| (0..=n).map(|k| length * k as f64 / n as f64).collect::<Vec<f64>>();
        let cylinder = Cylinder { radii: uniform(RADIUS, rings), sectors, heights: uniform(DEPTH, levels) };
        let volume = cylinder.volume().unwrap();
        let mut builder = Builder::new();
        builder.nodes(&volume.nodes);
        for cell in &volume.cells {
            builder.element("liquid", Potential8::new(cell, Chart::Cylindrical, DENSITY).unwrap());
        }
        for face in &volume.surface {
            let surface = PotentialSurface::new(face, Chart::Cylindrical, DENSITY, GRAVITY).unwrap();
            builder.element("surface", surface);
        }
        for face in &volume.wall {
            let normals = face.chart.map(|c| [c[1].cos(), c[1].sin(), 0.0]);
            let wet = WetFace::new(face, Chart::Cylindrical, face.nodes, normals, DENSITY).unwrap();
            builder.element("wet", wet);
        }
        builder.build().unwrap()
    }

    /// ιᵀ M ι of a translation along x.
    fn moved(found: &CondensedLiquid, iota: &[f64]) -> f64 {
        fem::linalg::dot(iota, &found.mass.times(iota))
    }

    /// The mesh condensed exactly carries its own mass, and with sloshing modes too, whatever their number (D10); its modes in the
    /// rigid tank are those of the three-field pencil; the first antisymmetric one is near its closed form.
    #[test]
    fn mesh_of_potential_elements() {
        let model = mesh(4, 12, 5);
        let found = of_mesh(&model).unwrap();
        let liquid = &found.liquid;
        assert_eq!(found.elevations.len(), liquid.surface());
        let translation = |liquid: &CondensedLiquid| -> Vec<f64> {
            let mut iota: Vec<f64> = found.wall.iter().map(|(_, d)| f64::from(*d == Dof::Ux)).collect();
            iota.resize(liquid.mass.rows, 0.0);
            iota
        };
        let own = moved(liquid, &translation(liquid));
        // The mesh's own volume: the cylinder's, as the wall is curved in the chart. φ = x is not in the space of the elements:
        // second order in the sectors, (π/12)²/3.
        let exact = DENSITY * std::f64::consts::PI * RADIUS * RADIUS * DEPTH;
        assert!((own / exact - 1.0).abs() < 0.025, "{}", own / exact);
        let all = liquid.with_sloshing_modes(liquid.surface()).unwrap();
        let few = liquid.with_sloshing_modes(4).unwrap();
        for reduced in [&all, &few] {
            let mass = moved(reduced, &translation(reduced));
            // Neglecting gravity in the omitted modes changes stiffness, not mass; but they follow the wall, which takes the
            // part of the mass that stays at rest in these modes.
            assert!((mass / own - 1.0).abs() < 0.05, "{}", mass / own);
        }
        // ω² = g (1.8412/R) tanh(1.8412 H/R), Lamb 1932.
        let k = 1.841_183_781_340_659 / RADIUS;
        let omega = (GRAVITY * k * (k * DEPTH).tanh()).sqrt();
        let nearest = few.omega.iter().fold(0.0_f64, |m, w| if (w - omega).abs() < (m - omega).abs() { *w } else { m });
        assert!((nearest / omega - 1.0).abs() < 0.03, "{:?} {omega}", few.omega);
        // With all modes the result is exact: the same frequencies of the free liquid with the wall on springs.
        let with_springs = |l: &CondensedLiquid| {
            let mut k = l.stiffness.clone();
            (0..l.wall).for_each(|i| k.add(i, i, 1e7));
            let mut m = l.mass.clone();
            (0..l.wall).for_each(|i| m.add(i, i, 50.0));
            generalized_eigen(&k, &m, Some(12)).unwrap().omega
        };
        for (a, b) in with_springs(liquid).iter().zip(with_springs(&all)) {
            assert!((a / b - 1.0).abs() < 1e-8, "{a} {b}");
        }
        for (a, b) in with_springs(liquid).iter().zip(with_springs(&few)).take(4) {
            assert!((a / b - 1.0).abs() < 0.02, "{a} {b}");
        }
        assert!(found.element().is_ok());
        assert!(liquid.element(&found.wall, &found.elevations, 0.01).is_err());
        assert!(liquid.with_sloshing_modes(1000).is_err());
    }
}
