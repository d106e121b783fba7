//! Grades of steel, reinforcement and concrete by name.
//!
//! Plain numbers of standards, in SI. Strengths are characteristic ones unless noted; no partial safety factor is in
//! them. Names are compared without regard to case and blanks.
//!
//! ```
//! let steel = materials::grades::steel("s355")?;
//! assert_eq!(steel.yield_stress, 355e6);
//! # Ok::<(), materials::grades::UnknownGrade>(())
//! ```

mod concrete;
mod metal;

pub use concrete::{CONCRETES, ConcreteGrade};
pub use metal::{BARS, BarGrade, STEELS, SteelGrade};

/// An unknown name.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("no {kind} is named \"{found}\", allowed {}", allowed.join(", "))]
pub struct UnknownGrade {
    /// Kind of grade.
    pub kind: &'static str,
    /// Found.
    pub found: String,
    /// All names.
    pub allowed: Vec<&'static str>,
}

fn find<T: Copy>(
    kind: &'static str,
    found: &str,
    list: &[T],
    name: impl Fn(&T) -> &'static str,
) -> Result<T, UnknownGrade> {
    let plain = |s: &str| s.replace([' ', '-', '_'], "").to_lowercase();
    list.iter()
        .find(|grade| plain(name(grade)) == plain(found))
        .copied()
        .ok_or_else(|| UnknownGrade {
            kind,
            found: found.to_owned(),
            allowed: list.iter().map(name).collect(),
        })
}

/// Steel or aluminium of plates.
///
/// Errors: no such name.
pub fn steel(name: &str) -> Result<SteelGrade, UnknownGrade> {
    find("steel or aluminium", name, STEELS, |grade| grade.name)
}

/// Reinforcing steel.
///
/// Errors: no such name.
pub fn bar(name: &str) -> Result<BarGrade, UnknownGrade> {
    find("reinforcing steel", name, BARS, |grade| grade.name)
}

/// Concrete.
///
/// Errors: no such name.
pub fn concrete(name: &str) -> Result<ConcreteGrade, UnknownGrade> {
    find("concrete", name, CONCRETES, |grade| grade.name)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_found_or_listed() {
        assert_eq!(concrete("c 30/37").unwrap().mean_strength, 38e6);
        assert_eq!(bar("BSt 500").unwrap().young_modulus, 210e9);
        assert_eq!(
            steel("S234").unwrap_err().to_string(),
            "no steel or aluminium is named \"S234\", allowed S235, S275, S355, A36, EN AW-5083"
        );
    }

    /// Every grade gives a law.
    #[test]
    fn grades_are_admissible() {
        STEELS.iter().for_each(|grade| assert!(grade.law(1.0).is_ok()));
        BARS.iter().for_each(|grade| assert!(grade.law().is_ok()));
    }

    /// EN 1992-1-1, table 3.1 has columns and formulas side by side: f_ctm = 0.30 f_ck^(2/3), E_cm = 22 (f_cm/10)^0.3 GPa,
    /// ε_c1 = 0.7 f_cm^0.31 ‰; the columns are rounded to two digits.
    #[test]
    fn columns_of_the_table_follow_its_formulas() {
        for grade in CONCRETES.iter().filter(|grade| grade.name.starts_with('C')) {
            let (f_ck, f_cm) = (grade.strength / 1e6, grade.mean_strength / 1e6);
            assert_eq!(f_cm, f_ck + 8.0);
            assert!(
                (grade.tensile_strength / 1e6 - 0.3 * f_ck.powf(2.0 / 3.0)).abs() < 0.06,
                "{}",
                grade.name
            );
            assert!(
                (grade.young_modulus / 1e9 - 22.0 * (f_cm / 10.0).powf(0.3)).abs() < 0.6,
                "{}",
                grade.name
            );
        }
    }

    /// fib Model Code 2010, 5.1.5.2: f_cm = 38 MPa gives 73·38^0.18 = 140.5 N/m.
    #[test]
    fn fracture_energy_of_a_common_concrete() {
        assert!((concrete("C30/37").unwrap().fracture_energy() - 140.5).abs() < 0.1);
    }
}
