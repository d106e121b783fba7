//! Supernodes of a factor as a tree of fronts.

use std::ops::Range;

use faer::sparse::linalg::cholesky::SymbolicCholeskyRaw;

use crate::{Kind, Symbolic};

/// Shares of the work of a bundle at which subtrees are split no further.
const SPLIT: f64 = 0.05;

/// A supernode: the columns `first .. first + width`, and the rows below them.
pub(super) struct Node {
    pub(super) first: usize,
    pub(super) width: usize,
    /// Rows below its columns, ascending.
    pub(super) below: Vec<u32>,
    pub(super) parent: Option<usize>,
    pub(super) children: Vec<usize>,
    /// Places of the rows below in the parent's front, or among the unknowns that stay.
    places: Vec<u32>,
    /// Range of the matrix's entries in these columns, in [`Tree::entries`].
    pub(super) entries: Range<usize>,
}

/// The fronts of a factor; children stand before their parents.
pub(super) struct Tree {
    pub(super) size: usize,
    pub(super) eliminated: usize,
    pub(super) nodes: Vec<Node>,
    /// Place in the matrix and in the panel of its supernode.
    pub(super) entries: Vec<[u32; 2]>,
    /// Subtrees that go side by side, ascending.
    pub(super) bundles: [Vec<usize>; 2],
    /// The supernodes above them, ascending.
    pub(super) top: Vec<usize>,
}

impl Node {
    pub(super) fn height(&self) -> usize {
        self.width + self.below.len()
    }

    pub(super) fn flops(&self) -> f64 {
        (1..=self.width).map(|c| ((c + self.below.len()) as f64).powi(2)).sum()
    }

    /// Adds its U to a square matrix of `size` rows, lower triangle.
    pub(super) fn add_to(&self, update: &[f64], size: usize, to: &mut [f64]) {
        let count = self.below.len();
        for (c, &at) in self.places.iter().enumerate() {
            let column = &mut to[at as usize * size..][..size];
            for (&row, u) in self.places[c..].iter().zip(&update[c * count + c..]) {
                column[row as usize] += u;
            }
        }
    }

    /// Adds its U to the front of its parent, which has `width` columns of `height` rows.
    pub(super) fn add_to_front(
        &self,
        given: &[f64],
        [width, height]: [usize; 2],
        panel: &mut [f64],
        update: &mut [f64],
    ) {
        let (count, below) = (self.below.len(), height - width);
        for (c, &at) in self.places.iter().enumerate() {
            let at = at as usize;
            let values = &given[c * count + c..(c + 1) * count];
            let rows = &self.places[c..];
            if at < width {
                let column = &mut panel[at * height..][..height];
                rows.iter().zip(values).for_each(|(&row, u)| column[row as usize] += u);
            } else {
                let column = &mut update[(at - width) * below..][..below];
                rows.iter().zip(values).for_each(|(&row, u)| column[row as usize - width] += u);
            }
        }
    }
}

impl Tree {
    /// Tree of an analysis with supernodes throughout, whose order is that of the unknowns.
    pub(super) fn new(symbolic: &Symbolic, eliminated: usize) -> Tree {
        let pattern = symbolic.pattern();
        let size = pattern.size();
        let mut nodes = nodes(symbolic, eliminated);
        let mut of_column = vec![usize::MAX; eliminated];
        for (k, node) in nodes.iter().enumerate() {
            of_column[node.first..node.first + node.width].fill(k);
        }
        for k in 0..nodes.len() {
            let node = &nodes[k];
            let parent = node.below.first().and_then(|&row| of_column.get(row as usize).copied());
            let places: Vec<u32> = match parent {
                None => node.below.iter().map(|&row| row - eliminated as u32).collect(),
                Some(p) => {
                    let above = &nodes[p];
                    let mut rows = (above.first as u32..(above.first + above.width) as u32)
                        .chain(above.below.iter().copied())
                        .enumerate();
                    // Both lists ascend, and the parent's front has every row.
                    let place = |row: &u32| rows.find(|(_, other)| other == row).map_or(0, |(at, _)| at as u32);
                    node.below.iter().map(place).collect()
                }
            };
            nodes[k].places = places;
            nodes[k].parent = parent;
            if let Some(p) = parent {
                nodes[p].children.push(k);
            }
        }
        let mut entries = Vec::with_capacity(pattern.places());
        for node in &mut nodes {
            let start = entries.len();
            let height = node.height();
            for j in node.first..node.first + node.width {
                let column = (j - node.first) * height;
                let mut below = node.below.iter().enumerate();
                for place in pattern.starts[j]..pattern.starts[j + 1] {
                    let row = pattern.rows[place];
                    let at = match row < node.first + node.width {
                        true => row - node.first,
                        false => node.width + below.find(|(_, other)| **other == row as u32).map_or(0, |(at, _)| at),
                    };
                    entries.push([place as u32, (column + at) as u32]);
                }
            }
            node.entries = start..entries.len();
        }
        let (bundles, top) = bundles(&nodes);
        Tree { size, eliminated, nodes, entries, bundles, top }
    }
}

/// Supernodes of the unknowns that are eliminated; one that reaches beyond them is cut.
fn nodes(symbolic: &Symbolic, eliminated: usize) -> Vec<Node> {
    let analysis = symbolic.of_kind(Kind::QuasiDefinite);
    let Ok(SymbolicCholeskyRaw::Supernodal(s)) = analysis.map(|a| a.raw()) else {
        unreachable!("the analysis has supernodes");
    };
    (0..s.n_supernodes())
        .filter(|&k| s.supernode_begin()[k] < eliminated)
        .map(|k| {
            let (first, end) = (s.supernode_begin()[k], s.supernode_end()[k]);
            let last = end.min(eliminated);
            let rows = &s.row_idx()[s.col_ptr_for_row_idx()[k]..][..s.nnz_per_super()[k]];
            let mut below: Vec<u32> = (last..end).chain(rows.iter().copied()).map(|row| row as u32).collect();
            below.sort_unstable();
            Node {
                first,
                width: last - first,
                below,
                parent: None,
                children: Vec::new(),
                places: Vec::new(),
                entries: 0..0,
            }
        })
        .collect()
}

/// Two sets of subtrees of about the same cost, and what is above them.
fn bundles(nodes: &[Node]) -> ([Vec<usize>; 2], Vec<usize>) {
    let mut cost: Vec<f64> = nodes.iter().map(Node::flops).collect();
    for k in 0..nodes.len() {
        if let Some(p) = nodes[k].parent {
            cost[p] += cost[k];
        }
    }
    let total: f64 = nodes.iter().map(Node::flops).sum();
    let mut roots: Vec<usize> = (0..nodes.len()).filter(|&k| nodes[k].parent.is_none()).collect();
    let mut above = vec![false; nodes.len()];
    let largest = |roots: &[usize]| (0..roots.len()).max_by(|&a, &b| cost[roots[a]].total_cmp(&cost[roots[b]]));
    // From the roots down, until no subtree is a large share or the parts are even.
    while let Some(at) = largest(&roots) {
        let k = roots[at];
        let left: f64 = roots.iter().map(|&k| cost[k]).sum();
        if cost[k] <= SPLIT * total || (roots.len() > 1 && cost[k] <= 0.5 * left && even(&roots, &cost)) {
            break;
        }
        roots.swap_remove(at);
        above[k] = true;
        roots.extend(&nodes[k].children);
    }
    let mut sums = [0.0; 2];
    let mut bundle = vec![None; nodes.len()];
    roots.sort_unstable_by(|&a, &b| cost[b].total_cmp(&cost[a]).then(a.cmp(&b)));
    for &k in &roots {
        let to = usize::from(sums[1] < sums[0]);
        sums[to] += cost[k];
        bundle[k] = Some(to);
    }
    for k in (0..nodes.len()).rev() {
        if let (None, Some(p)) = (bundle[k], nodes[k].parent)
            && !above[k]
        {
            bundle[k] = bundle[p];
        }
    }
    let of = |wanted: Option<usize>| (0..nodes.len()).filter(|&k| bundle[k] == wanted).collect::<Vec<_>>();
    ([of(Some(0)), of(Some(1))], of(None))
}

/// Whether two bundles of these subtrees differ by a tenth at most.
fn even(roots: &[usize], cost: &[f64]) -> bool {
    let mut costs: Vec<f64> = roots.iter().map(|&k| cost[k]).collect();
    costs.sort_unstable_by(|a, b| b.total_cmp(a));
    let mut sums = [0.0; 2];
    for c in costs {
        sums[usize::from(sums[1] < sums[0])] += c;
    }
    (sums[0] - sums[1]).abs() <= 0.1 * (sums[0] + sums[1])
}
