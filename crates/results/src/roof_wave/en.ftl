roof_wave = Wave and roof

roof_wave-reached =
    The crest of { $crest } ({ $method }) passes the freeboard of { $freeboard }: the wave presses on the roof. The roof has no resistance in the tank
    file, so that nothing here is checked.
roof_wave-at_rest = Pressure of the wave, and mass that the roof stops
roof_wave-method = Method
roof_wave-record = { $method }, record
roof_wave-site = { $method }, site
roof_wave-crest = Crest
roof_wave-from = Pressed from r
roof_wave-pressure = Pressure at the wall, at least
roof_wave-stopped =
    The surface is that of the first mode, nearly a plane; its pressure is that of liquid at rest, a lower bound. The share 1 − d_f/d of the
    convective mass moves with the tank (Malhotra 2005) and adds its force, with the spectral acceleration at the impulsive period, to the impulsive part
    of the base shear. The base shear of the methods does not contain it.
roof_wave-at_rest-stopped = Stopped share
roof_wave-mass = Stopped mass
roof_wave-shear = Its force
roof_wave-of_shear = Of the base shear
roof_wave-impact = Impact on the roof
roof_wave-speed = Velocity
roof_wave-angle = Angle of surface and roof
roof_wave-least = Pressure, from
roof_wave-most = to
roof_wave-range =
    Velocity ω_1 d √(1 − (d_f/d)²) at which the surface meets the roof at the wall. The range is an assumption: from ½ ρ V² of a jet to Wagner's
    wedge, ½ ρ V² π²/(4 tan² b), with an angle b of at least 4°, below which air stays under the roof. Such a peak is local and lasts milliseconds;
    single impacts scatter by a factor of 6.

roof_wave-carried =
    The floating roof of { $mass } is a mass on the surface without stiffness: it lengthens the periods of the waves.
roof_wave-modes = Modes under the floating roof
roof_wave-mode = Mode
roof_wave-free = Period, free surface
roof_wave-loaded = With the roof
roof_wave-wave = Wave at the wall
roof_wave-bent =
    The second mode, { $wave } at the wall, bends the roof there to a radius of { $radius }: a deck or pontoon of the bending stiffness EI has the moment
    EI over that radius. A membrane that stays on the surface shortens by { $shortening } of its radius, which presses on the pontoon.
roof_wave-assumed =
    Waves by the spectrum of the site, without one by the record, with the damping of the sloshing modes. A roof that is stiff in bending or has seals damps
    them (1 % is usual).
