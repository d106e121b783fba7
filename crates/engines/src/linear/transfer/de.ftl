transfer = Harmonische Fußpunktbewegung

transfer-meaning =
    Eingeschwungener Zustand unter harmonischer Horizontalbewegung des Bodens, über der Frequenz: die Amplitude bezogen auf ihren
    quasistatischen Wert, der für sehr langsame Bewegung 1 ist. Senkrechte Linien sind Eigenformen des ersten gezeichneten Rechenkerns:
    f_c Schwappen, f_i Struktur. Beträge und Phasen des ersten Rechenkerns stehen in `transfer.csv`, die aller Rechenkerne in
    `results.json` (Reihe `transfer`).
transfer-frequency = Frequenz
transfer-wave_height = Schwapphöhe an der Wand, θ = 0°
transfer-base_shear = Gesamterdbebenkraft
transfer-overturning_moment = Kippmoment (unterhalb der Bodenplatte)
transfer-ratio-wave_height = { transfer-wave_height } zum quasistatischen Wert
transfer-ratio-base_shear = { transfer-base_shear } zum quasistatischen Wert
transfer-ratio-overturning_moment = { transfer-overturning_moment } zum quasistatischen Wert
transfer-m_per_m_s2 = m je m/s²
transfer-n_per_m_s2 = N je m/s²
transfer-nm_per_m_s2 = N·m je m/s²
transfer-caption =
    Quasistatischer Wert { $static } { $unit ->
        [m_per_m_s2] { transfer-m_per_m_s2 }
        [n_per_m_s2] { transfer-n_per_m_s2 }
       *[nm_per_m_s2] { transfer-nm_per_m_s2 }
    }; { $damping ->
        [hysteretic] hysteretische
       *[viscous] viskose
    } Dämpfung mit den Graden der Zeitverlaufsberechnung.
transfer-unit = Einheit
transfer-static = Quasistatisch
transfer-largest = Größter Wert
transfer-amplification = Vergrößerung
transfer-linear =
    Lineare Theorie: die Amplituden gelten, solange Wellen klein sind und die Flüssigkeit die Wand berührt; nahe einer schwach gedämpften
    Schwappform begrenzt das die Bodenbeschleunigung auf sehr kleine Werte.
