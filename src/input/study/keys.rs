//! The keys of `study.json`.
//!
//! Keys and meaning are a contract: extend freely, do not rename.

use crate::input::tank::choice::choice;
use crate::input::tank::given::Given;
use crate::input::tank::read::{Field, Opt, object};
use crate::input::tank::values::{Named, Number, Whole};
use ::tank::keys::{Absent, Limits, default};
use ::tank::words;

/// Most tanks, record sets, levels or parameters of a study.
const MOST: usize = 10_000;

object! {
    /// Many tanks under many records.
    StudyFile {
        /// Title of the study.
        name ("Terminal North"): Field<String>,
        /// Remarks; not evaluated.
        notes: Opt<String>,
        /// Cover of the report.
        project: Opt<Given<::tank::Project>>,
        /// The tanks: files, or a template with a table.
        tanks: Field<Vec<Field<Tanks>>> [Limits::ANY.items(1, MOST)],
        /// The records. Without them the codes are run under the design spectra of the tanks.
        records: Opt<Vec<Field<Records>>> [Limits::ANY.items(1, MOST)],
        /// The scales of every record.
        scales: Opt<Scales>,
        /// Parameters that are sampled.
        sample: Opt<Sample>,
        /// Finite-element engine.
        engine: Opt<StudyEngine> = default(StudyEngine::Harmonic),
        /// Procedures to run.
        procedures: Opt<Vec<Field<String>>> = Absent::Follows("those of each tank file"),
        /// Damage states.
        damage: Opt<Vec<Field<Damage>>> [Limits::ANY.items(1, 100)] = Absent::Follows("the default set"),
        /// How curves are found: `stripes`, `cloud` or `capacities`.
        method: Opt<CurveMethod> = Absent::Follows("stripes for levels, cloud for factors"),
        /// Rule that the records have to keep; `study plan` checks it.
        rule: Opt<Rule>,
        /// Hazard curve of the site: a CSV file with the columns im and rate (a year), in the unit of the measure in SI.
        hazard ("hazard.csv"): Opt<String>,
        /// Records of one task: they share mesh, modes and code periods, and are lost together when a machine dies.
        block (10): Opt<Whole> [Limits::count(1, 10_000)] = default(Whole(10)),
    }

    /// Tanks: `files`, or `template` with `table`.
    Tanks {
        /// A tank file, or several by a pattern with `*` and `?`; relative to the study file.
        files ("farm/*.json"): Opt<String>,
        /// A tank file with values from a table.
        template ("t05.json"): Opt<String>,
        /// A CSV table with a line a tank; relative to the study file.
        table ("farm.csv"): Opt<String>,
        /// Column of the table → path in the tank file.
        columns: Opt<Named<String>> = Absent::Follows("every column but that of `id` is a path of the tank file"),
        /// Column of the table with the name of the tank.
        id ("tag"): Opt<String> = Absent::Follows("the number of the row"),
    }

    /// Records of one set.
    Records {
        /// A record, or several by a pattern with `*` and `?`; relative to the study file.
        files ("set/*.at2"): Field<String>,
        /// Unit of the accelerations, where the files do not give it: g, gal, m/s2 and others of `--units`.
        units ("g"): Opt<String>,
        /// Time step in seconds of files without a time column.
        dt (0.01): Opt<Number> [Limits::from(1e-5).to(10.0)],
        /// Components by the names of their files.
        components: Opt<Components>,
    }

    /// The part of a file's name that tells its component. A file without the part of `along` is another component or none. Parts such as `#2` or
    /// `#N-S` are channels of one file.
    Components {
        /// The component along x.
        along ("_NS"): Field<String>,
        /// The horizontal component along y.
        across ("_EW"): Opt<String>,
        /// The vertical component.
        up ("_UP"): Opt<String>,
    }

    /// Scales: `levels` of an intensity measure, or `factors` on the records as they are.
    Scales {
        /// Intensity measure: PGA, PGV, PGD, Sa(T), Sa(T, xi), AvgSa(T), AvgSa(T, xi); T is a time, Ti or Tc, the first impulsive and sloshing
        /// period of the tank (of the harmonic engine). Of two horizontal components the geometric mean.
        im ("Sa(0.3 s, 5 %)"): Opt<String> = Absent::Follows("PGA"),
        /// Levels of the measure, ascending.
        levels: Opt<Vec<Field<String>>> [Limits::ANY.items(1, 1000)],
        /// Factors on the records, ascending.
        factors: Opt<Vec<Field<Number>>> [Limits::above(0.0).to(1000.0).items(1, 1000)] = Absent::Follows("1"),
    }

    /// Samples of each tank. Sample i does not depend on their number.
    Sample {
        /// Number of samples.
        n (64): Field<Whole> [Limits::count(1, 65_536)],
        /// Sequence of the samples.
        method: Opt<SampleMethod> = default(SampleMethod::Sobol),
        /// Seed.
        seed (7): Opt<Whole> [Limits::count(0, u32::MAX)] = default(Whole(0)),
        /// The parameters.
        parameters: Field<Vec<Field<Parameter>>> [Limits::ANY.items(1, 100)],
    }

    /// A sampled value of the tank file, with one distribution.
    Parameter {
        /// Path of the tank file.
        path ("liquid.fill_height"): Field<String>,
        /// Uniform between two values.
        uniform: Opt<Range>,
        /// Normal.
        normal: Opt<Normal>,
        /// Lognormal.
        lognormal: Opt<Lognormal>,
        /// Beta, between two bounds.
        beta: Opt<Beta>,
    }

    /// A uniform distribution.
    Range {
        /// Lowest value.
        low ("8 m"): Field<String>,
        /// Highest value.
        high ("14 m"): Field<String>,
    }

    /// A normal distribution.
    Normal {
        /// Mean.
        mean ("250 MPa"): Field<String>,
        /// Coefficient of variation.
        cov (0.07): Field<Number> [Limits::above(0.0).to(1.0)],
    }

    /// A lognormal distribution.
    Lognormal {
        /// Median.
        median ("250 MPa"): Field<String>,
        /// Standard deviation of the logarithm.
        beta (0.07): Field<Number> [Limits::above(0.0).to(2.0)],
    }

    /// A beta distribution: shares of a reference value, such as the fill of a tank.
    Beta {
        /// The reference value.
        of ("15 m"): Field<String>,
        /// Mean share.
        mean (0.75): Field<Number>,
        /// Coefficient of variation of the share.
        cov (0.2): Field<Number> [Limits::above(0.0).to(1.0)],
        /// Smallest share.
        min (0.1): Opt<Number> = default(Number(0.0)),
        /// Largest share.
        max (0.95): Opt<Number> = default(Number(1.0)),
    }

    /// A rule for the set of records, as `tankcheck quake set` has it.
    Rule {
        /// The rule.
        code: Opt<RuleCode> = default(RuleCode::En1998),
        /// Target: `site`, the elastic spectrum of EN 1998 of each tank, or a CSV table.
        target ("spectrum.csv"): Opt<String> = Absent::Follows("site"),
        /// Periods: `both` (impulsive and sloshing), `impulsive`, `sloshing`, or a time.
        periods ("0.3 s"): Opt<String> = Absent::Follows("both"),
    }

    /// A way into a damage state: a demand that reaches a limit. Several of one state are alternatives.
    Damage {
        /// Name of the state, in the order of severity: DS1, DS2, …
        state ("DS3"): Field<String>,
        /// Id of a limit state of the engine (`tankcheck explain` lists them): its largest utilisation is compared. Or `collapse`.
        demand ("freeboard"): Field<String>,
        /// Utilisation at which the state begins.
        limit (1.0): Opt<Number> [Limits::above(0.0).to(100.0)] = default(Number(1.0)),
        /// Source of the limit.
        source ("Bakalis et al. 2017"): Opt<String>,
    }
}

words! {
    /// Finite-element engine of a study.
    pub(crate) StudyEngine {
        /// One Fourier harmonic at a time, linear: records and scales share one model.
        Harmonic = "harmonic",
        /// Three-dimensional elements, linear.
        Solid = "solid",
        /// Walls that yield and crack: one run for each scale.
        Nonlinear = "nonlinear",
        /// The codes alone.
        None = "none",
    }
}

words! {
    /// How curves are found.
    pub(crate) CurveMethod {
        /// Counts at levels, by maximum likelihood.
        Stripes = "stripes",
        /// Regression of the largest demand over its limit, collapses by logistic regression.
        Cloud = "cloud",
        /// The level at which each record reaches the state (incremental dynamic analysis).
        Capacities = "capacities",
    }
}

choice!(CurveMethod, SampleMethod, RuleCode, StudyEngine);

words! {
    /// Sequence of the samples.
    pub(crate) SampleMethod {
        /// A scrambled Sobol sequence (Burley 2020).
        Sobol = "sobol",
        /// A Latin hypercube that grows: of the first 2, 4, 8, … samples each parameter has one in each equally probable part (Qian 2009).
        Latin = "latin",
    }
}

words! {
    /// Rule for the set of records.
    pub(crate) RuleCode {
        /// EN 1998-1:2004 3.2.3.1.2(4).
        En1998 = "en1998-1",
    }
}
