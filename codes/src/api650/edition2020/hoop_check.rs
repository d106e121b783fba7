//! Hoop stresses over the height and their checks (E.6.1.4, E.6.2.4).
//!
//! Where a design pressure P is given, its hoop force N_P = P D/2 is added for a check of its own, also above the liquid. The
//! combination asks for F_p P, the operating pressure, which is at least 0.4 P; the whole P is on the safe side.

use crate::sheet::with_unit;
use tank::Material;
use tank::assessment::{CourseHoop, Profile, TOTAL_HOOP};
use tank::case::Combination;
use tank::ingredients::Vertical;
use tank::units::Dimension::{Length, LineForce, Stress};

use super::super::hoop::{HoopForces, hoop_forces};
use super::accelerations::Accelerations;
use super::{Run, limit_states};

const E6_1_4: &str = "API 650:2020 E.6.1.4";
const E6_2_4: &str = "API 650:2020 E.6.2.4";
/// Hoop force of the design pressure [N/m].
const N_P: &str = "P·D/2";

/// Hoop state of one height.
#[derive(Clone, Copy, Debug)]
struct Station {
    /// Height above the bottom [m].
    z: f64,
    /// Thickness of the course there [m].
    t: f64,
    /// Number of the course, from 0.
    course: usize,
    /// Hoop forces.
    n: HoopForces,
}

impl Station {
    fn dynamic(&self) -> f64 {
        self.n.dynamic() / self.t
    }

    fn total(&self) -> f64 {
        (self.n.hydrostatic + self.n.dynamic()) / self.t
    }

    /// The largest hoop stress with a hoop force of the design pressure [N/m].
    fn with_pressure(&self, n_p: f64) -> f64 {
        (self.n.hydrostatic + n_p + self.n.dynamic()) / self.t
    }
}

/// The parts of the largest seismic hoop stress.
pub(super) struct Largest {
    /// Impulsive stress per acceleration in g [Pa].
    pub impulsive: f64,
    /// Convective stress per acceleration in g [Pa].
    pub convective: f64,
    /// Heights [m] with both of them there.
    pub along: Vec<(f64, f64, f64)>,
    /// Stress of the vertical acceleration.
    pub vertical: Option<Vertical>,
}

/// The station where a stress is largest, the lowest of equal ones.
fn largest<'a>(stations: &'a [Station], f: &dyn Fn(&Station) -> f64) -> &'a Station {
    let first = &stations[0];
    stations.iter().fold(first, |best, s| if f(s) > f(best) { s } else { best })
}

/// Hoop forces and stresses of the courses below the surface, each where its stress is largest.
fn courses(stations: &[Station], allowed: Option<&[f64]>) -> Vec<CourseHoop> {
    let mut courses: Vec<CourseHoop> = Vec::new();
    for s in stations {
        let found = CourseHoop {
            course: s.course + 1,
            z: s.z,
            thickness: s.t,
            hydrostatic: Some(s.n.hydrostatic),
            impulsive: Some(s.n.impulsive),
            convective: Some(s.n.convective),
            vertical: Some(s.n.vertical),
            stress: s.total(),
            limit: allowed.and_then(|allowed| allowed.get(s.course).copied()),
        };
        match courses.last_mut().filter(|last| last.course == found.course) {
            Some(last) if last.stress >= found.stress => {}
            Some(last) => *last = found,
            None => courses.push(found),
        }
    }
    courses
}

/// The stress that lines show.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Part {
    /// The earthquake's.
    Seismic,
    /// With the hydrostatic part.
    Total,
    /// With the design pressure.
    Pressure,
}

/// Allowable hoop stress with the earthquake [Pa], the lesser of 1.33 S_d e and 0.9 F_y e.
///
/// * `efficiency`: e of the joints
///
/// Errors: the path of the missing strength.
pub(crate) fn allowable(material: &Material, efficiency: f64) -> Result<f64, String> {
    match (material.allowable_stress, material.yield_strength) {
        (Some(s_d), Some(f_y)) => Ok((1.33 * s_d * efficiency).min(0.9 * f_y * efficiency)),
        (None, Some(_)) => Err(format!("materials.{}.allowable_stress", material.name)),
        (_, None) => Err(format!("materials.{}.yield_strength", material.name)),
    }
}

impl Run<'_> {
    /// Profiles, lines and check; returns the largest seismic hoop stress over the height [Pa].
    pub(super) fn hoop(&mut self, a: &Accelerations) -> f64 {
        let stations = self.stations(a);
        self.hoop_profiles(&stations);
        // Never empty: the heights hold the bottom and the surface.
        let largest = |f: &dyn Fn(&Station) -> f64| *largest(&stations, f);
        let seismic = largest(&Station::dynamic);
        let allowable = self.allowable_hoop();
        let governing = match &allowable {
            Ok(allowed) => largest(&|s: &Station| s.total() / allowed[s.course]),
            Err(_) => largest(&Station::total),
        };
        self.out.courses = courses(&stations, allowable.as_deref().ok());
        self.sheet.section("Hoop stress: largest seismic part");
        let dynamic = self.hoop_lines(&seismic, a, "σ_s", "largest seismic hoop stress", Part::Seismic);
        self.sheet.section("Hoop stress: hydrostatic and seismic");
        let total = self.hoop_lines(&governing, a, "σ_T", "largest hoop stress, hydrostatic and seismic", Part::Total);
        if self.pressure() > 0.0 {
            self.pressure_hoop(&stations, allowable.as_deref(), a);
        }
        match allowable {
            Ok(allowed) => {
                let note = format!(
                    "Course {} from the bottom, {} above the bottom.",
                    governing.course + 1,
                    with_unit(governing.z, Length)
                );
                let capacity = allowed[governing.course];
                let name = "Hoop stress, hydrostatic and seismic";
                self.check(limit_states::HOOP.id, name, total, capacity, Stress, E6_2_4, &note);
            }
            Err(input) => self.missing(limit_states::HOOP.id, &input),
        }
        dynamic
    }

    /// What the largest seismic hoop stress is made of.
    pub(super) fn largest_hoop(&self, a: &Accelerations) -> Largest {
        let b = &self.basis;
        let stations = self.stations(a);
        let at = largest(&stations, &Station::dynamic);
        let unit = |at: &Station| hoop_forces(b.h - at.z, b.d, b.h, b.g, 1.0, 1.0, a.a_v);
        let per = |at: &Station| {
            let unit = unit(at);
            (at.z, unit.impulsive / at.t, unit.convective / at.t)
        };
        let ((_, impulsive, convective), unit) = (per(at), unit(at));
        Largest {
            impulsive,
            convective,
            along: stations.iter().map(per).collect(),
            vertical: (a.a_v > 0.0).then(|| Vertical {
                horizontal: 1.0,
                value: unit.vertical / at.t,
                combination: Combination::Srss,
            }),
        }
    }

    /// Hoop stress with the whole design pressure, over the whole wall.
    fn pressure_hoop(&mut self, stations: &[Station], allowable: Result<&[f64], &String>, a: &Accelerations) {
        let b = self.basis;
        let n_p = self.pressure() * b.d / 2.0;
        let mut stations = stations.to_vec();
        let mut z = 0.0;
        for (course, plate) in b.case.tank.courses.iter().enumerate() {
            if z > b.h {
                let (t, n) = (plate.net_thickness(), HoopForces::default());
                stations.push(Station { z, t, course, n });
            }
            z += plate.height;
        }
        let allowed = match allowable {
            Ok(allowed) => allowed,
            Err(input) => return self.missing(limit_states::PRESSURE.id, input),
        };
        let used = |s: &Station| s.with_pressure(n_p) / allowed[s.course];
        let governing = stations.iter().fold(stations[0], |best, s| if used(s) > used(&best) { *s } else { best });
        self.sheet.section("Hoop stress: with the design pressure");
        let name = "largest hoop stress with the design pressure";
        let stress = self.hoop_lines(&governing, a, "σ_TP", name, Part::Pressure);
        let note = format!(
            "Course {} from the bottom, {} above the bottom; the whole design pressure (F_p = 1).",
            governing.course + 1,
            with_unit(governing.z, Length)
        );
        let name = "Hoop stress with the design pressure";
        let capacity = allowed[governing.course];
        self.check(limit_states::PRESSURE.id, name, stress, capacity, Stress, E6_2_4, &note);
    }

    fn stations(&self, a: &Accelerations) -> Vec<Station> {
        let b = &self.basis;
        let courses = &b.case.tank.courses;
        b.case
            .tank
            .profile_heights(b.h)
            .into_iter()
            .map(|z| {
                let mut top = 0.0;
                let course = courses.iter().position(|c| {
                    top += c.height;
                    z < top
                });
                let course = course.unwrap_or(courses.len() - 1);
                Station {
                    z,
                    t: courses[course].net_thickness(),
                    course,
                    n: hoop_forces(b.h - z, b.d, b.h, b.g, a.a_i, a.a_c, a.a_v),
                }
            })
            .collect()
    }

    fn hoop_profiles(&mut self, stations: &[Station]) {
        let d = self.basis.d;
        let z: Vec<f64> = stations.iter().map(|s| s.z).collect();
        let mut add = |id: &str, title: &str, f: &dyn Fn(&Station) -> f64| {
            self.out.profiles.push(Profile {
                id: id.into(),
                title: title.into(),
                dimension: Stress,
                z: z.clone(),
                values: stations.iter().map(f).collect(),
            });
        };
        // The annex gives forces N = p D/2.
        add("pressure_impulsive", "Impulsive pressure", &|s| 2.0 * s.n.impulsive / d);
        add("pressure_convective", "Convective pressure", &|s| 2.0 * s.n.convective / d);
        add("pressure_dynamic", "Seismic pressure", &|s| 2.0 * s.n.dynamic() / d);
        add("hoop_stress", "Hoop stress (membrane)", &Station::dynamic);
        add(TOTAL_HOOP, "Hoop stress, static and seismic", &Station::total);
    }

    /// Allowable hoop stress of each course [Pa], or the missing data in words.
    fn allowable_hoop(&self) -> Result<Vec<f64>, String> {
        let Some(site) = self.site else { return Err("site.api650.joint_efficiency".into()) };
        let e = site.joint_efficiency;
        self.basis.case.tank.courses.iter().map(|c| allowable(&c.material, e)).collect()
    }

    /// Lines at one station; returns the seismic or the total stress [Pa].
    fn hoop_lines(&mut self, s: &Station, a: &Accelerations, symbol: &str, name: &str, part: Part) -> f64 {
        if s.z > self.basis.h {
            return self.dry_lines(s, symbol, name);
        }
        let pressure = self.pressure();
        let b = self.basis;
        let (d, h, y) = (b.d, b.h, b.h - s.z);
        let n_i = if b.squat() {
            "8480·A_i·G·D·H·(Y/H - 0.5·(Y/H)²)·tanh(0.866·D/H)"
        } else if y < 0.75 * d {
            "5220·A_i·G·D²·(Y/(0.75·D) - 0.5·(Y/(0.75·D))²)"
        } else {
            "2600·A_i·G·D²"
        };
        let n_c = if 3.68 * h / d < 300.0 {
            "1850·A_c·G·D²·cosh(3.68·(H - Y)/D)/cosh(3.68·H/D)"
        } else {
            // The same to the last digit; cosh(3.68 H/D) overflows.
            "1850·A_c·G·D²·exp(-3.68·Y/D)·(1 + exp(-7.36·(H - Y)/D))"
        };
        let formula = match (part, a.a_v > 0.0) {
            (Part::Total, true) => "(N_h + √(N_i² + N_c² + (A_v·N_h/2.5)²))/t",
            (Part::Total, false) => "(N_h + √(N_i² + N_c²))/t",
            (Part::Seismic, true) => "√(N_i² + N_c² + (A_v·N_h/2.5)²)/t",
            (Part::Seismic, false) => "√(N_i² + N_c²)/t",
            (Part::Pressure, true) => "(N_h + N_P + √(N_i² + N_c² + (A_v·N_h/2.5)²))/t",
            (Part::Pressure, false) => "(N_h + N_P + √(N_i² + N_c²))/t",
        };
        let sheet = &mut self.sheet;
        let depth = format!("depth below the surface of the {name}");
        sheet.input("Y", &depth, y, Length, E6_1_4);
        sheet.input("t", "thickness there", s.t, Length, "tank.courses");
        sheet.given(&[("P", pressure, Stress)]);
        let mut force = |symbol: &'static str, name: &str, formula: &str| {
            sheet.calc(symbol, name, formula, LineForce, E6_1_4);
        };
        if part == Part::Pressure {
            force("N_P", "hoop force of the design pressure", N_P);
        }
        if part != Part::Seismic || a.a_v > 0.0 {
            force("N_h", "hydrostatic hoop force", "4900·G·Y·D");
        }
        force("N_i", "impulsive hoop force", n_i);
        force("N_c", "convective hoop force", n_c);
        sheet.calc(symbol, name, formula, Stress, E6_1_4)
    }

    /// Lines above the liquid, where only the design pressure acts.
    fn dry_lines(&mut self, s: &Station, symbol: &str, name: &str) -> f64 {
        let pressure = self.pressure();
        let sheet = &mut self.sheet;
        sheet.input("t", "thickness there, above the liquid", s.t, Length, "tank.courses");
        sheet.given(&[("P", pressure, Stress)]);
        let force = "hoop force of the design pressure";
        sheet.calc("N_P", force, N_P, LineForce, E6_1_4);
        sheet.calc(symbol, name, "N_P/t", Stress, E6_1_4)
    }
}
