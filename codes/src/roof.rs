//! Roofs, and what the wall carries below them: mass and weight, the share of snow, and what a procedure assumes of them.
//!
//! The whole roof moves with the wall, so that its mass m_r counts in every horizontal force. Of its weight the wall carries what columns
//! leave; a resistance counts the weight without snow where the code has no share of it.

use tank::case::Case;
use tank::units::Dimension::{AreaMass, Dimensionless, Length, Mass, Stress};
use tank::{RoofKind, Shape, Tank};

use crate::sheet::{Sheet, number, with_unit};

/// Share of the balanced design snow load in W_r and w_rs, API 650 E.2.2.
pub(crate) const SNOW_OF_API: f64 = 0.1;

/// Why a live load has no share, by code.
pub(crate) enum LiveLoad {
    /// EN 1998.
    Eurocode,
    /// API 650.
    Api,
}

/// What the procedures assume of roof, rings, attachments and insulation.
pub(crate) fn assumptions(tank: &Tank, code: &LiveLoad) -> Vec<String> {
    let mut all: Vec<String> = floating(tank).into_iter().collect();
    let roof = &tank.roof;
    if roof.on_columns > 0.0 {
        let how = match roof.columns {
            Some(ring) => format!(
                "rafters span from the outermost columns, at {} from the middle, to the wall and carry the same load everywhere",
                with_unit(ring, Length)
            ),
            None => "the share is an input".to_owned(),
        };
        all.push(format!(
            "Columns carry {} % of the weight of the roof to the bottom, the wall carries the rest: {how}. The inertia of the whole roof is \
             with the wall. The columns, which stand in the liquid, are not checked.",
            number((1000.0 * roof.on_columns).round() / 10.0)
        ));
    }
    if let Some(load) = roof.live_load.filter(|load| *load > 0.0) {
        let why = match code {
            LiveLoad::Eurocode => "EN 1990:2002 table A1.1 has ψ_2 = 0 for roofs (category H)",
            LiveLoad::Api => "W_r of API 650:2020 E.2.2 has none",
        };
        all.push(format!(
            "The live load of the roof, {}, has no share in the seismic mass: {why}.",
            with_unit(load, Stress)
        ));
    }
    if !tank.rings.is_empty() {
        all.push(
            "The mass of the wall contains that of its rings. They do not stiffen it here: period and buckling of the wall are those of its \
             courses."
                .into(),
        );
    }
    if !tank.attachments.is_empty() {
        let mass: f64 = tank.attachments.iter().map(|one| one.mass).sum();
        all.push(format!(
            "The mass of the wall contains that of its attachments, {}, spread around the wall at their heights.",
            with_unit(mass, Mass)
        ));
    }
    if let Some(insulation) = tank.insulation {
        all.push(format!(
            "The mass of the wall contains that of its insulation, {} of wall, {} in all.",
            with_unit(insulation.mass, AreaMass),
            with_unit(tank.insulation_mass(), Mass)
        ));
    }
    all
}

/// What the procedures assume of a roof on the liquid; none without one.
fn floating(tank: &Tank) -> Option<String> {
    let what = match tank.roof.kind {
        RoofKind::Floating => "The floating roof",
        _ if tank.roof.afloat > 0.0 => "The internal floating roof",
        _ => return None,
    };
    let rim = match tank.roof.rim > 0.0 {
        true => {
            format!(" The freeboard is counted from its rim, {} above the liquid.", with_unit(tank.roof.rim, Length))
        }
        false => String::new(),
    };
    Some(format!(
        "{what} hangs on the liquid, not on the wall: it displaces its own mass of liquid below the level of fill_height, so the \
         mass of the liquid contains it. The wave is that of a free surface; a floating roof damps it.{rim}"
    ))
}

/// The line of the mass on the liquid, for information.
pub(crate) fn line(sheet: &mut Sheet, tank: &Tank) {
    if tank.roof.afloat > 0.0 {
        let name = match tank.roof.kind {
            RoofKind::Floating => "mass of the floating roof, within the mass of the liquid",
            _ => "mass of the internal floating roof, within the mass of the liquid",
        };
        sheet.input("m_f", name, tank.roof.afloat, Mass, "tank.roof");
    }
}

/// Lines of the mass m_r of the roof with its share of the snow by EN 1998, and of its part whose weight the wall carries.
pub(crate) fn mass_lines(sheet: &mut Sheet, case: &Case) {
    use tank::units::Dimension::{Acceleration, Area};
    let roof = &case.tank.roof;
    match roof.snow {
        None => {
            sheet.input("m_r", "mass of the roof", roof.mass, Mass, "input");
        }
        Some(snow) => {
            sheet.input("m_r0", "mass of the roof without snow", snow.bare, Mass, "tank.roof.mass");
            sheet.input("q_s", "characteristic snow load on the plan of the roof", snow.load, Stress, "tank.roof.snow");
            let source = "EN 1998-1:2004 4.2.4, EN 1990:2002 table A1.1; tank.roof.snow_combination";
            sheet.input("ψ_E", "share of the snow, φ·ψ_2 with φ = 1", snow.combination, Dimensionless, source);
            sheet.input("A_r", "plan area of the roof", case.tank.shape.plan_area(), Area, "input");
            sheet.given(&[("g", case.gravity, Acceleration)]);
            let name = "mass of the roof with its share of the snow";
            sheet.calc("m_r", name, "m_r0 + ψ_E·q_s·A_r/g", Mass, "EN 1998-1:2004 3.2.4");
        }
    }
    if share_line(sheet, &case.tank) {
        let name = "mass of the roof whose weight the wall carries";
        sheet.calc("m_rs", name, "f_s·m_r", Mass, "definition");
    }
}

/// Lines of the weight W_r of the roof with its share of the snow by API 650, and of its part W_rs on the shell.
pub(crate) fn weight_lines(sheet: &mut Sheet, case: &Case) {
    use tank::units::Dimension::{Area, Force};
    let roof = &case.tank.roof;
    match roof.snow {
        None => {
            sheet.input("W_r", "weight of the roof", case.gravity * roof.mass, Force, "tank.roof");
        }
        Some(snow) => {
            sheet.input("W_r0", "weight of the roof without snow", case.gravity * snow.bare, Force, "tank.roof.mass");
            sheet.input("S_b", "balanced design snow load", snow.load, Stress, "tank.roof.snow");
            sheet.input("A_r", "plan area of the roof", case.tank.shape.plan_area(), Area, "tank.radius");
            let name = "weight of the roof with 10 % of the balanced design snow load";
            sheet.calc("W_r", name, "W_r0 + 0.1·S_b·A_r", Force, "API 650:2020 E.2.2");
        }
    }
    if share_line(sheet, &case.tank) {
        sheet.calc("W_rs", "weight of the roof on the shell", "f_s·W_r", Force, "API 650:2020 E.2.2");
    }
}

/// Line of the share f_s of the weight on the wall; false where the wall carries the whole roof.
fn share_line(sheet: &mut Sheet, tank: &Tank) -> bool {
    let roof = &tank.roof;
    if roof.on_columns <= 0.0 {
        return false;
    }
    let name = "share of the roof's weight on the wall";
    match (roof.columns, tank.shape) {
        (Some(ring), Shape::Cylinder { radius }) => {
            sheet.given(&[("R", radius, Length)]);
            let of_ring = "radius of the outermost ring of columns";
            sheet.input("r_c", of_ring, ring, Length, "tank.roof.columns");
            let formula = "(1 - r_c/R)·(2 + r_c/R)/3";
            sheet.calc("f_s", name, formula, Dimensionless, "rafters under a uniform load, derived");
        }
        _ => {
            sheet.input("f_s", name, 1.0 - roof.on_columns, Dimensionless, "tank.roof.shell_share");
        }
    }
    true
}

/// Symbol of the mass of the roof whose weight holds the tank by EN 1998, with its line where that is not m_r: snow may be absent, which EN
/// 1990 asks of a favourable action, and columns take a part of it past the walls.
///
/// * `on_bottom`: whether what columns carry to the bottom holds the tank as well
pub(crate) fn holding(sheet: &mut Sheet, tank: &Tank, on_bottom: bool) -> &'static str {
    let roof = &tank.roof;
    let past = if on_bottom { 0.0 } else { roof.on_columns };
    let snow = roof.snow.filter(|snow| snow.mass > 0.0);
    let name = match (snow.is_some(), past > 0.0) {
        (false, false) => return "m_r",
        (true, false) => "mass of the roof that holds, without snow",
        (false, true) => "mass of the roof that holds, without what columns carry",
        (true, true) => "mass of the roof that holds, without snow and what columns carry",
    };
    let bare = snow.map_or(roof.mass, |snow| snow.bare);
    sheet.input("m_rh", name, (1.0 - past) * bare, Mass, "tank.roof");
    "m_rh"
}

#[cfg(test)]
mod tests;
