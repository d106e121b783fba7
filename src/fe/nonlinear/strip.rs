//! From a case to the strip of the nonlinear engine: fibre walls, liquid condensed onto them.

use std::sync::Arc;

use codes::Case;
use codes::tank::{BarDirection, Behaviour, Layer, LayerKind, Shape};
use codes::units::Dimension;
use fem::analysis::damping::Rayleigh;
use fem::analysis::march::Outcome;
use fem::analysis::scheme::TimeScheme;
use fem::element::beam_section::FibreSection;
use fem::element::fibre_beam;
use fem::liquid::strip::StripLiquid;
use fem::progress::Progress;
use fem::strip::{StripDamping, StripError, StripLevel, StripModel, StripQuake, StripTank};
use materials::Law;
use materials::elastic::Elastic;
use materials::von_mises::VonMises;

use super::laws::{bar_law, quadrature, refused, uniaxial_concrete, unsupported};
use super::{Contact, Damping, MassProportionalAt, NonlinearOptions, ThicknessRule};
use crate::fe::FeError;
use crate::results::{Collapse, Fact, FirstCrack, IdaRun};

/// Sloshing modes of the condensed liquid: the tenth holds 1e-4 of the liquid's mass.
const SLOSHING_MODES: usize = 12;
/// Elements over the wall unless the user says otherwise.
const ELEMENTS: u32 = 40;
/// Steps of the time integration in a period of the first mode of wall and liquid.
const STEPS_PER_PERIOD: f64 = 20.0;
/// Share of the bending stiffness that a leaf beside the main one may have without being modelled.
const NEGLIGIBLE: f64 = 1e-2;

/// A strip ready to be shaken.
pub struct Strip {
    model: StripModel,
    quake: StripQuake,
    /// The model in numbers.
    pub facts: Vec<Fact>,
    /// What was assumed, one sentence each.
    pub assumptions: Vec<String>,
}

fn failed(error: impl Into<StripError>) -> FeError {
    FeError::Analysis(error.into().to_string())
}

impl Strip {
    /// The strip of a case with its record.
    ///
    /// Errors: no record; a tank that is no strip; a wall, a law or an option that the strip does not know; parameters out of
    /// range.
    pub fn new(case: &Case, options: &NonlinearOptions) -> Result<Strip, FeError> {
        let Some(motion) = &case.ground_motion else {
            return Err(FeError::NoRecord);
        };
        let Shape::Rectangle {
            length, strip: true, ..
        } = case.tank.shape
        else {
            return unsupported(
                "the nonlinear engine runs strips of long rectangular tanks (shape rectangle, strip true); this tank is none",
            );
        };
        if options.contact == Contact::Opening {
            return unsupported("contact that opens is not part of the nonlinear strip: choose contact `bonded`");
        }
        let levels = levels(case, options.elements.map_or(ELEMENTS, |e| e.height));
        let mut top = 0.0;
        let joints: Vec<f64> = case
            .tank
            .courses
            .iter()
            .map(|c| {
                top += c.height;
                top
            })
            .collect();
        let mut sections = Vec::new();
        for ends in levels.windows(2) {
            let middle = 0.5 * (ends[0] + ends[1]);
            let course = joints.iter().position(|&z| middle < z).unwrap_or(joints.len() - 1);
            let layers = case.tank.courses[course].build_up();
            sections.push(Arc::new(section(&layers, ends[1] - ends[0], options)?));
        }
        let liquid = StripLiquid {
            half_width: 0.5 * length,
            depth: case.liquid.fill_height,
            density: case.liquid.density,
            gravity: case.gravity,
        };
        let tank = StripTank {
            levels,
            sections,
            options: fibre_beam::Options::default(),
            base_spring: None,
            liquid,
            sloshing: SLOSHING_MODES,
        };
        let mut model = StripModel::new(&tank, damping(options.damping, &liquid)?).map_err(failed)?;
        if !options.self_weight {
            model.weight.fill(0.0);
        }
        let record = &motion.horizontal;
        let period = std::f64::consts::TAU / model.wall_frequency();
        let step = options
            .time_step
            .unwrap_or_else(|| (period / STEPS_PER_PERIOD).min(0.5 * record.dt));
        let mut quake = StripQuake::new(record.clone(), step);
        quake.vertical.clone_from(&motion.vertical);
        quake.scheme = TimeScheme::GeneralizedAlpha {
            radius: options.spectral_radius,
        };
        let facts = facts(&model, &tank, step);
        let assumptions = assumptions(case, options);
        Ok(Strip {
            model,
            quake,
            facts,
            assumptions,
        })
    }

    /// Both walls at every scale on `threads` threads, by ascending scale; `each` hears of every run as it is finished.
    ///
    /// Errors: a failure of the analysis; collapse is none.
    pub fn incremental(
        &self,
        scales: &[f64],
        threads: usize,
        progress: &dyn Progress,
        mut each: impl FnMut(IdaRun),
    ) -> Result<Vec<IdaRun>, FeError> {
        let levels = self
            .model
            .incremental(&self.quake, scales, threads, progress, |level| each(self.run(level)))
            .map_err(failed)?;
        Ok(levels.iter().map(|level| self.run(level)).collect())
    }

    fn run(&self, level: &StripLevel) -> IdaRun {
        let demand = level.demand();
        let collapse = level.walls.iter().find_map(|wall| match &wall.outcome {
            Outcome::Collapsed(collapse) => Some(Collapse {
                time: collapse.time,
                reason: collapse.failure.to_string(),
            }),
            _ => None,
        });
        let [a, b] = &level.walls;
        IdaRun {
            scale: level.scale,
            pga: level.scale * self.quake.horizontal.pga(),
            collapse,
            wave: demand.wave,
            wall_displacement: demand.deflection,
            wall_displacement_time: demand.deflection_time,
            base_moment: demand.base_moment,
            first_crack: demand.first_crack.map(|c| FirstCrack {
                time: c.time,
                height: c.height,
                base_moment: c.base_moment,
            }),
            highest_crack: demand.highest_crack,
            largest_crack: demand.largest_crack,
            bar_stress: demand.bar_stress,
            bar_plastic_strain: demand.bar_plastic_strain,
            hysteretic_energy: a.hysteretic.max(b.hysteretic),
            wall_damping: self.model.wall_ratio(),
            halvings: level.halvings(),
            steps: a.steps + b.steps,
            energy_residual: level.imbalance(),
        }
    }
}

/// Nodes over the wall: every joint of the courses and the surface is one, elements of nearly equal length.
fn levels(case: &Case, elements: u32) -> Vec<f64> {
    let mut marks = vec![0.0, case.liquid.fill_height];
    let mut top = 0.0;
    for course in &case.tank.courses {
        top += course.height;
        marks.push(top);
    }
    marks.sort_by(f64::total_cmp);
    // Marks closer than this are one.
    marks.dedup_by(|b, a| (*b - *a).abs() < 1e-6 * top);
    let longest = top / f64::from(elements.max(1));
    let mut z = vec![0.0];
    for ends in marks.windows(2) {
        let count = ((ends[1] - ends[0]) / longest).round().max(1.0);
        z.extend((1..=count as usize).map(|i| ends[0] + (ends[1] - ends[0]) * i as f64 / count));
    }
    z
}

/// Section of a wall of 1 m breadth on an element of length `element` [m]: the leaf that carries the bending, the others as
/// mass.
fn section(layers: &[Layer], element: f64, options: &NonlinearOptions) -> Result<FibreSection, FeError> {
    let leaves: Vec<&[Layer]> = layers.split(|l| l.kind == LayerKind::Interlayer).collect();
    let stiffness = |leaf: &[Layer]| -> f64 {
        let height: f64 = leaf.iter().map(|l| l.thickness).sum();
        leaf.iter().map(|l| l.material.youngs_modulus).fold(0.0, f64::max) * height.powi(3)
    };
    let all: f64 = leaves.iter().map(|leaf| stiffness(leaf)).sum();
    let Some(main) = leaves
        .iter()
        .copied()
        .max_by(|a, b| stiffness(a).total_cmp(&stiffness(b)))
    else {
        return unsupported("a wall without layers");
    };
    if stiffness(main) < (1.0 - NEGLIGIBLE) * all {
        return unsupported(
            "the nonlinear strip bends one leaf of the wall; both leaves of this sandwich have a share of the stiffness",
        );
    }
    let mass = |layers: &[Layer]| -> f64 { layers.iter().map(|l| l.material.density * l.thickness).sum() };
    let beam_error = |e: fem::element::ElementError| failed(e);
    let own = mass(main);
    let mut section = FibreSection::new(own)
        .and_then(|s| s.with_attached_mass(mass(layers) - own))
        .map_err(beam_error)?;
    // ζ from the middle of the leaf, towards the outside.
    let height: f64 = main.iter().map(|l| l.thickness).sum();
    let mut inner = -0.5 * height;
    let mut bars: Vec<(Arc<dyn Law<1>>, [f64; 2])> = Vec::new();
    for layer in main {
        let (law, rule) = fibre_law(layer, element, options)?;
        let centre = inner + 0.5 * layer.thickness;
        section = match rule {
            ThicknessRule::MidPoint(n) => section.rectangle(law, [1.0, layer.thickness], centre, n as usize),
            rule => section.fibres(law, &fibres(rule, centre, layer.thickness)?),
        }
        .map_err(beam_error)?;
        for bar in layer
            .reinforcement
            .iter()
            .filter(|b| b.direction == BarDirection::Vertical)
        {
            bars.push((bar_law(&bar.material)?, [inner + bar.depth, bar.area]));
        }
        inner += layer.thickness;
    }
    for (law, fibre) in bars {
        section = section.bars(law, &[fibre]).map_err(beam_error)?;
    }
    Ok(section)
}

/// Depths and areas of a quadrature over a layer of 1 m breadth.
fn fibres(rule: ThicknessRule, centre: f64, thickness: f64) -> Result<Vec<[f64; 2]>, FeError> {
    let rule = quadrature(rule);
    let points = rule.points().map_err(failed)?;
    Ok(points
        .iter()
        .map(|&(x, w)| [centre + 0.5 * thickness * x, 0.5 * thickness * w])
        .collect())
}

/// Law of a fibre along the wall, and its quadrature. Across the strip the strain is held: plane strain, E/(1 − ν²).
fn fibre_law(
    layer: &Layer,
    element: f64,
    options: &NonlinearOptions,
) -> Result<(Arc<dyn Law<1>>, ThicknessRule), FeError> {
    let material = &layer.material;
    let nu = material.poisson_ratio;
    let young = material.youngs_modulus / (1.0 - nu * nu);
    Ok(match material.behaviour {
        Behaviour::Elastic | Behaviour::Interlayer(_) => (
            Arc::new(Elastic::new(young, 0.0).map_err(refused)?),
            options.integration.elastic,
        ),
        Behaviour::Steel(steel) => {
            // In plane strain a plate yields at 2/√3 of its strength.
            let strength = 2.0 / 3.0_f64.sqrt() * steel.yield_strength;
            let law = VonMises::new(young, 0.0, strength, steel.tangent_modulus, steel.kinematic_share);
            (Arc::new(law.map_err(refused)?), options.integration.steel)
        }
        Behaviour::Concrete(concrete) => (
            Arc::new(uniaxial_concrete(&concrete, young, layer, element)?),
            options.integration.concrete,
        ),
        Behaviour::Reinforcement(_) => return unsupported(format!("`{}` is for bars, not for a layer", material.name)),
    })
}

fn damping(damping: Damping, liquid: &StripLiquid) -> Result<StripDamping, FeError> {
    Ok(match damping {
        Damping::ByGroup { wall, sloshing } => StripDamping::ByGroup { wall, sloshing },
        Damping::Rayleigh {
            first,
            second,
            allow_negative,
        } => StripDamping::Rayleigh(
            Rayleigh::fit(first, second, allow_negative).map_err(|e| FeError::Option {
                option: "damping".into(),
                found: e.to_string(),
                allowed: "coefficients ≥ 0, or allow_negative".into(),
            })?,
        ),
        Damping::MassProportional { ratio, at } => {
            let omega = match at {
                MassProportionalAt::FirstSloshing => liquid.sloshing_frequency(0),
                MassProportionalAt::Frequency(omega) => omega,
            };
            StripDamping::Rayleigh(Rayleigh::mass_proportional(omega, ratio))
        }
    })
}

fn facts(model: &StripModel, tank: &StripTank, step: f64) -> Vec<Fact> {
    let fact = |name: &str, value: f64, dimension| Fact {
        name: name.into(),
        value,
        dimension,
    };
    let number = Dimension::Dimensionless;
    let fibres = tank.sections.iter().map(|s| s.fibre_count()).max().unwrap_or(0);
    vec![
        fact("elements over a wall", (tank.levels.len() - 1) as f64, number),
        fact("fibres in a section", fibres as f64, number),
        fact("sloshing modes of the liquid", tank.sloshing as f64, number),
        fact(
            "first sloshing mode",
            model.modes.omega.first().copied().unwrap_or(f64::NAN),
            Dimension::AngularFrequency,
        ),
        fact("damping of the first sloshing mode", model.ratios[0].ratio, number),
        fact(
            "first mode of wall and liquid",
            model.wall_frequency(),
            Dimension::AngularFrequency,
        ),
        fact(
            "damping of the first mode of wall and liquid",
            model.wall_ratio(),
            number,
        ),
        fact("longest time step", step, Dimension::Time),
    ]
}

fn assumptions(case: &Case, options: &NonlinearOptions) -> Vec<String> {
    let mut out = vec![
        "Strip of 1 m breadth in plane strain; corners of the tank are outside the model; rigid base, clamped walls.".to_owned(),
        "Walls as fibre beams with plane sections and small deflections: no shear failure, no bond slip.".to_owned(),
        "Liquid of linear potential theory, condensed onto the wall; it stays at the wall. Both walls are run (the record and the \
         record turned round); each number is that of the worse one."
            .to_owned(),
        "Every run begins with the weight of the walls and the hydrostatic pressure. An unconverged step is never accepted: it \
         is halved until it converges, or the run ends as a collapse, and its numbers are lower bounds."
            .to_owned(),
        format!(
            "A curve of one record says nothing of a capacity: that needs at least {} records.",
            fem::analysis::ida::RECORDS_FOR_CAPACITY
        ),
    ];
    if case.tank.courses.iter().any(|c| c.layers.len() > 1) {
        out.push(
            "Layered wall: the stiffest leaf bends; the interlayer passes no shear and what stands on its other side counts for \
             mass alone."
                .into(),
        );
    }
    if !options.self_weight {
        out.push("The walls have no weight, as asked for.".into());
    }
    if options.spectral_radius < 1.0 {
        out.push(format!(
            "Generalised-α method with ρ∞ = {}: what the scheme itself dissipates is part of the energy balance.",
            options.spectral_radius
        ));
    }
    out
}
