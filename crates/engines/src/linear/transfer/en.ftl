transfer = Harmonic base motion

transfer-meaning =
    Steady state under harmonic horizontal motion of the ground, by frequency: the amplitude over its quasi-static value, which is 1
    for very slow motion. Vertical lines are modes of the first engine drawn: f_c sloshing, f_i structural. Magnitudes and phases of
    the first engine are in `transfer.csv`, those of every engine in `results.json` (series `transfer`).
transfer-frequency = Frequency
transfer-wave_height = Wave height at the wall, θ = 0°
transfer-base_shear = Base shear
transfer-overturning_moment = Overturning moment (below the base plate)
transfer-ratio-wave_height = { transfer-wave_height } over its quasi-static value
transfer-ratio-base_shear = { transfer-base_shear } over its quasi-static value
transfer-ratio-overturning_moment = { transfer-overturning_moment } over its quasi-static value
transfer-m_per_m_s2 = m per m/s²
transfer-n_per_m_s2 = N per m/s²
transfer-nm_per_m_s2 = N·m per m/s²
transfer-caption =
    Quasi-static value { $static } { $unit ->
        [m_per_m_s2] { transfer-m_per_m_s2 }
        [n_per_m_s2] { transfer-n_per_m_s2 }
       *[nm_per_m_s2] { transfer-nm_per_m_s2 }
    }; { $damping ->
        [hysteretic] hysteretic
       *[viscous] viscous
    } damping with the ratios of the time history.
transfer-unit = Unit
transfer-static = Quasi-static
transfer-largest = Largest
transfer-amplification = Amplification
transfer-linear =
    Linear theory: the amplitudes hold while waves are small and the liquid touches the wall; near a lightly damped sloshing mode this
    limits the ground acceleration to very small values.
