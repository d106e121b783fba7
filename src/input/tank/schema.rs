//! Mirror of `tank.json`: every key once, with the text that explains it to users (JSON Schema, editors, `init`).
//!
//! Keys and meaning are a contract: extend freely, do not rename.

use std::borrow::Cow;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};

use super::behaviour::{Behaviour, Rule};
use super::read::{
    Field, FromNode, ObjectReader, ObjectSchema, choice, list, nearest, object, prose, wrong_kind, wrong_value,
};
use super::reported::{Measured, QuantityId, Raw};
use super::syntax::{Kind, Node};
use super::values::{
    Acceleration, Density, Force, InG, Length, LineArea, LineForce, Mass, Mesh, Named, Number, Pitch, Seconds, Stress,
    Time, Whole,
};
use crate::input::diagnostic::Faults;

object! {
    /// A liquid storage tank to be verified for earthquakes.
    ///
    /// Every value with a dimension is a text with its unit, such as "1.83 m"; bare numbers are dimensionless. Comments
    /// and trailing commas are allowed.
    TankFile {
        /// Title of the report.
        name: Field<String>,
        /// Remarks for the report, free text.
        notes: Option<Field<String>>,
        /// Acceleration of free fall, from 0.1 to 100 m/s2; 9.80665 m/s2 unless given.
        gravity: Option<Field<Acceleration>>,
        /// The tank.
        tank: Field<Tank>,
        /// The stored liquid.
        liquid: Field<Liquid>,
        /// Materials by name.
        materials: Field<Named<Material>>,
        /// What to do to the accelerogram given with --quake.
        record: Option<Field<Record>>,
        /// Damping ratios, as fractions of critical damping.
        damping: Option<Field<Damping>>,
        /// Site data for design spectra, one object for each code.
        site: Option<Field<Site>>,
        /// Choices within the code procedures.
        procedures: Option<Field<Procedures>>,
        /// Options of the finite-element analysis.
        analysis: Option<Field<Analysis>>,
        /// Measured values to stand beside the computed ones, by quantity.
        measured: Option<Field<Measured>>,
        /// Values others have published for this tank.
        published: Option<Field<Vec<Field<Published>>>>,
    }

    /// An upright tank on the ground.
    Tank {
        /// Plan shape.
        shape: Field<Shape>,
        /// Inner radius of a cylinder.
        radius: Option<Field<Length>>,
        /// Inner length of a rectangle in the direction of shaking (the whole length).
        length: Option<Field<Length>>,
        /// Inner breadth of a rectangle across the direction of shaking. Give either this or strip.
        breadth: Option<Field<Length>>,
        /// True for a strip 1 m wide of a long rectangular tank (plane strain); results are per metre of breadth.
        strip: Option<Field<bool>>,
        /// How the wall stands on the ground.
        support: Field<Support>,
        /// Rings of the wall with constant thickness, from the base up. Their heights add up to the height of the wall.
        courses: Field<Vec<Field<Course>>>,
        /// Mass on top of the wall; none unless given.
        roof: Option<Field<Roof>>,
        /// Bottom plate under the wall, needed by the anchorage and uplift checks.
        bottom: Option<Field<Bottom>>,
        /// Anchor bolts, needed by the anchorage checks.
        anchors: Option<Field<Anchors>>,
    }

    /// A ring of the wall.
    Course {
        /// Height of the ring.
        height: Field<Length>,
        /// Thickness of the wall. Give either this with a material, or layers.
        thickness: Option<Field<Length>>,
        /// Name of its material.
        material: Option<Field<String>>,
        /// Layers of the wall from inside to outside, instead of one thickness and material.
        ///
        /// A shell; shells that touch (a liner on concrete); or two shells with an interlayer between them.
        layers: Option<Field<Vec<Field<Layer>>>>,
    }

    /// A layer of the wall.
    Layer {
        /// What it is.
        kind: Field<LayerKind>,
        /// Thickness of the layer.
        thickness: Field<Length>,
        /// Name of its material.
        material: Field<String>,
        /// Layers of bars in a concrete shell; nonlinear analysis only.
        reinforcement: Option<Field<Vec<Field<Reinforcement>>>>,
    }

    /// A layer of bars. Give its distance either from the inner or from the outer face of the shell.
    Reinforcement {
        /// Direction of the bars.
        direction: Field<BarDirection>,
        /// Area of steel per metre of wall.
        area: Field<LineArea>,
        /// Distance of the axis of the bars from the inner face of their shell.
        from_inner: Option<Field<Length>>,
        /// Distance of the axis of the bars from the outer face of their shell.
        from_outer: Option<Field<Length>>,
        /// Name of their material.
        material: Field<String>,
    }

    /// Mass on top of the wall.
    Roof {
        /// Mass of the roof with what it carries.
        mass: Field<Mass>,
        /// Height of its centre of mass above the tank bottom, not below the liquid; the top of the wall unless given.
        height: Option<Field<Length>>,
    }

    /// Bottom plate under the wall.
    Bottom {
        /// Thickness of the bottom plate (of the annular plate, where there is one).
        thickness: Field<Length>,
        /// Name of its material.
        material: Field<String>,
    }

    /// Anchor bolts.
    Anchors {
        /// Number of anchors around the circumference.
        count: Field<Whole>,
        /// Design tension capacity of one anchor.
        capacity: Option<Field<Force>>,
    }

    /// The stored liquid.
    Liquid {
        /// Density.
        density: Field<Density>,
        /// Depth of the liquid above the tank bottom.
        fill_height: Field<Length>,
    }

    /// A material. Its elastic values serve the code procedures and the linear engines; its behaviour beyond them the
    /// nonlinear engine.
    Material {
        /// Grade that supplies what is not given here, such as "C30/37", "B35", "S355" or "BSt500".
        grade: Option<Field<String>>,
        /// Young's modulus; needed unless a grade supplies it or the material is an interlayer with e_normal.
        youngs_modulus: Option<Field<Stress>>,
        /// Poisson's ratio, from 0 to below 0.5; needed unless a grade supplies it or the material is an interlayer with
        /// e_normal.
        poisson_ratio: Option<Field<Number>>,
        /// Density; needed unless a grade supplies it. Usual for walls are 500 to 20000 kg/m3.
        density: Option<Field<Density>>,
        /// Yield strength (characteristic), needed by the stability and anchorage checks. Usual is up to 2 GPa and up to 1 % of
        /// Young's modulus (plastics: 5 %); more than a tenth of it is refused.
        yield_strength: Option<Field<Stress>>,
        /// Allowable design stress S_d (API 650 table 5-2), needed by the API hoop-stress check.
        allowable_stress: Option<Field<Stress>>,
        /// What the material does beyond its elastic range; that of the grade unless given, elastic without a grade.
        behaviour: Option<Field<Behaviour>>,
    }

    /// What a material does beyond its elastic range. Give one of them.
    BehaviourKinds {
        /// Steel that yields.
        steel: Option<Field<SteelBehaviour>>,
        /// Concrete that cracks and crushes.
        concrete: Option<Field<ConcreteBehaviour>>,
        /// Bars in concrete.
        reinforcement: Option<Field<BarBehaviour>>,
        /// Elastic layer between two shells.
        interlayer: Option<Field<InterlayerBehaviour>>,
    }

    /// Steel that yields: von Mises, linear hardening.
    SteelBehaviour {
        /// Yield strength of the law; yield_strength of the material unless given.
        yield_strength: Option<Field<Stress>>,
        /// Slope of the stress-strain line beyond yielding; 0 unless given here or by a grade. Give either this or
        /// hardening_modulus.
        tangent_modulus: Option<Field<Stress>>,
        /// Slope of the stress against the plastic strain.
        hardening_modulus: Option<Field<Stress>>,
        /// Share of kinematic hardening, from 0 (isotropic) to 1 (kinematic); 1 unless given.
        kinematic_share: Option<Field<Number>>,
        /// Tensile strength: larger stresses are reported. No limit unless given here or by a grade.
        ultimate_strength: Option<Field<Stress>>,
    }

    /// Concrete that cracks and crushes. Give at most one of fracture_energy, softening_strain and brittle.
    ConcreteBehaviour {
        /// Law; cracked unless given.
        law: Option<Field<ConcreteLaw>>,
        /// Uniaxial compressive strength; needed unless a grade supplies it.
        compressive_strength: Option<Field<Stress>>,
        /// Biaxial over uniaxial compressive strength; 1.16 unless given.
        biaxial_ratio: Option<Field<Number>>,
        /// Tensile strength; needed unless a grade supplies it.
        tensile_strength: Option<Field<Stress>>,
        /// Energy of a crack per area, such as "140 N/m"; 73 N/m times the mean compressive strength in MPa to the power 0.18
        /// unless given (fib Model Code 2010).
        fracture_energy: Option<Field<LineForce>>,
        /// Strain over which the tensile stress falls to f_t/e, whatever the element: results depend on the mesh.
        softening_strain: Option<Field<Number>>,
        /// True if the tensile stress falls to nothing at the first crack: results depend on the mesh and the time step.
        brittle: Option<Field<bool>>,
        /// Least share of the shear stiffness in a cracked point, from 0 to 1; 0.1 unless given.
        shear_retention: Option<Field<Number>>,
        /// Crack strain over which the shear stiffness falls; 2e-4 unless given.
        shear_retention_strain: Option<Field<Number>>,
        /// Share of the tensile strength that stays between cracks while the bars across them are elastic; 0 unless given.
        tension_stiffening: Option<Field<Number>>,
        /// Spacing of cracks, where bars set it; the size of the element unless given.
        crack_spacing: Option<Field<Length>>,
    }

    /// Bars in concrete: uniaxial, linear kinematic hardening.
    BarBehaviour {
        /// Yield strength of the law; yield_strength of the material unless given.
        yield_strength: Option<Field<Stress>>,
        /// Slope of the stress-strain line beyond yielding; 0 unless given here or by a grade.
        tangent_modulus: Option<Field<Stress>>,
        /// Strain at rupture: larger strains are reported. No limit unless given here or by a grade.
        rupture_strain: Option<Field<Number>>,
    }

    /// Elastic layer between two shells.
    InterlayerBehaviour {
        /// Modulus along the normal of the wall.
        e_normal: Field<Stress>,
        /// Modulus in the plane of the wall; 0 unless given.
        e_parallel: Option<Field<Stress>>,
        /// Transverse shear modulus; 0 unless given: the layer passes no shear.
        shear_modulus: Option<Field<Stress>>,
        /// Whether the layer carries tension along the normal; true unless given.
        tension: Option<Field<bool>>,
    }

    /// What to do to the accelerogram, in this order: scale, stretch the time axis, resample.
    Record {
        /// Scale to this peak ground acceleration, up to 5 g without --allow-implausible. Give either this or scale_by.
        scale_to: Option<Field<Acceleration>>,
        /// Multiply the accelerations by this; 1 unless given. A negative factor reverses the shaking.
        scale_by: Option<Field<Number>>,
        /// Multiply the time axis by this; 1 unless given (a model at length scale 1:3 needs 1/sqrt(3) = 0.57735).
        time_factor: Option<Field<Number>>,
        /// Resample to this time step by linear interpolation; as recorded unless given.
        resample: Option<Field<Time>>,
    }

    /// Damping ratios, as fractions of critical damping.
    Damping {
        /// Sloshing modes; 0.005 unless given (EN 1998-4:2006 2.3.3).
        sloshing: Option<Field<Number>>,
        /// Structural (impulsive) modes; unless given 0.02 for steel and aluminium, 0.05 for walls with a Young's modulus
        /// below 60 GPa such as concrete.
        impulsive: Option<Field<Number>>,
    }

    /// Site data for design spectra.
    Site {
        /// Eurocode 8; without it the Eurocode procedures run on the record's spectrum only.
        ec8: Option<Field<Ec8>>,
        /// API 650; without it the API procedures run on the record's spectrum only.
        api650: Option<Field<Api650>>,
    }

    /// Site data of Eurocode 8.
    Ec8 {
        /// Ground type of EN 1998-1 table 3.1.
        ground: Field<Ground>,
        /// Type of the elastic spectrum, 1 or 2.
        spectrum: Field<Whole>,
        /// Reference peak ground acceleration a_gR on rock.
        ag: Field<Acceleration>,
        /// Importance factor; 1.0 unless given.
        importance: Option<Field<Number>>,
        /// Behaviour factor q of the impulsive part; 1.0 unless given.
        behaviour_factor: Option<Field<Number>>,
        /// Fabrication quality of EN 1998-4 A.10: 1 normal (unless given), 1.5 quality, 2.5 very high quality construction.
        construction_quality: Option<Field<Number>>,
        /// Whether the vertical design spectrum is applied; true unless given.
        vertical: Option<Field<bool>>,
    }

    /// Site data of API 650: annex E of the 13th edition, and the zone method of appendix E, 9th edition.
    Api650 {
        /// Mapped short-period acceleration S_s in g.
        ss: Field<InG>,
        /// Mapped one-second acceleration S_1 in g.
        s1: Field<InG>,
        /// Peak ground acceleration S_0 in g; 0.4 S_s unless given.
        s0: Option<Field<InG>>,
        /// Site class of ASCE 7.
        site_class: Field<SiteClass>,
        /// Edition of the site-coefficient tables: 2010 (unless given; the tables printed in annex E) or 2016.
        asce7: Option<Field<Whole>>,
        /// Site coefficient F_a of a site study, instead of the table's; together with fv. Site class F needs both.
        fa: Option<Field<Number>>,
        /// Site coefficient F_v of a site study, instead of the table's; together with fa.
        fv: Option<Field<Number>>,
        /// Factor Q from the mapped to the design earthquake; 2/3 unless given (ASCE 7 maps), 1 for other maps.
        q: Option<Field<Number>>,
        /// Seismic use group, 1, 2 or 3.
        sug: Field<Whole>,
        /// Long-period transition T_L in seconds.
        tl: Field<Seconds>,
        /// Vertical acceleration A_v in g; 0.47 S_DS unless given.
        av: Option<Field<InG>>,
        /// Design pressure above the liquid; 0 unless given.
        design_pressure: Option<Field<Stress>>,
        /// Joint efficiency of the shell; 1.0 unless given.
        joint_efficiency: Option<Field<Number>>,
        /// Friction coefficient against sliding, at most 0.4; 0.4 unless given.
        friction: Option<Field<Number>>,
        /// 9th edition: zone factor Z (0, 0.075, 0.15, 0.2, 0.3 or 0.4); the zone method is not run unless given.
        zone_factor: Option<Field<Number>>,
        /// 9th edition: site amplification S (1.0, 1.2, 1.5 or 2.0); 1.5 unless given.
        soil_factor: Option<Field<Number>>,
        /// 9th edition: importance factor I (1.0 or 1.25); 1.0 unless given.
        importance_1993: Option<Field<Number>>,
    }

    /// Choices within the code procedures.
    Procedures {
        /// Procedures to run; all unless given.
        run: Option<Field<Vec<Field<ProcedureId>>>>,
        /// Housner's procedure.
        housner: Option<Field<HousnerOptions>>,
        /// Eurocode 8.
        ec8: Option<Field<Ec8Options>>,
    }

    /// Choices within Housner's procedure.
    HousnerOptions {
        /// Coefficients of the convective part; exact unless given.
        convective: Option<Field<Convective>>,
        /// How impulsive and convective maxima are added; abs unless given.
        combination: Option<Field<Combination>>,
    }

    /// Choices within the Eurocode procedures.
    Ec8Options {
        /// How impulsive and convective maxima are added; abs unless given.
        combination: Option<Field<Combination>>,
        /// How the flexible impulsive part is found; simplified unless given.
        impulsive: Option<Field<Impulsive>>,
    }

    /// Options of the finite-element analysis.
    Analysis {
        /// Time integration; modal unless given.
        integrator: Option<Field<Integrator>>,
        /// Factor on the number of elements in each direction; 1 unless given.
        refine: Option<Field<Number>>,
        /// Number of sloshing modes that count for the wave height; 5 unless given.
        wave_modes: Option<Field<Whole>>,
        /// Whether the discretisation error is estimated on a second mesh; true unless given.
        mesh_error: Option<Field<bool>>,
        /// Wave gauges besides the one at the wall: distances from the centre in the direction of shaking.
        gauges: Option<Field<Vec<Field<Length>>>>,
        /// Stress stations: heights above the base with histories of hoop, axial and bending stress.
        stations: Option<Field<Vec<Field<Length>>>>,
        /// Damping model; the modal ratios of damping unless given.
        damping: Option<Field<AnalysisDamping>>,
        /// Options of the three-dimensional engine (--fe solid, --fe both).
        solid: Option<Field<Solid>>,
        /// Options of the nonlinear engine.
        nonlinear: Option<Field<Nonlinear>>,
    }

    /// Options of the nonlinear engine: walls that yield and crack, large rotations, liquid of linear theory.
    Nonlinear {
        /// Numbers of elements of the wall; by its size and materials unless given.
        elements: Option<Field<Elements>>,
        /// Whether only the half of the tank on one side of the plane of shaking is computed; true unless given.
        symmetry: Option<Field<bool>>,
        /// Spectral radius of the time integration at high frequencies, from 0 to 1; 0.9 unless given, 1 is the trapezoidal
        /// rule (generalised-alpha method of Chung and Hulbert).
        spectral_radius: Option<Field<Number>>,
        /// Time step; a twentieth of the period of the impulsive mode, at most half the step of the record, unless given.
        time_step: Option<Field<Time>>,
        /// Damping model; by_group with the ratios of damping unless given.
        damping: Option<Field<NonlinearDamping>>,
        /// Contact of liquid and wall; bonded unless given.
        contact: Option<Field<Contact>>,
        /// Whether the weight of the wall acts; true unless given.
        self_weight: Option<Field<bool>>,
        /// Whether the pressure turns with the wall; true unless given.
        follower_pressure: Option<Field<bool>>,
        /// Points through the thickness, by kind of material.
        integration: Option<Field<Integration>>,
        /// Computing time between two checkpoints from which a run can be resumed; 60 s unless given.
        checkpoint: Option<Field<Time>>,
    }

    /// Numbers of elements of the wall.
    Elements {
        /// Over the height of the wall.
        height: Field<Whole>,
        /// Around a cylinder, even unless symmetry is false, or along the whole perimeter of a rectangle; not for a strip.
        circumference: Option<Field<Whole>>,
    }

    /// Points through the thickness of a layer, by kind of material.
    Integration {
        /// Elastic layers; "gauss 2" unless given, which is exact.
        elastic: Option<Field<Rule>>,
        /// Steel; "gauss 5" unless given.
        steel: Option<Field<Rule>>,
        /// Concrete; "midpoint 20" unless given.
        concrete: Option<Field<Rule>>,
    }

    /// Damping of the nonlinear engine. Give one of the three.
    NonlinearDamping {
        /// Stiffness-proportional in the wall, a ratio for every sloshing mode.
        by_group: Option<Field<ByGroup>>,
        /// Rayleigh damping fitted to two ratios.
        rayleigh: Option<Field<Rayleigh>>,
        /// Proportional to the mass. The wall is left next to undamped: a ratio at the first sloshing mode is a hundredth of
        /// it and less at the modes of the wall.
        mass_proportional: Option<Field<MassProportional>>,
    }

    /// Damping ratios by group.
    ByGroup {
        /// Of the first mode of wall and liquid; the impulsive ratio of damping unless given.
        wall: Option<Field<Number>>,
        /// Of every sloshing mode; the sloshing ratio of damping unless given.
        sloshing: Option<Field<Number>>,
    }

    /// Damping proportional to the mass.
    MassProportional {
        /// Damping ratio.
        ratio: Field<Number>,
        /// Where it holds; at the first sloshing mode unless given.
        at: Option<Field<Pitch>>,
    }

    /// Options of the three-dimensional engine.
    Solid {
        /// Numbers of elements over radius (or half length), circumference (or breadth) and height of the wall, such as
        /// "12x16x20"; by the size of the tank unless given.
        mesh: Option<Field<Mesh>>,
        /// Formulation of the liquid; potential unless given.
        liquid: Option<Field<LiquidElement>>,
        /// Largest memory of matrices and factors in MiB; 4096 unless given.
        memory_limit: Option<Field<Whole>>,
    }

    /// Damping model of the finite-element analysis instead of modal ratios. Give one of the two.
    AnalysisDamping {
        /// Rayleigh damping fitted to two ratios.
        rayleigh: Option<Field<Rayleigh>>,
        /// Rayleigh damping with its coefficients given, whatever their sign.
        coefficients: Option<Field<Coefficients>>,
    }

    /// Rayleigh damping C = a_M M + a_K K fitted to two ratios.
    Rayleigh {
        /// First pair.
        first: Field<RatioAt>,
        /// Second pair.
        second: Field<RatioAt>,
        /// Accept a negative coefficient (to repeat published runs); false unless given.
        allow_negative: Option<Field<bool>>,
    }

    /// A damping ratio at a frequency.
    RatioAt {
        /// Circular frequency, frequency or period.
        at: Field<Pitch>,
        /// Damping ratio.
        ratio: Field<Number>,
    }

    /// Coefficients of Rayleigh damping C = a_M M + a_K K.
    Coefficients {
        /// a_M in 1/s, a bare number.
        mass: Field<Number>,
        /// a_K.
        stiffness: Field<Time>,
    }

    /// A measured value.
    Reported {
        /// The value with its unit; a period may also be given as a frequency ("3.02 rad/s", "1.916 Hz").
        value: Field<Raw>,
        /// Who measured it, where it is published.
        source: Field<String>,
        /// What is known of it.
        note: Option<Field<String>>,
    }

    /// A published value.
    Published {
        /// What it is.
        quantity: Field<QuantityId>,
        /// The value with its unit.
        value: Field<Raw>,
        /// Who published it, where.
        source: Field<String>,
        /// What is known of it ("belongs to the record as recorded").
        note: Option<Field<String>>,
    }
}

choice! {
    /// Plan shape.
    Shape {
        /// Circular cylinder with a radius.
        Cylinder = "cylinder",
        /// Rectangle with a length in the direction of shaking, and a breadth or strip.
        Rectangle = "rectangle",
    }

    /// Support of the wall.
    Support {
        /// Held down; the wall is clamped at its base.
        Anchored = "anchored",
        /// Resting on the ground, may uplift (code procedures only; the linear finite elements assume contact).
        Unanchored = "unanchored",
    }

    /// Kind of a layer.
    LayerKind {
        /// Carries membrane forces and bending.
        Shell = "shell",
        /// Keeps two shells apart.
        Interlayer = "interlayer",
    }

    /// Direction of bars.
    BarDirection {
        /// Around the tank; along the wall of a rectangle.
        Hoop = "hoop",
        /// Up the wall.
        Vertical = "vertical",
    }

    /// Law of concrete.
    ConcreteLaw {
        /// Fixed cracks at right angles, Drucker-Prager compression.
        Cracked = "cracked",
        /// Uniaxial laws in the directions of the wall, for strips and rings.
        Uniaxial = "uniaxial",
        /// Plastic-fracturing theory.
        PlasticFracturing = "plastic-fracturing",
    }

    /// Contact of liquid and wall.
    Contact {
        /// The liquid stays at the wall.
        Bonded = "bonded",
        /// It parts from the wall where the pressure would be tension.
        Opening = "opening",
    }

    /// Ground type of EN 1998-1 table 3.1.
    Ground {
        /// Rock.
        A = "A",
        /// Very dense sand, gravel or very stiff clay.
        B = "B",
        /// Deep dense or medium-dense sand, gravel or stiff clay.
        C = "C",
        /// Loose-to-medium cohesionless soil or soft-to-firm cohesive soil.
        D = "D",
        /// A surface layer of type C or D over type A.
        E = "E",
    }

    /// Site class of ASCE 7.
    SiteClass {
        /// Hard rock.
        A = "A",
        /// Rock.
        B = "B",
        /// Very dense soil and soft rock.
        C = "C",
        /// Stiff soil.
        D = "D",
        /// Soft clay soil.
        E = "E",
        /// Soils that need a site study; give fa and fv.
        F = "F",
    }

    /// A code procedure.
    ProcedureId {
        /// Housner 1957 and 1963.
        Housner = "housner",
        /// ENV 1998-4:1998, annex B.
        Ec8Env = "ec8-env",
        /// EN 1998-4:2006, annex A.
        Ec82006 = "ec8-2006",
        /// API 650, 9th edition 1993, appendix E.
        Api6501993 = "api650-1993",
        /// API 650, 13th edition 2020, annex E.
        Api6502020 = "api650-2020",
    }

    /// Convective coefficients of Housner's procedure.
    Convective {
        /// The exact first-mode coefficients of potential flow.
        Exact = "exact",
        /// Housner 1957: 0.318 (circular) and 0.527 (rectangular).
        Housner1957 = "1957",
    }

    /// How the maxima of two parts are added.
    Combination {
        /// Sum of absolute values.
        Abs = "abs",
        /// Square root of the sum of squares.
        Srss = "srss",
    }

    /// The flexible impulsive part of EN 1998-4.
    Impulsive {
        /// A.3.2.2 with the coefficients of table A.2.
        Simplified = "simplified",
        /// A.3.1 with the iterated mode shape.
        Iterative = "iterative",
    }

    /// Time integration.
    Integrator {
        /// Exact piecewise-linear modal integration with missing mass.
        Modal = "modal",
        /// Direct integration by Newmark's method.
        Newmark = "newmark",
    }

    /// Formulation of the liquid in the three-dimensional engine.
    LiquidElement {
        /// Displacement potential on hexahedra.
        Potential = "potential",
        /// Displacements in convective coordinates with a rotation penalty, joined to the wall by contact elements.
        Displacement = "displacement",
    }
}

/// The JSON Schema of `tank.json`, draft 2020-12.
pub fn json_schema() -> serde_json::Value {
    let mut schema = schemars::generate::SchemaSettings::draft2020_12()
        .into_generator()
        .into_root_schema_for::<TankFile>();
    schema.insert("title".into(), "tank.json".into());
    let mut value = schema.to_value();
    // Editors find the schema by this key of the document; the reader skips it.
    if let Some(properties) = value.pointer_mut("/properties").and_then(|p| p.as_object_mut()) {
        properties.insert(
            "$schema".into(),
            serde_json::json!({ "description": "Where editors find this schema.", "type": "string" }),
        );
    }
    // A course is of one material or of layers.
    if let Some(course) = value.pointer_mut("/$defs/Course").and_then(|c| c.as_object_mut()) {
        course.insert(
            "oneOf".into(),
            serde_json::json!([{ "required": ["thickness", "material"] }, { "required": ["layers"] }]),
        );
    }
    // What a shape needs follows from the shape.
    if let Some(tank) = value.pointer_mut("/$defs/Tank").and_then(|t| t.as_object_mut()) {
        let shape_is =
            |word: &str| serde_json::json!({ "properties": { "shape": { "const": word } }, "required": ["shape"] });
        tank.insert(
            "allOf".into(),
            serde_json::json!([
                { "if": shape_is("cylinder"), "then": { "required": ["radius"] } },
                { "if": shape_is("rectangle"),
                  "then": { "required": ["length"], "anyOf": [{ "required": ["breadth"] }, { "required": ["strip"] }] } },
            ]),
        );
    }
    value
}
