//! Linear systems of a model of which only a zone changes from iteration to iteration.
//!
//! ```text
//! A = ⎡ E  Bᵀ ⎤      E: unknowns that no element of the zone uses, with the elements that are not assembled (liquid)
//!     ⎣ B  S  ⎦      S: unknowns of the elements of the zone (bottom plate, ground)
//! S + C          C = −B E⁻¹ Bᵀ, on the unknowns of the zone that E touches
//! ```
//!
//! E is factored and C formed rarely, S + C whenever iterations become slow: what the ground does costs a factor of the zone. The liquid of
//! a wall is dense in E: n²/2 entries and n³/3 operations over n wetted nodes. With such elements E is therefore its mean over all turns (`sections`), one
//! small factor for each harmonic, and a solution is guided by the factors: a minimal-residual iteration with products of the matrix itself takes one of them
//! where the wall is round and elastic, and up to ten where it yields at one side.
//!
//! # Newton's method with an E that is kept
//!
//! Let F be the residual of a step, B(u) = A_E⁰ + A_S(u) with the tangent A_E⁰ of an earlier state outside of the zone and an element A_S(u) of
//! the generalised Jacobian of the forces of the zone at u; every slow iteration is followed by a new one. The forces are piecewise smooth, so
//! that F(u) = V(u) (u − u*) + o(|u − u*|), V(u) = A_E(u) + A_S(u) (semi-smoothness, Qi & Sun 1993), and with e = u − u*
//!
//! ```text
//! e⁺ = e − B⁻¹ F = B⁻¹ (A_E⁰ − A_E(u)) e + o(|e|)
//! |e⁺|_B ≤ δ |e|_B + o(|e|) ,   δ = max |xᵀ (A_E⁰ − A_E) x| / xᵀ A_E⁰ x     where A_E⁰ > 0 and A_S ≥ 0
//! ```
//!
//! since B ≥ A_E⁰. The rate is that of the tangent outside of the zone and does not depend on the set of pressed points: a set that changes in
//! every iteration does not disturb it, because A_S is that of the present set. Where few points change, as in most steps, an earlier A_S serves as well,
//! and an iteration that shows that it does not makes way for the present one. A factor kept as a whole has no such bound: (A_S⁰ − A_S) is of
//! the size of the ground's stiffness, a thousand times what remains where a point opens. δ is small, since A_E⁰ contains the inertia of the liquid
//! (w_M M exceeds the stiffness of the wall a hundred times at steps of some milliseconds); where the wall outside of the zone
//! yields, iterations become slow and E is factored anew.
//!
//! Source: Qi & Sun 1993 (semi-smooth Newton); Przemieniecki 1963 (substructures).

mod sections;
pub mod solver;

use std::sync::Arc;

use super::AnalysisError;
use super::failed;
use super::rings::Without;
use crate::assembly::{Assembler, PlacedOperator};
use crate::linalg::{Fronts, Keep, LinalgError, Ordering, Pattern, Symmetric};
use crate::model::Model;
use sections::Sections;

/// Marks unknowns that are not in a part.
const NONE: u32 = u32::MAX;
const WHAT: &str = "the tangent with its zone";

/// Which unknowns and entries belong to the zone, and where they are in its two factors.
pub struct Zone {
    /// Elements of the zone.
    elements: Vec<bool>,
    /// Unknowns outside, and of the zone.
    sizes: [usize; 2],
    outside: Outside,
    /// Position of each equation in the zone.
    inner_of: Vec<u32>,
    inner: Arc<Pattern>,
    /// Places in the model's pattern and in that of the zone.
    inner_places: Vec<[u32; 2]>,
    /// Positions in the zone of the unknowns that the outside touches, in the order of C, and the places of C's lower triangle, column by column.
    touched: Vec<u32>,
    border: Vec<u32>,
}

/// Unknowns that are not of the zone.
enum Outside {
    /// As they are.
    Dissected(Dissected),
    /// With the elements that are not assembled, by harmonics.
    Harmonic(Box<Sections>),
}

/// Unknowns outside in the order of their elimination, then those of the zone that they touch.
struct Dissected {
    /// Position of each equation.
    of: Vec<u32>,
    /// Number of those eliminated.
    size: usize,
    pattern: Arc<Pattern>,
    /// Places in the model's pattern and in this one.
    places: Vec<[u32; 2]>,
}

/// The same elements are the same zone of a model.
impl PartialEq for Zone {
    fn eq(&self, other: &Zone) -> bool {
        self.elements == other.elements && self.sizes == other.sizes
    }
}

impl std::fmt::Debug for Zone {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let count = self.elements.iter().filter(|own| **own).count();
        f.debug_struct("Zone").field("elements", &count).field("sizes", &self.sizes).finish()
    }
}

/// Unknowns with and without `flag`, ascending.
fn split(flag: &[bool]) -> [Vec<usize>; 2] {
    let of = |wanted: bool| (0..flag.len()).filter(|&e| flag[e] == wanted).collect();
    [of(true), of(false)]
}

/// Places of a pattern given by pairs (row, column), row ≥ column, and by cliques of ascending unknowns.
fn pattern_of(size: usize, pairs: impl Iterator<Item = (usize, usize)>, cliques: &[Vec<usize>]) -> Pattern {
    let mut columns: Vec<Vec<usize>> = (0..size).map(|j| vec![j]).collect();
    pairs.for_each(|(i, j)| columns[j].push(i));
    for clique in cliques {
        for (k, &j) in clique.iter().enumerate() {
            columns[j].extend_from_slice(&clique[k + 1..]);
        }
    }
    let (mut starts, mut rows) = (vec![0], Vec::new());
    for mut column in columns {
        column.sort_unstable();
        column.dedup();
        rows.extend(column);
        starts.push(rows.len());
    }
    Pattern { starts, rows }
}

/// Unknowns of a part by dissection at the places of their nodes.
fn dissected(model: &Model, pattern: &Arc<Pattern>, part: &[usize]) -> Vec<usize> {
    let mut unknowns = part.to_vec();
    unknowns.sort_unstable();
    let own = Symmetric::zeros(pattern.clone()).submatrix(&unknowns);
    let node_of: Vec<usize> = unknowns.iter().map(|&e| model.dofs().unknown(e).0).collect();
    match Ordering::dissection(&own.pattern, &node_of, model.nodes()) {
        Ordering::Given(order) => order.iter().map(|&k| unknowns[k]).collect(),
        Ordering::MinimumDegree => unknowns,
    }
}

/// Positions of two unknowns in a part, the larger one first.
fn pair(of: &[u32], i: usize, j: usize) -> Option<(usize, usize)> {
    let (a, b) = (of[i], of[j]);
    (a != NONE && b != NONE).then(|| (a.max(b) as usize, a.min(b) as usize))
}

/// Shows row, column and place of every entry of a pattern.
fn entries(pattern: &Pattern, mut see: impl FnMut(usize, usize, usize)) {
    for j in 0..pattern.size() {
        (pattern.starts[j]..pattern.starts[j + 1]).for_each(|p| see(pattern.rows[p], j, p));
    }
}

/// Position of each of `size` equations in an order.
fn numbered(order: &[usize], size: usize) -> Vec<u32> {
    let mut of = vec![NONE; size];
    order.iter().enumerate().for_each(|(k, &e)| of[e] = k as u32);
    of
}

/// The flagged unknowns in the best order of their elimination.
fn apart(model: &Model, pattern: &Arc<Pattern>, flag: &[bool]) -> Vec<usize> {
    let [part, _] = split(flag);
    let own = Symmetric::zeros(pattern.clone()).submatrix(&part);
    let node_of: Vec<usize> = part.iter().map(|&e| model.dofs().unknown(e).0).collect();
    match Ordering::best(&own.pattern, &node_of, model.nodes()) {
        Ordering::Given(order) => order.iter().map(|&k| part[k]).collect(),
        Ordering::MinimumDegree => part,
    }
}

/// Elements and unknowns of the zone of the elements `own`, and of nonlinear elements all of whose unknowns are theirs.
fn members(model: &Model, own: impl Fn(usize) -> bool) -> (Vec<bool>, Vec<bool>) {
    let dofs = model.dofs();
    let unknowns = |e: usize| {
        let element = &model.elements()[e];
        let nodes = element.nodes().iter().enumerate();
        nodes.flat_map(move |(a, &node)| element.dofs(a).iter().filter_map(move |&d| dofs.equation(node, d)))
    };
    let count = model.elements().len();
    let mut inside = vec![false; dofs.len()];
    (0..count).filter(|&e| own(e)).flat_map(unknowns).for_each(|q| inside[q] = true);
    let within = |e: usize| {
        let element = &model.elements()[e];
        !element.is_linear() && element.operator().is_none() && unknowns(e).all(|q| inside[q])
    };
    let elements = (0..count).map(|e| own(e) || within(e)).collect();
    (elements, inside)
}

/// Unknowns of the zone that the outside touches.
fn seams(inside: &[bool], pattern: &Pattern, operators: &[PlacedOperator<'_>]) -> Vec<bool> {
    let mut touched = vec![false; inside.len()];
    entries(pattern, |i, j, _| {
        if inside[i] != inside[j] {
            touched[if inside[i] { i } else { j }] = true;
        }
    });
    for placed in operators {
        for q in (0..placed.operator.size()).filter_map(|k| placed.equation(k)) {
            touched[q] |= inside[q];
        }
    }
    touched
}

impl Dissected {
    fn new(model: &Model, pattern: &Arc<Pattern>, Without { inside, touched }: Without<'_>) -> Dissected {
        let free: Vec<bool> = inside.iter().map(|inside| !inside).collect();
        let mut order = apart(model, pattern, &free);
        let size = order.len();
        order.extend((0..inside.len()).filter(|&e| touched[e]));
        let of = numbered(&order, inside.len());
        // Entries of the zone are not those of the outside.
        let is_outer = |i: usize, j: usize| !(inside[i] && inside[j]);
        let mut pairs = Vec::new();
        entries(pattern, |i, j, _| {
            if is_outer(i, j) {
                pairs.extend(pair(&of, i, j));
            }
        });
        let own = Arc::new(pattern_of(order.len(), pairs.into_iter(), &[(size..order.len()).collect()]));
        let mut places = Vec::new();
        entries(pattern, |i, j, p| {
            if is_outer(i, j) {
                places.extend(place(&own, pair(&of, i, j)).map(|to| [p as u32, to]));
            }
        });
        Dissected { of, size, pattern: own, places }
    }
}

/// Positions of the unknowns of the zone and its pattern, in the order of fewer operations of two. What the outside touches comes last in
/// both: it need not have a pivot of its own.
///
/// Errors: not enough memory.
fn inner_part(
    model: &Model,
    pattern: &Arc<Pattern>,
    inside: &[bool],
    touched: &[bool],
) -> Result<(Vec<u32>, Arc<Pattern>), AnalysisError> {
    let size = inside.len();
    let border = (0..size).filter(|&e| touched[e]);
    let flag: Vec<bool> = inside.iter().zip(touched).map(|(inside, touched)| *inside && !touched).collect();
    let interior = apart(model, pattern, &flag);
    let mut choice: Option<(f64, Vec<u32>, Arc<Pattern>)> = None;
    for order in [interior.clone(), dissected(model, pattern, &interior)] {
        let order: Vec<usize> = order.into_iter().chain(border.clone()).collect();
        let of = numbered(&order, size);
        let mut pairs = Vec::new();
        entries(pattern, |i, j, _| {
            if inside[i] && inside[j] {
                pairs.extend(pair(&of, i, j));
            }
        });
        let last = border.clone().map(|e| of[e] as usize).collect();
        let places = Arc::new(pattern_of(order.len(), pairs.into_iter(), &[last]));
        let fronts = Fronts::new(&places, order.len(), Keep::Double).map_err(failed(WHAT))?;
        let flops = fronts.flops();
        if choice.as_ref().is_none_or(|(fewest, ..)| flops < *fewest) {
            choice = Some((flops, of, places));
        }
    }
    match choice {
        Some((_, of, places)) => Ok((of, places)),
        None => Err(failed(WHAT)(LinalgError::Singular { size })),
    }
}

/// Place of a pair of positions in a pattern.
fn place(of: &Pattern, at: Option<(usize, usize)>) -> Option<u32> {
    at.and_then(|(i, j)| of.place(i, j)).map(|p| p as u32)
}

impl Zone {
    /// The zone of the elements for which `own(element number)` holds, and of nonlinear elements all of whose unknowns are theirs.
    ///
    /// Errors: not enough memory.
    pub fn new(model: &Model, assembler: &Assembler, own: impl Fn(usize) -> bool) -> Result<Zone, AnalysisError> {
        let size = model.dofs().len();
        let (elements, inside) = members(model, own);
        let pattern = assembler.pattern();
        let operators: Vec<_> = assembler.operators(model).collect();
        let touched = seams(&inside, pattern, &operators);
        let without = Without { inside: &inside, touched: &touched };
        let outside = match operators.is_empty() {
            true => Outside::Dissected(Dissected::new(model, pattern, without)),
            false => Outside::Harmonic(Box::new(Sections::new(model, assembler, without)?)),
        };
        let (inner_of, inner) = inner_part(model, pattern, &inside, &touched)?;
        let mut inner_places = Vec::new();
        entries(pattern, |i, j, p| {
            if inside[i] && inside[j] {
                inner_places.extend(place(&inner, pair(&inner_of, i, j)).map(|to| [p as u32, to]));
            }
        });
        let touched: Vec<u32> = (0..size).filter(|&e| touched[e]).map(|e| inner_of[e]).collect();
        let mut border = Vec::with_capacity(touched.len() * (touched.len() + 1) / 2);
        for (b, &j) in touched.iter().enumerate() {
            for &i in &touched[b..] {
                let (i, j) = (i.max(j) as usize, i.min(j) as usize);
                border.extend(place(&inner, Some((i, j))));
            }
        }
        let eliminated = match &outside {
            Outside::Dissected(own) => own.size,
            Outside::Harmonic(own) => own.size(),
        };
        Ok(Zone {
            elements,
            sizes: [eliminated, inner.size()],
            outside,
            inner_of,
            inner,
            inner_places,
            touched,
            border,
        })
    }

    /// Elements of the zone.
    pub fn elements(&self) -> &[bool] {
        &self.elements
    }

    /// Part of ‖r‖ that is that of the unknowns outside; not a number where r is none or nothing.
    pub fn share_outside(&self, r: &[f64]) -> f64 {
        let mut squares = [0.0; 2];
        for (&inner, r) in self.inner_of.iter().zip(r) {
            squares[usize::from(inner == NONE)] += r * r;
        }
        (squares[1] / (squares[0] + squares[1])).sqrt()
    }

    /// Unknowns outside, and of the zone.
    pub fn sizes(&self) -> [usize; 2] {
        self.sizes
    }
}

#[cfg(test)]
mod tests;
