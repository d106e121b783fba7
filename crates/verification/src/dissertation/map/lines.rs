//! The lines of the map, by chapter.

use super::Shown::{Page, Rows, Run, Test};
use super::{Chapter, Line};

/// All chapters, in the order of [B02].
pub(super) const CHAPTERS: [Chapter; 7] = [
    Chapter { title: "Codes (chapter 2)", lines: CODES, note: "" },
    Chapter { title: "Dynamic analyses (chapter 3)", lines: DYNAMICS, note: "" },
    Chapter { title: "Liquid (chapter 5)", lines: LIQUID, note: LIQUID_NOTE },
    Chapter { title: "Wall (chapters 4 and 6)", lines: WALL, note: "" },
    Chapter { title: "Contact (chapter 7)", lines: CONTACT, note: CONTACT_NOTE },
    Chapter { title: "Examples (chapter 8) and appendix D", lines: EXAMPLES, note: EXAMPLES_NOTE },
    Chapter {
        title: "Outlook (3.2, 9.2)",
        lines: OUTLOOK,
        note: "Described in [B02] as damage or as what should follow, and computed here.",
    },
];

const LIQUID_NOTE: &str = "The default liquid is a potential ([harmonic-engine](harmonic-engine.md), [potential-elements](potential-elements.md)), \
which does not need a penalty. By default `--liquid displacement` has the mean dilatation and a split penalty instead of the four variants, whose patch test or \
spectrum fails ([fluid-elements](fluid-elements.md)).";

const CONTACT_NOTE: &str = "`contact: \"opening\"` joins a condensed liquid to the wall node by node ([strip](strip.md), section 8); clipped areas \
are in `contact8` alone.";

const EXAMPLES_NOTE: &str = "What [B02] could not compute for want of memory is the complete cylinder with a nonlinear wall: `compare --fe nonlinear` \
on `examples/07_steel_cylinder` and `08_concrete_cylinder` ([nonlinear-cylinder](nonlinear-cylinder.md)); its elephant's foot (3.2) is on the page \
[elephant-foot](elephant-foot.md).";

const fn line(system: &'static str, program: &'static str, shown: &'static [super::Shown]) -> Line {
    Line { system, program, shown }
}

const CODES: &[Line] = &[
    line(
        "Housner (2.2.1, 8.4.2): masses, levers, wave, shear, moment; broad and slender tanks, rectangles",
        "`check`, `compare`: Housner (1957, 1963)",
        &[Page("housner.md"), Rows("table-D.1"), Rows("table-8.10"), Rows("table-8.11")],
    ),
    line(
        "Eurocode 8 part 4 (2.3.1): the draft that [B02] cites, and EN 1998-4:2006",
        "`check`, `compare`: ENV 1998-4 and EN 1998-4:2006",
        &[Page("eurocode8.md"), Rows("table-D.3"), Run("check examples/05_oil_tank/tank.json")],
    ),
    line(
        "API 650 (2.3.2): appendix E of the 9th edition, and annex E of 2020",
        "`check`, `compare`: API 650, 9th edition and annex E of 2020",
        &[Page("api650.md"), Rows("table-D.2"), Run("check examples/05_oil_tank/tank.json")],
    ),
    line(
        "vertical motion (2.2.2)",
        "`compare --vertical`, also of strips and cylinders with `--fe nonlinear`; `site.ec8.vertical`",
        &[Page("response.md"), Rows("vertical")],
    ),
];

const DYNAMICS: &[Line] = &[
    line(
        "loads (3.1.1): weight, liquid, temperature, prestress, creep and shrinkage before the earthquake",
        "`analysis.nonlinear.temperature`, `materials.*.volume_change`, `prestress` of `tank.courses[].reinforcement`: state at rest of `--fe nonlinear`; \
         `tank.pressure` for the codes",
        &[Page("nonlinear-cylinder.md"), Rows("volume-change"), Test("-p fem creep")],
    ),
    line(
        "response spectra of a record, four-way plot (3.3, figures 3.25, 3.26)",
        "`tankcheck spectrum`; section *spectra* of the report",
        &[Page("spectra.md"), Rows("F13"), Run("spectrum examples/records/elcentro.csv")],
    ),
    line(
        "deformability parameter K (3.1)",
        "corrected, √(H/s), in every report of a cylinder; also as printed with `--report full`",
        &[Test("-p codes deformability")],
    ),
    line(
        "direct integration, Newmark (3.7), (3.8)",
        "`compare --integrator newmark`",
        &[Rows("time-integration"), Rows("four-methods-on-one-model")],
    ),
    line(
        "modal superposition (3.9) to (3.11)",
        "`compare` (default)",
        &[Rows("four-methods-on-one-model"), Rows("missing-mass")],
    ),
    line(
        "response-spectrum method, SRSS and CQC (3.4.3)",
        "`analysis.spectrum`: column `fe` under the design spectrum of `site`",
        &[
            Rows("response-spectrum-method"),
            Page("response-spectrum.md"),
            Run("compare examples/05_oil_tank/tank.json"),
        ],
    ),
    line("frequency domain (3.4.4)", "`analysis.frequency`", &[Rows("D8"), Page("dynamics.md")]),
    line("single dashpots (3.12)", "rings of dashpots: `analysis.damping.dashpots`", &[Rows("dashpots")]),
    line(
        "Rayleigh damping (3.13), (3.14), also with the coefficients as printed",
        "`analysis.damping.rayleigh`, `.coefficients`",
        &[Rows("rayleigh-damping")],
    ),
    line(
        "proportional to the stiffness (3.15) or the mass (3.16)",
        "`analysis.damping.coefficients` with one of them 0; `analysis.nonlinear.damping.mass_proportional`",
        &[Rows("C6"), Rows("strip-incremental")],
    ),
    line("Caughey's series", "`analysis.damping.caughey`", &[Rows("mode-damping"), Page("dynamics.md")]),
    line(
        "damping by part of the structure (3.4.5, 6.1)",
        "`analysis.damping.by_group`, `analysis.nonlinear.damping.by_group`",
        &[Rows("C6"), Rows("mode-damping"), Page("dynamics.md")],
    ),
    line(
        "nonlinear steps with Newton-Raphson iterations (3.4.1)",
        "`compare --fe nonlinear`, `ida`",
        &[Rows("nonlinear-dynamics")],
    ),
];

const LIQUID: &[Line] = &[
    line(
        "hexahedron in convective coordinates with a rotation penalty (5.2)",
        "`compare --fe solid --liquid displacement`",
        &[Rows("fluid-cylinder"), Rows("fluid-impulsive")],
    ),
    line(
        "its four variants of integration (5.3.1, table 5.3), plane and spatial",
        "variant 4, as stated: `analysis.solid.rotation_penalty`; variants 1 to 3: elements of benchmarks",
        &[Rows("fluid-rank"), Rows("K5"), Rows("K6"), Rows("element-8.1")],
    ),
    line(
        "patch tests (5.3.2.1), own weight (5.3.2.2)",
        "element of `--liquid displacement`",
        &[Rows("fluid-patch"), Rows("fluid-weight")],
    ),
    line(
        "sloshing of cylinders and rectangles (5.3.3), thin discs (table 5.4)",
        "`modes --fe solid --liquid displacement`",
        &[Rows("5.3.3.1"), Rows("fluid-cylinder"), Rows("fluid-rectangle"), Rows("fluid-disc")],
    ),
    line("geometrically linear surface with its stiffness ρ g (5.2)", "the same", &[Rows("fluid-weight")]),
];

const WALL: &[Line] = &[
    line(
        "four-node shell of finite rotations, five parameters, assumed shear strains (6.2)",
        "`compare --fe nonlinear`, `push`; linear in `--fe solid`",
        &[Rows("shell-*")],
    ),
    line(
        "layers through the thickness (2.2) to (2.4)",
        "`tank.courses[].layers`, `analysis.nonlinear.integration`",
        &[Rows("shell-concrete-beams"), Rows("shell-plastic-plates")],
    ),
    line(
        "steel: von Mises, isotropic and kinematic hardening (4.92)",
        "`behaviour.steel` with `kinematic_share`",
        &[Rows("materials-steel")],
    ),
    line(
        "concrete in compression: Drucker-Prager, ideally plastic (6.2)",
        "`behaviour.concrete`",
        &[Rows("materials-steel"), Rows("M3")],
    ),
    line(
        "concrete: plastic-fracturing (4.99) to (4.101)",
        "`behaviour.concrete.law: \"plastic-fracturing\"`: damage and plasticity with their own parameters",
        &[Rows("M4")],
    ),
    line(
        "two-surface plasticity; fracturing solid (Dougill), as (4.100) is meant",
        "`behaviour.concrete.law: \"two-surface\"`, `\"fracturing\"`",
        &[Rows("M15"), Rows("M17")],
    ),
    line(
        "fixed orthogonal cracks, closing and reopening (4.4.3)",
        "`behaviour.concrete`",
        &[Rows("materials-concrete")],
    ),
    line(
        "bars as smeared layers (6.4.2)",
        "`tank.courses[].reinforcement`, `behaviour.reinforcement`",
        &[Rows("shell-concrete-beams")],
    ),
    line(
        "elastomer, linearly elastic: isotropic (4.90); normal stress alone (6.1, 8.4.1), also with transverse shear and stiffness in the plane",
        "`tank.courses[].layers` with `kind: \"interlayer\"`, of an elastic material or with `behaviour.interlayer`",
        &[Rows("layered-wall"), Rows("macro-wall"), Rows("brick-cantilever")],
    ),
    line("macro element: two shells and a layer (6.1)", "the same in `--fe nonlinear`", &[Rows("macro-wall")]),
    line(
        "volume element: statics, frequencies, large deflections, harmonic force (6.4.1)",
        "layer between shells in `--fe nonlinear`",
        &[Rows("brick-cantilever"), Rows("elastica")],
    ),
    line(
        "beam of Bresler and Scordelis (6.4.2)",
        "element and law of the shells above",
        &[Rows("shell-concrete-beams")],
    ),
];

const CONTACT: &[Line] = &[
    line(
        "joint of two faces that carries pressure alone (7.1, figure 7.5)",
        "`analysis.nonlinear.contact: \"opening\"` in strips and cylinders",
        &[Rows("contact-joint"), Rows("liquid-separation")],
    ),
    line(
        "three parts of a partly closed joint (figure 7.3)",
        "`contact8`, which clips the closed part exactly: `--liquid displacement` of `--fe nonlinear` with `contact: \"opening\"`; bonded in `--fe solid`",
        &[Rows("C7"), Rows("chain-8.15")],
    ),
];

const EXAMPLES: &[Line] = &[
    line("all printed numbers, beside ours", "`verification dissertation`", &[Rows("dissertation")]),
    line(
        "8.1 broad tank: frequencies, statics, three records, meshes A to D; appendix D",
        "`examples/01_broad_tank`; [the meshes of table 8.1](../verification/dissertation-tanks.md)",
        &[
            Rows("table-8.2"),
            Rows("S11"),
            Rows("K5"),
            Rows("F12"),
            Rows("F14"),
            Run("compare examples/01_broad_tank/tank.json --quake examples/records/elcentro.csv --no-mesh-error"),
            Run("modes examples/01_broad_tank/tank.json --fe solid --mesh 12x16x19 --count 4"),
        ],
    ),
    line(
        "8.2 model tank: five depths, harmonic motion of the base",
        "`examples/02_perspex_model_tank`",
        &[
            Rows("8.2"),
            Rows("table-8.8"),
            Rows("table-8.9"),
            Run(
                "compare examples/02_perspex_model_tank/tank.json --quake examples/02_perspex_model_tank/record.csv --no-mesh-error",
            ),
        ],
    ),
    line(
        "8.3 slender tank: five depths",
        "`examples/03_slender_tank`",
        &[
            Rows("8.3"),
            Rows("table-8.10"),
            Run(
                "compare examples/03_slender_tank/tank_h4.5.json --quake examples/records/elcentro.csv --no-mesh-error",
            ),
        ],
    ),
    line(
        "8.4.2 to 8.4.5 strip: Housner, frequencies, statics, linear response (tables 8.11 to 8.14)",
        "`examples/04_concrete_strip`, `06_sandwich_strip`",
        &[
            Rows("table-8.11"),
            Rows("8.4"),
            Rows("C10"),
            Rows("table-8.12"),
            Rows("table-8.14"),
            Run("compare examples/04_concrete_strip/tank.json --quake examples/records/elcentro.csv --no-mesh-error"),
        ],
    ),
    line(
        "8.4 the strip with its own elements (layered shells, interlayer) in a history",
        "`analysis.nonlinear.wall: \"shell\"` with `--fe nonlinear`",
        &[Rows("strip-shells")],
    ),
    line(
        "8.4 the whole chain: liquid elements, contact elements and both walls in one nonlinear history",
        "`--fe nonlinear --liquid displacement` of a strip",
        &[
            Rows("strip-chain"),
            Run(
                "compare examples/06_sandwich_strip/tank.json --quake examples/records/elcentro.csv --fe nonlinear --liquid displacement --no-mesh-error",
            ),
        ],
    ),
    line(
        "8.4.6 the same with contact (table 8.15)",
        "`examples/06_sandwich_strip/opening`",
        &[
            Rows("C8"),
            Rows("chain-8.15"),
            Run(
                "compare examples/06_sandwich_strip/opening/tank.json --quake examples/records/elcentro.csv --fe nonlinear --no-mesh-error",
            ),
        ],
    ),
    line(
        "8.4.7 cracking concrete at rising scales (table 8.16)",
        "`ida`; [what the table measures](table-8-16.md)",
        &[
            Rows("table-8.16"),
            Run("ida examples/06_sandwich_strip/tank.json --quake examples/records/elcentro.csv --scale 0.1,0.2"),
        ],
    ),
];

const OUTLOOK: &[Line] = &[
    line(
        "uplift of unanchored tanks (3.2)",
        "strips of the bottom: `base`, `compare`; shells of wall and bottom: `push`, `compare --fe nonlinear`",
        &[
            Page("base.md"),
            Rows("base-strip"),
            Rows("base-shells"),
            Rows("base-rims"),
            Run("base examples/09_slender_unanchored/tank.json"),
        ],
    ),
    line(
        "soil-structure interaction (9.2)",
        "`tank.foundation.shear_wave_velocity`, `.soil_layers`: `compare`; `--fe nonlinear` of cylinders on a slab",
        &[
            Page("soil.md"),
            Rows("soil-engine"),
            Rows("soil-structure"),
            Run("compare examples/11_slab_tank/tank_soil.json --quake examples/records/elcentro.csv --no-mesh-error"),
        ],
    ),
    line(
        "isolators (9.2)",
        "`tank.isolators`: `compare`; `--fe nonlinear` of cylinders",
        &[
            Page("soil.md"),
            Rows("isolation"),
            Rows("isolation-engine"),
            Run(
                "compare examples/11_slab_tank/tank_isolated.json --quake examples/records/elcentro.csv --no-mesh-error",
            ),
        ],
    ),
    line(
        "large waves (9.2)",
        "`--liquid nonlinear`, and by itself beyond the limit of the linear wave",
        &[Page("large-waves.md"), Rows("large-waves")],
    ),
];
