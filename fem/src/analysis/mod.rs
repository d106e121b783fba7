//! Analyses of a model. An analysis knows matrices, loads and histories, and no element and no tank.
