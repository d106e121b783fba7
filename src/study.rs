//! The whole flow of a study: many tanks under many records.
//!
//! ```text
//! study.json ─ plan ─ tasks ─ run, anywhere, any number of times ─ results ─ merge ─ rows.csv, tanks.csv, fragility.json
//! ```
//!
//! | module | holds |
//! |---|---|
//! | [`plan`] | the tasks of a study and their keys |
//! | [`folder`] | the files of a study's folder |
//! | [`changes`] | what changed since the plan |
//! | [`pilot`] | what they will cost |
//! | `task` | the computation of one task |
//! | [`rows`] | what a task writes: one row a tank, sample, record and scale |
//! | [`store`] | files of results: whole, or damaged |
//! | `belongs` | whether a result is that of its task |
//! | [`check`] | what is damaged |
//! | [`run`] | missing tasks, in threads |
//! | [`merge`] | results to tables |
//! | [`damage`] | damage states, and the data of their curves |
//! | [`curves`] | the curves of tanks and farm, and its losses |
//! | [`keep`] | whole results of single rows |
//! | [`rule`] | whether the records stand for a spectrum |
//! | `page` | what the report shows |
//! | `parquet` | rows as a table of columns |
//!
//! **State is in files.** A task's key is the hash of everything its numbers depend on: the resolved tank, the samples of its records, the
//! scales, the engine and its options, the procedures, and [`METHOD`]. Its result stands at a path made of the key; a last line with the
//! key, the number of rows and their hash closes it. Any other file there is damaged, and computed again. Two runs of a task write the same bytes, so nothing is locked.
//! The files of a plan, and those of a merge, are moved into the folder as a set ([`files::OutputFolder`]). Merged files have no paths, times or counts of threads in them.

mod belongs;
pub mod changes;
pub mod check;
pub mod curves;
pub mod damage;
pub mod folder;
pub mod keep;
mod key;
pub mod merge;
pub mod merged;
mod page;
#[cfg(feature = "parquet")]
mod parquet;
pub mod pilot;
pub mod plan;
pub mod rows;
pub mod rule;
pub mod run;
pub mod scripts;
pub mod store;
mod task;

/// Digest of the methods: raised when numbers of rows change, so that results of an earlier program are not kept.
pub const METHOD: u32 = 8;
