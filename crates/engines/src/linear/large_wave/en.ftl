large_wave = Nonlinear liquid

large_wave-asked =
    The liquid is nonlinear as asked for (`--liquid nonlinear`): the linear wave of { $wave } stands beside it. Up to { $limit } a wave is
    small, and its crest at most a tenth higher than that of linear theory. Pressures on the wall and stresses in it are those of the linear liquid.
large_wave-passed =
    The linear wave of { $wave } is not small: above { $limit } its crest is more than a tenth higher. So the liquid was computed a second
    time as a nonlinear one. The values of the run, and the crest that its freeboard has to hold, are those of the linear liquid.
large_wave-counts =
    The linear wave of { $wave } is not small: above { $limit } its crest is more than a tenth higher. So the liquid was computed a second
    time as a nonlinear one. Crest and trough of the run, and the crest that its freeboard has to hold, are those of the nonlinear liquid: the wave
    breaks, or its factor is no longer exact. The other values are those of the linear liquid.
large_wave-other =
    The nonlinear liquid is left out. In a rigid tank that follows the ground the linear wave is { $alone }, in this one { $wave }: its base rocks, or its
    wall gives way, which the nonlinear liquid does not follow. The crest is the linear wave with its factor.
large_wave-breaking =
    From t = { $time } on the slope of the surface exceeds { $slope }: the wave may break, which the model does not follow. What is larger later is a
    lower bound.
large_wave-steep =
    The nonlinear run stops at t = { $time }, r = { $r }, θ = { $angle }, where the slope of the surface reaches 2: the wave breaks. Its values are
    lower bounds: those until then, or of the linear run where that has more.
large_wave-dry =
    The nonlinear run stops at t = { $time }, r = { $r }, θ = { $angle }, where a trough comes near the bottom. Its values are lower bounds: those
    until then, or of the linear run where that has more.
large_wave-diverged =
    The nonlinear run stops at t = { $time }, r = { $r }, θ = { $angle }, where the expansion of the surface diverges. Its values are lower
    bounds: those until then, or of the linear run where that has more.
large_wave-model =
    Potential flow in the rigid tank, expanded to third order on the tank's own modes; its difference from a linear liquid in the rigid
    tank is added to the linear response of the elastic one.
large_wave-values = Linear and nonlinear liquid
large_wave-value = Nonlinear
large_wave-held = Linear
large_wave-crest_around = Highest crest around the circumference
large_wave-wave_height_theta_0 = Wave at the wall, θ = 0, around the highest crest
large_wave-linear = linear
large_wave-nonlinear = nonlinear
large_wave-wave = Wave
large_wave-energies = Energy of the liquid at the end, in the frame of the tank
large_wave-energies-value = Energy
large_wave-input = Work of the motion
large_wave-damped = Damping
large_wave-kinetic = Kinetic
large_wave-potential = Potential
large_wave-balance =
    Over { $steps } steps the energies miss their balance by at most { $energy } of the largest, the mean level of the surface (its volume over the
    area) by { $volume }. The steepest slope of the surface is { $slope }.
