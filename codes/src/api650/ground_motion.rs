//! Ground motion of annex E (E.4): site coefficients and design spectrum of ASCE 7.
//!
//! ```text
//! S_MS = F_a S_s      S_M1 = F_v S_1      S_DS = Q S_MS      S_D1 = Q S_M1
//! T_0  = 0.2 S_D1/S_DS                    T_S  = S_D1/S_DS
//!
//! S_a(T) = S_DS (0.4 + 0.6 T/T_0)         0   ≤ T < T_0
//!          S_DS                           T_0 ≤ T ≤ T_S
//!          S_D1/T                         T_S < T ≤ T_L
//!          S_D1 T_L/T²                    T_L < T
//! ```
//!
//! All accelerations in g, at 5 % damping. Q = 2/3 scales the mapped motion to the design level; Q = 1 where the site is
//! not covered by ASCE 7 and the input is the design peak ground acceleration S_p, from which
//! `S_s = 2.5 S_p, S_1 = 1.25 S_p` (API 650, 12th edition, E.4.3; T_L = 4 s unless given).
//!
//! Site coefficients: ASCE 7-05 and 7-10 tables 11.4-1, 11.4-2 (those inside annex E), and ASCE 7-16; linear between the
//! columns, constant outside. Where ASCE 7-16 asks for a site study (class E above S_s = 0.75 g or S_1 = 0.1 g, class F)
//! there is no number to interpolate: the coefficients of that study must be given.

use crate::procedure::CodeError;
use tank::case::{Api650Site, SiteClass};

/// Abscissae and values of one row of a site-coefficient table; `values` is shorter where the table asks for a study.
struct Row {
    at: &'static [f64],
    values: &'static [f64],
}

const SS_2010: &[f64] = &[0.25, 0.5, 0.75, 1.0, 1.25];
const S1_2010: &[f64] = &[0.1, 0.2, 0.3, 0.4, 0.5];
const SS_2016: &[f64] = &[0.25, 0.5, 0.75, 1.0, 1.25, 1.5];
const S1_2016: &[f64] = &[0.1, 0.2, 0.3, 0.4, 0.5, 0.6];

/// Row of the table of F_a.
fn short_period_row(asce7: u16, class: SiteClass) -> Row {
    let (at, values): (_, &[f64]) = match (asce7, class) {
        (2016, SiteClass::A) => (SS_2016, &[0.8, 0.8, 0.8, 0.8, 0.8, 0.8]),
        (2016, SiteClass::B) => (SS_2016, &[0.9, 0.9, 0.9, 0.9, 0.9, 0.9]),
        (2016, SiteClass::C) => (SS_2016, &[1.3, 1.3, 1.2, 1.2, 1.2, 1.2]),
        (2016, SiteClass::D) => (SS_2016, &[1.6, 1.4, 1.2, 1.1, 1.0, 1.0]),
        (2016, SiteClass::E) => (SS_2016, &[2.4, 1.7, 1.3]),
        (_, SiteClass::A) => (SS_2010, &[0.8, 0.8, 0.8, 0.8, 0.8]),
        (_, SiteClass::B) => (SS_2010, &[1.0, 1.0, 1.0, 1.0, 1.0]),
        (_, SiteClass::C) => (SS_2010, &[1.2, 1.2, 1.1, 1.0, 1.0]),
        (_, SiteClass::D) => (SS_2010, &[1.6, 1.4, 1.2, 1.1, 1.0]),
        (_, SiteClass::E) => (SS_2010, &[2.5, 1.7, 1.2, 0.9, 0.9]),
        (_, SiteClass::F) => (SS_2010, &[]),
    };
    Row { at, values }
}

/// Row of the table of F_v.
fn long_period_row(asce7: u16, class: SiteClass) -> Row {
    let (at, values): (_, &[f64]) = match (asce7, class) {
        (2016, SiteClass::A | SiteClass::B) => (S1_2016, &[0.8, 0.8, 0.8, 0.8, 0.8, 0.8]),
        (2016, SiteClass::C) => (S1_2016, &[1.5, 1.5, 1.5, 1.5, 1.5, 1.4]),
        (2016, SiteClass::D) => (S1_2016, &[2.4, 2.2, 2.0, 1.9, 1.8, 1.7]),
        (2016, SiteClass::E) => (S1_2016, &[4.2]),
        (_, SiteClass::A) => (S1_2010, &[0.8, 0.8, 0.8, 0.8, 0.8]),
        (_, SiteClass::B) => (S1_2010, &[1.0, 1.0, 1.0, 1.0, 1.0]),
        (_, SiteClass::C) => (S1_2010, &[1.7, 1.6, 1.5, 1.4, 1.3]),
        (_, SiteClass::D) => (S1_2010, &[2.4, 2.0, 1.8, 1.6, 1.5]),
        (_, SiteClass::E) => (S1_2010, &[3.5, 3.2, 2.8, 2.4, 2.4]),
        (_, SiteClass::F) => (S1_2010, &[]),
    };
    Row { at, values }
}

/// Value of a row at `x`: linear between the columns, constant outside; the abscissa up to which the row goes if `x`
/// lies beyond, `None` inside if the row is empty.
fn interpolate(row: &Row, x: f64) -> Result<f64, Option<f64>> {
    let (Some(&first), Some(&last)) = (row.values.first(), row.values.last()) else { return Err(None) };
    if x <= row.at[0] {
        return Ok(first);
    }
    for i in 1..row.values.len() {
        if x <= row.at[i] {
            let t = (x - row.at[i - 1]) / (row.at[i] - row.at[i - 1]);
            return Ok(row.values[i - 1] + t * (row.values[i] - row.values[i - 1]));
        }
    }
    if row.values.len() == row.at.len() { Ok(last) } else { Err(Some(row.at[row.values.len() - 1])) }
}

/// Short-period site coefficient F_a.
///
/// * `asce7`: edition of the table, 2010 (same as 2005) or 2016
/// * `ss`: mapped acceleration S_s [g]
///
/// Errors: any other edition; a site that needs a study (module description).
/// Source: ASCE 7-10 and 7-16, table 11.4-1. Check: class D, S_s = 0.90 g, ASCE 7-10: 1.14.
pub fn short_period_coefficient(asce7: u16, class: SiteClass, ss: f64) -> Result<f64, CodeError> {
    coefficient(asce7, class, ss, "S_s", "F_a", "11.4-1", short_period_row)
}

/// One-second site coefficient F_v; arguments, errors and source as [`short_period_coefficient`] (table 11.4-2).
///
/// Check: class D, S_1 = 0.40 g, ASCE 7-10: 1.60.
pub fn long_period_coefficient(asce7: u16, class: SiteClass, s1: f64) -> Result<f64, CodeError> {
    coefficient(asce7, class, s1, "S_1", "F_v", "11.4-2", long_period_row)
}

fn coefficient(
    asce7: u16,
    class: SiteClass,
    x: f64,
    argument: &str,
    symbol: &str,
    table: &str,
    row: fn(u16, SiteClass) -> Row,
) -> Result<f64, CodeError> {
    let clause = format!("ASCE 7 (site.api650.asce7 = {asce7}) table {table}");
    if asce7 != 2010 && asce7 != 2016 {
        return Err(CodeError::Data {
            clause,
            reason: "no such edition of the site coefficients; allowed are 2010 and 2016".into(),
        });
    }
    interpolate(&row(asce7, class), x).map_err(|end| {
        let limit = match end {
            None => format!("site class {class:?} has no {symbol}"),
            Some(end) => format!("site class {class:?} has no {symbol} above {argument} = {end} g (found {x} g)"),
        };
        CodeError::Data { clause, reason: format!("{limit}: give fa and fv of a site study in site.api650") }
    })
}

/// Design spectrum of ASCE 7 as annex E uses it, 5 % damping, accelerations in g.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DesignSpectrum {
    /// Site coefficient F_a.
    pub f_a: f64,
    /// Site coefficient F_v.
    pub f_v: f64,
    /// Design acceleration at short periods S_DS [g].
    pub s_ds: f64,
    /// Design acceleration at one second S_D1 [g].
    pub s_d1: f64,
    /// Start of the plateau T_0 [s].
    pub t_0: f64,
    /// End of the plateau T_S [s].
    pub t_s: f64,
    /// Long-period transition T_L [s].
    pub t_l: f64,
}

impl DesignSpectrum {
    /// Spectrum of a site.
    ///
    /// Errors: site coefficients that the table does not give; S_s, S_1, Q or T_L not positive and finite; only one of
    /// `fa`, `fv` given.
    pub fn new(site: &Api650Site) -> Result<DesignSpectrum, CodeError> {
        let clause = || "API 650 annex E, E.4 (site.api650)".to_string();
        for (key, value, unit) in
            [("ss", site.ss, " g"), ("s1", site.s1, " g"), ("q", site.q, ""), ("tl", site.tl, " s")]
        {
            if !(value > 0.0 && value.is_finite()) {
                return Err(CodeError::Data {
                    clause: clause(),
                    reason: format!("{key} = {value}{unit} must be positive and finite"),
                });
            }
        }
        let (f_a, f_v) = match (site.fa, site.fv) {
            (Some(f_a), Some(f_v)) if f_a > 0.0 && f_v > 0.0 && f_a.is_finite() && f_v.is_finite() => (f_a, f_v),
            (Some(f_a), Some(f_v)) => {
                return Err(CodeError::Data {
                    clause: clause(),
                    reason: format!("fa = {f_a} and fv = {f_v} must be positive and finite"),
                });
            }
            (None, None) => (
                short_period_coefficient(site.asce7, site.site_class, site.ss)?,
                long_period_coefficient(site.asce7, site.site_class, site.s1)?,
            ),
            _ => {
                return Err(CodeError::Data {
                    clause: clause(),
                    reason: "fa and fv of a site study belong together; only one is given".into(),
                });
            }
        };
        let s_ds = site.q * f_a * site.ss;
        let s_d1 = site.q * f_v * site.s1;
        let t_s = s_d1 / s_ds;
        Ok(DesignSpectrum { f_a, f_v, s_ds, s_d1, t_0: 0.2 * t_s, t_s, t_l: site.tl })
    }

    /// Spectral acceleration S_a [g] at the period T [s], 5 % damping (module description).
    ///
    /// Where T_L < T_S the branch S_D1/T is absent and the plateau ends where S_D1 T_L/T² falls below it.
    pub fn acceleration(&self, period: f64) -> f64 {
        let DesignSpectrum { s_ds, s_d1, t_0, t_l, .. } = *self;
        if period < t_0 {
            s_ds * (0.4 + 0.6 * period / t_0)
        } else if period <= t_l {
            s_ds.min(s_d1 / period)
        } else {
            s_ds.min(s_d1 * t_l / (period * period))
        }
    }
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use proptest::prelude::*;

    /// A site with S_s and S_1 of the worked example (not of any place).
    pub(crate) fn site() -> Api650Site {
        Api650Site {
            bearing_capacity: None,
            ss: 0.90,
            s1: 0.40,
            s0: None,
            site_class: SiteClass::D,
            asce7: 2010,
            fa: None,
            fv: None,
            q: 2.0 / 3.0,
            sug: 2,
            tl: 8.0,
            av: None,
            design_pressure: 0.0,
            joint_efficiency: 1.0,
            friction: 0.4,
            foundation_weight: None,
            zone_factor: Some(0.30),
            soil_factor: 1.5,
            importance_1993: 1.0,
        }
    }

    const CLASSES: [SiteClass; 5] = [SiteClass::A, SiteClass::B, SiteClass::C, SiteClass::D, SiteClass::E];

    /// Values that the design-map reports of the US Geological Survey print (ASCE 7-10, three decimals; S_s and S_1 are
    /// rounded there to three decimals too, which moves F by up to 0.0006 in class E: hence 0.0011).
    #[test]
    fn coefficients_agree_with_printed_reports() {
        for (class, ss, printed) in [
            (SiteClass::D, 0.970, 1.112),
            (SiteClass::D, 0.943, 1.123),
            (SiteClass::D, 0.762, 1.195),
            (SiteClass::E, 0.970, 0.935),
            (SiteClass::D, 0.90, 1.14),
        ] {
            let f_a = short_period_coefficient(2010, class, ss).unwrap();
            assert!((f_a - printed).abs() < 1.1e-3, "{class:?} {ss}: {f_a}");
        }
        for (class, s1, printed) in [
            (SiteClass::D, 0.348, 1.704),
            (SiteClass::D, 0.344, 1.712),
            (SiteClass::D, 0.400, 1.600),
            // 13th-edition calculation of a tank in Australia, S_p = 0.09 g.
            (SiteClass::D, 0.1125, 2.35),
        ] {
            let f_v = long_period_coefficient(2010, class, s1).unwrap();
            assert!((f_v - printed).abs() < 1.1e-3, "{class:?} {s1}: {f_v}");
        }
    }

    /// Columns of the ASCE 7-16 tables at their abscissae, and midway.
    #[test]
    fn coefficients_of_2016() {
        let f_a = |class, ss| short_period_coefficient(2016, class, ss).unwrap();
        let f_v = |class, s1| long_period_coefficient(2016, class, s1).unwrap();
        for (value, expected) in [
            (f_a(SiteClass::B, 0.6), 0.9),
            (f_a(SiteClass::C, 0.625), 1.25),
            (f_a(SiteClass::D, 1.125), 1.05),
            (f_a(SiteClass::D, 3.0), 1.0),
            (f_a(SiteClass::E, 0.625), 1.5),
            (f_v(SiteClass::B, 0.3), 0.8),
            (f_v(SiteClass::C, 0.55), 1.45),
            (f_v(SiteClass::C, 0.9), 1.4),
            (f_v(SiteClass::D, 0.35), 1.95),
            (f_v(SiteClass::E, 0.05), 4.2),
        ] {
            assert!((value - expected).abs() < 1e-12, "{value} {expected}");
        }
    }

    #[test]
    fn sites_that_need_a_study_are_errors_with_the_way_out() {
        for result in [
            short_period_coefficient(2010, SiteClass::F, 0.5),
            short_period_coefficient(2016, SiteClass::E, 0.76),
            long_period_coefficient(2016, SiteClass::E, 0.2),
            long_period_coefficient(2016, SiteClass::F, 0.2),
        ] {
            let message = result.unwrap_err().to_string();
            assert!(message.contains("give fa and fv"), "{message}");
        }
        assert!(short_period_coefficient(2022, SiteClass::D, 0.5).unwrap_err().to_string().contains("2010 and 2016"));
        let study = Api650Site { site_class: SiteClass::F, fa: Some(1.3), fv: Some(2.0), ..site() };
        let spectrum = DesignSpectrum::new(&study).unwrap();
        assert!((spectrum.s_ds - 2.0 / 3.0 * 1.3 * 0.9).abs() < 1e-15);
        for bad in [
            Api650Site { fv: None, ..study },
            Api650Site { fa: Some(0.0), ..study },
            Api650Site { ss: -0.1, ..site() },
            Api650Site { s1: f64::NAN, ..site() },
            Api650Site { tl: 0.0, ..site() },
        ] {
            assert!(matches!(DesignSpectrum::new(&bad), Err(CodeError::Data { .. })));
        }
    }

    /// Worked example: S_s = 0.90, S_1 = 0.40, class D, Q = 2/3; half of the last printed digit.
    #[test]
    fn worked_example() {
        let s = DesignSpectrum::new(&site()).unwrap();
        assert!((s.f_a - 1.14).abs() < 1e-12 && (s.f_v - 1.60).abs() < 1e-12);
        assert!((s.s_ds - 0.6840).abs() < 5e-5 && (s.s_d1 - 0.42667).abs() < 5e-6);
    }

    /// A published 13th-edition calculation: S_p = 0.09 g, class D, Q = 1 give S_s = 0.225, S_1 = 0.113, F_a = 1.60,
    /// F_v = 2.35, S_DS = 0.360, S_D1 = 0.265 (0.2644 unrounded), T_S = 0.73 s, T_0 = 0.15 s; as printed.
    #[test]
    fn site_without_asce_maps() {
        let (ss, s1) = (2.5 * 0.09, 1.25 * 0.09);
        let s = DesignSpectrum::new(&Api650Site { ss, s1, q: 1.0, tl: 4.0, ..site() }).unwrap();
        for (value, printed, digits) in [
            (ss, 0.225, 5e-4),
            (s1, 0.113, 5.1e-4),
            (s.f_a, 1.60, 5e-3),
            (s.f_v, 2.35, 5e-3),
            (s.s_ds, 0.360, 5e-4),
            (s.s_d1, 0.265, 7e-4),
            (s.t_s, 0.73, 5e-3),
            (s.t_0, 0.15, 5e-3),
        ] {
            assert!((value - printed).abs() <= digits, "{value} {printed}");
        }
    }

    proptest! {
        /// The tables are continuous in S and never leave the range of their entries.
        #[test]
        fn coefficients_are_continuous(class in 0..5usize, edition in prop::sample::select(vec![2010u16, 2016]), s in 0.0..2.0f64) {
            let class = CLASSES[class];
            let h = 1e-9;
            for f in [short_period_coefficient, long_period_coefficient] {
                if let (Ok(a), Ok(b)) = (f(edition, class, s), f(edition, class, s + h)) {
                    prop_assert!((a - b).abs() < 1e-7);
                    prop_assert!((0.8..=4.2).contains(&a));
                }
            }
        }

        /// S_a is continuous at T_0, T_S and T_L, begins at 0.4 S_DS and falls with 1/T² beyond T_L.
        #[test]
        fn spectrum_is_continuous(ss in 0.05..2.0f64, s1 in 0.05..0.8f64, tl in 2.0..16.0f64, class in 0..5usize) {
            let s = DesignSpectrum::new(&Api650Site { ss, s1, tl, site_class: CLASSES[class], ..site() }).unwrap();
            for t in [s.t_0, s.t_s, s.t_l] {
                let (below, above) = (s.acceleration(t * (1.0 - 1e-9)), s.acceleration(t * (1.0 + 1e-9)));
                prop_assert!((below - above).abs() < 1e-7 * s.s_ds, "T = {t}: {below} {above}");
            }
            prop_assert!((s.acceleration(0.0) - 0.4 * s.s_ds).abs() < 1e-12);
            prop_assert!(s.acceleration(2.0 * s.t_l) <= s.acceleration(s.t_l) / 4.0 * (1.0 + 1e-12) || s.t_s > s.t_l);
        }
    }
}
