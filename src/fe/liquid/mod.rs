//! The liquid: displacement potential on a mesh, condensed to wall and free surface.
