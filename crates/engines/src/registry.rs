//! Registry of the engines.

use fem::progress::Progress;
use results::EngineId;
use tank::refusal::{Place, Refusal};
use tank::{PLANE_WALLS, Shape, Support};

use crate::engine::{Engine, Simulation, Task};
use crate::estimate::Estimate;
use crate::linear::turned::turns_no_base;
use crate::linear::{Extent, Pictures, simulate_to};
use crate::nonlinear::scope::{self, Purpose};
use crate::{FeError, harmonic, nonlinear, solid};

/// All engines, in the order of [`EngineId`].
pub const ALL: [&dyn Engine; 3] = [&Harmonic, &Solid, &Nonlinear];

/// The engine of an id.
pub fn engine(id: EngineId) -> &'static dyn Engine {
    ALL[id as usize]
}

/// A tank on a staging, of which no engine has a model: each holds the bottom to the ground.
pub(crate) fn elevated(task: &Task<'_>) -> Option<Refusal> {
    task.case.tank.staging?;
    let message = "not applicable: the tank stands on a staging; the finite-element engines model tanks on the ground";
    Some(
        Refusal::new(Place::Staging, message, "no tank.staging")
            .help("use `tankcheck check`, or `compare` without `--fe`, for the codes alone"),
    )
}

/// A box whose walls are plates, which the harmonic engine would take for cantilevers.
fn plates(task: &Task<'_>) -> Option<Refusal> {
    let tank = &task.case.tank;
    let ratio = tank.breadth_to_height().filter(|_| tank.bends_as_plates())?;
    let message =
        "the walls of this box bend as plates held at the base and both sides; the harmonic engine has cantilevers";
    let allowed = format!("a breadth of at least {PLANE_WALLS:.0} heights of the wall");
    let refusal = Refusal::new(Place::Shape, message, allowed).found(format!("{ratio:.2} heights"));
    Some(refusal.help("use --fe solid"))
}

/// A foot of the wall that turns or slides: the harmonic engine alone has one, on a base that does not move.
fn joint(task: &Task<'_>, engine: EngineId) -> Option<Refusal> {
    let tank = &task.case.tank;
    if tank.wall_base.is_fixed() {
        return None;
    }
    let ground = tank.foundation.and_then(|f| f.shear_wave_velocity).is_some();
    let moves = tank.support == Support::Unanchored || tank.isolators.is_some() || ground;
    let (message, help) = match engine {
        EngineId::Harmonic if !moves => return None,
        EngineId::Harmonic => (
            "a foot that turns or slides is computed on a base that does not move: of an anchored tank without isolators and soil",
            "use `tankcheck check` for the codes alone",
        ),
        _ => ("this engine clamps the foot of the wall", "use --fe harmonic"),
    };
    Some(Refusal::new(Place::WallBase, message, "\"kind\": \"fixed\"").help(help))
}

/// A base whose rotation is given, which the harmonic engine alone turns.
fn turning(task: &Task<'_>, engine: EngineId) -> Option<Refusal> {
    task.linear.rotation.as_ref()?;
    let (message, help) = match engine {
        EngineId::Harmonic => turns_no_base(task.case, task.linear)?,
        EngineId::Solid => ("the three-dimensional engine does not turn the base", "use --fe harmonic"),
        EngineId::Nonlinear => ("the nonlinear engine does not turn the base", "use --fe harmonic"),
    };
    Some(Refusal::new(Place::Rotation, message, "an anchored tank in the harmonic engine").help(help))
}

/// A rectangular tank has walls of its own along y, which only three dimensions have; a strip has none.
fn across_a_box(task: &Task<'_>, engine: EngineId) -> Option<Refusal> {
    let shaken = task.case.ground_motion.as_ref().is_some_and(|m| m.transverse.is_some());
    let (message, help) = match task.case.tank.shape {
        _ if !shaken => return None,
        Shape::Cylinder { .. } => return None,
        Shape::Rectangle { strip: true, .. } => {
            ("--quake-y: a strip has no walls across the other direction", "remove --quake-y")
        }
        Shape::Rectangle { .. } if engine == EngineId::Solid => return None,
        Shape::Rectangle { .. } => {
            ("--quake-y: this engine has no walls along y of a rectangular tank", "use --fe solid, or remove --quake-y")
        }
    };
    Some(Refusal::new(Place::Transverse, message, "a cylinder, or a box with --fe solid").help(help))
}

/// Note of an engine that computes the perfect tank beside imperfections.
const PERFECT: &str = "analysis.imperfections is not used here: harmonics of a shell of revolution are independent of each other, and \
    the engine computes the perfect cylinder; use --fe solid or --fe nonlinear for the imperfect one.";

/// The response along y is that along x turned by a quarter of the circle: of a perfect cylinder alone.
fn across_imperfections(task: &Task<'_>) -> Option<Refusal> {
    let shaken = task.case.ground_motion.as_ref().is_some_and(|m| m.transverse.is_some());
    (shaken && !task.solid.imperfections.is_empty()).then(|| {
        let message = "--quake-y: two horizontal components are for perfect cylinders";
        Refusal::new(Place::Transverse, message, "no analysis.imperfections")
            .help("remove --quake-y or analysis.imperfections")
    })
}

/// The march of isolators takes the motion along y for that along x turned by a quarter of the circle.
fn box_on_isolators(task: &Task<'_>) -> Option<Refusal> {
    let shaken = task.case.ground_motion.as_ref().is_some_and(|m| m.transverse.is_some());
    let boxed = matches!(task.case.tank.shape, Shape::Rectangle { .. });
    (shaken && boxed && task.case.tank.isolators.is_some()).then(|| {
        let message = "--quake-y: a box on isolators moves along x alone";
        Refusal::new(Place::Transverse, message, "a cylinder, or no tank.isolators").help("remove --quake-y")
    })
}

/// One Fourier harmonic at a time.
struct Harmonic;

impl Engine for Harmonic {
    fn id(&self) -> EngineId {
        EngineId::Harmonic
    }

    fn refuses(&self, task: &Task<'_>) -> Vec<Refusal> {
        across_a_box(task, EngineId::Harmonic)
            .into_iter()
            .chain(plates(task))
            .chain(joint(task, EngineId::Harmonic))
            .chain(turning(task, EngineId::Harmonic))
            .chain(elevated(task))
            .collect()
    }

    fn stops(&self) -> bool {
        false
    }

    fn estimate(&self, task: &Task<'_>) -> Result<Estimate, FeError> {
        let mut found = harmonic::estimate(task.case, task.linear)?;
        if let Some(every) = task.solid.snapshot_interval {
            harmonic::add_states(&mut found, task.case, every)?;
        }
        Ok(found)
    }

    fn run(&self, task: &Task<'_>, progress: &dyn Progress) -> Result<Simulation, FeError> {
        let extent = Extent::without(task.without);
        let close = task.solid.snapshot_close;
        let asked = (extent, task.solid.snapshot_interval.map(|every| Pictures { every, close }));
        let mut simulation = simulate_to(task.case, task.linear, asked, progress)?;
        if !task.solid.imperfections.is_empty() {
            simulation.notes.push(PERFECT.into());
        }
        Ok(simulation)
    }
}

/// Three-dimensional elements.
struct Solid;

impl Engine for Solid {
    fn id(&self) -> EngineId {
        EngineId::Solid
    }

    fn refuses(&self, task: &Task<'_>) -> Vec<Refusal> {
        let mut all = solid::refused(task.case, task.solid);
        all.extend(solid::unresolved(task));
        all.extend(across_a_box(task, EngineId::Solid));
        all.extend(across_imperfections(task));
        all.extend(box_on_isolators(task));
        all.extend(joint(task, EngineId::Solid));
        all.extend(turning(task, EngineId::Solid));
        all.extend(elevated(task));
        all
    }

    fn estimate(&self, task: &Task<'_>) -> Result<Estimate, FeError> {
        solid::estimate(task.case, task.linear, task.solid)
    }

    fn run(&self, task: &Task<'_>, progress: &dyn Progress) -> Result<Simulation, FeError> {
        solid::simulate(task.case, task.linear, task.solid, progress)
    }
}

/// Walls that yield and crack, with large rotations.
struct Nonlinear;

impl Engine for Nonlinear {
    fn id(&self) -> EngineId {
        EngineId::Nonlinear
    }

    fn refuses(&self, task: &Task<'_>) -> Vec<Refusal> {
        let mut all = scope::refusals(task.case, task.nonlinear, Purpose::History);
        if !task.linear.dashpots.is_empty() {
            let message = "the nonlinear engine has no dashpots";
            all.push(
                Refusal::new(Place::Dashpots, message, "no analysis.damping.dashpots")
                    .help("remove analysis.damping.dashpots, or use --fe harmonic or --fe solid"),
            );
        }
        all.extend(turning(task, EngineId::Nonlinear));
        all.extend(elevated(task));
        all
    }

    fn has_layers(&self) -> bool {
        true
    }

    fn estimate(&self, task: &Task<'_>) -> Result<Estimate, FeError> {
        let mut found = nonlinear::estimate(task.case, task.nonlinear)?;
        if let (Some(every), Shape::Cylinder { .. }) = (task.solid.snapshot_interval, task.case.tank.shape) {
            nonlinear::cylinder::estimate::add_states(&mut found, task.case, task.nonlinear, every)?;
        }
        Ok(found)
    }

    fn run(&self, task: &Task<'_>, progress: &dyn Progress) -> Result<Simulation, FeError> {
        let mut simulation = nonlinear::simulate_with_states(
            task.case,
            task.nonlinear,
            (task.solid.snapshot_interval, task.checkpoint),
            progress,
        )?;
        if task.linear.frequency.is_some() {
            let note =
                "`analysis.frequency`: transfer functions are those of the linear engines (--fe harmonic, --fe solid).";
            simulation.notes.push(note.into());
        }
        if !task.linear.force_stations.is_empty() {
            let note = "`analysis.force_stations`: histories of internal forces are those of the linear engines (--fe harmonic, --fe solid).";
            simulation.notes.push(note.into());
        }
        Ok(simulation)
    }
}

#[cfg(test)]
mod tests {
    use tank::Case;

    use super::*;
    use tank::imperfection::{Imperfection, Imperfections, Profile, Wave};
    use tank::options::LinearOptions as Options;
    use tank::options::nonlinear::NonlinearOptions;
    use tank::options::solid::{MeshSize, SolidOptions};

    #[test]
    fn every_id_has_its_engine() {
        assert_eq!(ALL.len(), EngineId::ALL.len());
        assert!(EngineId::ALL.iter().all(|&id| engine(id).id() == id));
    }

    #[test]
    fn an_engine_refuses_what_it_does_not_model() {
        let mut case = crate::harmonic::test_tanks::broad();
        let (linear, solid) = (Options::default(), SolidOptions::default());
        let nonlinear = NonlinearOptions::new(case.damping);
        let refusals = |case: &Case| {
            let task =
                Task { case, linear: &linear, solid: &solid, nonlinear: &nonlinear, checkpoint: None, without: &[] };
            EngineId::ALL.map(|id| engine(id).refuses(&task).into_iter().map(|r| r.place).collect::<Vec<_>>())
        };
        assert_eq!(refusals(&case), [Vec::new(), Vec::new(), Vec::new()]);
        case.tank.shape = Shape::Rectangle { length: 3.0, breadth: 3.0, strip: true };
        assert_eq!(refusals(&case), [Vec::new(), vec![Place::Shape], Vec::new()]);
        case.tank.shape = Shape::Rectangle { length: 3.0, breadth: 3.0, strip: false };
        assert_eq!(refusals(&case), [vec![Place::Shape], Vec::new(), vec![Place::Shape]]);
    }
    /// A crest beside the plane of shaking breaks the symmetry of half a tank; seven waves need 64 sectors, and a mesh that is given has
    /// as many as it has; the default mesh is refined.
    #[test]
    fn imperfections_need_a_mesh_and_a_symmetry() {
        let case = crate::harmonic::test_tanks::broad();
        let imperfections = |n: u32, phase: f64| Imperfections {
            parts: vec![Imperfection::Wave(Wave { n, amplitude: 1e-3, profile: Profile::Linear, phase })],
        };
        let refused = |imperfections: Imperfections, mesh: Option<MeshSize>, symmetry: bool| {
            let linear = Options::default();
            let solid = SolidOptions { mesh, imperfections: imperfections.clone(), ..SolidOptions::default() };
            let nonlinear = NonlinearOptions { symmetry, imperfections, ..NonlinearOptions::new(case.damping) };
            let task = Task {
                case: &case,
                linear: &linear,
                solid: &solid,
                nonlinear: &nonlinear,
                checkpoint: None,
                without: &[],
            };
            [EngineId::Solid, EngineId::Nonlinear].map(|id| engine(id).refuses(&task).len())
        };
        let mesh = |sectors| {
            let (radial, vertical) = (4, 12);
            Some(MeshSize { radial, sectors, vertical })
        };
        assert_eq!(refused(imperfections(7, 0.0), None, true), [0, 0]);
        assert_eq!(refused(imperfections(7, 0.1), None, true), [0, 1]);
        assert_eq!(refused(imperfections(7, 0.1), None, false), [0, 0]);
        assert_eq!(refused(imperfections(7, 0.0), mesh(60), true), [1, 0]);
        assert_eq!(refused(imperfections(7, 0.0), mesh(64), true), [0, 0]);
        assert_eq!(refused(imperfections(12, 0.0), None, true), [0, 1]);
    }
}
