//! Response of an imperfect wall by waves around the tank.
//!
//! ```text
//! u_n(z) = (2 − δ_n0)/N Σ_s u_r(θ_s, z) cos nθ_s          σ_n = (2 − δ_n0)/N Σ_s σ_z(θ_s, 0) cos nθ_s
//! ```
//!
//! and the same with sin nθ where the imperfections are not symmetric about the plane of shaking; the amplitude is then the square root
//! of the squares of both peaks, an upper bound. The axial membrane stress at the base is the reaction of the clamped edge, node by
//! node.

use fem::progress::Progress;
use results::{Around, BaseAround, Limit, WaveAround};
use tank::Case;
use tank::case::GroundMotion;
use tank::units::Dimension;

use super::around_probes::What;
use super::reduce::Space;
use crate::FeError;
use crate::linear::model::Model;
use crate::out_of_round;
use crate::response::motion::Motion;
use crate::response::observe::Extreme;
use crate::response::superpose::{self, ModalSystem, Observable};
use tank::options::LinearOptions as Options;
use tank::options::linear::Integrator;

/// The response around the tank; none of a perfect one.
///
/// Errors: as [`superpose::respond`].
pub(super) fn respond(
    case: &Case,
    imperfections: &tank::imperfection::Imperfections,
    (model, spaces): (&Model, &[Space]),
    motion: &GroundMotion,
    options: &Options,
    progress: &dyn Progress,
) -> Result<Option<Around>, FeError> {
    if imperfections.is_empty() || spaces.iter().any(|s| s.around.is_empty()) {
        return Ok(None);
    }
    let systems = model
        .systems()
        .map(|h| {
            let kept = superpose::keep(&h.coupled, &h.modes, &model.damper, options.wave_modes);
            ModalSystem::new(&h.coupled, kept, &model.damper)
        })
        .collect::<Result<Vec<ModalSystem>, FeError>>()?;
    let grid = model.grid(motion, Integrator::Modal)?;
    let records = std::iter::once(&motion.horizontal).chain(&motion.vertical);
    let ground: Vec<Motion> = records.map(|r| Motion::new(r, &grid)).collect();
    let ground: Vec<&Motion> = ground.iter().collect();
    let observables: Vec<Observable> = (0..spaces[0].around.len())
        .map(|i| spaces.iter().enumerate().map(|(k, space)| (k, 1.0, &space.around[i].1)).collect())
        .collect();
    let observed = superpose::respond(&systems, &ground, grid, &[], &observables, progress)?;
    let what = spaces[0].around.iter().map(|(what, _)| *what);
    let found: Vec<(What, Extreme)> = what.zip(observed.extremes).collect();
    Ok(Some(collect(case, imperfections, &found)))
}

/// Peaks of the harmonics, and the stress around the base.
fn collect(case: &Case, imperfections: &tank::imperfection::Imperfections, found: &[(What, Extreme)]) -> Around {
    let mut waves: Vec<WaveAround> = Vec::new();
    let mut base = BaseAround { theta: Vec::new(), min: Vec::new(), max: Vec::new() };
    let mut rest = found;
    while let Some(((what, extreme), after)) = rest.split_first() {
        // Cosine and sine of one harmonic follow each other.
        let twin = after.first().filter(|(other, _)| other == what).map(|(_, e)| e.peak().0);
        rest = if twin.is_some() { &after[1..] } else { after };
        let (peak, time) = extreme.peak();
        let peak = peak.hypot(twin.unwrap_or(0.0));
        let wave = |waves: &mut Vec<WaveAround>, n: u32| match waves.iter().position(|w| w.n == n) {
            Some(place) => place,
            None => {
                waves.push(WaveAround { n, deviation: 0.0, displacement: 0.0, z: 0.0, time: 0.0, stress: None });
                waves.len() - 1
            }
        };
        match *what {
            What::Displacement { n, z } => {
                let place = wave(&mut waves, n);
                if peak > waves[place].displacement {
                    (waves[place].displacement, waves[place].z, waves[place].time) = (peak, z, time);
                }
            }
            What::Stress { n } => {
                let place = wave(&mut waves, n);
                waves[place].stress = Some(peak);
            }
            What::Base { theta } => {
                base.theta.push(theta);
                base.min.push(extreme.min);
                base.max.push(extreme.max);
            }
        }
    }
    out_of_round::around(&case.tank, imperfections, waves, Some(base))
}

/// Waves around the tank that are not small against the thickness.
const SMALL: f64 = 0.5;
/// Deviation over the thickness up to which the coupling of harmonics is in proportion to it.
const FIRST_ORDER: f64 = 1.0;

/// Limits of validity of an imperfect wall.
pub(super) fn limits(case: &Case, around: &Around) -> Vec<Limit> {
    let mut out = vec![Limit {
        id: "deviation_against_thickness".into(),
        name: "Largest deviation from the perfect cylinder over the thickness of the wall".into(),
        value: around.over_thickness,
        limit: FIRST_ORDER,
        dimension: Dimension::Dimensionless,
        holds: around.over_thickness <= FIRST_ORDER,
        note: match around.over_thickness <= FIRST_ORDER {
            true => String::new(),
            false => "The waves around the tank are no longer in proportion to the deviation, and the stiffness of the wall against \
                      horizontal motion differs from that of the perfect cylinder: results hold for this form alone and must not be \
                      scaled."
                .into(),
        },
    }];
    if let Some((displacement, n)) = around.largest_beyond() {
        let thinnest = case.tank.courses.iter().map(|c| c.thickness).fold(f64::INFINITY, f64::min);
        let holds = displacement <= SMALL * thinnest;
        out.push(Limit {
            id: "waves_against_thickness".into(),
            name: format!("Seismic waves n = {n} around the tank against {SMALL} of the thinnest course"),
            value: displacement,
            limit: SMALL * thinnest,
            dimension: Dimension::Length,
            holds,
            note: match holds {
                true => String::new(),
                false => "The waves around the tank change the form of the wall by as much as its imperfections: the linear engine \
                          leaves out how membrane forces of large displacements then stiffen or soften it; use --fe nonlinear."
                    .into(),
            },
        });
    }
    out
}
