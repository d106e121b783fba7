roof_wave = Welle und Dach

roof_wave-reached =
    Der Wellenberg von { $crest } ({ $method }) ist höher als der Freibord von { $freeboard }: die Welle drückt auf das Dach. Die Eingabe gibt keinen
    Widerstand des Dachs an, so dass hier nichts nachgewiesen wird.
roof_wave-at_rest = Druck der Welle, und Masse, die das Dach aufhält
roof_wave-method = Verfahren
roof_wave-record = { $method }, Akzelerogramm
roof_wave-site = { $method }, Standort
roof_wave-crest = Wellenberg
roof_wave-from = Gedrückt ab r
roof_wave-pressure = Druck an der Wand, mindestens
roof_wave-stopped =
    Der Spiegel ist der der ersten Eigenform, nahezu eben; sein Druck ist der ruhender Flüssigkeit, eine untere Schranke. Der Anteil 1 − d_f/d der
    konvektiven Masse bewegt sich mit dem Tank (Malhotra 2005); seine Kraft mit der Spektralbeschleunigung bei der impulsiven Periode kommt zum impulsiven
    Teil der Gesamterdbebenkraft hinzu. Die Gesamterdbebenkraft der Verfahren enthält sie nicht.
roof_wave-at_rest-stopped = Aufgehaltener Anteil
roof_wave-mass = Aufgehaltene Masse
roof_wave-shear = Ihre Kraft
roof_wave-of_shear = Von der Gesamterdbebenkraft
roof_wave-impact = Aufprall auf das Dach
roof_wave-speed = Geschwindigkeit
roof_wave-angle = Winkel von Spiegel und Dach
roof_wave-least = Druck, von
roof_wave-most = bis
roof_wave-range =
    Geschwindigkeit ω_1 d √(1 − (d_f/d)²), mit der der Spiegel an der Wand auf das Dach trifft. Der Bereich ist eine Annahme: von ½ ρ V² eines Strahls
    bis zum Keil nach Wagner, ½ ρ V² π²/(4 tan² b), mit einem Winkel b von mindestens 4°, unter dem Luft unter dem Dach bleibt. Ein solcher Druck ist
    örtlich und dauert Millisekunden; einzelne Aufpralle streuen um den Faktor 6.

roof_wave-carried =
    Das Schwimmdach von { $mass } ist eine Masse ohne Steifigkeit auf dem Spiegel: es verlängert die Perioden der Wellen.
roof_wave-modes = Eigenformen unter dem Schwimmdach
roof_wave-mode = Eigenform
roof_wave-free = Periode, freier Spiegel
roof_wave-loaded = Mit dem Dach
roof_wave-wave = Welle an der Wand
roof_wave-bent =
    Die zweite Eigenform, { $wave } an der Wand, biegt das Dach dort auf einen Halbmesser von { $radius }: ein Deck oder Ponton der Biegesteifigkeit EI hat
    das Moment EI durch diesen Halbmesser. Eine Membran, die auf dem Spiegel bleibt, verkürzt sich um { $shortening } ihres Halbmessers, was auf den Ponton
    drückt.
roof_wave-assumed =
    Wellen nach dem Spektrum des Standorts, ohne eines nach dem Akzelerogramm, mit der Dämpfung der Schwappformen. Ein biegesteifes Dach oder eines mit
    Dichtungen dämpft sie (1 % ist üblich).
