//! The laws of `crates/fem/tests/laws`, obeyed by the elements of the benchmarks.

#![expect(dead_code, reason = "these elements need a part of what the laws provide")]

#[path = "../../../fem/tests/laws/abilities.rs"]
mod abilities;
#[path = "../../../fem/tests/laws/frame.rs"]
mod frame;
#[path = "../../../fem/tests/laws/mass.rs"]
mod mass;
#[path = "../../../fem/tests/laws/motion.rs"]
mod motion;
mod registry;
#[path = "../../../fem/tests/laws/restart.rs"]
mod restart;
#[path = "../../../fem/tests/laws/rigid.rs"]
mod rigid;
#[path = "../../../fem/tests/laws/specimen.rs"]
mod specimen;
#[path = "../../../fem/tests/laws/tangent.rs"]
mod tangent;
