//! Stresses of a metal shell against yield and buckling, course by course.

use tank::Course;
use tank::assessment::{Check, CheckStatus};
use tank::case::Case;
use tank::quantity::Quantity;
use tank::units::Dimension::{Dimensionless, Length, Stress};

use super::limit_states::{
    API, API_COMPRESSION, API_HOOP, BENDING, COLLAPSE, Codes, ELASTIC, EN_1993, EQUIVALENT, HOOP,
};
use super::ready::Ready;
use super::search::{Capacity, Found, Search};
use super::work::Work;
use crate::api650::edition2020::hoop_check;
use crate::api650::edition2020::limit_states::carbon_steel;
use crate::api650::hold_down;
use crate::ec8::buckling::{elastic, elastic_plastic};
use crate::ec8::cylinder_checks::{Wall, collapse_lines, elastic_lines};
use crate::ec8::demand::Edition;
use crate::sheet::with_unit;

/// Quality of construction without `site.ec8`: normal, the lowest.
const NORMAL: f64 = 1.0;

/// What a limit state finds at a place of a course above a utilisation.
type Find<'a> = Box<dyn Fn(&Search<'_>, &Course, f64) -> Option<Found> + 'a>;

/// A limit state of the wall.
struct Asked<'a> {
    id: &'static str,
    name: &'static str,
    clause: String,
    /// Quantities whose mesh errors its demand has.
    of: &'static [Quantity],
    /// What it finds at a place of a course.
    find: Find<'a>,
}

/// The worst place of a course.
#[derive(Clone, Copy)]
struct Worst {
    /// Number of the course, from 0.
    course: usize,
    found: Found,
    /// Height [m].
    z: f64,
    /// Interior pressure there and then [Pa].
    pressure: f64,
}

/// Adds the checks of all limit states of a metal shell.
pub(super) fn assess(work: &mut Work<'_>, radius: f64) {
    let all = asked(work, radius);
    let worst = worst(work, &all);
    for (asked, courses) in all.iter().zip(worst) {
        let found: Vec<Worst> = courses.into_iter().flatten().collect();
        check(work, asked, &found, radius);
    }
}

/// The worst place of each course for each limit state: the first of those with the largest utilisation.
///
/// Where the same demands were searched under another factor, what is found now near the place and the instant that governed then passes over
/// most others.
fn worst(work: &Work<'_>, all: &[Asked<'_>]) -> Vec<Vec<Option<Worst>>> {
    let courses = &work.case.tank.courses;
    let mut worst: Vec<Vec<Option<Worst>>> = vec![vec![None; courses.len()]; all.len()];
    let mut governing = work.ready.governing.borrow_mut();
    // A utilisation that the worst place of each limit state and course reaches.
    let reached: Vec<Vec<f64>> = { all.iter() }
        .map(|asked| {
            let of = |number: usize| {
                let found = governing.get(&(asked.id, number)).and_then(|&(place, instant)| {
                    let near = work.search(work.ready.wall.get(place)?).near(instant);
                    (asked.find)(&near, &courses[number], f64::NEG_INFINITY)
                });
                found.map_or(f64::NEG_INFINITY, |found| found.utilisation.next_down())
            };
            (0..courses.len()).map(of).collect()
        })
        .collect();
    for (of_place, searched) in work.ready.wall.iter().enumerate() {
        let (number, place) = (searched.place.course, searched.place);
        let search = work.search(searched);
        for ((asked, worst), reached) in all.iter().zip(&mut worst).zip(&reached) {
            let (course, best) = (&courses[number], &mut worst[number]);
            let above = best.map_or(reached[number], |best| best.found.utilisation);
            let found = (asked.find)(&search, course, above).filter(|found| found.utilisation > above);
            if let Some(found) = found {
                governing.insert((asked.id, number), (of_place, found.instant));
                *best = Some(Worst {
                    course: number,
                    found: found.turned(place.turned),
                    z: place.z,
                    pressure: search.pressure_at(found.instant, found.direction),
                });
            }
        }
    }
    worst
}

/// The check of the governing course with its lines; the others stand in its note.
fn check(work: &mut Work<'_>, asked: &Asked<'_>, found: &[Worst], radius: f64) {
    let larger = |best: Worst, next: &Worst| match next.found.utilisation > best.found.utilisation {
        true => *next,
        false => best,
    };
    let Some(first) = found.first() else { return };
    let governing = found.iter().fold(*first, larger);
    let moment = work.moment(&governing.found, governing.z);
    let number_of = |worst: &Worst| worst.course + 1;
    let title = format!("{}: course {}, {}", asked.name, number_of(&governing), moment.words());
    work.sheet.section(&title);
    lines_of(work, asked, radius, &governing);
    let others: Vec<String> = (found.iter())
        .filter(|other| other.course != governing.course)
        .map(|other| format!("course {}: {:.2}", number_of(other), other.found.utilisation))
        .collect();
    let mut note = format!("course {}", number_of(&governing));
    if !others.is_empty() {
        note.push_str(&format!("; utilisation of the others: {}", others.join(", ")));
    }
    let error = work.error(asked.of, &governing.found);
    let Found { demand, capacity, .. } = governing.found;
    let check = Check::new(asked.id, asked.name, demand, capacity, Stress, &asked.clause, &note);
    let check = check.at(Some(moment.time), Some(governing.z), Some(moment.theta));
    work.checks.push(check.with_error(error));
}

/// The limit states of the wall, those without their strengths marked as not checked.
fn asked<'a>(work: &mut Work<'a>, radius: f64) -> Vec<Asked<'a>> {
    let case = work.case;
    let mut all = eurocode(case, work.codes, radius, work.ready);
    let without = case.tank.courses.iter().find(|c| c.material.yield_strength.is_none());
    let without = without.map(|course| format!("materials.{}.yield_strength", course.material.name));
    let mut missing: Vec<(&str, String)> = Vec::new();
    if let Some(input) = &without {
        missing.extend(all.drain(..).map(|asked| (asked.id, input.clone())));
    }
    if let Some(site) = case.site.api650.filter(|_| work.codes.api) {
        let e = site.joint_efficiency;
        let allowed = (case.tank.courses.iter()).map(|course| hoop_check::allowable(&course.material, e));
        match allowed.collect::<Result<Vec<f64>, String>>() {
            Ok(_) => all.push(api_hoop(case, e)),
            Err(input) => missing.push((API_HOOP, input)),
        }
        match (carbon_steel(case), without) {
            (false, _) => {}
            (true, Some(input)) => missing.push((API_COMPRESSION, input)),
            (true, None) => all.push(api_compression(case, radius, work.ready)),
        }
    }
    for (id, input) in missing {
        let reason = format!("`{input}` is missing");
        work.without(id, CheckStatus::NotChecked, &reason, Some(&input));
    }
    all
}

/// The search at a place up to the surface at rest: the hoop stress of the codes is that of a pressure. The rim above it is judged by the
/// equivalent stress.
fn wetted<'s, 'p>(case: &Case, at: &'s Search<'p>) -> Option<&'s Search<'p>> {
    (at.height() <= case.liquid.fill_height * (1.0 + 1e-9)).then_some(at)
}

/// f_y, which [`asked`] has seen to be given [Pa].
fn strength(course: &Course) -> f64 {
    course.material.yield_strength.unwrap_or_default()
}

/// Quality of construction of A.10.
fn quality(case: &Case) -> f64 {
    case.site.ec8.map_or(NORMAL, |site| site.construction_quality)
}

/// Limit states of the Eurocodes; those of EN 1993-1-6 alone where another code is named.
fn eurocode<'a>(case: &'a Case, codes: Codes, radius: f64, ready: &'a Ready<'a>) -> Vec<Asked<'a>> {
    let quality = quality(case);
    let mut all: Vec<Asked<'a>> = vec![
        Asked {
            id: EQUIVALENT,
            name: "Equivalent membrane stress of the wall",
            clause: format!("{EN_1993} 6.2.1"),
            of: &[Quantity::HoopStress, Quantity::AxialMembraneStress],
            find: Box::new(|at, course, above| at.equivalent(strength(course), above)),
        },
        Asked {
            id: BENDING,
            name: "Range of the equivalent stress with bending at the base",
            clause: format!("{EN_1993} 7.4"),
            of: &[Quantity::BendingStress],
            find: Box::new(|at, course, _| at.range_at_base(2.0 * strength(course))),
        },
    ];
    if !codes.ec8 {
        return all;
    }
    let clause = |number: &str| Edition::En2006.clause(number);
    all.push(Asked {
        id: HOOP,
        name: "Hoop stress below yield",
        clause: clause("10.3"),
        of: &[Quantity::HoopStress],
        find: Box::new(|at, course, above| wetted(case, at)?.hoop_tension(strength(course), above)),
    });
    all.push(Asked {
        id: ELASTIC,
        name: "Elastic buckling of the wall",
        clause: clause("10.2"),
        of: &[Quantity::AxialMembraneStress],
        find: Box::new(move |at, c, above| {
            let (modulus, s) = (c.material.youngs_modulus, c.net_thickness());
            let capacity = |p: f64| elastic(modulus, strength(c), s, radius, p, quality).limit;
            compression((ELASTIC, ready), at, &capacity, above)
        }),
    });
    all.push(Asked {
        id: COLLAPSE,
        name: "Elastic-plastic collapse of the wall",
        clause: clause("10.3"),
        of: &[Quantity::AxialMembraneStress],
        find: Box::new(move |at, c, above| {
            let (modulus, s) = (c.material.youngs_modulus, c.net_thickness());
            let capacity = |p: f64| elastic_plastic(modulus, strength(c), s, radius, p.max(0.0));
            compression((COLLAPSE, ready), at, &capacity, above)
        }),
    });
    all
}

/// Compression at a place against the capacity of its course in a limit state, which depends on the pressure alone [Pa].
fn compression(
    (id, ready): (&'static str, &Ready<'_>),
    at: &Search<'_>,
    capacity: &dyn Fn(f64) -> f64,
    above: f64,
) -> Option<Found> {
    let floors = ready.shelf.floors((id, at.course()), at.pressures(), capacity);
    let capacity = Capacity {
        of: capacity,
        floors: &floors,
    };
    at.compression(capacity, above)
}

/// Hoop stress of API 650, whose strengths [`asked`] has seen to be given.
fn api_hoop<'a>(case: &'a Case, efficiency: f64) -> Asked<'a> {
    Asked {
        id: API_HOOP,
        name: "Hoop stress of the shell",
        clause: format!("{API} E.6.2.4"),
        of: &[Quantity::HoopStress],
        find: Box::new(move |at, course, above| {
            let allowable = hoop_check::allowable(&course.material, efficiency).unwrap_or_default();
            wetted(case, at)?.hoop_tension(allowable, above)
        }),
    }
}

/// Compression of API 650.
fn api_compression<'a>(case: &'a Case, radius: f64, ready: &'a Ready<'a>) -> Asked<'a> {
    Asked {
        id: API_COMPRESSION,
        name: "Compression of the shell",
        clause: format!("{API} E.6.2.2.3"),
        of: &[Quantity::AxialMembraneStress],
        find: Box::new(move |at, course, above| {
            let capacity = |p: f64| allowable_compression(case.liquid.density, case.gravity, radius, course, p);
            compression((API_COMPRESSION, ready), at, &capacity, above)
        }),
    }
}

/// Depth of liquid [m] that has the interior pressure, the H of the pressure parameter.
fn head(density: f64, gravity: f64, pressure: f64) -> f64 {
    pressure.max(0.0) / (density * gravity)
}

/// F_C at an interior pressure [Pa].
fn allowable_compression(density: f64, gravity: f64, radius: f64, course: &Course, pressure: f64) -> f64 {
    let depth = head(density, gravity, pressure);
    let (diameter, f_ty) = (2.0 * radius, course.material.yield_strength);
    hold_down::allowable_compression(course.net_thickness(), diameter, density / 1000.0, depth, f_ty).unwrap_or(0.0)
}

/// Lines of the governing place of a limit state.
fn lines_of(work: &mut Work<'_>, asked: &Asked<'_>, radius: f64, at: &Worst) {
    let (id, clause) = (asked.id, asked.clause.as_str());
    let (found, pressure, case) = (&at.found, at.pressure, work.case);
    let course = &case.tank.courses[at.course];
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
    let f_y = strength(course);
    let wall = Wall {
        youngs_modulus: course.material.youngs_modulus,
        yield_strength: f_y,
        thickness: course.net_thickness(),
        radius,
        quality: quality(case),
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
        API_COMPRESSION => api_lines(work, clause, radius, (course, pressure)),
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

/// Lines of the allowable compression of API 650 at an interior pressure [Pa].
fn api_lines(work: &mut Work<'_>, clause: &str, radius: f64, (course, pressure): (&Course, f64)) {
    let liquid = work.case.liquid;
    let depth = head(liquid.density, work.case.gravity, pressure);
    let source = format!("{} of interior pressure there and then", with_unit(pressure, Stress));
    let sheet = &mut work.sheet;
    sheet.look_up("H", "depth with that pressure", &source, depth, Length, clause);
    let terms = [
        ("t_s", course.net_thickness(), Length),
        ("D", 2.0 * radius, Length),
        ("G", liquid.density / 1000.0, Dimensionless),
        ("H", depth, Length),
        ("F_ty", strength(course), Stress),
    ];
    let (symbol, name) = (
        "G·H·D²/t_s²",
        "pressure parameter of the shell, D and H in m, t_s in mm",
    );
    let ratio = sheet.calc(symbol, name, hold_down::SLENDERNESS, &terms, Dimensionless, clause);
    if let Some(formula) = hold_down::allowable(ratio, true, false) {
        let name = "allowable shell compression";
        sheet.calc("F_C", name, formula, &terms, Stress, clause);
    }
}
