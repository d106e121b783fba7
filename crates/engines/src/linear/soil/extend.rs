//! The coupled system with the unknowns of the slab.

use fem::linalg::{Cholesky, Matrix, dot};
use results::Channel;
use results::channel::OnWall;
use tank::Case;

use super::Slab;
use super::floor::Floor;
use super::ground::Ground;
use super::residual;
use crate::FeError;
use crate::coupled::{Coupled, Part, ShapeRows};
use crate::damping::Damper;
use crate::error::failure;
use crate::modes::{self, CoupledMode};
use crate::probe::{Probe, ProbeLine};

/// Dashpots of the ground, the last of the system.
const GROUND: usize = 2;
/// Frequency of the spring that holds the internal rotation of the cone, over the lowest of the tank: a free rotation has no mode. Where the
/// cone matters, at the impulsive frequency 10 to 50 times that of sloshing, the spring has 1e-4 to 4e-6 of its inertia. A softer one costs
/// the digits of the higher modes ([`fem::linalg::generalized_eigen`] resolves 10⁴ times the lowest frequency).
const HELD: f64 = 0.1;

/// What tank and liquid weigh about the bottom plate and the underside of the slab.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Rigid {
    /// Row of the moment about the underside, f_ψ.
    pub moment: Vec<f64>,
    /// Rotation about the underside, of the unknowns of the wall.
    pub turn: Vec<f64>,
    /// m with the slab [kg].
    pub mass: f64,
    /// S [kg m].
    pub first: f64,
    /// J [kg m²].
    pub second: f64,
    /// Mass, first and second moment of wall and liquid alone about the bottom plate, and the share of the wall in the second.
    own: [f64; 4],
    /// Thickness t of the slab [m].
    thickness: f64,
    floor: Floor,
}

impl Rigid {
    /// Rigid motion of a coupled system of harmonic 1; `None` without the row of the overturning moment.
    pub(crate) fn of(coupled: &Coupled, case: &Case, slab: &Slab) -> Option<Rigid> {
        Rigid::on(coupled, case, [slab.thickness, slab.mass(), slab.inertia()])
    }

    /// The same without a slab, about the bottom plate.
    pub(crate) fn of_tank(coupled: &Coupled, case: &Case) -> Option<Rigid> {
        Rigid::on(coupled, case, [0.0; 3])
    }

    /// On a slab of this thickness, mass and moment of inertia.
    fn on(coupled: &Coupled, case: &Case, [t, own_mass, own_inertia]: [f64; 3]) -> Option<Rigid> {
        let floor = Floor::of(case);
        let below = coupled.probe(Channel::OverturningMoment)?;
        let (row, arm) = (&below.absolute_acceleration, &coupled.moment_arm);
        let wall = coupled.mass.times(arm);
        let shear = coupled.mass.times(&coupled.influence);
        let mass = coupled.liquid_mass + coupled.wall_mass;
        let first = dot(row, &coupled.influence) + below.ground_acceleration;
        let on_wall = dot(row, arm);
        // By reciprocity the floor does on the wall what the wall does on the floor.
        let second = on_wall + (on_wall - dot(&wall, arm)) + floor.inertia();
        Some(Rigid {
            moment: row.iter().zip(&shear).map(|(m, v)| m + t * v).collect(),
            turn: arm.iter().zip(&coupled.influence).map(|(a, i)| a + t * i).collect(),
            mass: mass + own_mass,
            first: first + t * mass + 0.5 * t * own_mass,
            second: second + 2.0 * t * first + t * t * mass + own_inertia,
            own: [mass, first, second, on_wall],
            thickness: t,
            floor,
        })
    }

    /// What a probe shows of a unit rotation about the underside: its row on the rotating wall and what the floor adds.
    pub(crate) fn turned(&self, probe: &Probe, z: Option<f64>, coupled: &Coupled) -> f64 {
        let on = |x: &[f64]| match probe.absolute_acceleration.is_empty() {
            true => 0.0,
            false => dot(&probe.absolute_acceleration, x),
        };
        let moved = on(&coupled.influence) + probe.ground_acceleration;
        let about_the_plate = match (probe.channel, z) {
            (Channel::BaseShear, _) => self.own[1],
            (Channel::BaseMoment, _) => self.own[3],
            (Channel::OverturningMoment, _) => self.own[2],
            (_, Some(z)) => on(&coupled.moment_arm) + self.floor.pressure(z),
            _ => on(&coupled.moment_arm),
        };
        about_the_plate + self.thickness * moved
    }
}

/// Mass and stiffness with the unknowns of the slab in units of `scale`, on springs; `inner`: that of the internal rotation.
fn with_slab(held: &Coupled, rigid: &Rigid, scale: &[f64], (spring, inner): ([[f64; 2]; 2], f64)) -> (Matrix, Matrix) {
    let n = held.influence.len();
    let size = n + scale.len();
    let shear = held.mass.times(&held.influence);
    let (mut mass, mut stiffness) = (Matrix::zeros(size, size), Matrix::zeros(size, size));
    for j in 0..n {
        mass.column_mut(j)[..n].copy_from_slice(held.mass.column(j));
        stiffness.column_mut(j)[..n].copy_from_slice(held.stiffness.column(j));
    }
    for (k, row) in [&shear, &rigid.moment].into_iter().enumerate() {
        for (i, f) in row.iter().enumerate() {
            mass.add(i, n + k, scale[k] * f);
            mass.add(n + k, i, scale[k] * f);
        }
    }
    for k in 0..scale.len() {
        mass.add(n + k, n + k, 1.0);
    }
    for (i, row) in spring.iter().enumerate() {
        for (j, value) in row.iter().enumerate() {
            stiffness.add(n + i, n + j, value * scale[i] * scale[j]);
        }
    }
    if let Some(scale) = scale.get(2) {
        stiffness.add(n + 2, n + 2, inner * scale * scale);
    }
    let coupling = rigid.first * scale[0] * scale[1];
    mass.add(n, n + 1, coupling);
    mass.add(n + 1, n, coupling);
    (mass, stiffness)
}

/// Rows of a system with the unknowns of the slab.
struct OnSlab<'a> {
    held: &'a Coupled,
    rigid: &'a Rigid,
    scale: &'a [f64],
}

impl OnSlab<'_> {
    /// A row of these entries of the slab alone.
    fn unit(&self, entries: &[(usize, f64)]) -> Vec<f64> {
        let n = self.held.influence.len();
        let mut row = vec![0.0; n + self.scale.len()];
        entries.iter().for_each(|(i, v)| row[n + i] = *v);
        row
    }

    /// A row with zeros for the unknowns of the slab.
    fn longer(&self, row: &[f64]) -> Vec<f64> {
        let mut row = row.to_vec();
        row.resize(self.held.influence.len() + self.scale.len(), 0.0);
        row
    }

    /// A probe at the height `z`, if it has one.
    fn probe(&self, probe: &Probe, z: Option<f64>) -> Probe {
        let n = self.held.influence.len();
        let a = &probe.absolute_acceleration;
        let still = a.is_empty() && probe.ground_acceleration == 0.0;
        let moved = if a.is_empty() { 0.0 } else { dot(a, &self.held.influence) };
        let mut row = self.longer(a);
        row[n] = self.scale[0] * (moved + probe.ground_acceleration);
        row[n + 1] = self.scale[1] * self.rigid.turned(probe, z, self.held);
        // The elevation is that over the level surface; floor and rim go down by ψ r at θ = 0.
        let radius = match probe.channel {
            Channel::Wave(_) => Some(self.rigid.floor.edge()),
            Channel::WaveAt { r } => Some(r),
            _ => None,
        };
        Probe {
            rim: radius.map(|r| (n + 1, self.scale[1] * r)).into_iter().collect(),
            displacement: if probe.displacement.is_empty() { Vec::new() } else { self.longer(&probe.displacement) },
            absolute_acceleration: if still { Vec::new() } else { row },
            ground_acceleration: 0.0,
            ..probe.clone()
        }
    }

    fn line(&self, line: &ProbeLine) -> ProbeLine {
        let probes = line.probes.iter().zip(&line.z);
        ProbeLine {
            probes: probes.map(|(probe, z)| self.probe(probe, (line.what == OnWall::Pressure).then_some(*z))).collect(),
            ..line.clone()
        }
    }
}

/// Gives every mode the damping ratio of its dashpots.
fn set_damping(modes: &mut [CoupledMode], dashpots: &[(Vec<f64>, f64)]) {
    for mode in modes {
        let rate = |(row, c): &(Vec<f64>, f64)| c * dot(row, &mode.vector).powi(2);
        let rate: f64 = dashpots.iter().map(rate).sum();
        mode.damping = Some(rate / (2.0 * mode.omega));
    }
}

/// The system and its modes on the slab.
///
/// Errors: a mass that is not positive definite; a mode that fails its residual check.
pub(crate) fn on_soil(
    (held, modes): (&Coupled, &[CoupledMode]),
    case: &Case,
    damper: &Damper,
    (slab, ground): (&Slab, &Ground),
) -> Result<(Coupled, Vec<CoupledMode>), FeError> {
    let missing = || FeError::Analysis("the model on soil: no row of the overturning moment".into());
    let rigid = Rigid::of(held, case, slab).ok_or_else(missing)?;
    let inner = ground.inner.map(|[inertia, _]| inertia);
    // Unknowns of the slab, and of the cone of a half-space, in units in which their mass is 1.
    let scale: Vec<f64> = [Some(rigid.mass), Some(rigid.second + ground.trapped_inertia), inner]
        .into_iter()
        .flatten()
        .map(|m| 1.0 / m.sqrt())
        .collect();
    let n = held.influence.len();
    let size = n + scale.len();
    let lowest = modes.iter().map(|m| m.omega).fold(f64::INFINITY, f64::min);
    let inner = inner.map_or(0.0, |inertia| inertia * (HELD * lowest).powi(2));
    let (mass, stiffness) = with_slab(held, &rigid, &scale, (ground.spring, inner));
    let slab = OnSlab { held, rigid: &rigid, scale: &scale };
    let own = modes.iter().map(|mode| {
        let momentum = held.mass.times(&mode.vector);
        (slab.longer(&momentum), 2.0 * damper.of(mode) * mode.omega)
    });
    let mut dashpots: Vec<(Vec<f64>, f64)> = own.collect();
    dashpots.extend(held.dashpots.iter().map(|(row, c)| (slab.longer(row), *c)));
    match ground.inner {
        Some([_, dashpot]) => {
            dashpots.push((slab.unit(&[(0, scale[0])]), ground.dashpot[0][0]));
            dashpots.push((slab.unit(&[(1, scale[1]), (2, -scale[2])]), dashpot));
        }
        None => {
            let principal = ground.principal([scale[0], scale[1]]);
            dashpots.extend(principal.map(|([x, turn], c)| (slab.unit(&[(0, x), (1, turn)]), c)));
        }
    }

    let base = [Channel::FoundationTranslation, Channel::FoundationRotation].into_iter().enumerate();
    let base = base.map(|(k, channel)| Probe { displacement: slab.unit(&[(k, scale[k])]), ..Probe::new(channel) });
    // M a = the row of the moment above the base plate.
    let above = held.probe(Channel::BaseMoment).map(|probe| slab.probe(probe, None).absolute_acceleration);
    let factor = Cholesky::factor(&mass).map_err(failure("the mass matrix of the tank on its slab"))?;
    let moment_arm = match above {
        Some(row) if !row.is_empty() => factor.solve_vector(&row),
        _ => vec![0.0; size],
    };
    let coupled = Coupled {
        harmonic: held.harmonic,
        influence: slab.unit(&[(0, 1.0 / scale[0])]),
        surface: held.surface.clone(),
        rotation: ground.inner.map(|_| Part::block(&stiffness, n + 2..size)),
        probes: held.probes.iter().map(|probe| slab.probe(probe, None)).chain(base).collect(),
        lines: held.lines.iter().map(|line| slab.line(line)).collect(),
        level: held.level,
        shear: held.shear.as_ref().map(|line| slab.line(line)),
        liquid_mass: held.liquid_mass,
        wall_mass: held.wall_mass,
        moment_arm,
        // Rows without the shares of the clamped edge, which a rigid motion needs.
        structure: None,
        dashpots,
        mesh: held.mesh.clone(),
        shape_rows: ShapeRows::clone(&held.shape_rows),
        mass,
        stiffness,
    };
    let mut found = modes::solve(&coupled, None)?;
    let own = coupled.dashpots.len() - GROUND;
    found.extend(residual::modes(&coupled, &found, &coupled.dashpots[own..])?);
    set_damping(&mut found, &coupled.dashpots);
    Ok((coupled, found))
}
