//! Response and design spectra.
