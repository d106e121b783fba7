//! Our side of the scripts in benches/peers: writes the systems that peers solve, and times ours.
//!
//! `solver_peers factor FOLDER [NAME...]` writes matrices as raw binary files, factors and solves them, and prints one JSON line each.
//! `solver_peers modes FILE` writes the brick model with lumped masses as text, finds its 20 lowest modes, and prints them.
//! `solver_peers assembly` prints bricks per second.

use std::error::Error;
use std::fmt::Write as _;
use std::io::Write as _;
use std::sync::Arc;
use std::time::Instant;

use fem::assembly::{Assembler, order};
use fem::dofs::Dof;
use fem::linalg::{Kind, Matrix, Ordering, Search, Sparse, Symbolic, Symmetric, modes};

#[path = "../benches/models/mod.rs"]
mod models;

/// Time of all threads on the processor so far [s], in steps of 10 ms; wall time where the system does not provide it.
fn processor_time(start: Instant) -> f64 {
    let told = std::fs::read_to_string("/proc/self/stat").ok();
    let ticks = told.and_then(|s| {
        let mut fields = s.rsplit_once(')')?.1.split_whitespace().skip(11);
        Some(fields.next()?.parse::<f64>().ok()? + fields.next()?.parse::<f64>().ok()?)
    });
    ticks.map_or_else(|| start.elapsed().as_secs_f64(), |t| 0.01 * t)
}

/// Median processor time of `runs` runs [s]; a run is repeated until it takes long enough to measure.
fn median(runs: usize, mut work: impl FnMut()) -> f64 {
    let start = Instant::now();
    let mut times: Vec<f64> = (0..runs)
        .map(|_| {
            let (before, mut repeats) = (processor_time(start), 0.0);
            loop {
                work();
                repeats += 1.0;
                let took = processor_time(start) - before;
                if took > 0.25 {
                    break took / repeats;
                }
            }
        })
        .collect();
    times.sort_by(f64::total_cmp);
    times[runs / 2]
}

/// n, number of places, starts, rows (64-bit integers), values: the lower triangle column by column.
fn write_raw(path: &std::path::Path, a: &Symmetric) -> std::io::Result<()> {
    let mut file = std::io::BufWriter::new(std::fs::File::create(path)?);
    for v in [a.size(), a.pattern.places()].iter().chain(&a.pattern.starts).chain(&a.pattern.rows) {
        file.write_all(&(*v as i64).to_le_bytes())?;
    }
    for v in &a.values {
        file.write_all(&v.to_le_bytes())?;
    }
    file.flush()
}

fn factor(folder: &str, names: &[&str]) -> Result<(), Box<dyn Error>> {
    std::fs::create_dir_all(folder)?;
    let cases = [
        ("scalar-12x16x20", [12, 16, 20], true),
        ("scalar-24x32x40", [24, 32, 40], true),
        ("scalar-36x48x60", [36, 48, 60], true),
        ("solid-8x12x14", [8, 12, 14], false),
        ("solid-12x16x20", [12, 16, 20], false),
        ("solid-18x24x30", [18, 24, 30], false),
        ("solid-24x32x40", [24, 32, 40], false),
    ];
    for (name, bricks, scalar) in cases {
        if !names.is_empty() && !names.contains(&name) {
            continue;
        }
        let model = if scalar { models::scalar(bricks) } else { models::solid(bricks) };
        let assembler = Assembler::new(&model);
        let matrix = if scalar {
            let mut h = assembler.mass(&model);
            h.values.iter_mut().for_each(|v| *v = -*v);
            h
        } else {
            assembler.stiffness(&model)?
        };
        write_raw(&std::path::Path::new(folder).join(format!("{name}.raw")), &matrix)?;
        let n = matrix.size();
        let runs = if n > 50_000 { 3 } else { 7 };
        let pattern = assembler.pattern().clone();
        let mut ordering = Ordering::MinimumDegree;
        let t_order = median(1, || ordering = order(&model, &pattern));
        let mut symbolic = None;
        let t_symbolic = median(1, || symbolic = Some(Symbolic::new(pattern.clone(), &ordering)));
        let symbolic = Arc::new(symbolic.ok_or("one run")??);
        let degree = Symbolic::new(pattern.clone(), &Ordering::MinimumDegree)?;
        let mut factor = symbolic.factor(&matrix, Kind::Definite)?;
        let mut fault = None;
        let t_factor = median(runs, || fault = factor.refactor(&matrix).err().or(fault.take()));
        let mut right = Matrix::zeros(n, 8);
        for (i, v) in right.data.iter_mut().enumerate() {
            *v = ((i * 7919) % 101) as f64 - 50.0;
        }
        let one = Matrix { rows: n, cols: 1, data: right.column(0).to_vec() };
        let mut x = one.clone();
        let t_solve = median(runs, || {
            x = one.clone();
            fault = factor.solve(&mut x).err().or(fault.take());
        });
        let t_eight = median(runs, || fault = factor.solve(&mut right).err().or(fault.take()));
        if let Some(fault) = fault {
            return Err(fault.into());
        }
        let mut rest = one.data.clone();
        matrix.add_product(-1.0, x.column(0), &mut rest);
        let norm = |v: &[f64]| v.iter().map(|v| v * v).sum::<f64>().sqrt();
        println!(
            "{{\"name\":\"{name}\",\"n\":{n},\"order\":{t_order:.4},\"symbolic\":{t_symbolic:.4},\"factor\":{t_factor:.5},\
             \"solve\":{t_solve:.6},\"solve8\":{t_eight:.6},\"entries\":{},\"gflop\":{:.3},\"gflop_degree\":{:.3},\
             \"residual\":{:.2e},\"sum\":{:.12e}}}",
            symbolic.entries(),
            1e-9 * symbolic.flops(),
            1e-9 * degree.flops(),
            norm(&rest) / norm(&one.data),
            x.data.iter().sum::<f64>(),
        );
    }
    Ok(())
}

fn find_modes(path: &str) -> Result<(), Box<dyn Error>> {
    let start = Instant::now();
    let model = models::solid([12, 16, 20]);
    let assembler = Assembler::new(&model);
    let (k, consistent) = assembler.stiffness_and_mass(&model)?;
    // Row sums as nodal masses, so that the peer can be given the same ones.
    let unknowns = k.size();
    let ones: Vec<Vec<f64>> = [Dof::Ux, Dof::Uy, Dof::Uz]
        .iter()
        .map(|d| model.vector(|_| std::array::from_fn(|i| f64::from(u8::from(i == d.index())))))
        .collect();
    let mut lumped = Symmetric::zeros(k.pattern.clone());
    for one in &ones {
        let row = consistent.times(one);
        for e in 0..unknowns {
            lumped.values[k.pattern.starts[e]] += row[e] * one[e];
        }
    }
    let symbolic = Arc::new(Symbolic::new(k.pattern.clone(), &order(&model, &k.pattern))?);
    let found = modes(&Sparse::new(&k, &lumped, symbolic), &Search::lowest(20))?;
    println!(
        "{{\"seconds\":{:.4},\"unknowns\":{unknowns},\"products\":{},\"residual\":{:.2e},\"omega\":{:?}}}",
        processor_time(start),
        found.products,
        found.residual.iter().copied().fold(0.0, f64::max),
        found.omega()
    );
    let mut text = String::new();
    for (node, p) in model.nodes().iter().enumerate() {
        let mass = model.dofs().equation(node, Dof::Ux).map_or(0.0, |e| lumped.get(e, e));
        writeln!(text, "node {} {:e} {:e} {:e} {mass:.16e}", node + 1, p[0], p[1], p[2])?;
    }
    for element in model.elements() {
        let nodes: Vec<String> = element.nodes().iter().map(|n| (n + 1).to_string()).collect();
        writeln!(text, "brick {}", nodes.join(" "))?;
    }
    std::fs::write(path, text)?;
    Ok(())
}

fn assembly() -> Result<(), Box<dyn Error>> {
    let model = models::solid([24, 32, 40]);
    let count = model.elements().len() as f64;
    let start = Instant::now();
    let pattern = median(3, || drop(Assembler::new(&model)));
    let assembler = Assembler::new(&model);
    let mut fault = None;
    let wall = Instant::now();
    let runs = 7;
    let both = median(runs, || fault = assembler.stiffness_and_mass(&model).err().or(fault.take()));
    let wall = wall.elapsed().as_secs_f64() / runs as f64;
    if let Some(fault) = fault {
        return Err(fault.into());
    }
    println!(
        "{{\"bricks\":{count},\"bricks_per_processor_second\":{:.0},\"bricks_per_second\":{:.0},\"pattern\":{pattern:.3},\"total\":{:.2}}}",
        count / both,
        count / wall,
        processor_time(start)
    );
    Ok(())
}

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        ["factor", folder, ref names @ ..] => factor(folder, names),
        ["modes", path] => find_modes(path),
        ["assembly"] => assembly(),
        _ => Err("usage: solver_peers factor FOLDER [NAME...] | modes FILE | assembly".into()),
    }
}
