//! Shape functions and quadrature.
