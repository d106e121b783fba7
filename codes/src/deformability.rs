//! Deformability parameter of the dissertation, eq. (3.1).
