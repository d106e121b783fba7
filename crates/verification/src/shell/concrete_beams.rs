//! M10 to M12: reinforced-concrete beams as strips of layered shells under a load at mid-span.
//!
//! Half the span between the plane of symmetry and the support, one element across the width, plane sections, bars without slip.
//! The concrete cracks with fracture energy and is ideally plastic in compression. Such a model does not crush: the
//! load keeps growing slowly. Ultimate is where the upper fibre at mid-span reaches −3.5 ‰.
//!
//! Source: Bresler & Scordelis 1963 (B-1 to B-3), Vecchio & Shim 2004 (B1, B2, C3), Hognestad 1951 (k_3 = 0.85), and a fibre analysis of the
//! same sections (theory sheet of this project: plane sections, curvature integrated along the span). Sections, strengths and loads of B-1,
//! B-2, B-3 and B2 are recalled, not read in the papers: no row asserts a load of their tests. Those of B1 and C3 are from published
//! reports that repeat them. Bars and strength of the concrete of B1 are also those of its companion OA1 as Bernardi, Cerioni, Michelini &
//! Sirico 2016 print it.

use std::sync::Arc;

use materials::LawError;
use materials::bar::Bar as BarLaw;
use materials::concrete::{CrackedConcrete, CrackedParameters, Softening, Tension};

use super::path::Problem;
use super::{Answer, Case, Grid, hold};
use crate::{Benchmark, Part, Reference, Row};
use fem::analysis::continuation::StepLength;
use fem::analysis::newton::Criteria;
use fem::dofs::Dof;
use fem::element::ElementError;
use fem::element::shell::layered::{Bar, LayeredSection, Ply};
use fem::element::shell::load::NodalLoads;
use fem::element::shell::rule::Rule;
use fem::element::shell::section::Section;
use fem::element::shell4::Axes;
use fem::model::Builder;
use fem::progress::Silent;
use fem::state::State;

/// The page.
pub(crate) const BENCHMARK: Benchmark = Benchmark {
    id: "shell-concrete-beams",
    title: "Shell: reinforced-concrete beams",
    model: "Beams B-1 to B-3 of Bresler & Scordelis (1963), B1, B2 and C3 of Vecchio & Shim (2004): half the span, layers of \
            cracking concrete, bars at their depth, pushed by displacement control. Data of B-1, B-2, B-3 and B2 are recalled, not read \
            in the papers: their tests are shown for comparison, not asserted.",
    ids: &[
        ("M10", "beam B-3 against a fibre analysis"),
        ("M11", "beam B-3 against its test"),
        ("M12", "beam C3 against its test"),
        ("M16", "beams B-1 to B-3, B1 and B2 as built, with their own weight, against their tests"),
    ],
    parts: &[Part::Tested(beams)],
};

/// A beam; lengths in m, stresses in Pa.
struct Beam {
    span: f64,
    width: f64,
    height: f64,
    /// E, f_c, f_t, G_f.
    concrete: [f64; 4],
    /// Area of all bars, height above the soffit, E, f_y.
    bars: Vec<[f64; 4]>,
}

/// Load P [kN] over deflection w [mm], and the strain of the upper fibre at mid-span.
struct Curve {
    points: Vec<[f64; 3]>,
    /// Whether the last target was reached.
    complete: bool,
}

impl Curve {
    /// P at the deflection w, NaN if the path did not get there.
    fn at(&self, w: f64) -> f64 {
        self.points.iter().find(|p| (p[0] - w).abs() < 1e-6).map_or(f64::NAN, |p| p[1])
    }

    /// P and w where the upper fibre reaches `strain`, between two points; else of the last one.
    fn ultimate(&self, strain: f64) -> [f64; 2] {
        let between = self.points.windows(2).find(|p| p[0][2] > strain && p[1][2] <= strain);
        match (between, self.points.last()) {
            (Some(p), _) => {
                let part = (p[0][2] - strain) / (p[0][2] - p[1][2]);
                [p[0][1] + part * (p[1][1] - p[0][1]), p[0][0] + part * (p[1][0] - p[0][0])]
            }
            (None, Some(p)) => [p[1], p[0]],
            (None, None) => [f64::NAN; 2],
        }
    }
}

fn law(source: LawError) -> ElementError {
    ElementError::Law { kind: "layered section", source }
}

/// E, f_c, f_t, G_f of a cylinder strength [MPa]: 21.5 (f_cm/10)^⅓ GPa of the Model Code, 0.33 √f_c, 73 f_cm^0.18.
fn of_strength(strength: f64) -> [f64; 4] {
    [21.5e9 * (0.1 * strength).cbrt(), 1e6 * strength, 0.33e6 * strength.sqrt(), 73.0 * strength.powf(0.18)]
}

impl Beam {
    /// B-3; its upper bars two inches below the top, which is not printed.
    fn b3() -> Beam {
        Beam {
            span: 6.40,
            width: 0.2286,
            height: 0.5525,
            concrete: [30e9, 38.8e6, 2.9e6, 140.0],
            bars: vec![[32.9e-4, 0.5525 - 0.461, 218e9, 555e6], [5.0e-4, 0.5525 - 0.051, 201e9, 345e6]],
        }
    }

    /// B-3 with the bars of the test, five No. 9 and two No. 4, instead of the areas that the dissertation prints.
    fn b3_as_built() -> Beam {
        let mut beam = Beam::b3();
        (beam.bars[0][0], beam.bars[1][0]) = (32.3e-4, 2.54e-4);
        beam
    }

    /// B1 of Vecchio & Shim: the bars of C3 in a width of 229 mm over 3.66 m.
    fn b1() -> Beam {
        Beam { span: 3.66, width: 0.229, concrete: of_strength(22.6), ..Beam::c3() }
    }

    /// B2 of Vecchio & Shim, recalled: B1 over 4.57 m with the concrete and the M25 bars of the second series.
    fn b2() -> Beam {
        let mut beam = Beam::b1();
        beam.span = 4.57;
        beam.concrete = of_strength(25.9);
        beam.bars[1][3] = 440e6;
        beam
    }

    /// B-1 and B-2 of Bresler & Scordelis, recalled: four No. 9 below, two No. 4 above, steels of B-3.
    fn short(span: f64, [width, height, depth]: [f64; 3], strength: f64) -> Beam {
        Beam {
            span,
            width,
            height,
            concrete: of_strength(strength),
            bars: vec![[25.8e-4, height - depth, 218e9, 555e6], [2.54e-4, height - 0.051, 201e9, 345e6]],
        }
    }

    /// The same beam whose concrete reaches this share of its cylinder strength.
    fn in_place(mut self, share: f64) -> Beam {
        self.concrete[1] *= share;
        self
    }

    /// Load at mid-span with the moment of the own weight, 25 kN/m³ [kN].
    fn weight(&self) -> f64 {
        25.0 * self.width * self.height * self.span / 2.0
    }

    fn c3() -> Beam {
        Beam {
            span: 6.40,
            width: 0.152,
            height: 0.552,
            // G_f of the fib Model Code 2010: 73 f_cm^0.18.
            concrete: [34.3e9, 43.5e6, 3.13e6, 73.0 * 43.5_f64.powf(0.18)],
            bars: vec![
                [1400e-6, 0.064, 200e9, 436e6],
                [1000e-6, 0.128, 200e9, 445e6],
                [300e-6, 0.552 - 0.050, 200e9, 315e6],
            ],
        }
    }

    fn section(&self, element: f64, layers: usize) -> Answer<Arc<dyn Section>> {
        let [young, f_c, f_t, fracture_energy] = self.concrete;
        let tension = Tension {
            strength: f_t,
            softening: Softening::Energy { fracture_energy, size: (element * self.width).sqrt() },
            stiffening: None,
            bond: None,
        };
        let concrete = CrackedConcrete::new(&CrackedParameters::new(young, 0.2, f_c, tension)).map_err(law)?;
        let ply = Ply { law: Arc::new(concrete), thickness: self.height, density: 0.0, rule: Rule::MidPoint(layers) };
        let bars: Vec<Bar> = self
            .bars
            .iter()
            .map(|&[area, height, young, yielding]| {
                Ok(Bar {
                    law: Arc::new(BarLaw::new(young, yielding, 0.0).map_err(law)?),
                    area: area / self.width,
                    depth: height - 0.5 * self.height,
                    angle: 0.0,
                    density: 0.0,
                })
            })
            .collect::<Answer<_>>()?;
        Ok(Arc::new(LayeredSection::new(&[ply], &bars)?))
    }

    /// Displacement control through the deflections `targets` [mm].
    fn curve(&self, elements: usize, layers: usize, targets: &[f64]) -> Answer<Curve> {
        let half = 0.5 * self.span;
        let section = self.section(half / elements as f64, layers)?;
        let grid = Grid::new(elements, 1);
        let mut builder = Builder::new();
        grid.nodes(&mut builder, |a, b| [half * a, self.width * b, 0.0]);
        let mut surface = grid.surface(&section);
        surface.axes = Axes::Along([1.0, 0.0, 0.0]);
        let placed = surface.place(&mut builder)?;
        hold(&mut builder, &grid.line_i(0), &[Dof::Ux, Dof::Ry]);
        hold(&mut builder, &grid.line_i(elements), &[Dof::Uz]);
        hold(&mut builder, &[grid.node(0, 0)], &[Dof::Uy]);
        let mut loads = NodalLoads::new();
        // Half of 1 kN on each half, shared by two nodes; no twist about the axis by symmetry.
        for node in grid.line_i(0) {
            loads.force(node, [0.0, 0.0, -250.0]);
        }
        let problem = Problem::new(builder, &loads)?;
        let criteria = Criteria { iterations: 40, ..Criteria::default() };
        let mut path = problem.continuation(criteria)?;
        let mut state = State::new(&problem.model);
        let row = problem.model.row(grid.node(0, 0), Dof::Uz);
        let down: Vec<f64> = targets.iter().map(|w| -1e-3 * w).collect();
        let length = StepLength { first: 0.25e-3, shortest: 0.25e-3 / 64.0, longest: 1e-3 };
        let mut points = vec![[0.0; 3]];
        let mut failed = None;
        let followed = path.to_displacements(&mut state, &row, &down, length, &Silent, |w, point, state| {
            match problem.sections(state, placed.elements[0]) {
                // Points 0 and 3 are nearest to mid-span.
                Ok(sections) => {
                    let strain = &sections[0].strain;
                    points.push([-1e3 * w, point.factor, strain[0] + 0.5 * self.height * strain[3]]);
                }
                Err(error) => failed = Some(error),
            }
        })?;
        match failed {
            Some(error) => Err(error),
            None => Ok(Curve { points, complete: followed.failure.is_none() }),
        }
    }
}

/// Upper fibre at the ultimate load.
const CRUSHING: f64 = -3.5e-3;

/// M10 and M11: beam B-3.
pub(super) fn b3(elements: usize, layers: usize) -> Answer {
    let mut case = Case {
        id: "M10",
        source: "fibre analysis of the section, ideally plastic concrete without tension",
        unit: "kN",
    };
    let targets: Vec<f64> = (1..=40).map(f64::from).collect();
    let curve = Beam::b3().curve(elements, layers, &targets)?;
    let mut rows = Vec::new();
    for (w, reference) in [(10.0, 130.7), (20.0, 259.1), (30.0, 376.4)] {
        // 3 % (sheet): the concrete in tension, which the fibre analysis leaves out, is worth 3 kN at 10 mm.
        let what = format!("B-3, load at {w} mm, {elements} elements, {layers} layers");
        rows.push(case.row(what, Reference::SecondFormulation, reference, curve.at(w), 0.03));
    }
    let [load, deflection] = curve.ultimate(CRUSHING);
    // Shown, not asserted (asked: 3 %, and 0.04 of the load factor). An element holds the moment of its middle: with 16 on half the
    // span 3.1 % less than at mid-span, so that the plastic load comes out so much too high.
    rows.push(case.row(
        format!("B-3, ultimate load, {elements} elements"),
        Reference::SecondFormulation,
        422.5,
        load,
        f64::INFINITY,
    ));
    case.unit = "";
    // Half a digit is 0.4 %, and the load, which is not printed, is read as 350 kN, within 1.4 % of the test.
    case.source =
        "dissertation 6.4.2, 1.21 over the share of the plastic moment that the middle of the last element holds";
    let middle = 1.0 - 0.5 / elements as f64;
    let what = format!("B-3, load factor on 350 kN, {elements} elements");
    let row = case.row(what, Reference::Dissertation, 1.21 / middle, load / 350.0, 0.018);
    rows.push(row.printed(1.21, "an element holds the moment of its middle"));
    (case.unit, case.id, case.source) = ("kN", "M11", "Bresler & Scordelis 1963, test, recalled");
    // Crushing under the load and shear with bending are not in a layer model, which is therefore stronger than the test.
    rows.push(case.row("B-3, ultimate load over the test", Reference::Experiment, 354.0, load, f64::INFINITY));
    case.unit = "mm";
    rows.push(case.row("B-3, deflection at the ultimate load", Reference::Experiment, 35.3, deflection, f64::INFINITY));
    if !curve.complete {
        rows.push(case.row(
            "B-3, deflection reached",
            Reference::ClosedForm,
            40.0,
            curve.points.len() as f64 - 1.0,
            1.0,
        ));
    }
    Ok(rows)
}

/// M10: ultimate load of B-3 on finer meshes, `elements` on half the span; the last but one is the model, all are its convergence.
pub(super) fn b3_refined(elements: &[usize], layers: usize) -> Answer {
    let case = Case {
        id: "M10",
        source: "fibre analysis of the section, ideally plastic concrete without tension",
        unit: "kN",
    };
    let targets: Vec<f64> = (1..=40).map(f64::from).collect();
    let mut found = Vec::new();
    for &n in elements {
        found.push((n, Beam::b3().curve(n, layers, &targets)?.ultimate(CRUSHING)[0]));
    }
    let reference = 422.5;
    // 3 % (sheet): half an element of 10 cm is 1.6 % of the lever to mid-span.
    let (n, load) = found[found.len().saturating_sub(2)];
    let row =
        case.row(format!("B-3, ultimate load, {n} elements"), Reference::SecondFormulation, reference, load, 0.03);
    Ok(vec![Row { convergence: found.iter().map(|&(n, p)| (n as f64, p / reference - 1.0)).collect(), ..row }])
}

/// M12: beam C3.
pub(super) fn c3(elements: usize, layers: usize) -> Answer {
    let case = Case { id: "M12", source: "Vecchio & Shim 2004, test", unit: "kN" };
    let targets: Vec<f64> = (1..=44).map(f64::from).collect();
    let curve = Beam::c3().curve(elements, layers, &targets)?;
    let mut rows = Vec::new();
    for (w, test) in
        [(2.0, 32.0), (6.0, 58.0), (10.0, 82.0), (14.0, 115.0), (20.0, 159.0), (26.0, 197.0), (30.0, 221.0)]
    {
        // Neither shear deformation nor slip of the bars is modelled: no theory sets a tolerance.
        rows.push(case.row(format!("C3, load at {w} mm"), Reference::Experiment, test, curve.at(w), f64::INFINITY));
    }
    let [load, _] = curve.ultimate(CRUSHING);
    // One test; the scatter of tests like it is not known.
    rows.push(case.row("C3, ultimate load", Reference::Experiment, 265.0, load, f64::INFINITY));
    Ok(rows)
}

/// k_3: strength of concrete in a member over that of its cylinders.
const IN_PLACE: f64 = 0.85;

/// M16: beams as built, less their own weight, on the converged mesh.
///
/// * as printed: the concrete is ideally plastic at the strength of its cylinders. 10 % for B1 of Vecchio & Shim, whose bars yield
///   first. Their B2 and the beams of Bresler & Scordelis are shown: their data are recalled, not read. Of the latter (555 MPa), at −3.5 ‰ above, their bars are at or below yield, so that the load
///   follows the stress block of the concrete;
/// * the concrete at 0.85 of its cylinders (Hognestad 1951: k_3 of members, for cylinders of 13 to 46 MPa): the computed reason of that
///   difference, shown with the same tolerances. A section analysis gives +9 % for B-3 and B-1 then, against +15 and +23 % as printed.
pub(super) fn as_built(elements: usize, layers: usize) -> Answer {
    let millimetres = |last: i32| (1..=last).map(f64::from).collect::<Vec<f64>>();
    let mut rows = Vec::new();
    let (old, new) = ("Bresler & Scordelis 1963, test, recalled", "Vecchio & Shim 2004, test");
    let recalled_new = "Vecchio & Shim 2004, test, recalled";
    let shown = f64::INFINITY;
    type Built = fn() -> Beam;
    let beams: [(&str, &'static str, Built, i32, f64, f64); 5] = [
        ("B-3", old, Beam::b3_as_built, 48, 354.0, shown),
        ("B1", new, Beam::b1, 30, 434.0, 0.10),
        ("B-1", old, || Beam::short(3.66, [0.2311, 0.5563, 0.461], 24.8), 30, 445.0, shown),
        ("B-2", old, || Beam::short(4.57, [0.2286, 0.5613, 0.4656], 23.2), 40, 400.0, shown),
        ("B2", recalled_new, Beam::b2, 40, 365.0, shown),
    ];
    for (share, how) in [(1.0, ""), (IN_PLACE, ", concrete at 0.85 f_c")] {
        for &(name, source, built, last, test, tolerance) in &beams {
            let case = Case { id: "M16", source, unit: "kN" };
            let beam = built().in_place(share);
            let [load, _] = beam.curve(elements, layers, &millimetres(last))?.ultimate(CRUSHING);
            rows.push(case.row(
                format!("{name} as built{how}, ultimate load less own weight, {elements} elements"),
                Reference::Experiment,
                test,
                load - beam.weight(),
                tolerance,
            ));
        }
    }
    Ok(rows)
}

fn beams() -> Answer {
    Ok([b3(16, 20)?, b3_refined(&[8, 16, 32, 64], 20)?, c3(16, 20)?, as_built(32, 20)?].concat())
}
