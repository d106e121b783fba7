//! Unknowns of a model by rings of nodes, and the mean of a matrix over all turns.

use std::collections::HashMap;
use std::f64::consts::TAU;
use std::sync::Arc;

use super::wide::{Wide, wide};
use crate::analysis::{AnalysisError, failed};
use crate::assembly::Assembler;
use crate::dofs::{Dof, DofMap};
use crate::linalg::{Matrix, Ordering, Pattern, Symbolic, Symmetric};
use crate::model::Model;
use crate::ring::{NodeRings, Ring, RingAmplitude};

/// Marks unknowns that are held and places that are left out.
pub(super) const NONE: u32 = u32::MAX;
/// Places whose values enter with the other sign.
const FLIPPED: u32 = 1 << 31;
/// Nodes further apart than this many sectors are joined by small masses only (a roof): left out of the mean. What is outside of a zone
/// has them in its sections: its factor stands alone.
pub(super) const REACH: usize = 2;

/// Mean of the entries (row, column) of nodes `offset` sectors apart.
#[derive(Clone, Copy, Debug)]
struct Entry {
    row: usize,
    column: usize,
    offset: usize,
    /// Number of pairs of nodes on the full circle.
    count: f64,
}

/// One operator in the sections: row of each of its levels, `None` where it is held.
type Levels = Vec<Option<usize>>;

/// Face of a liquid and the wall behind it, joined node by node and by nothing else.
pub(super) struct Pair {
    /// Unknowns of the meridian: face, wall.
    pub(super) rows: [usize; 2],
    /// Entries of the mean: between them, diagonal of the face, diagonal of the wall.
    pub(super) entries: [usize; 3],
    /// Place of the joint in the model's pattern, by meridian.
    pub(super) places: Vec<usize>,
}

/// Unknowns of a meridian, and where the entries of a model's matrices belong.
pub struct RingLayout {
    ring: Ring,
    /// Its full circle.
    circle: Ring,
    /// Equations by unknown of the meridian, then by meridian.
    rows: Vec<Vec<u32>>,
    odd: Vec<bool>,
    amplitudes: Vec<(usize, RingAmplitude)>,
    entries: Vec<Entry>,
    /// Entry of each place of the model's pattern.
    targets: Vec<u32>,
    wide: Vec<Wide>,
    operators: Vec<Levels>,
    pairs: Vec<Pair>,
    /// Sections without and with amplitudes.
    symbolic: [Arc<Symbolic>; 2],
    /// Place of each entry in the sections.
    places: [Vec<usize>; 2],
    /// Whether a harmonic has amplitudes.
    sloshing: Vec<bool>,
}

/// Unknowns of a meridian.
struct Meridian {
    rows: Vec<Vec<u32>>,
    odd: Vec<bool>,
    /// Row and meridian of each equation; the row is [`NONE`] where it is on none.
    of: Vec<(u32, u32)>,
}

impl Meridian {
    /// * `apart`: equations that are left out
    fn of(rings: &NodeRings, dofs: &DofMap, apart: impl Fn(usize) -> bool) -> Meridian {
        let (mut rows, mut odd) = (Vec::new(), Vec::new());
        let mut of = vec![(NONE, 0_u32); dofs.len()];
        for nodes in &rings.nodes {
            for dof in [Dof::Ux, Dof::Uy, Dof::Uz, Dof::Rx, Dof::Ry, Dof::Rz, Dof::Amplitude] {
                let number = |&n: &usize| dofs.equation(n, dof).filter(|e| !apart(*e)).map_or(NONE, |e| e as u32);
                let own: Vec<u32> = nodes.iter().map(number).collect();
                if own.iter().all(|e| *e == NONE) {
                    continue;
                }
                for (k, &e) in own.iter().enumerate().filter(|(_, e)| **e != NONE) {
                    of[e as usize] = (rows.len() as u32, k as u32);
                }
                rows.push(own);
                odd.push(matches!(dof, Dof::Uy | Dof::Ry | Dof::Rz));
            }
        }
        Meridian { rows, odd, of }
    }
}

/// Unknowns of a zone, and those of them that the outside touches.
#[derive(Clone, Copy)]
pub(in crate::analysis) struct Without<'a> {
    pub(in crate::analysis) inside: &'a [bool],
    pub(in crate::analysis) touched: &'a [bool],
}

impl RingLayout {
    /// Layout of a model whose nodes lie on rings.
    ///
    /// Errors: a model without rings, unknowns that are on none.
    pub fn new(model: &Model, assembler: &Assembler) -> Result<RingLayout, AnalysisError> {
        RingLayout::of(model, assembler, None)
    }

    /// The same of what is outside of a zone: with the unknowns that the zone touches, without entries among those of the zone.
    ///
    /// Errors: those of [`RingLayout::new`].
    pub(in crate::analysis) fn of(
        model: &Model,
        assembler: &Assembler,
        without: Option<Without<'_>>,
    ) -> Result<RingLayout, AnalysisError> {
        let apart = |e: usize| without.is_some_and(|w| w.inside[e] && !w.touched[e]);
        let missing = |found: String| {
            AnalysisError::option("elements that are not assembled", found, "a model whose nodes are named as rings")
        };
        let rings = model.rings().ok_or_else(|| missing("no rings of nodes".into()))?;
        let dofs = model.dofs();
        let Meridian { rows, odd, of } = Meridian::of(rings, dofs, apart);
        let mut amplitudes = Vec::new();
        let mut operators = Vec::new();
        for placed in assembler.operators(model) {
            let operator = placed.operator;
            for (k, &a) in operator.amplitudes().iter().enumerate() {
                if let Some(e) = placed.equation(operator.wall() + k) {
                    amplitudes.push((e, a));
                }
            }
            let meridians = operator.ring().meridians();
            let level = |l: usize| -> Option<usize> {
                let free = (0..meridians).find_map(|k| placed.equation(l * meridians + k))?;
                Some(of[free].0 as usize)
            };
            operators.push((0..operator.levels()).map(level).collect::<Levels>());
        }
        if operators.len() > 1 {
            return Err(missing(format!("{} liquids", operators.len())));
        }
        let slots = amplitudes.iter().map(|(_, a)| a.slot + 1).max().unwrap_or(0);
        let is_amplitude = |e: usize| amplitudes.iter().any(|(own, _)| *own == e);
        let mut left_out = match without {
            Some(_) => (0..dofs.len()).map(apart).collect(),
            None => alone(assembler.pattern(), |e| of[e].0 == NONE && !is_amplitude(e)),
        };
        amplitudes.iter().for_each(|(e, _)| left_out[*e] = true);
        if let Some(e) = (0..dofs.len()).find(|&e| of[e].0 == NONE && !left_out[e]) {
            let (node, dof) = dofs.unknown(e);
            return Err(missing(format!("{dof} of node {node} on no ring")));
        }
        let within = |i: usize, j: usize| without.is_some_and(|w| w.inside[i] && w.inside[j]);
        let wide = match without {
            Some(_) => wide(&rings.ring, assembler.pattern(), &of, within),
            None => Vec::new(),
        };
        let apart = |i: usize, j: usize| within(i, j) || wide.iter().any(|w| w.joins(of[i].0, of[j].0));
        let (entries, targets) = average(&rings.ring, assembler.pattern(), &of, &odd, apart);
        let wet: Vec<usize> = operators.iter().flatten().flatten().copied().collect();
        let pairs = pairs(&wet, &rows, &entries, assembler.pattern());
        let circle = Ring::new(rings.ring.sectors(), false).ok_or_else(|| missing("fewer than 3 sectors".into()))?;
        let sections = [0, slots].map(|slots| section(rows.len(), slots, (&entries, &wide), &wet));
        let [plain, full] = sections;
        let symbolic =
            [plain.map_err(failed("a section of the wall"))?, full.map_err(failed("a section of the wall"))?];
        let places = symbolic.each_ref().map(|s| {
            let place = |e: &Entry| s.pattern().place(e.row, e.column).unwrap_or(0);
            entries.iter().map(place).collect()
        });
        Ok(RingLayout {
            sloshing: (0..rings.ring.harmonics()).map(|m| amplitudes.iter().any(|(_, a)| a.harmonic == m)).collect(),
            ring: rings.ring.clone(),
            circle,
            rows,
            odd,
            amplitudes,
            entries,
            targets,
            wide,
            operators,
            pairs,
            symbolic,
            places,
        })
    }

    pub(in crate::analysis) fn ring(&self) -> &Ring {
        &self.ring
    }

    /// The full circle.
    pub(super) fn circle(&self) -> &Ring {
        &self.circle
    }

    /// Joints of a liquid's face and a wall.
    pub(super) fn pairs(&self) -> &[Pair] {
        &self.pairs
    }

    /// Gives `to` the joints of `from`.
    pub(in crate::analysis) fn take_joints(&self, from: &Symmetric, to: &mut Symmetric) {
        for pair in &self.pairs {
            for (k, &place) in pair.places.iter().enumerate() {
                // Off the diagonal a joint is negative.
                let change = to.values[place] - from.values[place];
                to.values[place] = from.values[place];
                for row in pair.rows {
                    let diagonal = to.pattern.starts[self.rows[row][k] as usize];
                    to.values[diagonal] += change;
                }
            }
        }
    }

    /// Unknowns of a meridian.
    pub(in crate::analysis) fn size(&self) -> usize {
        self.rows.len()
    }

    /// Equations of an unknown of the meridian; beyond all where it is held.
    pub(in crate::analysis) fn equations(&self, row: usize) -> &[u32] {
        &self.rows[row]
    }

    pub(in crate::analysis) fn is_odd(&self, row: usize) -> bool {
        self.odd[row]
    }

    pub(in crate::analysis) fn amplitudes(&self) -> &[(usize, RingAmplitude)] {
        &self.amplitudes
    }

    /// Rows of the levels of the operators.
    pub(in crate::analysis) fn levels(&self) -> impl Iterator<Item = usize> {
        self.operators.iter().flatten().flatten().copied()
    }

    /// Whether harmonic m has amplitudes.
    pub(in crate::analysis) fn has_amplitudes(&self, m: usize) -> bool {
        self.sloshing[m]
    }

    /// Pattern of the sections without (0) and with (1) amplitudes.
    pub(in crate::analysis) fn pattern(&self, sloshing: usize) -> &Pattern {
        self.symbolic[sloshing].pattern()
    }

    pub(super) fn symbolic(&self, m: usize) -> &Arc<Symbolic> {
        &self.symbolic[usize::from(self.sloshing[m])]
    }

    /// Means of all entries.
    pub(in crate::analysis) fn mean(&self, sparse: &Symmetric) -> Vec<f64> {
        let mut out = vec![0.0; self.entries.len()];
        for (&target, &value) in self.targets.iter().zip(&sparse.values) {
            if target != NONE {
                let at = (target & !FLIPPED) as usize;
                out[at] += if target & FLIPPED == 0 { value } else { -value };
            }
        }
        // Half a circle stands for the whole: every pair twice, those on the plane once with twice its value.
        let twice = if self.ring.is_half() { 2.0 } else { 1.0 };
        for (sum, entry) in out.iter_mut().zip(&self.entries) {
            *sum *= twice / entry.count;
        }
        out
    }

    /// Hᵀ A H on its diagonal, for the rows that a roof joins: by the number of their pair, then by harmonic.
    pub(in crate::analysis) fn wide(&self, sparse: &Symmetric) -> Vec<Vec<f64>> {
        let odd = |wide: &Wide| [wide.row, wide.column].map(|row| self.odd[row as usize]);
        self.wide.iter().map(|wide| wide.diagonal(&self.ring, odd(wide), sparse)).collect()
    }

    /// Adds what [`RingLayout::wide`] has found.
    pub(in crate::analysis) fn add_wide(&self, section: &mut Symmetric, m: usize, wide: &[Vec<f64>]) {
        for (own, values) in self.wide.iter().zip(wide) {
            if let Some(place) = section.pattern.place(own.row as usize, own.column as usize) {
                section.values[place] += values[m];
            }
        }
    }

    /// Diagonal of the amplitudes.
    pub(in crate::analysis) fn amplitude_diagonal(&self, sparse: &Symmetric) -> Vec<f64> {
        let diagonal = |&(e, _): &(usize, RingAmplitude)| sparse.values[sparse.pattern.starts[e]];
        self.amplitudes.iter().map(diagonal).collect()
    }

    /// The wall in harmonic m.
    pub(in crate::analysis) fn section(&self, m: usize, mean: &[f64]) -> Symmetric {
        let mut out = Symmetric::zeros(self.symbolic(m).pattern().clone());
        let places = &self.places[usize::from(self.sloshing[m])];
        for ((entry, &value), &place) in self.entries.iter().zip(mean).zip(places) {
            let sectors = self.ring.sectors();
            let angle = TAU * ((m * entry.offset) % sectors) as f64 / sectors as f64;
            let factor = match (entry.offset, self.odd[entry.row], self.odd[entry.column]) {
                (0, _, _) => 1.0,
                (_, a, b) if a == b => 2.0 * angle.cos(),
                (_, true, _) => 2.0 * angle.sin(),
                _ => -2.0 * angle.sin(),
            };
            out.values[place] += factor * value;
        }
        out
    }

    /// Adds `factor` times a block of an operator.
    pub(in crate::analysis) fn add_block(&self, section: &mut Symmetric, operator: usize, factor: f64, block: &Matrix) {
        if factor == 0.0 {
            return;
        }
        let levels = &self.operators[operator];
        let at = |i: usize| match levels.get(i) {
            Some(row) => *row,
            None => Some(self.rows.len() + i - levels.len()),
        };
        let pattern = section.pattern.clone();
        for j in 0..block.cols {
            for i in 0..block.rows {
                if let (Some(p), Some(q)) = (at(i), at(j))
                    && p >= q
                    && let Some(place) = pattern.place(p, q)
                {
                    section.values[place] += factor * block.get(i, j);
                }
            }
        }
    }

    /// Adds the amplitudes' own diagonal, and a one where there is nothing: a harmonic with fewer modes than another.
    pub(in crate::analysis) fn close(&self, section: &mut Symmetric, m: usize, amplitudes: &[f64]) {
        let pattern = section.pattern.clone();
        for ((_, a), c) in self.amplitudes.iter().zip(amplitudes) {
            if a.harmonic == m && a.family == 0 {
                section.values[pattern.starts[self.rows.len() + a.slot]] += c;
            }
        }
        for &diagonal in &pattern.starts[..pattern.size()] {
            if section.values[diagonal] == 0.0 {
                section.values[diagonal] = 1.0;
            }
        }
    }
}

/// Whether an unknown is `apart` and joined to others of them alone: those of a moving base, which its border solves for.
fn alone(pattern: &Pattern, apart: impl Fn(usize) -> bool) -> Vec<bool> {
    let mut alone: Vec<bool> = (0..pattern.size()).map(&apart).collect();
    for j in 0..pattern.size() {
        for &i in &pattern.rows[pattern.starts[j]..pattern.starts[j + 1]] {
            if apart(i) != apart(j) {
                (alone[i], alone[j]) = (false, false);
            }
        }
    }
    alone
}

/// Entries of the mean, and the entry of each place of a matrix.
///
/// * `without`: places, by row and column, that have none
fn average(
    ring: &Ring,
    pattern: &Pattern,
    of: &[(u32, u32)],
    odd: &[bool],
    without: impl Fn(usize, usize) -> bool,
) -> (Vec<Entry>, Vec<u32>) {
    let sectors = ring.sectors();
    let mut entries: Vec<Entry> = Vec::new();
    let mut numbers: HashMap<(u32, u32, usize), u32> = HashMap::new();
    let mut targets = vec![NONE; pattern.places()];
    let plane = |k: u32| ring.is_half() && (k == 0 || 2 * k as usize == sectors);
    for j in 0..pattern.size() {
        for p in pattern.starts[j]..pattern.starts[j + 1] {
            let (mut low, mut high) = (of[j], of[pattern.rows[p]]);
            if low.0 == NONE || high.0 == NONE || without(pattern.rows[p], j) {
                continue;
            }
            if low.0 > high.0 {
                std::mem::swap(&mut low, &mut high);
            }
            let ahead = (high.1 as usize + sectors - low.1 as usize) % sectors;
            let back = 2 * ahead > sectors;
            let offset = if back { sectors - ahead } else { ahead };
            let mixed = odd[high.0 as usize] != odd[low.0 as usize];
            if offset > REACH || (mixed && offset == 0) {
                continue;
            }
            let number = *numbers.entry((high.0, low.0, offset)).or_insert_with(|| {
                entries.push(Entry { row: high.0 as usize, column: low.0 as usize, offset, count: 0.0 });
                entries.len() as u32 - 1
            });
            let on_plane = plane(low.1) && plane(high.1);
            entries[number as usize].count += if ring.is_half() && !on_plane { 2.0 } else { 1.0 };
            targets[p] = number | if back && mixed { FLIPPED } else { 0 };
        }
    }
    (entries, targets)
}

/// The rows of `faces` that one other row on their own meridian joins, and nothing else.
fn pairs(faces: &[usize], rows: &[Vec<u32>], entries: &[Entry], pattern: &Pattern) -> Vec<Pair> {
    let pair = |&face: &usize| -> Option<Pair> {
        let mut own = entries.iter().enumerate().filter(|(_, e)| e.row == face || e.column == face);
        let (mut between, mut diagonal) = (None, None);
        own.try_for_each(|(number, e)| {
            let place = if e.row == e.column { &mut diagonal } else { &mut between };
            (e.offset == 0 && place.replace(number).is_none()).then_some(())
        })?;
        let between = between?;
        let wall = entries[between].row + entries[between].column - face;
        let on_diagonal = |e: &Entry| e.offset == 0 && e.row == wall && e.column == wall;
        let places = rows[face].iter().zip(&rows[wall]).map(|(&a, &b)| match a == NONE || b == NONE {
            true => None,
            false => pattern.place(a.max(b) as usize, a.min(b) as usize),
        });
        Some(Pair {
            rows: [face, wall],
            entries: [between, diagonal?, entries.iter().position(on_diagonal)?],
            places: places.collect::<Option<_>>()?,
        })
    };
    faces.iter().filter_map(pair).collect()
}

/// Analysis of a section: the wall first, then what the liquid joins.
fn section(
    size: usize,
    slots: usize,
    (entries, wide): (&[Entry], &[Wide]),
    wet: &[usize],
) -> Result<Arc<Symbolic>, crate::linalg::LinalgError> {
    let wide = wide.iter().map(|w| vec![w.row as usize, w.column as usize]);
    let mut cliques: Vec<Vec<usize>> = entries.iter().map(|e| vec![e.row, e.column]).chain(wide).collect();
    cliques.iter_mut().for_each(|c| c.dedup());
    let joined: Vec<usize> = wet.iter().copied().chain(size..size + slots).collect();
    let mut is_joined = vec![false; size + slots];
    joined.iter().for_each(|&i| is_joined[i] = true);
    cliques.push(joined.clone());
    let pattern = Arc::new(Pattern::from_cliques(size + slots, cliques.iter().map(Vec::as_slice)));
    let mut order: Vec<usize> = (0..size).filter(|&i| !is_joined[i]).collect();
    order.extend(joined);
    Ok(Arc::new(Symbolic::new(pattern, &Ordering::Given(order))?))
}
