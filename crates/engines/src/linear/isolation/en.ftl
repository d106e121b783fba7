isolation = Isolators

isolation-beside =
    The slab under the tank stands on isolators. All values of the run are those on isolators, the wave and the freeboard among them;
    those on a fixed base stand here beside them. The wave may grow where the effective period comes near that of sloshing. Pipes
    must follow the displacement of the isolators.
isolation-another =
    The slab under the tank stands on isolators. All values of the run are those on isolators, the wave and the freeboard among them. The slab
    moves by the march of the linear engine, under the base shear of this run beyond that of its modes. Pipes must follow the displacement of
    the isolators.
isolation-isolators =
    { $kind ->
        [friction_pendulum] Friction pendulums
        [lead_rubber] Lead-rubber bearings
       *[elastomer] Linear bearings
    }{ $dampers ->
        [yes] { " " }and viscous dampers
       *[no] { "" }
    } under a slab of { $slab }; { $mass } on them in all. Time step { $step }.

isolation-values = Largest values on isolators
isolation-values-value = On isolators
isolation-isolator_displacement = Displacement of the isolators over time
isolation-loop = Force of the isolators against their displacement
isolation-values-isolator_displacement = Largest displacement of the isolators
isolation-isolator_residual = Their displacement at the end
isolation-isolator_force = Largest force of the isolators
isolation-effective_stiffness = Effective stiffness at the largest displacement
isolation-effective_period = Effective period there
isolation-effective_damping = Effective damping there
isolation-bearing_share = Smallest force of the outermost bearing over that at rest; below 0 tension, which is not modelled
isolation-base_shear = Base shear of the tank
isolation-base_moment = Moment above the base plate
isolation-overturning_moment = Overturning moment
isolation-sloshing_height = Wave height
isolation-hoop_stress = Largest hoop stress up to the surface at rest
isolation-rim_hoop_stress = Largest hoop stress of the rim above it
isolation-axial_membrane_stress = Axial stress at the base
isolation-bending_stress = Bending stress at the base

isolation-band = Values with upper and lower properties
isolation-factor = Factor of the properties
isolation-band-isolator_displacement = Displacement
isolation-band-isolator_force = Force
isolation-band-effective_period = Effective period
isolation-band-effective_damping = Effective damping
isolation-band-base_shear = Base shear
isolation-bounds =
    Properties of isolators vary with wear, temperature and make: the same run with the lower and the upper bound of stiffness, strength,
    friction and damping, but for the stiffness that a pendulum has from its radius. Displacement is governed by the lower bound,
    forces mostly by the upper one.

isolation-energies = Energies of the isolated tank
isolation-energies-isolators = Isolators, stored and lost
isolation-balance =
    The balance of energy closes within { $error } of the input. Force of the isolators from the superposed modes, whose values are
    reported, and from the march agree within { $superposition }.
isolation-balance-another =
    The balance of energy closes within { $error } of the input. The base shear of the last run differs from that with which its slab moved by
    at most { $change } of the largest force of the isolators. Values with upper and lower properties are those of the linear engine.

isolation-rigid = The slab is rigid, does not rotate, and carries the tank clamped to it.
isolation-follows =
    Wall and liquid follow the acceleration of the slab as its march finds it. Displacements of the wall are those relative to the slab.
isolation-mass =
    The tank's mass on the isolators is all liquid, wall and roof; its sloshing modes move freely on the slab.
isolation-outermost =
    Force of the outermost bearing: bearings of equal load under the whole plan of the tank, the overturning moment at the underside of
    the slab spread over them linearly. Tension is reported, not modelled.
isolation-cycle =
    Effective period and damping are those of a cycle to the largest displacement, with all mass; the march does not use them.
isolation-mesh = Mesh errors are the relative ones of the tank on a fixed base.
isolation-bounded =
    Lower and upper properties are two runs beside that of the nominal ones; between them nothing is run, where a demand may be larger.
isolation-weight =
    Friction and restoring force follow the weight under the vertical motion of the ground; overturning does not change their sum.
    Effective stiffness and damping are with the friction of fast sliding; the bounds scale the friction, not the radius.
isolation-weight-at-rest =
    Without a vertical record, friction and restoring force are those of the weight at rest. Effective stiffness and damping are with
    the friction of fast sliding; the bounds scale the friction, not the radius.
isolation-circle =
    Both horizontal components act on one yield surface, a circle. Displacement and force, and all values with lower and upper
    properties, are those of both components; the largest values of the tank itself are those along x.
isolation-one-component =
    One horizontal component: a second one would lower the friction or yield force along the first.
