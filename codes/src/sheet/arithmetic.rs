//! Reads the arithmetic of a substitution back, for tests: `4.903 m/s²·7600.6 kg` is 37266.
//!
//! Understands `+ − · /`, `√`, superscripts, `π`, parentheses, absolute bars, `tanh cosh sinh exp ln min max`, and numbers
//! with the units of [`tank::units`].

use tank::assessment::Step;
use tank::units::UNITS;

/// Panics if a substitution does not give the value of its step to four digits, or if fewer than `least` could be read.
pub fn check(steps: &[Step], least: usize) {
    let mut read = 0;
    for step in steps.iter().filter(|s| !s.substitution.is_empty()) {
        let Some(value) = evaluate(&step.substitution) else {
            continue;
        };
        read += 1;
        assert!(
            (value - step.value).abs() <= 3e-4 * step.value.abs() + 1e-9,
            "{} = {} = {} gives {value}, the sheet says {}",
            step.symbol,
            step.formula,
            step.substitution,
            step.value
        );
    }
    assert!(read >= least, "only {read} substitutions could be read");
}

/// Value in SI; none if the text is not arithmetic.
pub fn evaluate(text: &str) -> Option<f64> {
    let mut reader = Reader {
        chars: text.chars().collect(),
        at: 0,
    };
    let value = reader.sum()?;
    reader.space();
    (reader.at == reader.chars.len()).then_some(value)
}

struct Reader {
    chars: Vec<char>,
    at: usize,
}

impl Reader {
    fn peek(&self) -> Option<char> {
        self.chars.get(self.at).copied()
    }

    fn space(&mut self) {
        while self.peek() == Some(' ') {
            self.at += 1;
        }
    }

    fn take(&mut self, wanted: &[char]) -> Option<char> {
        self.space();
        let c = self.peek().filter(|c| wanted.contains(c))?;
        self.at += 1;
        Some(c)
    }

    fn sum(&mut self) -> Option<f64> {
        let mut value = self.product()?;
        while let Some(sign) = self.take(&['+', '−', '-']) {
            let next = self.product()?;
            value += if sign == '+' { next } else { -next };
        }
        Some(value)
    }

    fn product(&mut self) -> Option<f64> {
        let mut value = self.power()?;
        while let Some(operator) = self.take(&['·', '/', '×']) {
            let next = self.power()?;
            value = if operator == '/' { value / next } else { value * next };
        }
        Some(value)
    }

    fn power(&mut self) -> Option<f64> {
        let base = self.atom()?;
        match self.peek() {
            Some('²') => self.at += 1,
            Some('³') => {
                self.at += 1;
                return Some(base.powi(3));
            }
            _ => return Some(base),
        }
        Some(base * base)
    }

    fn atom(&mut self) -> Option<f64> {
        self.space();
        match self.peek()? {
            '-' | '−' => {
                self.at += 1;
                Some(-self.power()?)
            }
            '√' => {
                self.at += 1;
                Some(self.atom()?.sqrt())
            }
            'π' => {
                self.at += 1;
                Some(std::f64::consts::PI)
            }
            '(' => {
                self.at += 1;
                let value = self.sum()?;
                self.take(&[')'])?;
                Some(value)
            }
            '|' => {
                self.at += 1;
                let value = self.sum()?;
                self.take(&['|'])?;
                Some(value.abs())
            }
            c if c.is_ascii_digit() => self.number(),
            c if c.is_alphabetic() => self.function(),
            _ => None,
        }
    }

    fn function(&mut self) -> Option<f64> {
        let start = self.at;
        while self.peek().is_some_and(char::is_alphabetic) {
            self.at += 1;
        }
        let name: String = self.chars[start..self.at].iter().collect();
        self.take(&['('])?;
        let first = self.sum()?;
        let second = self.take(&[',', ';']).and_then(|_| self.sum());
        self.take(&[')'])?;
        match (name.as_str(), second) {
            ("tanh", None) => Some(first.tanh()),
            ("cosh", None) => Some(first.cosh()),
            ("sinh", None) => Some(first.sinh()),
            ("exp", None) => Some(first.exp()),
            ("ln", None) => Some(first.ln()),
            ("min", Some(second)) => Some(first.min(second)),
            ("max", Some(second)) => Some(first.max(second)),
            _ => None,
        }
    }

    fn number(&mut self) -> Option<f64> {
        let start = self.at;
        while self.peek().is_some_and(|c| c.is_ascii_digit() || c == '.') {
            self.at += 1;
        }
        if self.peek() == Some('e') {
            self.at += 1;
            if self.peek() == Some('-') {
                self.at += 1;
            }
            while self.peek().is_some_and(|c| c.is_ascii_digit()) {
                self.at += 1;
            }
        }
        let number: f64 = self.chars[start..self.at].iter().collect::<String>().parse().ok()?;
        if self.peek() != Some(' ') {
            return Some(number);
        }
        // The longest unit that ends at a boundary.
        let rest: String = self.chars[self.at + 1..].iter().collect();
        let unit = UNITS
            .iter()
            .filter(|u| !u.symbol.is_empty() && rest.starts_with(u.symbol))
            .filter(|u| !rest[u.symbol.len()..].starts_with(|c: char| c.is_alphanumeric()))
            .max_by_key(|u| u.symbol.len());
        Some(match unit {
            Some(unit) => {
                self.at += 1 + unit.symbol.chars().count();
                number * unit.factor()
            }
            None => number,
        })
    }
}

#[test]
fn arithmetic_is_read_back() {
    for (text, value) in [
        ("4.903 m/s²·7600.6 kg", 4.903 * 7600.6),
        ("3/8·1.525 m", 0.571875),
        ("√(1.525 m/1.83 m)", (1.525_f64 / 1.83).sqrt()),
        (
            "37.281 kN·571.88 mm + 13.59 kN·883.5 mm",
            37281.0 * 0.57188 + 13590.0 * 0.8835,
        ),
        ("1.525 m·(1 − (cosh(1.5333) − 1)/(1.5333·sinh(1.5333)))", 0.8835),
        ("√((3 kN)² + (4 kN)²)", 5000.0),
        ("33.33 kN·m/(π·(3.66 m)²·2 mm/4)", 33330.0 / 0.0210418),
    ] {
        let read = evaluate(text).expect("readable");
        assert!((read - value).abs() < 1e-4 * value, "{text}: {read}");
    }
    assert_eq!(evaluate("see table"), None);
}
