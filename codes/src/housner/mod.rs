//! Housner's procedure.
