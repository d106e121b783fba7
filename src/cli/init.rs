//! `tankcheck init`: a commented tank file to start from.

use crate::cli::{Global, print};
use crate::error::{EXIT_OK, Error};

/// Arguments.
#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  tankcheck init > tank.json
  tankcheck init --shape rectangle > basin.json
  tankcheck init | tankcheck check -")]
pub(crate) struct Args {
    /// Shape of the tank.
    #[arg(long, value_enum, default_value_t = Shape::Cylinder)]
    shape: Shape,
}

/// Shape of the tank in the file.
#[derive(clap::ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
enum Shape {
    /// A steel cylinder on anchors.
    Cylinder,
    /// A strip of a concrete basin.
    Rectangle,
}

impl Shape {
    fn text(self) -> &'static str {
        match self {
            Shape::Cylinder => include_str!("init/cylinder.json"),
            Shape::Rectangle => include_str!("init/rectangle.json"),
        }
    }
}

/// Runs the subcommand; returns the exit code.
pub(crate) fn run(args: Args, _: &Global) -> Result<u8, Error> {
    print(args.shape.text())?;
    Ok(EXIT_OK)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::input::diagnostic::Source;
    use crate::input::tank::parse;

    #[test]
    fn both_files_are_valid() {
        for shape in [Shape::Cylinder, Shape::Rectangle] {
            let source = Source::new("tank.json", shape.text());
            let file = parse(&source).unwrap_or_else(|faults| panic!("{}", faults.render(&source, false)));
            assert!(file.remarks.is_empty(), "{:?}", file.remarks);
        }
    }
}
