//! Eurocode 8 part 4.
