//! The plane law along random closed paths.

use materials::Law;
use materials::concrete::{CrackAxes, CrackedConcrete, CrackedParameters, Softening, Stiffening, Tension};

use super::cracked::{E, F_C, parameters};
use super::{Noise, Point};

/// Corners of a closed path of random strains, `steps` to each.
fn closed_path(noise: &mut Noise, size: f64, corners: usize, steps: usize) -> Vec<[f64; 3]> {
    let mut path = Vec::new();
    let mut from = [0.0; 3];
    for corner in 0..=corners {
        let to: [f64; 3] = std::array::from_fn(|_| if corner == corners { 0.0 } else { size * noise.next() });
        for i in 1..=steps {
            let share = i as f64 / steps as f64;
            path.push(std::array::from_fn(|k| from[k] + share * (to[k] - from[k])));
        }
        from = to;
    }
    path
}

/// Laws for the property tests, by name.
fn all() -> Vec<(&'static str, CrackedConcrete)> {
    let stiffening = Some(Stiffening { share: 0.3, yield_strain: 2.5e-3 });
    let tail = Tension { stiffening, ..parameters().tension };
    [
        ("default", parameters()),
        ("turning", CrackedParameters { axes: CrackAxes::Turning, ..parameters() }),
        ("stiffened", CrackedParameters { tension: tail, ..parameters() }),
    ]
    .map(|(name, p)| (name, CrackedConcrete::new(&p).unwrap()))
    .to_vec()
}

/// M7. 150 closed strain cycles of 360 steps: no work gained, no negative dissipation, 99.9 % of the steps without
/// substeps.
#[test]
fn closed_cycles_give_no_work() {
    for (name, law) in all() {
        let mut noise = Noise::new(7);
        let (mut steps, mut cut, mut least, mut lost) = (0, 0, f64::INFINITY, f64::INFINITY);
        for cycle in 0..150 {
            let size = [2e-4, 6e-4, 2e-3][cycle % 3];
            let mut point = Point::new(&law);
            let (mut work, mut strain, mut stress) = (0.0, [0.0; 3], [0.0; 3]);
            for next in closed_path(&mut noise, size, 5, 60) {
                let response = point.step(&next);
                work += (0..3).map(|k| 0.5 * (stress[k] + response.stress[k]) * (next[k] - strain[k])).sum::<f64>();
                lost = lost.min(response.dissipation);
                steps += 1;
                cut += usize::from(law.parts(&point.history) > 1);
                (strain, stress) = (next, response.stress);
            }
            least = least.min(work / (F_C * size));
        }
        println!("{name}: {cut} of {steps} steps in parts, least work {least:.1e}, least dissipation {lost:.1e}");
        assert!(least >= -1e-9, "{name}: {least}");
        assert!(lost >= -1e-12 * F_C * 2e-3, "{name}: {lost}");
        assert!(cut * 1000 <= steps, "{name}: {cut} of {steps}");
    }
}

/// Tangents against central differences along random paths. At a kink (a crack that closes, begins or opens further,
/// the cone reached) the two sides differ and are not compared.
#[test]
fn tangents_are_derivatives() {
    for (name, law) in all() {
        let mut noise = Noise::new(11);
        let (mut errors, mut kinks) = (Vec::new(), 0);
        for cycle in 0..60 {
            let mut point = Point::new(&law);
            for strain in closed_path(&mut noise, [2e-4, 6e-4, 2e-3][cycle % 3], 4, 25) {
                let response = point.trial(&strain);
                let (mut worst, mut kink) = (0.0_f64, false);
                for j in 0..3 {
                    let step = 1e-9;
                    let (mut up, mut down) = (strain, strain);
                    (up[j], down[j]) = (strain[j] + step, strain[j] - step);
                    let (up, down) = (point.trial(&up), point.trial(&down));
                    for i in 0..3 {
                        let slope = (up.stress[i] - down.stress[i]) / (2.0 * step);
                        worst = worst.max((slope - response.tangent[i][j]).abs() / E);
                        kink |= (up.tangent[i][j] - down.tangent[i][j]).abs() > 1e-3 * E;
                    }
                }
                if kink {
                    kinks += 1;
                } else {
                    errors.push(worst);
                }
                point.step(&strain);
            }
        }
        errors.sort_by(f64::total_cmp);
        let at = |share: f64| errors[((errors.len() - 1) as f64 * share) as usize];
        println!(
            "{name}: {} points, {kinks} kinks, median {:.1e}, 90 % {:.1e}, 99.9 % {:.1e}, worst {:.1e}",
            errors.len(),
            at(0.5),
            at(0.9),
            at(0.999),
            at(1.0)
        );
        assert!(kinks * 100 < errors.len(), "{name}: {kinks}");
        // Rounding of the differences, 1e-16 f_c/(E 1e-9) and the tolerance of the local iteration over the step, 1e-7;
        // curvature on strains of f_t/E, (1e-9/1e-4)².
        assert!(at(0.9) < 1e-6 && at(0.999) < 1e-4, "{name}");
    }
}

/// Same input, same bits; the committed strain evaluated again gives the same stress and zero dissipation.
#[test]
fn repeatable() {
    for (name, law) in all() {
        let mut noise = Noise::new(13);
        for cycle in 0..30 {
            let mut point = Point::new(&law);
            for strain in closed_path(&mut noise, [2e-4, 6e-4, 2e-3][cycle % 3], 4, 10) {
                let old = point.history.clone();
                let first = point.step(&strain);
                let history = point.history.clone();
                let mut again = vec![f64::NAN; old.len()];
                assert_eq!(law.respond(&strain, &old, &mut again).unwrap(), first);
                assert!(again.iter().zip(&history).all(|(a, b)| a.to_bits() == b.to_bits()));
                let second = point.step(&strain);
                for k in 0..3 {
                    assert!(
                        (second.stress[k] - first.stress[k]).abs() < 1e-9 * F_C,
                        "{name} {strain:?} {first:?} {second:?}"
                    );
                }
                assert!(second.dissipation.abs() < 1e-9 * F_C * 2e-3, "{name} {second:?}");
            }
        }
    }
}

/// Rotating a strain path rotates the stress.
#[test]
fn axes_are_found_wherever_they_lie() {
    let law = CrackedConcrete::new(&parameters()).unwrap();
    let (sin, cos) = 0.7_f64.sin_cos();
    let turn = |e: &[f64; 3], shear: f64| {
        let (x, y, g) = (e[0], e[1], e[2] * shear);
        [
            cos * cos * x + sin * sin * y - 2.0 * sin * cos * g,
            sin * sin * x + cos * cos * y + 2.0 * sin * cos * g,
            (sin * cos * (x - y) + (cos * cos - sin * sin) * g) / shear,
        ]
    };
    let mut noise = Noise::new(17);
    for cycle in 0..30 {
        let (mut straight, mut turned) = (Point::new(&law), Point::new(&law));
        for strain in closed_path(&mut noise, [2e-4, 6e-4, 2e-3][cycle % 3], 4, 25) {
            let expected = turn(&straight.step(&strain).stress, 1.0);
            let found = turned.step(&turn(&strain, 0.5)).stress;
            assert!((0..3).all(|k| (found[k] - expected[k]).abs() < 1e-8 * F_C));
        }
    }
}

/// Jumps between unrelated strains, as in a Newton iteration of a structure: the response always exists, is finite
/// and does not gain energy; elements up to the largest admissible size, and brittle cracks.
#[test]
fn wild_jumps_have_an_answer() {
    for (number, softening) in [
        Softening::Energy { fracture_energy: 100.0, size: 0.1 },
        Softening::Energy { fracture_energy: 100.0, size: 0.272 },
        Softening::Brittle,
    ]
    .into_iter()
    .enumerate()
    {
        for axes in [CrackAxes::Fixed, CrackAxes::Turning] {
            let base = parameters();
            let law = CrackedConcrete::new(&CrackedParameters {
                axes,
                tension: Tension { softening, ..base.tension },
                ..base
            })
            .unwrap();
            let mut noise = Noise::new(200 + number as u64);
            let (mut steps, mut cut) = (0, 0);
            for run in 0..200 {
                let size = [1e-4, 3e-4, 1e-3, 1e-2][run % 4];
                let mut point = Point::new(&law);
                for _ in 0..25 {
                    let response = point.step(&std::array::from_fn(|_| size * noise.next()));
                    assert!(response.stress.iter().all(|s| s.abs() < 20.0 * F_C));
                    assert!(response.tangent.iter().flatten().all(|d| d.abs() < 100.0 * E));
                    assert!(response.dissipation >= -1e-12 * F_C * size);
                    steps += 1;
                    cut += usize::from(law.parts(&point.history) > 1);
                }
            }
            assert!(cut * 1000 <= steps, "{softening:?} {axes:?}: {cut} of {steps}");
        }
    }
}
