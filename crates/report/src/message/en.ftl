# Common to all subjects.

verbatim = { $text }

quantity = Quantity
value = Value
time = Time
ratio = Ratio
held = Fixed base
data = Data

displacement = Displacement
rotation = Rotation
force = Force
x = x
y = y

curve = { $title }, from { $low } to { $high }.

energy = Energy at the end
share = Share of the input
input = Input of the ground
viscous = Damping of wall and liquid
body = Kinetic and stored in wall and liquid

engine = Engine
engine-harmonic = harmonic
engine-solid = three-dimensional
engine-nonlinear = nonlinear
by-engine = By the { $engine } engine: { $text }
line = Curve
height = Height z

on-wall-pressure = Hydrodynamic pressure on the wall
on-wall-hoop_stress = Hoop membrane stress
on-wall-axial_membrane_stress = Axial membrane stress
on-wall-bending_stress = Meridional bending stress, outer face
on-wall-radial_displacement = Radial displacement
on-wall-wall_moment = Meridional bending moment of the wall
on-wall-wall_shear = Shear force of the wall
on-wall-horizontal_moment = Horizontal bending moment in the middle of the wall
on-wall-corner_moment = Horizontal bending moment of the wall at its corner
on-wall-axial_force = Meridional membrane force
on-wall-hoop_force = Hoop membrane force
on-wall-hoop_moment = Bending moment along the circumference
on-wall-twisting_moment = Twisting moment of the wall
