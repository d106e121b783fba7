//! Order of elimination of a cylinder.

use std::sync::Arc;

use fem::assembly::{Assembler, order};
use fem::dofs::DofMap;
use fem::element::Element;
use fem::linalg::{Ordering, Pattern, Symbolic};
use fem::model::Model;

use crate::FeError;
use crate::error::failed;

/// Order of elimination: the wall by nested dissection, then the amplitudes and the radial displacements that the liquid
/// joins; or minimum degree if that takes fewer operations.
pub(super) fn symbolic(model: &Model, assembler: &Assembler, liquid: usize) -> Result<Arc<Symbolic>, FeError> {
    let dofs = model.dofs();
    let element = &model.elements()[liquid];
    if element.operator().is_some() {
        let found = Symbolic::new(assembler.pattern().clone(), &order(model, assembler.pattern()));
        return Ok(Arc::new(found.map_err(failed)?));
    }
    let mut joined = vec![false; dofs.len()];
    equations(dofs, &**element).for_each(|e| joined[e] = true);
    let rest: Vec<usize> = (0..dofs.len()).filter(|&e| !joined[e]).collect();
    let mut place = vec![usize::MAX; dofs.len()];
    rest.iter().enumerate().for_each(|(k, &e)| place[e] = k);
    let others = model.elements().iter().enumerate().filter(|(e, _)| *e != liquid);
    let places = |e: usize| Some(place[e]).filter(|k| *k != usize::MAX);
    let cliques: Vec<Vec<usize>> =
        others.map(|(_, element)| equations(dofs, &**element).filter_map(places).collect()).collect();
    let pattern = Pattern::from_cliques(rest.len(), cliques.iter().map(Vec::as_slice));
    let node_of: Vec<usize> = rest.iter().map(|&e| dofs.unknown(e).0).collect();
    let given = match Ordering::best(&pattern, &node_of, model.nodes()) {
        Ordering::Given(order) => {
            let mut all: Vec<usize> = order.iter().map(|&k| rest[k]).collect();
            all.extend((0..dofs.len()).filter(|&e| joined[e]));
            Ordering::Given(all)
        }
        other => other,
    };
    let of = |ordering: &Ordering| Symbolic::new(assembler.pattern().clone(), ordering).map_err(failed);
    let (dissected, degree) = (of(&given)?, of(&Ordering::MinimumDegree)?);
    Ok(Arc::new(if degree.flops() < dissected.flops() { degree } else { dissected }))
}

/// Equations of the unknowns of an element, in its order.
fn equations<'a>(dofs: &'a DofMap, element: &'a dyn Element) -> impl Iterator<Item = usize> + 'a {
    let of = move |(local, &node): (usize, &'a usize)| {
        element.dofs(local).iter().filter_map(move |&dof| dofs.equation(node, dof))
    };
    element.nodes().iter().enumerate().flat_map(of)
}
