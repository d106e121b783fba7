//! The target `results` under libFuzzer.
#![no_main]

const NAME: &str = "results";
include!("run.rs");
