//! Seismic verification of liquid storage tanks: code procedures beside a coupled finite-element time history.
//!
//! Data flows one way:
//!
//! ```text
//! tank.json ─ input::schema ─ input::resolve ─┐        ┌─ codes procedures ─┐
//!                                             ├─ Job ──┤                    ├─ results ─ report (HTML + SVG)
//! record.csv ─ input::records ────────────────┘        └─ fe::simulate ─────┘
//! ```
//!
//! | module | holds |
//! |---|---|
//! | [`input`] | reading `tank.json` and records; the only place that knows units in text and file formats |
//! | [`job`] | what is to be computed: a `tank::Case`, the procedures, the finite-element options |
//! | [`fe`] | the finite-element engine |
//! | [`pipeline`] | the whole flow of a verification in one function |
//! | [`ida`] | that of an incremental dynamic analysis |
//! | [`push`] | that of a pushover |
//! | [`compare`] | the join of procedures and engine |
//! | [`results`] | the results folder: `results.json`, `series.csv` |
//! | [`output`] | the output folder: whole or not at all, and only its own files |
//! | [`numdiff`] | comparison of two results folders, number by number |
//! | [`report`] | results folder → HTML |
//! | [`text`] | user text made visible, before it reaches a terminal or a page |
//! | [`verify`] | the benchmarks of the verification manual |
//! | [`cli`] | the command line |

pub mod cli;
pub mod compare;
pub mod error;
pub mod fe;
pub mod ida;
pub mod input;
pub mod job;
pub mod numdiff;
pub mod output;
pub mod pipeline;
pub mod push;
pub mod report;
pub mod results;
pub mod text;
pub mod verify;
