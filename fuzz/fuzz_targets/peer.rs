//! The target `peer` under libFuzzer.
#![no_main]

const NAME: &str = "peer";
include!("run.rs");
