//! Grades of steel, aluminium, reinforcement and concrete by name.
//!
//! Plain numbers of standards, in SI. Strengths are characteristic ones unless noted; no partial safety factor is in
//! them. Strengths of plates depend on the nominal thickness ([`SteelGrade::at`]). Names are compared without regard to case, blanks,
//! hyphens and words such as *ASTM* and *grade* ([`folded`]).
//!
//! ```
//! let steel = materials::grades::steel("s355j2")?;
//! assert_eq!(steel.at(0.020).map(|plate| plate.yield_stress), Some(345e6));
//! assert_eq!(materials::grades::steel("ASTM A516 Gr. 70")?.name, "A516 70");
//! # Ok::<(), materials::grades::UnknownGrade>(())
//! ```

mod aluminium;
mod american;
mod bars;
mod concrete;
mod european;
mod plate;

pub use bars::{BARS, BarGrade};
pub use concrete::{CONCRETES, ConcreteGrade};
pub use plate::{PlateKind, SteelGrade, Step};

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

/// Steels and aluminium alloys of plates.
pub fn steels() -> impl Iterator<Item = &'static SteelGrade> {
    (european::GRADES.iter()).chain(american::GRADES).chain(aluminium::GRADES)
}

/// A name without what users write in different ways: case, blanks, hyphens, and the words that only say that a grade follows.
///
/// `ASTM A516M Gr.70`, `SA-516 grade 70` and `A516-70` are `a51670`; `EN AW-5083-O` is `aw5083o`.
pub fn folded(name: &str) -> String {
    const WORDS: [&str; 9] = ["aisi", "asme", "astm", "class", "csa", "en", "grade", "gr", "type"];
    let lower = name.to_lowercase();
    let words = lower.split(|c: char| c.is_whitespace() || matches!(c, '-' | '_' | ',' | '(' | ')'));
    let mut plain = String::with_capacity(lower.len());
    for word in words.filter(|word| !WORDS.contains(&word.trim_end_matches('.'))) {
        // `gr.70`, `gr70` and `cl.1`; the names themselves begin with neither.
        let rest = ["gr.", "cl.", "gr", "cl"].iter().find_map(|w| word.strip_prefix(w));
        plain.push_str(rest.unwrap_or(word));
    }
    american(&plain).unwrap_or(plain)
}

/// `sa516m70` and `a516m70` as `a51670`: ASME's and the metric edition of an ASTM specification.
fn american(plain: &str) -> Option<String> {
    let number = plain.strip_prefix("sa").or_else(|| plain.strip_prefix('a'))?;
    let digits = number.len() - number.trim_start_matches(|c: char| c.is_ascii_digit()).len();
    let (specification, grade) = number.split_at(digits);
    let grade = grade.strip_prefix('m').unwrap_or(grade);
    (digits > 0).then(|| format!("a{specification}{grade}"))
}

fn find<'g, T>(
    kind: &'static str,
    found: &str,
    mut list: impl Iterator<Item = &'g T> + Clone,
    names: impl Fn(&T) -> (&'static str, &'static [&'static str]),
) -> Result<T, UnknownGrade>
where
    T: Copy + 'g,
{
    let allowed = list.clone().map(|grade| names(grade).0);
    let wanted = folded(found);
    let named = |grade: &&T| {
        let (name, aliases) = names(grade);
        folded(name) == wanted || aliases.iter().any(|alias| folded(alias) == wanted)
    };
    let unknown = UnknownGrade { kind, found: found.to_owned(), allowed: allowed.collect() };
    list.find(named).copied().ok_or(unknown)
}

/// Steel or aluminium of plates, by its name or one of its aliases.
///
/// Errors: no such name.
pub fn steel(name: &str) -> Result<SteelGrade, UnknownGrade> {
    let list: Vec<&SteelGrade> = steels().collect();
    find("steel or aluminium", name, list.into_iter(), |g| (g.name, g.aliases))
}

/// Reinforcing steel.
///
/// Errors: no such name.
pub fn bar(name: &str) -> Result<BarGrade, UnknownGrade> {
    find("reinforcing steel", name, BARS.iter(), |g| (g.name, &[]))
}

/// Concrete.
///
/// Errors: no such name.
pub fn concrete(name: &str) -> Result<ConcreteGrade, UnknownGrade> {
    find("concrete", name, CONCRETES.iter(), |g| (g.name, &[]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_found_or_listed() {
        assert_eq!(concrete("c 30/37").unwrap().mean_strength, 38e6);
        assert_eq!(bar("BSt 500").unwrap().young_modulus, 210e9);
        assert_eq!(
            bar("B501").unwrap_err().to_string(),
            "no reinforcing steel is named \"B501\", allowed B500, B500A, B500B, B500C, BSt500"
        );
    }

    /// Every grade gives a law.
    #[test]
    fn grades_are_admissible() {
        steels().for_each(|grade| assert!(grade.law(1.0).is_ok(), "{}", grade.name));
        BARS.iter().for_each(|grade| assert!(grade.law().is_ok()));
    }

    /// EN 1992-1-1, table 3.1 has columns and formulas side by side: f_ctm = 0.30 f_ck^(2/3), E_cm = 22 (f_cm/10)^0.3 GPa,
    /// ε_c1 = 0.7 f_cm^0.31 ‰; the columns are rounded to two digits.
    #[test]
    fn columns_of_the_table_follow_its_formulas() {
        for grade in CONCRETES.iter().filter(|grade| grade.name.starts_with('C')) {
            let (f_ck, f_cm) = (grade.strength / 1e6, grade.mean_strength / 1e6);
            assert_eq!(f_cm, f_ck + 8.0);
            assert!((grade.tensile_strength / 1e6 - 0.3 * f_ck.powf(2.0 / 3.0)).abs() < 0.06, "{}", grade.name);
            assert!((grade.young_modulus / 1e9 - 22.0 * (f_cm / 10.0).powf(0.3)).abs() < 0.6, "{}", grade.name);
        }
    }

    /// fib Model Code 2010, 5.1.5.2: f_cm = 38 MPa gives 73·38^0.18 = 140.5 N/m.
    #[test]
    fn fracture_energy_of_a_common_concrete() {
        assert!((concrete("C30/37").unwrap().fracture_energy() - 140.5).abs() < 0.1);
    }
}
