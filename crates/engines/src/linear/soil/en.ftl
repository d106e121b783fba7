soil = Soil under the slab

soil-about =
    The tank moves on a rigid slab on soil. The whole run of the linear engine contains the motion of the slab; modes and the
    impulsive period and mass of the comparison are those on a fixed base.
soil-about-nonlinear =
    The tank moves on a rigid slab on soil. The whole run contains the motion of the slab, with springs and dashpots as in the linear engine;
    modes and the impulsive period of the comparison are those on a fixed base.
soil-ground =
    { $slab }. Soil with V_s = { $velocity }, { $density }, Poisson's ratio { $poisson }: static stiffness { $horizontal } and
    { $rocking }. Impulsive mode { $mass } at { $arm } above the underside of the slab, damping { $damping } on a fixed base.
soil-ground-layers =
    { $slab }. { $layers } layers of soil over a half-space with V_s = { $velocity }; underside { $embedment } below the ground, material
    damping { $hysteresis } in the half-space. Impulsive mode { $mass } at { $arm } above the underside of the slab, damping { $damping } on
    a fixed base.
soil-slab = Slab { $radius } in radius, { $thickness } thick, { $mass }
soil-slab-without-mass = Slab { $radius } in radius, without mass

soil-cones = Springs and dashpots of the soil
soil-impedance = Impedance
soil-spring = Spring k
soil-dashpot = Dashpot c
soil-inertia = Inertia
soil-translation = translation
soil-rocking = rocking
soil-internal = internal rotation, joined to the rocking slab by its dashpot

soil-effective = Period and damping of the impulsive mode
soil-mode = Impulsive mode
soil-period = Period
soil-effective-ratio = over fixed base
soil-damping = Damping
soil-fixed = fixed base
soil-effective-cones = on soil, complex stiffness with cones
soil-effective-layers = on soil, complex stiffness with cones in layers
soil-veletsos = on soil, complex stiffness after Veletsos and Verbic
soil-complex_mode = on soil, complex mode on cones, with the slab
soil-static = on soil, static springs
soil-definitions =
    Definitions of the damping agree below 0.10 and differ by up to a third above 0.20. No value of this report is computed
    from them: the time history has the cones themselves.

soil-at-frequency =
    Springs and dashpots are the complex stiffness at { $period }, the period of the impulsive mode on the soil; the time history has them at
    all frequencies. Waves of the liquid, much slower, hardly move the slab.

soil-motion = Largest motion of the slab
soil-motion-quantity = Slab
soil-motion-value = Largest
soil-base_translation = Translation relative to the free field
soil-base_rotation = Rotation
soil-beside = Values on soil and on a fixed base
soil-beside-value = On soil
soil-foundation_translation = Translation of the slab over time
soil-foundation_translation-axis = Translation
soil-foundation_rotation = Rotation of the slab over time
soil-foundation_rotation-axis = Rotation

soil-rigid =
    The slab is rigid and rests on the surface of a uniform half-space; the free field moves it without kinematic interaction.
soil-meek =
    Soil as cones of Meek and Wolf with the stiffness of `shear_wave_velocity`, the value at the strains of the earthquake; its
    hysteresis is left out.
soil-rigid-layers =
    The slab is rigid, its edge in contact with the soil over the depth of its underside; the motion of the free field at the ground moves
    the underside. Kinematic interaction, which makes that motion smaller and turns the slab, is left out.
soil-layered =
    Soil as cones with reflection and refraction at { $layers } layers (Wolf and Deeks 2004), discs over an embedment of { $embedment },
    material damping by the correspondence principle; velocities are those at the strains of the earthquake.
soil-bottom =
    The bottom pressure turns the slab, and the liquid on the turning floor has its inertia; the weight of liquid and wall has no moment
    in the turned position.
soil-modal = Modal damping is that of the tank on a fixed base; the soil adds its dashpots.
soil-relative = The damping of the wall acts on its motion relative to the slab; the soil adds its dashpots.
soil-vertical = Vertical motion is that of a fixed base.
soil-disc = The slab is a disc of reinforced concrete of { $density } with the radius of the bottom plate.
soil-no-mass = Without `tank.foundation.thickness` the slab has no mass.
