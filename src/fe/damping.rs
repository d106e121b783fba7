//! Damping models and the table of resulting ratios.
