//! Sections of reinforced concrete walls per metre, EN 1992-1-1:2004 and EN 1992-3:2006.
//!
//! | module | idea | clause |
//! |---|---|---|
//! | [`section`] | wall with layers of bars; bending resistance with axial force | EN 1992-1-1 3.1.7(3), 6.1 |
//! | [`shear`] | resistance without links | EN 1992-1-1 6.2.2 |
//! | [`crack`] | crack width and its limit | EN 1992-1-1 7.3.4, EN 1992-3 7.3.1 |
//! | [`required`] | areas of bars for a force and a moment | equilibrium |
//!
//! Axial forces are positive in tension, moments where they pull on the inner face. Clauses are recalled;
//! `docs/theory/concrete-walls.md` has worked numbers.

pub mod crack;
pub mod required;
pub mod section;
pub mod shear;
