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
        match &self.panels[k] {
            Panel::Double(l) => down(l, node.width, room),
            Panel::Single(l) => down(l, node.width, room),
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
        match &self.panels[k] {
            Panel::Double(l) => up(l, node.width, room),
            Panel::Single(l) => up(l, node.width, room),
        }
        x[node.first..node.first + node.width].copy_from_slice(&room[..node.width]);
    }
}

/// The first `width` of `room` ← L⁻¹ of them, the others −= Y times that.
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
        let column = |a: usize| &l[a * height + end..(a + 1) * height];
        if end - j == COLUMNS {
            let [y0, y1, y2, y3] = [room[j], room[j + 1], room[j + 2], room[j + 3]];
            let columns = column(j).iter().zip(column(j + 1)).zip(column(j + 2)).zip(column(j + 3));
            for (r, (((l0, l1), l2), l3)) in room[end..].iter_mut().zip(columns) {
                *r -= ((*l0).into() * y0 + (*l1).into() * y1) + ((*l2).into() * y2 + (*l3).into() * y3);
            }
        } else {
            for a in j..end {
                let y = room[a];
                room[end..].iter_mut().zip(column(a)).for_each(|(r, l)| *r -= (*l).into() * y);
            }
        }
    }
}

/// The first `width` of `room` ← L⁻ᵀ (D⁻¹ of them − Yᵀ times the others).
fn up<T: Copy + Into<f64>>(l: &[T], width: usize, room: &mut [f64]) {
    let height = room.len();
    for j in (0..width).step_by(COLUMNS).rev() {
        let end = (j + COLUMNS).min(width);
        let column = |a: usize| &l[a * height + end..(a + 1) * height];
        let mut sums = [0.0; COLUMNS];
        if end - j == COLUMNS {
            sums = dots([column(j), column(j + 1), column(j + 2), column(j + 3)], &room[end..]);
        } else {
            for a in j..end {
                sums[a - j] = column(a).iter().zip(&room[end..]).map(|(l, r)| (*l).into() * r).sum();
            }
        }
        for a in (j..end).rev() {
            let within: f64 = (a + 1..end).map(|i| l[a * height + i].into() * room[i]).sum();
            room[a] = room[a] / l[a * height + a].into() - sums[a - j] - within;
        }
    }
}

/// Σ a b of four columns a, in [`LANES`] sums each.
fn dots<T: Copy + Into<f64>>(columns: [&[T]; COLUMNS], b: &[f64]) -> [f64; COLUMNS] {
    let mut sums = [[0.0; LANES]; COLUMNS];
    let whole = b.len() - b.len() % LANES;
    for at in (0..whole).step_by(LANES) {
        let part: &[f64] = &b[at..at + LANES];
        for (sums, column) in sums.iter_mut().zip(columns) {
            for ((sum, a), b) in sums.iter_mut().zip(&column[at..at + LANES]).zip(part) {
                *sum += (*a).into() * b;
            }
        }
    }
    std::array::from_fn(|k| {
        let rest: f64 = columns[k][whole..].iter().zip(&b[whole..]).map(|(a, b)| (*a).into() * b).sum();
        sums[k].iter().sum::<f64>() + rest
    })
}
