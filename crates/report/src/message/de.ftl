# Allen Gegenständen gemeinsam.

verbatim = { $text }

quantity = Größe
value = Wert
time = Zeit
ratio = Verhältnis
held = Starrer Fuß
data = Daten

displacement = Verschiebung
rotation = Verdrehung
force = Kraft
x = x
y = y

curve = { $title }, von { $low } bis { $high }.

energy = Energie am Ende
share = Anteil am Eintrag
input = Eintrag des Bodens
viscous = Dämpfung von Wand und Flüssigkeit
body = Kinetisch und in Wand und Flüssigkeit gespeichert

engine = Rechenkern
engine-harmonic = harmonisch
engine-solid = dreidimensional
engine-nonlinear = nichtlinear
by-engine = Nach dem Rechenkern { $engine }: { $text }
line = Kurve
height = Höhe z

on-wall-pressure = Hydrodynamischer Druck auf die Wand
on-wall-hoop_stress = Umfangsmembranspannung
on-wall-axial_membrane_stress = Meridianmembranspannung
on-wall-bending_stress = Meridianbiegespannung, Außenseite
on-wall-radial_displacement = Radialverschiebung
on-wall-wall_moment = Meridianbiegemoment der Wand
on-wall-wall_shear = Querkraft der Wand
on-wall-horizontal_moment = Horizontales Biegemoment in Wandmitte
on-wall-corner_moment = Horizontales Biegemoment der Wand an der Ecke
on-wall-axial_force = Meridiankraft
on-wall-hoop_force = Umfangskraft
on-wall-hoop_moment = Biegemoment in Umfangsrichtung
on-wall-twisting_moment = Drillmoment der Wand
