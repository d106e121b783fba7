//! Solutions with a factor: down the tree and up again.

use super::tree::Node;
use super::{Fronts, Panel};

/// Columns used at a time.
const COLUMNS: usize = 4;
/// Sums of a product side by side.
const LANES: usize = 8;
/// Entries of the subtrees from which a second thread is worth its start.
const WORTH: usize = 400_000;

impl Fronts {
    /// b ← (L⁻¹ b_E, b_S − B E⁻¹ b_E). Does nothing without a factor.
    pub fn forward(&self, b: &mut [f64], threads: usize) {
        if !self.ready {
            return;
        }
        let tree = &*self.tree;
        let parts = self.bundles(threads, |members| {
            let mut own = vec![0.0; tree.size];
            self.each(members, |node| {
                let columns = node.first..node.first + node.width;
                own[columns.clone()].iter_mut().zip(&b[columns]).for_each(|(o, b)| *o += b);
            });
            let mut room = Vec::new();
            members.iter().for_each(|&k| self.down(k, &mut own, &mut room));
            own
        });
        for (members, own) in tree.bundles.iter().zip(&parts) {
            // Its own columns get values, the others what it adds.
            self.each(members, |node| b[node.first..node.first + node.width].fill(0.0));
            b.iter_mut().zip(own).for_each(|(b, o)| *b += o);
        }
        let mut room = Vec::new();
        tree.top.iter().for_each(|&k| self.down(k, b, &mut room));
    }

    /// x ← (E⁻¹ (b_E − Bᵀ x_S), x_S) from what [`Fronts::forward`] left in the first unknowns. Does nothing without a factor.
    pub fn backward(&self, x: &mut [f64], threads: usize) {
        if !self.ready {
            return;
        }
        let tree = &*self.tree;
        let mut room = Vec::new();
        tree.top.iter().rev().for_each(|&k| self.up(k, x, &mut room));
        let parts = self.bundles(threads, |members| {
            let mut own = x.to_vec();
            let mut room = Vec::new();
            members.iter().rev().for_each(|&k| self.up(k, &mut own, &mut room));
            own
        });
        for (members, own) in tree.bundles.iter().zip(&parts) {
            self.each(members, |node| {
                let columns = node.first..node.first + node.width;
                x[columns.clone()].copy_from_slice(&own[columns]);
            });
        }
    }

    fn each<'a>(&'a self, members: &[usize], see: impl FnMut(&'a Node)) {
        members.iter().map(|&k| &self.tree.nodes[k]).for_each(see);
    }

    /// What both bundles make, side by side if that is worth it.
    fn bundles(&self, threads: usize, make: impl Fn(&[usize]) -> Vec<f64> + Sync) -> [Vec<f64>; 2] {
        let [left, right] = &self.tree.bundles;
        let of = |k: &usize| self.tree.nodes[*k].width * self.tree.nodes[*k].height();
        let entries: usize = right.iter().map(of).sum();
        if threads < 2 || entries < WORTH {
            return [make(left), make(right)];
        }
        rayon::join(|| make(left), || make(right)).into()
    }

    fn down(&self, k: usize, b: &mut [f64], room: &mut Vec<f64>) {
        let node = &self.tree.nodes[k];
        room.clear();
        room.extend_from_slice(&b[node.first..node.first + node.width]);
        room.resize(node.height(), 0.0);
        let width = node.width;
        match &self.panels[k] {
            Panel::Double(l) => pulp::Arch::new().dispatch(Sweep { l, width, room, up: false }),
            Panel::Single(l) => pulp::Arch::new().dispatch(Sweep { l, width, room, up: false }),
        }
        b[node.first..node.first + node.width].copy_from_slice(&room[..node.width]);
        let below = node.below.iter().zip(&room[node.width..]);
        below.for_each(|(&i, r)| b[i as usize] += r);
    }

    fn up(&self, k: usize, x: &mut [f64], room: &mut Vec<f64>) {
        let node = &self.tree.nodes[k];
        room.clear();
        room.extend_from_slice(&x[node.first..node.first + node.width]);
        room.extend(node.below.iter().map(|&i| x[i as usize]));
        let width = node.width;
        match &self.panels[k] {
            Panel::Double(l) => pulp::Arch::new().dispatch(Sweep { l, width, room, up: true }),
            Panel::Single(l) => pulp::Arch::new().dispatch(Sweep { l, width, room, up: true }),
        }
        x[node.first..node.first + node.width].copy_from_slice(&room[..node.width]);
    }
}

/// A sweep over one panel in the registers of the processor: the same operations in the same order on all of them.
struct Sweep<'a, T> {
    l: &'a [T],
    width: usize,
    room: &'a mut [f64],
    up: bool,
}

impl<T: Copy + Into<f64>> pulp::WithSimd for Sweep<'_, T> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: pulp::Simd>(self, _: S) {
        match self.up {
            true => up(self.l, self.width, self.room),
            false => down(self.l, self.width, self.room),
        }
    }
}

/// The first `width` of `room` ← L⁻¹ of them, the others −= Y times that.
#[inline(always)]
fn down<T: Copy + Into<f64>>(l: &[T], width: usize, room: &mut [f64]) {
    let height = room.len();
    for j in (0..width).step_by(COLUMNS) {
        let end = (j + COLUMNS).min(width);
        for a in j..end {
            let y = room[a];
            for i in a + 1..end {
                room[i] -= l[a * height + i].into() * y;
            }
        }
        if end - j == COLUMNS {
            let [y0, y1, y2, y3] = [room[j], room[j + 1], room[j + 2], room[j + 3]];
            let [l0, l1, l2, l3] = columns(l, j, end, height);
            for (i, r) in room[end..].iter_mut().enumerate() {
                *r -= (l0[i].into() * y0 + l1[i].into() * y1) + (l2[i].into() * y2 + l3[i].into() * y3);
            }
        } else {
            for a in j..end {
                let y = room[a];
                for (r, l) in room[end..].iter_mut().zip(&l[a * height + end..(a + 1) * height]) {
                    *r -= (*l).into() * y;
                }
            }
        }
    }
}

/// Four columns from j on, below row `end`.
#[inline(always)]
fn columns<T>(l: &[T], j: usize, end: usize, height: usize) -> [&[T]; COLUMNS] {
    let below = height - end;
    [
        &l[j * height + end..][..below],
        &l[(j + 1) * height + end..][..below],
        &l[(j + 2) * height + end..][..below],
        &l[(j + 3) * height + end..][..below],
    ]
}

/// The first `width` of `room` ← L⁻ᵀ (D⁻¹ of them − Yᵀ times the others).
#[inline(always)]
fn up<T: Copy + Into<f64>>(l: &[T], width: usize, room: &mut [f64]) {
    let height = room.len();
    for j in (0..width).step_by(COLUMNS).rev() {
        let end = (j + COLUMNS).min(width);
        let mut sums = [0.0; COLUMNS];
        if end - j == COLUMNS {
            sums = dots(columns(l, j, end, height), &room[end..]);
        } else {
            for a in j..end {
                for (l, r) in l[a * height + end..(a + 1) * height].iter().zip(&room[end..]) {
                    sums[a - j] += (*l).into() * r;
                }
            }
        }
        for a in (j..end).rev() {
            let mut within = 0.0;
            for i in a + 1..end {
                within += l[a * height + i].into() * room[i];
            }
            room[a] = room[a] / l[a * height + a].into() - sums[a - j] - within;
        }
    }
}

/// Σ a b of four columns a, in [`LANES`] sums each.
#[inline(always)]
fn dots<T: Copy + Into<f64>>(columns: [&[T]; COLUMNS], b: &[f64]) -> [f64; COLUMNS] {
    let mut sums = [[0.0; LANES]; COLUMNS];
    let whole = b.len() - b.len() % LANES;
    for at in (0..whole).step_by(LANES) {
        let part: &[f64] = &b[at..at + LANES];
        for k in 0..COLUMNS {
            let column = &columns[k][at..at + LANES];
            for i in 0..LANES {
                sums[k][i] += column[i].into() * part[i];
            }
        }
    }
    let mut out = [0.0; COLUMNS];
    for k in 0..COLUMNS {
        let mut rest = 0.0;
        for (a, b) in columns[k][whole..].iter().zip(&b[whole..]) {
            rest += (*a).into() * b;
        }
        let mut sum = 0.0;
        for i in 0..LANES {
            sum += sums[k][i];
        }
        out[k] = sum + rest;
    }
    out
}
