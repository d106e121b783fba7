//! The procedures, the measurement and their comparison in the sample.

use std::collections::BTreeMap;

use codes::sheet::Sheet;
use results::compare::{Attribution, Difference, FactorStep, MEASURED, Ratio, Reason};
use results::*;
use tank::Quantity;
use tank::assessment::{Check, Excitation, Profile};
use tank::case::Reported;
use tank::factor::Factor;
use tank::units::Dimension;
use tank::{Liquid, Tank};

use super::{G, Kind};

pub(super) fn methods(
    kind: Kind,
    tank: &Tank,
    liquid: &Liquid,
    values: &[(Quantity, f64)],
    with_fe: bool,
) -> Vec<Method> {
    let procedures = [
        ("housner", "Housner 1957/1963", 0.97),
        ("ec8-env", "ENV 1998-4:1998, annex B", 1.04),
        ("ec8-2006", "EN 1998-4:2006, annex A", 1.08),
        ("api650-1993", "API 650 9th edition, appendix E", 0.88),
        ("api650-2020", "API 650 13th edition, annex E", 0.93),
    ];
    let mut methods = Vec::new();
    for excitation in [Excitation::Record, Excitation::Site] {
        if excitation == Excitation::Record && !with_fe {
            continue;
        }
        for (i, (id, title, factor)) in procedures.into_iter().enumerate() {
            if kind == Kind::Rectangle && id.starts_with("api") {
                methods.push(Method {
                    status: Status::NotApplicable {
                        clause: "API 650 1.1".into(),
                        reason: "the tank is rectangular; the standard covers vertical cylinders".into(),
                    },
                    ..column(id, title, excitation)
                });
                continue;
            }
            let factor = factor * if excitation == Excitation::Site { 0.62 } else { 1.0 };
            methods.push(procedure(id, title, excitation, factor, i, tank, liquid, values));
        }
    }
    if with_fe {
        methods.push(Method {
            label: EngineId::Harmonic.label(0).into(),
            figure_key: EngineId::Harmonic.figure_key(0).into(),
            quantities: values.iter().map(|(q, v)| (q.id().to_owned(), value(*q, *v))).collect(),
            assumptions: vec![
                "Small displacements and small waves; the liquid is inviscid and incompressible.".into(),
                "The wall is clamped at its base.".into(),
            ],
            ..Method::new(FE, "Finite elements, linear, harmonic", Excitation::Record)
        });
        methods.push(Method {
            figure_key: "k-measured".into(),
            quantities: BTreeMap::from([(
                Quantity::SloshingHeight.id().to_owned(),
                value(Quantity::SloshingHeight, 0.134),
            )]),
            notes: vec!["Sloshing height: Manos and Clough 1982, shaking table test.".into()],
            ..Method::new(MEASURED, "Measured", Excitation::Record)
        });
    }
    methods
}

/// An empty column of a procedure, named and drawn as the procedure of this id.
fn column(id: &str, title: &str, excitation: Excitation) -> Method {
    let found = codes::ALL.iter().find(|p| p.id() == id);
    let label = found.expect("a procedure").label();
    Method { label: label.short.into(), figure_key: label.figure_key.into(), ..Method::new(id, title, excitation) }
}

fn value(quantity: Quantity, value: f64) -> Value {
    Value { value, dimension: quantity.dimension() }
}

#[allow(clippy::too_many_arguments)]
fn procedure(
    id: &str,
    title: &str,
    excitation: Excitation,
    factor: f64,
    index: usize,
    tank: &Tank,
    liquid: &Liquid,
    values: &[(Quantity, f64)],
) -> Method {
    let (r, h) = (tank.shape.half_length(), liquid.fill_height);
    let clause = ["Housner 1957", "ENV 1998-4 B.2", "EN 1998-4:2006 A.2.1.3", "API 650 E.3", "API 650 E.6.1"][index];
    use Dimension::*;
    let mut s = Sheet::new();
    s.section("Geometry and mass");
    s.input("R", "inner radius", r, Length, "input");
    s.input("H", "depth of the liquid", h, Length, "input");
    s.input("ρ", "density of the liquid", liquid.density, Density, "input");
    let mass = s.calc("m", "mass of the liquid", "π·R²·H·ρ", Mass, clause);
    s.section("Convective part");
    s.given(&[("g", G, Acceleration), ("λ_1", 1.8412, Dimensionless)]);
    s.calc("ω_c1", "first sloshing circular frequency", "√(g·λ_1/R·tanh(λ_1·H/R))", AngularFrequency, clause);
    s.calc("T_c1", "first sloshing period", "2·π/ω_c1", Time, clause);
    s.calc("m_c1", "mass of the first sloshing mode", "m·(2·R·tanh(λ_1·H/R))/(H·λ_1·(λ_1^2 − 1))", Mass, clause);
    let s_c = s.look_up(
        "S_a(T_c1)",
        "spectral acceleration at the sloshing period",
        "spectrum of the record at T_c1",
        1.83,
        Acceleration,
        "record spectrum at 0.5 %",
    );
    s.section("Impulsive part");
    s.calc("m_i", "mass that moves with the wall", "m·tanh(√3·R/H)/(√3·R/H)", Mass, clause);
    s.look_up(
        "C_i",
        "coefficient of the impulsive period",
        "table A.2 at H/R = 0.83",
        6.52,
        Dimensionless,
        "EN 1998-4:2006 table A.2",
    );
    s.given(&[("ρ", 1000.0, Density), ("s", 0.002_03, Length), ("E", 69e9, Stress)]);
    s.calc("T_imp", "impulsive period", "C_i·√ρ·H/(√(s/R)·√E)", Time, clause);
    s.section("Base shear and moment");
    s.given(&[
        ("h_i", 0.41 * h, Length),
        ("m_w", tank.wall_mass(), Mass),
        ("h_w", 0.9, Length),
        ("m_r", 35.0, Mass),
        ("h_r", 1.83, Length),
        ("h_c1", 0.6 * h, Length),
        ("S_i", 4.9 * factor, Acceleration),
        ("S_c", s_c, Acceleration),
    ]);
    let formula = "(m_i + m_w + m_r)·S_i + m_c1·S_c";
    s.calc("Q", "base shear", formula, Force, clause);
    let formula = "(m_i·h_i + m_w·h_w + m_r·h_r)·S_i + m_c1·h_c1·S_c";
    s.calc("M", "moment just above the base", formula, Moment, clause);
    let name = "axial membrane stress at the base";
    s.calc("σ_x", name, "M/(π·R²·s)", Stress, clause);
    let z: Vec<f64> = (0..=30).map(|i| h * f64::from(i) / 30.0).collect();
    let profile = |id: &str, title: &str, scale: f64, shape: &dyn Fn(f64) -> f64| Profile {
        id: id.into(),
        title: title.into(),
        dimension: Stress,
        values: z.iter().map(|z| scale * shape(z / h)).collect(),
        z: z.clone(),
    };
    let quantities = values
        .iter()
        .filter(|(q, _)| match q {
            Quantity::BendingStress => !id.starts_with("api"),
            Quantity::HoopStress => id != "housner",
            _ => true,
        })
        .enumerate()
        .map(|(i, (q, v))| (q.id().to_owned(), value(*q, v * if i == 0 { 1.0 } else { factor + 0.01 * i as f64 })))
        .collect();
    Method {
        quantities,
        steps: s.into_steps().expect("the formulas of the sample have all their terms"),
        checks: vec![
            Check::new(
                "freeboard",
                "freeboard against the sloshing wave",
                factor * values[1].1,
                0.305,
                Length,
                clause,
                "",
            ),
            Check::new(
                "buckling_elastic",
                "elastic buckling of the lowest course",
                factor * values[9].1,
                if index == 3 { 1.2e6 } else { 14e6 },
                Stress,
                clause,
                "internal pressure at the base is credited; without it the capacity falls to 9.8 MPa",
            ),
            Check::new(
                "sliding",
                "sliding on the ground",
                factor * values[5].1,
                0.7 * mass * G * 0.4,
                Force,
                clause,
                "",
            ),
        ],
        profiles: vec![
            profile("pressure_impulsive", "Impulsive pressure", factor * 5.9e3, &|x| 1.0 - x * x),
            profile("pressure_convective", "Convective pressure", factor * 1.2e3, &|x| {
                (1.4 * x).cosh() / 1.4f64.cosh()
            }),
            profile("pressure_dynamic", "Dynamic pressure", factor * 6.6e3, &|x| 1.0 - 0.8 * x * x),
            profile("hoop_stress", "Hoop stress", factor * 5.9e6, &|x| {
                if x < 0.6 { 1.0 - 0.8 * x * x } else { 1.6 * (1.0 - 0.8 * x * x) }
            }),
            profile("axial_membrane_stress", "Axial membrane stress", factor * 1.6e6, &|x| (1.0 - x).powi(2)),
        ],
        assumptions: vec![
            "The impulsive and convective maxima are added by absolute values.".into(),
            "The ground is rigid.".into(),
        ],
        notes: if index == 0 {
            vec!["The 1957 coefficient 0.318 would give 4 % less convective mass.".into()]
        } else {
            Vec::new()
        },
        ..column(id, title, excitation)
    }
}

/// Where the sample's methods differ.
fn differences() -> Vec<Difference> {
    let ratio = |quantity, ratio| Ratio { quantity, ratio };
    vec![
        Difference {
            method: "api650-1993".into(),
            ratios: vec![ratio(Quantity::AxialMembraneStress, 0.88)],
            reasons: Vec::new(),
        },
        Difference {
            method: "ec8-2006".into(),
            ratios: vec![ratio(Quantity::SloshingHeight, 1.08)],
            reasons: vec![Reason::Factors { steps: steps(1.0) }],
        },
    ]
}

/// Two factors, 0.9 and 1.2, of a value.
fn steps(start: f64) -> Vec<FactorStep> {
    [(Factor::SloshingPeriod, 0.9, 0.9 * start), (Factor::WaveFormula, 1.2, 1.08 * start)]
        .map(|(factor_id, factor, value)| FactorStep { factor_id, factor, value })
        .to_vec()
}

/// Factors of the sample's wave by one procedure.
fn attribution(engine: f64) -> Attribution {
    Attribution {
        quantity: Quantity::SloshingHeight,
        method: "ec8-2006".into(),
        excitation: Excitation::Record,
        engine,
        steps: steps(engine),
        ratio: 1.08,
    }
}

pub(super) fn comparison(methods: &[Method], with_fe: bool) -> Comparison {
    let fe = methods.iter().find(|m| m.id == "fe");
    let rows = Quantity::ALL
        .iter()
        .map(|q| ComparisonRow {
            quantity: q.id().into(),
            title: q.title().into(),
            dimension: q.dimension(),
            cells: methods
                .iter()
                .map(|m| {
                    m.quantities.get(q.id()).map(|v| Cell {
                        value: v.value,
                        ratio: fe.and_then(|f| f.quantities.get(q.id())).map(|f| v.value / f.value),
                        unusable: false,
                        outside: false,
                    })
                })
                .collect(),
        })
        .collect();
    Comparison {
        rows,
        differences: if with_fe { differences() } else { Vec::new() },
        attribution: fe
            .and_then(|fe| fe.quantities.get(Quantity::SloshingHeight.id()))
            .map(|height| attribution(height.value))
            .into_iter()
            .collect(),
        published: vec![Reported {
            quantity: Quantity::SloshingHeight,
            value: 0.386,
            source: "dissertation, table 8.3".into(),
            note: Some("belongs to the record as recorded, not to the stated scaling".into()),
            motion: None,
        }],
        ..Comparison::default()
    }
}
