//! Wall, liquid and loads of a cylinder as a model.
//!
//! ```text
//! layered shells, or two with a layer between them   ─┐
//! liquid condensed onto radial displacements w and sloshing amplitudes q   ├─ M ü + C u̇ + f_int(u) = p_c − M ι a_g
//! hydrostatic pressure that rotates with the wall, weight, roof, rings       ─┘
//! ```
//!
//! The liquid is that of linear theory ([`fem::liquid::HarmonicLiquid`]): a dense block on the wetted radial displacements.
//! All other unknowns are eliminated before them, so that the block is factored once an iteration and all other blocks are sparse.
//! Horizontal ground motion is along x; with `symmetry` only 0 ≤ θ ≤ π is there.

mod damping;
mod order;
mod statics;

use std::collections::BTreeMap;
use std::sync::Arc;

use fem::analysis::damping::Rayleigh;
use fem::analysis::march::Problem;
use fem::analysis::system::System;
use fem::analysis::zone::Zone;
use fem::assembly::Assembler;
use fem::dofs::Dof;
use fem::element::interlayer;
use fem::element::shell::load::NodalLoads;
use fem::element::shell4::MassKind;
use fem::element::wall::place::{Footprint, PlacedWall, WallMesh};
use fem::linalg::Symbolic;
use fem::liquid::WallLiquid;
use fem::model::{Builder, Model};
use nalgebra::{Matrix3, Vector3};
use tank::Case;
use tank::Shape;

use super::contact::{Join, Joints};
use super::elements::{WALL, add_liquid, add_roof, build_rows, fit, iterates, penalty, pressures, support};
use super::floor::{FLOOR, LiquidFloor};
use super::mesh::Cells;
use super::rings::name_rings;
use super::section::RowBuild;
use super::slab::{Founded, MovingSlab};
use super::standing::{self, ANCHOR, Standing};
use crate::error::failed;
use crate::nonlinear::bottom::{BOTTOM, GROUND, Plate};
use crate::{FeError, out_of_round};
use tank::imperfection::Imperfections;
use tank::options::nonlinear::{Contact, NonlinearOptions};

/// Groups whose tangents are renewed with the contact.
const ZONE: [&str; 4] = [BOTTOM, GROUND, FLOOR, ANCHOR];

/// Modes of harmonic 1 that count for the wave at the wall, as in the linear engines: more only chase the singularity at the
/// contact line.
const WAVE_MODES: usize = 5;
/// Relative difference of two frequencies that are one.
const SAME: f64 = 1e-6;

/// The model, built once; runs only read it.
pub(crate) struct CylinderModel {
    /// Cells of the wall.
    pub cells: Cells,
    /// Points of the wall.
    pub footprint: Footprint,
    /// Where they went.
    pub wall: PlacedWall,
    /// Section of each row.
    pub rows: Vec<RowBuild>,
    /// Nodes and elements.
    pub model: Model,
    /// Its assembler.
    pub assembler: Assembler,
    /// Order of elimination.
    pub symbolic: Arc<Symbolic>,
    /// Mass and initial stiffness of the tank, with the damping.
    pub system: System,
    /// Rayleigh's coefficients by group.
    pub rayleigh: Vec<Rayleigh>,
    /// Forces of the weight.
    pub weight: Vec<f64>,
    /// Forces of the hydrostatic pressure on the undeformed wall.
    pub pressure: Vec<f64>,
    /// Node of each wetted radial displacement of the liquid, level by level from the base: the wall's own unless the two are
    /// joined.
    pub wetted: Vec<usize>,
    /// Joints of liquid and wall, where it may open.
    pub joints: Option<Joints>,
    /// The bottom under an unanchored wall.
    pub standing: Option<Standing>,
    /// Its part of the systems of equations: plate and ground.
    pub zone: Option<Arc<Zone>>,
    /// The liquid's floor over that bottom.
    pub floor: Option<LiquidFloor>,
    /// The slab that moves on soil.
    pub slab: Option<MovingSlab>,
    /// Area of the wall that belongs to each of them [m²].
    pub areas: Vec<f64>,
    /// The liquid.
    pub liquid: WallLiquid,
    /// Equations of the sloshing amplitudes.
    pub amplitudes: Vec<usize>,
    /// ω of the first mode of wall and liquid in which the tank moves sideways, the surface free of pressure [rad/s].
    pub wall_omega: f64,
    /// ω of the first sloshing mode in the direction of shaking [rad/s].
    pub sloshing_omega: f64,
    /// Damping ratio of the first mode of wall and liquid.
    pub wall_ratio: f64,
    /// Radius [m].
    pub radius: f64,
    /// Depth of the liquid [m].
    pub depth: f64,
    /// Unit weight of the liquid [N/m³].
    pub unit_weight: f64,
    /// g [m/s²].
    pub gravity: f64,
    /// Deviations of the wall; the liquid is that of the perfect cylinder.
    pub imperfections: Imperfections,
}

/// The points and normals of an imperfect wall; `None` of a perfect one.
fn shape(case: &Case, imperfections: &Imperfections, radius: f64, perfect: &Footprint) -> Option<Footprint> {
    if imperfections.is_empty() {
        return None;
    }
    let mut out = perfect.clone();
    for (point, normal) in out.points.iter_mut().zip(&mut out.normals) {
        let theta = point[1].atan2(point[0]);
        let deviation = imperfections.at(theta, point[2], case.tank.wall_height());
        let (offset, direction) = out_of_round::place(radius, theta, deviation);
        *point = (Vector3::from(*point) + offset).into();
        *normal = direction.normalize().into();
    }
    Some(out)
}

/// Distance of the two shells of a wall [m]; 0 of one shell.
///
/// Errors: another distance from course to course.
fn gap(rows: &[RowBuild], radius: f64) -> Result<f64, FeError> {
    let gap = rows.first().map_or(0.0, |r| r.gap);
    match rows.iter().any(|r| (r.gap - gap).abs() > 1e-9 * radius) {
        true => Err(FeError::Unsupported(
            "the nonlinear engine models walls of two shells whose distance is the same in all courses".into(),
        )),
        false => Ok(gap),
    }
}

/// Nodes of the liquid's face: those of the wall's inner face, or others at the same places.
fn wet_face(builder: &mut Builder, inner: &[usize], contact: Contact) -> Vec<usize> {
    let mut own = |&n: &usize| {
        let at = builder.position(n);
        builder.node(at)
    };
    match contact {
        Contact::Bonded => inner.to_vec(),
        Contact::Opening => inner.iter().map(&mut own).collect(),
    }
}

/// Gives the nodes of liquid and wall at these points their radial frames.
fn turn_radially(builder: &mut Builder, [wetted, inner]: [&[usize]; 2], points: &[usize], footprint: &Footprint) {
    for ((&wet, &own), &point) in wetted.iter().zip(inner).zip(points) {
        let [c, s, _] = footprint.normals[point];
        let radial = Matrix3::new(c, s, 0.0, -s, c, 0.0, 0.0, 0.0, 1.0);
        builder.frame(wet, radial);
        if wet != own {
            builder.frame(own, radial);
        }
    }
}

/// Plate and ground as a part of the systems of equations.
fn ground_zone(model: &Model, assembler: &Assembler) -> Result<Arc<Zone>, FeError> {
    let named = |e: usize| ZONE.contains(&model.groups()[model.group_of(e)].as_str());
    Ok(Arc::new(Zone::new(model, assembler, named).map_err(failed)?))
}

/// ω of the first sloshing mode of harmonic 1 [rad/s]; 0 without one.
pub(super) fn first_sloshing(liquid: &WallLiquid) -> f64 {
    let first = liquid.rim().iter().position(|r| r.harmonic == 1);
    (0..liquid.omega().len())
        .find(|&j| first.is_some_and(|r| liquid.rim()[r].row[liquid.wall() + j].abs() > 1e-9))
        .map_or(0.0, |j| liquid.omega()[j])
}

/// Adds the shells of the wall, on its bottom plate if it stands on one.
///
/// Errors: another distance of two shells from course to course; those of the elements.
fn place_wall(
    builder: &mut Builder,
    case: &Case,
    options: &NonlinearOptions,
    (radius, rows): (f64, &[RowBuild]),
    footprint: &Footprint,
    plate: Option<&Plate>,
) -> Result<(PlacedWall, Option<Standing>), FeError> {
    let shape = shape(case, &options.imperfections, radius, footprint);
    let mesh = WallMesh {
        footprint: shape.as_ref().unwrap_or(footprint),
        courses: &|row| rows[row].build.clone(),
        offsets: [0.0, gap(rows, radius)?],
        name: WALL,
        mass: MassKind::Consistent,
    };
    match plate {
        None => Ok((mesh.place(builder).map_err(failed)?, None)),
        Some(plate) => {
            let (wall, standing) = Standing::weld(plate, case, builder, &mesh, options)?;
            Ok((wall, Some(standing)))
        }
    }
}

/// Wall, liquid and bottom in a builder.
struct Parts {
    radius: f64,
    cells: Cells,
    rows: Vec<RowBuild>,
    footprint: Footprint,
    wall: PlacedWall,
    /// Wetted points of the wall, and the node of the liquid at each.
    points: Vec<usize>,
    wetted: Vec<usize>,
    joints: Option<Joints>,
    standing: Option<Standing>,
    floor: Option<LiquidFloor>,
    /// A slab on soil, with the liquid over its floor that turns.
    founded: Option<(Founded, WallLiquid)>,
    liquid: WallLiquid,
    /// Number of its element, and whether that is not assembled.
    liquid_element: usize,
    operator: bool,
    /// Nodes of the sloshing amplitudes.
    amplitudes: Vec<usize>,
    /// Loads of the hydrostatic pressure, and of a pressure of 1.
    pressure: NodalLoads,
    areas: NodalLoads,
}

impl Parts {
    /// Errors: a tank that is not a cylinder; an unsupported wall, law or option; parameters out of range.
    fn place(
        builder: &mut Builder,
        case: &Case,
        options: &NonlinearOptions,
        iterates: impl Fn(usize) -> bool,
    ) -> Result<Parts, FeError> {
        let Shape::Cylinder { radius } = case.tank.shape else {
            return Err(FeError::Unsupported("the tank is not a cylinder".into()));
        };
        let (depth, unit_weight) = (case.liquid.fill_height, case.liquid.density * case.gravity);
        let cells = Cells::new(&case.tank, depth, options.elements, options.symmetry);
        let rows = build_rows(case, &cells, radius, options)?;
        let footprint = Footprint::cylinder(radius, cells.columns(), [0.0, cells.span()], &cells.z).map_err(failed)?;
        let plate = standing::plate(case, options, radius)?;
        let (wall, mut standing) = place_wall(builder, case, options, (radius, &rows), &footprint, plate.as_ref())?;
        support(builder, &footprint, &wall, &cells, plate.is_some());
        fit(case, builder, &footprint, &wall, &cells)?;
        if case.tank.roof.mass > 0.0 {
            add_roof(case, builder, &footprint, &wall, &cells);
        }
        let wet = cells.wet(depth);
        let points: Vec<usize> = footprint.levels[..wet].iter().flatten().copied().collect();
        let inner: Vec<usize> = points.iter().map(|&p| wall.inner[p]).collect();
        let wetted = wet_face(builder, &inner, options.contact);
        turn_radially(builder, [&wetted, &inner], &points, &footprint);
        let operator = iterates(wetted.len());
        let floor = plate.as_ref().map(|plate| LiquidFloor::over(plate, builder, footprint.levels[0].len()));
        if operator {
            name_rings(builder, &footprint, &wall, &wetted, &cells, floor.as_ref())?;
        }
        if options.contact == Contact::Opening {
            for &node in &wetted[..footprint.levels[0].len()] {
                builder.hold(node, Dof::Ux);
            }
        }
        let (liquid, amplitudes, liquid_element) =
            add_liquid(case, builder, &cells, &wetted, options, (operator, floor.as_ref()))?;
        let join = Join {
            footprint: &footprint,
            wall: &wall,
            nodes: [&inner, &wetted],
            amplitudes: &amplitudes,
            liquid: &liquid,
            gravity: case.gravity,
            depth,
            unit_weight,
            penalty: penalty(case, radius),
        };
        let joints = (options.contact == Contact::Opening).then(|| join.add_to(builder)).transpose()?;
        let pressed: BTreeMap<usize, usize> = inner.iter().copied().zip(wetted.iter().copied()).collect();
        let (mut pressure, areas) =
            pressures(builder, &footprint, &wall, &cells, [unit_weight, depth], &pressed, options);
        if let (Some(plate), Some(standing), Some(floor)) = (&plate, &mut standing, &floor) {
            standing.found(plate, case, builder, options, &mut pressure)?;
            standing.wet(plate, builder, floor, operator)?;
        }
        let founded = match plate {
            Some(_) => None,
            None => Founded::place(case, builder, (&cells, radius), (&liquid, operator))?,
        };
        Ok(Parts {
            radius,
            cells,
            rows,
            footprint,
            wall,
            points,
            wetted,
            joints,
            standing,
            floor,
            founded,
            liquid,
            liquid_element,
            operator,
            amplitudes,
            pressure,
            areas,
        })
    }
}

impl CylinderModel {
    /// The model of a case.
    ///
    /// Errors: a tank that is not a cylinder; an unsupported wall, law or option; parameters out of range.
    pub(crate) fn new(case: &Case, options: &NonlinearOptions) -> Result<CylinderModel, FeError> {
        // Contact with the ground takes every step of an iteration, as that of an opening joint does: a wall on its bottom has factors.
        let stands = standing::stands(case, options);
        CylinderModel::in_form(case, options, |wetted| stands || iterates(wetted, options.contact))
    }

    /// The model with the liquid as an operator if `iterates(wetted nodes)`; on a bottom a block asks for a factor of the whole in every
    /// iteration.
    pub(super) fn in_form(
        case: &Case,
        options: &NonlinearOptions,
        iterates: impl Fn(usize) -> bool,
    ) -> Result<CylinderModel, FeError> {
        let mut builder = Builder::new();
        let parts = Parts::place(&mut builder, case, options, iterates)?;
        let model = builder.build().map_err(failed)?;
        interlayer::check(&model).map_err(failed)?;
        let assembler = Assembler::new(&model);
        let zone = match &parts.standing {
            Some(_) if parts.operator => Some(ground_zone(&model, &assembler)?),
            _ => None,
        };
        let symbolic = order::symbolic(&model, &assembler, parts.liquid_element)?;
        let system = System::new(&model, &assembler).map_err(failed)?;
        let weight = match options.self_weight {
            true => assembler.body_force(&model, [0.0, 0.0, -case.gravity]),
            false => vec![0.0; model.dofs().len()],
        };
        let amplitudes =
            { parts.amplitudes.iter() }.filter_map(|&n| model.dofs().equation(n, Dof::Amplitude)).collect();
        let radial = |(&node, &point): (&usize, &usize)| {
            let [c, s, _] = parts.footprint.normals[point];
            let load = parts.areas.at(node);
            c * load[0] + s * load[1]
        };
        let areas = parts.wetted.iter().zip(&parts.points).map(radial).collect();
        let pressure = parts.pressure.vector(&model);
        let mut out = CylinderModel {
            cells: parts.cells,
            footprint: parts.footprint,
            wall: parts.wall,
            rows: parts.rows,
            rayleigh: vec![Rayleigh::NONE; model.groups().len()],
            model,
            assembler,
            symbolic,
            system,
            weight,
            pressure,
            wetted: parts.wetted,
            joints: parts.joints,
            standing: parts.standing,
            zone,
            floor: parts.floor,
            slab: None,
            areas,
            sloshing_omega: first_sloshing(&parts.liquid),
            liquid: parts.liquid,
            amplitudes,
            wall_omega: 0.0,
            wall_ratio: 0.0,
            radius: parts.radius,
            depth: case.liquid.fill_height,
            unit_weight: case.liquid.density * case.gravity,
            gravity: case.gravity,
            imperfections: match options.imperfections.is_empty() {
                true => Imperfections::NONE,
                false => options.imperfections.clone(),
            },
        };
        out.wall_omega = out.damped_mode(case, options)?;
        if let Some((founded, over_floor)) = parts.founded {
            MovingSlab::install(&mut out, founded, &over_floor);
        }
        out.set_damping(options.damping)?;
        Ok(out)
    }

    /// Whether there are joints that open.
    pub(crate) fn contact(&self) -> bool {
        self.joints.is_some() || self.standing.is_some()
    }

    /// The problem to be integrated.
    pub(crate) fn problem(&self) -> Problem<'_> {
        Problem { model: &self.model, assembler: &self.assembler, symbolic: &self.symbolic, system: &self.system }
    }

    /// Forces of weight and hydrostatic pressure.
    pub(crate) fn constant(&self) -> Vec<f64> {
        self.weight.iter().zip(&self.pressure).map(|(w, p)| w + p).collect()
    }

    /// Row of the surface's elevation at the wall, over its rim on a slab that turns, at the angle θ [rad]: of harmonic 0 whole, of harmonic 1 the first modes. Cosine and
    /// sine of a mode have one frequency, and their amplitudes may be mixed: frequencies are counted.
    pub(crate) fn elevation(&self, theta: f64) -> Vec<(usize, f64)> {
        let wall = self.liquid.wall();
        let mut row = vec![0.0; wall + self.amplitudes.len()];
        for rim in self.liquid.rim() {
            let (s, c) = (f64::from(rim.harmonic) * theta).sin_cos();
            let sine = |k: usize| rim.sine.get(k).copied().unwrap_or(0.0);
            let (mut counted, mut last) = (0, 0.0);
            for (k, (to, cosine)) in row.iter_mut().zip(&rim.row).enumerate() {
                let amplitude = k >= wall && (cosine.abs() > 1e-9 || sine(k).abs() > 1e-9);
                if amplitude && (self.liquid.omega()[k - wall] / last - 1.0).abs() > SAME {
                    (counted, last) = (counted + 1, self.liquid.omega()[k - wall]);
                }
                if rim.harmonic == 0 || (amplitude && counted <= WAVE_MODES) {
                    *to += c * cosine + s * sine(k);
                }
            }
        }
        let unknowns = self.liquid_unknowns();
        let of = |(e, c): (&Option<usize>, &f64)| e.filter(|_| *c != 0.0).map(|e| (e, *c));
        let rim = self.slab.iter().flat_map(|slab| slab.rim(theta));
        unknowns.iter().zip(&row).filter_map(of).chain(rim).collect()
    }

    /// Equations of the liquid's unknowns, in its order; none where a support holds the wall.
    pub(crate) fn liquid_unknowns(&self) -> Vec<Option<usize>> {
        let dofs = self.model.dofs();
        let wall = self.wetted.iter().map(|&n| dofs.equation(n, Dof::Ux));
        let floor = self.floor.iter().flat_map(|floor| &floor.nodes);
        let floor = floor.map(|&n| dofs.equation(n, Dof::Amplitude));
        wall.chain(floor).chain(self.amplitudes.iter().map(|&e| Some(e))).collect()
    }
}
