//! Masses, levers and periods of potential flow.
