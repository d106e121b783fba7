//! Appendix D.1 to D.3: the procedures of `codes` on tank 8.1, whose liquid weighs 16.3 t as printed, with the printed spectral ordinates.
//!
//! Slips of the tables, which the references leave out:
//! * D.1 prints h_k = 1.47 m, which lies at the surface; its formula gives 0.884 m. Moments and stresses inherit it.
//! * D.2 reads W_1 = 0.50 W_T off a chart whose closed form is the impulsive mass of D.1, 0.466, and puts 0.3 t for a wall of 0.0955 t.
//! * D.3 rounds η = √(7/3) to 1.5.
//!
//! Tolerances: half of the last printed digit, one where digits are cut, and what the printed intermediate values were rounded by.

use codes::api650::edition1993::Api6501993;
use codes::ec8::Env1998;
use codes::housner::Housner;
use codes::procedure::Procedure;
use tank::assessment::{Assessment, Excitation};
use tank::case::{Combination, ConvectiveCoefficient, Ec8Site, GroundType, ZoneSite};
use tank::hazard::{SiteSpectrum, SpectrumForm, SpectrumTable};
use tank::quantity::Quantity;
use tank::reference::broad;
use tank::{Case, Shape};

use crate::tanks::G;
use crate::{Answer, Failure, Reference, Row};

/// Records of table 8.3: name and the printed S_v(ω₁, 1 %) [m/s].
const VELOCITIES: [(&str, f64); 3] = [("El Centro", 0.80), ("Parkfield", 0.09), ("Pacoima Dam", 0.22)];

/// W of the appendix [m³].
const SECTION_MODULUS: f64 = 0.0211;

/// Thickness of W, and of the lowest course [m].
const THICKNESS: [f64; 2] = [2.0e-3, 2.03e-3];

/// A case under a spectrum of the user, with the constants of 1957 and both parts added: ground acceleration and that of the sloshing mode
/// [m/s²] at 1 % damping.
pub(super) fn under(mut case: Case, ground: f64, sloshing: f64) -> Result<Case, Failure> {
    case.damping.sloshing = 0.01;
    let horizontal = SpectrumTable::new(vec![[0.0, ground], [0.1, sloshing], [20.0, sloshing]])?;
    let form = SpectrumForm::Table { damping: 0.01, horizontal, vertical: None };
    case.site.spectrum = Some(SiteSpectrum { form, vertical_ratio: 0.9 });
    case.procedures.housner_combination = Combination::Abs;
    case.procedures.housner_convective = ConvectiveCoefficient::Housner1957;
    Ok(case)
}

/// The value of a line of a calculation sheet; NaN where the sheet has no such line.
pub(super) fn line(sheet: &Assessment, symbol: &str) -> f64 {
    sheet.steps.iter().find(|step| step.symbol == symbol).map_or(f64::NAN, |step| step.value)
}

pub(super) fn value(sheet: &Assessment, quantity: Quantity) -> f64 {
    sheet.values.get(&quantity).copied().unwrap_or(f64::NAN)
}

/// Housner's sheet for a case with the pseudo-velocity of its sloshing mode [m/s].
pub(super) fn with_velocity(case: &Case, ground: f64, velocity: f64) -> Result<Assessment, Failure> {
    // The ordinate is an acceleration: ω does not depend on it.
    let omega = line(&Housner.assess(&under(case.clone(), ground, 1.0)?, Excitation::Site)?, "ω");
    Ok(Housner.assess(&under(case.clone(), ground, velocity * omega)?, Excitation::Site)?)
}

/// Tank 8.1 with 16.3 t of liquid.
fn tank_8_1() -> Case {
    let mut case = broad(1.0);
    let Shape::Cylinder { radius } = case.tank.shape else { return case };
    case.liquid.density = 16_300.0 / (std::f64::consts::PI * radius * radius * case.liquid.fill_height);
    case
}

/// Rows of one table.
struct Table {
    id: &'static str,
    source: &'static str,
}

impl Table {
    fn row(
        &self,
        what: impl Into<String>,
        reference: f64,
        computed: f64,
        (tolerance, unit): (f64, &'static str),
    ) -> Row {
        Row::new(self.id, what, (reference, self.source, Reference::Dissertation), computed, (tolerance, unit))
    }
}

/// Table D.1, and Housner's lines of tables 8.4 and 8.5.
///
/// Errors: a failure of the procedure.
pub(super) fn housner() -> Answer {
    let table = Table { id: "table-D.1", source: "dissertation, table D.1" };
    let case = tank_8_1();
    let unit = with_velocity(&case, 0.5 * G, 1.0)?;
    let h_k = table.row("lever h_k", 0.8835, line(&unit, "h_k"), (6e-5, "m"));
    let mut rows = vec![
        table.row("ω", 3.0, line(&unit, "ω"), (1.7e-2, "rad/s")),
        table.row("lever h_i", 0.57, line(&unit, "h_i"), (8.8e-3, "m")),
        table.row("impulsive force P_i", 37.2e3, line(&unit, "P_i"), (2.7e-3, "N")),
        table.row("θ_h over S_v", 0.254, line(&unit, "θ_h"), (4e-3, "s/m")),
        table.row("g/(ω² θ_h R) times S_v", 2.345, line(&unit, "κ"), (4e-3, "m/s")),
        Row {
            source: "H (1 − (cosh x − 1)/(x sinh x)), x = 1.84 H/R, by hand", kind: Reference::ClosedForm, ..h_k
        }
        .printed(1.47, "a slip: the formula beside it gives 0.884 m; all moments of the table inherit it"),
    ];
    let (lever, inherited) = (1.47 - 0.8835, "with the lever of its formula, 0.884 m, in place of 1.47 m");
    let printed = [(13.55, 42.4, 41.1, 1.9), (1.52, 3.3, 23.4, 1.1), (3.72, 8.5, 26.6, 1.2)];
    for ((record, velocity), (force, wave, moment, stress)) in VELOCITIES.into_iter().zip(printed) {
        let found = with_velocity(&case, 0.5 * G, velocity)?;
        let what = |quantity: &str| format!("{record}: {quantity}");
        // θ_h has three digits, cut: 0.4 %.
        rows.push(table.row(
            what("convective force P_k"),
            1e3 * force,
            line(&found, "P_k"),
            (4e-3 + 0.01 / force, "N"),
        ));
        // 0.82 has two digits, 0.6 %, besides.
        let height = value(&found, Quantity::SloshingHeight);
        rows.push(table.row(what("wave"), 1e-2 * wave, height, (1e-2 + 0.05 / wave, "m")));
        let corrected = moment - force * lever;
        let row = table.row(
            what("moment above the base"),
            1e3 * corrected,
            value(&found, Quantity::BaseMoment),
            (1e-2, "N m"),
        );
        rows.push(row.printed(1e3 * moment, inherited));
        let corrected = 1e3 * corrected / SECTION_MODULUS * THICKNESS[0] / THICKNESS[1];
        // W has three digits, 0.3 % off.
        let found = value(&found, Quantity::AxialMembraneStress);
        let row = table.row(what("axial membrane stress"), corrected, found, (1.5e-2, "Pa"));
        rows.push(row.printed(
            1e6 * stress,
            "its moment corrected, and the lowest course of 2.03 mm in place of 2.0 mm; printed cut to a tenth",
        ));
    }
    Ok(rows)
}

/// Table D.2, and the lines of API 650 in tables 8.4 and 8.5.
///
/// The zone method gives the moments of both parts; they are linear in the coefficients, in whose place the table has 0.5 g and S_a.
///
/// Errors: a failure of the procedure.
pub(super) fn api650() -> Answer {
    let table = Table { id: "table-D.2", source: "dissertation, table D.2" };
    let mut case = tank_8_1();
    case.site.zone = Some(ZoneSite { zone_factor: 0.4, soil_factor: 1.0, importance: 1.0 });
    let sheet = Api6501993.assess(&case, Excitation::Site)?;
    let [m_1, m_2] = ["M_1", "M_2"].map(|symbol| line(&sheet, symbol));
    let (a_1, a_2) = (0.4 * 0.6, 0.4 * line(&sheet, "C_2"));
    let of_d1 = Table { id: "table-D.2", source: "dissertation, table D.1: P_i over 0.5 g, h_i" };
    // The wall by hand: 2750 kg/m³ 2π 1.83 m (0.915 m of 2.03 and of 1.27 mm).
    let wall = table.row("mass of the wall W_S", 95.48, value(&sheet, Quantity::WallMass), (1e-3, "kg"));
    let chart = "read off a chart to two digits; the closed form of the same curve is D.1's";
    let mut rows = vec![
        // k is read as 0.6, to 0.01.
        table.row("ω", 3.02, std::f64::consts::TAU / value(&sheet, Quantity::SloshingPeriod), (1.7e-2, "rad/s")),
        Row { source: "ρ 2π R Σ h t, by hand", kind: Reference::ClosedForm, ..wall }
            .printed(300.0, "three times the wall of figure 8.1: open"),
        of_d1
            .row("impulsive mass W_1", 37.2e3 / (0.5 * G), value(&sheet, Quantity::ImpulsiveMass), (2.7e-3, "kg"))
            .printed(8150.0, chart),
        of_d1.row("its height X_1", 0.57, line(&sheet, "X_1"), (8.8e-3, "m")).printed(0.59, chart),
        // Readings of 0.50 and 0.59 to 0.01.
        table.row("convective mass W_2", 8150.0, value(&sheet, Quantity::ConvectiveMass), (2e-2, "kg")),
        table.row("its height X_2", 0.90, line(&sheet, "X_2"), (2.3e-2, "m")),
    ];
    let impulsive = 95.48 * line(&sheet, "X_s") + 37.2e3 / (0.5 * G) * 0.57;
    let printed = [(2.40, 42.0, 2.0), (0.27, 26.5, 1.3), (0.66, 29.3, 1.4)];
    for ((record, _), (acceleration, moment, stress)) in VELOCITIES.into_iter().zip(printed) {
        let found = 0.5 / a_1 * m_1 + acceleration / G / a_2 * m_2;
        let corrected = 0.5 * G * impulsive + acceleration * 8150.0 * 0.90;
        let reason = "W_S, W_1 and X_1 as above";
        // P_i and h_i: 1.1 %; W_2 X_2: 2.5 % of less than half.
        let row = table.row(format!("{record}: moment"), corrected, found, (2.4e-2, "N m"));
        rows.push(row.printed(1e3 * moment, reason));
        let ratio = value(&sheet, Quantity::AxialMembraneStress) / value(&sheet, Quantity::BaseMoment);
        let corrected = corrected / SECTION_MODULUS * THICKNESS[0] / THICKNESS[1];
        let row = table.row(format!("{record}: axial membrane stress"), corrected, found * ratio, (2.9e-2, "Pa"));
        rows.push(
            row.printed(1e6 * stress, "the moment corrected, and the lowest course of 2.03 mm in place of 2.0 mm"),
        );
    }
    Ok(rows)
}

/// Table D.3, and the line of Eurocode 8 in table 8.4.
///
/// Errors: a failure of the procedure.
pub(super) fn env1998() -> Answer {
    let table = Table { id: "table-D.3", source: "dissertation, table D.3" };
    let mut case = tank_8_1();
    case.damping.sloshing = 0.01;
    case.site.ec8 = Some(Ec8Site {
        ground: GroundType::A,
        spectrum: 1,
        ag: 0.5 * G,
        importance: 1.0,
        behaviour_factor: 1.0,
        construction_quality: 1.0,
        vertical: false,
        components: Default::default(),
        friction: None,
        reduction_factor: None,
        bearing_capacity: None,
    });
    let sheet = Env1998.assess(&case, Excitation::Site)?;
    let mut rows: Vec<Row> = [("T_B", 0.1), ("T_C", 0.4), ("T_D", 3.0)]
        .into_iter()
        .map(|(symbol, printed)| table.row(symbol, printed, line(&sheet, symbol), (1e-9, "s")))
        .collect();
    let rounded = (7.0_f64 / 3.0).sqrt() / 1.5;
    rows.extend([
        // Cut to two decimals.
        table.row("sloshing period", 2.09, value(&sheet, Quantity::SloshingPeriod), (5e-3, "s")),
        // Half a digit of S_e, and η.
        table.row("S_e over g", 0.36, line(&sheet, "S_e(T_c1)") / G, (1.4e-2 + rounded - 1.0, "")),
        // Half of 1 % by the period, and cut: 0.84 R S_e is 55.2 cm with the table's own values.
        table
            .row("wave", 0.55 * rounded, value(&sheet, Quantity::SloshingHeight), (6e-3, "m"))
            .printed(0.55, "η = √(7/3) in place of 1.5"),
    ]);
    Ok(rows)
}
