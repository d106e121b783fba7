//! From a case to a model of nodes and elements.
//!
//! The wall is a mantle of `shell4`, clamped at its base: a cylinder, or four plates that meet in monolithic corners. The liquid has
//! separate nodes. The bottom is rigid. All horizontal ground motion is along x.

use fem::assembly::Assembler;
use fem::chart::Chart;
use fem::dofs::Dof;
use fem::element::contact8::{Contact8, ContactLaw};
use fem::element::{
    ElementError, Fluid8, FreeSurface, LiquidProperties, Potential8, PotentialSurface, RotationPart, VolumePart,
    WetFace,
};
use fem::mesh::{Cylinder, Face, Volume};
use fem::model::{Builder, Model};
use nalgebra::Vector3;
use tank::{Case, Shape};

use super::form::Form;
use super::loaded::LoadedState;
use super::memory::allow;
use super::mesh::Division;
use super::plan::{self, Plan};
use super::wall::{WallPart, add_wall};
use crate::error::failed;
use crate::{FeError, out_of_round};
use tank::imperfection::Imperfections;
use tank::options::LinearOptions as Options;
use tank::options::solid::{Liquid, SolidOptions};
use tank::refusal::{Place, Refusal};

/// Group of the liquid's volume.
pub const LIQUID: &str = "liquid";
/// Group of the free surface.
pub const SURFACE: &str = "surface";
/// Group of the joints of liquid and wall.
pub const JOINT: &str = "joint";

/// Factor of the joint's penalty: the gap is 1 % of the liquid's own compression in the outermost element, which is small
/// itself (theory of contact).
const PENALTY: f64 = 1e2;

/// A tank as a model.
pub struct TankModel {
    /// Division it was made by.
    pub division: Division,
    /// Formulation of the liquid.
    pub liquid: Liquid,
    /// Properties of a displacement liquid.
    pub properties: LiquidProperties,
    /// The model.
    pub model: Model,
    /// Its pattern and places.
    pub assembler: Assembler,
    /// The wall.
    pub wall: WallPart,
    /// The liquid; numbers of the model.
    pub volume: Volume,
    /// Depth of the liquid [m].
    pub depth: f64,
    /// Radius, or half the length of a rectangle [m].
    pub radius: f64,
    /// Chart of the liquid: (r, θ, z) of a cylinder, (x, y, z) of a rectangle.
    pub chart: Chart,
    /// Nodes of the surface on the line of shaking, from the middle to θ = 0 and to θ = 180°; places as in the radii of the division.
    pub lines: [Vec<usize>; 2],
    /// Mirror images of all nodes at x = 0 and y = 0, of a rectangle.
    pub mirrors: Option<[Vec<usize>; 2]>,
    /// Length of the base that belongs to its node at θ = 0 [m].
    pub edge: f64,
    /// Density of the liquid [kg/m³].
    pub density: f64,
    /// Acceleration of free fall [m/s²].
    pub gravity: f64,
    /// Normal stiffness of the joint of a displacement liquid [N/m³]; 0 with a potential.
    pub joint: f64,
    /// Deviations of the wall.
    pub imperfections: Imperfections,
    /// The loaded state, if the wall moves about it.
    pub loaded: Option<LoadedState>,
}

impl TankModel {
    /// Builds the model of a case.
    ///
    /// Errors: a shape that is not modelled in three dimensions; a division out of range; an element that cannot be built.
    pub fn new(case: &Case, options: &Options, solid: &SolidOptions) -> Result<TankModel, FeError> {
        if let Some(refusal) = refused(case, solid).into_iter().next() {
            return Err(FeError::Unsupported(format!("{}; {}", refusal.message, refusal.help)));
        }
        let form = Form::of(case, &solid.imperfections);
        TankModel::formed(case, options, solid, &form)
    }

    /// The model with a wall and a liquid of this form.
    ///
    /// Errors: as [`TankModel::new`].
    pub(super) fn formed(
        case: &Case,
        options: &Options,
        solid: &SolidOptions,
        form: &Form<'_>,
    ) -> Result<TankModel, FeError> {
        let matching = solid.liquid == Liquid::Displacement;
        let depth = case.liquid.fill_height;
        let division = Division::new(&case.tank, depth, options, solid, matching)?;
        refuse_the_hopeless(&division, solid)?;
        refuse_the_unresolved(case, &division, solid)?;
        let loaded = if solid.about_loaded_state() { Some(LoadedState::new(case, &division, form)?) } else { None };
        let plan = division.plan();
        let mut builder = Builder::new();
        let mut wall = add_wall(case, &division, (plan.as_ref(), form), &mut builder)?;
        if let Some(state) = &loaded {
            wall.loaded = state.add_to(&wall, &mut builder);
        }
        let volume = add_liquid(case, &division, (plan.as_ref(), form), solid, &wall, &mut builder)?;
        let joint = match solid.liquid {
            Liquid::Displacement => joint_stiffness(case, &division),
            Liquid::Potential => 0.0,
        };
        let model = builder.build().map_err(failed)?;
        let assembler = Assembler::new(&model);
        let mirrors = match plan {
            Some(_) => {
                let liquid = wall.rows.len() * division.sectors;
                let found = plan::mirrors(model.nodes(), &[0, liquid]);
                Some(found.ok_or_else(|| failed("the mesh is not symmetric"))?)
            }
            None => None,
        };
        let radius = case.tank.shape.half_length();
        Ok(TankModel {
            lines: lines(&division, plan.as_ref(), &volume),
            edge: match &plan {
                None => 2.0 * radius * (std::f64::consts::PI / division.sectors as f64).sin(),
                // Half of the elements on both sides of the middle.
                Some(_) => division.breadth[1],
            },
            chart: chart(plan.as_ref()),
            mirrors,
            division,
            liquid: solid.liquid,
            properties: displacement_liquid(case, solid),
            model,
            assembler,
            wall,
            volume,
            depth,
            radius,
            density: case.liquid.density,
            gravity: case.gravity,
            joint,
            imperfections: if form.imperfections.is_empty() { Imperfections::NONE } else { form.imperfections.clone() },
            loaded,
        })
    }

    /// Whether the wall is a cylinder.
    pub fn is_round(&self) -> bool {
        self.mirrors.is_none()
    }

    /// Factor of the mean of the two elements next to θ = 0 on the value there, under motion of a harmonic: flat elements of a round
    /// wall see cos θ at half a sector.
    pub fn beside(&self, harmonic: u32) -> f64 {
        match harmonic {
            1 if self.is_round() => (std::f64::consts::PI / self.division.sectors as f64).cos(),
            _ => 1.0,
        }
    }

    /// Height of the wall [m].
    pub fn height(&self) -> f64 {
        self.wall.z.last().copied().unwrap_or(0.0)
    }

    /// Whether element `e` belongs to one of the groups.
    pub fn is_in(&self, e: usize, groups: &[&str]) -> bool {
        groups.contains(&self.model.groups()[self.model.group_of(e)].as_str())
    }

    /// Rings of nodes, each in the order of its angles from θ = 0, and the nodes on the axis.
    pub fn rings(&self) -> (Vec<Vec<usize>>, Vec<usize>) {
        let sectors = self.division.sectors;
        let per_level = 1 + (self.division.radii.len() - 1) * sectors;
        let mut rings = self.wall.rows.clone();
        for level in 0..self.division.liquid.len() {
            let first = self.volume.axis[0] + level * per_level + 1;
            rings.extend((0..self.division.radii.len() - 1).map(|r| {
                let start = first + r * sectors;
                (start..start + sectors).collect()
            }));
        }
        (rings, self.volume.axis.clone())
    }
}

/// What the engine does not model of a rectangular tank.
pub fn refused(case: &Case, solid: &SolidOptions) -> Vec<Refusal> {
    let mut found: Vec<Refusal> = penalty_of_potential(solid).into_iter().collect();
    let Shape::Rectangle { strip, .. } = case.tank.shape else { return found };
    if strip {
        let message = "the three-dimensional engine models boxes with four walls, not a strip of a long tank";
        let refusal = Refusal::new(Place::Shape, message, "a rectangle with its breadth");
        found.push(refusal.help("use --fe harmonic for a strip, or give tank.breadth in place of tank.strip"));
    }
    if !solid.imperfections.is_empty() {
        let message = "a box is computed with plane walls";
        let refusal = Refusal::new(Place::Imperfections, message, "no imperfections of a rectangle");
        found.push(refusal.help("remove analysis.imperfections"));
    }
    if solid.liquid == Liquid::Displacement {
        let message = "the three-dimensional engine models the liquid of a box by its potential only";
        let refusal = Refusal::new(Place::Liquid, message, "\"potential\"").found("\"displacement\"");
        found.push(refusal.help("use --liquid potential"));
    }
    found
}

/// The refusal of a penalty beside a liquid without rotation.
fn penalty_of_potential(solid: &SolidOptions) -> Option<Refusal> {
    let without = solid.rotation_penalty.filter(|_| solid.liquid == Liquid::Potential);
    without.map(|_| {
        let message = "a liquid by its potential does not rotate: it has no rotation penalty";
        let refusal = Refusal::new(Place::RotationPenalty, message, "no rotation_penalty with liquid \"potential\"");
        refusal.help("use --liquid displacement, or remove analysis.solid.rotation_penalty")
    })
}

/// Chart of the liquid.
fn chart(plan: Option<&Plan>) -> Chart {
    match plan {
        Some(_) => Chart::Cartesian,
        None => Chart::Cylindrical,
    }
}

/// Nodes of the surface on the line of shaking.
fn lines(division: &Division, plan: Option<&Plan>, volume: &Volume) -> [Vec<usize>; 2] {
    let places = match plan {
        Some(plan) => plan.lines(),
        None => [0, division.sectors / 2].map(|sector| {
            let ring = |ring: usize| match ring {
                0 => 0,
                ring => 1 + (ring - 1) * division.sectors + sector,
            };
            (0..division.radii.len()).map(ring).collect()
        }),
    };
    places.map(|side| side.into_iter().map(|k| volume.surface_nodes[k]).collect())
}

/// Errors: imperfections that the mesh does not resolve, or beside a liquid that does not follow them.
fn refuse_the_unresolved(case: &Case, division: &Division, solid: &SolidOptions) -> Result<(), FeError> {
    let mesh = (division.sectors, division.wall.len() - 1);
    match unresolved(case, solid, mesh) {
        Some(refusal) => Err(FeError::option("analysis.imperfections", refusal.found, refusal.allowed)),
        None => Ok(()),
    }
}

/// The refusal of imperfections on a mesh of so many sectors and rows, or beside a liquid that does not follow them.
pub(super) fn unresolved(case: &Case, solid: &SolidOptions, mesh: (usize, usize)) -> Option<Refusal> {
    if solid.liquid == Liquid::Displacement && !solid.imperfections.is_empty() {
        let refusal = Refusal::new(
            Place::Imperfections,
            "the displacement liquid does not follow an imperfect wall",
            "analysis.solid.liquid \"potential\" with imperfections",
        );
        return Some(refusal.found("analysis.solid.liquid \"displacement\""));
    }
    let help = match solid.mesh {
        Some(_) => "give more sectors in --mesh or analysis.solid.mesh",
        None => "refine the mesh with --refine or analysis.refine",
    };
    out_of_round::resolved(&solid.imperfections, &case.tank, mesh, help)
}

/// Least memory of an unknown with its matrices and factors [bytes]: below the need of the smallest models (3.7 kB); the factor
/// of a larger one needs more for each unknown.
const LEAST_BYTES: f64 = 2048.0;

/// Refuses a mesh that cannot fit, before its nodes and elements fill the memory themselves.
///
/// Errors: more unknowns than the allowed memory holds at `LEAST_BYTES` each.
fn refuse_the_hopeless(division: &Division, solid: &SolidOptions) -> Result<(), FeError> {
    let ring = division.sectors as f64;
    let plan = match division.breadth.len().saturating_sub(1) {
        0 => (division.radii.len() - 1) as f64 * ring,
        half => 4.0 * (division.radii.len() - 1) as f64 * half as f64,
    };
    let liquid = plan * division.liquid.len() as f64;
    let unknowns_of_liquid = match solid.liquid {
        Liquid::Displacement => 3.0,
        Liquid::Potential => 1.0,
    };
    let unknowns = unknowns_of_liquid * liquid + 5.0 * ring * (division.wall.len() - 1) as f64;
    allow((unknowns * LEAST_BYTES) as u64, solid.memory_limit_mib << 20)
}

fn add_liquid(
    case: &Case,
    division: &Division,
    (plan, form): (Option<&Plan>, &Form<'_>),
    solid: &SolidOptions,
    wall: &WallPart,
    builder: &mut Builder,
) -> Result<Volume, FeError> {
    let mesh = Cylinder { radii: division.radii.clone(), sectors: division.sectors, heights: division.liquid.clone() };
    let chart = chart(plan);
    let mut volume = match plan {
        Some(plan) => plan.volume(&division.liquid),
        None => mesh.volume(),
    }
    .map_err(failed)?;
    form.deform(&mut volume);
    let first = builder.nodes(&volume.nodes);
    shift(&mut volume, first);
    let (density, gravity) = (case.liquid.density, case.gravity);
    match solid.liquid {
        Liquid::Potential => {
            for cell in &volume.cells {
                let element = Potential8::new(cell, chart, density).map_err(failed)?;
                builder.element(LIQUID, element);
            }
            for face in &volume.surface {
                let element = PotentialSurface::new(face, chart, density, gravity).map_err(failed)?;
                builder.element(SURFACE, element);
            }
            join_potential(division, &volume, (wall, form), (density, chart), builder).map_err(failed)?;
        }
        Liquid::Displacement => {
            let liquid = displacement_liquid(case, solid);
            for cell in &volume.cells {
                let element = Fluid8::new(cell, Chart::Cylindrical, liquid).map_err(failed)?;
                builder.element(LIQUID, element);
            }
            for face in &volume.surface {
                // The lift of a node is that of the volume part's quadrature.
                let element = match liquid.volume {
                    VolumePart::OnePoint => FreeSurface::at_one_point(face, Chart::Cylindrical, density * gravity),
                    VolumePart::Full | VolumePart::MeanDilatation => {
                        FreeSurface::new(face, Chart::Cylindrical, density * gravity)
                    }
                };
                builder.element(SURFACE, element.map_err(failed)?);
            }
            // The bottom is rigid; the liquid slides on it.
            for &node in &volume.bottom_nodes {
                builder.hold(node, Dof::Uz);
            }
            let law = ContactLaw::bonded(joint_stiffness(case, division));
            for (face, wall) in volume.wall.iter().zip(&wall.faces) {
                let normals = face.chart.map(|c| [c[1].cos(), c[1].sin(), 0.0]);
                let joint =
                    Contact8::new(face, Chart::Cylindrical, wall.nodes, face.nodes, normals, law).map_err(failed)?;
                builder.element(JOINT, joint);
            }
        }
    }
    Ok(volume)
}

/// Properties of the displacement liquid of a case: bulk modulus of the case or of water; uncalibrated, or with the penalty of the user and
/// the quadratures of [B02, 5.3.1.4].
pub(super) fn displacement_liquid(case: &Case, solid: &SolidOptions) -> LiquidProperties {
    let radius = case.tank.shape.half_length();
    let own = LiquidProperties::new(case.liquid.density, case.liquid.compression_modulus(), case.gravity, radius);
    match solid.rotation_penalty {
        Some(penalty) => {
            LiquidProperties { volume: VolumePart::OnePoint, rotation: RotationPart::Full(penalty), ..own }
        }
        None => own,
    }
}

/// Normal stiffness of the joint between displacement liquid and wall [N/m³]: `PENALTY` times the larger of K/h of the
/// liquid's outermost elements and E t/R² of the wall.
pub fn joint_stiffness(case: &Case, division: &Division) -> f64 {
    let n = division.radii.len();
    let thickness = division.radii[n - 1] - division.radii[n - 2];
    let radius = case.tank.shape.half_length();
    let wall = |c: &tank::Course| c.material.youngs_modulus * c.thickness / (radius * radius);
    PENALTY * case.tank.courses.iter().map(wall).fold(case.liquid.compression_modulus() / thickness, f64::max)
}

/// Wetted faces of liquid and wall, sector by sector, wherever they overlap.
fn join_potential(
    division: &Division,
    volume: &Volume,
    (wall, form): (&WallPart, &Form<'_>),
    (density, chart): (f64, Chart),
    builder: &mut Builder,
) -> Result<(), ElementError> {
    let sectors = division.sectors;
    for (k, liquid) in volume.wall.iter().enumerate() {
        // Faces of the liquid run sector by sector within a level, those of the wall too.
        let (level, sector) = (k / sectors, k % sectors);
        let (low, high) = (division.liquid[level], division.liquid[level + 1]);
        for (l, z) in wall.z.windows(2).enumerate() {
            if z[1] <= low || z[0] >= high {
                continue;
            }
            let face = &wall.faces[l * sectors + sector];
            let normals = match chart {
                Chart::Cylindrical => face.chart.map(|c| [c[1].cos(), c[1].sin(), 0.0]),
                Chart::Cartesian => [normal(face); 4],
            };
            if let Some(joint) = WetFace::overlapping(liquid, face, chart, normals, density)? {
                let joint = match form.area_vectors(face) {
                    Some(vectors) => joint.with_area_vectors(vectors),
                    None => joint,
                };
                builder.element(JOINT, joint);
            }
        }
    }
    Ok(())
}

/// Unit normal of a face of a plane wall, outwards.
fn normal(face: &Face) -> [f64; 3] {
    let p = face.chart.map(Vector3::from);
    (p[2] - p[0]).cross(&(p[3] - p[1])).normalize().into()
}

/// Adds `first` to all node numbers of a volume.
fn shift(volume: &mut Volume, first: usize) {
    volume.cells.iter_mut().flat_map(|c| &mut c.nodes).for_each(|n| *n += first);
    let faces = volume.wall.iter_mut().chain(&mut volume.bottom).chain(&mut volume.surface);
    faces.flat_map(|f| &mut f.nodes).for_each(|n| *n += first);
    let lists = volume.wall_nodes.iter_mut().flatten().chain(&mut volume.axis);
    lists.chain(&mut volume.bottom_nodes).chain(&mut volume.surface_nodes).for_each(|n| *n += first);
}
