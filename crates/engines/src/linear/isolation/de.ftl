isolation = Isolatoren

isolation-beside =
    Die Platte unter dem Tank steht auf Isolatoren. Alle Werte des Laufs sind die auf Isolatoren, auch Welle und Freibord; die auf
    starrem Fuß stehen hier daneben. Die Welle kann wachsen, wo die effektive Periode der des Schwappens nahekommt. Rohrleitungen
    müssen der Verschiebung der Isolatoren folgen.
isolation-another =
    Die Platte unter dem Tank steht auf Isolatoren. Alle Werte des Laufs sind die auf Isolatoren, auch Welle und Freibord. Die Platte
    bewegt sich nach der Zeitintegration des linearen Rechenkerns, unter der Fußquerkraft dieses Laufs über die seiner Eigenformen hinaus.
    Rohrleitungen müssen der Verschiebung der Isolatoren folgen.
isolation-isolators =
    { $kind ->
        [friction_pendulum] Reibungspendel
        [lead_rubber] Blei-Gummi-Lager
       *[elastomer] Lineare Lager
    }{ $dampers ->
        [yes] { " " }und viskose Dämpfer
       *[no] { "" }
    } unter einer Platte von { $slab }; insgesamt { $mass } darauf. Zeitschritt { $step }.

isolation-values = Größte Werte auf Isolatoren
isolation-values-value = Auf Isolatoren
isolation-isolator_displacement = Verschiebung der Isolatoren über die Zeit
isolation-loop = Kraft der Isolatoren über ihrer Verschiebung
isolation-values-isolator_displacement = Größte Verschiebung der Isolatoren
isolation-isolator_residual = Ihre Verschiebung am Ende
isolation-isolator_force = Größte Kraft der Isolatoren
isolation-effective_stiffness = Effektive Steifigkeit bei der größten Verschiebung
isolation-effective_period = Effektive Periode dort
isolation-effective_damping = Effektive Dämpfung dort
isolation-bearing_share = Kleinste Kraft des äußersten Lagers zu der in Ruhe; unter 0 Zug, der nicht abgebildet ist
isolation-base_shear = Gesamterdbebenkraft des Tanks
isolation-base_moment = Wandfußmoment (oberhalb der Bodenplatte)
isolation-overturning_moment = Kippmoment
isolation-sloshing_height = Schwapphöhe
isolation-hoop_stress = Größte Umfangsspannung bis zum ruhenden Spiegel
isolation-rim_hoop_stress = Größte Umfangsspannung des Randes darüber
isolation-axial_membrane_stress = Meridianspannung am Wandfuß
isolation-bending_stress = Meridianbiegespannung am Wandfuß

isolation-band = Werte mit oberen und unteren Eigenschaften
isolation-factor = Faktor der Eigenschaften
isolation-band-isolator_displacement = Verschiebung
isolation-band-isolator_force = Kraft
isolation-band-effective_period = Effektive Periode
isolation-band-effective_damping = Effektive Dämpfung
isolation-band-base_shear = Gesamterdbebenkraft
isolation-bounds =
    Die Eigenschaften von Isolatoren streuen mit Verschleiß, Temperatur und Herstellung: derselbe Lauf mit unterer und oberer Schranke
    von Steifigkeit, Festigkeit, Reibung und Dämpfung, außer der Steifigkeit, die ein Pendel aus seinem Radius hat. Die Verschiebung
    bestimmt die untere Schranke, die Kräfte meist die obere.

isolation-energies = Energien des isolierten Tanks
isolation-energies-isolators = Isolatoren, gespeichert und dissipiert
isolation-balance =
    Die Energiebilanz geht bis auf { $error } des Eintrags auf. Die Kraft der Isolatoren aus den überlagerten Eigenformen, deren Werte
    angegeben werden, und aus der Zeitintegration stimmen auf { $superposition } überein.
isolation-balance-another =
    Die Energiebilanz geht bis auf { $error } des Eintrags auf. Die Fußquerkraft des letzten Laufs weicht von der, mit der sich seine Platte
    bewegt hat, um höchstens { $change } der größten Kraft der Isolatoren ab. Werte mit oberen und unteren Eigenschaften sind die des linearen
    Rechenkerns.

isolation-rigid = Die Platte ist starr, dreht sich nicht und trägt den auf ihr eingespannten Tank.
isolation-follows =
    Wand und Flüssigkeit folgen der Beschleunigung der Platte, wie sie deren Zeitintegration ergibt. Verschiebungen der Wand sind die
    relativ zur Platte.
isolation-mass =
    Die Masse des Tanks auf den Isolatoren ist die gesamte Flüssigkeit, Wand und Dach; ihre Schwappformen bewegen sich frei auf der Platte.
isolation-outermost =
    Kraft des äußersten Lagers: gleich belastete Lager unter dem ganzen Grundriss des Tanks, das Kippmoment an der Plattenunterseite
    linear darüber verteilt. Zug wird angegeben, nicht abgebildet.
isolation-cycle =
    Effektive Periode und Dämpfung sind die eines Zyklus bis zur größten Verschiebung, mit der gesamten Masse; die Zeitintegration
    verwendet sie nicht.
isolation-mesh = Die Netzfehler sind die relativen des Tanks auf starrem Fuß.
isolation-bounded =
    Untere und obere Eigenschaften sind zwei Läufe neben dem mit den nominellen; dazwischen wird nichts gerechnet, wo eine Beanspruchung
    größer sein kann.
isolation-weight =
    Reibung und Rückstellkraft folgen dem Gewicht unter der Vertikalbewegung des Bodens; das Kippen ändert ihre Summe nicht. Effektive
    Steifigkeit und Dämpfung gelten mit der Reibung schnellen Gleitens; die Schranken skalieren die Reibung, nicht den Radius.
isolation-weight-at-rest =
    Ohne vertikales Akzelerogramm sind Reibung und Rückstellkraft die des Ruhegewichts. Effektive Steifigkeit und Dämpfung gelten mit
    der Reibung schnellen Gleitens; die Schranken skalieren die Reibung, nicht den Radius.
isolation-circle =
    Beide Horizontalkomponenten wirken auf eine Fließfläche, einen Kreis. Verschiebung und Kraft sowie alle Werte mit unteren und oberen
    Eigenschaften sind die beider Komponenten; die größten Werte des Tanks selbst sind die entlang x.
isolation-one-component =
    Eine Horizontalkomponente: eine zweite würde die Reibungs- oder Fließkraft längs der ersten verringern.
