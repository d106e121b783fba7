//! Title and model of each page of the manual; a page that is not described here carries its id.

/// A page: one benchmark.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Page {
    /// Id, as in [`super::Row::page`], and name of the file.
    pub id: &'static str,
    /// Title.
    pub title: &'static str,
    /// The model in a few sentences: geometry, mesh, material, loads.
    pub model: &'static str,
}

/// All described pages.
pub const PAGES: &[Page] = &[
    Page {
        id: "rigid-tank-sloshing",
        title: "Sloshing in a rigid cylinder",
        model: "Harmonic engine, wall held: displacement potential on nine-node elements over (r, z), default mesh 5 × 8 \
                graded towards wall and surface. Tanks 8.1 (R = 1.83 m, H = 1.525 m), 8.2 (R = 9.6 cm) and 8.3 \
                (R = 1.83 m, H = 3 to 5 m) of the dissertation, g = 9.81 m/s².",
    },
    Page {
        id: "rigid-strip-sloshing",
        title: "Sloshing in a rigid rectangular strip",
        model: "Harmonic engine, plane strip of 5.00 m length, symmetric and antisymmetric half, default mesh, \
                g = 9.81 m/s².",
    },
    Page {
        id: "rigid-tank-masses",
        title: "Masses and levers of the liquid in a rigid cylinder",
        model: "Harmonic engine, wall translated or held: convective masses from the sloshing modes, impulsive mass from \
                the liquid with its surface free of pressure; default mesh.",
    },
    Page {
        id: "coupled-modes",
        title: "Coupled modes of wall and liquid",
        model: "Harmonic engine: potential liquid condensed to the wall, shell of revolution clamped at the base, default \
                mesh. Tanks 8.1 and 8.3 of the dissertation, and a steel tank of R = 10 m, 10 mm at eight slendernesses.",
    },
    Page {
        id: "responses-of-the-harmonic-engine",
        title: "Responses to El Centro 1940",
        model: "Harmonic engine: tank 8.1 and the concrete strip 8.4 under the Caltech record (0.348 g), which may not be \
                redistributed; damping as the dissertation prints it. References: full three-dimensional assemblies and a \
                harmonic model in another language.",
    },
    Page {
        id: "solid-against-harmonic",
        title: "Three dimensions against harmonics",
        model: "Tanks 8.1 (ρ = 1 t/m³) and 8.3 (H = 4 m) under an artificial accelerogram of 6 s, horizontal. Three-dimensional \
                engine: four-node shells, potential liquid on hexahedra, reduced to load-dependent Ritz vectors, mesh rule \
                at the refinement stated. Reference: harmonic engine, default mesh. Convergence over the mesh size, 1 at \
                refinement 1.",
    },
    Page {
        id: "potential-liquid",
        title: "Potential liquid on hexahedra",
        model: "`potential8` in rigid cylinders, sectors and boxes; then with the anchored `shell4` walls of tanks 8.1 and \
                8.3, the liquid on hexahedra or harmonic by harmonic. Meshes in each row.",
    },
    Page {
        id: "fluid-rank",
        title: "Rank of the displacement fluid elements",
        model: "Unit square and unit cube of `fluid4` and `fluid8`, K = 2.06·10⁶ kPa, K_rot = 100 kPa: eigenvectors of the \
                stiffness told apart by volume energy, rotation energy or none, for the four variants of table 5.3.",
    },
    Page {
        id: "fluid-patch",
        title: "Patch tests of the displacement fluid elements",
        model: "Regular and distorted patches (MacNeal & Harder 1985), K = 2.06·10⁶ kPa, K_rot = 206 kPa, pressure of 10 kPa \
                prescribed through the displacements of the outer nodes; Cartesian and cylindrical chart.",
    },
    Page {
        id: "fluid-weight",
        title: "Cylinder of liquid under its own weight",
        model: "R = H = 5 m, 8 × 8 × 8 `fluid8` between rigid walls, free surface with its stiffness ρ g.",
    },
    Page {
        id: "fluid-cylinder",
        title: "Sloshing of the displacement liquid in rigid cylinders",
        model: "`fluid8` with mean dilatation and split rotation penalty between rigid walls; tanks 8.1 to 8.3, meshes in \
                each row.",
    },
    Page {
        id: "fluid-rectangle",
        title: "Sloshing of the displacement liquid in rectangles",
        model: "Plane `fluid4` between rigid walls; strip 8.4 and equation (5.69), meshes in each row.",
    },
    Page {
        id: "fluid-disc",
        title: "Degenerate discs of table 5.4",
        model: "Strip of (5.69), 5 × 5 m, as spatial elements one element thin in the cylindrical chart: a sector of 1° and \
                a ring of one element.",
    },
    Page {
        id: "fluid-impulsive",
        title: "Impulsive mass of the displacement liquid",
        model: "Tank 8.1, `fluid8`, the wall's normal acceleration prescribed, nearly incompressible.",
    },
    Page {
        id: "fluid-box",
        title: "Sloshing and acoustic modes of a box",
        model: "Code_Aster V8.21.101: L = 0.8 m, H = 0.3 m, ρ = 1000 kg/m³, c = 1400 m/s, g = 9.81 m/s²; plane `fluid4`, \
                default penalty, the modes told apart by their energies.",
    },
    Page {
        id: "brick-cantilever",
        title: "Cantilever of bricks",
        model: "Dissertation 6.4.1, figure 6.5: `solid8`, L = 2.50 m, section 0.10 × 0.10 m, E = 3·10⁷ kN/m², ν = 0; static, \
                modes, harmonic tip force.",
    },
    Page {
        id: "contact-joint",
        title: "Joint between two bodies",
        model: "`contact8`: integrals over a partly closed face of 2 × 2 m; two blocks of bricks pressed by 1 MPa.",
    },
    Page {
        id: "layered-wall",
        title: "Layered wall of example 8.4",
        model: "Concrete 0.30 m, layer 0.05 m, liner 6 mm; 3.00 m high, 2.57 m of liquid of 10 kN/m³, strip of 1 m in plane \
                strain; beams with `solid8` of stiffness along its normal between them.",
    },
    Page {
        id: "materials-steel",
        title: "Stress laws: steel and Drucker-Prager's cone",
        model: "One point under strain paths: von Mises in a bar, in plane stress and in the solid; the cone in plane stress; \
                concrete damaged in compression.",
    },
    Page {
        id: "materials-concrete",
        title: "Stress laws: cracking concrete",
        model: "One point: E = 34 GPa, ν = 0.2, f_c = 35 MPa, f_t = 3.5 MPa, G_f = 100 N/m on 100 mm; and a bar of 1 m that \
                localises in one element.",
    },
    Page {
        id: "elastica",
        title: "Large deflections of a cantilever with axial force",
        model: "Dissertation 6.4.1, figure 6.5: bricks and shells under dead loads λ (P_v, P_h); reference: Reissner's \
                extensible, shear-flexible elastica by shooting.",
    },
    Page {
        id: "macro-wall",
        title: "Wall of two shells and a layer",
        model: "Strip one element wide: the wall of example 8.4 by its exact statics, sandwich beams, rigid rotations.",
    },
    Page {
        id: "strip-at-rest",
        title: "Strip 8.4 at rest",
        model: "Fibre beams and the liquid condensed onto them in closed form: L = 5 m, H = 2.57 m, wall 3.00 m × 0.30 m in plane \
                strain, bars of 7.0 cm²/m on each face.",
    },
    Page {
        id: "strip-section",
        title: "Section of the wall of strip 8.4",
        model: "Fibres of 30 cm of concrete with bars of 7.0 cm²/m on each face, under its own weight: moments over curvature.",
    },
    Page {
        id: "liquid-separation",
        title: "Does the liquid leave the wall",
        model: "Strip 8.4: the liquid has a normal displacement of its own and a joint without tension to the elastic wall; \
                Moreau's time stepping, and the same joints in the march of nonlinear walls; El Centro, the Caltech record (0.348 g).",
    },
    Page {
        id: "nonlinear-dynamics",
        title: "Nonlinear time histories",
        model: "Rest, energy balance, and condensed liquids against the full ones, with walls that yield.",
    },
    Page {
        id: "shell-slit-ring",
        title: "Shell: slit annular plate",
        model: "Radii 6 and 10, t = 0.03, E = 21·10⁶, ν = 0, line load 0.8 on one lip of the slit; meshes in each row.",
    },
    Page {
        id: "shell-hemisphere-large",
        title: "Shell: hemisphere with a hole at large displacements",
        model: "Hole of 18°, R = 10, t = 0.04, E = 6.825·10⁷, ν = 0.3, four radial forces of 400.",
    },
    Page {
        id: "shell-pull-out",
        title: "Shell: open cylinder pulled out",
        model: "L = 10.35, R = 4.953, t = 0.094, E = 10.5·10⁶, ν = 0.3125, two forces of 40 000.",
    },
    Page {
        id: "shell-pinched-large",
        title: "Shell: pinched cylinder with diaphragms at large displacements",
        model: "R = 100, L = 200, t = 1, E = 30·10³, ν = 0.3, an eighth in 40 × 40 elements, displacement control.",
    },
    Page {
        id: "shell-hinged-roof",
        title: "Shell: hinged cylindrical roof",
        model: "R = 2540, L = 254, 0.1 rad, E = 3102.75, ν = 0.3; t = 12.7 snaps through, t = 6.35 snaps back.",
    },
    Page {
        id: "shell-follower-pressure",
        title: "Shell: follower pressure",
        model: "Segments of closed shells under internal pressure that turns with them.",
    },
    Page {
        id: "shell-plastic-plates",
        title: "Shell: plastic plates",
        model: "Circular plates and a strip of von Mises steel without hardening, loaded to collapse.",
    },
    Page {
        id: "shell-concrete-beams",
        title: "Shell: reinforced-concrete beams",
        model: "Beam B-3 of Bresler & Scordelis (1963) and C3 of Vecchio & Shim (2004): half the span, layers of cracking \
                concrete, bars at their depth, pushed by displacement control.",
    },
    Page {
        id: "strip-linear-response",
        title: "Strip 8.4, linear, under El Centro",
        model: "As at rest, under the Caltech record (0.348 g), which may not be redistributed, with the dampings that all read \
                1 to 2 %.",
    },
    Page {
        id: "strip-incremental",
        title: "Strip 8.4 with concrete that cracks, under El Centro at rising scales",
        model: "Fibres with softening e_f = 3·10⁻⁴ and bars that yield, both walls, damping proportional to the mass; the \
                Caltech record (0.348 g). Table 8.16 of the dissertation stands beside ours for comparison.",
    },
    Page {
        id: "shell-element",
        title: "Shell: one element",
        model: "One distorted `shell4`: zero energies, finite rigid rotations, tangent against differences of the force.",
    },
    Page {
        id: "shell-patch",
        title: "Shell: patch test",
        model: "Distorted patch of MacNeal & Harder 1985 under membrane and bending strains.",
    },
    Page {
        id: "shell-scordelis-lo",
        title: "Shell: Scordelis-Lo roof",
        model: "Quarter of the roof, R = 25, L = 50, t = 0.25, E = 4.32·10⁸, 90 per area; meshes in each row.",
    },
    Page {
        id: "shell-pinched-cylinder",
        title: "Shell: pinched cylinder with end diaphragms",
        model: "One eighth, R = 300, L = 600, t = 3, E = 3·10⁶, ν = 0.3; meshes in each row.",
    },
    Page {
        id: "shell-hemisphere",
        title: "Shell: pinched hemisphere",
        model: "Quarter with a hole of 18°, R = 10, t = 0.04, E = 6.825·10⁷, ν = 0.3; meshes in each row.",
    },
    Page {
        id: "shell-twisted-beam",
        title: "Shell: twisted beam",
        model: "Strip twisted by 90°, L = 12, b = 1.1, unit force at the tip in and out of plane (MacNeal & Harder 1985).",
    },
    Page {
        id: "shell-cook",
        title: "Shell: Cook's membrane",
        model: "Tapered panel under shear at its free edge, plane stress; meshes in each row.",
    },
    Page {
        id: "shell-z-cantilever",
        title: "Shell: Z-section cantilever (NAFEMS LE5)",
        model: "Cantilever of Z section under a torque; folds with drilling stiffness.",
    },
    Page {
        id: "shell-square-frame",
        title: "Shell: closed frame under inner pressure",
        model: "Square frame of plates with folds at its corners, a strip one element wide, under inner pressure.",
    },
    Page {
        id: "shell-cantilever-plate",
        title: "Shell: cantilevered square plate (NAFEMS FV16)",
        model: "Modes of a thin square plate clamped along one side.",
    },
    Page {
        id: "shell-tank-static",
        title: "Shell: wall of tank 8.1 under the liquid",
        model: "One sector of the wall under hydrostatic pressure, clamped at the base; courses of the tank.",
    },
    Page {
        id: "shell-tank-locking",
        title: "Shell: membrane locking of a cylindrical wall",
        model: "Sector of tank 8.1's wall with the membrane shear integrated fully and taken at the centre.",
    },
    Page {
        id: "shell-tank-sectors",
        title: "Shell: a polygon for a circle",
        model: "Wall of tank 8.1 by the number of its sectors.",
    },
    Page {
        id: "shell-tank-grading",
        title: "Shell: mesh graded to the base",
        model: "Wall of tank 8.1 by the grading of its mesh into the edge disturbance.",
    },
    Page {
        id: "shell-axial-buckling",
        title: "Shell: axial buckling of a cylinder",
        model: "Linear buckling of one sector against 0.605 E t/R.",
    },
    Page {
        id: "shell-pressurized-buckling",
        title: "Shell: axial buckling under internal pressure",
        model: "Panel between planes of symmetry, R/t = 400, follower pressure: perfect, with an axisymmetric imperfection, \
                and bent into the computed buckling mode.",
    },
    Page {
        id: "shell-elephant-foot",
        title: "Shell: elastic-plastic collapse above the base",
        model: "One sector of 180, height 10 √(R t), ideally plastic steel of 250 MPa with five Gauss points, constant follower \
                pressure, axial load along an arc through its maximum; 1 is E t/R.",
    },
    Page {
        id: "time-integration",
        title: "Time integration",
        model: "Oscillators without space: amplification, period and numerical damping of Newmark's method and the \
                generalised-α method, the exact recurrence.",
    },
    Page {
        id: "rayleigh-damping",
        title: "Rayleigh damping",
        model: "Coefficients from two ratios, the ratios that result, and the rule for admissible pairs.",
    },
];

/// The description of a page, if there is one.
pub fn find(id: &str) -> Option<&'static Page> {
    PAGES.iter().find(|p| p.id == id)
}

/// Name of a page's file: lower-case letters and digits, all else a hyphen.
pub fn slug(page: &str) -> String {
    let letters = page.chars().map(|c| {
        if c.is_ascii_alphanumeric() {
            c.to_ascii_lowercase()
        } else {
            '-'
        }
    });
    letters.collect()
}

/// Title of a page that is not described.
pub fn plain_title(page: &str) -> String {
    let words = page.replace('-', " ");
    let mut letters = words.chars();
    letters
        .next()
        .map_or(String::new(), |c| c.to_uppercase().chain(letters).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ids_are_names_of_files_and_unique() {
        for (i, page) in PAGES.iter().enumerate() {
            assert_eq!(slug(page.id), page.id);
            assert!(PAGES[..i].iter().all(|other| other.id != page.id), "{}", page.id);
        }
        assert_eq!(slug("Time integration"), "time-integration");
        assert_eq!(plain_title("layered-wall"), "Layered wall");
    }
}
