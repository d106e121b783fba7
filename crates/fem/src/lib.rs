//! Finite elements in space, and the linear algebra of all engines.
//!
//! This crate knows no tank, no file and no report: its words are nodes, elements, supports, loads and analyses.
//!
//! ```text
//! mesh ─► model (nodes, elements, supports) ─► dofs ─► assembly ─► analysis ─► fields, histories
//!             ▲                                           │
//!          element ◄─ shape, chart                     linalg
//! ```
//!
//! * [`linalg`]: dense and sparse matrices, factors, eigenpairs (a crate of its own, the only one that names faer).
//! * [`shape`]: shape functions and quadrature. [`chart`]: Cartesian and cylindrical coordinates.
//! * [`mesh`]: generators of structured meshes.
//! * [`element`]: one file a kind; elements are pure, they hold parameters and read and write what they are handed.
//! * [`model`]: nodes, elements, supports and groups, built once and then read-only; [`dofs`] numbers its unknowns.
//! * [`state`]: committed and trial fields and the elements' history. [`assembly`]: element matrices to global ones.
//! * [`strip`]: a long rectangular tank as a strip, from fibre beams and condensed liquid.
//! * [`progress`]: how a long analysis tells where it is, and is told to stop.
//! * [`analysis`]: static, eigen, modal, spectral, frequency-domain and direct time integration.
//!
//! Units are SI throughout unless a test's source fixes others.

pub mod analysis;
pub mod assembly;
pub mod chart;
pub mod dofs;
pub mod element;
pub use linalg;
pub mod liquid;
pub mod mesh;
pub mod model;
pub mod progress;
pub mod shape;
pub mod state;
pub mod strip;
