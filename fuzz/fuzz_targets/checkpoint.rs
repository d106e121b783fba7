//! The target `checkpoint` under libFuzzer.
#![no_main]

const NAME: &str = "checkpoint";
include!("run.rs");
