//! The wall of `concrete_strip` as a macro wall whose concrete cracks.
//!
//! Source:    dissertation, 8.4: liner, normal-only layer, reinforced concrete; sections by fibres
//! Model:     one element wide, layered shells (20 layers of cracking concrete, bars of 7 cm²/m at each face, liner), layer pressed only
//!            between their faces, 80 elements; hydrostatic pressure on the liner times a factor
//! Reference: the fibre section of the strips under the same moments, curvature integrated over the height, and Timoshenko's shear:
//!            no shells, no finite elements. Moments stay on the rising branch of the section: beyond its top, 76 kNm/m, cracks
//!            localise and the integral has no meaning
//! Tolerance: 1 %, set before the run: a shell element has one curvature, the mesh leaves 0.2 % (rows C9), the liner carries 1e-4

use std::sync::Arc;

use super::macro_wall::{layered, levels, plane_strain, press};
use super::wall::{CONCRETE, DEPTH, HEIGHT, LAYER, LINER, pressure};
use crate::{Answer, Failure, Reference, Row};
use fem::analysis::newton::{Criteria, Newton, load_path};
use fem::assembly::{Assembler, order};
use fem::dofs::Dof;
use fem::element::beam_section::FibreSection;
use fem::element::shell::layered::{Bar, LayeredSection, Ply};
use fem::element::shell::rule::Rule;
use fem::element::shell::section::ElasticSection;
use fem::element::solid8::Elastic;
use fem::element::wall::place::{Footprint, Leaf};
use fem::linalg::Symbolic;
use fem::model::Builder;
use fem::progress::Silent;
use fem::state::State;
use materials::bar::Bar as BarLaw;
use materials::concrete::{Compression, CrackedConcrete, CrackedParameters, Softening, Tension, UniaxialConcrete};

/// f_c, f_t [kN/m²] and softening strain.
const STRENGTHS: [f64; 2] = [35e3, 3.5e3];

const SOFTENING: f64 = 3e-4;

/// E, f_y [kN/m²], area [m²/m] of the bars of a face and their distance from the middle [m].
const BARS: [f64; 4] = [2.1e8, 5e5, 7e-4, 0.115];

/// Layers of the concrete.
const LAYERS: usize = 20;

fn tension() -> Tension {
    Tension {
        strength: STRENGTHS[1],
        softening: Softening::Strain { softening_strain: SOFTENING },
        stiffening: None,
        bond: None,
    }
}

/// Cracking concrete with bars up the wall.
fn concrete() -> Result<Leaf, Failure> {
    let [young, nu, thickness, _] = CONCRETE;
    let law = CrackedConcrete::new(&CrackedParameters::new(young, nu, STRENGTHS[0], tension()))?;
    let ply = Ply { law: Arc::new(law), thickness, density: 0.0, rule: Rule::MidPoint(LAYERS) };
    let mut bars = Vec::new();
    for depth in [-BARS[3], BARS[3]] {
        bars.push(Bar {
            law: Arc::new(BarLaw::new(BARS[0], BARS[1], 0.0)?),
            area: BARS[2],
            depth,
            angle: std::f64::consts::FRAC_PI_2,
            density: 0.0,
        });
    }
    Ok(Leaf { section: Arc::new(LayeredSection::new(&[ply], &bars)?), face: 0.5 * thickness })
}

/// Deflection of the top of the concrete [m] under the pressure times each factor.
fn macro_wall(factors: &[f64]) -> Result<Vec<f64>, Failure> {
    let z = levels(80)?;
    let footprint = Footprint::strip(0.0, &[0.0, 1.0], &z)?;
    let mut builder = Builder::new();
    let [young, nu, thickness, _] = LINER;
    let liner = Leaf { section: Arc::new(ElasticSection::new(young, nu, thickness, 0.0)?), face: 0.5 * thickness };
    let layer = Elastic::pressed_only(3e6, 0.0);
    let placed = layered(&mut builder, &footprint, [liner, concrete()?], LAYER, layer)?;
    plane_strain(&mut builder, &footprint, &placed);
    placed.hold(&mut builder, &footprint.levels[0], Dof::SHELL);
    let model = builder.build()?;
    let assembler = Assembler::new(&model);
    let symbolic = Arc::new(Symbolic::new(assembler.pattern().clone(), &order(&model, assembler.pattern()))?);
    let last = factors.last().copied().unwrap_or(0.0);
    let load: Vec<f64> = press(&model, &footprint, &placed, pressure).iter().map(|f| last * f).collect();
    let mut newton = Newton::new(&model, &assembler, &symbolic, None, Criteria::default())?;
    let mut state = State::new(&model);
    let top = placed.outer[footprint.levels[z.len() - 1][0]];
    let mut found = Vec::new();
    let (steps, none) = (40, vec![0.0; load.len()]);
    let path = load_path(&mut newton, &mut state, &none, &load, steps, &Silent, |share, state| {
        let [x, ..] = model.at_node(&state.committed.u, top);
        found.push([share * last, x]);
    })?;
    if let Some(failure) = path.failure {
        return Err(format!("the wall does not carry {last} times the pressure: {failure}").into());
    }
    // Committed steps lie closer than the curve bends: linear between them.
    let at = |factor: f64| {
        let i = found.iter().position(|p| p[0] >= factor * (1.0 - 1e-12)).unwrap_or(found.len() - 1);
        let (a, b) = (if i == 0 { [0.0; 2] } else { found[i - 1] }, found[i]);
        a[1] + (factor - a[0]) / (b[0] - a[0]) * (b[1] - a[1])
    };
    Ok(factors.iter().map(|&f| at(f)).collect())
}

/// The same by the section of fibres: ∫ κ(M(z)) (H − z) dz + ∫ V dz/(G A_s).
fn by_fibres(factor: f64) -> Result<f64, Failure> {
    let [young, nu, thickness, _] = CONCRETE;
    let compression = Compression::Plastic { strength: STRENGTHS[0] };
    let law = UniaxialConcrete::new(young / (1.0 - nu * nu), compression, Some(tension()))?;
    let section = FibreSection::new(0.0)?
        .rectangle(Arc::new(law), [1.0, thickness], 0.0, LAYERS)?
        .bars(Arc::new(BarLaw::new(BARS[0], BARS[1], 0.0)?), &[[-BARS[3], BARS[2]], [BARS[3], BARS[2]]])?;
    let curvatures: Vec<f64> = (1..=500).map(|i| 2.5e-6 * f64::from(i)).collect();
    let mut line = vec![[0.0; 2]];
    for point in section.moment_curvature(0.0, &curvatures)? {
        // The rising branch.
        if line.last().is_some_and(|p| point.moment > p[0]) {
            line.push([point.moment, point.curvature]);
        } else {
            break;
        }
    }
    let curvature = |m: f64| {
        let i = line.iter().position(|p| p[0] >= m);
        i.map_or(f64::NAN, |i| {
            if i == 0 {
                return 0.0;
            }
            let (a, b) = (line[i - 1], line[i]);
            a[1] + (m - a[0]) / (b[0] - a[0]) * (b[1] - a[1])
        })
    };
    let gamma = factor * pressure(0.0) / DEPTH;
    let n = 2000;
    let h = DEPTH / f64::from(n);
    let mut sum = 0.0;
    for i in 0..n {
        let z = (f64::from(i) + 0.5) * h;
        sum += h * curvature(gamma * (DEPTH - z).powi(3) / 6.0) * (HEIGHT - z);
    }
    let shear = 5.0 / 6.0 * young / (2.0 * (1.0 + nu)) * thickness;
    Ok(sum + gamma * DEPTH.powi(3) / (6.0 * shear))
}

/// Rows C13.
pub(super) fn rows() -> Answer {
    let factors = [1.0, 2.2, 2.45];
    let found = macro_wall(&factors)?;
    let mut rows = Vec::new();
    for (factor, found) in factors.into_iter().zip(found) {
        let moment = factor * pressure(0.0) * DEPTH * DEPTH / 6.0;
        rows.push(Row::new(
            "C13",
            format!("wall of liner, layer and cracking concrete, {moment:.1} kNm/m at its base: deflection of the top"),
            (
                1e3 * by_fibres(factor)?,
                "fibre section of the strips, curvature integrated",
                Reference::SecondFormulation,
            ),
            1e3 * found,
            (1e-2, "mm"),
        ));
    }
    Ok(rows)
}
