//! The target `pipeline` under libFuzzer.
#![no_main]

const NAME: &str = "pipeline";
include!("run.rs");
