//! The target `agencies` under libFuzzer.
#![no_main]

const NAME: &str = "agencies";
include!("run.rs");
