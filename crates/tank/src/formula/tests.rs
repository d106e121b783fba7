//! Goal: the grammar as its table has it, and properties of every formula: its text is read back as the same tree,
//! and the text with its numbers put in has the value of the formula.

use super::*;
use crate::units::Dimension::*;
use proptest::prelude::*;

fn tree(text: &str) -> Sum {
    Formula::parse(text).expect(text).tree
}

/// Value of a text without symbols.
fn value(text: &str) -> f64 {
    Formula::parse(text).expect(text).value(&[]).expect(text)
}

#[test]
fn values_by_hand() {
    for (text, expected) in [
        ("1 + 2·3", 7.0),
        ("-2 + 5 − 1", 2.0),
        ("8/2/2", 2.0),
        ("8/2·4", 16.0),
        ("√9·2", 6.0),
        ("√3²", 3.0),
        ("√(16)/2", 2.0),
        ("2³/2²", 2.0),
        ("12.1·10⁻²", 0.121),
        ("4^0.5", 2.0),
        ("4^−(1/2)", 0.5),
        ("-2²", -4.0),
        ("(-2)²", 4.0),
        ("[1 + 1]·|2 − 5|", 6.0),
        ("6.9e3/3e-1", 23e3),
        ("½ + ¼", 0.75),
        ("1/∞", 0.0),
        ("min(3, 2; 5) + max(1, 4)", 6.0),
        ("ln(exp(2))", 2.0),
        ("cosh(1)² − sinh(1)²", 1.0),
        ("sin(π/2) + cos(0) + tan(0)", 2.0),
        // With 30 digits.
        ("I₁(0.01)/I₀(0.01)", 0.004_999_937_501_041_649),
        ("I₁(2)/I₀(2)", 0.697_774_657_964_008),
        ("I₁(500)/I₀(500)", 0.998_999_498_996_861_9),
        // Abramowitz and Stegun (1972), table 9.8: e⁻ˣ I at x = 1.
        ("I₀(1)·exp(-1)", 0.465_759_607_6),
        ("I₁(1)·exp(-1)", 0.207_910_415_3),
    ] {
        assert!((value(text) - expected).abs() < 1e-10 * expected.abs().max(1.0), "{text}: {}", value(text));
    }
}

#[test]
fn numbers_carry_units() {
    for (text, expected) in [
        ("83 GPa", 83e9),
        ("7.5 MPa", 7.5e6),
        ("0.3048 m", 0.3048),
        ("572 mm", 0.572),
        ("4.903 m/s²·7600.6 kg", 4.903 * 7600.6),
        ("37.281 kN·571.88 mm + 13.59 kN·883.5 mm", 37281.0 * 0.57188 + 13590.0 * 0.8835),
        ("4 s/2 s", 2.0),
        ("3 m/s·2", 6.0),
        ("33.33 kN·m/(π·(3.66 m)²·2 mm/4)", 33330.0 / (std::f64::consts::PI * 3.66 * 3.66 * 0.0005)),
        ("2 %·50", 1.0),
    ] {
        assert!((value(text) / expected - 1.0).abs() < 1e-15, "{text}: {}", value(text));
    }
    // A symbol that begins like a unit is a symbol; `g` is one always.
    let terms = [("m_i", 3.0, Mass), ("g", 9.81, Acceleration)];
    assert_eq!(Formula::parse("2·m_i·g").unwrap().value(&terms), Ok(2.0 * 3.0 * 9.81));
    assert!(Formula::parse("2 m_i").is_err() && Formula::parse("2 g").is_err());
}

#[test]
fn symbols() {
    let terms = [
        ("h_i", 1.0, Length),
        ("h_i′", 2.0, Length),
        ("λ1", 4.0, Dimensionless),
        ("s_⅓", 8.0, Length),
        ("σ_θ,max", 16.0, Stress),
        ("π", 32.0, Dimensionless),
    ];
    assert_eq!(Formula::parse("h_i + h_i′ + λ1 + s_⅓ + σ_θ,max + π").unwrap().value(&terms), Ok(63.0));
    // A comma with a blank separates arguments.
    assert_eq!(Formula::parse("max(h_i, λ1)").unwrap().value(&terms), Ok(4.0));
}

#[test]
fn substitution_replaces_whole_symbols_only() {
    let terms = [
        ("k", 1.8412, Dimensionless),
        ("R", 1.83, Length),
        ("H", 1.525, Length),
        ("h_i", 0.572, Length),
        ("h_i′", 1.4446, Length),
        ("n", -2.0, Dimensionless),
        ("M", 5.0, Mass),
    ];
    for (formula, text) in [
        ("tanh(k·H/R)", "tanh(1.8412·1.525 m/1.83 m)"),
        ("π·R²", "π·(1.83 m)²"),
        ("R^2.5", "(1.83 m)^2.5"),
        ("k²", "1.8412²"),
        ("√(H/R)", "√(1.525 m/1.83 m)"),
        ("h_i + h_i′", "572 mm + 1.4446 m"),
        ("3/8·H", "3/8·1.525 m"),
        ("n·R", "(-2)·1.83 m"),
        ("250 MPa/k", "250 MPa/1.8412"),
        ("x·k", "x·1.8412"),
    ] {
        assert_eq!(Formula::parse(formula).unwrap().substitution(&terms), text);
    }
}

#[test]
fn numbers_have_five_digits_and_no_idle_zeros() {
    for (value, text) in [
        (0.0, "0"),
        (1.83, "1.83"),
        (2.99763, "2.9976"),
        (0.254_749, "0.25475"),
        (37281.4, "37281"),
        (9.999_996, "10"),
        (-0.5, "-0.5"),
        (1234567.0, "1234567"),
        (6.9e10, "6.9e10"),
        (3.2e-7, "3.2e-7"),
        (f64::INFINITY, "∞"),
    ] {
        assert_eq!(number(value), text);
    }
}

#[test]
fn units_are_those_of_engineers() {
    for (value, dimension, text) in [
        (0.00203, Length, "2.03 mm"),
        (1.525, Length, "1.525 m"),
        (16300.0, Mass, "16.3 t"),
        (37281.0, Force, "37.281 kN"),
        (69e9, Stress, "69 GPa"),
        (1.58e6, Stress, "1.58 MPa"),
        (14960.0, Stress, "14.96 kPa"),
        (0.46629, Dimensionless, "0.46629"),
    ] {
        assert_eq!(with_unit(value, dimension), text);
    }
}

#[test]
fn faults_say_what_and_where() {
    for (text, message) in [
        ("", "``: found the end at character 1, expected a number, a symbol, a function or an opening bracket"),
        ("a +", "`a +`: found the end at character 4, expected a number, a symbol, a function or an opening bracket"),
        ("a)", "`a)`: found `)` at character 2, expected an operator or the end"),
        ("(a", "`(a`: found the end at character 3, expected an operator or the closing bracket"),
        ("|a]", "`|a]`: found `]` at character 3, expected an operator or the closing bracket"),
        ("f(a b)", "`f(a b)`: found `b` at character 5, expected an operator, a comma or the closing parenthesis"),
        ("2 a", "`2 a`: found `a` at character 3, expected an operator or the end"),
        ("π = 3", "`π = 3`: found `=` at character 3, expected an operator or the end"),
    ] {
        assert_eq!(Formula::parse(text).unwrap_err().to_string(), message);
    }
    for text in ["3 +", "^", "√", "a//b", "a^", "a² ³", "2 kN²", "2..3", "a--b", "f()", "1 − ⁻", "Σ x"] {
        assert!(Formula::parse(text).is_err(), "{text}");
    }
    let no_value = Formula::parse("a·b").unwrap().value(&[("a", 1.0, Length)]).unwrap_err();
    assert_eq!(no_value.to_string(), "`a·b`: no value given for `b`");
    for text in ["f(1)", "tanh(1, 2)"] {
        assert!(matches!(Formula::parse(text).unwrap().value(&[]), Err(FormulaError::NoFunction { .. })));
    }
    let deep = |n: usize| "(".repeat(n) + "1" + &")".repeat(n);
    assert!(Formula::parse(&deep(50)).is_ok());
    assert!(matches!(Formula::parse(&deep(100_000)), Err(FormulaError::TooDeep { .. })));
    assert!(matches!(Formula::parse(&("√".repeat(100_000) + "1")), Err(FormulaError::TooDeep { .. })));
}

/// Symbols of the trees.
const SYMBOLS: [&str; 5] = ["a", "b_i", "h′", "λ1", "σ_θ,max"];

/// Trees of the grammar.
mod trees {
    use super::*;
    use crate::units::UNITS;

    fn number() -> impl Strategy<Value = Number> {
        let units: Vec<_> = UNITS.iter().filter(|u| !matches!(u.symbol, "" | "g" | "%")).collect();
        let unit = proptest::option::weighted(0.3, proptest::sample::select(units));
        // Four digits: the number put in for a symbol keeps five.
        (1..9999_u32, 0..4_u32, unit).prop_map(|(digits, shift, unit)| {
            let digits = (f64::from(digits) / f64::from(10_u32.pow(shift))).to_string();
            let text = match unit {
                Some(unit) => format!("{digits} {}", unit.symbol),
                None => digits.clone(),
            };
            let Power::Plain(Primary::Number(number)) = tree(&text).0.remove(0).1.first else {
                panic!("{text} is not a number");
            };
            number
        })
    }

    fn primary() -> impl Strategy<Value = Primary> {
        let leaf = prop_oneof![
            number().prop_map(Primary::Number),
            proptest::sample::select(&SYMBOLS[..]).prop_map(|s| Primary::Symbol(s.into())),
        ];
        leaf.prop_recursive(4, 40, 4, |inner| {
            let sum = sums(inner).boxed();
            let call = (proptest::sample::select(vec!["tanh", "cos", "exp", "ln", "sinh"]), sum.clone());
            let many = (proptest::sample::select(vec!["min", "max"]), proptest::collection::vec(sum.clone(), 1..4));
            let brackets = proptest::sample::select(vec![Bracket::Round, Bracket::Square, Bracket::Bar]);
            prop_oneof![
                call.prop_map(|(name, sum)| Primary::Call(name.into(), vec![sum])),
                many.prop_map(|(name, sums)| Primary::Call(name.into(), sums)),
                (brackets, sum).prop_map(|(bracket, sum)| Primary::Group(bracket, Box::new(sum))),
            ]
        })
    }

    fn power(primary: impl Strategy<Value = Primary> + Clone + 'static) -> impl Strategy<Value = Power> {
        let plain = primary.clone().prop_map(Power::Plain);
        let base = primary.clone().prop_map(|base| match base {
            // `2 mm²` is not a number with a unit.
            Primary::Number(Number { unit: Some(_), .. }) => {
                let product = Product { first: Power::Plain(base), rest: Vec::new() };
                Primary::Group(Bracket::Round, Box::new(Sum(vec![(Sign::Plus, product)])))
            }
            base => base,
        });
        prop_oneof![
            4 => plain.clone(),
            1 => plain.prop_map(|p| Power::Root(Box::new(p))),
            1 => (base.clone(), -3..4_i32).prop_map(|(base, exponent)| Power::Raised(base, exponent)),
            1 => (base, any::<bool>(), primary)
                .prop_map(|(base, minus, exponent)| Power::To { base, minus, exponent }),
        ]
    }

    fn sums(primary: impl Strategy<Value = Primary> + Clone + 'static) -> impl Strategy<Value = Sum> {
        let operator = proptest::sample::select(vec![Operator::Times, Operator::Over]);
        let power = power(primary).boxed();
        let product = (power.clone(), proptest::collection::vec((operator, power), 0..3))
            .prop_map(|(first, rest)| Product { first, rest });
        let sign = proptest::sample::select(vec![Sign::Plus, Sign::Minus]);
        proptest::collection::vec((sign, product), 1..3).prop_map(Sum)
    }

    /// Any tree.
    pub(super) fn any_tree() -> impl Strategy<Value = Sum> {
        sums(primary().boxed())
    }
}

fn terms() -> impl Strategy<Value = Vec<Term<'static>>> {
    let value = || (-9999..9999_i32, 0..6_u32).prop_map(|(v, s)| f64::from(v) / f64::from(10_u32.pow(s)));
    let dimension = || proptest::sample::select(Dimension::ALL.to_vec());
    (proptest::array::uniform5(value()), proptest::array::uniform5(dimension()))
        .prop_map(move |(values, dimensions)| (0..5).map(|i| (SYMBOLS[i], values[i], dimensions[i])).collect())
}

/// Whether two values are one but for the rounding of numbers to text and back.
fn same(a: f64, b: f64) -> bool {
    (a.is_nan() && b.is_nan()) || a == b || (a - b).abs() <= 1e-9 * a.abs().max(b.abs())
}

proptest! {
    #[test]
    fn printed_formulas_read_back(tree in trees::any_tree()) {
        let text = tree.to_string();
        let formula = Formula::parse(&text);
        prop_assert!(formula.is_ok(), "{formula:?}");
        let formula = formula.unwrap();
        prop_assert_eq!(&formula.tree, &tree, "{}", text);
        // Printing keeps the text, and the text its value.
        prop_assert_eq!(formula.tree().to_string(), text);
    }

    /// The numbers put in have at most four digits, so that the text holds them exactly.
    #[test]
    fn substitutions_have_the_value_of_the_formula(tree in trees::any_tree(), terms in terms()) {
        let formula = Formula::parse(&tree.to_string()).unwrap();
        let text = formula.substitution(&terms);
        let read = Formula::parse(&text);
        prop_assert!(read.is_ok(), "{formula:?}: {read:?}");
        let (value, read) = (formula.value(&terms).unwrap(), read.unwrap().value(&[]).unwrap());
        // Cancellation loses the digits.
        prop_assert!(same(value, read) || ill_conditioned(&formula, &terms), "{} = {} = {}: {}", tree, text, value, read);
    }

    /// Any text is read or refused, and never ends the program.
    #[test]
    fn any_text_is_read_or_refused(text in "[-+·/√^²³⁻()\\[\\]|,; .0-9a-eλ_′πmsNkPGI₀₁½∞tanhx]{0,40}") {
        if let Ok(formula) = Formula::parse(&text) {
            let _ = formula.value(&[("a", 1.0, Length)]);
            let _ = formula.substitution(&[("a", -1e-9, Length)]);
            let printed = formula.tree().to_string();
            prop_assert_eq!(&Formula::parse(&printed).unwrap().tree, formula.tree(), "{}", printed);
        }
    }
}

/// Whether a relative change of 1e-12 of the terms moves the value by more than 1e-9.
fn ill_conditioned(formula: &Formula, terms: &[Term]) -> bool {
    let moved: Vec<Term> = terms.iter().map(|&(s, v, d)| (s, v * (1.0 + 1e-12), d)).collect();
    match (formula.value(terms), formula.value(&moved)) {
        (Ok(a), Ok(b)) => (a - b).abs() > 1e-11 * a.abs(),
        _ => true,
    }
}
