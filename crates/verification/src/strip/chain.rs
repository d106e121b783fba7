//! C15: the liquid of displacement elements between both walls against the condensed one.

use oscillator::record::Record;

use super::at_rest::at_rest;
use super::{elastic_section, tank};
use crate::{Answer, Benchmark, Part, Reference, Row};
use engines::strip::{LiquidMesh, Scalar, StripDamping, StripError, StripModel, StripQuake, StripTank};
use fem::analysis::AnalysisError;
use fem::analysis::scheme::TimeScheme;
use fem::element::fibre_beam::Options;
use fem::linalg::{Kind, Matrix, dot, generalized_eigen};
use fem::progress::Silent;

/// The page.
pub(crate) const BENCHMARK: Benchmark = Benchmark {
    id: "strip-chain",
    title: "Strip 8.4 with both walls and a liquid of displacement elements in one model",
    model: "Elastic fibre walls, fluid8 elements (mean dilatation, split rotation penalty) between them, bonded contact8 joints; \
            7 × 14, 14 × 28 and 28 × 56 elements. Reference: the liquid condensed in closed form, on the same wall. Motion: two seconds of sines \
            that excite sloshing and wall.",
    ids: &[("C15", "liquid of elements between both walls against the condensed liquid")],
    parts: &[Part::Fast(linear)],
};

const CONDENSED: &str = "condensed liquid, same wall";
/// Bulk modulus of water [Pa].
const WATER: f64 = 2.06e9;
/// Damping by group.
const DAMPING: StripDamping = StripDamping::ByGroup { wall: 0.05, sloshing: 0.005 };
/// Rows of the liquid; it has twice as many columns.
const MESHES: [usize; 3] = [7, 14, 28];

/// The tank with `rows` wet elements, and as condensed liquid or elements.
fn own(rows: usize, mesh: Option<LiquidMesh>) -> Result<StripTank, StripError> {
    Ok(StripTank { mesh, ..tank(elastic_section()?, rows, 1.0, Options::default())? })
}

/// Two seconds that excite sloshing and wall alike, begun and ended softly; peak 0.1 g.
fn motion() -> Record {
    let sample = |i: usize| {
        let t = 0.01 * i as f64;
        let swell = (std::f64::consts::PI * t / 2.0).sin().powi(2);
        0.7 * swell * (0.6 * (2.4 * t).sin() + 0.5 * (40.0 * t).sin() + 0.3 * (95.0 * t + 1.0).sin())
    };
    Record { name: "sines".into(), dt: 0.01, acceleration: (0..=200).map(sample).collect(), processing: Vec::new() }
}

/// Vectors of the space that the ground motion excites.
const VECTORS: usize = 40;

/// Frequency [rad/s] and effective mass of the modes near `omega` that the ground excites, by a Krylov space of (K + ω² M)⁻¹ M: eigenvalue
/// solvers for single pairs meet hundreds of circulations next to the mode of the wall.
fn excited(strip: &StripModel, omega: f64) -> Result<Vec<[f64; 2]>, StripError> {
    let failed = |e| AnalysisError::from(fem::analysis::failed("modes of the chain")(e));
    let (k, m) = (&strip.system.stiffness, &strip.system.mass);
    let mut shifted = k.clone();
    shifted.values.iter_mut().zip(&m.values).for_each(|(k, m)| *k += omega * omega * m);
    let factor = strip.symbolic.clone().factor(&shifted, Kind::Definite).map_err(failed)?;
    let load = &strip.system.inertia[0];
    let mut space: Vec<[Vec<f64>; 2]> = Vec::new();
    let mut next = factor.solve_vector(load).map_err(failed)?;
    while space.len() < VECTORS {
        for _ in 0..2 {
            for [v, mass_v] in &space {
                let part = dot(mass_v, &next);
                next.iter_mut().zip(v).for_each(|(x, v)| *x -= part * v);
            }
        }
        let mass_next = m.times(&next);
        let norm = dot(&mass_next, &next).sqrt();
        let [v, mass_v] = [next, mass_next].map(|x| x.iter().map(|x| x / norm).collect::<Vec<f64>>());
        next = factor.solve_vector(&mass_v).map_err(failed)?;
        space.push([v, mass_v]);
    }
    let (mut small, mut one) = (Matrix::zeros(VECTORS, VECTORS), Matrix::zeros(VECTORS, VECTORS));
    for j in 0..VECTORS {
        let force = k.times(&space[j][0]);
        one.add(j, j, 1.0);
        for (i, [v, _]) in space.iter().enumerate() {
            small.add(i, j, dot(v, &force));
        }
    }
    let found = generalized_eigen(&small, &one, None).map_err(failed)?;
    let participation: Vec<f64> = space.iter().map(|[v, _]| dot(v, load)).collect();
    let mode = |j: usize| [found.omega[j], dot(found.vectors.column(j), &participation).powi(2)];
    Ok((0..VECTORS).map(mode).collect())
}

/// First sloshing frequency and that of the wall [rad/s].
fn frequencies(strip: &StripModel) -> Result<[f64; 2], StripError> {
    let near = |omega: f64| -> Result<f64, StripError> {
        let all = excited(strip, omega)?;
        let close = all.iter().filter(|[w, _]| (w / omega - 1.0).abs() < 0.2);
        Ok(close.max_by(|a, b| a[1].total_cmp(&b[1])).map_or(f64::NAN, |mode| mode[0]))
    };
    Ok([near(strip.modes.omega[0])?, near(strip.wall_frequency())?])
}

/// What is compared: name, unit, tolerance of the finest mesh.
///
/// Tolerances: the elements converge with h², and the error of the coarsest mesh of a wave of length 4 L over 14 elements is (π/14)²/24 = 2e-3 in frequency
/// (linear interpolation of a sine). The wall mode sees the added mass, whose error is that of pressures over 7 elements, (π/14)²/6 = 8e-3, a sixteenth
/// of it on the finest; its resonance of 5 % damping multiplies an error of frequency by up to ten.
const COMPARED: [(&str, &str, f64); 8] = [
    ("deflection of the top at rest", "m", 5e-3),
    ("moment at the base at rest", "Nm/m", 2e-3),
    ("shear force at the base at rest", "N/m", 2e-3),
    ("first sloshing frequency", "rad/s", 1e-3),
    ("frequency of the wall", "rad/s", 5e-3),
    ("wave, both walls", "m", 1e-2),
    ("shear force at the base, dynamic, both walls", "N/m", 2e-2),
    ("moment at the base, dynamic, both walls", "Nm/m", 2e-2),
];

/// The values of [`COMPARED`], and the energy balance.
fn values(strip: &StripModel) -> Result<([f64; 8], f64), StripError> {
    let state = at_rest(strip)?;
    let wall = &strip.walls[0];
    let [shear, _, moment] = strip.base_reaction(wall, &state, [0.0; 3])?.total();
    let [sloshing, of_wall] = match &strip.chain {
        None => [strip.modes.omega[0], strip.wall_frequency()],
        Some(_) => frequencies(strip)?,
    };
    let mut quake = StripQuake::new(motion(), 0.0624 / 40.0);
    quake.scheme = TimeScheme::GeneralizedAlpha { radius: 1.0 };
    let runs = strip.histories(&quake, [None, None], &Silent)?;
    let peak = |scalar: Scalar| {
        let of = |h: &engines::strip::WallHistory| {
            let rest = h.at_rest(scalar);
            h.scalar(scalar).iter().fold(0.0, |most: f64, v| most.max((v - rest).abs()))
        };
        runs.iter().map(|run| of(&run.history)).fold(0.0, f64::max)
    };
    let imbalance = runs.iter().map(|run| run.run.balance.error()).fold(0.0, f64::max);
    let found = [
        state.committed.u[strip.top(wall)],
        moment,
        shear,
        sloshing,
        of_wall,
        peak(Scalar::Elevation),
        peak(Scalar::Shear),
        peak(Scalar::Moment),
    ];
    Ok((found, imbalance))
}

/// Rows C15: the linear limit, with its convergence.
///
/// Errors: those of the models.
fn linear() -> Answer {
    let mut study = Vec::new();
    let mut last = None;
    for rows in MESHES {
        let (reference, _) = values(&StripModel::new(&own(rows, None)?, DAMPING)?)?;
        let mesh = LiquidMesh::new(2 * rows, WATER);
        let (found, imbalance) = values(&StripModel::new(&own(rows, Some(mesh))?, DAMPING)?)?;
        study.push((rows as f64, std::array::from_fn::<f64, 8, _>(|i| found[i] / reference[i] - 1.0)));
        last = Some((reference, found, imbalance));
    }
    let mut rows = Vec::new();
    let Some((reference, found, imbalance)) = last else { return Ok(rows) };
    for (i, (what, unit, tolerance)) in COMPARED.into_iter().enumerate() {
        let own = (reference[i], CONDENSED, Reference::SecondFormulation);
        let row = Row::new("C15", format!("liquid of elements, bonded: {what}"), own, found[i], (tolerance, unit));
        rows.push(Row { convergence: study.iter().map(|(n, errors)| (*n, errors[i])).collect(), ..row });
    }
    let none = (0.0, "balance of energies", Reference::ClosedForm);
    rows.push(Row::new(
        "C15",
        "liquid of elements, bonded: residual of the energy balance",
        none,
        imbalance,
        (1e-3, ""),
    ));
    Ok(rows)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_hold() {
        crate::row::assert_held(&linear().unwrap());
    }
}
