//! Solid and liquid cylinders of the measurements: r × θ × z bricks, R = 10 m, H = 20 m, held at the base.

use fem::chart::Chart;
use fem::dofs::Dof;
use fem::element::Potential8;
use fem::element::solid8::{Elastic, Kinematics, Solid8};
use fem::mesh::{Cylinder, Volume};
use fem::model::{Builder, Model};

fn volume([radial, sectors, levels]: [usize; 3]) -> Volume {
    let steps = |n: usize, length: f64| (0..=n).map(|i| length * i as f64 / n as f64).collect();
    let cylinder = Cylinder { radii: steps(radial, 10.0), sectors, heights: steps(levels, 20.0) };
    cylinder.volume().expect("the mesh is regular")
}

/// Concrete bricks, 3 unknowns a node (E = 30 GPa, ν = 0.2, ρ = 2500 kg/m³).
pub(crate) fn solid(bricks: [usize; 3]) -> Model {
    let mesh = volume(bricks);
    let mut builder = Builder::new();
    builder.nodes(&mesh.nodes);
    let material = Elastic::isotropic(30e9, 0.2, 2500.0);
    for cell in &mesh.cells {
        let corners = cell.nodes.map(|n| mesh.nodes[n]);
        let brick = Solid8::new(cell.nodes, corners, material, Kinematics::Linear).expect("the bricks are regular");
        builder.element("solid", brick);
    }
    for &node in &mesh.bottom_nodes {
        Dof::TRANSLATIONS.iter().for_each(|&dof| builder.hold(node, dof));
    }
    builder.build().expect("the model is complete")
}

/// Liquid with φ = 0 at the base, one unknown a node: its mass matrix is −ρ H.
pub(crate) fn scalar(bricks: [usize; 3]) -> Model {
    let mesh = volume(bricks);
    let mut builder = Builder::new();
    builder.nodes(&mesh.nodes);
    for cell in &mesh.cells {
        builder.element("liquid", Potential8::new(cell, Chart::Cylindrical, 1000.0).expect("the bricks are regular"));
    }
    for &node in &mesh.bottom_nodes {
        builder.hold(node, Dof::Phi);
    }
    builder.build().expect("the model is complete")
}
