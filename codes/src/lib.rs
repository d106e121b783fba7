//! The code procedures: Housner, Eurocode 8, API 650, ACI 350.3, IS 1893-2.
//!
//! This crate does not depend on files, finite elements and the report.
//!
//! | module | idea |
//! |---|---|
//! | [`procedure`], [`sheet`] | the trait all code procedures implement, and their calculation sheets |
//! | [`bessel`], [`mechanical`] | special functions; masses, levers and periods of potential flow |
//! | [`en1992`] | sections of reinforced concrete |
//! | [`time_history`] | demands of an engine under the record against the capacities of the codes |
//! | `slab` | a rigid slab on soil |
//! | [`hazard`] | ordinates of the user's spectrum |
//! | [`ordinates`] | ordinates of a record, shared by its multiples |
//! | [`modal_action`] | the design spectrum of a procedure for the modes of an engine |
//! | [`limit_state`], [`meaning`] | limit states as constants: clause, requirement, what is compared |
//! | [`code`] | a code as the judge of a run knows it |
//! | `two_mass` | Housner's masses with SRSS, the chain of the last three procedures |
//! | [`housner`], [`ec8`], [`api650`], [`aci350`], [`is1893`], [`national`], [`deformability`] | the procedures |

pub mod aci350;
pub mod api650;
pub mod base_state;
pub mod bessel;
pub mod code;
mod corrosion;
pub mod deformability;
pub mod ec8;
pub mod en1992;
pub mod hazard;
pub mod housner;
#[cfg(test)]
mod ingredients;
pub mod is1893;
pub mod lifted;
pub mod limit_state;
pub mod meaning;
pub mod mechanical;
pub mod modal_action;
pub mod national;
pub mod ordinates;
pub mod procedure;
pub mod record_set;
mod roof;
pub mod roof_wave;
#[cfg(test)]
mod samples;
pub mod sheet;
pub mod site_action;
mod slab;
pub mod time_history;
mod two_mass;
pub mod wall_period;

pub use code::Code;
pub use procedure::Procedure;

/// All procedures in report order; the only list of them.
pub const ALL: &[&dyn Procedure] = &[
    &housner::Housner,
    &ec8::Env1998,
    &ec8::En2006,
    &api650::edition1993::Api6501993,
    &api650::edition2020::Api6502020,
    &aci350::Aci3502006,
    &is1893::Is18932014,
    &national::National,
];

/// All codes; without a site the first counts.
pub const CODES: &[&dyn Code] = &[&ec8::Eurocode8, &api650::Api650];

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    #[test]
    fn names_are_unique() {
        let names: [fn(&dyn Procedure) -> &'static str; 3] = [|p| p.id(), |p| p.label().title, |p| p.label().short];
        for name in names {
            let found: BTreeSet<_> = ALL.iter().map(|p| name(*p)).collect();
            assert_eq!(found.len(), ALL.len(), "{found:?}");
        }
    }
}
