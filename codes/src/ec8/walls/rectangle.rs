//! Forces in the walls of a box or of a strip.

use super::checks;
use super::place::{Factors, Horizontal, Place, Situation, cases, course_index};
use crate::ec8::wall_bending::{Forces, Plan, State as Bent, Wall};
use crate::ec8::work::Work;
use tank::{BarDirection, Course};

/// A box as its sheet knows it.
pub(in crate::ec8) struct BoxTank<'f> {
    /// Inner length in the direction of shaking and breadth [m].
    pub plan: (f64, f64),
    /// Whether it is a strip of a long tank.
    pub strip: bool,
    /// Acceleration of the impulsive part [m/s²].
    pub impulsive: f64,
    /// Impulsive and convective pressure [Pa] at a height [m].
    pub pressures: &'f dyn Fn(f64) -> (f64, f64),
    /// Moment [N·m] and shear [N] of the tank's cross-section at a height [m].
    pub section: &'f dyn Fn(f64) -> (f64, f64),
}

/// Position of sections across a wall, ξ = x/B.
const ACROSS: [(f64, &str); 5] =
    [(0.0, "middle"), (0.25, "quarter"), (0.5, "half way to the corner"), (0.75, "near the corner"), (1.0, "corner")];
/// Share of the height above which the reaction of a side is concentrated at the free corner; it is taken as the one here.
const FREE_CORNER: f64 = 0.9;

/// States of one wall under the loads.
struct Loaded<'a> {
    still: Bent<'a>,
    vertical: Bent<'a>,
    seismic: Bent<'a>,
    damage: Bent<'a>,
}

impl Loaded<'_> {
    /// A linear quantity under each load.
    fn each<T>(&self, of: impl Fn(&Bent) -> T) -> Each<T> {
        Each {
            still: of(&self.still),
            vertical: of(&self.vertical),
            seismic: of(&self.seismic),
            damage: of(&self.damage),
        }
    }
}

/// Values of a quantity under each load.
struct Each<T> {
    still: T,
    vertical: T,
    seismic: T,
    damage: T,
}

impl<T> Each<T> {
    /// Its sum in one case.
    fn sum(&self, factors: &Factors, of: impl Fn(&T) -> f64) -> f64 {
        let side = match factors.situation {
            Situation::Damage => &self.damage,
            _ => &self.seismic,
        };
        of(&self.still) + factors.x * of(side) + factors.v * of(&self.vertical)
    }
}

/// What one wall carries at one height.
struct Level {
    name: &'static str,
    /// Forces of the sections across it.
    sections: Vec<(f64, &'static str, Each<Forces>)>,
    /// Clamping moment and shear of the middle, at the base.
    base: Option<Each<(f64, f64)>>,
    /// Reaction at its sides [N/m].
    reaction: Each<f64>,
}

impl Level {
    fn new(name: &'static str, loaded: &Loaded, (z, reaction): (f64, f64), strip: bool) -> Level {
        let across = if strip { &ACROSS[..1] } else { &ACROSS[..] };
        let sections = across.iter().map(|(xi, part)| (*xi, *part, loaded.each(|s| s.at(*xi, z))));
        Level {
            name,
            sections: sections.collect(),
            base: (z == 0.0).then(|| loaded.each(|s| s.base)),
            reaction: loaded.each(|s| s.at(1.0, reaction).v_x),
        }
    }
}

/// Writes the checks of the walls.
pub(in crate::ec8) fn assess(work: &mut Work, tank: &BoxTank) {
    let case = work.case;
    let (depth, courses) = (case.liquid.fill_height, case.tank.courses.as_slice());
    let weight = case.liquid.density * case.gravity;
    let q = work.demand.behaviour_factor;
    let ground = work.demand.vertical_ground() / case.gravity;
    let horizontal =
        Horizontal::new((depth, courses), case.procedures.ec8_combination, (tank.impulsive, q), tank.pressures);
    let (length, breadth) = tank.plan;
    let plans: Vec<(&'static str, Plan)> = match tank.strip {
        true => vec![("wall across the shaking", Plan::Strip)],
        false => [("wall across the shaking", breadth), ("wall along the shaking", length)]
            .map(|(name, width)| (name, Plan::Box { half_width: 0.5 * width }))
            .to_vec(),
    };
    let walls: Vec<Wall> = plans.iter().map(|(_, plan)| Wall::new(courses, *plan)).collect();
    let loaded: Vec<Loaded> = walls
        .iter()
        .map(|wall| Loaded {
            still: wall.under(|z| weight * (depth - z).max(0.0)),
            vertical: wall.under(|z| ground * weight * (depth - z).max(0.0)),
            seismic: wall.under(|z| horizontal.pressure(z, Situation::Seismic)),
            damage: wall.under(|z| horizontal.pressure(z, Situation::Damage)),
        })
        .collect();
    let reduction = work.demand.site.and_then(|site| site.reduction_factor);
    let vertical = work.demand.vertical;
    // The shear of the tank is in the reactions and in the walls along the shaking; a case aside has no meaning of its own.
    let cases: Vec<Factors> = cases(vertical, reduction).into_iter().filter(|f| !f.aside).collect();
    let mut places = Vec::new();
    let height = case.tank.wall_height();
    for z in heights(courses, height) {
        let index = course_index(courses, z);
        let reaction = z.min(FREE_CORNER * height);
        let levels: Vec<Level> = (plans.iter().zip(&loaded))
            .map(|((name, _), loaded)| Level::new(name, loaded, (z, reaction), tank.strip))
            .collect();
        let at = Place {
            course: &courses[index],
            index,
            wall: ("", ""),
            z,
            head: (depth - z).max(0.0),
            factors: cases[0],
            direction: BarDirection::Vertical,
            n: 0.0,
            m: 0.0,
            shear: None,
        };
        let own = case.tank.weight_above(z) * case.gravity / case.tank.perimeter();
        let section = (tank.section)(z);
        for factors in &cases {
            let axial = axial(tank, section, factors.x * horizontal.scale(factors.situation));
            let dead = own * (1.0 + factors.v * ground);
            for (w, level) in levels.iter().enumerate() {
                let axial = axial[w];
                // The wall that meets this one; a strip has none.
                let other = levels.get(1 - w).filter(|_| !tank.strip);
                let pull = other.map_or(0.0, |other| other.reaction.sum(factors, |v| *v));
                let n = (pull.max(0.0) + axial.1, axial.0 + axial.1 - dead);
                let at = Place { factors: *factors, ..at };
                sections(&mut places, &at, level, n, tank.strip);
            }
        }
    }
    notes(work, tank.strip);
    checks::assess(work, &places);
}

/// Forces of the sections across one wall at one height.
///
/// * `at`: place to be filled in; `n`: axial force along the wall and up the wall [N/m]
fn sections<'a>(places: &mut Vec<Place<'a>>, at: &Place<'a>, level: &Level, n: (f64, f64), strip: bool) {
    let factors = &at.factors;
    for (xi, part_of_wall, forces) in &level.sections {
        let part = |of: fn(&Forces) -> f64| forces.sum(factors, of);
        let base = level.base.as_ref().filter(|_| *xi == 0.0);
        let (m_x, m_xz) = (part(|f| f.m_x), part(|f| f.m_xz).abs());
        let m_z = base.map_or_else(|| part(|f| f.m_z), |base| base.sum(factors, |b| b.0));
        // Wood and Armer: the twisting moment adds to both directions.
        let twisted = |m: f64| m + m_xz.copysign(m);
        let place = Place { wall: (level.name, part_of_wall), ..*at };
        places.push(Place {
            direction: BarDirection::Vertical,
            n: n.1,
            m: twisted(m_z),
            shear: base.map(|base| base.sum(factors, |b| b.1).abs()),
            ..place
        });
        if !strip {
            let corner = *xi == 1.0;
            places.push(Place {
                direction: BarDirection::Hoop,
                n: n.0,
                m: twisted(m_x),
                shear: corner.then(|| level.reaction.sum(factors, |v| *v).abs()),
                ..place
            });
        }
    }
}

/// Axial force up the wall and membrane shear [N/m] of the tank's moment and shear: wall across, wall along the shaking.
///
/// Thin walls of one thickness: I/s = 2 b L² + 4 L³/3, largest shear flow 1.5 Q/(2 · 2 L). A wall along the shaking pulls at one end
/// whatever the sign.
///
/// * `(moment, shear)`: of the tank's cross-section [N·m, N]
fn axial(tank: &BoxTank, (moment, shear): (f64, f64), factor: f64) -> [(f64, f64); 2] {
    if tank.strip {
        return [(0.0, 0.0); 2];
    }
    let (length, breadth) = tank.plan;
    let half = 0.5 * length;
    let bending = moment * half / (2.0 * breadth * half * half + 4.0 * half.powi(3) / 3.0);
    let flow = 0.75 * shear / length;
    [(-factor * bending, 0.0), (factor.abs() * bending, factor.abs() * flow)]
}

/// Heights: 40 steps over the wall, and both sides of its joints.
fn heights(courses: &[Course], height: f64) -> Vec<f64> {
    let mut z: Vec<f64> = (0..=40).map(|i| height * f64::from(i) / 40.0).collect();
    let mut joint = 0.0;
    for course in courses.iter().take(courses.len() - 1) {
        joint += course.height;
        z.extend([joint - 1e-6 * height, joint]);
    }
    z.sort_by(f64::total_cmp);
    z.dedup_by(|b, a| (*b - *a).abs() < 1e-9 * height);
    z
}

fn notes(work: &mut Work, strip: bool) {
    work.out.notes.push(
        if strip {
            "Wall of a strip: cantilever in plane strain; the bars along the wall are not checked."
        } else {
            "Walls of the box: plates clamped at base and corners, free at the top. The walls along the shaking carry the pressure of \
             the walls across it over their whole length, an upper bound for this direction; shaking across the tank needs a run of its \
             own with length and breadth exchanged. The reaction of a wall at its sides pulls in the walls that meet it."
        }
        .into(),
    );
}
