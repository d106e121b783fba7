//! S6: twisted beam.

use std::f64::consts::FRAC_PI_2;
use std::sync::Arc;

use nalgebra::Vector3;

use super::{Answer, Case, Grid, hold, solve};
use crate::{Benchmark, Part, Reference};
use fem::dofs::Dof;
use fem::element::shell::load::NodalLoads;
use fem::element::shell::section::{ElasticSection, Section};
use fem::element::shell::surface::Normals;
use fem::model::Builder;

/// The page.
pub(crate) const BENCHMARK: Benchmark = Benchmark {
    id: "shell-twisted-beam",
    title: "Shell: twisted beam",
    model: "Strip twisted by 90°, L = 12, b = 1.1, unit force at the tip in and out of plane (MacNeal & Harder \
            1985).",
    ids: &[("S6", "twisted beam, thick and thin")],
    parts: &[Part::Fast(twisted_beam)],
};

/// S6: beam twisted by 90 degrees, clamped at one end, loaded at the other, thick and thin.
pub(super) fn twisted_beam() -> Answer {
    let (length, breadth) = (12.0, 1.1);
    let mut rows = Vec::new();
    // (thickness, load, displacement along the load: in plane, out of plane; prototype on 12 × 2 and 24 × 4)
    let thick = (0.32, 1.0, [5.424e-3, 1.754e-3], [[0.995, 0.984], [0.997, 0.995]]);
    let thin = (0.0032, 1e-6, [5.256e-3, 1.294e-3], [[0.986, 0.981], [0.995, 0.995]]);
    for (thickness, load, reference, prototype) in [thick, thin] {
        for (direction, name) in ["in plane", "out of plane"].into_iter().enumerate() {
            let mut values = Vec::new();
            for n in [12_usize, 24] {
                let section: Arc<dyn Section> = Arc::new(ElasticSection::new(29e6, 0.22, thickness, 0.0)?);
                let grid = Grid::new(n, n / 6);
                let mut builder = Builder::new();
                let turn = |x: f64| FRAC_PI_2 * x / length;
                grid.nodes(&mut builder, |a, b| {
                    let (s, c) = turn(length * a).sin_cos();
                    [length * a, breadth * (b - 0.5) * c, breadth * (b - 0.5) * s]
                });
                let nodes: Vec<(usize, usize)> = (0..=n / 6).flat_map(|j| (0..=n).map(move |i| (i, j))).collect();
                // Helicoid x = (x, η cos φ, η sin φ): normal x,x × x,η.
                let normal = |_: usize, node: usize| {
                    let (i, j) = nodes[node];
                    let eta = breadth * (j as f64 / (n / 6) as f64 - 0.5);
                    let (s, c) = turn(length * i as f64 / n as f64).sin_cos();
                    let twist = FRAC_PI_2 / length * eta;
                    Vector3::new(1.0, -twist * s, twist * c).cross(&Vector3::new(0.0, c, s))
                };
                let mut shell = grid.surface(&section);
                shell.normals = Normals::Exact(&normal);
                let placed = shell.place(&mut builder)?;
                hold(&mut builder, &grid.line_i(0), Dof::SHELL);
                // The tip's breadth lies along z.
                let along = [Vector3::z(), Vector3::y()][direction];
                let mut loads = NodalLoads::new();
                for pair in grid.line_i(n).windows(2) {
                    let edge = [pair[0], pair[1]];
                    let positions = edge.map(|e| builder.position(e));
                    loads.edge_force(edge, positions, |_| (along * (load / breadth)).into());
                }
                let solution = solve(builder, placed, &loads, [0.0; 3])?;
                values.push((n, along.dot(&solution.displacement(grid.node(n, n / 12)))));
            }
            let case = Case { id: "S6", source: "MacNeal & Harder 1985; thin: Simo, Fox & Rifai 1989", unit: "in" };
            let prototype = [(12, prototype[0][direction]), (24, prototype[1][direction])];
            let what = format!("{name}, t {thickness}");
            // 24 × 4 within 1 %, 12 × 2 within 3 % (sheet): error of second order, four times larger on the half mesh.
            rows.extend(case.study(&what, reference[direction], 0.01, &values, &prototype, 0.005));
            let coarse = format!("{what}, 12 elements");
            rows.push(case.row(coarse, Reference::Published, reference[direction], values[0].1, 0.03));
        }
    }
    Ok(rows)
}
