//! The fibre beam against closed forms and difference quotients.

use super::*;
use crate::analysis::newton::{Criteria, Newton, load_path};
use crate::assembly::Assembler;
use crate::element::{Inspect, Motion, Trial, Want};
use crate::linalg::{Ordering, Symbolic};
use crate::model::Model;
use crate::progress::Silent;
use crate::state::State;
use materials::elastic::Elastic;
use materials::{Law, LawError, Response as Stress};

/// Stiff in compression only, and so cracked under any tension.
#[derive(Debug)]
struct NoTension(f64);

impl Law<1> for NoTension {
    fn kind(&self) -> &'static str {
        "no tension"
    }

    fn respond(&self, [strain]: &[f64; 1], _: &[f64], _: &mut [f64]) -> Result<Stress<1>, LawError> {
        let modulus = if *strain < 0.0 { self.0 } else { 1e-9 * self.0 };
        Ok(Stress { stress: [modulus * strain], tangent: [[modulus]], dissipation: 0.0 })
    }
}

/// σ = E (ε + 40 ε²): a section of it couples N with M.
#[derive(Debug)]
struct Curved(f64);

impl Law<1> for Curved {
    fn kind(&self) -> &'static str {
        "curved"
    }

    fn history_len(&self) -> usize {
        1
    }

    fn respond(&self, [e]: &[f64; 1], _: &[f64], new: &mut [f64]) -> Result<Stress<1>, LawError> {
        new[0] = *e;
        Ok(Stress { stress: [self.0 * (e + 40.0 * e * e)], tangent: [[self.0 * (1.0 + 80.0 * e)]], dissipation: 0.5 })
    }
}

fn section(law: impl Law<1> + 'static, layers: usize) -> FibreSection {
    FibreSection::new(2.0).unwrap().rectangle(Arc::new(law), [1.0, 0.3], 0.0, layers).unwrap()
}

const ENDS: [[f64; 3]; 2] = [[1.0, 0.4, 0.5], [2.2, 0.4, 2.1]];

/// A cantilever of `count` beams from the origin to `tip`.
fn cantilever(tip: [f64; 3], count: usize, section: FibreSection, options: Options) -> Model {
    let mut builder = Builder::new();
    let section = Arc::new(section);
    for i in 0..=count {
        builder.node(tip.map(|x| x * i as f64 / count as f64));
    }
    for dof in [Dof::Ux, Dof::Uz, Dof::Ry] {
        builder.hold(0, dof);
    }
    for i in 0..count {
        FibreBeam::add_to(&mut builder, "beam", [i, i + 1], section.clone(), options).unwrap();
    }
    builder.build().unwrap()
}

/// Final state under a force at node `count`, in `steps` steps after the constant load.
fn loaded(model: &Model, node: usize, force: [f64; 2], constant: &[f64]) -> State {
    let assembler = Assembler::new(model);
    let symbolic = Arc::new(Symbolic::new(assembler.pattern().clone(), &Ordering::MinimumDegree).unwrap());
    let mut newton = Newton::new(model, &assembler, &symbolic, None, Criteria::default()).unwrap();
    let mut state = State::new(model);
    let mut load = vec![0.0; model.dofs().len()];
    for (dof, f) in [Dof::Ux, Dof::Uz].into_iter().zip(force) {
        load[model.dofs().equation(node, dof).unwrap()] = f;
    }
    let path = load_path(&mut newton, &mut state, constant, &load, 10, &Silent, |_, _| {}).unwrap();
    assert_eq!(path.failure, None);
    state
}

/// In any direction of the plane: w = P L³/(3 E I) + P L/(G A_s), u = N L/(E A), exact with one beam.
#[test]
fn elastic_cantilever() {
    for shear in [f64::INFINITY, 3.0] {
        for tip in [[0.0, 0.0, 2.0], [2.0, 0.0, 0.0], [1.2, 0.0, 1.6]] {
            for count in [1, 3] {
                let elastic = section(Elastic::new(50.0, 0.0).unwrap(), 4).with_shear(shear).unwrap();
                let model = cantilever(tip, count, elastic, Options::default());
                let [x, z] = [0.5 * tip[0], 0.5 * tip[2]];
                // 0.01 across and 0.03 along.
                let force = [0.01 * z + 0.03 * x, -0.01 * x + 0.03 * z];
                let zero = vec![0.0; model.dofs().len()];
                let state = loaded(&model, count, force, &zero);
                let u = model.at_node(&state.committed.u, count);
                let across = 0.01 * 8.0 / (3.0 * 50.0 * 0.027 / 12.0) + 0.01 * 2.0 / shear;
                let along = 0.03 * 2.0 / 15.0;
                assert!((u[0] - (across * z + along * x)).abs() < 1e-12 * across.max(1.0), "{u:?}");
                assert!((u[2] - (along * z - across * x)).abs() < 1e-12 * across.max(1.0), "{u:?}");
            }
        }
    }
}

/// Weight of a column: u = −ρ g L²/(2 E A), N = −ρ g (L − z) at every section.
#[test]
fn weight_of_a_column() {
    let elastic = section(Elastic::new(50.0, 0.0).unwrap(), 4).with_attached_mass(7.0).unwrap();
    let model = cantilever([0.0, 0.0, 3.0], 2, elastic, Options::default());
    let assembler = Assembler::new(&model);
    let weight = assembler.body_force(&model, [0.0, 0.0, -10.0]);
    let state = loaded(&model, 2, [0.0; 2], &weight);
    let u = model.at_node(&state.committed.u, 2);
    assert!((u[2] + 20.0 * 9.0 / (2.0 * 15.0)).abs() < 1e-12, "{u:?}");
    let mut gather = crate::state::Gather::default();
    for (e, element) in model.elements().iter().enumerate() {
        let motion = gather.motion(&model, &state.committed, &**element);
        for s in element.sections(motion, &state.old[state.history(e)]).unwrap() {
            assert!((s.resultants[0] + 20.0 * (3.0 - s.position[2])).abs() < 1e-11);
            assert!(s.resultants[3].abs() < 1e-12);
        }
    }
}

/// Eccentric compression of a wall without tensile strength: a force P down and H across at the top, M = H (L − z).
///
/// ```text
/// e = M/P ≤ h/6: κ = M/(E I)          e > h/6: c = 3 (h/2 − e), κ = 2 P/(b E c²)
/// ```
#[test]
fn cracked_cantilever_converges() {
    let (length, h, young, p) = (3.0_f64, 0.3_f64, 1000.0, 1.0);
    // e = 0.12 at the base: cracked below z = 1.75 m, over 70 % of the section at the base.
    let force = 0.04;
    let curvature = |e: f64| {
        if e <= h / 6.0 {
            p * e / (young * h.powi(3) / 12.0)
        } else {
            2.0 * p / (young * (3.0 * (0.5 * h - e)).powi(2))
        }
    };
    // w = ∫ κ (L − z) dz by Simpson's rule on 10⁴ panels, to 1e-12.
    let n = 10_000;
    let integrand = |i: usize| {
        let arm = length * i as f64 / n as f64;
        curvature(force * arm / p) * arm
    };
    let exact: f64 = (0..n)
        .step_by(2)
        .map(|i| (integrand(i) + 4.0 * integrand(i + 1) + integrand(i + 2)) * length / (3.0 * n as f64))
        .sum();
    let mut errors = Vec::new();
    for count in [2, 4, 8, 16] {
        // 400 layers: their own error is 1e-4.
        let model = cantilever([0.0, 0.0, length], count, section(NoTension(young), 400), Options::default());
        let mut down = vec![0.0; model.dofs().len()];
        down[model.dofs().equation(count, Dof::Uz).unwrap()] = -p;
        let state = loaded(&model, count, [force, 0.0], &down);
        let u = model.at_node(&state.committed.u, count);
        errors.push(u[0] / exact - 1.0);
        let mut gather = crate::state::Gather::default();
        for (e, element) in model.elements().iter().enumerate() {
            let motion = gather.motion(&model, &state.committed, &**element);
            for s in element.sections(motion, &state.old[state.history(e)]).unwrap() {
                // Without locking: N is the applied one at both points of every beam.
                assert!((s.resultants[0] + p).abs() < 1e-4, "{}", s.resultants[0]);
            }
        }
    }
    eprintln!("{errors:?}");
    // The curvature is linear along a beam: the error falls with the square of its length, and always on the stiff side.
    assert!(errors.iter().all(|e| *e < 1e-3), "{errors:?}");
    assert!(errors[0].abs() < 0.1 && errors[2].abs() < 0.01 && errors[3].abs() < 2e-3, "{errors:?}");
}

/// Cantilever under P down and H across: w = H/P (tan(k L)/k − L), k² = P/(E I); Euler's load by `geometric_stiffness`.
#[test]
fn second_order() {
    let (length, h, p) = (3.0_f64, 0.01, 0.02);
    let bending: f64 = 50.0 * 0.027 / 12.0;
    let k = (p / bending).sqrt();
    let exact = h / p * ((k * length).tan() / k - length);
    let options = Options { second_order: true, ..Options::default() };
    let model = cantilever([0.0, 0.0, length], 8, section(Elastic::new(50.0, 0.0).unwrap(), 4), options);
    let mut down = vec![0.0; model.dofs().len()];
    let top = model.dofs().equation(8, Dof::Uz).unwrap();
    down[top] = -p;
    let state = loaded(&model, 8, [h, 0.0], &down);
    let w = model.at_node(&state.committed.u, 8)[0];
    // The cubics are not the exact functions under P; the force follows the chord of each beam.
    assert!((w / exact - 1.0).abs() < 2e-3, "{w} {exact}");

    let assembler = Assembler::new(&model);
    let stiffness = assembler.stiffness(&model).unwrap();
    let mut u = vec![0.0; model.dofs().len()];
    for node in 0..model.nodes().len() {
        if let Some(e) = model.dofs().equation(node, Dof::Uz) {
            u[e] = -model.nodes()[node][2] / 15.0;
        }
    }
    // Inverse iteration on K φ = −λ K_G φ: λ is Euler's load for P = 1.
    let geometric = assembler.geometric_stiffness(&model, &u).unwrap();
    let symbolic = Arc::new(Symbolic::new(assembler.pattern().clone(), &Ordering::MinimumDegree).unwrap());
    let statics = crate::analysis::statics::Statics::new(&symbolic, &stiffness, crate::linalg::Kind::Definite).unwrap();
    let mut phi = vec![1.0; u.len()];
    let mut buckling = 0.0;
    for _ in 0..30 {
        let force: Vec<f64> = geometric.times(&phi).iter().map(|x| -x).collect();
        let next = statics.solve(&stiffness, &[&force]).unwrap().remove(0);
        let norm = |x: &[f64]| crate::linalg::dot(x, x).sqrt();
        buckling = norm(&phi) / norm(&next);
        phi = next;
    }
    let euler = (std::f64::consts::FRAC_PI_2 / length).powi(2) * bending;
    // Cubics on eight elements: relative error of order (π/(2·8))⁴/720.
    assert!((buckling / euler - 1.0).abs() < 1e-5, "{buckling} {euler}");
}

#[test]
fn history_and_dissipation() {
    let beam = FibreBeam::new([0, 1, 2], ENDS, Arc::new(section(Curved(1.0), 3)), Options::default()).unwrap();
    assert_eq!(beam.history_len(), 2 * 4);
    let mut old = vec![0.0; 8];
    beam.init_history(&mut old);
    let motion = Motion { values: &[0.0; SIZE], rotations: &[] };
    let mut new = old.clone();
    beam.respond(Trial { motion, old: &old, new: &mut new, want: Want::ALL }, &mut Response::sized(SIZE)).unwrap();
    // 0.5 per volume.
    assert!((beam.dissipated(&new) - 0.5 * 0.3 * 2.0).abs() < 1e-14);
    let mut fibres = 0;
    beam.material_points(motion, &new, &mut |_| fibres += 1);
    assert_eq!(fibres, 6);
}

#[test]
fn bad_beams_are_rejected() {
    let section = Arc::new(section(Elastic::new(50.0, 0.0).unwrap(), 3));
    let make = |ends| FibreBeam::new([0, 1, 2], ends, section.clone(), Options::default());
    assert!(make([[0.0; 3], [0.0; 3]]).is_err());
    assert!(make([[0.0; 3], [0.0, 1.0, 1.0]]).is_err());
    let empty = Arc::new(FibreSection::new(1.0).unwrap());
    assert!(FibreBeam::new([0, 1, 2], ENDS, empty, Options::default()).is_err());
}
