//! Joints that open: a stiff block under an eccentric force, blocks pressed and lifted, augmented Lagrangian.
//!
//! Source:    C7 of the theory sheet; the rigid block on a bed without tension is the text-book case of the open kern
//! Model:     block 1 × 0.5 × 1 m, 4 × 1 × 1 bricks, E = 3·10⁵ m · k_n, force N at x = e beyond the kern; the same block
//!            without eccentricity, pressed and lifted; the same between joint and springs
//! Reference: closed length 3 (b/2 − e), largest pressure 2 N/(closed length · d), by equilibrium; k_n r of the residual;
//!            with k_b = E A/h, springs k_g, penalty K = k_n A: F_m = (P + k_g λ/K)/(1 + k_g/k_b + k_g/K), λ ← F_m
//! Tolerance: the block bends by 1.5 k_n b⁴/(E h³) = 5e-6 of the penetration; a stiffer one is lost in rounding

use std::sync::Arc;

use crate::{Answer, Failure, Reference, Row};
use fem::analysis::contact::{ContactReport, ContactSettings, settle};
use fem::assembly::Assembler;
use fem::chart::Chart;
use fem::dofs::{Dof, KINDS};
use fem::element::contact8::{Contact8, ContactLaw};
use fem::element::solid8::{Elastic, Kinematics, Solid8};
use fem::element::spring::{Direction, Spring};
use fem::linalg::{Ordering, Symbolic};
use fem::mesh::Face;
use fem::model::{Builder, Model};
use fem::state::State;

const BREADTH: f64 = 1.0;

const LENGTH: f64 = 0.5;

const HEIGHT: f64 = 1.0;

const CELLS: usize = 4;

const PENALTY: f64 = 1e6;

/// Force [N].
const FORCE: f64 = 1e3;

struct Block {
    model: Model,
    assembler: Assembler,
    symbolic: Arc<Symbolic>,
    state: State,
    /// Nodes of the bottom at y = 0, along x.
    bottom: Vec<usize>,
    /// Nodes of the top.
    top: Vec<usize>,
}

impl Block {
    /// A block of modulus `modulus` on a joint; `spring`: stiffness of all springs that hold its top.
    fn new(modulus: f64, law: ContactLaw, spring: f64) -> Result<Block, Failure> {
        let mut builder = Builder::new();
        let (mut ground, mut bottom, mut top) = (Vec::new(), Vec::new(), Vec::new());
        for (z, list) in [(0.0, &mut ground), (0.0, &mut bottom), (HEIGHT, &mut top)] {
            for i in 0..=CELLS {
                for y in [0.0, LENGTH] {
                    list.push(builder.node([BREADTH * (i as f64 / CELLS as f64 - 0.5), y, z]));
                }
            }
        }
        for &node in &ground {
            Dof::TRANSLATIONS.iter().for_each(|&d| builder.hold(node, d));
        }
        // Rotation about y moves the bottom along z only.
        for &node in &bottom {
            builder.hold(node, Dof::Ux);
            builder.hold(node, Dof::Uy);
        }
        for &node in &top {
            builder.hold(node, Dof::Uy);
        }
        let quad = |list: &[usize], i: usize| [list[2 * i], list[2 * i + 2], list[2 * i + 3], list[2 * i + 1]];
        for i in 0..CELLS {
            let (low, high) = (quad(&bottom, i), quad(&top, i));
            let nodes: [usize; 8] = std::array::from_fn(|a| if a < 4 { low[a] } else { high[a - 4] });
            let corners = nodes.map(|n| builder.position(n));
            let material = Elastic::isotropic(modulus, 0.0, 0.0);
            builder.element("block", Solid8::new(nodes, corners, material, Kinematics::Linear)?);
            let under = quad(&ground, i);
            let face = Face { nodes: under, chart: under.map(|n| builder.position(n)) };
            let normals = [[0.0, 0.0, 1.0]; 4];
            builder.element("joint", Contact8::new(&face, Chart::Cartesian, low, under, normals, law)?);
        }
        if spring > 0.0 {
            for (&node, share) in top.iter().zip(shares()) {
                let up = Direction::Translation([0.0, 0.0, 1.0]);
                builder.element("spring", Spring::to_ground(node, up, spring * share)?);
            }
        }
        let model = builder.build()?;
        let assembler = Assembler::new(&model);
        let symbolic = Arc::new(Symbolic::new(assembler.pattern().clone(), &Ordering::MinimumDegree)?);
        let state = State::new(&model);
        Ok(Block { model, assembler, symbolic, state, bottom: bottom.into_iter().step_by(2).collect(), top })
    }

    /// Force `force` upwards on the top, as a pressure linear in x with its resultant at `eccentricity`.
    fn load(&mut self, force: f64, eccentricity: f64, passes: usize) -> Result<ContactReport, Failure> {
        let mut at = vec![0.0; self.model.nodes().len()];
        // Shares of the nodes, and their first moment Σ share x² on the block.
        let place = |node: usize| self.model.nodes()[node][0];
        let second: f64 = (self.top.iter().zip(shares())).map(|(&n, s)| s * place(n).powi(2)).sum();
        for (&node, share) in self.top.iter().zip(shares()) {
            at[node] = force * share * (1.0 + eccentricity * place(node) / second);
        }
        let load = self.model.vector(|node| {
            let mut f = [0.0; KINDS];
            f[2] = at[node];
            f
        });
        let settings = ContactSettings { passes, ..ContactSettings::default() };
        Ok(settle(&self.model, &self.assembler, &self.symbolic, &mut self.state, &load, &settings)?)
    }

    /// Displacement of the bottom along z at its nodes.
    fn gaps(&self) -> Vec<f64> {
        let at = |&n: &usize| self.model.at_node(&self.state.committed.u, n)[2];
        self.bottom.iter().map(at).collect()
    }
}

/// Shares of a uniform pressure at the nodes of the top.
fn shares() -> Vec<f64> {
    (0..=CELLS)
        .flat_map(|i| {
            let share = if i == 0 || i == CELLS { 0.25 } else { 0.5 };
            [share / CELLS as f64; 2]
        })
        .collect()
}

/// C7 with joints that open.
pub(super) fn rows() -> Answer {
    let mut rows = Vec::new();
    let closed = |formula| (formula, Reference::ClosedForm);
    let stiff = 3e5 * PENALTY;
    // Beyond the kern: e = b/3 leaves half of the base closed; the other case ends inside a face.
    for eccentricity in [BREADTH / 3.0, 0.27 * BREADTH] {
        let mut block = Block::new(
            stiff,
            ContactLaw {
                opening: fem::element::contact8::Opening::Unilateral { residual: 1e-9 },
                ..ContactLaw::unilateral(PENALTY)
            },
            0.0,
        )?;
        let report = block.load(-FORCE, eccentricity, 0)?;
        let g = block.gaps();
        let length = 3.0 * (0.5 * BREADTH - eccentricity);
        let slope = (g[0] - g[CELLS]) / BREADTH;
        for (what, (source, kind), exact, found, unit) in [
            ("closed length", closed("3 (b/2 − e)"), length, -g[CELLS] / slope, "m"),
            (
                "largest pressure",
                closed("2 N/(3 (b/2 − e) d)"),
                2.0 * FORCE / (length * LENGTH),
                -PENALTY * g[CELLS],
                "Pa",
            ),
            (
                "penetration reported",
                closed("largest pressure/k_n"),
                2.0 * FORCE / (length * LENGTH) / PENALTY,
                report.penetration[0],
                "m",
            ),
        ] {
            rows.push(Row::new(
                "C7",
                format!("stiff block, force at e = {eccentricity:.3} b: {what}"),
                (exact, source, kind),
                found,
                // Ten times the bending of the block.
                (5e-5, unit),
            ));
        }
    }
    // Strains are uniform: the modulus does not matter, and a soft block keeps its digits when it is lifted by metres.
    let mut block = Block::new(1e8, ContactLaw::unilateral(PENALTY), 0.0)?;
    block.load(-FORCE, 0.0, 0)?;
    let area = BREADTH * LENGTH;
    let worst = |g: &[f64], exact: f64| g.iter().map(|g| (g / exact - 1.0).abs()).fold(0.0, f64::max);
    rows.push(Row::new(
        "C7",
        "block pressed on a joint that may open: deviation of the penetration",
        (0.0, "uniform pressure", Reference::ClosedForm),
        worst(&block.gaps(), -FORCE / area / PENALTY),
        (1e-8, ""),
    ));
    // From the pressed state, then pulled: the residual carries the force.
    let report = block.load(1e-3 * FORCE, 0.0, 0)?;
    rows.push(Row::new(
        "C7",
        "the same lifted: deviation of the gap from F/(r k_n A)",
        (0.0, "residual stiffness", Reference::ClosedForm),
        worst(&block.gaps(), 1e-3 * FORCE / area / (1e-6 * PENALTY)),
        (1e-8, ""),
    ));
    rows.push(Row::new(
        "C7",
        "the same lifted: corners still closed",
        (0.0, "all open", Reference::ClosedForm),
        report.closed as f64,
        (0.0, ""),
    ));
    rows.extend(augmented()?);
    Ok(rows)
}

/// Penetration after 0 … 3 updates of the multipliers.
fn augmented() -> Answer {
    let area = BREADTH * LENGTH;
    let modulus = 1e8;
    let (block, bed) = (modulus * area / HEIGHT, PENALTY * area);
    let spring = 2.0 * bed;
    let mut wall = Block::new(modulus, ContactLaw::unilateral(PENALTY).augmented(), spring)?;
    let report = wall.load(-FORCE, 0.0, 3)?;
    let mut multiplier = 0.0;
    let mut rows = Vec::new();
    for (pass, &found) in report.penetration.iter().enumerate() {
        let force = (FORCE + spring * multiplier / bed) / (1.0 + spring / block + spring / bed);
        rows.push(Row::new(
            "C7",
            format!("block between joint and springs: penetration after {pass} updates of the multiplier"),
            ((force - multiplier) / bed, "three springs in a row, by hand", Reference::ClosedForm),
            found,
            (1e-8, "m"),
        ));
        multiplier = force;
    }
    Ok(rows)
}
