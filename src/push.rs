//! The whole flow of a pushover: job → shells → `push.json`, report.

use fem::progress::Progress;

use crate::error::Error;
use crate::job::PushJob;
use codes::api650::hold_down::allowable_compression;
use codes::ec8::{buckling, plate_uplift};
use engines::nonlinear::push::{Formula, pushover};
use files::code::{Code, Warning};
use files::{Kind, OutputFolder, kept_complete};
use report::{self, FIGURES_FOLDER, REPORT_FILE};
use results::{PUSH_FILE, PUSH_FORMAT, Push, PushJoint, Volatile, finite, read_push, write_push};
use tank::{Case, Course, Shape};

/// Density of water in the specific gravity of API 650 [kg/m³].
const WATER: f64 = 1000.0;

/// Results of a pushover.
const PUSH: Kind = Kind {
    id: "push",
    option: "--out",
    names: |name| [PUSH_FILE, REPORT_FILE, FIGURES_FOLDER].contains(&name),
    keeps: |_| false,
};

/// Runs a job; `volatile` stamps the results. Errors: a tank or option that a pushover does not support; a folder
/// with other contents or that cannot be written; a wall that does not carry its liquid at rest. Failure under the
/// pushover load is a result, not an error.
pub fn run(job: &PushJob, volatile: impl Fn() -> Volatile, progress: &dyn Progress) -> Result<Push, Error> {
    // Faults of the folder are reported before anything is computed.
    let folder = OutputFolder::prepare_alone(&job.out, PUSH)?;
    let case = &job.job.case;
    let pushed = pushover(case, &job.job.nonlinear, &job.options, &formulas(case), job.checkpoint.as_ref(), progress)?;
    let joint = pushed.shells.first();
    let joint = joint.and_then(|shell| PushJoint::of(shell, plate_uplift::ROTATION, "EN 1998-4:2006, A.9"));
    let push = Push {
        format: PUSH_FORMAT.into(),
        volatile: volatile(),
        name: case.name.clone(),
        project: job.job.project.clone(),
        tank: Some(job.job.tank()),
        gravity: case.gravity,
        files: job.job.files.clone(),
        model: pushed.model,
        assumptions: pushed.assumptions,
        shells: pushed.shells,
        limits: pushed.limits,
        joint,
        incomplete: !pushed.interruption.is_empty(),
        doubts: [job.job.warnings.clone(), doubts(pushed.doubts)].concat(),
        interruption: pushed.interruption,
    };
    finite::check("pushover", &push)?;
    let earlier = read_push(&job.out.join(PUSH_FILE));
    if push.incomplete && earlier.is_ok_and(|earlier| !earlier.incomplete) {
        progress.warn(&kept_complete(&job.out));
        return Ok(push);
    }
    write_push(&folder.path().join(PUSH_FILE), &push)?;
    report::push::report(&push)?.write(&folder.path())?;
    folder.commit()?;
    if let Some(file) = job.checkpoint.as_ref().filter(|_| !push.incomplete) {
        file.remove();
    }
    Ok(push)
}

/// Limits of the codes for the compression of the wall. Those that need a yield strength appear if every course has
/// one.
fn formulas(case: &Case) -> Vec<Formula<'_>> {
    let Shape::Cylinder { radius } = case.tank.shape else { return Vec::new() };
    let young = |course: &Course| course.material.youngs_modulus;
    let strength = |course: &Course| course.material.yield_strength.unwrap_or(f64::INFINITY);
    let quality = case.site.ec8.map_or(1.0, |s| s.construction_quality);
    let mut out = vec![Formula {
        name: "0.605 E t/R, perfect elastic".into(),
        source: "Timoshenko & Gere 1961".into(),
        bottom_course: false,
        impulsive: 0.0,
        capacity: Box::new(move |course, _| 0.605 * young(course) * course.thickness / radius),
    }];
    if case.tank.courses.iter().all(|c| c.material.yield_strength.is_some()) {
        out.push(Formula {
            name: format!("elastic buckling, quality {quality}"),
            source: "EN 1998-4:2006, A.10.2".into(),
            bottom_course: false,
            impulsive: -1.0,
            capacity: Box::new(move |course, p| {
                buckling::elastic(young(course), strength(course), course.thickness, radius, p, quality)
            }),
        });
        out.push(Formula {
            name: "elastic-plastic collapse".into(),
            source: "EN 1998-4:2006, A.10.3".into(),
            bottom_course: false,
            impulsive: 1.0,
            capacity: Box::new(move |course, p| {
                buckling::elastic_plastic(young(course), strength(course), course.thickness, radius, p)
            }),
        });
    }
    let specific = case.liquid.density / WATER;
    let api = move |course: &Course| {
        allowable_compression(
            course.thickness,
            2.0 * radius,
            specific,
            case.liquid.fill_height,
            course.material.yield_strength,
        )
    };
    if case.tank.courses.first().and_then(api).is_some() {
        out.push(Formula {
            name: "allowable compression F_C".into(),
            source: "API 650, E.6.2.2.3".into(),
            bottom_course: true,
            impulsive: 0.0,
            capacity: Box::new(move |course, _| api(course).unwrap_or(f64::INFINITY)),
        });
    }
    out
}

/// What of the model may not hold for this tank, as warnings.
fn doubts(found: Vec<String>) -> Vec<Warning> {
    let warning = |text| Warning::new(Code::PushAssumption, text);
    found.into_iter().map(warning).collect()
}
