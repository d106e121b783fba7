tilt = Static tilt test

tilt-rest =
    Tank and liquid at rest on a tilted base: weight and pressure of the tilted tank, in axes of the tank. θ = 0 is the low
    side. Linear: the wall is not wetted higher on the low side.
tilt-angle = Angle
tilt-base_shear = Base shear
tilt-base_moment = Moment above the base plate
tilt-overturning_moment = Moment below the base plate
tilt-rise = Rise of the surface at the wall

tilt-overtops =
    Tilted by { $angle } the surface rises by { $rise } at the wall, above the freeboard of { $freeboard }: the liquid overtops or
    presses on the roof, which the tilt test does not model.
tilt-dry = Tilted by { $angle } the liquid leaves a part of the bottom dry, which the tilt test does not model.
tilt-wetted =
    Tilted by { $angle } the wetted part of the wall changes by { $rise } on both sides, which the linear tilt test leaves out.

tilt-over-height = Over the height, including weight and pressure.
tilt-chart = { $of }, tilted
tilt-on-wall-pressure = Pressure on the wall
tilt-low = θ = 0°, low side
tilt-high = θ = 180°, high side
