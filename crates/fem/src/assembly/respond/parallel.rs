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
use crate::state::{Fields, State};

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
    failure: Option<Failure>,
}

/// A failure with the number of its element.
type Failure = (usize, ElementError);

/// What the elements of an evaluation read.
struct Evaluation<'a> {
    assembler: &'a Assembler,
    model: &'a Model,
    trial: &'a Fields,
    nodes: &'a Nodes,
    ask: Ask<'a>,
    /// Committed history, and the start of each element's part.
    old: &'a [f64],
    starts: &'a [usize],
    /// Start of each element's kept data; empty without any.
    kept_starts: &'a [usize],
}

/// First `len` variables, taken off.
fn take<'a>(from: &mut &'a mut [f64], len: usize) -> &'a mut [f64] {
    let (own, rest) = std::mem::take(from).split_at_mut(len);
    *from = rest;
    own
}

impl Evaluation<'_> {
    /// The elements of `rest` up to `end`, taken off with their variables.
    fn cut<'v>(&self, rest: &mut Chunk<'v>, end: usize) -> Chunk<'v> {
        let from = std::mem::replace(&mut rest.elements.start, end);
        let kept = match self.kept_starts {
            [] => 0,
            starts => starts[end] - starts[from],
        };
        Chunk {
            elements: from..end,
            new: take(&mut rest.new, self.starts[end] - self.starts[from]),
            kept: take(&mut rest.kept, kept),
        }
    }

    /// Takes the first element off a chunk and evaluates it in `room`; whether it has a result.
    fn first(&self, chunk: &mut Chunk<'_>, room: &mut Room) -> Result<bool, Failure> {
        let e = chunk.elements.start;
        let Chunk { new, kept, .. } = self.cut(chunk, e + 1);
        if self.assembler.is_replaced(e, self.ask) {
            return Ok(false);
        }
        let slots = Slots { old: &self.old[self.starts[e]..self.starts[e + 1]], new, kept };
        let done = self.assembler.local(self.model, e, self.ask, (self.trial, self.nodes), slots, room);
        done.map(|()| true).map_err(|error| (e, error))
    }

    /// Evaluates a chunk up to its first failure.
    fn fill(&self, mut chunk: Chunk<'_>, store: &mut Store, room: &mut Room) {
        store.clear(chunk.elements.clone());
        while !chunk.elements.is_empty() {
            let e = chunk.elements.start;
            match self.first(&mut chunk, room) {
                Ok(true) => store.push(self.ask.wants_tangent(e), room),
                Ok(false) => {}
                Err(failure) => {
                    store.failure = Some(failure);
                    break;
                }
            }
        }
    }

    /// Evaluates a round on its threads, each chunk into its store.
    fn share(&self, chunks: Vec<Chunk<'_>>, stores: &mut [Store]) {
        let threads = self.ask.threads.min(chunks.len());
        let queue = Mutex::new(chunks.into_iter().zip(stores));
        let work = || {
            let mut room = Room::default();
            loop {
                let next = queue.lock().unwrap_or_else(PoisonError::into_inner).next();
                let Some((chunk, store)) = next else { break };
                self.fill(chunk, store, &mut room);
            }
        };
        std::thread::scope(|scope| {
            for _ in 1..threads {
                scope.spawn(work);
            }
            work();
        });
    }
}

impl Assembler {
    /// Calls `accept(element, force, matrix)` in the order of the elements, without those that `ask` replaces.
    ///
    /// Errors: the first element that fails, with its number.
    pub(super) fn evaluate(
        &self,
        model: &Model,
        state: &mut State,
        nodes: &Nodes,
        ask: Ask<'_>,
        kept: Option<&mut Kept>,
        mut accept: impl FnMut(usize, &[f64], &[f64]),
    ) -> Result<(), Failure> {
        let count = model.elements().len();
        let (trial, old, new, starts) = state.split();
        let (kept, kept_starts): (&mut [f64], &[usize]) = match kept {
            Some(kept) => (&mut kept.values, &kept.offsets),
            None => (&mut [], &[]),
        };
        let run = Evaluation { assembler: self, model, trial, nodes, ask, old, starts, kept_starts };
        let mut rest = Chunk { elements: 0..count, new, kept };
        if ask.threads < 2 || count < FEW {
            let mut room = Room::default();
            for e in 0..count {
                if run.first(&mut rest, &mut room)? {
                    accept(e, &room.response.force, &room.response.tangent.data);
                }
            }
            return Ok(());
        }
        let mut stores: Vec<Store> = Vec::new();
        while !rest.elements.is_empty() {
            let round = rest.elements.start..self.round(rest.elements.start, count, ask);
            let cut = |from: usize| run.cut(&mut rest, (from + CHUNK).min(round.end));
            let chunks: Vec<Chunk<'_>> = round.clone().step_by(CHUNK).map(cut).collect();
            stores.resize_with(stores.len().max(chunks.len()), Store::default);
            let stores = &mut stores[..chunks.len()];
            run.share(chunks, stores);
            for store in stores {
                self.accept(store, ask, &mut accept)?;
            }
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
    ) -> Result<(), Failure> {
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
