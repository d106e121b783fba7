//! Waves that are not small: potential flow in a rigid upright tank by the expansion of the surface about the level at rest.
//!
//! In the frame of the tank the liquid has a potential whose normal derivative is zero at wall and floor, so that the modes of
//! small waves are a basis of all waves:
//!
//! ```text
//! φ = Σ a_j(t) Z_j(z) F_j(x, y)      Z_j = cosh k_j(z + H) / cosh k_j H      ψ = φ at z = η      W = φ_z at z = η
//!
//! η̇ = −∇η·∇ψ + (1 + |∇η|²) W
//! ψ̇ = −(g + a_v) η − a·x − ½ |∇ψ|² + ½ (1 + |∇η|²) W² − 2 ζ ω_j ψ_j
//!
//! φ⁽¹⁾ = ψ      φ⁽ᵐ⁾ = −Σ_{k=1}^{m−1} ηᵏ/k! ∂_zᵏ φ⁽ᵐ⁻ᵏ⁾      W⁽ᵐ⁾ = Σ_{k=0}^{m−1} ηᵏ/k! ∂_zᵏ⁺¹ φ⁽ᵐ⁻ᵏ⁾
//! ```
//!
//! W is cut at the order of the expansion, 1 to 3, its products are not: they keep the energy to about the next order, and are
//! nearer to fourth order than products that are cut. Order 1 is the linear theory.
//!
//! * [`Basis`]: the modes of a cylinder or of a strip, with their tables on quadrature points.
//! * [`Liquid`]: the rates of elevation and potential. [`Motion`], [`Sampled`]: what moves the tank.
//! * [`run`]: the march in time. [`Run`]: waves, pressures, forces, energy of a march.
//!
//! Limits: rigid wall, no breaking; a march stops where the surface becomes steep ([`Stop`]), and what it has until then is a
//! lower bound. Sources: Dommermuth & Yue 1987; West et al. 1987.

mod basis;
mod bessel;
mod burst;
mod expansion;
mod forces;
mod motion;
mod quadrature;
mod run;

pub use basis::{Basis, Mode, Place, Shape, Side};
pub use bessel::{bessel_j, bessel_j_prime_zero};
pub use burst::{Burst, RESONANCE};
pub use expansion::{Liquid, Properties};
pub use forces::{Forces, Probe};
pub use motion::{Drive, Motion, Sampled};
pub use run::{BREAKING, Energy, Frame, Reason, Run, Stop, run};
