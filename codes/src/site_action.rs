//! Which procedure's design spectrum the modes of an engine see.

use tank::case::{Case, Site};

use crate::modal_action::ModalAction;
use crate::procedure::CodeError;

/// The procedures that give an action, those in force first.
const ORDER: [&str; 3] = ["ec8-2006", "api650-2020", "housner"];

/// Id of the procedure whose spectrum the modes see: that of `wanted`, or the first that the site gives the data of; none without.
///
/// * `reduced`: whether by the factors of the procedure, as it takes the spectrum itself
///
/// Errors: data that the procedure does not admit.
pub fn of<'a>(
    case: &'a Case,
    wanted: Option<&str>,
    reduced: bool,
) -> Option<(&'static str, Result<ModalAction<'a>, CodeError>)> {
    let named = |id: &&&str| wanted.is_none_or(|w| w == **id);
    ORDER.iter().filter(named).find_map(|id| {
        let procedure = crate::ALL.iter().find(|p| p.id() == *id)?;
        Some((procedure.id(), procedure.modal_action(case, reduced)?))
    })
}

/// Ids of the procedures that give an action.
pub fn ids() -> &'static [&'static str] {
    &ORDER
}

/// Errors: a period [s] beyond the user's table, which is not continued.
///
/// * `what`: of the tank ("sloshing")
pub fn covers(site: &Site, what: &str, period: f64) -> Result<(), CodeError> {
    crate::hazard::covers(site.spectrum.as_ref(), what, period)
}

#[cfg(test)]
mod tests {
    use tank::STANDARD_GRAVITY;
    use tank::assessment::Excitation;
    use tank::case::Ec8Site;
    use tank::hazard::{SiteSpectrum, SpectrumForm, SpectrumTable};

    use super::*;
    use crate::procedure::Procedure;

    /// What EN 1998-4 prints for the periods of the oil tank is what the action gives there: the same spectrum, no other factor.
    #[test]
    fn of_eurocode_it_is_that_of_the_sheet() {
        for (behaviour_factor, damping) in [(1.0, 0.02), (1.5, 0.02), (1.5, 0.08)] {
            let mut case = crate::ec8::example::oil_tank();
            case.damping.impulsive = damping;
            case.site.ec8 = case.site.ec8.map(|site| Ec8Site { behaviour_factor, ..site });
            let sheet = crate::ec8::En2006.assess(&case, Excitation::Site).unwrap();
            let line = |symbol: &str| sheet.steps.iter().find(|s| s.symbol == symbol).unwrap().value;
            let (id, action) = of(&case, None, true).unwrap();
            let action = action.unwrap();
            assert_eq!(id, "ec8-2006");
            let governing = (action.structural)(line("T_imp"), damping);
            assert!((governing / line("A_i") - 1.0).abs() < 1e-12, "{governing}");
            // Elastic, without the behaviour factor: 5 % plateau 2.5 a_g S and ground acceleration a_g S, EN 1998-1 (3.2), (3.3).
            let (_, elastic) = of(&case, Some("ec8-2006"), false).unwrap();
            let elastic = elastic.unwrap();
            let ag = 1.2 * 0.25 * 9.81 * 1.15;
            assert!(((elastic.structural)(0.0, 0.02) / ag - 1.0).abs() < 1e-12);
            assert!(((elastic.structural)(0.3, 0.05) / (2.5 * ag) - 1.0).abs() < 1e-12);
            assert!(((elastic.sloshing)(0.3, 0.05) / (2.5 * ag) - 1.0).abs() < 1e-12);
        }
    }

    /// By hand from S_DS and S_D1 of the site: A_i on the plateau, A_c and A_f of annex E beyond it.
    #[test]
    fn of_annex_e_it_has_its_factors() {
        let case = crate::api650::example::case();
        let site = case.site.api650.unwrap();
        let spectrum = crate::api650::ground_motion::DesignSpectrum::new(&site).unwrap();
        let i = [1.0, 1.25, 1.5][usize::from(site.sug) - 1];
        let (id, action) = of(&case, None, true).unwrap();
        let action = action.unwrap();
        assert_eq!(id, "api650-2020");
        let plateau = spectrum.s_ds * i / 3.5 * STANDARD_GRAVITY;
        let period = 0.5 * (spectrum.t_0 + spectrum.t_s);
        let close = |a: f64, b: f64| assert!((a / b - 1.0).abs() < 1e-12, "{a} {b}");
        close((action.structural)(period, 0.02), plateau);
        close((action.structural)(0.0, 0.02), 0.4 * plateau);
        let long = 3.9_f64.min(0.99 * spectrum.t_l);
        close((action.sloshing)(long, 0.005), (1.5 * spectrum.s_d1 / long * i / 2.0 * STANDARD_GRAVITY).min(plateau));
        close((action.sloshing)(0.1, 0.005), plateau);
        let importance = if site.sug == 3 { 1.0 } else { i };
        close((action.wave)(long, 0.005), 1.5 * spectrum.s_d1 / long * importance * STANDARD_GRAVITY);
        let sheet = crate::api650::edition2020::Api6502020.assess(&case, Excitation::Site).unwrap();
        let line = |symbol: &str| sheet.steps.iter().find(|s| s.symbol == symbol).unwrap().value;
        close((action.wave)(line("T_c"), 0.005), line("A_f") * STANDARD_GRAVITY);
        close((action.sloshing)(line("T_c"), 0.005), line("A_c") * STANDARD_GRAVITY);
    }

    /// A user's spectrum alone is that of the table; a period beyond it is refused.
    #[test]
    fn a_spectrum_alone() {
        let mut case = crate::ec8::example::oil_tank();
        case.site.ec8 = None;
        assert!(of(&case, None, true).is_none());
        let table = SpectrumTable::new(vec![[0.0, 1.0], [0.2, 2.5], [2.0, 0.5]]).unwrap();
        case.site.spectrum = Some(SiteSpectrum {
            form: SpectrumForm::Table { damping: 0.05, horizontal: table, vertical: None },
            vertical_ratio: 0.9,
        });
        let (id, action) = of(&case, None, true).unwrap();
        let action = action.unwrap();
        assert_eq!(id, "housner");
        assert!(((action.structural)(1.1, 0.05) - 1.5).abs() < 1e-12);
        assert!(covers(&case.site, "sloshing", 2.1).is_err() && covers(&case.site, "sloshing", 1.9).is_ok());
    }
}
