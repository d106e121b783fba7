//! Structured mesh of nine-node quadrilaterals, finer towards the wall and the surface.

/// Breakpoints r/R of the default mesh: the functions J_m(λr/R) of higher modes and the impulsive boundary layer crowd
/// towards the wall.
const RADIAL: [f64; 6] = [0.0, 0.25, 0.5, 0.7, 0.85, 1.0];

/// Elements over the height of the default mesh.
const VERTICAL: f64 = 8.0;

/// Exponent of the grading z/H = 1 − (1 − s)^p towards the surface.
const GRADING: f64 = 1.3;

/// Aspect H/R beyond which more elements over the height are taken (accuracy measured up to here).
const SLENDER: f64 = 2.7;

/// Nodes of a structured mesh: node (i, j) has the number `i + j * r.len()`; corners have even i and j.
#[derive(Clone, Debug, PartialEq)]
pub struct LiquidMesh {
    /// Radii (or x) of all nodes [m], mid-side nodes included, from 0 to R.
    pub r: Vec<f64>,
    /// Heights of all nodes [m], from 0 to H.
    pub z: Vec<f64>,
}

impl LiquidMesh {
    /// Default mesh of a liquid of half length `half_length` [m] and depth `depth` [m]; every element count is
    /// multiplied by `refine`.
    pub fn graded(half_length: f64, depth: f64, refine: f64) -> LiquidMesh {
        let slender = (depth / half_length / SLENDER).max(1.0);
        let radial = scaled(5.0, refine);
        let vertical = scaled(VERTICAL * slender, refine);
        let r = corners(radial, |s| {
            let at = s * (RADIAL.len() - 1) as f64;
            let k = (at as usize).min(RADIAL.len() - 2);
            half_length * (RADIAL[k] + (RADIAL[k + 1] - RADIAL[k]) * (at - k as f64))
        });
        let z = corners(vertical, |s| depth * (1.0 - (1.0 - s).powf(GRADING)));
        LiquidMesh { r: with_midpoints(&r), z: with_midpoints(&z) }
    }

    /// Number of elements along r and z.
    pub fn elements(&self) -> (usize, usize) {
        (self.r.len() / 2, self.z.len() / 2)
    }

    /// Number of nodes.
    pub fn nodes(&self) -> usize {
        self.r.len() * self.z.len()
    }

    /// Numbers of the nine nodes of element (a, b), in the order of [`crate::shape::quad9`].
    pub fn element_nodes(&self, a: usize, b: usize) -> [usize; 9] {
        std::array::from_fn(|k| (2 * a + k % 3) + (2 * b + k / 3) * self.r.len())
    }
}

/// Element count n × refine, at least 2.
pub fn scaled(n: f64, refine: f64) -> usize {
    ((n * refine).round() as usize).max(2)
}

fn corners(elements: usize, place: impl Fn(f64) -> f64) -> Vec<f64> {
    (0..=elements).map(|k| place(k as f64 / elements as f64)).collect()
}

fn with_midpoints(corners: &[f64]) -> Vec<f64> {
    let mut nodes = vec![corners[0]];
    for pair in corners.windows(2) {
        nodes.push(0.5 * (pair[0] + pair[1]));
        nodes.push(pair[1]);
    }
    nodes
}

/// Element that holds `x` and its ξ ∈ [−1, 1], for nodes with mid-side nodes; the upper element at a corner but the last.
pub(crate) fn locate(nodes: &[f64], x: f64) -> (usize, f64) {
    let elements = nodes.len() / 2;
    let e = (0..elements).find(|e| x < nodes[2 * e + 2]).unwrap_or(elements - 1);
    let (a, b) = (nodes[2 * e], nodes[2 * e + 2]);
    (e, ((2.0 * x - a - b) / (b - a)).clamp(-1.0, 1.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn default_mesh() {
        let mesh = LiquidMesh::graded(2.0, 3.0, 1.0);
        assert_eq!(mesh.elements(), (5, 8));
        assert_eq!((mesh.r[0], mesh.r[10]), (0.0, 2.0));
        assert_eq!((mesh.z[0], mesh.z[16]), (0.0, 3.0));
        assert!((mesh.r[4] - 1.0).abs() < 1e-15, "r/R = 0.5 is a corner");
        assert!(mesh.z.windows(2).all(|w| w[1] > w[0]));
        assert!(mesh.z[16] - mesh.z[14] < 0.3 * (mesh.z[2] - mesh.z[0]) * 2.0);
        assert_eq!(LiquidMesh::graded(1.0, 5.4, 1.0).elements(), (5, 16));
    }

    #[test]
    fn locate_finds_the_element() {
        let nodes = [0.0, 1.0, 2.0, 2.5, 3.0];
        assert_eq!(locate(&nodes, 0.0), (0, -1.0));
        assert_eq!(locate(&nodes, 2.0), (1, -1.0));
        assert_eq!(locate(&nodes, 3.0), (1, 1.0));
        assert_eq!(locate(&nodes, 2.75), (1, 0.5));
    }
}
