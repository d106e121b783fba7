//! The target `columns` under libFuzzer.
#![no_main]

const NAME: &str = "columns";
include!("run.rs");
