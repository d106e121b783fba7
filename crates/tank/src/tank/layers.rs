//! Walls of layers: single shells, liners, and two shells with an interlayer between them.

use serde::{Deserialize, Serialize};

use super::{Behaviour, Course, Material};
use crate::words;

/// A layer of a wall.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Layer {
    /// Kind.
    pub kind: LayerKind,
    /// Thickness [m].
    pub thickness: f64,
    /// Material.
    pub material: Material,
    /// Bars; of concrete shells only.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub reinforcement: Vec<Reinforcement>,
}

words! {
    /// Kind of a layer.
    pub LayerKind {
        /// Carries membrane forces and bending.
        Shell = "shell",
        /// Keeps two shells apart.
        Interlayer = "interlayer",
    }
}

/// A layer of bars.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Reinforcement {
    /// Direction of the bars.
    pub direction: BarDirection,
    /// Area of steel per length of wall [m²/m].
    pub area: f64,
    /// Distance of the axis of the bars from the inner face of their layer [m].
    pub depth: f64,
    /// Diameter of a bar [m], needed by the crack width.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub diameter: Option<f64>,
    /// Stress of prestressed bars where the layer has no strain, after losses [Pa] (nonlinear engine).
    #[serde(default, skip_serializing_if = "super::is_zero")]
    pub prestress: f64,
    /// Material.
    pub material: Material,
}

words! {
    /// Direction of bars.
    pub BarDirection {
        /// Around the tank; along the wall of a rectangle.
        Hoop = "hoop",
        /// Up the wall.
        Vertical = "vertical",
    }
}

/// Name of the equivalent material of a layered wall.
pub const EQUIVALENT: &str = "equivalent of the layers";

impl Course {
    /// A course of one material.
    pub fn uniform(height: f64, thickness: f64, material: Material) -> Course {
        Course { height, thickness, corrosion: 0.0, material, layers: Vec::new() }
    }

    /// A course of layers from inside to outside, at least one of them a shell. Layers of shell that touch are one
    /// shell (plane sections); an interlayer divides the wall into two.
    ///
    /// `thickness` and `material` are those of the homogeneous wall with the same membrane and bending stiffness and
    /// mass, which replaces the layers in the code procedures and the linear engines:
    ///
    /// ```text
    /// A = Σ E_i t_i        D = Σ over the shells of Σ E_i (t_i³/12 + t_i y_i²)
    /// t = (12 D/A)^½       E = A/t       ν = Σ ν_i E_i t_i/A       ρ = Σ ρ_i t_i/t (interlayer included)
    /// ```
    ///
    /// with y_i from the elastic centroid of the shell to which the layer belongs. The interlayer does not transmit
    /// shear, so the shells bend separately and their rigidities add; bars are neglected. Strengths of the
    /// homogeneous wall are unknown: checks that need them are omitted.
    pub fn layered(height: f64, layers: Vec<Layer>) -> Course {
        let shells = layers.iter().filter(|l| l.kind == LayerKind::Shell);
        let membrane: f64 = shells.clone().map(Layer::membrane).sum();
        let poisson: f64 = shells.map(|l| l.material.poisson_ratio * l.membrane()).sum();
        let mass: f64 = layers.iter().map(|l| l.material.density * l.thickness).sum();
        let bending: f64 = layers.split(|l| l.kind == LayerKind::Interlayer).map(bending_stiffness).sum();
        let thickness = (12.0 * bending / membrane).sqrt();
        Course {
            height,
            thickness,
            material: Material {
                family: None,
                name: EQUIVALENT.into(),
                youngs_modulus: membrane / thickness,
                poisson_ratio: poisson / membrane,
                density: mass / thickness,
                yield_strength: None,
                allowable_stress: None,
                behaviour: Behaviour::Elastic,
                volume_change: Default::default(),
            },
            corrosion: 0.0,
            layers,
        }
    }

    /// Layers from inside to outside; the one of its material where the course is uniform.
    pub fn build_up(&self) -> Vec<Layer> {
        if !self.layers.is_empty() {
            return self.layers.clone();
        }
        vec![Layer {
            kind: LayerKind::Shell,
            thickness: self.thickness,
            material: self.material.clone(),
            reinforcement: Vec::new(),
        }]
    }

    /// Distance from the inner to the outer face [m].
    pub fn total_thickness(&self) -> f64 {
        match self.layers.as_slice() {
            [] => self.thickness,
            layers => layers.iter().map(|l| l.thickness).sum(),
        }
    }

    /// Assumptions of the code procedures and the linear engines for a layered course; `None` for a uniform one.
    pub fn layer_assumption(&self) -> Option<&'static str> {
        if self.layers.is_empty() {
            return None;
        }
        Some(if self.layers.iter().any(|l| l.kind == LayerKind::Interlayer) {
            "Layered wall: a homogeneous one with the same membrane stiffness, bending stiffness and mass. The interlayer passes \
             no shear: the stiffnesses of the two shells add, each bends about its own axis, the interlayer counts for mass \
             only. Bars are left out. Stresses are those of the homogeneous wall, not of a layer."
        } else {
            "Layered wall: a homogeneous one with the same membrane stiffness, bending stiffness and mass (plane sections). Bars \
             are left out. Stresses are those of the homogeneous wall, not of a layer."
        })
    }
}

impl Layer {
    /// Mean spacing of stabilised cracks across the bars [m], the smaller of both directions; `None` without bars of known diameter.
    ///
    /// ```text
    /// s_rm = ⅔ φ/(3.6 ρ_eff) ,  ρ_eff = Σ A_s/Σ h_eff ,  h_eff = min(2.5 c, t/n)
    /// ```
    ///
    /// with the distance c of the axis of a layer of bars from the nearer face, the thickness t and the number n of layers of bars in
    /// this direction, φ = Σ A_s/Σ (A_s/φ).
    ///
    /// Source: CEB-FIP Model Code 1990, 7.4.3.1.1 (l_s,max = φ/(3.6 ρ_eff), mean ⅔ of it; h_eff of 7.4.2.2 for walls in tension).
    pub fn mean_crack_spacing(&self) -> Option<f64> {
        let of = |direction| {
            let bars: Vec<&Reinforcement> = self.reinforcement.iter().filter(|b| b.direction == direction).collect();
            let most = self.thickness / bars.len() as f64;
            let effective: f64 = (bars.iter()).map(|b| (2.5 * b.depth.min(self.thickness - b.depth)).min(most)).sum();
            let area: f64 = bars.iter().map(|b| b.area).sum();
            let diameter = self.bar_diameter(direction)?;
            Some(diameter * effective / (5.4 * area))
        };
        [BarDirection::Hoop, BarDirection::Vertical].into_iter().filter_map(of).reduce(f64::min)
    }

    /// Diameter of bars of one size with the area and the surface of those of this direction [m]: Σ A_s/Σ (A_s/φ); `None`
    /// without bars, or with one of unknown diameter.
    pub fn bar_diameter(&self, direction: BarDirection) -> Option<f64> {
        let bars = || self.reinforcement.iter().filter(|b| b.direction == direction);
        let area: f64 = bars().map(|b| b.area).sum();
        let surface = bars().map(|b| b.diameter.map(|d| b.area / d)).sum::<Option<f64>>()?;
        (surface > 0.0).then(|| area / surface)
    }

    /// E t [N/m].
    fn membrane(&self) -> f64 {
        self.material.youngs_modulus * self.thickness
    }
}

/// Σ E (t³/12 + t y²) of layers that touch, about their elastic centroid [N·m²/m]; without the factor 1/(1 − ν²), which
/// the equivalent wall has as well.
fn bending_stiffness(layers: &[Layer]) -> f64 {
    let (mut bottom, mut a, mut b, mut d) = (0.0, 0.0, 0.0, 0.0);
    for layer in layers {
        let (t, s) = (layer.thickness, layer.membrane());
        let middle = bottom + t / 2.0;
        a += s;
        b += s * middle;
        d += s * (t * t / 12.0 + middle * middle);
        bottom += t;
    }
    if a > 0.0 { d - b * b / a } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn layer(kind: LayerKind, thickness: f64, youngs_modulus: f64, density: f64) -> Layer {
        Layer {
            kind,
            thickness,
            material: Material {
                family: None,
                name: "m".into(),
                youngs_modulus,
                poisson_ratio: 0.2,
                density,
                yield_strength: Some(1e6),
                allowable_stress: None,
                behaviour: Behaviour::Elastic,
                volume_change: Default::default(),
            },
            reinforcement: Vec::new(),
        }
    }

    fn close(a: f64, b: f64) {
        assert!((a - b).abs() <= 1e-12 * b.abs(), "{a} {b}");
    }

    /// Rounding of the sums only, throughout.
    /// By hand, 30 cm with 7.5 cm²/m of 16 mm 4 cm below both faces: h_eff = 2 · 2.5 · 4 cm, 16 mm · 20 cm/(5.4 · 15 cm²/m); the hoops of
    /// twice the area have half of it. Bars of 10 and 20 mm with equal areas count as 13.3 mm.
    #[test]
    fn crack_spacing_by_hand() {
        let mut wall = layer(LayerKind::Shell, 0.3, 33e9, 2500.0);
        let bars = |direction, area, depth, diameter| Reinforcement {
            direction,
            area,
            depth,
            diameter,
            prestress: 0.0,
            material: wall.material.clone(),
        };
        let vertical = [0.04, 0.26].map(|z| bars(BarDirection::Vertical, 7.5e-4, z, Some(0.016)));
        let hoops = [0.04, 0.26].map(|z| bars(BarDirection::Hoop, 15e-4, z, Some(0.016)));
        let mixed = [0.01, 0.02].map(|d| bars(BarDirection::Hoop, 1e-3, 0.1, Some(d)));
        let unknown = bars(BarDirection::Hoop, 1e-3, 0.1, None);
        assert_eq!(wall.mean_crack_spacing(), None);
        wall.reinforcement = vertical.to_vec();
        let exact = 0.016 * 0.2 / (5.4 * 15e-4);
        assert!((wall.mean_crack_spacing().unwrap() - exact).abs() < 1e-12);
        wall.reinforcement.extend(hoops);
        assert!((wall.mean_crack_spacing().unwrap() - 0.5 * exact).abs() < 1e-12);
        wall.reinforcement = mixed.to_vec();
        assert!((wall.bar_diameter(BarDirection::Hoop).unwrap() - 0.04 / 3.0).abs() < 1e-12);
        wall.reinforcement.push(unknown);
        assert_eq!(wall.bar_diameter(BarDirection::Hoop), None);
    }

    #[test]
    fn one_shell_is_itself() {
        let course = Course::layered(3.0, vec![layer(LayerKind::Shell, 0.3, 34e9, 2540.0)]);
        close(course.thickness, 0.3);
        close(course.material.youngs_modulus, 34e9);
        close(course.material.poisson_ratio, 0.2);
        close(course.material.density, 2540.0);
        close(course.total_thickness(), 0.3);
        assert_eq!(course.material.yield_strength, None);
    }

    #[test]
    fn a_cut_shell_is_whole() {
        let halves = vec![layer(LayerKind::Shell, 0.1, 34e9, 2540.0), layer(LayerKind::Shell, 0.2, 34e9, 2540.0)];
        let course = Course::layered(3.0, halves);
        close(course.thickness, 0.3);
        close(course.material.youngs_modulus, 34e9);
        assert!(course.layer_assumption().is_some_and(|a| a.contains("plane sections")));
    }

    #[test]
    fn two_equal_shells_apart_double_the_modulus() {
        // A = 2 E t and D = 2 E t³/12: the same thickness with twice the modulus and the mass of all three layers.
        let course = Course::layered(
            3.0,
            vec![
                layer(LayerKind::Shell, 0.01, 210e9, 7850.0),
                layer(LayerKind::Interlayer, 0.05, 3e9, 1000.0),
                layer(LayerKind::Shell, 0.01, 210e9, 7850.0),
            ],
        );
        close(course.thickness, 0.01);
        close(course.material.youngs_modulus, 420e9);
        close(course.material.density * course.thickness, 2.0 * 78.5 + 50.0);
        close(course.total_thickness(), 0.07);
        assert!(course.layer_assumption().is_some_and(|a| a.contains("no shear")));
    }

    #[test]
    fn uniform_course_has_one_layer() {
        let material = layer(LayerKind::Shell, 0.3, 34e9, 2540.0).material;
        let course = Course::uniform(3.0, 0.3, material.clone());
        let layers = course.build_up();
        assert_eq!(layers.len(), 1);
        assert_eq!(layers[0].material, material);
        assert_eq!(course.layer_assumption(), None);
    }
}
