//! One Fourier harmonic at a time: shell of revolution or plane wall strip, coupled to the liquid.
