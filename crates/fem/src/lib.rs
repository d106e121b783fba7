//! Finite elements in space, and the linear algebra of all engines.
//!
//! This crate does not depend on tanks, files or reports; its terms are nodes, elements, supports, loads and analyses.
//!
//! ```text
//! mesh ─► model (nodes, elements, supports) ─► dofs ─► assembly ─► analysis ─► fields, histories
//!             ▲                                           │
//!          element ◄─ shape, chart                     linalg
//! ```
//!
//! * [`linalg`]: dense and sparse matrices, factors, eigenpairs (a separate crate, the only one that uses faer).
//! * [`shape`]: shape functions and quadrature. [`chart`]: Cartesian and cylindrical coordinates.
//! * [`mesh`]: generators of structured meshes.
//! * [`element`]: one file a kind; elements are pure, they hold parameters, and read and write the given state.
//! * [`model`]: nodes, elements, supports and groups, built once and then read-only; [`dofs`] numbers its unknowns.
//! * [`state`]: committed and trial fields and the elements' history. [`assembly`]: element matrices to global ones.
//! * [`progress`]: progress of a long analysis, and its interruption. [`cores`]: the cores it may use.
//! * [`analysis`]: static, eigen, modal, spectral, frequency-domain and direct time integration.
//!
//! Units are SI throughout unless a test's source fixes others.

pub mod analysis;
pub mod assembly;
pub mod chart;
pub mod cores;
pub mod dofs;
pub mod element;
pub use linalg;
pub mod liquid;
pub mod mesh;
pub mod model;
pub mod progress;
pub mod ring;
pub mod shape;
pub mod state;
