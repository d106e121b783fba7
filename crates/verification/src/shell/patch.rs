//! S2: patch test.

use std::sync::Arc;

use super::{Answer, Case, surface};
use crate::{Benchmark, Part, Reference};
use fem::assembly::Assembler;
use fem::element::Inspect;
use fem::element::shell::section::{ElasticSection, Section};
use fem::element::shell4::{Axes, RESULTANTS};
use fem::linalg::Cholesky;
use fem::model::Builder;

/// The page.
pub(crate) const BENCHMARK: Benchmark = Benchmark {
    id: "shell-patch",
    title: "Shell: patch test",
    model: "Distorted patch of MacNeal & Harder 1985 under membrane and bending strains.",
    ids: &[("S2", "patch test: constant membrane and bending strains")],
    parts: &[Part::Fast(patch)],
};

/// S2: the patch of MacNeal & Harder with displacements given on its boundary.
pub(super) fn patch() -> Answer {
    // More than 80 lines: the patch with its coordinates and two states.
    let (thickness, scale) = (1e-3_f64, 1e-3);
    let section: Arc<dyn Section> = Arc::new(ElasticSection::new(1e6, 0.25, thickness, 0.0)?);
    let mut builder = Builder::new();
    let plan =
        [[0.0, 0.0], [0.24, 0.0], [0.24, 0.12], [0.0, 0.12], [0.04, 0.02], [0.18, 0.03], [0.16, 0.08], [0.08, 0.08]];
    plan.iter().for_each(|&[x, y]| {
        builder.node([x, y, 0.0]);
    });
    let cells = [[0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7], [4, 5, 6, 7]];
    let mut shell = surface(&cells, &section);
    shell.axes = Axes::Along([1.0, 0.0, 0.0]);
    let placed = shell.place(&mut builder)?;
    let model = builder.build()?;
    let assembler = Assembler::new(&model);
    let k = assembler.stiffness(&model)?.to_dense();
    let case = Case { id: "S2", source: "MacNeal & Harder 1985", unit: "N/m² and N" };
    let membrane = model.vector(|n| {
        let [x, y] = plan[n];
        [scale * (x + 0.5 * y), scale * (y + 0.5 * x), 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]
    });
    let bending = model.vector(|n| {
        let [x, y] = plan[n];
        let w = 0.5 * scale * (x * x + x * y + y * y);
        let (w_x, w_y) = (scale * (x + 0.5 * y), scale * (y + 0.5 * x));
        [0.0, 0.0, w, w_y, -w_x, 0.0, 0.0, 0.0, 0.0]
    });
    let mut rows = Vec::new();
    // m = −D (w,xx + ν w,yy): the director turns against the slope.
    let plate = 1e6 * thickness * thickness * thickness / (12.0 * (1.0 - 0.0625)) * scale;
    let expected = [
        (&membrane, 0, [4000.0 / 3.0, 4000.0 / 3.0, 400.0], thickness),
        (&bending, 3, [-1.25 * plate, -1.25 * plate, -0.375 * plate], 1.0),
    ];
    for (given, first, reference, divisor) in expected {
        let inner: Vec<usize> = (0..model.dofs().len()).filter(|&e| model.dofs().unknown(e).0 >= 4).collect();
        let outer: Vec<usize> = (0..model.dofs().len()).filter(|&e| model.dofs().unknown(e).0 < 4).collect();
        let boundary: Vec<f64> = outer.iter().map(|&e| given[e]).collect();
        let load: Vec<f64> = k.select(&inner, &outer).times(&boundary).iter().map(|f| -f).collect();
        let found = Cholesky::factor(&k.select(&inner, &inner))?.solve_vector(&load);
        let mut u = given.clone();
        inner.iter().zip(&found).for_each(|(&e, &v)| u[e] = v);
        for (i, reference) in reference.into_iter().enumerate() {
            let mut worst = reference;
            for &e in &placed.elements {
                let element = &*model.elements()[e];
                let local = fem::assembly::local_values(&model, element, &u);
                for sample in element.samples().iter().filter(|s| s.name == RESULTANTS[first + i]) {
                    let value = sample.row.iter().zip(&local).map(|(c, v)| c * v).sum::<f64>() / divisor;
                    if (value - reference).abs() > (worst - reference).abs() {
                        worst = value;
                    }
                }
            }
            let what = format!("{}, worst of all points", RESULTANTS[first + i]);
            // Exact up to rounding, which grows with the ratio of side to thickness (100) squared.
            rows.push(case.row(what, Reference::ClosedForm, reference, worst, 1e-9));
        }
    }
    Ok(rows)
}
