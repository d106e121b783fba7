//! The design spectrum of a procedure as the modes of an engine see it: the response-spectrum method.
//!
//! | procedure | structural modes, and what follows the ground (T = 0) | sloshing modes | wave |
//! |---|---|---|---|
//! | `ec8-2006` | max(S_e(T, ξ)/q, S_d(T)) | S_e(T, ξ) | S_e(T, ξ) |
//! | `api650-2020` | S_a(T) I/R_wi, 5 % | min(K S_a(T) I/R_wc, S_DS I/R_wi) | K S_a(T) I; as A_f beyond 4 s |
//! | `housner` | S_e(T, ξ) of the user | S_e(T, ξ) | S_e(T, ξ) |
//!
//! Vertical modes see S_ve of `ec8-2006` at the 3 % of its breathing mode, q = 1; the other procedures have no vertical spectrum here.
//!
//! These are the accelerations of the procedure itself, so that its column and that of the engine differ by masses, periods, levers and
//! the combination alone. Not reduced, q, R_wi and R_wc are 1, S_d and the limit by S_DS do not count. `housner` stands for a site that
//! gives the user's spectrum alone. Damping: ξ of the mode in EN 1998-1 (η); annex E has one for each part, 5 % and 0.5 % (K).

/// Acceleration [m/s²] at a period [s], 0 for the ground, and a damping ratio.
pub type Ordinates<'a> = Box<dyn Fn(f64, f64) -> f64 + 'a>;

/// Vertical motion for the modes of an engine.
pub struct Upwards<'a> {
    /// Vertical acceleration [m/s²] at a period [s], 0 for the ground, and a damping ratio.
    pub spectrum: Ordinates<'a>,
    /// Share of the horizontal action where the vertical one leads (EN 1998-1 4.3.3.5.2).
    pub beside: f64,
}

/// A design spectrum for the modes of an engine.
pub struct ModalAction<'a> {
    /// Longest period that it covers [s].
    pub longest: f64,
    /// Structural modes; at T = 0 what follows the ground.
    pub structural: Ordinates<'a>,
    /// Sloshing modes, for forces and stresses.
    pub sloshing: Ordinates<'a>,
    /// Sloshing modes, for the wave.
    pub wave: Ordinates<'a>,
    /// The spectrum in one sentence.
    pub assumption: String,
    /// Whether the procedure also asks for vertical motion, which the modes of horizontal motion leave out.
    pub vertical: bool,
    /// Its vertical motion, where the procedure combines it as EN 1998-1 4.3.3.5.2 does.
    pub upwards: Option<Upwards<'a>>,
}
