//! Nodes and normals of a wall whose radius deviates from R by w(θ, z), for all engines with shells in space.
//!
//! ```text
//! x = (R + w) e_r + z e_z          n ∝ e_r − w,θ/(R + w) e_θ − w,z e_z          n dA = (1 + w/R) (e_r − w,θ/(R + w) e_θ − w,z e_z) R dθ dz
//! ```

use nalgebra::Vector3;
use results::{Around, BaseAround, WallMap, WaveAround};
use tank::Tank;
use tank::imperfection::{Deviation, Imperfections};
use tank::refusal::{Place, Refusal};
use tank::units::Dimension;

/// Cells in a wave around the tank: fewer are refused. Four-node shells of eight cells a wave miss 2 % of the curvature of a wave
/// (1 − (sin(π/8)/(π/8))² = 5 % of its square, of which the exact directors save half).
const CELLS_PER_WAVE: usize = 8;
/// Cells in a half wave over the height.
const CELLS_PER_HALF_WAVE: usize = 4;

/// Displacement of a node of the perfect wall and the normal there, of any length.
pub(crate) fn place(radius: f64, theta: f64, deviation: Deviation) -> (Vector3<f64>, Vector3<f64>) {
    let (s, c) = theta.sin_cos();
    let radial = Vector3::new(c, s, 0.0);
    let along = Vector3::new(-s, c, 0.0) * (deviation.along_theta / (radius + deviation.w));
    (radial * deviation.w, radial - along - Vector3::z() * deviation.along_z)
}

/// Area vector of the imperfect wall over the area of the perfect one.
pub(crate) fn area(radius: f64, theta: f64, deviation: Deviation) -> [f64; 3] {
    (place(radius, theta, deviation).1 * (1.0 + deviation.w / radius)).into()
}

/// Sectors around the tank that resolve the harmonics n + 1 to which the motion of harmonic 1 couples the waves n.
pub(crate) fn sectors(imperfections: &Imperfections, tank: &Tank) -> usize {
    let most = imperfections.waves(tank.wall_height()).last().copied();
    most.map_or(0, |n| CELLS_PER_WAVE * (n as usize + 1))
}

/// Whether a mesh of `sectors` around and `rows` over the height resolves the imperfections; `help` says how to refine it.
pub(crate) fn resolved(
    imperfections: &Imperfections,
    tank: &Tank,
    mesh: (usize, usize),
    help: &str,
) -> Option<Refusal> {
    if imperfections.is_empty() {
        return None;
    }
    let (around, rows) = (sectors(imperfections, tank), CELLS_PER_HALF_WAVE * imperfections.half_waves() as usize);
    (mesh.0 < around || mesh.1 < rows).then(|| {
        Refusal::new(
            Place::Imperfections,
            "the mesh does not resolve the waves of the imperfections and those they are coupled to",
            format!("at least {around} elements around the tank and {rows} over its height"),
        )
        .found(format!("{} around, {} over the height", mesh.0, mesh.1))
        .help(help)
    })
}

/// Angles and heights of the map of deviations.
const MAPPED: [usize; 2] = [120, 24];

/// The imperfections with what was found wave by wave.
pub(crate) fn around(
    tank: &Tank,
    imperfections: &Imperfections,
    mut waves: Vec<WaveAround>,
    base: Option<BaseAround>,
) -> Around {
    let height = tank.wall_height();
    let (_, theta, z) = imperfections.largest(height);
    let deviation = imperfections.at(theta, z, height).w;
    let most = waves.iter().map(|w| w.n).max().unwrap_or(0);
    let levels: Vec<Vec<[f64; 2]>> =
        (0..=MAPPED[1]).map(|l| imperfections.harmonics(height * l as f64 / MAPPED[1] as f64, height, most)).collect();
    for wave in &mut waves {
        let amplitudes = levels.iter().map(|level| level[wave.n as usize]);
        wave.deviation = amplitudes.fold(0.0, |m, [c, s]| f64::max(m, c.hypot(s)));
    }
    Around {
        deviation,
        over_thickness: deviation.abs() / tank.course_at(z).thickness,
        theta,
        z,
        map: map(tank, imperfections),
        waves,
        base,
    }
}

/// The deviations over the developed wall, in steps of six digits.
fn map(tank: &Tank, imperfections: &Imperfections) -> WallMap {
    let height = tank.wall_height();
    let [angles, levels] = MAPPED;
    let rounded = |v: f64| format!("{v:.5e}").parse().unwrap_or(v);
    let theta: Vec<f64> = (0..angles).map(|k| rounded(std::f64::consts::TAU * k as f64 / angles as f64)).collect();
    let z: Vec<f64> = (0..=levels).map(|l| rounded(height * l as f64 / levels as f64)).collect();
    let values =
        theta.iter().flat_map(|&t| z.iter().map(move |&z| rounded(imperfections.at(t, z, height).w))).collect();
    WallMap {
        id: "deviation".into(),
        title: "Deviation from the perfect cylinder".into(),
        time: None,
        dimension: Dimension::Length,
        theta,
        z,
        values,
    }
}
