//! Stresses of a metal shell against yield and buckling, course by course.

use tank::Course;
use tank::assessment::CourseHoop;
use tank::case::Case;
use tank::quantity::Quantity;
use tank::units::Dimension::Stress;

use super::limit_states::{BENDING, EQUIVALENT};
use super::ready::Ready;
use super::search::{Capacity, Found, Search};
use super::work::Work;
use crate::base_state::leave_open;
use crate::code::{WallLimit, WallStress, without_strength};
use crate::sheet::{Sheet, without_lines};

impl WallStress {
    /// Quantities whose mesh errors it has.
    fn quantities(self) -> &'static [Quantity] {
        match self {
            WallStress::Equivalent => &[Quantity::HoopStress, Quantity::AxialMembraneStress],
            WallStress::RangeAtBase => &[Quantity::BendingStress],
            WallStress::Hoop => &[Quantity::HoopStress],
            WallStress::Compression => &[Quantity::AxialMembraneStress],
        }
    }

    /// Symbol and name of its line.
    fn words(self) -> (&'static str, &'static str) {
        match self {
            WallStress::Equivalent => ("σ_v", "largest equivalent membrane stress, √(σ_θ² + σ_z² - σ_θ σ_z + 3 τ²)"),
            WallStress::RangeAtBase => ("Δσ_v", "range of the equivalent stress of a face"),
            WallStress::Hoop => ("σ_θ", "largest hoop membrane stress, static and seismic"),
            WallStress::Compression => ("σ_m", "axial membrane compression, static and seismic"),
        }
    }
}

/// What a limit finds at a place of a course above a utilisation.
fn find(work: &Work<'_>, limit: &WallLimit<'_>, at: &Search<'_>, course: &Course, above: f64) -> Option<Found> {
    let capacity = |p: f64| without_lines(|| (limit.limit)(&mut Sheet::new(), course, p));
    match limit.stress {
        WallStress::Equivalent => at.equivalent(capacity(0.0), above),
        WallStress::RangeAtBase => at.range_at_base(capacity(0.0)),
        WallStress::Hoop => wetted(work.case, at)?.hoop_tension(capacity(0.0), above),
        WallStress::Compression => compression((limit.state.id, work.ready), at, &capacity, above),
    }
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

/// Why no compression holds above a foot that warps.
const WARPS: &str = "strips leave out the inertia of the liquid that ovals with a wall whose rim is not round: in six histories under free rims shells had 1.2 to 1.6 times the stress at the toe; the nonlinear engine (`--fe nonlinear`) has shells";

/// Adds the checks of all limit states of a metal shell.
pub(super) fn assess(work: &mut Work<'_>, radius: f64) {
    let all = limits(work, radius);
    let worst = worst(work, &all);
    for (asked, courses) in all.iter().zip(worst) {
        let found: Vec<Worst> = courses.into_iter().flatten().collect();
        check(work, asked, &found);
        match asked.stress {
            WallStress::Hoop => keep(work, &found),
            WallStress::Compression if work.demands.base.as_ref().is_some_and(|base| base.warps) => {
                leave_open(&mut work.checks, &[asked.state.id], WARPS);
            }
            _ => {}
        }
    }
}

/// The worst place of each course for each limit state: the first of those with the largest utilisation.
///
/// Where the same demands were searched under another factor, what is found now near the place and the instant that governed then passes over
/// most others.
fn worst(work: &Work<'_>, all: &[WallLimit<'_>]) -> Vec<Vec<Option<Worst>>> {
    let courses = &work.case.tank.courses;
    let mut worst: Vec<Vec<Option<Worst>>> = vec![vec![None; courses.len()]; all.len()];
    let mut governing = work.ready.governing.borrow_mut();
    // A utilisation that the worst place of each limit state and course reaches.
    let reached: Vec<Vec<f64>> = { all.iter() }
        .map(|asked| {
            let of = |number: usize| {
                let found = governing.get(&(asked.state.id, number)).and_then(|&(place, instant)| {
                    let near = work.search(work.ready.wall.get(place)?).near(instant);
                    find(work, asked, &near, &courses[number], f64::NEG_INFINITY)
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
            let found = find(work, asked, &search, course, above).filter(|found| found.utilisation > above);
            if let Some(found) = found {
                governing.insert((asked.state.id, number), (of_place, found.instant));
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

/// Keeps the hoop stresses of the courses, of several limits that which is used most.
fn keep(work: &mut Work<'_>, found: &[Worst]) {
    for worst in found {
        let Found { demand, capacity, rest, .. } = worst.found;
        let thickness = work.case.tank.courses[worst.course].net_thickness();
        let of_course = CourseHoop {
            course: worst.course + 1,
            z: worst.z,
            thickness,
            hydrostatic: Some(rest * thickness),
            impulsive: None,
            convective: None,
            vertical: None,
            stress: demand,
            limit: Some(capacity),
        };
        match work.courses.iter_mut().find(|known| known.course == of_course.course) {
            Some(known) if known.utilisation() >= of_course.utilisation() => {}
            Some(known) => *known = of_course,
            None => work.courses.push(of_course),
        }
    }
}

/// The check of the governing course with its lines; the others stand in its note.
fn check(work: &mut Work<'_>, asked: &WallLimit<'_>, found: &[Worst]) {
    let larger = |best: Worst, next: &Worst| if next.found.utilisation > best.found.utilisation { *next } else { best };
    let Some(first) = found.first() else { return };
    let governing = found.iter().fold(*first, larger);
    let moment = work.moment(&governing.found, governing.z);
    let number_of = |worst: &Worst| worst.course + 1;
    let title = format!("{}: course {}, {}", asked.state.name, number_of(&governing), moment.words());
    work.sheet.section(&title);
    let Found { demand, capacity, .. } = governing.found;
    let (symbol, name) = asked.stress.words();
    work.sheet.input(symbol, name, demand, Stress, "the run of the engine");
    let course = &work.case.tank.courses[governing.course];
    (asked.limit)(&mut work.sheet, course, governing.pressure);
    let others: Vec<String> = (found.iter())
        .filter(|other| other.course != governing.course)
        .map(|other| format!("course {}: {:.2}", number_of(other), other.found.utilisation))
        .collect();
    let mut note = format!("course {}", number_of(&governing));
    if !others.is_empty() {
        note.push_str(&format!("; utilisation of the others: {}", others.join(", ")));
    }
    let error = work.error(asked.stress.quantities(), &governing.found);
    let check = asked.state.check().of(demand, capacity, asked.state.clause, &note);
    let check = check.at(Some(moment.time), Some(governing.z), Some(moment.theta));
    work.checks.push(check.with_error(error));
}

/// The limits of the wall; the limit states of those that lack an input are not checked.
fn limits<'a>(work: &mut Work<'a>, radius: f64) -> Vec<WallLimit<'a>> {
    let case = work.case;
    let of_codes = work.codes.iter().flat_map(|code| code.wall(case, radius));
    let all = shell(case).into_iter().chain(of_codes);
    let (known, unknown): (Vec<_>, Vec<_>) = all.partition(|limit| limit.missing.is_none());
    for limit in unknown {
        let input = limit.missing.unwrap_or_default();
        work.missing(limit.state.id, &input);
    }
    known
}

/// Limits of EN 1993-1-6, whichever code counts.
fn shell(case: &Case) -> [WallLimit<'_>; 2] {
    let strength = |course: &Course| course.material.yield_strength.unwrap_or_default();
    let missing = without_strength(case);
    [
        WallLimit {
            state: EQUIVALENT,
            stress: WallStress::Equivalent,
            missing: missing.clone(),
            limit: Box::new(move |sheet, course, _| {
                sheet.input("f_y", "yield strength", strength(course), Stress, "materials")
            }),
        },
        WallLimit {
            state: BENDING.named("Range of the equivalent stress with bending at the base"),
            stress: WallStress::RangeAtBase,
            missing,
            limit: Box::new(move |sheet, course, _| {
                sheet.given(&[("f_y", strength(course), Stress)]);
                let name = "limit of the range, beyond which the wall yields in every cycle";
                sheet.calc("Δσ_Rd", name, "2·f_y", Stress, BENDING.clause)
            }),
        },
    ]
}

/// The search at a place up to the surface at rest: the hoop stress of the codes is that of a pressure. The rim above it is judged by the
/// equivalent stress.
fn wetted<'s, 'p>(case: &Case, at: &'s Search<'p>) -> Option<&'s Search<'p>> {
    (at.height() <= case.liquid.fill_height * (1.0 + 1e-9)).then_some(at)
}

/// Compression at a place against the capacity of its course in a limit state, which depends on the pressure alone [Pa].
fn compression(
    (id, ready): (&'static str, &Ready<'_>),
    at: &Search<'_>,
    capacity: &dyn Fn(f64) -> f64,
    above: f64,
) -> Option<Found> {
    let floors = ready.shelf.floors((id, at.course()), at.pressures(), capacity);
    let capacity = Capacity { of: capacity, floors: &floors };
    at.compression(capacity, above)
}
