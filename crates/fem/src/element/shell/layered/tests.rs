//! Layers against closed forms and hand calculations.

use std::f64::consts::PI;

use materials::concrete::{CrackedConcrete, CrackedParameters, Softening, Tension};
use materials::elastic::Elastic;

use super::*;
use crate::element::shell::section::ElasticSection;

const E: f64 = 200e9;
const YIELD: f64 = 250e6;

/// Three uncoupled ideally plastic springs, for tests: σ_i = clamp(C_i (ε_i − p_i)), history p.
#[derive(Debug)]
pub(crate) struct Springs;

const MODULI: [f64; 3] = [E, E, 0.5 * E];

fn spring(modulus: f64, strain: f64, old: f64) -> (f64, f64, f64, f64) {
    let trial = modulus * (strain - old);
    let stress = trial.clamp(-YIELD, YIELD);
    let plastic = (trial - stress) / modulus;
    let tangent = if plastic == 0.0 { modulus } else { 0.0 };
    (stress, tangent, old + plastic, stress * plastic)
}

impl Law<3> for Springs {
    fn kind(&self) -> &'static str {
        "springs"
    }

    fn history_len(&self) -> usize {
        3
    }

    fn respond(&self, strain: &[f64; 3], old: &[f64], new: &mut [f64]) -> Result<Response<3>, LawError> {
        let mut out = Response::default();
        for i in 0..3 {
            let (stress, tangent, plastic, energy) = spring(MODULI[i], strain[i], old[i]);
            out.stress[i] = stress;
            out.tangent[i][i] = tangent;
            out.dissipation += energy;
            new[i] = plastic;
        }
        Ok(out)
    }
}

impl Law<1> for Springs {
    fn kind(&self) -> &'static str {
        "springs"
    }

    fn history_len(&self) -> usize {
        1
    }

    fn respond(&self, strain: &[f64; 1], old: &[f64], new: &mut [f64]) -> Result<Response<1>, LawError> {
        let (stress, tangent, plastic, dissipation) = spring(E, strain[0], old[0]);
        new[0] = plastic;
        Ok(Response { stress: [stress], tangent: [[tangent]], dissipation })
    }
}

fn ply(law: Arc<dyn Law<3>>, thickness: f64, rule: Rule) -> Ply {
    Ply { law, thickness, density: 7850.0, rule }
}

fn respond(section: &LayeredSection, strain: &[f64; 8], old: &[f64], new: &mut [f64]) -> SectionResponse {
    let mut out = SectionResponse::default();
    section.respond(strain, old, new, &mut out).unwrap();
    out
}

fn virgin(section: &LayeredSection) -> Vec<f64> {
    let mut old = vec![f64::NAN; section.history_len()];
    section.init_history(&mut old);
    old
}

const STRAIN: [f64; 8] = [3e-4, -1e-4, 2e-4, 0.02, -0.01, 0.03, 1e-4, -2e-4];

/// Plies of one elastic material in any rule that is exact for cubics are the homogeneous section, as seen from any
/// reference surface; and the plain trapezoid is not.
#[test]
fn elastic_plies_are_the_elastic_section() {
    let (t, e, nu) = (0.02, 0.007, 0.3);
    let law: Arc<dyn Law<3>> = Arc::new(Elastic::new(E, nu).unwrap());
    let expected = ElasticSection::new(E, nu, t, 7850.0).unwrap().eccentric(e).unwrap();
    let mut reference = SectionResponse::default();
    expected.respond(&STRAIN, &[], &mut [], &mut reference).unwrap();
    let difference = |rules: [Rule; 2]| {
        let plies = [ply(law.clone(), 0.3 * t, rules[0]), ply(law.clone(), 0.7 * t, rules[1])];
        let section = LayeredSection::eccentric(&plies, &[], e).unwrap();
        assert_eq!(section.history_len(), 0);
        let found = respond(&section, &STRAIN, &[], &mut []);
        for (a, b) in section.inertia().iter().zip(expected.inertia()) {
            assert!((a / b - 1.0).abs() < 1e-13);
        }
        assert!((section.shear_stiffness() / expected.shear_stiffness() - 1.0).abs() < 1e-13);
        let tangents = found.tangent.iter().flatten().zip(reference.tangent.iter().flatten());
        let pairs = found.resultants.iter().zip(&reference.resultants).chain(tangents);
        pairs.map(|(a, b)| (a - b).abs() / b.abs().max(1.0)).fold(0.0, f64::max)
    };
    for rules in [
        [Rule::Gauss(2), Rule::Gauss(5)],
        [Rule::Lobatto(3), Rule::Simpson(5)],
        [Rule::MidPoint(2), Rule::MidPoint(20)],
    ] {
        assert!(difference(rules) < 1e-12, "{rules:?}");
    }
    assert!(difference([Rule::Trapezoid(5), Rule::Trapezoid(5)]) > 0.01);
}

/// Aluminium on steel, bent about the reference surface: A, B and D of the two plies by hand.
#[test]
fn two_materials_by_hand() {
    let (ea, es, ta, ts) = (70e9, 210e9, 0.03, 0.01);
    let law = |e: f64| -> Arc<dyn Law<3>> { Arc::new(Elastic::new(e, 0.0).unwrap()) };
    let plies = [ply(law(es), ts, Rule::Gauss(2)), ply(law(ea), ta, Rule::Gauss(2))];
    let section = LayeredSection::new(&plies, &[]).unwrap();
    let mut strain = [0.0; 8];
    (strain[0], strain[3]) = (1e-3, 0.1);
    let found = respond(&section, &strain, &[], &mut []);
    // Steel from −0.02 to −0.01, aluminium from −0.01 to 0.02.
    let s1 = es * -0.5 * (0.02_f64.powi(2) - 0.01_f64.powi(2)) + ea * 0.5 * (0.02_f64.powi(2) - 0.01_f64.powi(2));
    let s2 = (es * (0.02_f64.powi(3) - 0.01_f64.powi(3)) + ea * (0.02_f64.powi(3) + 0.01_f64.powi(3))) / 3.0;
    let n = (es * ts + ea * ta) * 1e-3 + s1 * 0.1;
    let m = s1 * 1e-3 + s2 * 0.1;
    assert!((found.resultants[0] / n - 1.0).abs() < 1e-12);
    assert!((found.resultants[3] / m - 1.0).abs() < 1e-12);
}

/// A bar at 30° in a ply of negligible stiffness: N = A E (a · ε) a, M = ζ N; linear law and history law alike.
#[test]
fn bar_in_an_oblique_direction() {
    let soft: Arc<dyn Law<3>> = Arc::new(Elastic::new(1.0, 0.0).unwrap());
    let laws: [Arc<dyn Law<1>>; 2] = [Arc::new(Elastic::new(E, 0.0).unwrap()), Arc::new(Springs)];
    let (area, depth, e, angle) = (7e-4, 0.11, 0.05, PI / 6.0);
    for law in laws {
        let bar = Bar { law, area, depth, angle, density: 7850.0 };
        let section = LayeredSection::eccentric(&[ply(soft.clone(), 0.3, Rule::Gauss(2))], &[bar], e).unwrap();
        let old = virgin(&section);
        let found = respond(&section, &STRAIN, &old, &mut old.clone());
        let a = [0.75, 0.25, 0.75_f64.sqrt() * 0.5];
        let zeta = e + depth;
        let along: f64 = (0..3).map(|i| a[i] * (STRAIN[i] + zeta * STRAIN[3 + i])).sum();
        // Below yield for the spring as well?
        let stress = (E * along).clamp(-YIELD, if section.history_len() > 0 { YIELD } else { f64::MAX });
        for i in 0..3 {
            let force = area * stress * a[i];
            assert!((found.resultants[i] - force).abs() < 1e-6 * force.abs() + 1.0, "{i}");
            assert!((found.resultants[3 + i] - zeta * force).abs() < 1e-6 * force.abs() + 1.0, "{i}");
        }
        let inertia = section.inertia();
        assert!((inertia[0] - 7850.0 * (0.3 + area)).abs() < 1e-9);
        assert!((inertia[1] - 7850.0 * (0.3 * e + area * zeta)).abs() < 1e-9);
        let mut bars = Vec::new();
        section.inspect(&STRAIN, &old, &mut |l| {
            if l.layer == 2 {
                bars.push((l.depth, l.angle, l.strain[0]));
            }
        });
        assert_eq!(bars.len(), 1);
        assert!((bars[0].0 - zeta).abs() < 1e-15 && bars[0].1 == angle && (bars[0].2 - along).abs() < 1e-15);
    }
}

/// Bending beyond yield and back: M = M_p (1 − (κ_y/κ)²/3), the tangent is the derivative, and the work done is the sum of stored
/// and dissipated energy.
#[test]
fn plastic_bending_and_its_energy() {
    let t = 0.02;
    let law: Arc<dyn Law<3>> = Arc::new(Springs);
    let plies = [ply(law.clone(), 0.5 * t, Rule::MidPoint(200)), ply(law, 0.5 * t, Rule::MidPoint(200))];
    let bar = Bar { law: Arc::new(Springs), area: 1e-4, depth: -0.008, angle: 0.0, density: 0.0 };
    let yielding = 2.0 * YIELD / (E * t);
    let plain = LayeredSection::new(&plies, &[]).unwrap();
    let mut strain = [0.0; 8];
    strain[3] = 3.0 * yielding;
    let old = virgin(&plain);
    let found = respond(&plain, &strain, &old, &mut old.clone());
    let plastic = YIELD * t * t / 4.0;
    // 400 layers: 1/400².
    assert!((found.resultants[3] / (plastic * (1.0 - 1.0 / 27.0)) - 1.0).abs() < 1e-4);
    // The elastic core is 133 layers: one more or less is 2.3 %.
    assert!((found.tangent[3][3] / (E * t.powi(3) / 12.0 / 27.0) - 1.0).abs() < 3e-2);

    let section = LayeredSection::new(&plies, &[bar]).unwrap();
    let (mut old, mut work, mut moment, mut last) = (virgin(&section), 0.0, 0.0, 0.0);
    let steps = 4000;
    for k in 1..=steps {
        let phase = f64::from(k) / f64::from(steps) * 2.25 * PI;
        strain[3] = 3.0 * yielding * phase.sin();
        let mut new = old.clone();
        let found = respond(&section, &strain, &old, &mut new);
        work += 0.5 * (found.resultants[3] + moment) * (strain[3] - last);
        (moment, last) = (found.resultants[3], strain[3]);
        assert!(section.dissipated(&new) >= section.dissipated(&old));
        old = new;
    }
    let mut stored = 0.0;
    section.inspect(&strain, &old, &mut |l| {
        let weight = if l.layer < 400 { t / 400.0 } else { 1e-4 };
        stored += weight * l.stress[0] * l.stress[0] / (2.0 * E);
    });
    let dissipated = section.dissipated(&old);
    assert!(dissipated > 3.0 * stored && stored > 0.0);
    // Steps of 1/4000 of the path: trapezoidal rule.
    assert!((work / (stored + dissipated) - 1.0).abs() < 1e-4, "{work} {stored} {dissipated}");
}

#[test]
fn parameters_out_of_range_are_rejected() {
    let law: Arc<dyn Law<3>> = Arc::new(Springs);
    let good = ply(law.clone(), 0.1, Rule::Gauss(3));
    let bar = |area: f64, depth: f64| Bar { law: Arc::new(Springs), area, depth, angle: 0.0, density: 0.0 };
    assert!(LayeredSection::new(&[], &[]).is_err());
    assert!(LayeredSection::new(&[ply(law.clone(), 0.0, Rule::Gauss(3))], &[]).is_err());
    assert!(LayeredSection::new(&[ply(law, 0.1, Rule::Gauss(0))], &[]).is_err());
    assert!(LayeredSection::new(std::slice::from_ref(&good), &[bar(1e-3, 0.051)]).is_err());
    assert!(LayeredSection::new(std::slice::from_ref(&good), &[bar(0.0, 0.0)]).is_err());
    let section = LayeredSection::new(&[good], &[bar(1e-3, 0.05)]).unwrap();
    assert!(section.with_shear_factor(0.0).is_err());
}

/// A law that hides its elastic range.
#[derive(Debug)]
struct Hidden(CrackedConcrete);

impl Law<3> for Hidden {
    fn kind(&self) -> &'static str {
        "hidden"
    }

    fn history_len(&self) -> usize {
        self.0.history_len()
    }

    fn respond(&self, strain: &[f64; 3], old: &[f64], new: &mut [f64]) -> Result<Response<3>, LawError> {
        self.0.respond(strain, old, new)
    }

    fn inspect(&self, strain: &[f64; 3], history: &[f64]) -> materials::PointState {
        self.0.inspect(strain, history)
    }
}

/// A whole section is its layers one by one, before and after it cracks: resultants, tangent, dissipation and the state of every
/// layer. Sums in another order differ by rounding: 1e-12 of the elastic values. The path bends to and fro, beyond the cracking
/// strain of 1e-4 from its middle on.
#[test]
fn whole_sections_are_their_layers() {
    let tension = Tension {
        strength: 3e6,
        softening: Softening::Energy { fracture_energy: 100.0, size: 0.15 },
        stiffening: None,
        bond: None,
    };
    let law = CrackedConcrete::new(&CrackedParameters::new(30e9, 0.2, 38e6, tension)).unwrap();
    let bar = Bar {
        law: Arc::new(materials::bar::Bar::new(E, 500e6, 1e9).unwrap()),
        area: 1e-3,
        depth: 0.06,
        angle: 0.0,
        density: 7850.0,
    };
    let of = |law: Arc<dyn Law<3>>| {
        let plies = [ply(law.clone(), 0.08, Rule::MidPoint(8)), ply(law, 0.12, Rule::Gauss(5))];
        LayeredSection::eccentric(&plies, std::slice::from_ref(&bar), 0.01).unwrap()
    };
    let sections = [of(Arc::new(law)), of(Arc::new(Hidden(law)))];
    let mut histories = [0, 1].map(|i| virgin(&sections[i]));
    let mut first_crack = None;
    for step in 0..200 {
        let size = 1.5e-6 * f64::from(step);
        let wave = |k: f64| size * (0.3 * k * f64::from(step) + k).sin();
        let strain =
            [wave(1.0), 0.4 * wave(2.0), wave(3.0), 5.0 * wave(1.3), 4.0 * wave(0.7), 3.0 * wave(2.1), wave(1.7), 0.0];
        let mut seen: [Vec<LayerState>; 2] = Default::default();
        let found: [SectionResponse; 2] = std::array::from_fn(|i| {
            // Another strain in between, as of an iterate that was not accepted.
            let mut new = vec![f64::NAN; histories[i].len()];
            respond(&sections[i], &strain.map(|e| 3.0 * e), &histories[i], &mut new);
            let found = respond(&sections[i], &strain, &histories[i], &mut new);
            let mut alone = SectionResponse::default();
            let mut again = vec![f64::NAN; new.len()];
            sections[i].resist(&strain, &histories[i], &mut again, &mut alone).unwrap();
            assert_eq!((alone.resultants, &again), (found.resultants, &new));
            sections[i].inspect(&strain, &new, &mut |layer| seen[i].push(layer));
            histories[i] = new;
            found
        });
        let [a, b] = &found;
        for i in 0..8 {
            let scale = sections[0].whole[i][i];
            assert!((a.resultants[i] - b.resultants[i]).abs() <= 1e-12 * scale * 1e-4, "step {step}, resultant {i}");
            for j in 0..8 {
                let scale = (scale * sections[0].whole[j][j]).sqrt();
                assert!((a.tangent[i][j] - b.tangent[i][j]).abs() <= 1e-12 * scale, "step {step}, {i} {j}");
            }
        }
        let [x, y] = [0, 1].map(|i| sections[i].dissipated(&histories[i]));
        assert!((x - y).abs() <= 1e-12 * y.abs());
        assert_eq!(seen[0], seen[1], "step {step}");
        let cracked = seen[1].iter().any(|layer| layer.state.cracks[0].is_some());
        if cracked && first_crack.is_none() {
            first_crack = Some(step);
        }
        // The range is smaller than the elastic one only where compression is beyond f_c.
        assert_eq!(histories[0][response::WHOLE] == 1.0, first_crack.is_none(), "step {step}");
    }
    assert!(first_crack.is_some_and(|step| step > 20 && step < 150), "{first_crack:?}");
}

/// Responds at `strain` from a history at this stage; returns the response and the history after it.
fn staged(section: &LayeredSection, stage: Stage, strain: &[f64; 8], mut old: Vec<f64>) -> (SectionResponse, Vec<f64>) {
    section.stage(stage, &mut old);
    let mut new = old.clone();
    (respond(section, strain, &old, &mut new), new)
}

fn close(a: &[f64], b: &[f64], scale: f64) {
    for (i, (a, b)) in a.iter().zip(b).enumerate() {
        assert!((a - b).abs() <= 1e-12 * scale, "{i}: {a} {b}");
    }
}

/// A section with free strains answers as one without at the strain less the free ones, whole, yielding and after it, share by share.
#[test]
fn free_strains_shift_the_strain() {
    let (t, free, of_bar) = (0.02, [2e-4, 8e-4], -5e-4);
    let steel: Arc<dyn Law<3>> = Arc::new(materials::von_mises::VonMises::new(E, 0.3, YIELD, 0.01 * E, 0.5).unwrap());
    let plies = [ply(steel, t, Rule::Gauss(5))];
    // A bar in the middle, and the free strains of the ply there.
    let bar = |law: Arc<dyn Law<1>>| super::Bar { law, area: 1e-3, depth: 0.0, angle: 0.0, density: 0.0 };
    let plain = LayeredSection::new(&plies, &[]).unwrap();
    let free_only = LayeredSection::new(&plies, &[]).unwrap().lasting(&[PlyState { free, creep: 0.0 }], &[]).unwrap();
    let (mut own, mut other) = (virgin(&free_only), virgin(&plain));
    let mean = 0.5 * (free[0] + free[1]);
    let slope = (free[1] - free[0]) / t;
    for (share, size) in [(0.25, 0.2), (0.5, 0.2), (1.0, 0.3), (1.0, 3.0), (1.0, -1.0)] {
        let strain = STRAIN.map(|e| size * e);
        let less = std::array::from_fn(|i| match i {
            0 | 1 => strain[i] - share * mean,
            3 | 4 => strain[i] - share * slope,
            _ => strain[i],
        });
        let (found, next) = staged(&free_only, Stage::Lasting(share), &strain, own);
        let mut new = other.clone();
        let expected = respond(&plain, &less, &other, &mut new);
        close(&found.resultants, &expected.resultants, E * t * 1e-3);
        close(&found.tangent.concat(), &expected.tangent.concat(), E * t);
        (own, other) = (next, new);
    }
    // Nothing changes when the loads cease to last.
    let before = staged(&free_only, Stage::Lasting(1.0), &STRAIN, own.clone()).0;
    assert_eq!(staged(&free_only, Stage::Short, &STRAIN, own).0, before);
    // A yielding bar, prestressed.
    let law: Arc<dyn Law<1>> = Arc::new(materials::bar::Bar::new(E, YIELD, 0.0).unwrap());
    let elastic: Arc<dyn Law<3>> = Arc::new(Elastic::new(E, 0.3).unwrap());
    let plies = [ply(elastic, t, Rule::Gauss(2))];
    let section = LayeredSection::new(&plies, &[bar(law)]).unwrap().lasting(&[PlyState::default()], &[of_bar]).unwrap();
    let at = |e: f64| {
        let strain = [e, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0];
        staged(&section, Stage::Lasting(1.0), &strain, virgin(&section)).0.resultants[0] - E * t * e / (1.0 - 0.09)
    };
    for (strain, stress) in [(0.0, 100e6), (5e-4, 200e6), (1e-3, YIELD), (-1e-3, -100e6)] {
        assert!((at(strain) - 1e-3 * stress).abs() < 1e-9 * YIELD, "{strain} {}", at(strain));
    }
}

/// Creep halves the moduli while loads last, keeps the stress when they cease, and leaves the short-time moduli after that; in a law without
/// history, in one with an elastic range and in one that is integrated layer by layer.
#[test]
fn creep_is_the_effective_modulus_and_stays() {
    let t = 0.02;
    let laws: [Arc<dyn Law<3>>; 3] = [
        Arc::new(Elastic::new(E, 0.3).unwrap()),
        Arc::new(materials::von_mises::VonMises::new(E, 0.3, YIELD, 0.0, 1.0).unwrap()),
        Arc::new(Springs),
    ];
    for law in laws {
        let plies = [ply(law, t, Rule::Gauss(5))];
        let plain = LayeredSection::new(&plies, &[]).unwrap();
        let state = PlyState { free: [1e-4; 2], creep: 1.0 };
        let section = LayeredSection::new(&plies, &[]).unwrap().lasting(&[state], &[]).unwrap();
        let strain = STRAIN.map(|e| 0.3 * e);
        let half = std::array::from_fn(|i| match i {
            0 | 1 => 0.5 * (strain[i] - 1e-4),
            6 | 7 => strain[i],
            _ => 0.5 * strain[i],
        });
        let mut scratch = virgin(&plain);
        let expected = respond(&plain, &half, &virgin(&plain), &mut scratch);
        let (lasting, old) = staged(&section, Stage::Lasting(1.0), &strain, virgin(&section));
        close(&lasting.resultants, &expected.resultants, E * t * 1e-3);
        assert!((lasting.tangent[0][0] / expected.tangent[0][0] - 0.5).abs() < 1e-12);
        assert_eq!(lasting.tangent[6], expected.tangent[6]);
        let (short, old) = staged(&section, Stage::Short, &strain, old);
        close(&short.resultants, &lasting.resultants, E * t * 1e-3);
        close(&short.tangent.concat(), &expected.tangent.concat(), E * t);
        // A strain beside it: the stress changes by the short-time modulus.
        let more = strain.map(|e| 1.1 * e);
        let change: Vec<f64> = (0..8)
            .map(|i| (0..8).map(|j| expected.tangent[i][j] * 0.1 * strain[j]).sum::<f64>() + short.resultants[i])
            .collect();
        close(&staged(&section, Stage::Short, &more, old).0.resultants, &change, E * t * 1e-3);
    }
}

#[test]
fn states_out_of_range_are_rejected() {
    let law: Arc<dyn Law<3>> = Arc::new(Elastic::new(E, 0.3).unwrap());
    let section = LayeredSection::new(&[ply(law, 0.02, Rule::Gauss(2))], &[]).unwrap();
    let bad = |free: f64, creep: f64| section.clone().lasting(&[PlyState { free: [free; 2], creep }], &[]).is_err();
    assert!(bad(f64::NAN, 0.0) && bad(0.0, -1.0) && !bad(1e-4, 1.0));
    assert!(section.clone().lasting(&[], &[]).is_err() && section.lasting(&[PlyState::default()], &[0.0]).is_err());
}
