//! Elements evaluated on several threads, their results added in the order of the elements.
//!
//! ```text
//! round     ├──────────────────────────────────┤   elements whose matrices fit into the caches
//! chunk     ├───┼───┼───┼───┼───┼───┼───┼───┼──┤   a thread takes the next one when it is free
//! results   kept by chunk; after the round the calling thread adds them, element after element
//! ```
//!
//! An element writes its own part of the history and its own result only, and every sum is formed in the order of one
//! thread: the bits do not depend on the number of threads. Of several elements that fail the first is reported.

use std::ops::Range;
use std::sync::{Mutex, PoisonError};

use super::{Ask, Kept, Room, Slots};
use crate::assembly::Assembler;
use crate::assembly::turn::Nodes;
use crate::element::ElementError;
use crate::model::Model;
use crate::state::State;

/// Elements that a thread takes at a time.
const CHUNK: usize = 16;
/// Models with fewer elements are evaluated by one thread: starting another costs more than it saves.
const FEW: usize = 256;
/// Entries of the matrices of a round [numbers], 4 MiB; of its forces alone so many elements.
const ENTRIES: usize = 1 << 19;
const ELEMENTS: usize = 1 << 14;

/// Elements of one chunk, with their variables.
struct Chunk<'a> {
    elements: Range<usize>,
    new: &'a mut [f64],
    kept: &'a mut [f64],
}

/// Results of a chunk.
#[derive(Default)]
struct Store {
    elements: Range<usize>,
    forces: Vec<f64>,
    matrices: Vec<f64>,
    failure: Option<(usize, ElementError)>,
}

/// First `len` variables, taken off.
fn take<'a>(from: &mut &'a mut [f64], len: usize) -> &'a mut [f64] {
    let (own, rest) = std::mem::take(from).split_at_mut(len);
    *from = rest;
    own
}

impl Assembler {
    /// Calls `accept(element, force, matrix)` in the order of the elements, without those that `ask` replaces.
    ///
    /// Errors: the first element that fails, with its number.
    // Long: with one thread and with several the same closure takes its variables off the same slices.
    pub(super) fn evaluate(
        &self,
        model: &Model,
        state: &mut State,
        nodes: &Nodes,
        ask: Ask<'_>,
        kept: Option<&mut Kept>,
        mut accept: impl FnMut(usize, &[f64], &[f64]),
    ) -> Result<(), (usize, ElementError)> {
        let count = model.elements().len();
        let (trial, old, mut new, starts) = state.split();
        let (mut kept, kept_starts): (&mut [f64], &[usize]) = match kept {
            Some(kept) => (&mut kept.values, &kept.offsets),
            None => (&mut [], &[]),
        };
        let kept_len = |from: usize, to: usize| match kept_starts {
            [] => 0,
            starts => starts[to] - starts[from],
        };
        // Element `e` with the first of the variables; whether it has a result.
        let one = |e: usize, new: &mut &mut [f64], kept: &mut &mut [f64], room: &mut Room| {
            let slots = Slots {
                old: &old[starts[e]..starts[e + 1]],
                new: take(new, starts[e + 1] - starts[e]),
                kept: take(kept, kept_len(e, e + 1)),
            };
            if self.is_replaced(e, ask) {
                return Ok(false);
            }
            let done = self.local(model, e, ask, (trial, nodes), slots, room);
            done.map(|()| true).map_err(|error| (e, error))
        };
        if ask.threads < 2 || count < FEW {
            let mut room = Room::default();
            for e in 0..count {
                if one(e, &mut new, &mut kept, &mut room)? {
                    accept(e, &room.response.force, &room.response.tangent.data);
                }
            }
            return Ok(());
        }
        let compute = |chunk: Chunk<'_>, store: &mut Store, room: &mut Room| {
            let Chunk { elements, mut new, mut kept } = chunk;
            store.clear(elements.clone());
            for e in elements {
                match one(e, &mut new, &mut kept, room) {
                    Ok(true) => store.push(ask.wants_tangent(e), room),
                    Ok(false) => {}
                    Err(failure) => {
                        store.failure = Some(failure);
                        break;
                    }
                }
            }
        };
        let mut stores: Vec<Store> = Vec::new();
        let mut first = 0;
        while first < count {
            let last = self.round(first, count, ask);
            let mut chunks = Vec::new();
            for from in (first..last).step_by(CHUNK) {
                let to = (from + CHUNK).min(last);
                chunks.push(Chunk {
                    elements: from..to,
                    new: take(&mut new, starts[to] - starts[from]),
                    kept: take(&mut kept, kept_len(from, to)),
                });
            }
            let used = chunks.len();
            if stores.len() < used {
                stores.resize_with(used, Store::default);
            }
            let queue = Mutex::new(chunks.into_iter().zip(&mut stores));
            let work = || {
                let mut room = Room::default();
                loop {
                    let next = queue.lock().unwrap_or_else(PoisonError::into_inner).next();
                    let Some((chunk, store)) = next else { break };
                    compute(chunk, store, &mut room);
                }
            };
            std::thread::scope(|scope| {
                for _ in 1..ask.threads.min(used) {
                    scope.spawn(work);
                }
                work();
            });
            for store in &mut stores[..used] {
                self.accept(store, ask, &mut accept)?;
            }
            first = last;
        }
        Ok(())
    }

    /// Whether the linear part stands for the element, or nothing is wanted of it.
    fn is_replaced(&self, e: usize, ask: Ask<'_>) -> bool {
        let wanted = ask.want.force || ask.tangents.is_none_or(|of| of[e]);
        self.unassembled[e] || (ask.linear.is_some() && self.linear[e]) || !wanted
    }

    /// End of the round that begins with element `first`.
    fn round(&self, first: usize, count: usize, ask: Ask<'_>) -> usize {
        let end = count.min(first + ELEMENTS);
        let mut entries = 0;
        for e in first..end {
            if ask.wants_tangent(e) && !self.is_replaced(e, ask) {
                entries += self.place_starts[e + 1] - self.place_starts[e];
            }
            if entries >= ENTRIES {
                return e + 1;
            }
        }
        end
    }

    /// Passes the results of a chunk on, up to its failure.
    fn accept(
        &self,
        store: &mut Store,
        ask: Ask<'_>,
        accept: &mut impl FnMut(usize, &[f64], &[f64]),
    ) -> Result<(), (usize, ElementError)> {
        let (mut forces, mut matrices) = (&store.forces[..], &store.matrices[..]);
        let end = store.failure.as_ref().map_or(store.elements.end, |(e, _)| *e);
        for e in (store.elements.start..end).filter(|&e| !self.is_replaced(e, ask)) {
            let n = self.equation_starts[e + 1] - self.equation_starts[e];
            let (force, matrix);
            (force, forces) = forces.split_at(n);
            (matrix, matrices) = matrices.split_at(if ask.wants_tangent(e) { n * n } else { 0 });
            accept(e, force, matrix);
        }
        store.failure.take().map_or(Ok(()), Err)
    }
}

impl Store {
    fn clear(&mut self, elements: Range<usize>) {
        self.elements = elements;
        self.forces.clear();
        self.matrices.clear();
        self.failure = None;
    }

    fn push(&mut self, tangent: bool, room: &Room) {
        self.forces.extend_from_slice(&room.response.force);
        if tangent {
            self.matrices.extend_from_slice(&room.response.tangent.data);
        }
    }
}
