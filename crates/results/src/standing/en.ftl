standing = Base under the moments of the codes

standing-about =
    The tank has no anchors. Strips of the bottom plate side by side hold a wall whose foot warps as its rim lets it; plates, wall and weight are those
    of the sheet: less corrosion, vertical motion and overpressure. A given stiffness of the ground decides, of assumed ones the least
    favourable.
standing-with-weight = Under { $moment }, the moment of { $method }, with { $weight } of wall and roof as on its sheet.
standing-moment = Under { $moment }, the moment of { $method }.
standing-softened =
    Rotation, uplift and toe stress do not hold: the bottom pressure of the motion reaches { $share } of that at rest, above { $limit }, if
    all of the moment is that of impulsive liquid. Under a rim of the wall that is not round, strips, which leave that
    pressure out, then lift less than shells and have too little stress at the toe. Take a record and the nonlinear engine, whose wall and
    bottom are shells.
standing-ground = Ground under the rim
standing-information = { $ground }, for information
standing-not-held = not held
standing-grounds-rotation = Rotation of the base
standing-uplift = Uplift
standing-lifted_width = Lifted width
standing-plastic_rotation = Plastic rotation
standing-toe_axial_stress = Toe stress

standing-moment_rotation = Moment of the base against its rotation
standing-lifted = Lifted bottom plate
standing-pressed = Pressure of the ground under it
standing-exaggerated = At the lifted side, on { $ground }; heights are exaggerated.
standing-moment_rotation-moment = Moment
standing-distance = Distance from the wall
standing-deflection = Deflection
standing-pressure = Pressure
standing-level = ground
standing-plate = plate
standing-yielded = yielded
