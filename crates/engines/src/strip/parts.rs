//! Parts that a strip is built of.

use fem::analysis::damping::Rayleigh;
use fem::analysis::observable::Observable;
use fem::dofs::{Dof, KINDS};
use fem::element::super_element::SuperElement;
use fem::linalg::{Eigen, Matrix};
use fem::model::Model;

use super::liquid::{Trace, WallLiquid};
use super::parameters::{StripError, StripTank};
use super::shells;

/// Viscous damping of a strip, on the initial stiffness of the wall.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum StripDamping {
    /// Rayleigh's coefficients over wall and liquid. Mass-proportional damping alone leaves the wall mode practically
    /// undamped; see [`StripModel::ratios`](super::StripModel::ratios).
    Rayleigh(Rayleigh),
    /// Wall: stiffness-proportional with this ratio at the frequency of the first wall mode; every sloshing mode its ratio.
    ByGroup {
        /// ξ of the wall mode.
        wall: f64,
        /// ξ of the sloshing modes.
        sloshing: f64,
    },
}

/// The condensed liquid as an element on its face and its amplitudes.
pub(super) fn liquid_element(
    tank: &StripTank,
    damping: StripDamping,
    liquid: &WallLiquid,
    face: &[Vec<usize>],
    amplitude_nodes: &[usize],
) -> Result<SuperElement, StripError> {
    let trace = tank.trace();
    let mut nodes: Vec<usize> = face.iter().flatten().copied().collect();
    let mut dofs = vec![dofs_of(trace); nodes.len()];
    nodes.extend(amplitude_nodes);
    dofs.resize(nodes.len(), AMPLITUDE);
    let over = |matrix: &Matrix| shells::spread(matrix, trace.unknowns(), face);
    let mass = over(&liquid.mass);
    let n = mass.rows;
    let mut element = SuperElement::new(nodes, dofs)?.with_mass(mass)?.with_stiffness(over(&liquid.stiffness))?;
    if let StripDamping::ByGroup { sloshing, .. } = damping {
        let mut c = Matrix::zeros(n, n);
        for (i, (mass, omega)) in liquid.modal_masses.iter().zip(&liquid.omega).enumerate() {
            let at = n - tank.sloshing + i;
            c.add(at, at, 2.0 * sloshing * omega * mass);
        }
        element = element.with_damping(c)?;
    }
    Ok(element)
}

/// First mode of the wall. Sloshing modes have more than half of their potential energy in the amplitudes.
pub(super) fn first_wall_mode(tank: &StripTank, modes: &Eigen, amplitudes: &[usize]) -> usize {
    let spring = tank.liquid.spring();
    let is_wall = |j: &usize| {
        let phi = modes.vectors.column(*j);
        let surface: f64 = amplitudes.iter().map(|&e| spring * phi[e] * phi[e]).sum();
        surface < 0.5 * modes.omega[*j].powi(2)
    };
    (0..modes.omega.len()).find(is_wall).unwrap_or(0)
}

/// Rayleigh's coefficients of the wall, whose first frequency is `omega` [rad/s], and of the rest.
pub(super) fn coefficients(damping: StripDamping, omega: f64) -> [Rayleigh; 2] {
    match damping {
        StripDamping::Rayleigh(all) => [all, all],
        StripDamping::ByGroup { wall, .. } => [Rayleigh::stiffness_proportional(omega, wall), Rayleigh::NONE],
    }
}

/// Forces over the unknowns of the liquid's face as a load.
pub(super) fn wall_forces(model: &Model, face: &[Vec<usize>], dofs: &[Dof], forces: &[f64]) -> Vec<f64> {
    let mut out = vec![0.0; model.dofs().len()];
    for (i, nodes) in face.iter().enumerate() {
        for &node in nodes {
            for (k, &dof) in dofs.iter().enumerate() {
                if let Some(e) = model.dofs().equation(node, dof) {
                    out[e] = forces[dofs.len() * i + k] / nodes.len() as f64;
                }
            }
        }
    }
    out
}

/// Reactions on the base of wall and liquid: along x and z, about y. On a rotation spring the last is that of the spring.
pub(super) fn base_rows(
    model: &Model,
    base: &[usize],
    tank: &StripTank,
    rayleigh: &[Rayleigh],
) -> Result<[Observable; 3], StripError> {
    let of = |e: usize| rayleigh[model.group_of(e)];
    let row = |name: &str, dof: Dof| {
        let field = |node: usize| {
            let mut out = [0.0; KINDS];
            out[dof.index()] = f64::from(base.contains(&node));
            out
        };
        Observable::reaction(model, name, field, of)
    };
    let mut rows = [
        row("shear force at the base", Dof::Ux)?,
        row("normal force at the base", Dof::Uz)?,
        row("moment at the base", Dof::Ry)?,
    ];
    if let Some(stiffness) = tank.base_spring {
        rows[2].displacement = model.row(base[0], Dof::Ry).iter().map(|&(e, c)| (e, -stiffness * c)).collect();
    }
    Ok(rows)
}

/// Dofs of the reactions at the base.
pub(super) const BASE: [Dof; 3] = [Dof::Ux, Dof::Uz, Dof::Ry];
pub(super) const WALL_DOFS: &[Dof] = &[Dof::Ux, Dof::Ry];

/// Dofs of the nodes of a face.
pub(super) fn dofs_of(trace: Trace) -> &'static [Dof] {
    &WALL_DOFS[..trace.unknowns()]
}
pub(super) const AMPLITUDE: &[Dof] = &[Dof::Amplitude];

pub(super) fn check(tank: &StripTank, damping: StripDamping) -> Result<(), StripError> {
    let refuse = |parameter, found: String, allowed| Err(StripError::Parameter { parameter, found, allowed });
    let (z, liquid) = (&tank.levels, &tank.liquid);
    if z.len() < 2 || z[0] != 0.0 || !z.windows(2).all(|w| w[0] < w[1] && w[1].is_finite()) {
        return refuse("levels", format!("{z:?} m"), "ascending from 0");
    }
    if tank.sections.len() + 1 != z.len() {
        let found = format!("{} for {} elements", tank.sections.len(), z.len() - 1);
        return refuse("sections", found, "one an element");
    }
    for (parameter, value) in [
        ("half width", liquid.half_width),
        ("depth", liquid.depth),
        ("liquid density", liquid.density),
        ("gravity", liquid.gravity),
    ] {
        if !(value > 0.0 && value.is_finite()) {
            return refuse(parameter, value.to_string(), "> 0");
        }
    }
    if liquid.depth > z[z.len() - 1] {
        return refuse("depth", format!("{} m", liquid.depth), "at most the wall's height");
    }
    if let Some(mesh) = &tank.mesh {
        if mesh.columns < 2 || !mesh.columns.is_multiple_of(2) {
            return refuse(
                "elements of the liquid from wall to wall",
                mesh.columns.to_string(),
                "an even number, 2 or more",
            );
        }
        if !z.iter().any(|z| (z - liquid.depth).abs() <= 1e-9 * liquid.depth) {
            return refuse(
                "levels",
                format!("none at the surface, {} m", liquid.depth),
                "one at the surface, for elements of the liquid",
            );
        }
    }
    if tank.sloshing == 0 {
        return refuse("sloshing modes", "0".into(), "1 or more");
    }
    if let StripDamping::ByGroup { wall, sloshing } = damping
        && ![wall, sloshing].iter().all(|x| (0.0..1.0).contains(x))
    {
        return refuse("damping ratios", format!("{wall}, {sloshing}"), "0 to 1");
    }
    Ok(())
}
