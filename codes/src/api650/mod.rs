//! API 650, seismic design of storage tanks: appendix E of the 9th edition and annex E of the 12th and 13th.
//!
//! | module | idea |
//! |---|---|
//! | [`ground_motion`] | ASCE 7 site coefficients and design spectrum |
//! | [`masses`] | effective masses, heights and periods, closed forms of the charts |

pub mod ground_motion;
pub mod hold_down;
pub mod hoop;
pub mod masses;
