//! The `tankcheck` command.

fn main() -> std::process::ExitCode {
    tankcheck::cli::main()
}
