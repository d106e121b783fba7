tilt = Statischer Kippversuch

tilt-rest =
    Tank und Flüssigkeit in Ruhe auf geneigtem Boden: Gewicht und Druck des geneigten Tanks, in Achsen des Tanks. θ = 0 ist die tiefe
    Seite. Linear: die Wand wird auf der tiefen Seite nicht höher benetzt.
tilt-angle = Winkel
tilt-base_shear = Gesamterdbebenkraft
tilt-base_moment = Wandfußmoment (oberhalb der Bodenplatte)
tilt-overturning_moment = Moment unterhalb der Bodenplatte
tilt-rise = Anstieg des Spiegels an der Wand

tilt-overtops =
    Um { $angle } geneigt steigt der Spiegel an der Wand um { $rise }, über den Freibord von { $freeboard } hinaus: die Flüssigkeit
    läuft über oder drückt auf das Dach, was der Kippversuch nicht abbildet.
tilt-dry = Um { $angle } geneigt lässt die Flüssigkeit einen Teil des Bodens trocken, was der Kippversuch nicht abbildet.
tilt-wetted =
    Um { $angle } geneigt ändert sich der benetzte Teil der Wand auf beiden Seiten um { $rise }, was der lineare Kippversuch außer Ansatz lässt.

tilt-over-height = Über die Höhe, einschließlich Gewicht und Druck.
tilt-chart = { $of }, geneigt
tilt-on-wall-pressure = Druck auf die Wand
tilt-low = θ = 0°, tiefe Seite
tilt-high = θ = 180°, hohe Seite
