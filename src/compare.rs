//! The join of procedures and engine: quantity × method, ratios, partings, verdict.
