//! Bending resistance with axial force of a wall section, by strain compatibility.
//!
//! ```text
//! ε(y) = ε_cu3 (x − y)/x      concrete: η f_cd over λ x      bars: σ = E_s ε, |σ| ≤ f_yd, no limit of strain
//! N = Σ A_i σ_i − η f_cd λ x      M = Σ A_i σ_i (d_i − h/2) + η f_cd λ x (h − λ x)/2
//! λ = 0.8, η = 1, ε_cu3 = 3.5 ‰ up to f_ck = 50 MPa
//! ```
//!
//! with y from the compressed face, N positive in tension, x the depth of the neutral axis. N falls as x grows, so that x follows
//! from N by bisection. The compressed concrete that the bars displace is not deducted. Depths x > h, the wall pressed over its whole
//! thickness, are left out: a larger compression has no resistance here, which is safe and far from any tank.
//!
//! Source: EN 1992-1-1:2004 3.1.7(3), 3.2.7(2)b, 6.1, recalled.

/// A face of the wall.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Face {
    /// The wetted one.
    Inner,
    /// The dry one.
    Outer,
}

/// A layer of bars in one direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bars {
    /// Distance of their axis from the inner face [m].
    pub depth: f64,
    /// Area per length of wall [m²/m].
    pub area: f64,
    /// Diameter of a bar [m], where it is known.
    pub diameter: Option<f64>,
    /// Characteristic yield strength f_yk [Pa].
    pub yield_strength: f64,
    /// Young's modulus E_s [Pa].
    pub modulus: f64,
}

/// A section of the wall, 1 m wide.
#[derive(Clone, Debug, PartialEq)]
pub struct Section {
    /// Thickness h [m].
    pub thickness: f64,
    /// Characteristic cylinder strength f_ck [Pa].
    pub strength: f64,
    /// Young's modulus of the concrete E_cm [Pa].
    pub modulus: f64,
    /// Layers of bars across the section.
    pub bars: Vec<Bars>,
    /// Partial factors γ_c, γ_s.
    pub factors: (f64, f64),
}

/// Steps of the bisection: from the thickness of a wall down to rounding.
const STEPS: usize = 80;

impl Section {
    /// f_cd = f_ck/γ_c [Pa], α_cc = 1.
    pub fn design_strength(&self) -> f64 {
        self.strength / self.factors.0
    }

    /// f_yd of a layer [Pa].
    pub fn design_yield(&self, bars: &Bars) -> f64 {
        bars.yield_strength / self.factors.1
    }

    /// λ, η and ε_cu3 of the rectangular block.
    fn block(&self) -> (f64, f64, f64) {
        let over = (self.strength / 1e6 - 50.0).max(0.0);
        let crushing = if over > 0.0 { 2.6 + 35.0 * ((40.0 - over) / 100.0).max(0.0).powi(4) } else { 3.5 };
        (0.8 - over / 400.0, 1.0 - over / 200.0, crushing * 1e-3)
    }

    /// Distance of bars from the face opposite to `tension` [m].
    pub fn effective_depth(&self, bars: &Bars, tension: Face) -> f64 {
        match tension {
            Face::Inner => self.thickness - bars.depth,
            Face::Outer => bars.depth,
        }
    }

    /// Axial force [N/m] and moment [N·m/m] with the neutral axis at x [m] from the face opposite to `tension`.
    fn resultants(&self, x: f64, tension: Face) -> (f64, f64) {
        let (lambda, eta, crushing) = self.block();
        let h = self.thickness;
        let concrete = eta * self.design_strength() * lambda * x;
        let (mut n, mut m) = (-concrete, concrete * 0.5 * (h - lambda * x));
        for bars in &self.bars {
            let d = self.effective_depth(bars, tension);
            let f_yd = self.design_yield(bars);
            let force = bars.area * (bars.modulus * crushing * (d - x) / x).clamp(-f_yd, f_yd);
            n += force;
            m += force * (d - 0.5 * h);
        }
        (n, m)
    }

    /// Largest axial tension [N/m], Σ A_s f_yd.
    pub fn tension_resistance(&self) -> f64 {
        self.bars.iter().map(|b| b.area * self.design_yield(b)).sum()
    }

    /// M_Rd [N·m/m] with an axial force N [N/m], tension positive; it may be negative where the bars are not symmetric. None where
    /// the section does not resist N.
    pub fn bending_resistance(&self, n: f64, tension: Face) -> Option<f64> {
        let (mut low, mut high) = (1e-9 * self.thickness, self.thickness);
        // At x → 0 all bars yield in tension, up to 1e-9 of the concrete.
        if n > self.tension_resistance() || n < self.resultants(high, tension).0 {
            return None;
        }
        for _ in 0..STEPS {
            let x = 0.5 * (low + high);
            if self.resultants(x, tension).0 > n {
                low = x;
            } else {
                high = x;
            }
        }
        Some(self.resultants(high, tension).1)
    }

    /// Whether the section resists an axial force [N/m] together with a moment [N·m/m].
    pub fn resists(&self, n: f64, m: f64) -> bool {
        let inner = self.bending_resistance(n, Face::Inner);
        let outer = self.bending_resistance(n, Face::Outer);
        matches!((inner, outer), (Some(inner), Some(outer)) if m <= inner && -m <= outer)
    }

    /// Utilisation of a force and a moment: in tension 1/k with the largest k for which k N and k M are resisted (same eccentricity),
    /// in compression the moment over that resisted with N. Infinite without any resistance, and without bars.
    pub fn utilisation(&self, n: f64, m: f64) -> f64 {
        let whole = self.tension_resistance();
        if whole <= 0.0 {
            return f64::INFINITY;
        }
        if n <= 0.0 {
            let tension = if m >= 0.0 { Face::Inner } else { Face::Outer };
            return match self.bending_resistance(n, tension) {
                Some(limit) if limit > 0.0 => m.abs() / limit,
                _ => f64::INFINITY,
            };
        }
        let (mut low, mut high) = (0.0, whole / n);
        for _ in 0..STEPS {
            let k = 0.5 * (low + high);
            if self.resists(k * n, k * m) {
                low = k;
            } else {
                high = k;
            }
        }
        1.0 / (0.5 * (low + high))
    }
}

#[cfg(test)]
mod tests;
