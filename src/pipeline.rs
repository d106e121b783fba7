//! The whole flow of a verification in one function.
