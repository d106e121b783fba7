//! Seismic verification of liquid storage tanks: code procedures and a coupled finite-element time history.
//!
//! Data flows one way:
//!
//! ```text
//! tank.json ─ input ─┐       ┌─ codes ───┐
//!                    ├─ Job ─┤           ├─ results ─ report (HTML + SVG)
//! record.csv ─ input ┘       └─ engines ─┘
//! ```
//!
//! | module | holds |
//! |---|---|
//! | [`input`] | reading `tank.json` and records; the only place with units in text and file formats |
//! | [`job`] | input of a computation: a `tank::Case`, the procedures, the finite-element options |
//! | [`pipeline`] | the whole flow of a verification in one function |
//! | [`ida`] | that of an incremental dynamic analysis |
//! | [`push`] | that of a pushover |
//! | [`record_set`] | that of a verification under a set of records |
//! | [`curves`] | fragility curves of data |
//! | [`study`] | that of many tanks under many records |
//! | [`solve`] | that of the largest value at which no check fails |
//! | [`selftest`] | a row for each code and engine against values from elsewhere |
//! | [`cli`] | the command line |

pub mod cli;
pub mod curves;
pub mod error;
pub mod ida;
pub mod input;
pub mod job;
pub mod pipeline;
pub mod push;
pub mod record_set;
pub mod selftest;
pub mod solve;
pub mod study;
