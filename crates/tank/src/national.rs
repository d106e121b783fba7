//! Sites of the codes whose procedures follow Housner's two masses: India, and the user's data of any other country.

use crate::keys::{Field, Limits, Number, Opt, Or, keys};
use crate::words;

words! {
    /// Seismic zone of IS 1893-1.
    pub Zone {
        /// Z = 0.10.
        II = "II",
        /// Z = 0.16.
        III = "III",
        /// Z = 0.24.
        IV = "IV",
        /// Z = 0.36.
        V = "V",
    }
}

words! {
    /// Soil type of IS 1893-1.
    pub Soil in "snake_case" {
        /// Type I, rock or hard soil.
        Hard = "hard",
        /// Type II, medium soil.
        Medium = "medium",
        /// Type III, soft soil.
        Soft = "soft",
    }
}

/// Importance factors: 1, 1.5 and 1.75 of IS 1893-2, others nationally.
const IMPORTANCE: Limits = Limits::from(0.5).to(2.0).usual(1.0, 1.75);
/// Factors that reduce a response: from elastic to ductile frames.
const REDUCTION: Limits = Limits::from(1.0).to(8.0).usual(1.0, 5.0);
/// Factor of the sloshing ordinate: 1.75 of IS 1893-2, 1.5 of ACI 350.3.
const DAMPING: Limits = Limits::from(1.0).to(2.0);

keys! {
    /// Site data of IS 1893-2:2014, liquid retaining tanks. With them its procedure runs.
    pub Is1893Site as Is1893 (Copy) {
        /// Seismic zone.
        zone ("IV"): Field<Zone>,
        /// Soil type.
        soil ("medium"): Field<Soil>,
        /// Importance factor I.
        importance (1.5): Or<Number> [IMPORTANCE]
            = default(Number(1.5)).because("IS 1893-2:2014, drinking water and petroleum"),
        /// Response reduction factor R.
        @"Option::is_none" response_reduction (2.0): Opt<Number> [REDUCTION]
            = without("by the kind of base or staging: IS 1893-2:2014 table 2"),
    }

    /// Data of a national code for the chain of Housner's masses with SRSS, beside its spectrum in `site.spectrum`. With them its procedure
    /// runs; no value of the code is checked here.
    pub NationalSite as National {
        /// Name of the code.
        code ("NCh 2369:2023"): Field<String>,
        /// Importance factor on the spectrum.
        importance (1.2): Or<Number> [IMPORTANCE] = default(Number(1.0)).shown("1.0").because("ordinary tank"),
        /// Reduction factor of the impulsive part.
        impulsive_reduction (2.0): Field<Number> [REDUCTION],
        /// Reduction factor of sloshing.
        sloshing_reduction (1.0): Or<Number> [REDUCTION] = default(Number(1.0)).shown("1.0").because("sloshing is elastic"),
        /// Factor on the spectrum for the damping of sloshing.
        @"Option::is_none" sloshing_factor (1.75): Opt<Number> [DAMPING]
            = without("from the damping of the spectrum by η of EN 1998-1:2004 3.2.2.2"),
    }
}
