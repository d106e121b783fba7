//! The commands of `examples/experiments/README.md`.

use crate::compare::{stderr, tankcheck};

/// Every command runs, and every tank file of the folder has one.
#[test]
fn commands_of_the_experiments_run() {
    let folder = "examples/experiments";
    let text = std::fs::read_to_string(format!("{folder}/README.md")).expect("a page");
    let commands: Vec<&str> = text.split('`').filter(|part| part.starts_with("tankcheck ")).collect();
    for entry in std::fs::read_dir(folder).expect("a folder") {
        let name = entry.expect("readable").file_name().into_string().expect("text");
        let has = commands.iter().any(|command| command.contains(&name));
        assert!(has || !name.ends_with(".json"), "{name} has no command");
    }
    let home = tempfile::tempdir().expect("a temporary folder");
    for (i, command) in commands.iter().enumerate() {
        let out = home.path().join(i.to_string());
        let mut arguments: Vec<&str> = command.split(' ').skip(1).collect();
        if arguments[0] == "compare" {
            arguments.extend(["--no-mesh-error", "--out", out.to_str().expect("text")]);
        }
        let run = tankcheck(&arguments);
        // No method decides about a tank on a table: 4.
        assert!(matches!(run.status.code(), Some(0 | 4)), "{command}: {:?}\n{}", run.status.code(), stderr(&run));
    }
}
