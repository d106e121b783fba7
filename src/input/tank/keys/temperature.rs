//! `tank.design_temperature`: the values of metals at that temperature.
//!
//! API 650 annex M reduces the stresses of carbon steel above 93 °C and ends at 260 °C; annex S has allowable stresses of stainless steel from
//! 40 °C on. The tables of both are not in the program: the file states the values at the temperature, material by material.

use std::collections::BTreeSet;

use ::tank::Family;
use ::tank::units::{Dimension, display};
use files::code::Code;

use super::file::TankFile;
use super::materials::Materials;
use crate::input::tank::resolver::Resolver;
use ::tank::keys::Limits;

/// From liquefied gas to the end of API 650 annex M [°C]; usual up to the temperature from which strengths are reduced.
pub(super) const TEMPERATURE: Limits = Limits::from(-200.0).to(260.0);
/// Temperature up to which the values at room temperature hold [°C]: carbon steel, API 650 annex M; other metals, annexes S and AL.
const CARBON_STEEL: f64 = 93.0;
const OTHER_METAL: f64 = 40.0;

/// The design temperature [°C]. Reports materials that need values at it and have none, and values at a temperature that is not stated.
///
/// * `used`: names of the materials of the tank
pub(super) fn design(
    r: &mut Resolver<'_>,
    file: &TankFile,
    used: &BTreeSet<&String>,
    materials: &Materials,
) -> Option<f64> {
    let tank = file.tank.value.as_ref()?;
    let temperature = r.optional(&tank.design_temperature);
    let named = file.materials.value.iter().flat_map(|named| &named.0).filter(|(name, _)| used.contains(name));
    let mut cold = Vec::new();
    for (name, field) in named {
        let Some(given) = &field.value else { continue };
        let family = materials.get(name).and_then(Option::as_ref).and_then(|m| m.family);
        let limit = match family {
            Some(Family::CarbonSteel) => CARBON_STEEL,
            Some(Family::Stainless | Family::Aluminium | Family::OtherMetal) => OTHER_METAL,
            _ => f64::INFINITY,
        };
        match (&given.hot.given, temperature) {
            (Some(_), None) if tank.design_temperature.given.is_none() => {
                let why = format!(": the material `{name}` has values at it");
                r.missing(&file.tank, &tank.design_temperature, &why, "a temperature", "\"120 degC\"");
            }
            (None, Some(t)) if t > limit => cold.push((name, limit)),
            (None, Some(t)) if limit.is_infinite() && t > OTHER_METAL => {
                let text =
                    format!("`tank.design_temperature` changes nothing of the material `{name}`, which has no `hot`");
                r.warn(Code::NotUsed, text);
            }
            _ => {}
        }
    }
    if let (Some((name, limit)), Some(field)) = (cold.first(), &tank.design_temperature.given) {
        let names: Vec<String> = cold.iter().map(|(name, _)| format!("`{name}`")).collect();
        let message = format!("no values at the design temperature of the material {}", names.join(", "));
        let limit = display(*limit, Dimension::Temperature);
        let allowed = format!(
            "at most {limit}, or `hot` in the material with youngs_modulus and yield_strength at the temperature"
        );
        let fault = crate::input::tank::resolver::range_fault(Code::MissingKey, field, &message, &allowed);
        r.faults.push(fault.help(format!(
            "add \"hot\": {{ \"youngs_modulus\": …, \"yield_strength\": … }} to materials.{name}; API 650 annexes M and S and EN 10028 have values"
        )));
    }
    temperature
}
