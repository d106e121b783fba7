//! `templates export`: what it writes gives the same report, and nothing is overwritten unasked.

use std::path::Path;

use crate::study::tankcheck;

fn done(folder: &Path, args: &[&str]) {
    let output = tankcheck(folder, args);
    // 4: something was not checked.
    let code = output.status.code();
    assert!(matches!(code, Some(0 | 1 | 4)), "{args:?} {code:?}: {}", String::from_utf8_lossy(&output.stderr));
}

#[test]
fn exported_templates_give_the_identical_report() {
    let home = tempfile::tempdir().unwrap();
    let read = |name: &str| std::fs::read(home.path().join(name)).unwrap();
    done(home.path(), &["init", "--out", "tank.json"]);
    done(home.path(), &["check", "tank.json", "--out", "out"]);
    done(home.path(), &["report", "out", "--report", "full"]);
    let embedded = read("out/report.html");
    done(home.path(), &["templates", "export", "mine"]);
    done(home.path(), &["report", "out", "--report", "full", "--templates", "mine"]);
    assert!(embedded == read("out/report.html"), "another report");
    // They are read: a change shows.
    let page = home.path().join("mine/report.html");
    let text = std::fs::read_to_string(&page).unwrap();
    std::fs::write(&page, text.replacen("</body>", "<p>office</p></body>", 1)).unwrap();
    done(home.path(), &["report", "out", "--report", "full", "--templates", "mine"]);
    assert!(String::from_utf8(read("out/report.html")).unwrap().contains("<p>office</p>"));
}

#[test]
fn templates_are_overwritten_only_with_force() {
    let home = tempfile::tempdir().unwrap();
    done(home.path(), &["templates", "export", "mine"]);
    let (own, note) = (home.path().join("mine/style.css"), home.path().join("mine/note.txt"));
    std::fs::write(&own, "own").unwrap();
    std::fs::write(&note, "note").unwrap();
    let refused = tankcheck(home.path(), &["templates", "export", "mine"]);
    let message = String::from_utf8(refused.stderr).unwrap();
    assert_eq!(refused.status.code(), Some(2));
    assert!(message.contains("error[T0602]") && message.contains("--force"), "{message}");
    assert_eq!(std::fs::read_to_string(&own).unwrap(), "own");
    done(home.path(), &["templates", "export", "mine", "--force"]);
    assert_ne!(std::fs::read_to_string(&own).unwrap(), "own");
    assert_eq!(std::fs::read_to_string(&note).unwrap(), "note");
    std::fs::write(home.path().join("file"), "").unwrap();
    let refused = tankcheck(home.path(), &["templates", "export", "file", "--force"]);
    assert_eq!(refused.status.code(), Some(2), "{}", String::from_utf8_lossy(&refused.stderr));
}
