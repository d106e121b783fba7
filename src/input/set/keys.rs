//! The keys of `set.json`.
//!
//! Keys and meaning are a contract: extend freely, do not rename.

use crate::input::tank::choice::choice;
use crate::input::tank::read::{Field, Opt, object};
use crate::input::tank::values::Number;
use ::tank::keys::{Absent, Limits, default};
use ::tank::words;

/// Most records of a set.
const MOST: usize = 100;

object! {
    /// A set of records for one verification.
    SetFile {
        /// Title of the set.
        name ("Seven records for the spectrum of the site"): Opt<String>,
        /// Remarks; not evaluated.
        notes: Opt<String>,
        /// Code whose rules the set keeps.
        code: Opt<SetCode> = Absent::Follows("en1998-1, or asce7-16 where the site of the tank is that of API 650 alone"),
        /// Design value: `mean` of the maxima, or the `worst` of them.
        combine: Opt<SetCombine> = Absent::Follows("the mean from as many records as the code asks for, else the worst"),
        /// Target spectrum: `site`, the elastic spectrum of the tank's site, or a CSV table of the 5 % spectrum.
        target ("spectrum.csv"): Opt<String> = Absent::Follows("site"),
        /// Factor on all records, after the processing of the tank file.
        factor (1.2): Opt<Number> [Limits::above(0.0).to(1000.0)] = default(Number(1.0)),
        /// Multiply the set by the one factor with which the rule for its spectrum just holds.
        fit (true): Opt<bool> = default(false),
        /// The records, three or more.
        records: Field<Vec<Field<SetRecord>>> [Limits::ANY.items(3, MOST)],
    }

    /// An earthquake: one file, or a channel of one (`station.V2#2`), a component, relative to the set file. All of a set have the same components.
    SetRecord {
        /// Name in tables; unique.
        name ("El Centro 1940"): Opt<String> = Absent::Follows("the name of the file along x"),
        /// The component along x.
        along ("elcentro-ns.csv"): Field<String>,
        /// The horizontal component along y.
        across ("elcentro-ew.csv"): Opt<String>,
        /// The vertical component.
        up ("elcentro-up.csv"): Opt<String>,
        /// Unit of the accelerations, where the files do not give it: g, gal, m/s2 and others of `--units`.
        units ("g"): Opt<String>,
        /// Time step in seconds of files without a time column.
        dt (0.01): Opt<Number> [Limits::from(1e-5).to(10.0)],
        /// Factor on this record.
        scale (0.8): Opt<Number> [Limits::above(0.0).to(1000.0)] = default(Number(1.0)),
    }
}

words! {
    /// Code whose rules a set keeps.
    pub(crate) SetCode {
        /// EN 1998-1:2004 3.2.3.1.2(4) and 4.3.3.4.3(3).
        En1998 = "en1998-1",
        /// ASCE/SEI 7-16 chapter 16, recalled.
        Asce716 = "asce7-16",
    }
}

choice!(SetCode, SetCombine);

words! {
    /// Design value of a set.
    pub(crate) SetCombine {
        /// Mean of the maxima.
        Mean = "mean",
        /// Largest of the maxima.
        Worst = "worst",
    }
}
