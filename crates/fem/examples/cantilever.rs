//! Uses the finite elements alone: a cantilever of bricks under a force at its tip.
//!
//!     cargo run -p fem --example cantilever

use std::error::Error;
use std::sync::Arc;

use fem::analysis::statics::Statics;
use fem::assembly::Assembler;
use fem::dofs::{Dof, KINDS};
use fem::element::solid8::{Elastic, Kinematics, Solid8};
use fem::linalg::{Kind, Ordering, Symbolic};
use fem::model::Builder;

/// Length and depth [m].
const LENGTH: f64 = 2.5;
const DEPTH: f64 = 0.1;
/// Young's modulus [Pa], density [kg/m³].
const MODULUS: f64 = 3.0e10;
const DENSITY: f64 = 2500.0;
/// Force at the tip [N].
const FORCE: f64 = 3000.0;

fn main() -> Result<(), Box<dyn Error>> {
    let inertia = DEPTH.powi(4) / 12.0;
    let beam = FORCE * LENGTH.powi(3) / (3.0 * MODULUS * inertia);
    println!("deflection of the beam P L³/(3 E I): {:.4} mm", 1e3 * beam);
    for bricks in [25, 50, 100, 200] {
        println!("{bricks:>4} bricks: {:.4} mm", 1e3 * deflection(bricks)?);
    }
    Ok(())
}

/// Deflection of the tip [m] of a row of bricks, clamped at one end, plane in x and z.
fn deflection(bricks: usize) -> Result<f64, Box<dyn Error>> {
    let mut builder = Builder::new();
    let h = 0.5 * DEPTH;
    for i in 0..=bricks {
        let x = LENGTH * i as f64 / bricks as f64;
        for [y, z] in [[-h, -h], [h, -h], [h, h], [-h, h]] {
            let node = builder.node([x, y, z]);
            builder.hold(node, Dof::Uy);
            if i == 0 {
                builder.hold(node, Dof::Ux);
                builder.hold(node, Dof::Uz);
            }
        }
    }
    for i in 0..bricks {
        let (a, b) = (4 * i, 4 * i + 4);
        let nodes = [a, b, b + 1, a + 1, a + 3, b + 3, b + 2, a + 2];
        let corners = nodes.map(|n| builder.position(n));
        let material = Elastic::isotropic(MODULUS, 0.0, DENSITY);
        builder.element("beam", Solid8::new(nodes, corners, material, Kinematics::Linear)?);
    }
    let model = builder.build()?;
    let assembler = Assembler::new(&model);
    let stiffness = assembler.stiffness(&model)?;
    let symbolic = Arc::new(Symbolic::new(assembler.pattern().clone(), &Ordering::MinimumDegree)?);
    let tip = 4 * bricks..4 * bricks + 4;
    let load = model.vector(|node| {
        let mut force = [0.0; KINDS];
        if tip.contains(&node) {
            force[Dof::Uz.index()] = 0.25 * FORCE;
        }
        force
    });
    let solution = Statics::new(&symbolic, &stiffness, Kind::Definite)?.solve(&stiffness, &[&load])?;
    let u = solution.first().ok_or("one load case has one solution")?;
    Ok(model.at_node(u, tip.start)[Dof::Uz.index()])
}
