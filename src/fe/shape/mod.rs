//! Shape functions and quadrature on the reference interval [−1, 1] and its square.

pub mod gauss;
pub mod line;
pub mod quad9;
