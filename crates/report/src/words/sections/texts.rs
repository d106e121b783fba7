//! The texts of sections and pages.

/// Title and sentences of a section or page.
pub(super) struct Words {
    pub id: &'static str,
    pub title: &'static str,
    /// Sentences by the key under which the template has them, `words.<key>`; names of files and keys in backquotes.
    pub sentences: &'static [(&'static str, &'static str)],
}

/// A section without sentences.
const fn title(id: &'static str, title: &'static str) -> Words {
    Words { id, title, sentences: &[] }
}

/// All sections and pages.
pub(super) const ALL: &[Words] = &[
    Words {
        id: "summary",
        title: "Summary",
        sentences: &[("standards", "Standards:"), ("who", "Name"), ("when", "Date"), ("signature", "Signature")],
    },
    Words {
        id: "comparison",
        title: "Quantities by method",
        sentences: &[
            ("seismic", "Seismic part alone, absolute maxima over time and circumference."),
            ("engine", "Dashed line: finite elements; × ratio to them."),
            ("outside", "✗: outside the model of the finite elements, see limits of validity."),
            ("design", "Design values: spectrum of the site"),
            ("record", "Under the record"),
            (
                "ratios",
                "Below each value: its ratio to the finite elements under the same excitation. For the spectrum of the site these are the \
                 engine's modes with the response-spectrum method, under the design spectrum named in their column; a code with another \
                 spectrum also differs by its spectrum. Without such a column the ratios refer to the run under the record: they show \
                 the size of the design action, not the accuracy of the method.",
            ),
            (
                "masses",
                "Masses of the finite elements are modal: the impulsive mass is that of the leading mode alone, and a roof that the modes move \
                 more than the wall counts with more than its own mass.",
            ),
        ],
    },
    title("partings", "Differences between methods"),
    Words {
        id: "reported",
        title: "Measured and published values",
        sentences: &[
            (
                "apart",
                "Measured under another ground motion, or under one that the tank file does not name in `motion`: listed, not compared.",
            ),
            (
                "ratios",
                "Ratios are to the finite elements, of periods, of masses and of values that name the ground motion of this run.",
            ),
        ],
    },
    Words {
        id: "attribution",
        title: "Factors of the differences",
        sentences: &[
            (
                "exchange",
                "From the value of the finite elements, one ingredient after the other is exchanged for the procedure's and the \
                 value computed again; the product of the factors is the ratio to the finite elements under the record, also of the \
                 columns of the site.",
            ),
            (
                "order",
                "The order is fixed: the wall held down for a base that lifts; modal maxima combined by SRSS for the history; the \
                 impulsive mode and the first sloshing mode for all modes; masses of liquid, wall, roof, floor and sloshing; lever arms; \
                 stress formulas; rigid wall, plateau and periods; damping; spectrum, code's damping factor, long-period branch, importance \
                 and behaviour factor, bounds; wave formula; combination rule; vertical motion; last the model and the formula of the \
                 procedure. Another order has other factors with the same product.",
            ),
            (
                "bars",
                "Bars on a logarithmic axis; dashed line: the finite elements. Factors within 2 % of 1 share a row.",
            ),
        ],
    },
    Words {
        id: "checks",
        title: "Checks",
        sentences: &[
            ("utilisation", "Utilisation is demand over capacity; the tick on the bar marks 100 %."),
            ("cover", "Why a check fails, is open or is accepted stands on the first page."),
            ("caption", "Limit states"),
            ("others", "Methods that do not decide"),
        ],
    },
    Words {
        id: "tank",
        title: "Datasheet",
        sentences: &[
            ("defaults", "*: default; the full report has its source."),
            (
                "forces",
                "t: as built; N_h, N_i, N_c, N_v: hoop forces of the static, impulsive, convective and vertical pressure at the height z where the \
                 course is used most; σ and its limit as the sheet of the method takes them. –: the method does not give it.",
            ),
        ],
    },
    Words {
        id: "input",
        title: "Input",
        sentences: &[
            ("resolved", "Every value of the input file as resolved."),
            ("defaults", "Values marked `default` were not in the file."),
        ],
    },
    title("motion", "Ground motion"),
    title("spectra", "Spectra"),
    Words {
        id: "record_set",
        title: "Set of records",
        sentences: &[
            ("spectrum", "The set against its target spectrum"),
            ("scatter", "Scatter over the records"),
            ("each", "Record by record"),
            ("seismic", "Seismic part alone, absolute maxima."),
        ],
    },
    Words {
        id: "modes",
        title: "Modes",
        sentences: &[(
            "coupled",
            "Coupled modes of wall and liquid. m: circumferential wave number; effective mass in the direction of shaking.",
        )],
    },
    Words {
        id: "profiles",
        title: "Pressure and stress over the height",
        sentences: &[
            ("side", "At θ = 0, the side towards which the ground moves."),
            (
                "maxima",
                "The codes give absolute maxima; the finite elements give the largest and smallest values over time.",
            ),
            ("after", "Largest and smallest values are those of the record and of the free vibration after it."),
        ],
    },
    Words {
        id: "histories",
        title: "Time histories",
        sentences: &[("marks", "The dot marks the largest absolute value. All samples are in `series.csv`.")],
    },
    Words {
        id: "internal_forces",
        title: "Internal forces of the wall at stations",
        sentences: &[(
            "meaning",
            "Forces and moments a metre of the wall's middle surface: s along the meridian, θ along the circumference; tension and moments \
             that stretch the outer face are positive. Histories are the seismic part; the state at rest under weight and liquid is to be \
             added. A transverse shear force is not given: the harmonic engine's wall is a thin shell without shear strain. All samples are in \
             `series.csv`.",
        )],
    },
    Words {
        id: "base",
        title: "Base: uplift and sliding",
        sentences: &[
            (
                "beside",
                "The tank stands on its bottom plate and lifts or slides. All values of the run are those with a base that rotates and slips; those \
                 of the wall held down stand here beside them. Modes, transfer functions and the response-spectrum method are those of the wall \
                 held down.",
            ),
            (
                "on_anchors",
                "With the wall held down an anchor yields: the tank stands on its bottom plate and on anchors that give way, which hold it in place. All \
                 values of the run are those with a base that rotates; those of the wall held down stand here beside them. Modes, transfer functions \
                 and the response-spectrum method are those of the wall held down.",
            ),
            (
                "band",
                "The ground under the rim is never known well: the same run on a third and on three times its modulus. The spread is that of rotation, \
                 toe stress and shear under motions 0.1 % weaker and stronger and with half the time step; above 5 % the run does not repeat.",
            ),
        ],
    },
    Words {
        id: "directions",
        title: "Two horizontal components",
        sentences: &[
            (
                "together",
                "Both components act together: the largest value over time and circumference, with its direction from x towards y and \
                 its time. Seismic part alone; x, y and the resultant include the response to a vertical record.",
            ),
            (
                "srss",
                "SRSS: the square root of the sum of the squares of the largest values of x and y, which the codes take for components \
                 that do not peak together.",
            ),
        ],
    },
    Words {
        id: "nonlinear",
        title: "Nonlinear run",
        sentences: &[
            (
                "difference",
                "Seismic part alone, absolute maxima. Both runs have the same ground motion, but each has its own duration: where one \
                 continues longer with free vibration after the record, a wave may still rise. Periods and masses are those of \
                 the initial wall.",
            ),
            ("bounds", "≥: the run ended before the ground motion did."),
            ("numbers", "Vertical lines: the events by their numbers."),
            (
                "extremes",
                "Changes from the state at rest, over the record and the free vibration after it; waves and displacements positive upwards \
                 and outwards. Widths of cracks and gaps are the largest so far.",
            ),
            (
                "moments",
                "At the time of the largest reaction of each wall, signed, with the static state. The reaction of the ground combines \
                 the stresses of the section, viscous damping, inertia and the pressure on the lowest element; only the part of the \
                 section is limited by its strength. The last column is the largest bending moment of the lowest section in the \
                 whole run.",
            ),
            (
                "cracks",
                "Strokes run along the cracks; wider cracks have thicker strokes. Height and circumference have different scales; \
                 directions are drawn accordingly.",
            ),
            ("loops", "In the order of time, starting from the static state, which is included."),
        ],
    },
    Words {
        id: "spatial",
        title: "Three-dimensional run",
        sentences: &[
            (
                "difference",
                "Both engines solve the same linear problem on different meshes; they differ by discretisation.",
            ),
            (
                "modes",
                "n: waves around the circumference; m: half waves over the height. The scale of a mode is arbitrary; dashed: \
                 undeformed.",
            ),
            (
                "moments",
                "Displacements relative to the ground; wall and free surface are each enlarged by their own factor.",
            ),
            ("maps", "Static state and earthquake together. Lines join equal values, at the ticks of the bar."),
        ],
    },
    Words {
        id: "around",
        title: "Waves around the imperfect wall",
        sentences: &[(
            "why",
            "A perfect cylinder responds to horizontal motion in a single wave around the tank. Where its radius deviates in n waves, the hoop \
             force and the pressure of that motion act on the deviation and excite n − 1 and n + 1 waves. Seismic part; largest amplitudes \
             over the height and over time, at different times.",
        )],
    },
    Words {
        id: "sheets",
        title: "Calculation sheets",
        sentences: &[
            ("record", "the sheet for the record"),
            ("from", "from"),
            ("beside", "A clause beside a heading is that of the lines below it that name none."),
            (
                "others",
                "The sheets of the procedures that do not decide are in the full report: `tankcheck report FOLDER --report full`.",
            ),
        ],
    },
    Words {
        id: "engine",
        title: "Finite-element model",
        sentences: &[(
            "mesh_error",
            "From a second mesh by Richardson's extrapolation, relative; accurate within a factor of about 2 above 0.2 %.",
        )],
    },
    title("limits", "Limits of validity"),
    Words {
        id: "provenance",
        title: "Provenance and reproduction",
        sentences: &[(
            "reproduce",
            "To reproduce, put files with these hashes in one folder and run the command line below; `tankcheck diff` compares the two \
             results folders number by number.",
        )],
    },
    Words {
        id: "ida",
        title: "Incremental dynamic analysis",
        sentences: &[
            (
                "interrupted",
                "The analysis was interrupted and runs are missing; use `--resume` with the same command to continue.",
            ),
            (
                "moment",
                "Base moment: reaction of the ground, with damping and inertia. Moment of the section: largest bending moment of the \
                 lowest section, the integral of its stresses, which its strength limits.",
            ),
            (
                "outside",
                "These runs exceed limits of the theory: results that depend on these limits are indicative only.",
            ),
            ("extremes", "Changes from the state at rest; waves and displacements positive upwards and outwards."),
            (
                "departures",
                "These runs passed a limit of the model: their later values are not results. Runs that gained energy were stopped there.",
            ),
            ("collapses", "The values of these runs end with the collapse and are lower bounds."),
        ],
    },
    Words {
        id: "push",
        title: "Pushover",
        sentences: &[
            (
                "beam",
                "Axial stress M/(π R² t) and weight at the lower edge of every course; the table has the governing course and the limit \
                 at that acceleration.",
            ),
            (
                "base",
                "The foot of the wall on its bottom plate. Rotation: the part of the foot's deflection that is proportional to cos θ, over \
                 R; the moment of the wall on the base from the reactions of the ground; uplift, lifted width and plastic rotation of the \
                 joint on the lifted side; lifted angle: all of the circumference that is off the ground. Moment of the strips: that of the \
                 fast engines, with the same rim or the same plane foot, at the same rotation and bottom pressure.",
            ),
            (
                "strips",
                "Shells beside strips. Toe stress: axial membrane compression of the lowest row of elements at the toe, and of a foot that is kept \
                 plane the reaction of the ground there. The plastic rotation of \
                 the joint is that of the plate and that of the wall together; the strips have an elastic wall, so theirs is in the plate \
                 alone.",
            ),
        ],
    },
];
