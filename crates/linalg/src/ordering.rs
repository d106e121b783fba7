//! Orders of elimination that keep the factor of a spatial model small.
//!
//! Nested dissection (George 1973): a separator S splits the graph into parts A and B without an edge between them; A
//! is eliminated first, B next, S last, and the parts are split in turn. The separators are found from the positions
//! of the nodes: for each of a few keys (x, y, z, x ± y, radius and angle about the z axis and about the vertical through the centre) the
//! graph is cut at five quantiles of the key; S is the smaller of the two layers of nodes that touch the cut. The
//! cheapest of all candidates by |S| (1 + 2 (b − 1/2)), b = larger part/both parts, is used.
//!
//! All unknowns of a node stay together: the graph is that of the nodes, its weights count their unknowns. If
//! positions describe the graph poorly, minimum degree may be better; [`Ordering::best`] compares both by the
//! operations of the factorisation, counted on the elimination tree (Liu 1990).

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::sparse::SymbolicSparseColMatRef;
use faer::sparse::linalg::amd;

use super::Pattern;

/// Parts of at most this many nodes are not split further.
const LEAF: usize = 24;
/// Cuts tried for each key, as quantiles.
const QUANTILES: [f64; 5] = [0.40, 0.45, 0.50, 0.55, 0.60];
/// Number of keys.
const KEYS: usize = 9;
/// Marks an absent entry.
const NONE: u32 = u32::MAX;

/// Order in which unknowns are eliminated: `order[k]` is the k-th.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Ordering {
    /// Minimum degree, on the matrix alone.
    MinimumDegree,
    /// A given order.
    Given(Vec<usize>),
}

/// The graph of the nodes that have unknowns.
struct Graph {
    /// Unknowns of each node.
    unknowns: Vec<Vec<usize>>,
    /// Neighbours of node i: `neighbours[starts[i]..starts[i + 1]]`, ascending.
    starts: Vec<usize>,
    neighbours: Vec<u32>,
    /// Positions.
    coordinates: Vec<[f64; 3]>,
}

impl Ordering {
    /// Nested dissection by position, or minimum degree on the nodes if that takes fewer operations.
    ///
    /// `node_of[e]` is the node of unknown e, `coordinates[node]` its position; positions need not be distinct.
    pub fn best(pattern: &Pattern, node_of: &[usize], coordinates: &[[f64; 3]]) -> Ordering {
        let graph = Graph::new(pattern, node_of, coordinates);
        let dissection = graph.dissect();
        let order = match graph.minimum_degree() {
            Some(degree) if graph.operations(&degree) < graph.operations(&dissection) => degree,
            _ => dissection,
        };
        Ordering::Given(graph.expand(&order))
    }

    /// Nested dissection by position; arguments as for [`Ordering::best`].
    pub fn dissection(pattern: &Pattern, node_of: &[usize], coordinates: &[[f64; 3]]) -> Ordering {
        let graph = Graph::new(pattern, node_of, coordinates);
        Ordering::Given(graph.expand(&graph.dissect()))
    }

    /// Minimum degree on the graph of the nodes; `None` if there is not enough memory.
    pub fn minimum_degree_of_nodes(pattern: &Pattern, node_of: &[usize]) -> Option<Ordering> {
        let nodes = node_of.iter().max().map_or(0, |m| m + 1);
        let graph = Graph::new(pattern, node_of, &vec![[0.0; 3]; nodes]);
        Some(Ordering::Given(graph.expand(&graph.minimum_degree()?)))
    }

    /// Whether `order` lists every unknown of 0 … size − 1 exactly once.
    pub fn is_bijection(order: &[usize], size: usize) -> bool {
        let mut seen = vec![false; size];
        order.len() == size && order.iter().all(|&i| i < size && !std::mem::replace(&mut seen[i], true))
    }
}

impl Graph {
    fn new(pattern: &Pattern, node_of: &[usize], coordinates: &[[f64; 3]]) -> Graph {
        let mut number = vec![NONE; coordinates.len()];
        let (mut unknowns, mut positions): (Vec<Vec<usize>>, Vec<[f64; 3]>) = (Vec::new(), Vec::new());
        for (e, &node) in node_of.iter().enumerate() {
            if number[node] == NONE {
                number[node] = unknowns.len() as u32;
                unknowns.push(Vec::new());
                positions.push(coordinates[node]);
            }
            unknowns[number[node] as usize].push(e);
        }
        // Edges once per pair of nodes: the rows of a node's columns, without repetition.
        let mut edges: Vec<(u32, u32)> = Vec::new();
        let mut seen = vec![NONE; unknowns.len()];
        for (i, own) in unknowns.iter().enumerate() {
            for &e in own {
                for &row in &pattern.rows[pattern.starts[e]..pattern.starts[e + 1]] {
                    let j = number[node_of[row]] as usize;
                    if j != i && seen[j] != i as u32 {
                        seen[j] = i as u32;
                        edges.push((i as u32, j as u32));
                        edges.push((j as u32, i as u32));
                    }
                }
            }
        }
        edges.sort_unstable();
        edges.dedup();
        let mut starts = vec![0; unknowns.len() + 1];
        for &(i, _) in &edges {
            starts[i as usize + 1] += 1;
        }
        for i in 0..unknowns.len() {
            starts[i + 1] += starts[i];
        }
        Graph { unknowns, starts, neighbours: edges.into_iter().map(|(_, j)| j).collect(), coordinates: positions }
    }

    fn len(&self) -> usize {
        self.unknowns.len()
    }

    fn neighbours(&self, i: usize) -> &[u32] {
        &self.neighbours[self.starts[i]..self.starts[i + 1]]
    }

    fn weight(&self, i: usize) -> usize {
        self.unknowns[i].len()
    }

    /// The unknowns, node by node.
    fn expand(&self, order: &[u32]) -> Vec<usize> {
        order.iter().flat_map(|&i| self.unknowns[i as usize].iter().copied()).collect()
    }

    /// Values of the keys at every node.
    fn keys(&self) -> Vec<[f64; KEYS]> {
        let n = self.len().max(1) as f64;
        let centre = [0, 1].map(|k| self.coordinates.iter().map(|c| c[k]).sum::<f64>() / n);
        let key = |&[x, y, z]: &[f64; 3]| {
            let (dx, dy) = (x - centre[0], y - centre[1]);
            [
                z,
                dx,
                dy,
                dx.hypot(dy),
                dx + dy,
                dx - dy,
                dy.atan2(dx),
                // Half of a round plate has its centre of mass off its axis.
                x.hypot(y),
                y.atan2(x),
            ]
        };
        let mut keys: Vec<[f64; KEYS]> = self.coordinates.iter().map(key).collect();
        // Nodes of one ring or meridian have one key: a cut between the last digits of its nodes would be a zigzag.
        for k in 0..KEYS {
            let largest = keys.iter().fold(0.0_f64, |m, own| m.max(own[k].abs()));
            if largest > 0.0 {
                keys.iter_mut().for_each(|own| own[k] = (own[k] / largest * 1e9).round());
            }
        }
        keys
    }

    /// Nested dissection: nodes in order of elimination.
    fn dissect(&self) -> Vec<u32> {
        let keys = self.keys();
        let mut order = vec![0; self.len()];
        let mut side = vec![Side::Outside; self.len()];
        // Parts still to be numbered, with their range of numbers.
        let mut open: Vec<(Vec<u32>, usize)> = vec![((0..self.len() as u32).collect(), 0)];
        while let Some((part, first)) = open.pop() {
            let split = if part.len() > LEAF { self.separate(&keys, &part, &mut side) } else { None };
            match split {
                Some([a, b, separator]) => {
                    let middle = first + a.len();
                    let last = middle + b.len();
                    order[last..last + separator.len()].copy_from_slice(&separator);
                    open.push((a, first));
                    open.push((b, middle));
                }
                None => order[first..first + part.len()].copy_from_slice(&part),
            }
        }
        order
    }

    /// Parts and separator of the cheapest cut; `None` if no key separates the nodes.
    fn separate(&self, keys: &[[f64; KEYS]], part: &[u32], side: &mut [Side]) -> Option<[Vec<u32>; 3]> {
        let mut best: Option<(f64, usize, f64, bool)> = None;
        let mut values: Vec<f64> = Vec::with_capacity(part.len());
        let total: usize = part.iter().map(|&i| self.weight(i as usize)).sum();
        for key in 0..KEYS {
            values.clear();
            values.extend(part.iter().map(|&i| keys[i as usize][key]));
            values.sort_unstable_by(f64::total_cmp);
            let mut last = f64::NAN;
            for q in QUANTILES {
                let cut = values[(q * part.len() as f64) as usize];
                // Equal keys stay on one side: a cut at the smallest value has an empty lower part.
                if cut == last || cut <= values[0] {
                    continue;
                }
                last = cut;
                for &i in part {
                    side[i as usize] = if keys[i as usize][key] < cut { Side::Below } else { Side::Above };
                }
                let (mut below, mut layers) = (0, [0, 0]);
                for &i in part {
                    let (own, weight) = (side[i as usize], self.weight(i as usize));
                    below += if own == Side::Below { weight } else { 0 };
                    if self.touches(i as usize, own.other(), side) {
                        layers[usize::from(own == Side::Above)] += weight;
                    }
                }
                for (k, &layer) in layers.iter().enumerate() {
                    let parts =
                        [below - if k == 0 { layer } else { 0 }, total - below - if k == 1 { layer } else { 0 }];
                    let larger = parts[0].max(parts[1]);
                    if parts[0] == 0 || parts[1] == 0 {
                        continue;
                    }
                    let balance = larger as f64 / (parts[0] + parts[1]) as f64;
                    let cost = layer as f64 * (1.0 + 2.0 * (balance - 0.5));
                    if best.is_none_or(|(least, ..)| cost < least) {
                        best = Some((cost, key, cut, k == 1));
                    }
                }
            }
        }
        let result = best.map(|(_, key, cut, above)| {
            for &i in part {
                side[i as usize] = if keys[i as usize][key] < cut { Side::Below } else { Side::Above };
            }
            let layer = if above { Side::Above } else { Side::Below };
            let mut out = [Vec::new(), Vec::new(), Vec::new()];
            for &i in part {
                let own = side[i as usize];
                let k = if own == layer && self.touches(i as usize, own.other(), side) {
                    2
                } else {
                    usize::from(own == Side::Above)
                };
                out[k].push(i);
            }
            out
        });
        for &i in part {
            side[i as usize] = Side::Outside;
        }
        result
    }

    fn touches(&self, i: usize, other: Side, side: &[Side]) -> bool {
        self.neighbours(i).iter().any(|&j| side[j as usize] == other)
    }

    /// Approximate minimum degree on the nodes.
    fn minimum_degree(&self) -> Option<Vec<u32>> {
        let n = self.len();
        let (mut starts, mut rows) = (vec![0], Vec::with_capacity(self.neighbours.len() / 2));
        for j in 0..n {
            rows.extend(self.neighbours(j).iter().map(|&i| i as usize).filter(|&i| i < j));
            starts.push(rows.len());
        }
        let view = SymbolicSparseColMatRef::new_checked(n, n, &starts, None, &rows);
        let (mut order, mut inverse) = (vec![0usize; n], vec![0usize; n]);
        let mut buffer = MemBuffer::try_new(amd::order_maybe_unsorted_scratch::<usize>(n, rows.len())).ok()?;
        amd::order_maybe_unsorted(&mut order, &mut inverse, view, Default::default(), MemStack::new(&mut buffer))
            .ok()?;
        Some(order.into_iter().map(|i| i as u32).collect())
    }

    /// Multiplications of the factorisation in this order: Σ over columns of (entries below the diagonal)²/2.
    fn operations(&self, order: &[u32]) -> f64 {
        let n = self.len();
        let mut position = vec![0u32; n];
        for (k, &i) in order.iter().enumerate() {
            position[i as usize] = k as u32;
        }
        // Row i of the factor is the part of the elimination tree between the columns of row i of the matrix and i.
        let (mut parent, mut ancestor, mut seen) = (vec![NONE; n], vec![NONE; n], vec![NONE; n]);
        let mut below = vec![0usize; n];
        for i in 0..n {
            let node = order[i] as usize;
            for &neighbour in self.neighbours(node) {
                // Path compression finds the root of the neighbour's subtree so far.
                let mut k = position[neighbour as usize];
                while k < i as u32 {
                    let next = ancestor[k as usize];
                    ancestor[k as usize] = i as u32;
                    if next == NONE {
                        parent[k as usize] = i as u32;
                        break;
                    }
                    k = next;
                }
            }
            seen[i] = i as u32;
            let weight = self.weight(node);
            for &neighbour in self.neighbours(node) {
                let mut k = position[neighbour as usize];
                while k < i as u32 && seen[k as usize] != i as u32 {
                    seen[k as usize] = i as u32;
                    below[k as usize] += weight;
                    k = parent[k as usize];
                }
            }
        }
        let column = |(k, &i): (usize, &u32)| {
            (0..self.weight(i as usize)).map(|later| 0.5 * ((below[k] + later) as f64).powi(2)).sum::<f64>()
        };
        order.iter().enumerate().map(column).sum()
    }
}

/// Side of a cut on which a node lies.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Side {
    Outside,
    Below,
    Above,
}

impl Side {
    fn other(self) -> Side {
        match self {
            Side::Below => Side::Above,
            Side::Above => Side::Below,
            Side::Outside => Side::Outside,
        }
    }
}
