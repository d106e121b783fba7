//! Temperature, shrinkage, creep and prestress of a wall at rest.

use std::collections::{BTreeMap, BTreeSet};

use fem::element::shell::layered::PlyState;
use tank::options::nonlinear::{NonlinearOptions, StripWall};
use tank::refusal::{Place, Refusal};
use tank::units::{Dimension, display, significant};
use tank::{BarDirection, Case, Layer, LayerKind, Material, WallTemperature};

/// Wall whose layers have free strains.
#[derive(Clone, Copy)]
pub(crate) struct Wall {
    temperature: Option<WallTemperature>,
    /// Distance from its inner to its outer face [m].
    thickness: f64,
}

impl Wall {
    /// The wall of these layers, interlayer included; `None` if nothing changes their volume.
    pub(crate) fn of(layers: &[Layer], temperature: Option<WallTemperature>) -> Option<Wall> {
        let acts = temperature.is_some() || layers.iter().any(Layer::lasts);
        acts.then(|| Wall { temperature, thickness: layers.iter().map(|l| l.thickness).sum() })
    }

    /// Thermal strain of a material at a distance from the inner face [m].
    fn thermal(&self, expansion: Option<f64>, depth: f64) -> f64 {
        // Materials without a coefficient are refused.
        self.temperature.map_or(0.0, |t| expansion.unwrap_or(f64::NAN) * t.change(depth / self.thickness))
    }

    /// Free strain and creep of a layer, and the free strains of its bars.
    ///
    /// * `inner`: distance of its inner face from that of the wall [m]
    pub(crate) fn states(&self, layer: &Layer, inner: f64) -> (PlyState, Vec<f64>) {
        let change = layer.material.volume_change;
        let expansion = layer.material.thermal_expansion();
        let free = [inner, inner + layer.thickness].map(|depth| self.thermal(expansion, depth) - change.shrinkage);
        let bars = layer.reinforcement.iter().map(|bars| {
            let own = bars.material.volume_change.thermal_expansion.or(expansion);
            self.thermal(own, inner + bars.depth) - bars.prestress / bars.material.youngs_modulus
        });
        (PlyState { free, creep: change.creep_coefficient }, bars.collect())
    }
}

/// Shells of all courses with the number of their course.
fn shells(case: &Case) -> impl Iterator<Item = (usize, Layer)> {
    let courses = case.tank.courses.iter().enumerate();
    courses
        .flat_map(|(index, course)| course.build_up().into_iter().map(move |layer| (index, layer)))
        .filter(|(_, layer)| layer.kind == LayerKind::Shell)
}

/// Refusals of what changes the volume of the wall.
///
/// * `history`: of a run through a record
pub(crate) fn refusals(case: &Case, options: &NonlinearOptions, history: bool) -> Vec<Refusal> {
    let mut all = Vec::new();
    let fibres = case.tank.shape.radius().is_none() && options.wall == StripWall::Fibre;
    if !history || fibres {
        let only = match history {
            true => "a wall of fibres has neither temperature, shrinkage, creep nor prestress at rest",
            false => "a pushover has neither temperature, shrinkage, creep nor prestress at rest",
        };
        let help =
            if history { "set analysis.nonlinear.wall to \"shell\"" } else { "use compare --fe nonlinear or ida" };
        let mut refuse = |place: Place, allowed: &str| all.push(Refusal::new(place, only, allowed).help(help));
        if options.temperature.is_some() {
            refuse(Place::Temperature, "no temperature");
        }
        for (index, layer) in shells(case) {
            if layer.material.volume_change.lasts() {
                refuse(Place::VolumeChange(layer.material.name.clone()), "neither shrinkage nor creep_coefficient");
            }
            if layer.reinforcement.iter().any(|bars| bars.prestress != 0.0) {
                refuse(Place::Course(index), "bars without prestress");
            }
        }
    } else if options.temperature.is_some() {
        for (_, layer) in shells(case).filter(|(_, layer)| layer.material.thermal_expansion().is_none()) {
            let name = layer.material.name;
            let message = format!("the material `{name}` has no coefficient of thermal expansion");
            let refusal = Refusal::new(Place::VolumeChange(name), message, "a number such as 1.2e-5, per kelvin");
            all.push(refusal.help("add \"volume_change\": { \"thermal_expansion\": 1.2e-5 } to the material"));
        }
    }
    all
}

/// The state at rest in words.
pub(crate) fn assumptions(case: &Case, options: &NonlinearOptions) -> Vec<String> {
    let mut out = Vec::new();
    let materials: BTreeMap<String, Material> =
        shells(case).map(|(_, layer)| (layer.material.name.clone(), layer.material)).collect();
    if let Some(WallTemperature { inside, outside, stress_free }) = options.temperature {
        let shown = |t: f64| display(t, Dimension::Temperature);
        let expansions =
            materials.values().filter_map(|m| Some(format!("{} {:.2e}/K", m.name, m.thermal_expansion()?)));
        out.push(format!(
            "At rest the wall has {} at its wet and {} at its dry face, linear between them, and is free of stress at {}; coefficients of \
             thermal expansion: {}.",
            shown(inside), shown(outside), shown(stress_free), expansions.collect::<Vec<_>>().join(", ")
        ));
        out.push(
            "Bars without a coefficient of their own expand as their layer. Base, bottom plate, rings and interlayer keep their \
             length at rest."
                .into(),
        );
    }
    for Material { name, volume_change: change, .. } in materials.values() {
        if change.shrinkage != 0.0 {
            out.push(format!("{name} has shrunk by {:.2e} before the record.", change.shrinkage));
        }
        if change.creep_coefficient > 0.0 {
            out.push(format!(
                "{name} creeps at rest with the coefficient {}: all strains of its law are multiplied by 1 + φ, those of a change \
                 of temperature too (EN 1992-1-1, 5.8.6). The record meets its short-time stiffness.",
                significant(change.creep_coefficient, 3)
            ));
        }
    }
    for (direction, name) in [(BarDirection::Hoop, "hoop"), (BarDirection::Vertical, "vertical")] {
        let bars = shells(case).flat_map(|(_, layer)| layer.reinforcement).filter(|bars| bars.direction == direction);
        let prestress = bars.map(|bars| bars.prestress).filter(|stress| *stress != 0.0);
        let texts: BTreeSet<String> = prestress.map(|stress| display(stress, Dimension::Stress)).collect();
        if !texts.is_empty() {
            let texts = texts.into_iter().collect::<Vec<_>>().join(", ");
            out.push(format!(
                "Prestress of {name} bars where the wall has no strain: {texts}. The wall that it shortens takes its part of it at rest; \
                 the bars are bonded."
            ));
        }
    }
    if !out.is_empty() {
        out.push("Code procedures and linear engines leave this state out.".into());
    }
    out
}
