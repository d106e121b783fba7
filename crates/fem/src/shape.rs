//! Shape functions and quadrature on the reference interval [−1, 1], its square and its cube.

pub mod gauss;
pub mod hex8;
pub mod line;
pub mod quad4;
pub mod quad9;
