//! Shape functions of one coordinate ξ ∈ [−1, 1].

/// Quadratic Lagrange functions of the nodes ξ = −1, 0, 1.
pub fn quadratic(xi: f64) -> [f64; 3] {
    [0.5 * xi * (xi - 1.0), 1.0 - xi * xi, 0.5 * xi * (xi + 1.0)]
}

/// Derivatives dN/dξ of [`quadratic`].
pub fn quadratic_slope(xi: f64) -> [f64; 3] {
    [xi - 0.5, -2.0 * xi, xi + 0.5]
}

/// Cubic Hermite functions on an element of length h: value and slope (d/dz) at ξ = −1, then at ξ = 1.
///
/// Rows: the functions, their first and second derivatives in z = h (1 + ξ)/2.
pub fn hermite(xi: f64, h: f64) -> [[f64; 4]; 3] {
    let value = [
        0.25 * (1.0 - xi) * (1.0 - xi) * (2.0 + xi),
        0.125 * h * (1.0 - xi) * (1.0 - xi) * (1.0 + xi),
        0.25 * (1.0 + xi) * (1.0 + xi) * (2.0 - xi),
        0.125 * h * (1.0 + xi) * (1.0 + xi) * (xi - 1.0),
    ];
    let bend = 1.5 / h * (1.0 - xi * xi);
    let slope = [-bend, 0.25 * (xi - 1.0) * (3.0 * xi + 1.0), bend, 0.25 * (xi + 1.0) * (3.0 * xi - 1.0)];
    let curvature = [6.0 * xi / (h * h), (3.0 * xi - 1.0) / h, -6.0 * xi / (h * h), (3.0 * xi + 1.0) / h];
    [value, slope, curvature]
}

/// Functions that are continuous, not smooth: two linear ones and the bubbles 1 − ξ², ξ (1 − ξ²), (5 ξ² − 1)(1 − ξ²),
/// whose slopes are orthogonal. The first four span the cubics, all five the quartics.
///
/// Rows: the functions and their derivatives in z on an element of length h.
pub fn bubbled(xi: f64, h: f64) -> [[f64; 5]; 2] {
    let square = xi * xi;
    let bubble = 1.0 - square;
    let value = [0.5 * (1.0 - xi), 0.5 * (1.0 + xi), bubble, xi * bubble, (5.0 * square - 1.0) * bubble];
    let slope = [-1.0 / h, 1.0 / h, -4.0 * xi / h, 2.0 * (1.0 - 3.0 * square) / h, 8.0 * xi * (3.0 - 5.0 * square) / h];
    [value, slope]
}

#[cfg(test)]
mod tests {
    use super::*;

    const H: f64 = 0.7;
    const STEP: f64 = 1e-6;

    #[test]
    fn derivatives_match_differences() {
        for xi in [-0.9, -0.2, 0.35, 0.8] {
            let dz = 0.5 * H * STEP;
            let (a, b, c) = (hermite(xi - STEP, H), hermite(xi + STEP, H), hermite(xi, H));
            let (d, e, f) = (bubbled(xi - STEP, H), bubbled(xi + STEP, H), bubbled(xi, H));
            let (q, r, s) = (quadratic(xi - STEP), quadratic(xi + STEP), quadratic_slope(xi));
            for i in 0..4 {
                assert!(((b[0][i] - a[0][i]) / (2.0 * dz) - c[1][i]).abs() < 1e-8);
                assert!(((b[1][i] - a[1][i]) / (2.0 * dz) - c[2][i]).abs() < 1e-7);
            }
            for i in 0..5 {
                assert!(((e[0][i] - d[0][i]) / (2.0 * dz) - f[1][i]).abs() < 1e-8);
            }
            for i in 0..3 {
                assert!(((r[i] - q[i]) / (2.0 * STEP) - s[i]).abs() < 1e-8);
            }
        }
    }

    #[test]
    fn hermite_interpolates_a_cubic() {
        let cubic = |z: f64| (1.0 + z * (2.0 + z * (3.0 - z)), 2.0 + z * (6.0 - 3.0 * z), 6.0 - 6.0 * z);
        let (left, right) = (cubic(0.0), cubic(H));
        for xi in [-1.0, -0.3, 0.6, 1.0] {
            let shape = hermite(xi, H);
            let exact = cubic(0.5 * H * (1.0 + xi));
            let nodal = [left.0, left.1, right.0, right.1];
            for (row, exact) in shape.iter().zip([exact.0, exact.1, exact.2]) {
                let value: f64 = row.iter().zip(nodal).map(|(n, x)| n * x).sum();
                assert!((value - exact).abs() < 1e-13);
            }
        }
    }
}
