//! The code procedures: Housner, Eurocode 8, API 650.
//!
//! This crate knows no files, no finite elements and no report. It holds
//!
//! | module | idea |
//! |---|---|
//! | [`procedure`], [`sheet`] | the trait all code procedures implement, and their calculation sheets |
//! | [`bessel`], [`mechanical`] | special functions; masses, levers and periods of potential flow |
//! | [`housner`], [`ec8`], [`api650`], [`deformability`] | the procedures |

pub mod api650;
pub mod bessel;
pub mod deformability;
pub mod ec8;
pub mod housner;
pub mod mechanical;
pub mod procedure;
pub mod sheet;

pub use procedure::Procedure;
