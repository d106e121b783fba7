//! API 650, seismic design of storage tanks: appendix E of the 9th edition and annex E of the 12th and 13th.
//!
//! | module | idea |
//! |---|---|
//! | [`ground_motion`] | ASCE 7 site coefficients and design spectrum; plateau of a record |
//! | [`site_specific`] | the user's spectrum with the lower limit of ASCE 7 chapter 21 |
//! | [`masses`] | effective masses, heights and periods, closed forms of the charts |
//! | [`hold_down`] | hold-down by the bottom plate, figure E-5, allowable shell compression |
//! | [`hoop`] | hoop forces over the height |
//! | [`basis`] | the tank in the standard's terms, lines that both editions share |
//! | [`edition1993`], [`edition2020`] | the procedures |
//!
//! Inside all is SI; the standard's SI forms (mm, MPa, kN) are converted in the formula that uses them. Both unit forms of
//! the standard are printed rounded, so they differ by up to 0.6 %; the SI one is used. `docs/theory/api650.md` maps the
//! clauses and lists errata and gaps.

#[cfg(test)]
mod annex_e_tables;
#[cfg(test)]
mod asce7_tables;
pub mod basis;
#[cfg(test)]
mod boundaries;
pub mod edition1993;
pub mod edition2020;
#[cfg(test)]
pub(crate) mod example;
pub mod ground_motion;
pub mod hold_down;
pub mod hoop;
mod ingredients;
pub mod masses;
#[cfg(test)]
mod own_spectrum;
mod run;
pub mod site_specific;
#[cfg(test)]
mod tests1993;

pub use run::Api650;
