//! The seismic action of EN 1998 for the modes of an engine.

use super::demand::{Demand, Edition};
use crate::hazard;
use crate::modal_action::{ModalAction, Upwards};
use crate::procedure::CodeError;
use crate::sheet::{Sheet, number};
use tank::assessment::Excitation;
use tank::case::{Case, Components};

/// The action of a site, see [`crate::modal_action`].
///
/// * `reduced`: whether by q, and not below S_d
///
/// Errors: data that the edition does not admit.
pub(super) fn action<'a>(case: &'a Case, reduced: bool) -> Result<ModalAction<'a>, CodeError> {
    let demand = Demand::new(case, Excitation::Site, Edition::En2006)?;
    let elastic =
        move |period: f64, damping: f64| demand.convective(&mut Sheet::new(), &mut Vec::new(), "S_e", period, damping);
    let design =
        move |period: f64, damping: f64| demand.impulsive(&mut Sheet::new(), &mut Vec::new(), "S_e", period, damping);
    let q = number(demand.behaviour_factor);
    let spectrum = match demand.user {
        Some(_) => "the user's spectrum times γ_I as EN 1998-1 takes it",
        None => "the spectrum of EN 1998-1",
    };
    let structural = match reduced {
        true => format!("structural modes and what follows the ground with max(S_e(T, ξ)/q, S_d), q = {q}"),
        false => "structural modes and what follows the ground with S_e(T, ξ), q = 1".to_owned(),
    };
    let components = match demand.components {
        Components::One => "",
        Components::HundredThirty => "; two horizontal components as in `ec8-2006`",
    };
    Ok(ModalAction {
        longest: demand.user.map_or(f64::INFINITY, hazard::longest),
        structural: if reduced { Box::new(design) } else { Box::new(elastic) },
        sloshing: Box::new(elastic),
        wave: Box::new(elastic),
        assumption: format!(
            "Modes of the engine under {spectrum}, at the damping of each mode: {structural}, sloshing modes with S_e, q = 1{components}."
        ),
        vertical: demand.vertical,
        upwards: demand.vertical.then(|| Upwards {
            spectrum: Box::new(move |period, _| demand.upwards(period).0),
            beside: demand.beside_vertical(),
        }),
    })
}
