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
