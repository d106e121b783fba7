//! Compression of the courses above the bottom course.
//!
//! The annex gives the moment above the bottom only, and one thickness. Derived here, course by course at its lower edge z:
//!
//! ```text
//! M(z) = √([A_i (W_i X_i χ_i + W_a X_a)]² + [A_c W_c X_c χ_c]²)      M(0) = M_rw
//! σ(z) = (W_a/(π D) (1 + 0.4 A_v) + 1.273 M(z)/D²)/t
//! ```
//!
//! W_a is the weight of shell and roof above z, X_a the height of its centre above z. χ is the moment about z of the wall pressure
//! above z over that about the bottom, of the rigid tank in potential flow ([`crate::mechanical`]): the annex's forces keep their size
//! and arm, and the field gives the distribution. The allowable stress is that of E.6.2.2.3 with the thickness, yield strength and depth
//! of liquid at z; a design pressure would raise it and relieve the shell, and is left out. The whole ring bears; the concentration
//! above the bearing arc of a lifted shell is left out.

use tank::Course;
use tank::units::Dimension::{Dimensionless, Force, Length, LineForce, Moment, Stress};

use super::super::basis::softer;
use super::super::hold_down as hd;
use super::accelerations::Accelerations;
use super::forces::Forces;
use super::{Run, limit_states};
use crate::mechanical::{ConvectiveField, ImpulsiveField, Plan};
use crate::sheet::{Sheet, with_unit};

const E6_2_2: &str = "API 650:2020 E.6.2.2, derived";
const E6_2_2_3: &str = "API 650:2020 E.6.2.2.3, local thickness and depth";

/// The moments of the wall pressure above a height, each over that above the bottom.
struct Shares {
    impulsive: ImpulsiveField,
    convective: ConvectiveField,
}

impl Shares {
    fn at(&self, zeta: f64) -> (f64, f64) {
        if zeta >= 1.0 {
            return (0.0, 0.0);
        }
        (
            self.impulsive.moment_above(zeta) / self.impulsive.moment_above(0.0),
            self.convective.moment_above(zeta) / self.convective.moment_above(0.0),
        )
    }
}

/// The lower edge of a course.
struct Edge<'a> {
    course: &'a Course,
    /// From 1 at the bottom.
    number: usize,
    z: f64,
}

impl Run<'_> {
    /// Compression at the lower edge of each course above the bottom course; the lines and the check of the governing one.
    pub(super) fn upper_courses(&mut self, a: &Accelerations, forces: &Forces) {
        let b = self.basis;
        let shares = Shares {
            impulsive: ImpulsiveField::new(Plan::Circle, 2.0 * b.h / b.d),
            convective: ConvectiveField::new(Plan::Circle, 2.0 * b.h / b.d, 1),
        };
        let mut z = 0.0;
        let mut edges = Vec::new();
        for (index, course) in b.case.tank.courses.iter().enumerate() {
            if index > 0 {
                let number = index + 1;
                edges.push(Edge { course, number, z });
            }
            z += course.height;
        }
        let mut governing: Option<(f64, &Edge)> = None;
        for edge in &edges {
            // The lines of one edge on a sheet of their own, for the comparison.
            let mut scratch = Sheet::new();
            let sigma = self.compression_at(&mut scratch, edge, &shares, a, forces);
            let Some(allowed) = self.allowable_at(&mut scratch, edge) else {
                let input = format!("materials.{}.yield_strength", edge.course.material.name);
                return self.missing(limit_states::UPPER_COMPRESSION.id, &input);
            };
            let utilisation = sigma / allowed;
            if governing.is_none_or(|(largest, _)| utilisation > largest) {
                governing = Some((utilisation, edge));
            }
        }
        let Some((_, edge)) = governing else { return };
        let mut sheet = std::mem::take(&mut self.sheet);
        let place = format!("course {} at z = {}", edge.number, with_unit(edge.z, Length));
        sheet.section(&format!("Compression of the courses above: {place} governs"));
        let sigma = self.compression_at(&mut sheet, edge, &shares, a, forces);
        let allowed = self.allowable_at(&mut sheet, edge);
        self.sheet = sheet;
        if let Some(allowed) = allowed {
            let name = "Compression of the courses above";
            let note = format!("{place}; moment above it derived from potential flow");
            let id = limit_states::UPPER_COMPRESSION.id;
            self.check(id, name, sigma, allowed, Stress, E6_2_2, &note);
        }
    }

    /// Lines of the compression [Pa] at the lower edge of a course.
    fn compression_at(
        &self,
        sheet: &mut Sheet,
        edge: &Edge,
        shares: &Shares,
        a: &Accelerations,
        forces: &Forces,
    ) -> f64 {
        let b = self.basis;
        let (chi_i, chi_c) = shares.at(edge.z / b.h);
        let (mass, moment) = b.case.tank.mass_above(edge.z);
        let source = "potential flow of the rigid tank, moment above z over moment above the bottom";
        for (symbol, name, value) in [
            ("χ_i", "share of the impulsive moment above z", chi_i),
            ("χ_c", "share of the convective moment above z", chi_c),
        ] {
            sheet.look_up(symbol, name, source, value, Dimensionless, E6_2_2);
        }
        let weight = mass * b.case.gravity;
        sheet.input("W_a", "weight of shell and roof above z", weight, Force, "tank");
        let arm = if mass > 0.0 { moment / mass } else { 0.0 };
        sheet.input("X_a", "height of its centre above z", arm, Length, "tank");
        sheet.given(&[
            ("A_i", a.a_i, Dimensionless),
            ("A_c", a.a_c, Dimensionless),
            ("A_v", a.a_v, Dimensionless),
            ("W_i", forces.w_i, Force),
            ("X_i", forces.x_i, Length),
            ("W_c", forces.w_c, Force),
            ("X_c", forces.x_c, Length),
            ("D", b.d, Length),
            ("t", edge.course.net_thickness(), Length),
        ]);
        let carried = match b.case.tank.roof.on_columns > 0.0 {
            true => {
                let weight = b.case.gravity * b.case.tank.weight_above(edge.z);
                sheet.input("W_as", "the same on the shell, without what columns carry", weight, Force, "tank");
                "W_as/(π·D)"
            }
            false => "W_a/(π·D)",
        };
        let mut line = |symbol: &'static str, name: &str, formula: &str, dimension| {
            sheet.calc(symbol, name, formula, dimension, E6_2_2)
        };
        let formula = "A_i·(W_i·X_i·χ_i + W_a·X_a)";
        line("M_zi", "impulsive moment at z", formula, Moment);
        line("M_zc", "convective moment at z", "A_c·W_c·X_c·χ_c", Moment);
        line("M_z", "moment at z", "√(M_zi² + M_zc²)", Moment);
        line("w_z", "weight above z per length of shell", carried, LineForce);
        let name = "compression at the lower edge of the course";
        line("σ_cz", name, "(w_z·(1 + 0.4·A_v) + 1.273·M_z/D²)/t", Stress)
    }

    /// Lines of the allowable compression [Pa] at the lower edge of a course; none if it needs a yield strength that is not given.
    fn allowable_at(&self, sheet: &mut Sheet, edge: &Edge) -> Option<f64> {
        let b = self.basis;
        let f_ty = edge.course.material.yield_strength;
        let depth = (b.h - edge.z).max(0.0);
        sheet.given(&[
            ("t", edge.course.net_thickness(), Length),
            ("D", b.d, Length),
            ("G", b.g, Dimensionless),
            ("H_z", depth, Length),
            ("F_ty", f_ty.unwrap_or(0.0), Stress),
            ("E", edge.course.material.youngs_modulus, Stress),
        ]);
        let local = |formula: &str| formula.replace("t_s", "t").replace('H', "H_z");
        let name = "pressure parameter with the depth H_z above z, D and H_z in m, t in mm";
        let slenderness = local(hd::SLENDERNESS);
        let ratio = sheet.calc("G·H_z·D²/t²", name, &slenderness, Dimensionless, E6_2_2_3);
        let formula = local(hd::allowable(ratio, f_ty.is_some(), softer(&edge.course.material))?);
        let name = "allowable compression of the course";
        Some(sheet.calc("F_Cz", name, &formula, Stress, E6_2_2_3))
    }
}
