//! A run in the vocabulary of the results.

use std::collections::BTreeMap;
use std::f64::consts::TAU;

use codes::tank::Behaviour;
use codes::units::{Dimension, display, significant};
use codes::{Case, Quantity};
use fem::analysis::march::{Outcome, Run};
use fem::analysis::scheme::TimeScheme;

use super::super::{Damping, NonlinearOptions};
use super::completed;
use super::model::CylinderModel;
use super::points::{Look, look};
use super::watch::{
    BASE_MOMENT, BASE_SHEAR, BELLY_FRONT, Extremes, Happening, TOP_FRONT, WAVE_BACK, WAVE_FRONT, Watch,
};
use crate::fe::Simulation;
use crate::results::nonlinear::{
    CellMap, Columns, Count, CrackPicture, End, Energies, Event, Loop, LoopAxis, Nonlinear, WallGrid,
};
use crate::results::{EnergyBalance, Envelope, FeResult, Labelled, Series, SeriesInfo};

/// Points of a loop or a curve of energy at most.
const POINTS: usize = 1500;

/// Everything that is reported of a run.
pub fn report(
    case: &Case,
    options: &NonlinearOptions,
    tank: &CylinderModel,
    watch: &Watch<'_>,
    run: &Run,
) -> Simulation {
    let last = look(tank, &run.state);
    let mut worst = watch.seen.worst.clone().unwrap_or_else(|| last.clone());
    worst.envelop(&last);
    let (info, series) = histories(watch);
    let values = values(tank, watch);
    let mut notes = Vec::new();
    let end = end(tank, run);
    match &end {
        End::Completed => {}
        End::Interrupted { time } => {
            notes.push(format!("Interrupted at {time:.3} s: everything ends there."));
        }
        End::Collapsed { time, reason, .. } => notes.push(format!(
            "Collapse: no equilibrium after {time:.3} s ({reason}). All numbers are those until then, lower bounds."
        )),
    }
    let events = events(tank, watch);
    if let Some(parts) = events.iter().find(|e| e.id == "separation") {
        notes.push(format!(
            "The liquid would part from the wall ({}, first at {:.2} s); the engine keeps it there.",
            parts.place, parts.time
        ));
    }
    let balance = &run.balance;
    let energies = energies(run, watch);
    let nonlinear = Nonlinear {
        end,
        events,
        grid: grid(tank),
        maps: maps(case, tank, watch, &worst, &last),
        cracks: pictures(watch, &last, run.time),
        loops: loops(watch),
        energies,
        cost: cost(tank, watch, run),
    };
    let total = balance.samples.last().copied().unwrap_or_default();
    let copies = tank.cells.copies();
    let result = FeResult {
        engine: "nonlinear".into(),
        mesh: mesh(tank),
        modes: Vec::new(),
        integration: integration(tank, options, run),
        damping_table: Vec::new(),
        mesh_error: BTreeMap::new(),
        mass_balance: Vec::new(),
        energy: Some(EnergyBalance {
            input: copies * total.input,
            kinetic: copies * total.kinetic,
            elastic: copies * (total.internal - total.hysteretic),
            damping: copies * total.damping,
            error: balance.error(),
        }),
        envelopes: envelopes(tank, watch),
        series: info,
        limits: Vec::new(),
        fields: None,
        nonlinear: Some(nonlinear),
        incomplete: !completed(run),
    };
    Simulation {
        values,
        result,
        series,
        assumptions: assumptions(case, options, tank),
        notes,
        snapshots: None,
    }
}

/// Histories relative to the state at rest, as those of the other engines.
fn histories(watch: &Watch<'_>) -> (Vec<SeriesInfo>, Series) {
    let recorder = &watch.recorder;
    let (mut info, mut series) = (Vec::new(), Series::default());
    series.time.clone_from(&recorder.times);
    let mut push = |id: &str, title: &str, dimension, values: &[f64], peak: Option<(f64, f64)>| {
        let rest = values.first().copied().unwrap_or(0.0);
        let own: Vec<f64> = values.iter().map(|v| v - rest).collect();
        let sampled = || {
            let i = (0..own.len()).fold(0, |m, i| if own[i].abs() > own[m].abs() { i } else { m });
            (
                own.get(i).map_or(0.0, |v| v.abs()),
                recorder.times.get(i).copied().unwrap_or(0.0),
            )
        };
        let (peak, time) = peak.unwrap_or_else(sampled);
        info.push(SeriesInfo {
            id: id.into(),
            title: title.into(),
            dimension,
            static_value: rest,
            peak,
            time,
        });
        series.ids.push(id.into());
        series.columns.push(own);
    };
    for (k, id, title, dimension) in [
        (
            WAVE_FRONT,
            "wave_height_theta_0",
            "Wave height at the wall, θ = 0°",
            Dimension::Length,
        ),
        (
            WAVE_BACK,
            "wave_height_theta_180",
            "Wave height at the wall, θ = 180°",
            Dimension::Length,
        ),
        (BASE_SHEAR, "base_shear", "Base shear", Dimension::Force),
        (
            BASE_MOMENT,
            "base_moment",
            "Moment above the base plate",
            Dimension::Moment,
        ),
        (
            TOP_FRONT,
            "top_displacement",
            "Radial displacement of the top of the wall, θ = 0°",
            Dimension::Length,
        ),
        (
            BELLY_FRONT,
            "belly_displacement",
            "Radial displacement at a third of the levels of the wall, θ = 0°",
            Dimension::Length,
        ),
    ] {
        let swing = extremes(watch, k);
        push(id, title, dimension, &recorder.histories[k], Some(swing.swing()));
    }
    for (side, angle) in [(0, 0), (1, 180)] {
        let meridian = &watch.seen.sides[side];
        push(
            &format!("axial_membrane_stress_base_theta_{angle}"),
            &format!("Axial membrane stress at the base, θ = {angle}°"),
            Dimension::Stress,
            &meridian.base_axial,
            None,
        );
        push(
            &format!("wall_moment_base_theta_{angle}"),
            &format!("Meridional bending moment of the wall at the base, θ = {angle}°"),
            Dimension::LineMoment,
            &meridian.moment,
            None,
        );
    }
    (info, series)
}

/// Range of a recorded quantity with its value at rest; zeros where the state at rest was not reached.
fn extremes(watch: &Watch<'_>, k: usize) -> Extremes {
    let range = &watch.recorder.ranges[k];
    match watch.recorder.histories[k].first() {
        Some(&rest) => Extremes {
            rest,
            min: range.min,
            min_time: range.min_time,
            max: range.max,
            max_time: range.max_time,
        },
        None => Extremes::default(),
    }
}

fn values(tank: &CylinderModel, watch: &Watch<'_>) -> BTreeMap<Quantity, f64> {
    let swing = |k: usize| extremes(watch, k).swing().0;
    let rise = |k: usize| {
        let of = extremes(watch, k);
        of.max - of.rest
    };
    let sides = &watch.seen.sides;
    let hoop = sides
        .iter()
        .flat_map(|s| s.hoop.iter().map(|e| e.swing().0))
        .fold(0.0, f64::max);
    let axial = sides
        .iter()
        .filter_map(|s| s.axial.first().map(|e| e.swing().0))
        .fold(0.0, f64::max);
    let mut out = BTreeMap::from([
        (Quantity::ImpulsivePeriod, TAU / tank.wall_omega),
        (Quantity::SloshingHeight, rise(WAVE_FRONT).max(rise(WAVE_BACK))),
        (Quantity::BaseShear, swing(BASE_SHEAR)),
        (Quantity::BaseMoment, swing(BASE_MOMENT)),
        (Quantity::HoopStress, hoop),
        (Quantity::AxialMembraneStress, axial),
    ]);
    if tank.sloshing_omega > 0.0 {
        out.insert(Quantity::SloshingPeriod, TAU / tank.sloshing_omega);
    }
    out
}

fn end(tank: &CylinderModel, run: &Run) -> End {
    match &run.outcome {
        Outcome::Completed => End::Completed,
        Outcome::Interrupted | Outcome::Stopped { .. } => End::Interrupted { time: run.time },
        Outcome::Collapsed(collapse) => {
            let node = collapse.worst.map(|(node, _)| node);
            let node = node.or(collapse.element.map(|e| tank.model.elements()[e].nodes()[0]));
            End::Collapsed {
                time: collapse.time,
                load_factor: collapse.load_factor,
                reason: collapse.failure.to_string(),
                place: node.map_or(String::new(), |n| {
                    let [x, y, z] = tank.model.nodes()[n];
                    place(y.atan2(x), z)
                }),
            }
        }
    }
}

fn place(theta: f64, z: f64) -> String {
    format!(
        "θ = {}°, z = {}",
        significant(theta.to_degrees().abs(), 3),
        display(z, Dimension::Length)
    )
}

/// Middle of a cell.
fn middle(tank: &CylinderModel, cell: usize) -> String {
    let columns = tank.cells.columns();
    let (row, column) = (cell / columns, cell % columns);
    let theta = (column as f64 + 0.5) * tank.cells.angle();
    place(theta, 0.5 * (tank.cells.z[row] + tank.cells.z[row + 1]))
}

fn events(tank: &CylinderModel, watch: &Watch<'_>) -> Vec<Event> {
    let mut out: Vec<Event> = watch
        .seen
        .first
        .iter()
        .map(|&(what, time, cell)| {
            let (id, title) = match what {
                Happening::Crack => ("first_crack", "first crack"),
                Happening::Yield => ("first_yield", "first yielding of a plate"),
                Happening::BarYield => ("first_bar_yield", "first yielding of a bar"),
                Happening::Tears => ("above_strength", "a plate passes its tensile strength"),
                Happening::BarRupture => ("bar_rupture", "a bar passes its strain at rupture"),
                Happening::Crushing => ("crushing", "concrete reaches its compressive strength"),
            };
            Event {
                id: id.into(),
                title: title.into(),
                time,
                place: middle(tank, cell),
                note: if time == 0.0 {
                    "In the state at rest.".into()
                } else {
                    String::new()
                },
            }
        })
        .collect();
    let separation = watch.separation.result();
    if let Some(first) = separation
        .places
        .iter()
        .filter(|p| p.below_trough)
        .min_by(|a, b| a.first.total_cmp(&b.first))
    {
        let [x, y, z] = tank.model.nodes()[tank.wetted[first.number]];
        out.push(Event {
            id: "separation".into(),
            title: "the liquid would part from the wall".into(),
            time: first.first,
            place: place(y.atan2(x), z),
            note: format!(
                "Lowest pressure there {} at {:.2} s, judged on the displaced particle.",
                display(first.pressure, Dimension::Stress),
                first.time
            ),
        });
    }
    out.sort_by(|a, b| a.time.total_cmp(&b.time));
    out
}

fn grid(tank: &CylinderModel) -> WallGrid {
    WallGrid {
        columns: Columns::Sectors {
            radius: tank.radius,
            edges: tank.cells.edges(),
            mirrored: tank.cells.half,
        },
        z: tank.cells.z.clone(),
        surface: tank.depth,
    }
}

/// Lowest yield strength of all bars [Pa].
fn bar_strength(case: &Case) -> Option<f64> {
    let bars = case.tank.courses.iter().flat_map(|c| c.build_up());
    let bars = bars.flat_map(|layer| layer.reinforcement);
    let strengths = bars.filter_map(|bar| match bar.material.behaviour {
        Behaviour::Reinforcement(bar) => Some(bar.yield_strength),
        _ => None,
    });
    strengths.min_by(f64::total_cmp)
}

fn maps(case: &Case, tank: &CylinderModel, watch: &Watch<'_>, worst: &Look, last: &Look) -> Vec<CellMap> {
    let mut out = Vec::new();
    let mut push = |id: &str, title: &str, dimension, values: &[f64], mark: Option<f64>, note: &str| {
        if !values.is_empty() {
            out.push(CellMap {
                id: id.into(),
                title: title.into(),
                dimension,
                values: values.to_vec(),
                mark,
                note: note.into(),
            });
        }
    };
    let number = Dimension::Dimensionless;
    push(
        "utilisation",
        "Utilisation of the plate, largest over time",
        number,
        &worst.utilisation,
        Some(1.0),
        "Von Mises stress over the yield stress, hardening included; 1: yielding.",
    );
    push(
        "plastic_strain",
        "Plastic strain of the plate at the end",
        number,
        &last.plastic_strain,
        None,
        "Accumulated equivalent plastic strain, the largest over the thickness.",
    );
    push(
        "crack_width_inner",
        "Largest crack width, inner face",
        Dimension::Length,
        &worst.crack_width[0],
        None,
        "Crack strain times the length over which a crack is smeared; the widest so far.",
    );
    push(
        "crack_width_outer",
        "Largest crack width, outer face",
        Dimension::Length,
        &worst.crack_width[1],
        None,
        "Crack strain times the length over which a crack is smeared; the widest so far.",
    );
    push(
        "compression",
        "Compression of the concrete over its strength, largest over time",
        number,
        &worst.compression,
        Some(1.0),
        "Smallest principal stress over the uniaxial strength; above 1 under biaxial compression.",
    );
    push(
        "bar_stress",
        "Stress of the bars, largest over time",
        Dimension::Stress,
        &worst.bar_stress,
        bar_strength(case),
        "Tension or compression, the larger, of all bars of a cell; the mark is their yield strength.",
    );
    push(
        "bar_plastic_strain",
        "Plastic strain of the bars at the end",
        number,
        &last.bar_plastic_strain,
        None,
        "Accumulated, the largest of all bars of a cell.",
    );
    let found = watch.separation.result();
    if found.places.iter().any(|p| p.below_trough) {
        let columns = tank.cells.columns();
        let around = tank.footprint.levels[0].len();
        let mut share = vec![0.0_f64; tank.cells.rows() * columns];
        for p in found.places.iter().filter(|p| p.below_trough) {
            let (level, k) = (p.number / around, p.number % around);
            for row in [level.checked_sub(1), Some(level)].into_iter().flatten() {
                for column in [k.checked_sub(1), Some(k)].into_iter().flatten() {
                    if row < tank.cells.rows() && column < columns {
                        let own = &mut share[row * columns + column];
                        *own = own.max(p.share);
                    }
                }
            }
        }
        push(
            "separation",
            "Share of the time in which the liquid would part from the wall",
            number,
            &share,
            None,
            "Pressure of the displaced particle below zero, under the lowest surface.",
        );
    }
    out
}

fn pictures(watch: &Watch<'_>, last: &Look, time: f64) -> Vec<CrackPicture> {
    let extreme = watch.seen.extreme.as_ref();
    let rest = watch.seen.rest.as_ref().map(|l| ("state at rest", 0.0, l));
    let extreme = extreme.map(|k| ("largest base moment", k.time, &k.look));
    let extreme = extreme.filter(|e| e.1 > 0.0);
    let all = rest.into_iter().chain(extreme).chain([("end of the run", time, last)]);
    let mut out = Vec::new();
    for (title, time, look) in all {
        for (face, name) in ["inner face", "outer face"].into_iter().enumerate() {
            // Only where the wall has concrete at all.
            if !look.crack_width[face].is_empty() {
                out.push(CrackPicture {
                    title: title.into(),
                    face: name.into(),
                    time,
                    cracks: look.cracks[face].clone(),
                });
            }
        }
    }
    out
}

/// Shortest step [s]; 0 if none was taken.
fn shortest(run: &Run) -> f64 {
    if run.shortest.is_finite() { run.shortest } else { 0.0 }
}

/// Every so-manieth of `n` points.
fn stride(n: usize) -> usize {
    n.div_ceil(POINTS).max(1)
}

fn paired(x: &[f64], y: &[f64]) -> Vec<[f64; 2]> {
    let n = x.len().min(y.len());
    x.iter().zip(y).step_by(stride(n)).map(|(x, y)| [*x, *y]).collect()
}

fn loops(watch: &Watch<'_>) -> Vec<Loop> {
    let axis = |title: &str, dimension| LoopAxis {
        title: title.into(),
        dimension,
    };
    let mut out = Vec::new();
    for (side, angle) in [(0, 0), (1, 180)] {
        let meridian = &watch.seen.sides[side];
        out.push(Loop {
            id: format!("moment_curvature_theta_{angle}"),
            title: format!("Base of the wall, θ = {angle}°: meridional moment over curvature of the lowest cell"),
            x: axis("Curvature", Dimension::Curvature),
            y: axis("Moment", Dimension::LineMoment),
            points: paired(&meridian.curvature, &meridian.moment),
        });
    }
    let h = &watch.recorder.histories;
    out.push(Loop {
        id: "shear_displacement".into(),
        title: "Base shear over the radial displacement of the wall, θ = 0°, at a third of its levels".into(),
        x: axis("Displacement", Dimension::Length),
        y: axis("Base shear", Dimension::Force),
        points: paired(&h[BELLY_FRONT], &h[BASE_SHEAR]),
    });
    out
}

fn energies(run: &Run, watch: &Watch<'_>) -> Energies {
    let samples = &run.balance.samples;
    let copies = watch.copies();
    let every = stride(samples.len());
    let column = |f: &dyn Fn(&fem::analysis::march::Energies) -> f64| -> Vec<f64> {
        samples.iter().step_by(every).map(|e| copies * f(e)).collect()
    };
    let times = &watch.recorder.times;
    Energies {
        time: times.iter().take(samples.len()).step_by(every).copied().collect(),
        input: column(&|e| e.input),
        kinetic: column(&|e| e.kinetic),
        internal: column(&|e| e.internal),
        damping: column(&|e| e.damping),
        numerical: column(&|e| e.numerical),
        hysteretic: column(&|e| e.hysteretic),
        error: run.balance.error(),
    }
}

fn cost(tank: &CylinderModel, watch: &Watch<'_>, run: &Run) -> Vec<Count> {
    let count = |label: &str, value: f64, dimension| Count {
        label: label.into(),
        value,
        dimension,
    };
    let number = Dimension::Dimensionless;
    vec![
        count("unknowns", tank.model.dofs().len() as f64, number),
        count("wetted radial displacements", tank.wetted.len() as f64, number),
        count("steps", run.cost.steps as f64, number),
        count("steps cut to half", run.cuts as f64, number),
        count("shortest step", shortest(run), Dimension::Time),
        count("iterations", run.cost.iterations as f64, number),
        count("factorisations", run.cost.factors as f64, number),
        count("evaluations of all elements", run.cost.evaluations as f64, number),
        count("looks at all material points", watch.seen.looks as f64, number),
    ]
}

fn envelopes(tank: &CylinderModel, watch: &Watch<'_>) -> Vec<Envelope> {
    let z: Vec<f64> = tank.cells.z.windows(2).map(|z| 0.5 * (z[0] + z[1])).collect();
    let front = &watch.seen.sides[0];
    [
        ("hoop_stress", "Hoop membrane stress", &front.hoop),
        ("axial_membrane_stress", "Axial membrane stress", &front.axial),
    ]
    .into_iter()
    .map(|(id, title, list)| Envelope {
        id: id.into(),
        title: title.into(),
        dimension: Dimension::Stress,
        z: z[..list.len()].to_vec(),
        static_: list.iter().map(|e| e.rest).collect(),
        min: list.iter().map(|e| e.min - e.rest).collect(),
        max: list.iter().map(|e| e.max - e.rest).collect(),
    })
    .collect()
}

fn label(label: &str, text: String) -> Labelled {
    Labelled {
        label: label.into(),
        text,
    }
}

fn mesh(tank: &CylinderModel) -> Vec<Labelled> {
    let layers = tank
        .rows
        .iter()
        .map(|r| r.parts.iter().map(Vec::len).sum::<usize>())
        .max();
    vec![
        label(
            "shells (around × over the height)",
            format!("{} × {}", tank.cells.columns(), tank.cells.rows()),
        ),
        label(
            "symmetry",
            match tank.cells.half {
                true => "half of the tank, mirrored at the plane of shaking".into(),
                false => "the whole tank".into(),
            },
        ),
        label("layers and bars over the thickness", layers.unwrap_or(0).to_string()),
        label(
            "liquid",
            format!(
                "condensed onto {} radial displacements and {} sloshing modes",
                tank.wetted.len(),
                tank.amplitudes.len()
            ),
        ),
        label("unknowns", tank.model.dofs().len().to_string()),
    ]
}

fn integration(tank: &CylinderModel, options: &NonlinearOptions, run: &Run) -> Vec<Labelled> {
    let scheme = TimeScheme::GeneralizedAlpha {
        radius: options.spectral_radius,
    };
    let method = match scheme {
        TimeScheme::GeneralizedAlpha { radius } => format!(
            "generalised-α method, ρ∞ = {}, modified Newton iteration with line search",
            significant(radius, 3)
        ),
        _ => "implicit".into(),
    };
    let damping = match options.damping {
        Damping::ByGroup { wall, sloshing } => format!(
            "wall {} % at the first mode of wall and liquid, proportional to the stiffness of the virgin wall; sloshing modes {} % \
             each",
            significant(100.0 * wall, 3),
            significant(100.0 * sloshing, 3)
        ),
        Damping::Rayleigh { .. } => "Rayleigh damping on the stiffness of the virgin wall".into(),
        Damping::MassProportional { ratio, .. } => {
            format!("proportional to the mass, {} %", significant(100.0 * ratio, 3))
        }
    };
    vec![
        label("method", method),
        label(
            "time step",
            format!(
                "{} steps; the shortest {} s",
                run.cost.steps,
                significant(shortest(run), 3)
            ),
        ),
        label(
            "duration",
            format!("{:.2} s, the record without free vibration", run.time),
        ),
        label("damping", damping),
        label(
            "damping of the first mode of wall and liquid",
            format!(
                "{} % at {} rad/s, virgin wall",
                significant(100.0 * tank.wall_ratio, 3),
                significant(tank.wall_omega, 4)
            ),
        ),
    ]
}

fn assumptions(case: &Case, options: &NonlinearOptions, tank: &CylinderModel) -> Vec<String> {
    let mut out = vec![
        "Wall of four-node shells with finite rotations, plane sections in each shell, layers and bars with the laws of the \
         input; clamped at its base, rigid bottom."
            .to_owned(),
        "Liquid of linear potential theory on the undeformed tank, condensed onto the radial displacements of the wall; gravity \
         acts on the surface in the circumferential waves 0 and 1. It stays at the wall: where the pressure of the displaced \
         particle falls below zero, the report says so."
            .to_owned(),
        "The run begins with weight and hydrostatic pressure. An unconverged step is never accepted: it is halved until it \
         converges, or the run ends as a collapse, and its numbers are lower bounds."
            .to_owned(),
        "Damping of the wall is proportional to the stiffness of the virgin wall; where the wall softens, the damping force stays \
         and the energy it takes is shown."
            .to_owned(),
    ];
    if options.follower_pressure {
        out.push("The hydrostatic pressure turns with the deformed wall; the dynamic pressure does not.".into());
    }
    if !options.self_weight {
        out.push("The wall has no weight, as asked for.".into());
    }
    if tank.cells.half {
        out.push("Motion symmetric to the plane of shaking: buckles that break this symmetry are left out.".into());
    }
    if case
        .tank
        .courses
        .iter()
        .any(|c| c.build_up().iter().any(|l| !l.reinforcement.is_empty()))
    {
        out.push(
            "Bars are smeared to layers and bonded; the concrete they displace and their mass are left out.".into(),
        );
    }
    out
}
