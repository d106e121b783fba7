//! Eurocode 8 part 4: EN 1998-4:2006 annex A and the pre-standard ENV 1998-4:1998 annex B.
//!
//! | module | idea | clause |
//! |---|---|---|
//! | [`spectrum`] | elastic and design spectra | EN 1998-1:2004 3.2.2, ENV 1998-1-1:1994 4.2 |

pub mod buckling;
pub mod flexible;
pub mod shell_mode;
pub mod simplified;
pub mod spectrum;
pub mod vertical;
