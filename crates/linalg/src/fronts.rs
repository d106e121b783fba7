//! Multifrontal LDLᵀ of a symmetric matrix of which the last unknowns may stay.
//!
//! ```text
//! front     columns of a supernode, with the rows below them: ⎡ F₁₁  ·  ⎤ ,  F = A's entries in these columns + Σ U of its children
//!                                                             ⎣ F₂₁ F₂₂ ⎦
//! F₁₁ = L D Lᵀ ,  Y = F₂₁ L⁻ᵀ D⁻¹ ,  U = F₂₂ − Y D Yᵀ               U goes to the front of the parent
//! ```
//!
//! What reaches the unknowns that stay is the Schur complement C = −B E⁻¹ Bᵀ of those eliminated. Pivots are taken in their order, so
//! that the matrix must be quasi-definite (Vanderbei 1995).
//!
//! Two bundles of subtrees of about the same cost go side by side, and large products within the fronts above them. Which thread does
//! a part changes none of its sums: the factor has the same bits for any number of threads.
//!
//! A factor that only guides an iteration can keep its numbers in single precision ([`Keep::Single`]): a solution reads each of them twice, and at
//! some ten million of them memory sets its time. All arithmetic is in double precision.
//!
//! Source: Duff & Reid 1983; Liu 1992 (multifrontal method).

mod dense;
mod sweep;
#[cfg(test)]
mod tests;
mod tree;

use std::sync::Arc;

use super::{LinalgError, Matrix, Pattern, Symbolic, Symmetric};
use dense::Desk;
use tree::{Node, Tree};

/// Precision in which a factor is kept.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Keep {
    /// As computed.
    Double,
    /// Rounded: relative error 6·10⁻⁸ of every entry.
    Single,
}

/// Columns of a supernode, `height` rows each: D on the diagonal, L below.
enum Panel {
    Double(Vec<f64>),
    Single(Vec<f32>),
}

/// The factor of a matrix whose first unknowns are eliminated in their order.
pub struct Fronts {
    tree: Arc<Tree>,
    keep: Keep,
    panels: Vec<Panel>,
    desks: [Desk; 2],
    ready: bool,
}

/// What a bundle of subtrees leaves: panels in the order of its nodes, and the U of those whose parents are above it.
type Bundle = (Vec<Panel>, Vec<(usize, Vec<f64>)>);

impl Fronts {
    /// For a pattern of which the first `eliminated` unknowns are eliminated.
    ///
    /// Errors: not enough memory.
    pub fn new(pattern: &Arc<Pattern>, eliminated: usize, keep: Keep) -> Result<Fronts, LinalgError> {
        let symbolic = Symbolic::supernodal(pattern.clone())?;
        Ok(Fronts {
            tree: Arc::new(Tree::new(&symbolic, eliminated)),
            keep,
            panels: Vec::new(),
            desks: Default::default(),
            ready: false,
        })
    }

    /// The same for another matrix on the pattern.
    pub fn another(&self) -> Fronts {
        Fronts { tree: self.tree.clone(), keep: self.keep, panels: Vec::new(), desks: Default::default(), ready: false }
    }

    /// Factors a matrix on the pattern on `threads` threads; returns the lower triangle of C. Its entries among the unknowns that stay are not read.
    ///
    /// Errors: a pivot that is zero or not finite; the factor is lost then.
    pub fn factor(&mut self, matrix: &Symmetric, threads: usize) -> Result<Matrix, LinalgError> {
        let Fronts { tree, keep, panels, desks, ready } = self;
        let (tree, keep, values) = (&**tree, *keep, &*matrix.values);
        *ready = false;
        // Fresh pages would cost more than a small front.
        let mut used = std::mem::take(panels);
        used.resize_with(tree.nodes.len(), || Panel::Double(Vec::new()));
        panels.resize_with(tree.nodes.len(), || Panel::Double(Vec::new()));
        let mut used_by = |members: &[usize]| -> Vec<Panel> {
            let take = |&k: &usize| std::mem::replace(&mut used[k], Panel::Double(Vec::new()));
            members.iter().map(take).collect()
        };
        let mut updates: Vec<Option<Vec<f64>>> = vec![None; tree.nodes.len()];
        let [first, second] = desks;
        let [left, right] = tree.bundles.each_ref().map(|members| (&members[..], used_by(members)));
        let bundles = match threads < 2 {
            true => [bundle(tree, left, values, keep, first)?, bundle(tree, right, values, keep, second)?],
            false => {
                let (own, other) = rayon::join(
                    || bundle(tree, left, values, keep, first),
                    || bundle(tree, right, values, keep, second),
                );
                [own?, other?]
            }
        };
        for (members, (made, leaves)) in tree.bundles.iter().zip(bundles) {
            members.iter().zip(made).for_each(|(&k, panel)| panels[k] = panel);
            leaves.into_iter().for_each(|(k, update)| updates[k] = Some(update));
        }
        for (&k, used) in tree.top.iter().zip(used_by(&tree.top)) {
            panels[k] = front(tree, k, values, (keep, used), &mut updates, first, threads)?;
        }
        let stay = tree.size - tree.eliminated;
        let mut c = Matrix::zeros(stay, stay);
        for (k, node) in tree.nodes.iter().enumerate().filter(|(_, n)| n.parent.is_none()) {
            if let Some(update) = updates[k].take() {
                node.add_to(&update, stay, &mut c.data);
                first.give(update);
            }
        }
        *ready = true;
        Ok(c)
    }

    /// Keeps the next factor in this precision.
    pub fn keep_as(&mut self, keep: Keep) {
        self.keep = keep;
    }

    /// The first unknown whose pivot is negative, if there is one.
    pub fn first_negative(&self) -> Option<usize> {
        let of = |(node, panel): (&Node, &Panel)| {
            let mut columns = (0..node.width).map(|j| j * (node.height() + 1)).enumerate();
            let negative = columns.find(|&(_, at)| match panel {
                Panel::Double(l) => l[at] < 0.0,
                Panel::Single(l) => l[at] < 0.0,
            });
            negative.map(|(j, _)| node.first + j)
        };
        self.tree.nodes.iter().zip(&self.panels).find_map(of)
    }

    /// Additions and multiplications of one factorisation.
    pub fn flops(&self) -> f64 {
        self.tree.nodes.iter().map(Node::flops).sum()
    }
}

/// The fronts of a bundle, from its leaves up.
fn bundle(
    tree: &Tree,
    (members, used): (&[usize], Vec<Panel>),
    values: &[f64],
    keep: Keep,
    desk: &mut Desk,
) -> Result<Bundle, LinalgError> {
    let mut updates: Vec<Option<Vec<f64>>> = vec![None; tree.nodes.len()];
    let made = members
        .iter()
        .zip(used)
        .map(|(&k, used)| front(tree, k, values, (keep, used), &mut updates, desk, 1))
        .collect::<Result<Vec<Panel>, LinalgError>>()?;
    let left = updates.into_iter().enumerate();
    Ok((made, left.filter_map(|(k, u)| u.map(|u| (k, u))).collect()))
}

/// Assembles the front of a supernode, eliminates its columns into the memory of a panel that was used, and leaves its U.
fn front(
    tree: &Tree,
    k: usize,
    values: &[f64],
    (keep, used): (Keep, Panel),
    updates: &mut [Option<Vec<f64>>],
    desk: &mut Desk,
    threads: usize,
) -> Result<Panel, LinalgError> {
    let node = &tree.nodes[k];
    let (width, height) = (node.width, node.height());
    let below = height - width;
    let (mut panel, mut rounded) = match used {
        Panel::Double(values) => (values, Vec::new()),
        Panel::Single(values) => (Vec::new(), values),
    };
    match keep {
        Keep::Single => panel = desk.take(width * height),
        Keep::Double => {
            panel.clear();
            panel.resize(width * height, 0.0);
        }
    }
    let mut update = desk.take(below * below);
    for &[from, to] in &tree.entries[node.entries.clone()] {
        panel[to as usize] = values[from as usize];
    }
    for &child in &node.children {
        if let Some(given) = updates[child].take() {
            tree.nodes[child].add_to_front(&given, [width, height], &mut panel, &mut update);
            desk.give(given);
        }
    }
    let regular = desk.eliminate(&mut panel, &mut update, [width, height], threads);
    updates[k] = Some(update);
    if !regular {
        return Err(LinalgError::Singular { size: tree.size });
    }
    Ok(match keep {
        Keep::Double => Panel::Double(panel),
        Keep::Single => {
            rounded.clear();
            rounded.extend(panel.iter().map(|x| *x as f32));
            desk.give(panel);
            Panel::Single(rounded)
        }
    })
}
