//! Checks of layers between shells.
//!
//! A layer that is stiff along its normal only has 20 modes without energy (24 less its four fibres); it is held by the
//! shells on both sides only. So every node of such an element must belong to a shell or beam.

use super::ElementError;
use crate::dofs::Dof;
use crate::model::Model;

/// Refuses a model in which a node of a layer that is stable only between shells belongs to no shell and no beam.
///
/// Errors: the node, with its element.
pub fn check(model: &Model) -> Result<(), ElementError> {
    let mut carried = vec![false; model.nodes().len()];
    for element in model.elements() {
        for (a, &node) in element.nodes().iter().enumerate() {
            if element.dofs(a).contains(&Dof::Rx) {
                carried[node] = true;
            }
        }
    }
    for (number, element) in model.elements().iter().enumerate() {
        if !element.contact().is_some_and(|layer| layer.only_between_shells()) {
            continue;
        }
        let held = |node: usize| Dof::TRANSLATIONS.iter().all(|&d| model.is_held(node, d));
        if let Some(&node) = element.nodes().iter().find(|&&n| !carried[n] && !held(n)) {
            return Err(ElementError::NoAnswer {
                kind: "interlayer",
                reason: format!(
                    "node {node} of layer element {number} belongs to no shell or beam: a layer with stiffness along its \
                     normal must lie between two shells"
                ),
            });
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::element::solid8::{Elastic, Kinematics, Solid8};
    use crate::model::Builder;
    use crate::shape::hex8::CORNERS;

    fn brick(material: Elastic) -> Model {
        let mut builder = Builder::new();
        let corners = CORNERS;
        builder.nodes(&corners);
        let nodes = std::array::from_fn(|a| a);
        builder.element("layer", Solid8::new(nodes, corners, material, Kinematics::Linear).unwrap());
        builder.build().unwrap()
    }

    #[test]
    fn a_free_layer_is_rejected() {
        assert!(check(&brick(Elastic::isotropic(1.0, 0.0, 0.0))).is_ok());
        let error = check(&brick(Elastic::normal_only(1.0, 0.0))).unwrap_err().to_string();
        assert!(error.contains("node 0") && error.contains("element 0"), "{error}");
        assert!(check(&brick(Elastic::core(1.0, 1.0, 0.0))).is_err());
    }
}
