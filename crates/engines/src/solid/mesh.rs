//! Where the nodes of a tank go.
//!
//! Along the wall the element length follows the edge bending, whose wave length is proportional to l = √(R t):
//!
//! ```text
//! h(z) = min over features f of (h_f + (q − 1) |z − z_f|),  at most 1.3 l         q = 1.15
//! clamped base: h_f = 0.3 l;   thickness step, liquid level, ring: h_f = 0.4 l
//! ```
//!
//! with l of the thinner course at a feature (1.3 of a 24th of the height at most on a plane wall). Nodes lie where ∫ dz/h is a multiple of its mean step between two
//! features, so that no element is a needle. Under hydrostatic load
//! h_f = l/2 at the base gives hoop force and base moment of tank 8.1 to 1 % (theory of the shell element). The liquid has its own division, finer towards wall and surface.
//! A division given in numbers is uniform.

use tank::{Shape, Tank};

use super::plan::Plan;
use crate::FeError;
use crate::out_of_round::sectors;
use tank::options::LinearOptions as Options;
use tank::options::solid::{MeshSize, SolidOptions};

/// Element length at the clamped base, in √(R t).
const BASE: f64 = 0.3;
/// Element length at thickness steps and the liquid level, in √(R t).
const STEP: f64 = 0.4;
/// A ring that is closer than this to a joint of courses or the surface sits on the nodes there, in √(R t).
const NEAR_RING: f64 = 0.2;
/// Largest element length, in √(R t).
const LARGEST: f64 = 1.3;
/// Growth of the element length from one element to the next.
const GROWTH: f64 = 1.15;
/// Sectors of the full circle.
const SECTORS: f64 = 56.0;
/// Liquid elements over the radius.
const RADIAL: f64 = 16.0;
/// Exponent of the grading r/R = 1 − (1 − s)^p towards the wall.
const RADIAL_GRADING: f64 = 1.4;
/// Liquid elements over the depth of a tank no deeper than its radius.
const VERTICAL: f64 = 16.0;
/// Exponent of the grading z/H = 1 − (1 − s)^p towards the surface.
const VERTICAL_GRADING: f64 = 1.4;
/// Elements over half a side of a rectangle that is no longer than twice the height of its walls; with longer ones the number goes with
/// the root of the length.
const HALF_SIDE: f64 = 10.0;
/// Half a side over the height of the walls beyond which elements grow longer with the side.
const LONG: f64 = 16.0;
/// Liquid elements over the depth of a rectangle no deeper than half its shorter side.
const BOX_VERTICAL: f64 = 12.0;
/// Largest count of elements in one direction that is accepted.
const MOST: usize = 4000;

/// Division of a tank.
#[derive(Clone, Debug, PartialEq)]
pub struct Division {
    /// Radii of the liquid's nodes, from 0 to R [m]; for a rectangle the x of one half.
    pub radii: Vec<f64>,
    /// y of the nodes of half the breadth of a rectangle, from 0 [m]; empty for a circle.
    pub breadth: Vec<f64>,
    /// Sectors of the circle, or elements around the four walls of a rectangle.
    pub sectors: usize,
    /// Heights of the wall's nodes, from 0 to the top [m].
    pub wall: Vec<f64>,
    /// Heights of the liquid's nodes, from 0 to the fill height [m].
    pub liquid: Vec<f64>,
}

impl Division {
    /// The division of a tank filled to `depth` [m]. `matching` asks for liquid nodes at the heights of the wall's.
    ///
    /// Errors: a count of zero, or of fewer than 3 sectors; a count beyond reason.
    pub fn new(
        tank: &Tank,
        depth: f64,
        options: &Options,
        solid: &SolidOptions,
        matching: bool,
    ) -> Result<Division, FeError> {
        let radius = tank.shape.half_length();
        if let Shape::Rectangle { breadth, .. } = tank.shape {
            return Division::of_rectangle(tank, depth, breadth, options, solid);
        }
        if let Some(size) = solid.mesh {
            check(size, true)?;
            let wall = uniform_wall(tank, depth, size.vertical);
            return Ok(Division {
                radii: graded(radius, size.radial, 1.0),
                breadth: Vec::new(),
                sectors: size.sectors,
                liquid: wetted(&wall, depth),
                wall,
            });
        }
        let refine = options.refine;
        check_levels(tank, depth, refine)?;
        let wall = wall_levels(tank, depth, refine);
        let count = |n: f64| ((n * refine).round() as usize).max(3);
        let slender = (depth / radius).max(1.0);
        Ok(Division {
            radii: graded(radius, count(RADIAL), RADIAL_GRADING),
            breadth: Vec::new(),
            // A multiple of four keeps both planes of symmetry.
            sectors: (4 * count(SECTORS / 4.0)).max(sectors(&solid.imperfections, tank).next_multiple_of(4)),
            liquid: if matching {
                wetted(&wall, depth)
            } else {
                graded(depth, count(VERTICAL * slender.min(4.0)), VERTICAL_GRADING)
            },
            wall,
        })
    }

    /// The same of a rectangle: the plan is finer towards the corners, and where the walls are long against their height.
    ///
    /// Errors: as [`Division::new`]; an odd number of elements over the breadth, which leaves no node in its middle.
    fn of_rectangle(
        tank: &Tank,
        depth: f64,
        breadth: f64,
        options: &Options,
        solid: &SolidOptions,
    ) -> Result<Division, FeError> {
        let halves = [tank.shape.half_length(), 0.5 * breadth];
        if let Some(size) = solid.mesh {
            check(size, false)?;
            let wall = uniform_wall(tank, depth, size.vertical);
            return Ok(Division {
                radii: graded(halves[0], size.radial, 1.0),
                breadth: graded(halves[1], size.sectors / 2, 1.0),
                sectors: 4 * (size.radial + size.sectors / 2),
                liquid: wetted(&wall, depth),
                wall,
            });
        }
        let refine = options.refine;
        check_levels(tank, depth, refine)?;
        let count = |n: f64| ((n * refine).round() as usize).max(3);
        let height = tank.wall_height();
        let counts = halves.map(|half| count(HALF_SIDE * (half / height).clamp(1.0, LONG).sqrt()));
        let shortest = halves[0].min(halves[1]);
        Ok(Division {
            radii: graded(halves[0], counts[0], RADIAL_GRADING),
            breadth: graded(halves[1], counts[1], RADIAL_GRADING),
            sectors: 4 * (counts[0] + counts[1]),
            liquid: graded(depth, count(BOX_VERTICAL * (depth / shortest).clamp(1.0, 4.0)), VERTICAL_GRADING),
            wall: wall_levels(tank, depth, refine),
        })
    }

    /// The plan of a rectangle.
    pub(super) fn plan(&self) -> Option<Plan> {
        (!self.breadth.is_empty()).then(|| Plan::new(&self.radii, &self.breadth))
    }

    /// Numbers of elements of the division.
    pub fn size(&self) -> MeshSize {
        let half = self.breadth.len().saturating_sub(1);
        MeshSize {
            radial: self.radii.len() - 1,
            sectors: if half > 0 { 2 * half } else { self.sectors },
            vertical: self.wall.len() - 1,
        }
    }
}

fn check(size: MeshSize, round: bool) -> Result<(), FeError> {
    let least = if round { 4 } else { 2 };
    let sides = if round { "mesh, sectors" } else { "mesh, elements over the breadth" };
    if !round && !size.sectors.is_multiple_of(2) {
        return Err(FeError::option(
            sides,
            size.sectors.to_string(),
            "an even number: the middle of the wall is where results are read",
        ));
    }
    for (option, found, least) in [
        ("mesh, elements over the radius", size.radial, 1),
        (sides, size.sectors, least),
        ("mesh, elements over the height", size.vertical, 1),
    ] {
        if !(least..=MOST).contains(&found) {
            return Err(FeError::option(option, found.to_string(), format!("{least} to {MOST}")));
        }
    }
    Ok(())
}

/// `count` elements from 0 to `length`, finer towards the end for an exponent > 1.
fn graded(length: f64, count: usize, exponent: f64) -> Vec<f64> {
    (0..=count)
        .map(|k| match k {
            0 => 0.0,
            k if k == count => length,
            k => length * (1.0 - (1.0 - k as f64 / count as f64).powf(exponent)),
        })
        .collect()
}

/// Nodes of the wall up to the liquid level.
fn wetted(wall: &[f64], depth: f64) -> Vec<f64> {
    let tolerance = 1e-6 * depth;
    let mut z: Vec<f64> = wall.iter().copied().filter(|z| *z < depth - tolerance).collect();
    z.push(depth);
    z
}

/// Heights at which the wall changes: base, joints of courses, liquid level, top; closer than 1e-6 of the height are one. A ring is one, too,
/// unless it is so near to another that its nodes serve.
fn features(tank: &Tank, depth: f64) -> Vec<f64> {
    let height = tank.wall_height();
    let mut cuts = vec![0.0];
    for course in &tank.courses {
        cuts.push(cuts[cuts.len() - 1] + course.height);
    }
    *cuts.last_mut().expect("the base is always there") = height;
    if cuts.iter().all(|c| (c - depth).abs() > 1e-6 * height) && depth < height {
        cuts.push(depth);
    }
    for ring in &tank.rings {
        let near = NEAR_RING * (tank.shape.half_length() * tank.course_at(ring.height).thickness).sqrt();
        if cuts.iter().all(|c| (c - ring.height).abs() > near) && ring.height < height {
            cuts.push(ring.height);
        }
    }
    cuts.sort_by(f64::total_cmp);
    cuts
}

/// About `count` elements of equal length, with nodes at the features of the wall.
fn uniform_wall(tank: &Tank, depth: f64, count: usize) -> Vec<f64> {
    let cuts = features(tank, depth);
    let height = tank.wall_height();
    let lengths: Vec<f64> = cuts.windows(2).map(|c| c[1] - c[0]).collect();
    let mut shares: Vec<usize> = vec![1; lengths.len()];
    // One element more where the elements are longest, until the count is reached.
    while shares.iter().sum::<usize>() < count {
        let longest = (0..shares.len())
            .max_by(|&a, &b| {
                let length = |i: usize| lengths[i] / shares[i] as f64;
                length(a).total_cmp(&length(b)).then(b.cmp(&a))
            })
            .expect("the wall has a height");
        shares[longest] += 1;
    }
    let mut z = vec![0.0];
    for (pair, &n) in cuts.windows(2).zip(&shares) {
        z.extend((1..=n).map(|k| pair[0] + (pair[1] - pair[0]) * k as f64 / n as f64));
    }
    *z.last_mut().expect("the base is always there") = height;
    z
}

/// Heights of the wall's nodes by the rule of the module's theory [m], in elements `refine` times as short.
pub(crate) fn wall_levels(tank: &Tank, depth: f64, refine: f64) -> Vec<f64> {
    based_levels(tank, depth, BASE, refine)
}

/// The same with elements of `base` √(R t) at the base.
pub(crate) fn based_levels(tank: &Tank, depth: f64, base: f64, refine: f64) -> Vec<f64> {
    let mut nodes = vec![0.0];
    for ([from, to], sums) in cumulated(tank, depth, base, refine) {
        let step = (to - from) / PARTS as f64;
        let total = sums[PARTS];
        let count = elements(total);
        for k in 1..count as usize {
            let wanted = total * k as f64 / count;
            let place = sums.partition_point(|s| *s < wanted).max(1);
            let share = (wanted - sums[place - 1]) / (sums[place] - sums[place - 1]);
            nodes.push(from + step * ((place - 1) as f64 + share));
        }
        nodes.push(to);
    }
    nodes
}

/// Most elements over the height of the wall that are laid out.
const MOST_LEVELS: f64 = 20_000.0;

/// Refuses walls so slender or thin that the rule of the module's theory makes more than [`MOST_LEVELS`] elements, before any is
/// laid out.
///
/// Errors: that, with the number.
pub(crate) fn check_levels(tank: &Tank, depth: f64, refine: f64) -> Result<(), FeError> {
    let count: f64 = cumulated(tank, depth, BASE, refine).iter().map(|(_, sums)| elements(sums[PARTS])).sum();
    if count <= MOST_LEVELS {
        return Ok(());
    }
    Err(FeError::option(
        "mesh, elements over the height by √(R t)",
        format!("{count:.3e}"),
        format!("at most {MOST_LEVELS}; check radius, heights and thicknesses of the wall"),
    ))
}

/// Parts between two features of the wall in which ∫ dz/h is summed up.
const PARTS: usize = 2000;

/// Elements between two features over which ∫ dz/h is `total`.
fn elements(total: f64) -> f64 {
    (total - 0.2).ceil().max(1.0)
}

/// Cumulative ∫ dz/h between the features of the wall: their ends, the sums.
fn cumulated(tank: &Tank, depth: f64, base: f64, refine: f64) -> Vec<([f64; 2], Vec<f64>)> {
    let cuts = features(tank, depth);
    let height = tank.wall_height();
    let radius = tank.shape.half_length();
    let bending = |z: f64| match tank.shape {
        Shape::Cylinder { .. } => (radius * tank.course_at(z).thickness).sqrt(),
        // A plane wall bends over its whole height.
        Shape::Rectangle { .. } => height / 24.0,
    };
    let thinner = |z: f64| bending((z - 1e-6 * height).max(0.0)).min(bending(z + 1e-6 * height));
    let seeds: Vec<(f64, f64)> =
        cuts[..cuts.len() - 1].iter().map(|&z| (z, if z == 0.0 { base } else { STEP } * thinner(z))).collect();
    let length = |z: f64| {
        seeds
            .iter()
            .map(|(at, h)| h + (GROWTH - 1.0) * (z - at).abs())
            .fold(LARGEST * bending(z), f64::min)
            .min(height / 12.0)
            / refine
    };
    cuts.windows(2)
        .map(|pair| {
            let step = (pair[1] - pair[0]) / PARTS as f64;
            let mut sums = vec![0.0];
            for k in 0..PARTS {
                sums.push(sums[k] + step / length(pair[0] + (k as f64 + 0.5) * step));
            }
            ([pair[0], pair[1]], sums)
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use tank::reference::broad;

    #[test]
    fn nodes_lie_where_the_wall_changes_and_are_fine_at_the_base() {
        let tank = broad(1000.0).tank;
        let options = Options::default();
        let division = Division::new(&tank, 1.525, &options, &SolidOptions::default(), false).unwrap();
        for z in [0.0, 0.915, 1.525, 1.83] {
            assert!(division.wall.iter().any(|n| (n - z).abs() < 1e-12), "no node at {z}");
        }
        let l = (1.83_f64 * 2.03e-3).sqrt();
        assert!(division.wall[1] <= BASE * l * 1.2 && division.wall[1] > 0.6 * BASE * l);
        for w in division.wall.windows(3) {
            let ratio = (w[2] - w[1]) / (w[1] - w[0]);
            assert!((0.5..2.0).contains(&ratio), "neighbours {w:?}");
        }
        assert_eq!(division.liquid.last(), Some(&1.525));
        assert_eq!(division.sectors % 4, 0);
        let fine = Options { refine: 2.0, ..Options::default() };
        let twice = Division::new(&tank, 1.525, &fine, &SolidOptions::default(), true).unwrap();
        let ratio = twice.wall.len() as f64 / division.wall.len() as f64;
        assert!((1.8..2.2).contains(&ratio), "{ratio}");
        assert!(twice.liquid.iter().all(|z| twice.wall.iter().any(|w| (w - z).abs() < 1e-9)));
    }

    #[test]
    fn numbers_are_taken_and_bad_ones_refused() {
        let tank = broad(1000.0).tank;
        let solid = |radial, sectors, vertical| SolidOptions {
            mesh: Some(MeshSize { radial, sectors, vertical }),
            ..SolidOptions::default()
        };
        let options = Options::default();
        let division = Division::new(&tank, 1.525, &options, &solid(12, 16, 20), true).unwrap();
        assert_eq!(division.size(), MeshSize { radial: 12, sectors: 16, vertical: 20 });
        for bad in [solid(0, 16, 20), solid(12, 3, 20), solid(12, 16, 0), solid(12, 16, 100_000)] {
            assert!(matches!(Division::new(&tank, 1.525, &options, &bad, true), Err(FeError::Option { .. })));
        }
    }
}
