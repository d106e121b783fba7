//! Global matrices and vectors from those of the elements: the pattern and every element's places are found once.

use std::ops::Range;
use std::sync::Arc;

mod matrices;
mod operators;
mod respond;
mod turn;

pub use operators::PlacedOperator;
pub(crate) use respond::{Apart, Ask};
pub use respond::{Forces, Kept, LinearPart};

use crate::dofs::Dof;
use crate::element::{Element, local_size};
use crate::linalg::{Ordering, Pattern};
use crate::model::Model;

/// Marks local dofs and entries that go nowhere.
const NONE: u32 = u32::MAX;

/// Models with at least this many elements are assembled in two halves: below it a thread costs more than it saves.
const HALVED: usize = 2000;

/// Pattern of a model's matrices and, element by element, the places of its entries.
pub struct Assembler {
    pattern: Arc<Pattern>,
    /// Equations of the local dofs (of the node's frame), element after element; [`NONE`] if held.
    equations: Vec<u32>,
    equation_starts: Vec<usize>,
    /// Places of the local entries of the lower triangle (by equation), element after element.
    places: Vec<u32>,
    place_starts: Vec<usize>,
    /// Elements with a node that has a frame.
    turned: Vec<bool>,
    /// Elements whose force is K u in components that do not turn with the nodes.
    linear: Vec<bool>,
    /// Elements that are operators.
    unassembled: Vec<bool>,
    /// Elements whose force is taken at the end of a time step; empty without any.
    at_end: Vec<bool>,
    /// Held dofs that some element uses, by node.
    supports: Vec<(usize, Dof)>,
    /// Number in `supports` of the local dofs, element after element; [`NONE`] if free.
    held: Vec<u32>,
    /// Places that both halves of the elements write to lie in this range.
    shared: Range<usize>,
}

impl Assembler {
    /// Finds pattern and places.
    pub fn new(model: &Model) -> Assembler {
        let dofs = model.dofs();
        let (mut equations, mut equation_starts) = (Vec::new(), vec![0]);
        let (mut turned, mut linear, mut held) = (Vec::new(), Vec::new(), Vec::new());
        let ends: Vec<bool> =
            model.elements().iter().map(|e| e.contact().is_some_and(|joint| joint.acts_at_end())).collect();
        let unassembled: Vec<bool> = model.elements().iter().map(|e| e.operator().is_some()).collect();
        let mut supports: Vec<(usize, Dof)> = Vec::new();
        let mut number = std::collections::BTreeMap::new();
        for element in model.elements() {
            let (mut any, mut fixed) = (false, element.is_linear());
            for (a, &node) in element.nodes().iter().enumerate() {
                let framed = model.frame(node).is_some() || model.rotation_frame(node).is_some();
                any |= framed && !element.own_axes();
                for &dof in element.dofs(a) {
                    let equation = dofs.equation(node, dof);
                    equations.push(equation.map_or(NONE, |e| e as u32));
                    held.push(match equation {
                        Some(_) => NONE,
                        None => *number.entry((node, dof)).or_insert_with(|| {
                            supports.push((node, dof));
                            supports.len() as u32 - 1
                        }),
                    });
                    fixed &= dof != Dof::Rx || model.rotation_frame(node).is_none() || element.own_axes();
                }
            }
            turned.push(any);
            linear.push(fixed);
            equation_starts.push(equations.len());
        }
        let pattern = pattern_of(dofs.len(), &equations, &equation_starts, &unassembled);
        let (places, place_starts) = places_of(&pattern, &equations, &equation_starts, &unassembled);
        let (first, second) = places.split_at(place_starts[(place_starts.len() - 1) / 2]);
        let end = first.iter().filter(|&&p| p != NONE).max().map_or(0, |&p| p as usize + 1);
        let start = second.iter().min().map_or(end, |&p| (p as usize).min(end));
        Assembler {
            pattern: Arc::new(pattern),
            equations,
            equation_starts,
            places,
            place_starts,
            turned,
            linear,
            unassembled,
            at_end: if ends.contains(&true) { ends } else { Vec::new() },
            supports,
            held,
            shared: start..end,
        }
    }

    /// Held dofs that some element uses, along the axes of their nodes.
    pub fn supports(&self) -> &[(usize, Dof)] {
        &self.supports
    }

    /// Whether some element's force is taken at the end of a time step.
    pub fn acts_at_end(&self) -> bool {
        !self.at_end.is_empty()
    }

    /// The pattern of all matrices of the model.
    pub fn pattern(&self) -> &Arc<Pattern> {
        &self.pattern
    }
}

/// Pattern of `size` equations whose elements use `equations`, those aside that are `unassembled`.
fn pattern_of(size: usize, equations: &[u32], starts: &[usize], unassembled: &[bool]) -> Pattern {
    let assembled = starts.windows(2).zip(unassembled).filter(|(_, operator)| !**operator);
    let cliques: Vec<Vec<usize>> = assembled
        .map(|(w, _)| {
            let own = &equations[w[0]..w[1]];
            let mut clique: Vec<usize> = own.iter().filter(|&&e| e != NONE).map(|&e| e as usize).collect();
            clique.sort_unstable();
            clique.dedup();
            clique
        })
        .collect();
    Pattern::from_cliques(size, cliques.iter().map(Vec::as_slice))
}

/// Places of the local entries of the lower triangle, with the start of each element's.
fn places_of(pattern: &Pattern, equations: &[u32], starts: &[usize], unassembled: &[bool]) -> (Vec<u32>, Vec<usize>) {
    let (mut places, mut place_starts) = (Vec::new(), vec![0]);
    for (w, operator) in starts.windows(2).zip(unassembled) {
        let own = if *operator { &[] } else { &equations[w[0]..w[1]] };
        for &j in own {
            for &i in own {
                let place = if i == NONE || j == NONE || i < j {
                    NONE
                } else {
                    let found = pattern.place(i as usize, j as usize);
                    found.expect("the pattern holds every element's entries") as u32
                };
                places.push(place);
            }
        }
        place_starts.push(places.len());
    }
    (places, place_starts)
}

/// Values of an element's dofs under the unknowns `u`, in the components of the element.
pub fn local_values(model: &Model, element: &dyn Element, u: &[f64]) -> Vec<f64> {
    let mut out = Vec::with_capacity(local_size(element));
    for (a, &node) in element.nodes().iter().enumerate() {
        let at = if element.own_axes() { model.own_at_node(u, node) } else { model.at_node(u, node) };
        out.extend(element.dofs(a).iter().map(|d| at[d.index()]));
    }
    out
}

/// Order of elimination for the matrices of a model: nested dissection by the positions of its nodes, or minimum degree if
/// that is cheaper.
pub fn order(model: &Model, pattern: &Pattern) -> Ordering {
    let dofs = model.dofs();
    let node_of: Vec<usize> = (0..dofs.len()).map(|e| dofs.unknown(e).0).collect();
    Ordering::best(pattern, &node_of, model.nodes())
}

#[cfg(test)]
mod tests;
