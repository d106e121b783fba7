//! The wall element: two shells and a layer that adds no unknowns.
//!
//! Source:    dissertation, figure 8.9 (C9); sandwich beam after Plantema 1966 and Allen 1969
//! Model:     one element wide, MITC4 shells with the layer between their faces
//! Reference: C9: two beams on an elastic layer, Bernoulli's in closed form and Timoshenko's by exact beam elements.
//!            Sandwich of length L = π/k under q sin kz, faces A = E t, bending stiffness D_f of both together, distance d of
//!            their middles, core of thickness c and shear modulus G that is stiff along its normal:
//!            q/W = k⁴ [D_f + D_0/(1 + D_0 k²/S)],  D_0 = A d²/2,  S = G d²/c
//! Tolerance: the error that the refinement in the rows shows

use std::sync::Arc;

use super::solve;
use super::wall::{CONCRETE, DEPTH, HEIGHT, LAYER, LINER, Shear, TwoBeams, beams, pressure};
use crate::{Answer, Benchmark, Failure, Part, Reference, Row};
use fem::assembly::Assembler;
use fem::dofs::Dof;
use fem::element::shell::load::NodalLoads;
use fem::element::shell::section::{ElasticSection, Section, SectionResponse};
use fem::element::shell4::MassKind;
use fem::element::solid8::{Elastic, Kinematics};
use fem::element::wall::place::{Build, Footprint, Leaf, PlacedWall, WallMesh};
use fem::element::wall::{Layer, LayerMass};
use fem::element::{ElementError, interlayer};
use fem::mesh::grading;
use fem::model::{Builder, Model};

/// The page.
pub(crate) const BENCHMARK: Benchmark = Benchmark {
    id: "macro-wall",
    title: "Wall of two shells and a layer",
    model: "Strip one element wide: the wall of example 8.4 by its exact statics, sandwich beams, rigid \
            rotations.",
    ids: &[
        ("C9", "wall of two shells and a layer"),
        ("C13", "the same with concrete that cracks, beside the fibre section of the strips"),
    ],
    parts: &[Part::Fast(rows), Part::Fast(super::cracked_wall::rows)],
};

/// An elastic section whose shear stiffness is multiplied: a shell after Kirchhoff, to be compared with Bernoulli's beams.
/// A hundred times leaves 1e-4 of the shear deflection of the concrete (1 %) and 2e-3 of the moment at the liner's edge;
/// 10⁴ times leaves a residual of 1e-5 on the finest mesh.
pub(crate) struct StiffShear {
    section: ElasticSection,
    factor: f64,
}

impl StiffShear {
    pub(crate) fn new(section: ElasticSection, factor: f64) -> StiffShear {
        StiffShear { section, factor }
    }
}

impl Section for StiffShear {
    fn respond(
        &self,
        strain: &[f64; 8],
        old: &[f64],
        new: &mut [f64],
        out: &mut SectionResponse,
    ) -> Result<(), ElementError> {
        self.section.respond(strain, old, new, out)?;
        for i in 6..8 {
            out.resultants[i] *= self.factor;
            out.tangent[i].iter_mut().for_each(|c| *c *= self.factor);
        }
        Ok(())
    }

    fn inertia(&self) -> [f64; 3] {
        self.section.inertia()
    }

    fn shear_stiffness(&self) -> f64 {
        self.section.shear_stiffness()
    }
}

/// A leaf of E, ν, thickness.
fn leaf([e, nu, t]: [f64; 3], shear: Shear) -> Result<Leaf, Failure> {
    let section = ElasticSection::new(e, nu, t, 0.0)?;
    let section: Arc<dyn Section> = match shear {
        Shear::Flexible => Arc::new(section),
        Shear::Stiff => Arc::new(StiffShear::new(section, 100.0)),
    };
    Ok(Leaf { section, face: 0.5 * t })
}

/// A layered wall on a footprint.
pub(super) fn layered(
    builder: &mut Builder,
    footprint: &Footprint,
    leaves: [Leaf; 2],
    thickness: f64,
    material: Elastic,
) -> Result<PlacedWall, Failure> {
    let outer = leaves[0].face + thickness + leaves[1].face;
    let layer = Layer { material, kinematics: Kinematics::GreenLagrange, mass: LayerMass::Halves };
    let build = Build::Layered(leaves, layer);
    let mesh = WallMesh {
        footprint,
        courses: &|_| build.clone(),
        offsets: [0.0, outer],
        name: "wall",
        mass: MassKind::Consistent,
    };
    Ok(mesh.place(builder)?)
}

/// Plane strain of a strip in y, z: no displacement across, no rotation about z.
pub(super) fn plane_strain(builder: &mut Builder, footprint: &Footprint, placed: &PlacedWall) {
    for level in &footprint.levels {
        placed.hold(builder, level, &[Dof::Uy, Dof::Ry]);
    }
}

/// Forces of a pressure on the inner shell.
pub(super) fn press(model: &Model, footprint: &Footprint, placed: &PlacedWall, p: impl Fn(f64) -> f64) -> Vec<f64> {
    let mut loads = NodalLoads::new();
    for &cell in &footprint.cells {
        let nodes = placed.inner_cell(cell);
        let positions = nodes.map(|n| model.nodes()[n]);
        loads.pressure(&nodes, &positions, |x| p(x[2]));
    }
    loads.vector(model)
}

/// Levels graded 1:30 to the base, with one at the liquid's surface: the shortest decay length is 23 mm, the lowest element
/// 3 mm.
pub(super) fn levels(count: usize) -> Result<Vec<f64>, Failure> {
    let mut z = grading::geometric(0.0, DEPTH, count, 30.0)?;
    z.extend(grading::uniform(DEPTH, HEIGHT, 6)?.into_iter().skip(1));
    Ok(z)
}

/// Base moments of concrete and liner [kNm/m] and largest compression of the layer [m] of the wall of example 8.4.
fn example(e_normal: f64, count: usize, shear: Shear) -> Result<[f64; 3], Failure> {
    let z = levels(count)?;
    let footprint = Footprint::strip(0.0, &[0.0, 1.0], &z)?;
    let mut builder = Builder::new();
    let of = |[e, nu, t, _]: [f64; 4]| leaf([e, nu, t], shear);
    let placed =
        layered(&mut builder, &footprint, [of(LINER)?, of(CONCRETE)?], LAYER, Elastic::normal_only(e_normal, 0.0))?;
    plane_strain(&mut builder, &footprint, &placed);
    placed.hold(&mut builder, &footprint.levels[0], Dof::SHELL);
    let model = builder.build()?;
    interlayer::check(&model)?;
    let assembler = Assembler::new(&model);
    let u = solve(&model, &assembler, &press(&model, &footprint, &placed, pressure))?;
    let forces = assembler.nodal_forces(&model, &u, |_| true)?;
    let moment = |nodes: &[usize]| -> f64 { footprint.levels[0].iter().map(|&p| -forces[nodes[p]][4]).sum() };
    let gap = |p: usize| model.at_node(&u, placed.inner[p])[0] - model.at_node(&u, placed.outer[p])[0];
    let pressed = footprint.levels[..=count].iter().map(|l| gap(l[0])).fold(0.0, f64::max);
    Ok([moment(&placed.outer), moment(&placed.inner), pressed])
}

const NAMES: [&str; 3] = ["base moment of the concrete", "base moment of the liner", "compression of the layer"];

const UNITS: [&str; 3] = ["kNm/m", "kNm/m", "m"];

/// C9 with shells.
fn layered_wall() -> Answer {
    let mut rows = Vec::new();
    let counts = [40, 80, 160];
    for e_normal in [3e6, 3e4, 3e2] {
        let exact = TwoBeams::new(e_normal)?;
        let [concrete, liner] = exact.moments();
        let z = levels(160)?;
        let compression = z[..=160].iter().map(|&z| exact.difference(z, 0)).fold(0.0, f64::max);
        let stiff = [concrete, liner, compression];
        let flexible = beams(e_normal, 160, Shear::Flexible)?;
        for (shear, what, reference, source, kind) in [
            (Shear::Stiff, "shells stiff in shear", stiff, "two Bernoulli beams on a layer", Reference::ClosedForm),
            (
                Shear::Flexible,
                "shells",
                flexible,
                "two Timoshenko beams, 160 exact elements, and bricks",
                Reference::SecondFormulation,
            ),
        ] {
            let mut found = Vec::new();
            for count in counts {
                found.push(example(e_normal, count, shear)?);
            }
            for k in 0..3 {
                let mut row = Row::new(
                    "C9",
                    format!("{}, {what}, e_normal {e_normal:.0e} kN/m²", NAMES[k]),
                    (reference[k], source, kind),
                    found[2][k],
                    ([1e-3, 1e-2, 2e-3][k], UNITS[k]),
                );
                let error = |v: &[f64; 3]| v[k] / reference[k] - 1.0;
                row.convergence = counts.iter().zip(&found).map(|(n, v)| (*n as f64, error(v))).collect();
                rows.push(row);
            }
        }
    }
    Ok(rows)
}

/// Faces E, t; core c; length [N, m].
const FACE: [f64; 3] = [70e9, 0.0, 0.002];

const CORE: f64 = 0.05;

const SPAN: f64 = 1.0;

/// Largest pressure [Pa].
const PEAK: f64 = 1e4;

/// Deflection of the middle of the sandwich under q sin(π z/L).
fn sandwich(material: Elastic, elements: usize) -> Result<f64, Failure> {
    let z = grading::uniform(0.0, SPAN, elements)?;
    let footprint = Footprint::strip(0.0, &[0.0, 0.1], &z)?;
    let mut builder = Builder::new();
    // Thin faces: their own shear is 1e-5 of the bending.
    let face = leaf(FACE, Shear::Flexible)?;
    let placed = layered(&mut builder, &footprint, [face.clone(), face], CORE, material)?;
    plane_strain(&mut builder, &footprint, &placed);
    for end in [0, elements] {
        placed.hold(&mut builder, &footprint.levels[end], &[Dof::Ux]);
    }
    // By symmetry.
    placed.hold(&mut builder, &footprint.levels[elements / 2], &[Dof::Uz, Dof::Rx]);
    let model = builder.build()?;
    let assembler = Assembler::new(&model);
    let load = press(&model, &footprint, &placed, |z| PEAK * (std::f64::consts::PI * z / SPAN).sin());
    let u = solve(&model, &assembler, &load)?;
    Ok(model.at_node(&u, placed.outer[footprint.levels[elements / 2][0]])[0])
}

/// Composite action against the closed form of the sandwich, from no bond to a stiff one.
fn composite() -> Answer {
    let [e, _, t] = FACE;
    let (k, d) = (std::f64::consts::PI / SPAN, CORE + t);
    let (own, together) = (e * t.powi(3) / 6.0, 0.5 * e * t * d * d);
    let stiffness = |g: f64| {
        let share = if g == 0.0 { 0.0 } else { together / (1.0 + together * k * k / (g * d * d / CORE)) };
        k.powi(4) * (own + share)
    };
    let mut rows = Vec::new();
    // Normal stiffness as of the faces: the core's own shortening is 1e-6 of the deflection.
    for g in [0.0, 2e5, 2e6, 2e7, 2e8] {
        let material = if g == 0.0 { Elastic::normal_only(e, 0.0) } else { Elastic::core(e, g, 0.0) };
        let exact = PEAK / stiffness(g);
        let counts = [20, 40, 80];
        let mut errors = Vec::new();
        let mut last = 0.0;
        for count in counts {
            last = sandwich(material, count)?;
            errors.push((count as f64, last / exact - 1.0));
        }
        let what = if g == 0.0 {
            "sandwich beam without bond: E I adds".to_owned()
        } else {
            format!("sandwich beam, core G = {g:.0e} Pa")
        };
        let source = "q/W = k⁴ [D_f + D_0/(1 + D_0 k²/S)], Plantema 1966, Allen 1969";
        let mut row = Row::new(
            "C9",
            format!("{what}: deflection of the middle"),
            (exact, source, Reference::ClosedForm),
            last,
            // The bonded layer is a plain brick: it locks with S h²/(12 D_0), here 4e-3 for the stiffest core at h = L/80.
            (if g > 1e8 { 5e-3 } else { 2e-3 }, "m"),
        );
        row.convergence = errors;
        rows.push(row);
    }
    Ok(rows)
}

/// A ring of liner, stiff layer and wall under pressure: p R_I = w (E_I t_I/R_I + E_O t_O/R_O + E_p ln(r_2/r_1)) for ν = 0 and a layer that does
/// not shorten, from r_1 to r_2, with the modulus E_p in its plane.
fn ring(in_plane: f64) -> Result<Row, Failure> {
    let (radius, p) = (2.0, 1e4);
    let (inner, outer) = ([210e9, 0.0, 0.004], [30e9, 0.0, 0.05]);
    let gap = 0.5 * inner[2] + LAYER + 0.5 * outer[2];
    let face = radius + 0.5 * inner[2];
    let layer = in_plane * ((face + LAYER) / face).ln();
    let exact = p * radius / (inner[0] * inner[2] / radius + outer[0] * outer[2] / (radius + gap) + layer);
    let material = match in_plane {
        0.0 => Elastic::normal_only(1e15, 0.0),
        _ => Elastic::transverse([1e15, 0.5 * in_plane, in_plane], 0.0),
    };
    let counts = [12, 24, 48];
    let mut errors = Vec::new();
    let mut last = 0.0;
    for sectors in counts {
        let heights = [0.0, 0.25, 0.5];
        let footprint = Footprint::cylinder(radius, sectors, [0.0, std::f64::consts::TAU], &heights)?;
        let mut builder = Builder::new();
        let leaves = [leaf(inner, Shear::Flexible)?, leaf(outer, Shear::Flexible)?];
        let placed = layered(&mut builder, &footprint, leaves, LAYER, material)?;
        // Rigid displacements only: two opposite points on the y = 0 axis, one level.
        for level in &footprint.levels {
            placed.hold(&mut builder, level, &[Dof::Uz]);
        }
        for at in [0, sectors / 2] {
            placed.hold(&mut builder, &footprint.levels[0][at..=at], &[Dof::Uy]);
        }
        for at in [sectors / 4, 3 * sectors / 4] {
            placed.hold(&mut builder, &footprint.levels[0][at..=at], &[Dof::Ux]);
        }
        let model = builder.build()?;
        let assembler = Assembler::new(&model);
        let u = solve(&model, &assembler, &press(&model, &footprint, &placed, |_| p))?;
        last = model.at_node(&u, placed.outer[footprint.levels[1][0]])[0];
        errors.push((sectors as f64, last / exact - 1.0));
    }
    let what = match in_plane {
        0.0 => "cylinder of liner, stiff layer and wall under pressure: radial displacement".to_owned(),
        _ => format!("the same with E_p = {in_plane:.0e} Pa in the plane of the layer"),
    };
    let source = "p R_I = w (E_I t_I/R_I + E_O t_O/R_O + E_p ln(r_2/r_1))";
    let mut row = Row::new(
        "C9",
        what,
        (exact, source, Reference::ClosedForm),
        last,
        // A polygon of 48 sides: 1 − cos(π/48) = 0.2 % in the radius, twice in the displacement.
        (5e-3, "m"),
    );
    row.convergence = errors;
    Ok(row)
}

/// Rows of the wall element.
pub(super) fn rows() -> Answer {
    let mut rows = layered_wall()?;
    rows.extend(composite()?);
    rows.push(ring(0.0)?);
    // A quarter of the stiffness of liner and wall together, and a layer that carries more than both.
    rows.push(ring(5e9)?);
    rows.push(ring(5e10)?);
    Ok(rows)
}
