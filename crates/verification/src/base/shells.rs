//! A strip of the bottom plate as shells on unilateral ground, lifted at its rim.
//!
//! Source:    beam on rigid ground; the strips of `base`
//! Model:     one row of MITC4 shells between planes of symmetry, large rotations; ground at the nodes (`fem::element::ground`); the edge
//!            of the wall as a matrix of the long cylinder; dead pressure; J2 in layers
//! Reference: closed forms; F(w) of `base::Strip`: beams with the membrane force of von Karman, fibres, ground in Gauss points
//! Tolerance: closed forms 1e-3 with a converged mesh; strips 1 % elastic, the rounding of the touch-down to nodes and shear of the
//!            plate, and θ²/12 of the slope θ = 2 w/l: beams of von Karman shorten by θ²/2, shells by 1 − cos θ (up to 1 % more, tank A at
//!            100 mm); yielding 4 %: plane strain of J2 is 2/√3 f_y only where the plastic strains are large, other hardening

use std::sync::Arc;

use ::base::{Lifted, Plan, Plate, Strip, closed};
use fem::analysis::continuation::{Constraint, Continuation, StepLength};
use fem::analysis::newton::Criteria;
use fem::assembly::{Assembler, order};
use fem::dofs::Dof;
use fem::element::ElementError;
use fem::element::ground::Ground;
use fem::element::shell::layered::{LayeredSection, Ply};
use fem::element::shell::load::NodalLoads;
use fem::element::shell::rule::Rule;
use fem::element::shell::section::{ElasticSection, Section};
use fem::element::shell::surface::{ShellCell, ShellSurface};
use fem::element::shell4::Axes;
use fem::element::super_element::SuperElement;
use fem::linalg::{Matrix, Symbolic};
use fem::model::Builder;
use fem::progress::Silent;
use fem::state::State;
use materials::von_mises::VonMises;

use super::{Sample, TANKS, failure};
use crate::benchmark::{Benchmark, Part};
use crate::{Answer, Failure, Reference, Row};

pub(crate) const BENCHMARK: Benchmark = Benchmark {
    id: "base-shells",
    title: "Strip of a bottom plate as shells on unilateral ground",
    model: "One row of shells from the rim to the centre between planes of symmetry, on ground that pushes but does not pull. It is the \
            finite-element counterpart of the strips that the fast engines use.",
    ids: &[
        ("U6", "closed forms on nearly rigid ground (k = 10¹³ N/m³), without the wall's edge"),
        ("U7", "hold-down force against uplift on k = 10⁸ N/m³, with the wall's edge: shells against strips"),
    ],
    parts: &[Part::Fast(closed_forms), Part::Tested(tanks)],
};

/// Width of the row of shells [m]; nothing depends on it.
const WIDTH: f64 = 0.1;

/// Reaches the residual of a set of few points.
pub(super) const CRITERIA: Criteria = Criteria { energy: 1e-12, force: 1e-6, iterations: 40 };

/// What holds the rim.
#[derive(Clone, Copy)]
enum Held<'a> {
    Hinged,
    Clamped,
    Wall(&'a Sample),
}

/// A row of shells.
struct Shells<'a> {
    /// Stations from the centre to the rim [m].
    stations: Vec<f64>,
    section: Arc<dyn Section>,
    modulus: f64,
    pressure: f64,
    /// Of wall and roof [N/m].
    weight: f64,
    held: Held<'a>,
}

impl Shells<'_> {
    /// Hold-down force [N/m] at uplifts of the rim [m].
    fn lift(&self, uplifts: &[f64]) -> Answer<Vec<f64>> {
        let mut builder = Builder::new();
        let mut dead = NodalLoads::new();
        let rows: Vec<[usize; 2]> =
            self.stations.iter().map(|&x| [-0.5, 0.5].map(|y| builder.node([x, y * WIDTH, 0.0]))).collect();
        let mut cells = Vec::new();
        for (x, pair) in self.stations.windows(2).zip(rows.windows(2)) {
            let nodes = [pair[0][0], pair[1][0], pair[1][1], pair[0][1]];
            let positions = nodes.map(|n| builder.position(n));
            dead.pressure(&nodes, &positions, |_| -self.pressure);
            for node in nodes {
                let area = 0.25 * (x[1] - x[0]) * WIDTH;
                builder.element("ground", Ground::new(node, self.modulus, area)?);
            }
            cells.push(ShellCell { nodes, section: self.section.clone(), group: "plate".into() });
        }
        let surface = ShellSurface { axes: Axes::Along([1.0, 0.0, 0.0]), ..ShellSurface::new(cells) };
        surface.place(&mut builder)?;
        for (i, &row) in rows.iter().enumerate() {
            let centre: &[Dof] = if i == 0 { &[Dof::Ux, Dof::Ry] } else { &[] };
            crate::shell::hold(&mut builder, &row, &[Dof::Uy, Dof::Rx]);
            crate::shell::hold(&mut builder, &row, centre);
        }
        let rim = rows[rows.len() - 1];
        match self.held {
            Held::Hinged => {}
            Held::Clamped => crate::shell::hold(&mut builder, &rim, &[Dof::Ry]),
            Held::Wall(tank) => {
                let (stiffness, free) = edge(tank);
                for node in rim {
                    let half = stiffness.map(|row| row.map(|k| 0.5 * WIDTH * k));
                    let matrix =
                        Matrix { rows: 2, cols: 2, data: vec![half[0][0], half[1][0], half[0][1], half[1][1]] };
                    let element = SuperElement::over(&[(node, Dof::Ux), (node, Dof::Ry)])?.with_stiffness(matrix)?;
                    builder.element("edge", element);
                    let force = half.map(|row| row[0] * free[0] + row[1] * free[1]);
                    dead.force(node, [force[0], 0.0, 0.0]);
                    dead.moment(node, [0.0, force[1], 0.0]);
                }
            }
        }
        let mut pull = NodalLoads::new();
        for node in rim {
            dead.force(node, [0.0, 0.0, -0.5 * WIDTH * self.weight]);
            pull.force(node, [0.0, 0.0, 0.5 * WIDTH]);
        }
        let model = builder.build()?;
        let assembler = Assembler::new(&model);
        let symbolic = Arc::new(Symbolic::new(assembler.pattern().clone(), &order(&model, assembler.pattern()))?);
        let (dead, pull) = (dead.vector(&model), pull.vector(&model));
        let none = vec![0.0; dead.len()];
        let mut state = State::new(&model);
        let mut rest = Continuation::new(&model, &assembler, &symbolic, &none, &dead, CRITERIA)?;
        for step in 1..=8 {
            rest.step(&mut state, &Constraint::Load(f64::from(step) / 8.0))
                .map_err(|e| Failure::from(format!("at rest, step {step}: {e}")))?;
        }
        let mut path = Continuation::new(&model, &assembler, &symbolic, &dead, &pull, CRITERIA)?;
        let lengths = StepLength { first: 1e-4, shortest: 1e-7, longest: 5e-3 };
        let mut forces = Vec::new();
        let row = model.row(rim[0], Dof::Uz);
        let followed = path.to_displacements(&mut state, &row, uplifts, lengths, &Silent, |_, point, _| {
            forces.push(point.factor - self.weight);
        })?;
        match followed.failure {
            Some(error) => Err(Failure::from(format!("after {forces:?} N/m: {error}"))),
            None => Ok(forces),
        }
    }
}

/// Stiffness of the edge of a long cylinder against (δ, δ′), and both without forces (Timoshenko & Woinowsky-Krieger 1959, art. 114).
fn edge(tank: &Sample) -> ([[f64; 2]; 2], [f64; 2]) {
    let plane = 1.0 - 0.3 * 0.3;
    let (r, s, e) = (tank.radius, tank.wall, tank.young_modulus);
    let beta = (3.0_f64 * plane).powf(0.25) / (r * s).sqrt();
    let d = e * s.powi(3) / (12.0 * plane);
    let membrane = r * r / (e * s);
    (
        [[4.0 * beta.powi(3) * d, 2.0 * beta * beta * d], [2.0 * beta * beta * d, 2.0 * beta * d]],
        [tank.pressure() * membrane, -tank.density * super::GRAVITY * membrane],
    )
}

/// Stations from the centre: from the rim elements of `first` over `fine`, then longer by `growth` up to a tenth of the length.
pub(super) fn stations(length: f64, first: f64, fine: f64, growth: f64) -> Vec<f64> {
    let mut from_rim = vec![0.0];
    let (mut x, mut h) = (0.0, first);
    while x < length {
        if x > fine {
            h = (h * growth).min(0.1 * length);
        }
        x += h;
        from_rim.push(x);
    }
    let scale = length / x;
    from_rim.iter().rev().map(|x| length - scale * x).collect()
}

fn law_failure(source: materials::LawError) -> Failure {
    ElementError::Law { kind: "layered section", source }.into()
}

fn closed_forms() -> Answer {
    let (young, nu, t) = (205e9, 0.3, 0.01);
    let plate = Plate { thickness: t, young_modulus: young, poisson_ratio: nu, yield_stress: None };
    // Low: rotations of 0.006 rad and a lifted length of 100 t, so that neither rotations nor shear count.
    let (pressure, length) = (1280.0, 1.0);
    let mut rows = Vec::new();
    for (name, held, expected) in [
        ("hinged", Held::Hinged, closed::hinged(&plate, pressure, length)),
        ("clamped", Held::Clamped, closed::clamped(&plate, pressure, length)),
    ] {
        let mut study = Vec::new();
        let mut finest = f64::NAN;
        for count in [12_u32, 24, 48, 96] {
            let shells = Shells {
                stations: (0..=count * 2).map(|i| 2.0 * f64::from(i) / f64::from(count * 2)).collect(),
                section: Arc::new(ElasticSection::new(young, nu, t, 0.0)?),
                modulus: 1e13,
                pressure,
                weight: 0.0,
                held,
            };
            finest = shells.lift(&[expected.uplift])?[0];
            study.push((f64::from(count), finest / expected.hold_down - 1.0));
        }
        let source = "beam on rigid ground with a line reaction at the touch-down";
        let row = Row::new(
            "U6",
            format!("hold-down force, rim {name}; elements over the lifted length"),
            (expected.hold_down, source, Reference::ClosedForm),
            finest,
            (1e-3, "N/m"),
        );
        rows.push(Row { convergence: study, ..row });
    }
    Ok(rows)
}

/// Uplifts [m].
const UPLIFTS: [f64; 5] = [1e-3, 10e-3, 20e-3, 50e-3, 100e-3];
const STRIPS: &str = "strip of `base`: beams of von Karman, fibres";

fn tanks() -> Answer {
    let mut rows = Vec::new();
    for tank in &TANKS {
        for yields in [false, true] {
            let (young, t) = (tank.young_modulus, tank.plate);
            let section: Arc<dyn Section> = if yields {
                // Hardening of a hundredth, kinematic as the fibres'.
                let law = VonMises::new(young, 0.3, tank.yield_stress, 0.01 * young, 1.0).map_err(law_failure)?;
                let ply = Ply { law: Arc::new(law), thickness: t, density: 0.0, rule: Rule::Gauss(9) };
                Arc::new(LayeredSection::new(&[ply], &[])?)
            } else {
                Arc::new(ElasticSection::new(young, 0.3, t, 0.0)?)
            };
            let shells = Shells {
                // A hinge is about a tenth of the lifted length long, of which 2 t are two elements and more.
                stations: stations(tank.radius, 1.5 * t, 80.0 * t, 1.15),
                section,
                modulus: 1e8,
                pressure: tank.pressure(),
                weight: tank.weight,
                held: Held::Wall(tank),
            };
            let found = shells.lift(&UPLIFTS)?;
            // Plane strain: J2 yields at 2/√3 f_y.
            let strip = Sample { yield_stress: tank.yield_stress * 2.0 / 3.0_f64.sqrt(), ..*tank };
            let strip: Strip = strip.strip(yields, 1e8, Plan::Strip).map_err(failure)?;
            let mut state = Lifted::at_rest(&strip, tank.weight).map_err(failure)?;
            let (kind, tolerance) = if yields { ("yielding", 0.04) } else { ("elastic", 0.01) };
            for (&uplift, force) in UPLIFTS.iter().zip(found) {
                state.lift_to(uplift).map_err(failure)?;
                let point = state.point();
                let slope = 2.0 * uplift / point.lifted_width.max(uplift);
                let rotation = if yields { 0.0 } else { slope * slope / 12.0 };
                rows.push(Row::new(
                    "U7",
                    format!("tank {}, {kind}: hold-down force at {} mm", tank.name, 1e3 * uplift),
                    (point.hold_down / 1e3, STRIPS, Reference::SecondFormulation),
                    force / 1e3,
                    (tolerance + rotation, "kN/m"),
                ));
            }
        }
    }
    Ok(rows)
}
