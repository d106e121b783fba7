//! Calculation lines and comparisons of a governing section of concrete.

use super::place::{Place, Situation};
use crate::ec8::limit_states::{CRACKS, DAMAGE, DAMAGE_CRACKS, WALL_BENDING, WALL_SHEAR};
use crate::ec8::work::Work;
use crate::en1992::crack::{self, Width};
use crate::en1992::section::{Face, Section};
use crate::en1992::shear::{RESISTANCE, Shear};
use crate::sheet::Sheet;
use tank::BarDirection;
use tank::assessment::Check;
use tank::units::Dimension::*;

/// A place with its section and the utilisation there.
#[derive(Clone, Copy, Debug)]
pub(super) struct Governing<'a> {
    pub place: &'a Place<'a>,
    pub section: &'a Section,
    pub utilisation: f64,
}

/// Clause of bending with axial force.
const BENDING: &str = "EN 1992-1-1:2004 6.1";
/// Clause of shear without links.
const SHEAR: &str = "EN 1992-1-1:2004 6.2.2";
/// Clause of the crack width.
const CRACK: &str = "EN 1992-1-1:2004 7.3.4";
/// Clause of its limit.
const LIMIT: &str = "EN 1992-3:2006 7.3.1";

impl Governing<'_> {
    /// Strengths and bars.
    fn section_lines(&self, sheet: &mut Sheet) {
        let s = self.section;
        sheet.input("h", "thickness of the wall", s.thickness, Length, "input");
        let (gamma_c, gamma_s) = s.factors;
        let source = "procedures.concrete; EN 1998-1:2004 5.2.4";
        sheet.input("γ_c", "partial factor of concrete", gamma_c, Dimensionless, source);
        sheet.input("γ_s", "partial factor of bars", gamma_s, Dimensionless, source);
        sheet.given(&[("f_ck", s.strength, Stress)]);
        let clause = "EN 1992-1-1:2004 3.1.6";
        sheet.calc("f_cd", "strength of concrete", "f_ck/γ_c", Stress, clause);
        for bars in &s.bars {
            sheet.given(&[("f_yk", bars.yield_strength, Stress)]);
            let clause = "EN 1992-1-1:2004 3.2.7";
            sheet.calc("f_yd", "strength of the bars", "f_yk/γ_s", Stress, clause);
            sheet.input("a_s", "area of the bars", bars.area, LineArea, "input");
            sheet.input("d_i", "their distance from the inner face", bars.depth, Length, "input");
        }
    }

    fn action_lines(&self, sheet: &mut Sheet, clause: &str) {
        let p = self.place;
        sheet.input("n_Ed", "axial force, tension positive", p.n, LineForce, clause);
        let name = "moment, positive where the inner face pulls";
        sheet.input("m_Ed", name, p.m, LineMoment, clause);
    }

    fn bars(&self) -> (&'static str, &'static str) {
        match self.place.direction {
            BarDirection::Hoop => ("horizontal", "Horizontal"),
            BarDirection::Vertical => ("vertical", "Vertical"),
        }
    }
}

/// Bending with axial force.
pub(super) fn bending(work: &mut Work, governing: &Governing) {
    let (place, section) = (governing.place, governing.section);
    let (bars, title) = governing.bars();
    let sheet = &mut work.sheet;
    sheet.section(&format!("Wall of concrete: {bars} bars, {}", place.describe()));
    governing.section_lines(sheet);
    governing.action_lines(sheet, "forces of the wall");
    let tension = if place.m >= 0.0 { Face::Inner } else { Face::Outer };
    let source = "strain compatibility, rectangular block 0.8 x, bars without hardening";
    // In tension along a ray of the same eccentricity, named by the larger part; in compression at the same force.
    let pulls = place.n > 0.0 && place.n * 0.5 * section.thickness > place.m.abs();
    let (demand, dimension) = if pulls { (place.n, LineForce) } else { (place.m.abs(), LineMoment) };
    let capacity = match governing.utilisation {
        u if u.is_infinite() => 0.0,
        u if u > 0.0 => demand / u,
        // Nothing to resist.
        _ => section.bending_resistance(place.n, tension).unwrap_or_default(),
    };
    let (symbol, name) = match (pulls, place.n > 0.0) {
        (true, _) => ("n_Rd", "tension resisted with the same eccentricity"),
        (false, true) => ("m_Rd", "moment resisted with the same eccentricity"),
        (false, false) => ("m_Rd", "moment resisted with n_Ed"),
    };
    sheet.look_up(symbol, name, source, capacity, dimension, BENDING);
    let id = format!("{}_{bars}", WALL_BENDING.id);
    let name = format!("{title} bars: tension and bending of the wall");
    let check = Check::new(&id, &name, demand, capacity, dimension, BENDING, &place.describe());
    work.out.checks.push(check.of(WALL_BENDING.id));
}

/// Tells the values of [`RESISTANCE`].
fn shear_terms(sheet: &mut Sheet, section: &Section, terms: &Shear) {
    sheet.given(&[
        ("p", 1e6, Stress),
        ("l", 1.0, Length),
        ("γ_c", section.factors.0, Dimensionless),
        ("f_ck", section.strength, Stress),
        ("d", terms.depth, Length),
        ("A_sl", terms.area, LineArea),
        ("σ_cp", terms.axial, Stress),
    ]);
}

/// V_Rd,c [N/m].
pub(super) fn shear_resistance(section: &Section, terms: &Shear) -> f64 {
    let mut sheet = Sheet::new();
    shear_terms(&mut sheet, section, terms);
    sheet.calc("v_Rd,c", "", RESISTANCE, LineForce, SHEAR)
}

/// Shear without links.
pub(super) fn shear(work: &mut Work, governing: &Governing, terms: Option<Shear>) {
    let (place, section) = (governing.place, governing.section);
    let demand = place.shear.unwrap_or_default();
    let sheet = &mut work.sheet;
    sheet.section(&format!("Wall of concrete: shear, {}", place.describe()));
    governing.action_lines(sheet, "forces of the wall");
    sheet.input("v_Ed", "shear across the wall", demand, LineForce, "forces of the wall");
    let mut capacity = 0.0;
    if let Some(terms) = terms {
        sheet.input("d", "effective depth of the bars in tension", terms.depth, Length, "input");
        sheet.input("A_sl", "area of the bars in tension", terms.area, LineArea, "input");
        sheet.given(&[
            ("n_Ed", place.n, LineForce),
            ("h", section.thickness, Length),
            ("f_cd", section.design_strength(), Stress),
        ]);
        let name = "axial stress, compression positive, at most 0.2 f_cd";
        sheet.calc("σ_cp", name, "min(-n_Ed/h, 0.2·f_cd)", Stress, SHEAR);
        shear_terms(sheet, section, &terms);
        let name = "resistance without links, p = 1 MPa, l = 1 m";
        capacity = sheet.calc("v_Rd,c", name, RESISTANCE, LineForce, SHEAR);
    }
    let (name, note) = ("Shear of the wall without links", place.describe());
    work.check(WALL_SHEAR.named(name), demand, capacity, SHEAR, &note);
}

/// Crack width.
pub(super) fn crack(
    work: &mut Work,
    governing: &Governing,
    width: &Width,
    limit: f64,
    duration: f64,
    situation: Situation,
) {
    let (place, section) = (governing.place, governing.section);
    let bars = governing.bars().0;
    let sheet = &mut work.sheet;
    sheet.section(&format!("Wall of concrete: crack width, {bars} bars, {}", place.describe()));
    governing.action_lines(sheet, "forces of the wall");
    let steel = section.bars.first().map_or(200e9, |b| b.modulus);
    sheet.look_up("σ_s", "stress of the bars", "cracked elastic section", width.stress, Stress, CRACK);
    sheet.look_up("h_c,ef", "effective height", "min(2.5 (h - d), (h - x)/3, h/2)", width.effective, Length, CRACK);
    if width.stress > 0.0 {
        sheet.given(&[
            ("c", width.cover, Length),
            ("k_2", width.distribution, Dimensionless),
            ("φ", width.diameter, Length),
            ("ρ_p", width.ratio, Dimensionless),
        ]);
        let close = 3.4 * width.cover + 0.34 * width.distribution * width.diameter / width.ratio;
        if (width.spacing - close).abs() <= 1e-9 * close {
            let formula = "3.4·c + 0.425·0.8·k_2·φ/ρ_p";
            sheet.calc("s_r", "largest crack spacing", formula, Length, CRACK);
        } else {
            let source = "1.3 (h - x), bars wider apart than 5 (c + φ/2)";
            sheet.look_up("s_r", "largest crack spacing", source, width.spacing, Length, CRACK);
        }
        sheet.given(&[
            ("k_t", duration, Dimensionless),
            ("f_ct", crack::tensile_strength(section.strength), Stress),
            ("ρ_p", width.ratio, Dimensionless),
            ("E_s", steel, Stress),
            ("E_cm", section.modulus, Stress),
        ]);
        let name = "mean strain of bars less that of concrete";
        let formula = "max(σ_s - k_t·f_ct/ρ_p·(1 + E_s/E_cm·ρ_p), 0.6·σ_s)/E_s";
        sheet.calc("ε_m", name, formula, Dimensionless, CRACK);
    }
    let demand = sheet.calc("w_k", "crack width", "s_r·ε_m", Length, CRACK);
    let source = "tightness class; through cracks by h_D/h, otherwise 0.3 mm";
    sheet.look_up("w_k1", "its limit", source, limit, Length, LIMIT);
    let clause = format!("{CRACK}, {LIMIT}");
    let (id, name, state) = match situation {
        Situation::Damage => (DAMAGE_CRACKS.id, DAMAGE_CRACKS.name, DAMAGE.id),
        _ => (CRACKS.id, CRACKS.name, CRACKS.id),
    };
    let note = format!("{bars} bars, {}", place.describe());
    let check = Check::new(id, name, demand, limit, Length, &clause, &note);
    work.out.checks.push(check.of(state));
}
