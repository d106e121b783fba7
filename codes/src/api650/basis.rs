//! The tank in the terms of API 650, and the lines that both editions share.

use super::edition2020::limit_states::ANCHORS;
use crate::sheet::{Sheet, with_unit};
use tank::assessment::{Assessment, Check, CheckStatus, NotApplicable};
use tank::case::Case;
use tank::units::Dimension::{Dimensionless, Force, Length, LineForce};
use tank::{Family, Material, Shape, Support};

use super::hold_down;
use super::masses::SQUAT;
use crate::corrosion;
use crate::roof::{self, LiveLoad};

/// Elastic modulus of steel [Pa] that the constants 83 MPa and 7.5 MPa of the allowable compression stand for.
const STEEL: f64 = 206e9;

/// Modulus [Pa] by which the allowable compression of softer metals, and of steel that is hot, is scaled: 29 000 ksi.
pub const REFERENCE_MODULUS: f64 = 200e9;

/// Modulus [Pa] of steel at room temperature, just below 29 000 ksi = 199.95 GPa.
const AT_ROOM_TEMPERATURE: f64 = 199.9e9;

/// Whether the allowable compression of a metal is scaled with its modulus: it is softer than steel at room temperature.
pub fn softer(material: &Material) -> bool {
    material.is_metal() && material.youngs_modulus < AT_ROOM_TEMPERATURE
}

/// Tank and product as the standard sees them; weights in N.
#[derive(Clone, Copy, Debug)]
pub struct Basis<'a> {
    /// The case.
    pub case: &'a Case,
    /// Nominal diameter D [m].
    pub d: f64,
    /// Design liquid level H [m].
    pub h: f64,
    /// Specific gravity G.
    pub g: f64,
    /// Weight of the shell W_s.
    pub w_s: f64,
    /// Height of its centre X_s [m].
    pub x_s: f64,
    /// Weight of the roof W_r.
    pub w_r: f64,
    /// Weight of the floor W_f, all of it as thick as the bottom plate under the shell; 0 if that is not given.
    pub w_f: f64,
    /// Weight of the product W_p.
    pub w_p: f64,
    /// Thickness of the bottom course less corrosion t_s [m].
    pub t_s: f64,
}

impl<'a> Basis<'a> {
    /// The basis of a case.
    ///
    /// Errors: not applicable to rectangles, the standard covers upright cylinders (1.1).
    pub fn new(case: &'a Case, edition: &str) -> Result<Basis<'a>, NotApplicable> {
        let Shape::Cylinder { radius } = case.tank.shape else {
            return Err(NotApplicable {
                clause: format!("{edition} 1.1"),
                reason: "the standard covers upright cylindrical tanks; this tank is rectangular".into(),
            });
        };
        let (tank, h) = (&case.tank, case.liquid.fill_height);
        let d = 2.0 * radius;
        let (w_s, w_r) = (case.gravity * tank.wall_mass(), case.gravity * tank.roof.mass);
        Ok(Basis {
            case,
            d,
            h,
            g: case.liquid.density / 1000.0,
            w_s,
            x_s: tank.wall_centroid(),
            w_r,
            w_f: case
                .tank
                .bottom
                .as_ref()
                .map_or(0.0, |plate| case.gravity * plate.material.density * plate.thickness * tank.shape.plan_area()),
            w_p: case.gravity * case.liquid_mass(),
            t_s: tank.courses[0].net_thickness(),
        })
    }

    /// Whether the tank is mechanically anchored.
    pub fn anchored(&self) -> bool {
        self.case.tank.support == Support::Anchored
    }

    /// Whether the squat branches of the charts hold.
    pub fn squat(&self) -> bool {
        self.d / self.h >= SQUAT
    }

    /// Yield strength of the bottom course [Pa].
    pub fn shell_yield(&self) -> Option<f64> {
        self.case.tank.courses[0].material.yield_strength
    }

    /// Bottom plate under the shell (thickness less corrosion [m], yield strength [Pa]), or the missing data in words.
    pub fn bottom(&self) -> Result<(f64, f64), String> {
        let Some(bottom) = &self.case.tank.bottom else { return Err("tank.bottom".into()) };
        match bottom.material.yield_strength {
            Some(f_y) => Ok((bottom.net_thickness(), f_y)),
            None => Err(format!("materials.{}.yield_strength", bottom.material.name)),
        }
    }

    /// Inputs of the sheet; `roof` is the height of the roof's weight that the edition uses.
    pub fn inputs(&self, sheet: &mut Sheet, roof: (&str, f64)) {
        corrosion::lines(sheet, &self.case.tank, "t", "nomenclature: less corrosion allowance");
        sheet.section("Tank and product");
        for (symbol, name, value, dimension, source) in [
            ("D", "nominal diameter (twice the inner radius)", self.d, Length, "tank.radius"),
            ("H", "design liquid level", self.h, Length, "liquid.fill_height"),
            ("G", "specific gravity of the product, ρ/1000 kg/m³", self.g, Dimensionless, "liquid.density"),
            ("t_s", "thickness of the bottom course", self.t_s, Length, "tank.courses"),
            ("W_s", "weight of the shell", self.w_s, Force, "tank.courses"),
            ("X_s", "height of its centre of mass", self.x_s, Length, "tank.courses"),
        ] {
            sheet.input(symbol, name, value, dimension, source);
        }
        roof::weight_lines(sheet, self.case);
        sheet.input(roof.0, "height of the roof's weight", roof.1, Length, "tank.roof");
        sheet.input("W_p", "weight of the product", self.w_p, Force, "liquid");
        roof::line(sheet, &self.case.tank);
    }

    /// Line for the weight of shell and roof per length of shell; returns it [N/m].
    pub fn weight_line(&self, sheet: &mut Sheet, clause: &str) -> f64 {
        let formula = match self.case.tank.roof.on_columns > 0.0 {
            true => "(W_s + W_rs)/(π·D)",
            false => "(W_s + W_r)/(π·D)",
        };
        sheet.calc("w_t", "weight of shell and roof per length of shell", formula, LineForce, clause)
    }

    /// Assumptions common to both editions.
    ///
    /// * `scales`: whether the edition scales the allowable compression of softer metals
    pub fn assumptions(&self, out: &mut Assessment, scales: bool) {
        out.assumptions.extend([
            "Rigid wall and ground for the masses; the effective masses are those of the standard's charts in closed form."
                .to_string(),
            match self.case.tank.corrodes() {
                true => format!("The nominal diameter is twice the inner radius. {}", corrosion::ASSUMPTION),
                false => {
                    "The nominal diameter is twice the inner radius; thicknesses as given, without corrosion allowance.".into()
                }
            },
            "The constants of the standard contain g = 9.81 m/s² and water of 1000 kg/m³.".into(),
        ]);
        if self.case.tank.roof.mass > 0.0 && self.case.tank.roof.on_columns == 0.0 {
            out.assumptions.push("The shell carries the whole roof.".into());
        }
        out.assumptions.extend(roof::assumptions(&self.case.tank, &LiveLoad::Api));
        if !self.case.tank.is_metal() {
            let reason = "API 650 is for welded tanks of metal: its values of this wall stand in the tables alone";
            out.beyond_scope = Some(reason.into());
            out.notes.push(format!("{reason}."));
        }
        let material = &self.case.tank.courses[0].material;
        let modulus = material.youngs_modulus;
        if scales && softer(material) {
            out.assumptions.push(format!(
                "The bottom course is {}: the allowable compression of steel is scaled by E/{}, which is on the safe side of similarity. \
                 Yield strength and allowable stress must be those of annex {} at the design temperature, with the loss by welding.",
                material.family.map_or("a softer metal", Family::name),
                with_unit(REFERENCE_MODULUS, tank::units::Dimension::Stress),
                if material.is(Family::CarbonSteel) { "M" } else { "S or AL" }
            ));
        } else if (modulus / STEEL - 1.0).abs() > 0.1 {
            out.notes.push(format!(
                "The allowable shell compression stands for steel; the bottom course has E = {}, {:.2} times that of \
                 steel, and buckling stresses are proportional to E.",
                with_unit(modulus, tank::units::Dimension::Stress),
                modulus / STEEL
            ));
        }
    }

    /// Allowable compression of the bottom course with its lines, or the path of the missing input.
    ///
    /// * `scales`: whether that of softer metals is scaled with its modulus
    pub fn allowable_compression(
        &self,
        sheet: &mut Sheet,
        symbol: &str,
        clause: &str,
        scales: bool,
    ) -> Result<f64, String> {
        use tank::units::Dimension::Stress;
        let f_ty = self.shell_yield();
        let material = &self.case.tank.courses[0].material;
        sheet.given(&[("F_ty", f_ty.unwrap_or(0.0), Stress), ("E", material.youngs_modulus, Stress)]);
        let (ratio, name) = ("G·H·D²/t_s²", "pressure parameter of the shell, D and H in m, t_s in mm");
        let ratio = sheet.calc(ratio, name, hold_down::SLENDERNESS, Dimensionless, clause);
        let scaled = scales && softer(material);
        let Some(formula) = hold_down::allowable(ratio, f_ty.is_some(), scaled) else {
            return Err(format!("materials.{}.yield_strength", material.name));
        };
        let name = "allowable shell compression";
        Ok(sheet.calc(symbol, name, formula, Stress, clause))
    }

    /// Anchor tension from the uplift `w_ab` per length [N/m] with its lines, and how the limit state ends: a check, or the reason
    /// and the path of the missing input.
    pub fn anchors(
        &self,
        sheet: &mut Sheet,
        w_ab: f64,
        symbol: &str,
        clause: &str,
        note: &str,
    ) -> Result<Check, (CheckStatus, String)> {
        if w_ab <= 0.0 {
            let reason = "the weight outweighs the uplift; the anchors carry no tension";
            return Err((CheckStatus::NotApplicable, reason.into()));
        }
        let Some(anchors) = self.case.tank.anchors.filter(|a| a.count > 0) else {
            return Err((CheckStatus::NotChecked, "tank.anchors".into()));
        };
        let n = f64::from(anchors.count);
        sheet.given(&[("n_A", n, Dimensionless)]);
        let tension = sheet.calc("P_AB", "tension of an anchor", &format!("{symbol}·π·D/n_A"), Force, clause);
        let capacity = anchors.capacity.ok_or((CheckStatus::NotChecked, "tank.anchors.capacity".to_string()))?;
        let name = "Tension of an anchor";
        Ok(Check::new(ANCHORS.id, name, tension, capacity, Force, clause, note))
    }
}
