//! The code procedures: Housner, Eurocode 8, API 650.
//!
//! This crate knows no files, no finite elements and no report. It holds
//!
//! | module | idea |
//! |---|---|
//! | [`procedure`], [`sheet`] | the trait all code procedures implement, and their calculation sheets |
//! | [`bessel`], [`mechanical`] | special functions; masses, levers and periods of potential flow |
//! | [`housner`], [`ec8`], [`api650`], [`deformability`] | the procedures |

pub mod api650;
pub mod bessel;
pub mod deformability;
pub mod ec8;
pub mod housner;
pub mod mechanical;
pub mod procedure;
#[cfg(test)]
mod samples;
pub mod sheet;

pub use procedure::Procedure;

/// All procedures in report order. No other file names them all.
pub const ALL: &[&dyn Procedure] = &[
    &housner::Housner,
    &ec8::Env1998,
    &ec8::En2006,
    &api650::edition1993::Api6501993,
    &api650::edition2020::Api6502020,
];

#[cfg(test)]
mod tests {
    use super::*;

    /// The order of the report, each id once; every id leads to a title of its own that names the edition.
    #[test]
    fn procedures_in_report_order() {
        let ids: Vec<_> = ALL.iter().map(|p| p.id()).collect();
        assert_eq!(ids, ["housner", "ec8-env", "ec8-2006", "api650-1993", "api650-2020"]);
        for (procedure, part) in ALL
            .iter()
            .zip(["Housner", "ENV 1998-4:1998", "EN 1998-4:2006", "1993", "2020"])
        {
            assert!(procedure.label().title.contains(part), "{}", procedure.label().title);
        }
    }
}
