//! Waves around an imperfect wall against the three-dimensional linear engine.

use fem::progress::Silent;
use tank::Case;
use tank::imperfection::{Imperfection, Imperfections, Profile, Wave};
use tank::options::linear::DampingModel;
use tank::options::nonlinear::{Damping, NonlinearOptions};
use tank::options::solid::{MeshSize, SolidOptions};

use super::super::super::simulate;
use super::{elastic, options, shaken};
use crate as fe;

/// Wall and sloshing damping, by group in both engines.
const RATIOS: [f64; 2] = [0.02, 0.005];
/// Elements over the height and around the tank, in both engines.
const MESH: [u32; 2] = [20, 48];

/// The elastic tank under a shock that leaves the sloshing nearly at rest: its waves act on the wall for seconds, and the
/// three-dimensional engine continues after the record.
fn shocked() -> Case {
    let mut case = shaken(elastic(), 0.0, 40);
    if let Some(motion) = &mut case.ground_motion {
        for (i, a) in motion.horizontal.acceleration.iter_mut().enumerate() {
            let t = 0.01 * i as f64;
            *a = 0.05 * (40.0 * t).sin() * (-6.0 * t).exp();
        }
    }
    case
}

/// A tenth of the thickness in n = 3 couples n = 1 to 2 and 4. Both engines have the same form, loaded state, damping, mesh, record and
/// liquid: that of the perfect tank. Peaks lie within the record in both. Left are the walls' elements and the time integration:
/// periods differ by 1 %, and the amplitudes of the three-dimensional engine change by up to 7 % from 14 x 32 to 20 x 48 elements, by half of it
/// beyond: 10 %.
#[test]
fn waves_are_those_of_three_dimensions() {
    let case = shocked();
    let imperfections = Imperfections {
        parts: vec![Imperfection::Wave(Wave { n: 3, amplitude: 3e-4, profile: Profile::Linear, phase: 0.0 })],
    };
    let [wall, sloshing] = RATIOS;
    let mut own = NonlinearOptions {
        imperfections: imperfections.clone(),
        damping: Damping::ByGroup { wall, sloshing },
        ..options(&case, MESH[0], MESH[1])
    };
    own.spectral_radius = 1.0;
    own.time_step = Some(0.001);
    let found = simulate(&case, &own, None, &Silent).unwrap().result.around.unwrap();
    let linear =
        fe::Options { mesh_error: false, damping: DampingModel::ByGroup { wall, sloshing }, ..fe::Options::default() };
    let solid = SolidOptions {
        mesh: Some(MeshSize { radial: 6, sectors: MESH[1] as usize, vertical: MESH[0] as usize }),
        imperfections,
        ..SolidOptions::default()
    };
    let other = fe::solid::around_a_perfect_liquid(&case, &linear, &solid).unwrap().unwrap();
    for n in [1, 2, 4] {
        let [a, b] = [&found, &other].map(|around| &around.waves[n]);
        assert!(a.time < 0.39 && b.time < 0.39, "{n}: {} {}", a.time, b.time);
        assert!((a.displacement / b.displacement - 1.0).abs() < 0.1, "{n}: {:e} {:e}", a.displacement, b.displacement);
    }
}
