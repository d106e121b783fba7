//! Three-field direct integration against modal superposition of the condensed pencil.

use oscillator::sdof;

use super::coupled::{Division, Tank, along_x, with_hexahedra};
use super::rigid::uniform;
use super::three_field::ThreeField;
use crate::Failure;
use fem::analysis::motion::{Grid, Motion};
use fem::analysis::observable::Observable;
use fem::analysis::system::System;
use fem::analysis::transient::{Load, Settings, integrate};
use fem::dofs::Dof;
use fem::element::shell4::MembraneShear;
use fem::linalg::{Matrix, Pencil, dot, generalized_eigen};
use fem::progress::Silent;

/// Observable, its history by direct integration and by modal superposition.
pub type Compared = (&'static str, Vec<f64>, Vec<f64>);

/// Tank 8.1 on a coarse mesh (the comparison is one of algorithms) under half a second of 4 Hz and 25 Hz shaking, undamped:
/// near both the sloshing and the first wall mode.
///
/// Errors: a model that cannot be solved.
pub fn three_field_and_modal() -> Result<Vec<Compared>, Failure> {
    // More than 80 lines: one model, two solutions, compared at the end.
    let data = Tank::broad();
    let division = Division {
        sectors: 8,
        wall: vec![0.0, 0.15, 0.4, 0.915, 1.2, 1.525, 1.83],
        radii: uniform(data.radius, 3),
        liquid: uniform(data.depth, 4),
        membrane_shear: MembraneShear::default(),
    };
    let tank = with_hexahedra(&data, &division)?;
    let system = System::new(&tank.model, &tank.assembler)?;
    let grid = Grid { dt: 1e-4, sub_steps: 1, samples: 5001 };
    let ground: Vec<f64> = (0..grid.samples)
        .map(|i| {
            let t = grid.time(i);
            (25.0 * t).sin() + (157.0 * t).sin()
        })
        .collect();
    let load = Load::ground(0, Motion::sampled(grid.dt, &ground, &grid));
    // θ = 0, at the upper course's foot; and a surface node at the wall.
    let node = tank.rows[3][0];
    let eta = tank.model.dofs().of_kind(Dof::Eta);
    let surface = tank.model.dofs().unknown(eta[eta.len() - 8]).0;
    let observed = [
        ("radial displacement of the wall", node, Dof::Ux),
        ("elevation of the surface at the wall", surface, Dof::Eta),
    ];
    let scalars: Vec<Observable> =
        observed.iter().map(|&(_, node, dof)| Observable::displacement(&tank.model, node, dof)).collect();
    let direct = integrate(&system, &tank.symbolic, &[load], &Settings::new(grid), &scalars, &[], &Silent)?;

    let phi = tank.model.dofs().of_kind(Dof::Phi);
    let pencil = ThreeField::new(&tank.stiffness, &tank.mass, tank.symbolic.clone(), phi)?;
    let n = pencil.size();
    // The volume is kept by leaving out one elevation, x = T x'.
    let flux = tank.mass.times(&tank.model.vector(|_| {
        let mut field = [0.0; fem::dofs::KINDS];
        field[Dof::Phi.index()] = 1.0;
        field
    }));
    let flux = pencil.restrict(&flux);
    let kept_eta = (0..n).filter(|&i| tank.model.dofs().unknown(pencil.kept()[i]).1 == Dof::Eta);
    let last = kept_eta.max_by(|&a, &b| flux[a].abs().total_cmp(&flux[b].abs())).ok_or("a tank without a surface")?;
    let mut t = Matrix::zeros(n, n - 1);
    for (j, i) in (0..n).filter(|&i| i != last).enumerate() {
        t.add(i, j, 1.0);
        t.add(last, j, -flux[i] / flux[last]);
    }
    let reduce = |a: &Matrix| fem::linalg::transposed_product(&t, a);
    let (k, m) = (reduce(&pencil.stiffness(&t)), reduce(&pencil.mass(&t)?));
    let eigen = generalized_eigen(&k, &m, None)?;
    let modes = fem::linalg::product(&t, &eigen.vectors);
    let all = pencil.expand(&modes)?;
    let inertia = tank.inertia(along_x);
    let mut modal = vec![vec![0.0; grid.samples]; observed.len()];
    for (j, &omega) in eigen.omega.iter().enumerate() {
        let participation = dot(all.column(j), &inertia);
        let history = sdof::exact(&ground, grid.dt, omega, 0.0);
        for (out, &(_, node, dof)) in modal.iter_mut().zip(&observed) {
            let shape: f64 = tank.model.row(node, dof).iter().map(|&(e, c)| c * all.get(e, j)).sum();
            for (v, q) in out.iter_mut().zip(&history.u) {
                *v += shape * participation * q;
            }
        }
    }
    Ok(observed
        .iter()
        .zip(direct[0].observed.scalars.iter().zip(modal))
        .map(|(&(what, ..), (direct, modal))| (what, direct.values.clone(), modal))
        .collect())
}
