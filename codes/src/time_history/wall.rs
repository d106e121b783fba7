//! Stresses of a metal shell against yield and buckling, course by course.

use tank::Course;
use tank::assessment::{Check, CheckStatus};
use tank::quantity::Quantity;
use tank::units::Dimension::{Dimensionless, Length, Stress};

use super::limit_states::{
    API, API_COMPRESSION, API_HOOP, BENDING, COLLAPSE, Codes, ELASTIC, EN_1993, EQUIVALENT, HOOP,
};
use super::search::{Found, Histories};
use super::work::Work;
use crate::api650::edition2020::hoop_check;
use crate::api650::edition2020::limit_states::carbon_steel;
use crate::api650::hold_down;
use crate::ec8::buckling::{elastic, elastic_plastic};
use crate::ec8::cylinder_checks::{Wall, collapse_lines, elastic_lines};
use crate::ec8::demand::Edition;
use crate::sheet::{number, with_unit};

/// Quality of construction without `site.ec8`: normal, the lowest.
const NORMAL: f64 = 1.0;

/// A limit state of the wall.
struct Asked<'a> {
    id: &'static str,
    name: &'static str,
    clause: String,
    /// Quantities whose mesh errors its demand has.
    of: &'static [Quantity],
    /// What it finds at a place of a course.
    find: Box<dyn Fn(&Histories, &Course) -> Option<Found> + 'a>,
}

/// Adds the checks of all limit states of a metal shell.
pub(super) fn assess(work: &mut Work<'_>, radius: f64) {
    let case = work.case;
    let all = asked(work, radius);
    // Of each limit state the worst place of each course.
    let mut worst: Vec<Vec<Option<(Found, usize)>>> = vec![vec![None; case.tank.courses.len()]; all.len()];
    let mut pressures = vec![0.0; all.len() * case.tank.courses.len()];
    for (number, place) in work.demands.places.iter().enumerate() {
        let histories = Histories::new(work.demands, place);
        let course = &case.tank.courses[place.course];
        for (k, asked) in all.iter().enumerate() {
            let Some(found) = (asked.find)(&histories, course) else {
                continue;
            };
            let best = &mut worst[k][place.course];
            if best.is_none_or(|(best, _)| found.utilisation > best.utilisation) {
                *best = Some((found, number));
                pressures[k * case.tank.courses.len() + place.course] =
                    histories.pressure_at(found.instant, found.cosine);
            }
        }
    }
    let lines: Vec<(&'static str, &'static str, String, &'static [Quantity])> =
        all.into_iter().map(|a| (a.id, a.name, a.clause, a.of)).collect();
    for (k, (id, name, clause, of)) in lines.into_iter().enumerate() {
        let courses = worst[k].iter().enumerate();
        let found: Vec<(usize, Found, usize)> = courses.filter_map(|(c, w)| w.map(|(f, p)| (c, f, p))).collect();
        let governing = found
            .iter()
            .copied()
            .reduce(|best, next| match next.1.utilisation > best.1.utilisation {
                true => next,
                false => best,
            });
        let Some((course, governing, place)) = governing else {
            continue;
        };
        let pressure = pressures[k * case.tank.courses.len() + course];
        let z = work.demands.places[place].z;
        let place = work.moment(&governing, z);
        work.sheet
            .section(&format!("{name}: course {}, {}", course + 1, place.words()));
        lines_of(work, id, &clause, radius, (course, &governing, pressure));
        let rest: Vec<String> = (found.iter())
            .filter(|other| other.0 != course)
            .map(|other| {
                format!(
                    "course {}: {}",
                    other.0 + 1,
                    number((other.1.utilisation * 1e3).round() / 1e3)
                )
            })
            .collect();
        let mut note = format!("course {}", course + 1);
        if !rest.is_empty() {
            note.push_str(&format!("; utilisation of the others: {}", rest.join(", ")));
        }
        let error = work.error(of, &governing);
        let check = Check::new(id, name, governing.demand, governing.capacity, Stress, &clause, &note);
        let check = check.at(Some(place.time), Some(z), Some(place.theta)).with_error(error);
        work.checks.push(check);
    }
}

/// The limit states of the wall, those without their strengths marked as not checked.
fn asked<'a>(work: &mut Work<'a>, radius: f64) -> Vec<Asked<'a>> {
    let case = work.case;
    let codes = Codes::of(case);
    let missing = case.tank.courses.iter().find(|c| c.material.yield_strength.is_none());
    let missing = missing.map(|course| format!("materials.{}.yield_strength", course.material.name));
    let en = |number: &str| Edition::En2006.clause(number);
    let quality = case.site.ec8.map_or(NORMAL, |site| site.construction_quality);
    let strength = |course: &Course| course.material.yield_strength.unwrap_or_default();
    let (hoop, axial) = (&[Quantity::HoopStress], &[Quantity::AxialMembraneStress]);
    let mut all: Vec<Asked<'a>> = vec![
        Asked {
            id: EQUIVALENT,
            name: "Equivalent membrane stress of the wall",
            clause: format!("{EN_1993} 6.2.1"),
            of: &[Quantity::HoopStress, Quantity::AxialMembraneStress],
            find: Box::new(move |at, course| at.equivalent(strength(course))),
        },
        Asked {
            id: BENDING,
            name: "Range of the equivalent stress with bending at the base",
            clause: format!("{EN_1993} 7.4"),
            of: &[Quantity::BendingStress],
            find: Box::new(move |at, course| at.range_at_base(course.material.poisson_ratio, 2.0 * strength(course))),
        },
    ];
    if codes.ec8 {
        all.push(Asked {
            id: HOOP,
            name: "Hoop stress below yield",
            clause: en("10.3"),
            of: hoop,
            find: Box::new(move |at, course| at.hoop_tension(strength(course))),
        });
        all.push(Asked {
            id: ELASTIC,
            name: "Elastic buckling of the wall",
            clause: en("10.2"),
            of: axial,
            find: Box::new(move |at, c| {
                let (modulus, s) = (c.material.youngs_modulus, c.thickness);
                at.compression(|p| elastic(modulus, strength(c), s, radius, p, quality).limit)
            }),
        });
        all.push(Asked {
            id: COLLAPSE,
            name: "Elastic-plastic collapse of the wall",
            clause: en("10.3"),
            of: axial,
            find: Box::new(move |at, c| {
                let (modulus, s) = (c.material.youngs_modulus, c.thickness);
                at.compression(|p| elastic_plastic(modulus, strength(c), s, radius, p.max(0.0)))
            }),
        });
    }
    let mut missing_states = Vec::new();
    if let Some(input) = &missing {
        missing_states.extend(all.drain(..).map(|asked| (asked.id, input.clone())));
    }
    if let Some(site) = case.site.api650 {
        let efficiency = site.joint_efficiency;
        let allowed: Result<Vec<f64>, String> = (case.tank.courses.iter())
            .map(|course| hoop_check::allowable(&course.material, efficiency))
            .collect();
        match allowed {
            Ok(_) => all.push(Asked {
                id: API_HOOP,
                name: "Hoop stress of the shell",
                clause: format!("{API} E.6.2.4"),
                of: hoop,
                find: Box::new(move |at, course| {
                    at.hoop_tension(hoop_check::allowable(&course.material, efficiency).unwrap_or_default())
                }),
            }),
            Err(input) => missing_states.push((API_HOOP, input)),
        }
        match (carbon_steel(case), &missing) {
            (false, _) => {}
            (true, Some(input)) => missing_states.push((API_COMPRESSION, input.clone())),
            (true, None) => all.push(Asked {
                id: API_COMPRESSION,
                name: "Compression of the shell",
                clause: format!("{API} E.6.2.2.3"),
                of: axial,
                find: Box::new(move |at, course| {
                    at.compression(|p| allowable_compression(case.liquid.density, case.gravity, radius, course, p))
                }),
            }),
        }
    }
    for (id, input) in missing_states {
        let reason = format!("`{input}` is missing");
        work.without(id, CheckStatus::NotChecked, &reason, Some(&input));
    }
    all
}

/// Depth of liquid [m] that has the interior pressure, the H of the pressure parameter.
fn head(density: f64, gravity: f64, pressure: f64) -> f64 {
    pressure.max(0.0) / (density * gravity)
}

/// F_C at an interior pressure [Pa].
fn allowable_compression(density: f64, gravity: f64, radius: f64, course: &Course, pressure: f64) -> f64 {
    let depth = head(density, gravity, pressure);
    let (diameter, f_ty) = (2.0 * radius, course.material.yield_strength);
    hold_down::allowable_compression(course.thickness, diameter, density / 1000.0, depth, f_ty).unwrap_or(0.0)
}

/// Lines of the governing place of a limit state.
fn lines_of(work: &mut Work<'_>, id: &str, clause: &str, radius: f64, at: (usize, &Found, f64)) {
    let (course, found, pressure) = at;
    let case = work.case;
    let course = &case.tank.courses[course];
    let (symbol, name) = match id {
        HOOP | API_HOOP => ("σ_θ", "largest hoop membrane stress, static and seismic"),
        EQUIVALENT => (
            "σ_v",
            "largest equivalent membrane stress, √(σ_θ² + σ_z² - σ_θ σ_z + 3 τ²)",
        ),
        BENDING => ("Δσ_v", "range of the equivalent stress of a face"),
        _ => ("σ_m", "axial membrane compression, static and seismic"),
    };
    work.sheet
        .input(symbol, name, found.demand, Stress, "the run of the engine");
    let f_y = course.material.yield_strength.unwrap_or_default();
    let wall = Wall {
        youngs_modulus: course.material.youngs_modulus,
        yield_strength: f_y,
        thickness: course.thickness,
        radius,
        quality: case.site.ec8.map_or(NORMAL, |site| site.construction_quality),
    };
    let interior = "interior pressure there and then, static and seismic";
    match id {
        ELASTIC => {
            work.sheet
                .input("p_min", interior, pressure, Stress, "the run of the engine");
            elastic_lines(&mut work.sheet, &wall, pressure, clause);
        }
        COLLAPSE => {
            let pressure = pressure.max(0.0);
            work.sheet
                .input("p_max", interior, pressure, Stress, "the run of the engine");
            collapse_lines(&mut work.sheet, &wall, pressure, clause);
        }
        API_COMPRESSION => {
            let depth = head(case.liquid.density, case.gravity, pressure);
            let source = format!("{} of interior pressure there and then", with_unit(pressure, Stress));
            work.sheet
                .look_up("H", "depth with that pressure", &source, depth, Length, clause);
            let terms = [
                ("t_s", course.thickness, Length),
                ("D", 2.0 * radius, Length),
                ("G", case.liquid.density / 1000.0, Dimensionless),
                ("H", depth, Length),
                ("F_ty", f_y, Stress),
            ];
            let (symbol, name) = ("G·H·D²/t_s²", "pressure parameter of the shell [m³/mm²]");
            let slenderness = hold_down::SLENDERNESS;
            let ratio = work
                .sheet
                .calc(symbol, name, slenderness, &terms, Dimensionless, clause);
            if let Some(formula) = hold_down::allowable(ratio, true, false) {
                let name = "allowable shell compression";
                work.sheet.calc("F_C", name, formula, &terms, Stress, clause);
            }
        }
        BENDING => {
            let terms = [("f_y", f_y, Stress)];
            let name = "limit of the range, beyond which the wall yields in every cycle";
            work.sheet.calc("Δσ_Rd", name, "2·f_y", &terms, Stress, clause);
        }
        API_HOOP => {
            let source = "lesser of 1.33 S_d e and 0.9 F_y e";
            let name = "allowable hoop stress with the earthquake";
            work.sheet.look_up("σ_a", name, source, found.capacity, Stress, clause);
        }
        _ => {
            work.sheet.input("f_y", "yield strength", f_y, Stress, "materials");
        }
    }
}
