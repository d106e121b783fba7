//! The self-test: a row or two for each code and each engine, whose answers are known from elsewhere. It shows that this program computes on
//! this machine what it should; the verification manual (`docs/verification`) has all rows, and the program `verification` runs them.

mod models;

use codes::api650::{edition1993::Api6501993, edition2020::Api6502020};
use codes::ec8::{En2006, Env1998};
use codes::housner::Housner;
use engines::Options;
use engines::solid::{MeshSize, SolidOptions};
use fem::analysis::scheme::TimeScheme;
use fem::analysis::spectrum::correlation;
use fem::progress::Silent;
use fragility::stripes::{Stripe, fit};
use oscillator::sdof::Recurrence;
use soil::disc::{Disc, Soil};
use soil::isolator::{Friction, Isolator};
use std::error::Error;
use std::f64::consts::{PI, TAU};
use tank::case::GroundType;
use tank::reference::{broad, case, material};
use tank::{Quantity, Shape};

use models::*;

/// A computed value, or why there is none.
pub type Answer = Result<f64, Box<dyn Error>>;

/// A value with its reference.
pub struct Row {
    /// The code or engine.
    pub id: &'static str,
    /// The quantity, in words.
    pub what: &'static str,
    /// Where the reference comes from.
    pub source: &'static str,
    /// Reference value, in `unit`; never 0.
    pub reference: f64,
    /// Allowed deviation, relative to the reference.
    pub tolerance: f64,
    /// Unit.
    pub unit: &'static str,
    /// Computes the value, in `unit`.
    pub compute: fn() -> Answer,
}

impl Row {
    /// Deviation of a value, relative to the reference.
    pub fn error(&self, value: f64) -> f64 {
        (value - self.reference) / self.reference.abs()
    }

    /// Whether a value is within the tolerance.
    pub fn holds(&self, value: f64) -> bool {
        self.error(value).abs() <= self.tolerance
    }
}

const fn row(
    (id, what): (&'static str, &'static str),
    (reference, source): (f64, &'static str),
    (tolerance, unit): (f64, &'static str),
    compute: fn() -> Answer,
) -> Row {
    Row {
        id,
        what,
        source,
        reference,
        tolerance,
        unit,
        compute,
    }
}

const EXAMPLE: &str =
    "worked example of an oil tank, R = 15 m, H = 12 m, by an independent script from the text of the code";
const STATICS: &str = "statics";

/// All rows. Tolerances are half the last printed digit, rounding for closed forms, and those of the same rows in the manual for meshes.
pub const ROWS: &[Row] = &[
    row(
        ("housner", "impulsive mass over that of the liquid, R/H = 1.2"),
        (0.466_292_76, "tanh(√3 R/H)/(√3 R/H)"),
        (1e-6, "1"),
        || {
            let mut case = broad(1000.0);
            case.site.ec8 = Some(ec8(GroundType::A, 0.5, 1.0));
            let mass = value(&Housner, &case, Quantity::ImpulsiveMass)?;
            Ok(mass / case.liquid_mass())
        },
    ),
    row(
        (
            "ec8-env",
            "sloshing height of an aluminium tank, R = 1.83 m, H = 1.525 m",
        ),
        (0.560, "Brüggemann 2002, table D.3, with η unrounded"),
        (9e-4, "m"),
        || {
            let mut case = broad(1000.0);
            case.site.ec8 = Some(ec8(GroundType::A, 0.5, 1.0));
            (case.damping.sloshing, case.damping.impulsive) = (0.01, 0.01);
            value(&Env1998, &case, Quantity::SloshingHeight)
        },
    ),
    row(
        ("ec8-2006", "impulsive period"),
        (0.19050, EXAMPLE),
        (2.7e-5, "s"),
        || line(&En2006, "T_imp", 1.0),
    ),
    row(
        ("ec8-2006", "impulsive base shear"),
        (35_677.4, EXAMPLE),
        (1.5e-6, "kN"),
        || line(&En2006, "Q_i", 1e-3),
    ),
    row(
        ("api650-1993", "overturning moment"),
        (40.445, EXAMPLE),
        (1.3e-5, "MN m"),
        || line(&Api6501993, "M", 1e-6),
    ),
    row(
        ("api650-2020", "ringwall moment"),
        (43_696.6, EXAMPLE),
        (1.2e-6, "kN m"),
        || line(&Api6502020, "M_rw", 1e-3),
    ),
    row(
        ("api650-2020", "hoop stress of the lowest course"),
        (141.10, EXAMPLE),
        (3.6e-5, "MPa"),
        || line(&Api6502020, "σ_T", 1e-6),
    ),
    row(
        ("en1992", "stress of the bars of a cracked section, 50 kNm/m on 25 cm"),
        (269.564_832, "M/(A (d − x/3)), x by the quadratic"),
        (1e-8, "MPa"),
        cracked_section,
    ),
    row(
        (
            "oscillator",
            "sudden load on an undamped oscillator, after half a period",
        ),
        (2.0, "u = p/ω² (1 − cos ωt)"),
        (1e-12, "1"),
        || Ok(Recurrence::new(1.0, 0.0, PI).step(0.0, 0.0, 1.0, 1.0).0),
    ),
    row(
        ("time-steps", "period error of the trapezoidal rule, Δt/T = 0.1"),
        (3.207_491_062_3e-2, "x/(2 arctan(x/2)) − 1 (Hughes 1987)"),
        (1e-9, "1"),
        || Ok(TimeScheme::Trapezoidal.with_step(1.0)?.spectral_properties(TAU * 0.1).1),
    ),
    row(
        ("spectrum", "correlation of modes, ξ = 5 %, r = 0.9"),
        (0.4730, "Wilson, Der Kiureghian & Bayo 1981"),
        (1.1e-4, "1"),
        || Ok(correlation((1.0, 0.05), (0.9, 0.05))),
    ),
    row(
        ("harmonic", "sloshing in a rigid cylinder, R = 1.83 m, H = 1.525 m"),
        (2.998_852_3, "ω² = g λ/R tanh(λ H/R), J₁'(λ) = 0 (Lamb 1932)"),
        (5e-4, "rad/s"),
        || {
            let mut rigid = broad(1000.0);
            rigid
                .tank
                .courses
                .iter_mut()
                .for_each(|course| course.material.youngs_modulus = 3e13);
            first(&rigid, "sloshing")
        },
    ),
    row(
        ("harmonic", "wall and liquid of a steel tank, R = H = 10 m, 10 mm"),
        (45.272_283, "C_i of Malhotra, Wenk & Wieland 2000"),
        (0.02, "rad/s"),
        || {
            let steel = material(210e9, 0.3, 7850.0);
            first(
                &case(
                    Shape::Cylinder { radius: 10.0 },
                    &[(10.0, 0.01)],
                    &steel,
                    (1000.0, 10.0),
                ),
                "structural",
            )
        },
    ),
    row(
        ("harmonic", "moment of a tank on a tilted base"),
        (14_457.883_732, STATICS),
        (1e-8, "N m"),
        || {
            let options = Options {
                tilt: Some(TILT),
                ..options()
            };
            let run = engines::simulate(&at_rest(broad(1000.0)), &options)?;
            Ok(run.result.tilt.ok_or("no tilt test")?.base_moment)
        },
    ),
    row(
        ("solid", "the same with 24 sectors, three-dimensional"),
        (14_457.883_732, STATICS),
        // A polygon in a circle: (π/24)²/6.
        (3e-3, "N m"),
        || {
            let mesh = Some(MeshSize {
                radial: 4,
                sectors: 24,
                vertical: 12,
            });
            let solid = SolidOptions {
                mesh,
                ..SolidOptions::default()
            };
            Ok(engines::solid::tilted(&broad(1000.0), TILT, &options(), &solid, &Silent)?.base_moment)
        },
    ),
    row(
        ("nonlinear strip", "moment at the base of a wall at rest"),
        (-28_291.876_7, "cantilever under hydrostatic pressure, γ H³/6"),
        (1e-6, "N m/m"),
        || {
            let shape = Shape::Rectangle {
                length: 5.0,
                breadth: 1.0,
                strip: true,
            };
            let tank = case(shape, &[(3.0, 0.3)], &material(34e9, 0.2, 2950.0), (1019.4, 2.57));
            nonlinear(tank, [20, 1], "wall_moment_base_theta_0")
        },
    ),
    row(
        (
            "nonlinear cylinder",
            "rise of the surface in a cylinder at rest, R = 1.83 m, 3 mm",
        ),
        (
            -1.803_749e-4,
            "long cylinder under hydrostatic pressure, clamped (Timoshenko & Woinowsky-Krieger 1959)",
        ),
        (0.01, "m"),
        || {
            let aluminium = material(69e9, 0.32, 2750.0);
            let tank = case(
                Shape::Cylinder { radius: 1.83 },
                &[(1.8, 3e-3)],
                &aluminium,
                (1000.0, 1.5),
            );
            nonlinear(tank, [24, 32], "wave_height_theta_0")
        },
    ),
    row(
        ("shell", "Cook's membrane, 16 × 16 elements"),
        (
            23.61,
            "independent prototype of the same formulation; fine meshes 23.96 (Cook 1974)",
        ),
        (0.02, "m"),
        cook,
    ),
    row(
        ("steel", "stress after strains of 0.5 % and −0.5 %, isotropic hardening"),
        (-516.39, "bilinear law by hand"),
        (5e-4, "MPa"),
        steel_cycle,
    ),
    row(
        ("concrete", "cracking moment of a wall of 30 cm under 22.5 kN/m"),
        (53.625, "(f_t + N/A) h²/6"),
        (1e-3, "kN m/m"),
        cracking_moment,
    ),
    row(
        ("base", "force that holds a bottom plate down, 70 cm of it lifted"),
        (44_800.0, "beam on rigid ground, p l/2"),
        (1e-3, "N/m"),
        lifted_plate,
    ),
    row(
        (
            "soil",
            "horizontal stiffness of a disc of 10 m, G = 118.75 MPa, ν = 0.25",
        ),
        (9.5e9 / 1.75, "8 G R/(2 − ν)"),
        (1e-12, "N/m"),
        || {
            let soil = Soil {
                density: 1900.0,
                shear_wave_velocity: 250.0,
                poisson_ratio: 0.25,
                damping: 0.0,
                depth: None,
            };
            Ok(Disc::new(10.0, soil)?.stiffness().horizontal)
        },
    ),
    row(
        ("isolators", "period on friction pendulums, D = 0.2 m"),
        (2.403, "independent program"),
        (5e-3, "s"),
        || {
            let pendulum = Isolator::FrictionPendulum {
                radius: 2.2365,
                friction: Friction::constant(0.05),
                slip: 1e-3,
            };
            let (mass, gravity) = (1e6, 9.81);
            Ok(TAU * (mass / pendulum.effective(0.2, mass * gravity, 0.0, 0.0).stiffness).sqrt())
        },
    ),
    row(
        ("fragility", "median of 40 runs at each of eight intensities"),
        (0.519_144, "two optimisers outside this program"),
        (2e-6, "1"),
        || {
            let counts = [
                (0.1, 0.0),
                (0.2, 1.0),
                (0.3, 5.0),
                (0.4, 11.0),
                (0.5, 18.0),
                (0.6, 24.0),
                (0.8, 33.0),
                (1.0, 38.0),
            ];
            let stripes = counts.map(|(im, exceed)| Stripe { im, n: 40.0, exceed });
            Ok(fit(&stripes).map_err(|e| e.reason)?.curve.median)
        },
    ),
];
