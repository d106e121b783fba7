//! Checks of a cylinder's wall: hoop yielding and stability A.10.
//!
//! Stability is checked at the lower edge of every course under every combination of horizontal and vertical motion; the
//! governing place is printed. The elastic check takes the smallest, the elastic-plastic one the largest interior pressure. Over- or
//! underpressure above the liquid enters the interior pressure and, over the roof, the axial force with p R/2.

use super::buckling::{Wall, collapse_lines, elastic_lines, limit};
use super::cylinder_base::{self, Amplification};
use super::cylinder_stress::{Factors, State};
use super::limit_states::{ELASTIC_BUCKLING, ELEPHANT_FOOT, HOOP};
use super::work::Work;
use crate::sheet::{number, with_unit};
use tank::assessment::{Check, CheckStatus, CourseHoop, TOTAL_HOOP};
use tank::units::Dimension::*;
use tank::{Course, Support};

/// Clause of the factors of a combination with an earthquake.
const SITUATION: &str = "EN 1990:2002 6.4.3.4";

/// Compression and pressures at the lower edge of a course under one combination.
#[derive(Clone, Copy)]
struct Place<'a> {
    course: &'a Course,
    number: usize,
    z: f64,
    factors: Factors,
    /// Pressure of the gas above the liquid [Pa].
    gas: f64,
    /// Its tension in the wall, p_g R/2 [N/m].
    lift: f64,
    /// Seismic axial force [N/m].
    axial: f64,
    /// Axial force of the weight [N/m].
    weight: f64,
    /// Smallest and largest interior pressure [Pa].
    p_min: f64,
    p_max: f64,
    yield_strength: f64,
}

impl Place<'_> {
    /// σ_m [Pa].
    fn compression(&self) -> f64 {
        (self.axial + self.weight - self.lift) / self.course.net_thickness()
    }

    fn wall(&self, radius: f64, quality: f64) -> Wall {
        Wall {
            youngs_modulus: self.course.material.youngs_modulus,
            yield_strength: self.yield_strength,
            thickness: self.course.net_thickness(),
            radius,
            quality,
        }
    }

    fn describe(&self, vertical: bool) -> String {
        let mut place = format!("course {} at z = {}", self.number, with_unit(self.z, Length));
        if self.gas > 0.0 {
            place += ", overpressure";
        } else if self.gas < 0.0 {
            place += ", vacuum";
        }
        if vertical {
            format!("{place}, {} E_x + {} E_z", number(self.factors.0), number(self.factors.1))
        } else {
            place
        }
    }
}

/// The place with the largest demand/capacity, and its capacity.
fn governing<'a>(
    places: &[Place<'a>],
    demand: impl Fn(&Place) -> f64,
    capacity: impl Fn(&Place) -> f64,
) -> Option<(Place<'a>, f64)> {
    let judged = places.iter().map(|place| {
        let limit = capacity(place);
        let utilisation = if limit > 0.0 { demand(place) / limit } else { f64::INFINITY };
        (place, limit, utilisation)
    });
    // Equal utilisation: the lower place.
    let (worst, limit, _) = judged.max_by(|a, b| a.2.total_cmp(&b.2).then(b.0.z.total_cmp(&a.0.z)))?;
    Some((*worst, limit))
}

/// Writes the checks.
pub(super) fn assess(work: &mut Work, state: &State, vertical: bool) {
    let amplification = match state.tank.support {
        Support::Anchored => {
            cylinder_base::anchorage(work, state, vertical);
            Amplification::Factor(1.0)
        }
        Support::Unanchored => cylinder_base::unanchored(work, state),
    };
    let clause = work.edition.clause("10");
    if !state.tank.is_metal() {
        return;
    }
    let missing = state.tank.courses.iter().find(|c| c.material.yield_strength.is_none());
    if let Some(course) = missing {
        let input = format!("materials.{}.yield_strength", course.material.name);
        let reason = format!("`{input}` is missing");
        for id in [HOOP.id, ELASTIC_BUCKLING.id, ELEPHANT_FOOT.id] {
            work.without_comparison(id, CheckStatus::NotChecked, &reason, Some(&input));
        }
        return;
    }
    let factor = match &amplification {
        Amplification::Factor(factor) => *factor,
        Amplification::Overturns => {
            work.out.notes.push(format!(
                "{clause}, stability of the wall: checked with the compression of an anchored wall, a lower bound, because the \
                 unanchored tank overturns."
            ));
            1.0
        }
        Amplification::Missing(_) => 1.0,
    };
    if state.tank.pressure.vacuum > 0.0 {
        work.out.notes.push(format!(
            "{clause}: the vacuum enters the axial compression and the supporting pressure; buckling of the wall under outer pressure \
             (EN 1993-1-6) is not covered."
        ));
    }
    let places = places(state, vertical, factor);
    hoop_yield(work, state, &places, vertical);
    if let Amplification::Missing(input) = amplification {
        // What uplift does to the compression at the base is not known.
        let reason = format!("`{input}` is missing");
        for id in [ELASTIC_BUCKLING.id, ELEPHANT_FOOT.id] {
            work.without_comparison(id, CheckStatus::NotChecked, &reason, Some(&input));
        }
        return;
    }
    elastic_check(work, state, &places, vertical);
    collapse_check(work, state, &places, vertical);
    if matches!(amplification, Amplification::Overturns) {
        leave_open(work);
    }
}

/// Leaves checks open if the tank overturns: the compression of an anchored wall is then a lower bound, which can only fail a check.
fn leave_open(work: &mut Work) {
    let of_wall = |check: &&mut Check| [ELASTIC_BUCKLING.id, ELEPHANT_FOOT.id].contains(&check.limit_state.as_str());
    let holding = work.out.checks.iter_mut().filter(of_wall).filter(|check| check.holds());
    for check in holding {
        let share = check.utilisation.unwrap_or_default();
        let reason = format!(
            "the unanchored tank overturns: the compression of its wall is not known; that of an anchored wall, a lower bound, is {:.0} % of the \
             capacity",
            100.0 * share
        );
        *check = check.left_open(reason);
    }
}

fn places<'a>(state: &State<'a>, vertical: bool, amplification: f64) -> Vec<Place<'a>> {
    let mut out = Vec::new();
    let mut z = 0.0;
    for (index, course) in state.tank.courses.iter().enumerate() {
        let combinations = state.combinations(vertical).into_iter();
        for (factors, gas) in combinations.flat_map(|f| state.gas().into_iter().map(move |gas| (f, gas))) {
            let (p_min, p_max) = state.pressure_range(z, factors, gas);
            let weight = state.weight(z) * state.weight_factor(factors.1);
            let axial = factors.0 * state.axial(z);
            // At its base an unanchored wall carries a multiple of the anchored wall's whole force.
            let axial = if z == 0.0 { amplification * (axial + weight) - weight } else { axial };
            out.push(Place {
                course,
                number: index + 1,
                z,
                factors,
                gas,
                lift: 0.5 * gas * state.radius,
                axial,
                weight,
                p_min,
                p_max,
                yield_strength: course.material.yield_strength.unwrap_or_default(),
            });
        }
        z += course.height;
    }
    out
}

fn hoop_yield(work: &mut Work, state: &State, places: &[Place], vertical: bool) {
    let hoop = |p: &Place| p.p_max * state.radius / p.course.net_thickness();
    let Some((place, capacity)) = governing(places, hoop, |p| p.yield_strength) else { return };
    let z = work.heights();
    let total = |z: f64| state.largest_pressure(z, vertical) * state.radius / state.tank.course_at(z).net_thickness();
    work.profile(TOTAL_HOOP, "Hoop stress, static and seismic", Stress, &z, total);
    work.out.courses = courses(state, places);
    let clause = work.edition.clause("10.3");
    work.sheet.section("Hoop stress with the static state");
    pressure_line(work, state, &place, "p_max");
    work.sheet.given(&[("p_max", place.p_max, Stress), ("s", place.course.net_thickness(), Length)]);
    let name = format!("largest hoop stress, {}", place.describe(vertical));
    let stress = work.sheet.calc("σ_θ,max", &name, "p_max·R/s", Stress, &clause);
    let note = format!("p R/(s f_y) < 1 with γ_M = 1, {}", place.describe(vertical));
    let name = "Hoop stress below yield";
    work.check(HOOP.named(name), stress, capacity, &clause, &note);
}

/// Hoop forces and stresses of the courses, each at its lower edge under the combination of its largest pressure.
fn courses(state: &State, places: &[Place]) -> Vec<CourseHoop> {
    let of = |number: usize| {
        let own = places.iter().filter(|place| place.number == number);
        let place = own.max_by(|a, b| a.p_max.total_cmp(&b.p_max))?;
        let force = |pressure: f64| Some(pressure * state.radius);
        Some(CourseHoop {
            course: number,
            z: place.z,
            thickness: place.course.net_thickness(),
            hydrostatic: force(state.pressure_hydrostatic(place.z)),
            impulsive: force(state.pressure_impulsive(place.z)),
            convective: force(state.pressure_convective(place.z)),
            vertical: force(state.pressure_vertical(place.z)),
            stress: place.p_max * state.radius / place.course.net_thickness(),
            limit: Some(place.yield_strength),
        })
    };
    (1..=state.tank.courses.len()).filter_map(of).collect()
}

/// Line of the largest (`p_max`) or smallest (`p_min`) interior pressure at a place, with the factors of the seismic design
/// situation.
fn pressure_line(work: &mut Work, state: &State, place: &Place, symbol: &str) {
    let z = place.z;
    let (sign, name) = match symbol {
        "p_max" => ("+", "largest interior pressure"),
        _ => ("-", "smallest interior pressure"),
    };
    work.sheet.given(&[
        ("p_0", state.pressure_hydrostatic(z), Stress),
        ("p_g", place.gas, Stress),
        ("E_x", place.factors.0, Dimensionless),
        ("p_h", state.pressure_horizontal(z), Stress),
        ("E_z", place.factors.1, Dimensionless),
        ("p_v", state.pressure_vertical(z), Stress),
    ]);
    let gas = if place.gas == 0.0 { "" } else { " + γ_F·p_g" };
    let formula = format!("γ_F·p_0{gas} {sign} E_x·p_h {sign} E_z·p_v");
    work.sheet.calc(symbol, name, &formula, Stress, SITUATION);
}

/// Lines of the compression; returns it [Pa].
fn compression_lines(work: &mut Work, place: &Place, clause: &str) -> f64 {
    work.sheet.given(&[("p_g", place.gas, Stress), ("s", place.course.net_thickness(), Length)]);
    work.sheet.input("n_z", "seismic axial compression", place.axial, LineForce, clause);
    work.sheet.input("N_0", "axial compression of the weight above", place.weight, LineForce, clause);
    let (name, formula) = if place.gas == 0.0 {
        ("vertical membrane compression", "(n_z + N_0)/s")
    } else {
        ("vertical membrane compression with the pressure above the liquid", "(n_z + N_0 - p_g·R/2)/s")
    };
    work.sheet.calc("σ_m", name, formula, Stress, clause)
}

fn elastic_check(work: &mut Work, state: &State, places: &[Place], vertical: bool) {
    let site = work.demand.site;
    let quality = site.map_or(1.0, |s| s.construction_quality);
    let radius = state.radius;
    let of = |p: &Place| limit(elastic_lines, &p.wall(radius, quality), p.p_min);
    let Some((place, _)) = governing(places, |p| p.compression(), of) else { return };
    let clause = work.edition.clause("10.2");
    work.sheet.section(&format!("Elastic buckling, {}", place.describe(vertical)));
    let compression = compression_lines(work, &place, &clause);
    pressure_line(work, state, &place, "p_min");
    let wall = place.wall(radius, quality);
    let limit = elastic_lines(&mut work.sheet, &wall, place.p_min, &clause);
    if place.p_min < 0.0 {
        work.out.notes.push(format!(
            "{clause}: the formulas give a suction of {} as the smallest interior pressure ({}); zero is used.",
            with_unit(-place.p_min, Stress),
            place.describe(vertical)
        ));
    }
    if site.is_none() {
        work.out
            .notes
            .push(format!("{clause}: normal quality of construction (a = 1) assumed, `site.ec8` is not given."));
    }
    let note = place.describe(vertical);
    work.check(ELASTIC_BUCKLING, compression, limit, &clause, &note);
}

fn collapse_check(work: &mut Work, state: &State, places: &[Place], vertical: bool) {
    let radius = state.radius;
    let of = |p: &Place| limit(collapse_lines, &p.wall(radius, 1.0), p.p_max);
    let Some((place, _)) = governing(places, |p| p.compression(), of) else { return };
    let clause = work.edition.clause("10.3");
    work.sheet.section(&format!("Elastic-plastic collapse, {}", place.describe(vertical)));
    let compression = compression_lines(work, &place, &clause);
    pressure_line(work, state, &place, "p_max");
    let limit = collapse_lines(&mut work.sheet, &place.wall(radius, 1.0), place.p_max, &clause);
    let note = place.describe(vertical);
    work.check(ELEPHANT_FOOT, compression, limit, &clause, &note);
}

#[cfg(test)]
mod tests;
