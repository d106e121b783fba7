//! The target `tank` under libFuzzer.
#![no_main]

const NAME: &str = "tank";
include!("run.rs");
