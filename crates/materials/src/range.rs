//! Strains in which a point without a past is elastic.

/// A convex set of strains in which a point that has never left it is elastic, σ = C ε without dissipation.
///
/// Because the set is convex, points on a straight line between two strains of it are in it too: for a section, whose strains are
/// linear over its depth, the outermost points of a ply decide for all of them. The set may be smaller than the whole elastic
/// range, never larger.
pub trait ElasticRange<const N: usize> {
    /// Whether `strain` is in the set; false for one that is not finite.
    fn holds(&self, strain: &[f64; N]) -> bool;

    /// C [Pa].
    fn moduli(&self) -> [[f64; N]; N];

    /// Writes the history of a point that has never left the set and is at `strain`.
    fn history(&self, strain: &[f64; N], slots: &mut [f64]);
}
