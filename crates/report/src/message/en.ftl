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
