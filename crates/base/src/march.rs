//! Lifting a strip step by step: Newton's method under a given uplift of the rim.

use crate::band::Band;
use crate::element::{Answer, Element, GAUSS, SIZE};
use crate::error::BaseError;
use crate::strip::{Plan, Rim, Strip};

/// Steps of the liquid's pressure on the way to rest.
const FILLING: usize = 8;
/// Smallest share of the pressure in a step on that way.
const SMALLEST_SHARE: f64 = 1e-5;
/// Iterations of a step.
const ITERATIONS: usize = 40;
/// Corrections in a row that grow: the step of the uplift is too long. On the way to rest the contact of hard ground makes many grow.
const DIVERGES: usize = 2;
/// Largest correction [m].
const FARTHEST: f64 = 10.0;
/// Shortest step of the uplift [m].
const SHORTEST: f64 = 1e-9;

/// A state of a strip, per metre of the rim.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// Uplift of the rim w [m], from the ground without load.
    pub uplift: f64,
    /// Pull of the plate on the wall, downwards, F [N/m]; negative where the plate carries the wall.
    pub hold_down: f64,
    /// Rotation θ of the rim [rad], positive where the plate rises outwards.
    pub rotation: f64,
    /// Bending moment of the plate at the rim [N], positive where its underside is in tension.
    pub rim_moment: f64,
    /// Membrane force of the plate at the rim, tension positive, N [N/m].
    pub axial_force: f64,
    /// Distance from the rim to the ground l [m].
    pub lifted_width: f64,
    /// Plastic rotation of the joint [rad].
    pub plastic_rotation: f64,
}

/// A strip in a state of equilibrium.
#[derive(Clone, Debug)]
pub struct Lifted<'a> {
    strip: &'a Strip,
    /// u, w, θ of each node.
    x: Vec<f64>,
    plastic: Plastic,
    /// Forces and tangent of this state, where they are known.
    system: Option<System>,
}

/// Plastic strains of all fibres, and which sections have any.
#[derive(Clone, Debug)]
struct Plastic {
    strains: Vec<f64>,
    yielded: Vec<bool>,
}

impl Plastic {
    fn of(strains: Vec<f64>, elements: usize) -> Plastic {
        let each = strains.len() / (3 * elements);
        let yielded = |section: usize| strains[section * each..(section + 1) * each].iter().any(|p| *p != 0.0);
        Plastic { yielded: (0..3 * elements).map(yielded).collect(), strains }
    }

    /// Places of an element: all plates have a yield stress, or none has.
    fn range(&self, element: usize) -> std::ops::Range<usize> {
        let each = 3 * self.strains.len() / self.yielded.len();
        element * each..(element + 1) * each
    }

    fn at(&self, element: usize) -> (&[f64], &[bool]) {
        (&self.strains[self.range(element)], &self.yielded[3 * element..3 * element + 3])
    }

    fn at_mut(&mut self, element: usize) -> (&mut [f64], &mut [bool]) {
        let range = self.range(element);
        (&mut self.strains[range], &mut self.yielded[3 * element..3 * element + 3])
    }
}

/// The plate of a strip in a state.
#[derive(Clone, Debug)]
pub(crate) struct Shape {
    /// Deflections of the nodes, upwards [m].
    pub(crate) deflections: Vec<f64>,
    /// Which elements have yielded.
    pub(crate) yielded: Vec<bool>,
}

/// What is given at the rim.
#[derive(Clone, Copy)]
enum Given {
    /// The hold-down force [N/m], and the share of the pressures.
    Force(f64, f64),
    /// The uplift [m], under the full pressure.
    Uplift(f64),
}

/// A step of a state.
struct Step<'a, 'b> {
    state: &'a mut Lifted<'b>,
    given: Given,
}

impl pulp::WithSimd for Step<'_, '_> {
    type Output = bool;

    #[inline(always)]
    fn with_simd<S: pulp::Simd>(self, _: S) -> bool {
        self.state.stepped(self.given)
    }
}

#[derive(Clone, Debug)]
struct System {
    residual: Vec<f64>,
    tangent: Band,
    /// Plastic strains that the displacements ask for.
    plastic: Plastic,
}

impl<'a> Lifted<'a> {
    /// At rest: the plate under its liquid, the rim under a wall of `weight` [N/m].
    ///
    /// The liquid widens the wall and turns its foot, which presses the rim down; a strip that starts flat misses it.
    ///
    /// Errors: no equilibrium.
    pub fn at_rest(strip: &'a Strip, weight: f64) -> Result<Lifted<'a>, BaseError> {
        let elements = strip.cubics.len();
        let fibres: usize = (0..elements).map(|i| 3 * strip.plate(i).fibres()).sum();
        let mut state = Lifted {
            strip,
            x: vec![0.0; 3 * strip.nodes.len()],
            plastic: Plastic::of(vec![0.0; fibres], elements),
            system: None,
        };
        // All of the plate sunk evenly: near the answer, and in contact everywhere.
        let mut step = 1.0 / FILLING as f64;
        for w in state.x.iter_mut().skip(1).step_by(3) {
            *w = -step * strip.pressure / strip.modulus;
        }
        let mut share = 0.0;
        while share < 1.0 {
            let next = f64::min(share + step, 1.0);
            if state.step(Given::Force(-weight * next, next)) {
                share = next;
                continue;
            }
            step /= 2.0;
            if step < SMALLEST_SHARE {
                return Err(BaseError::NoEquilibrium { uplift: state.uplift(), step: 0.0 });
            }
        }
        Ok(state)
    }

    /// What makes up the state without its strip: displacements and plastic strains.
    pub(crate) fn into_parts(self) -> (Vec<f64>, Vec<f64>) {
        (self.x, self.plastic.strains)
    }

    /// The state again, of the same strip.
    pub(crate) fn of_parts(strip: &'a Strip, (x, plastic): (Vec<f64>, Vec<f64>)) -> Lifted<'a> {
        Lifted { strip, x, plastic: Plastic::of(plastic, strip.cubics.len()), system: None }
    }

    /// Uplift of the rim [m].
    pub fn uplift(&self) -> f64 {
        self.x[self.strip.rim_at() + 1]
    }

    /// Lifts or lowers the rim to `uplift` [m].
    ///
    /// Errors: no equilibrium at the smallest step; the state is then the last one found.
    pub fn lift_to(&mut self, uplift: f64) -> Result<(), BaseError> {
        let mut step = uplift - self.uplift();
        while self.uplift() != uplift {
            let rest = uplift - self.uplift();
            let target = if rest.abs() <= step.abs() * (1.0 + 1e-9) { uplift } else { self.uplift() + step };
            if self.step(Given::Uplift(target)) {
                continue;
            }
            step /= 2.0;
            if step.abs() < SHORTEST {
                return Err(BaseError::NoEquilibrium { uplift, step });
            }
        }
        Ok(())
    }

    /// One step, in the widest registers there are; false, and nothing changed, where it does not converge.
    fn step(&mut self, given: Given) -> bool {
        pulp::Arch::new().dispatch(Step { state: self, given })
    }

    #[inline(always)]
    fn stepped(&mut self, given: Given) -> bool {
        let (n, rim) = (self.x.len(), self.strip.rim_at());
        let mut x = self.x.clone();
        let mut dx = vec![0.0; n];
        let known = self.system.take();
        let mut system = known.unwrap_or_else(|| self.system(&x, given));
        if let Given::Uplift(w) = given {
            // The change of the rim is spread by the first solve, not left to one element.
            let change = w - self.uplift();
            for (i, (d, residual)) in dx.iter_mut().zip(&system.residual).enumerate() {
                *d = -residual - system.tangent.get(i, rim + 1) * change;
            }
            self.solve(&mut system.tangent, &mut dx, Some(change));
            if !dx.iter().all(|v| v.is_finite()) {
                return false;
            }
            x.iter_mut().zip(&dx).for_each(|(x, d)| *x += d);
        }
        let (mut before, mut growing) = (f64::INFINITY, 0);
        for _ in 0..ITERATIONS {
            self.assemble(&x, given, &mut system);
            dx.iter_mut().zip(&system.residual).for_each(|(d, r)| *d = -r);
            let solved = self.solve(&mut system.tangent, &mut dx, matches!(given, Given::Uplift(_)).then_some(0.0));
            if !solved {
                return false;
            }
            // Displacements and rotations times the plate's thickness are lengths: settled to a thousandth of a micrometre.
            let t = self.strip.bands.rim().thickness;
            let moved = dx.chunks_exact(3).map(|d| d[0].abs().max(d[1].abs()).max(t * d[2].abs()));
            let largest = moved.fold(0.0, f64::max);
            growing = if largest > before { growing + 1 } else { 0 };
            before = largest;
            let too_long = matches!(given, Given::Uplift(_)) && growing == DIVERGES;
            if !largest.is_finite() || largest > FARTHEST || too_long {
                return false;
            }
            x.iter_mut().zip(&dx).for_each(|(x, d)| *x += d);
            if largest < 1e-9 {
                if let Given::Uplift(w) = given {
                    x[rim + 1] = w;
                }
                self.assemble(&x, given, &mut system);
                self.x = x;
                std::mem::swap(&mut self.plastic, &mut system.plastic);
                // The system is kept for the whole pressure alone: the next step may have another share.
                self.system = matches!(given, Given::Uplift(_)).then_some(system);
                return true;
            }
        }
        false
    }

    #[inline(always)]
    fn solve(&self, tangent: &mut Band, dx: &mut [f64], rim: Option<f64>) -> bool {
        let at = self.strip.rim_at();
        let turned = (self.strip.rim == Rim::Clamped).then_some((at + 2, 0.0));
        let lifted = rim.map(|change| (at + 1, change));
        for (i, value) in [Some((0, 0.0)), Some((2, 0.0)), lifted, turned].into_iter().flatten() {
            tangent.fix(i);
            dx[i] = value;
        }
        tangent.solve(dx)
    }

    fn system(&self, x: &[f64], given: Given) -> System {
        let mut system =
            System { residual: vec![0.0; x.len()], tangent: Band::new(x.len()), plastic: self.plastic.clone() };
        self.assemble(x, given, &mut system);
        system
    }

    /// Forces and tangent at `x`, in the place of those of another state.
    #[inline(always)]
    fn assemble(&self, x: &[f64], given: Given, system: &mut System) {
        let (strip, rim) = (self.strip, self.strip.rim_at());
        let share = match given {
            Given::Force(_, share) => share,
            Given::Uplift(_) => 1.0,
        };
        system.residual.fill(0.0);
        system.tangent.clear();
        for i in 0..strip.cubics.len() {
            let element = strip.element(i, share);
            let answer = element.respond(&unknowns(x, i), self.plastic.at(i), system.plastic.at_mut(i));
            for (own, force) in system.residual[3 * i..].iter_mut().zip(answer.force) {
                *own += force;
            }
            system.tangent.add_block(3 * i, &answer.tangent);
        }
        if let Rim::Wall(edge) = &strip.rim {
            let edge = edge.stiffness();
            // δ = u, δ′ = −θ.
            let (u, turn) = (x[rim] - share * edge.free[0], -x[rim + 2] - share * edge.free[1]);
            let k = edge.k;
            system.residual[rim] += k[0][0] * u + k[0][1] * turn;
            system.residual[rim + 2] -= k[1][0] * u + k[1][1] * turn;
            system.tangent.add(rim, rim, k[0][0]);
            system.tangent.add(rim + 2, rim, -k[1][0]);
            system.tangent.add(rim + 2, rim + 2, k[1][1]);
        }
        if let Given::Force(force, _) = given {
            system.residual[rim + 1] -= force;
        }
    }

    /// Response of an element in this state.
    fn respond(&self, i: usize) -> Answer {
        let old = self.plastic.at(i);
        let (mut new, mut yielded) = (vec![0.0; old.0.len()], [false; 3]);
        self.strip.element(i, 1.0).respond(&unknowns(&self.x, i), old, (&mut new, &mut yielded))
    }

    /// What the strip does in this state.
    pub fn point(&self) -> Point {
        let strip = self.strip;
        let rim = strip.rim_at();
        let hold_down = match &self.system {
            Some(system) => system.residual[rim + 1],
            None => self.system(&self.x, Given::Uplift(self.uplift())).residual[rim + 1],
        };
        // Forces of the plate alone: the edge of the wall is what they meet.
        let outer = self.respond(rim / 3 - 1);
        Point {
            uplift: self.uplift(),
            hold_down,
            rotation: self.x[rim + 2],
            rim_moment: outer.force[5],
            axial_force: outer.force[3],
            lifted_width: self.lifted_width(),
            plastic_rotation: self.plastic_rotation(),
        }
    }

    /// The plate in this state.
    pub(crate) fn shape(&self) -> Shape {
        Shape {
            deflections: self.x.iter().skip(1).step_by(3).copied().collect(),
            yielded: self.plastic.yielded.chunks_exact(3).map(|s| s.contains(&true)).collect(),
        }
    }

    /// Distance from the rim to the first point on the ground [m].
    fn lifted_width(&self) -> f64 {
        let strip = self.strip;
        if self.uplift() <= 0.0 {
            return 0.0;
        }
        let mut before = (strip.length(), self.uplift());
        for i in (0..strip.rim_at() / 3).rev() {
            let element = strip.element(i, 1.0);
            let q = unknowns(&self.x, i);
            for (point, (x, _)) in GAUSS.iter().enumerate().rev() {
                let here = (strip.nodes[i] + x * element.cubics.length, element.deflection(&q, point));
                if here.1 <= 0.0 {
                    let crossing = here.0 + (before.0 - here.0) * -here.1 / (before.1 - here.1);
                    return strip.length() - crossing;
                }
                before = here;
            }
        }
        strip.length()
    }

    /// Plastic rotation of the joint: curvature less M/D, from the rim to where its sign changes [rad].
    fn plastic_rotation(&self) -> f64 {
        let strip = self.strip;
        let (mut sum, mut sign) = (0.0_f64, 0.0);
        for i in (0..strip.rim_at() / 3).rev() {
            let yielded = &self.plastic.yielded[3 * i..3 * i + 3];
            if !yielded.contains(&true) {
                continue;
            }
            let (answer, stiffness) = (self.respond(i), strip.plate(i).bending_stiffness());
            for (g, (_, weight)) in GAUSS.iter().enumerate().rev() {
                if !yielded[g] {
                    continue;
                }
                let plastic = answer.curvature[g] - answer.sections[g].m / stiffness;
                if sign == 0.0 {
                    sign = plastic.signum();
                }
                if plastic.signum() != sign {
                    return sum.abs();
                }
                sum += weight * strip.cubics[i].length * plastic;
            }
        }
        sum.abs()
    }
}

fn unknowns(x: &[f64], element: usize) -> [f64; SIZE] {
    let mut q = [0.0; SIZE];
    q.copy_from_slice(&x[3 * element..3 * element + SIZE]);
    q
}

impl Strip {
    /// First unknown of the rim.
    fn rim_at(&self) -> usize {
        3 * (self.nodes.len() - 1 - self.outside)
    }

    pub(crate) fn plate(&self, element: usize) -> &crate::plate::Plate {
        let middle = 0.5 * (self.nodes[element] + self.nodes[element + 1]);
        self.bands.at(self.length() - middle)
    }

    fn element(&self, i: usize, share: f64) -> Element<'_> {
        Element {
            cubics: &self.cubics[i],
            plate: self.plate(i),
            round: (self.plan == Plan::Round).then(|| (self.nodes[i], self.length())),
            modulus: self.modulus,
            // Outside the wall there is no liquid.
            pressure: if 3 * i < self.rim_at() { share * self.pressure } else { 0.0 },
        }
    }
}
