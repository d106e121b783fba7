//! Single-degree-of-freedom response.
