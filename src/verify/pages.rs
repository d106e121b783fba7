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
];

/// The description of a page, if there is one.
pub fn find(id: &str) -> Option<&'static Page> {
    PAGES.iter().find(|p| p.id == id)
}
