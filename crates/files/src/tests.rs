//! Invariants of output folders at every moment of a run, a killed one included.

use std::fs;
use std::path::Path;

use super::staging::{Commit, Staging, discard};
use super::{Kind, MANIFEST_FILE, OutputFolder, PART, WorkFolder, settle, write_whole};
use crate::error::{EXIT_COMPUTATION, EXIT_INPUT};

const KIND: Kind = Kind {
    id: "test",
    option: "--out",
    names: |name| ["report.html", "results.json", "figures"].contains(&name),
    keeps: |_| false,
};

/// Names of all entries below a folder, sorted.
fn tree(folder: &Path) -> Vec<String> {
    let mut names: Vec<String> = super::files_below(folder).unwrap().iter().map(|p| super::manifest::key(p)).collect();
    names.sort();
    names
}

fn text(path: &Path) -> String {
    fs::read_to_string(path).unwrap()
}

/// Writes files (path, text) as results of a kind.
fn write_as(kind: Kind, target: &Path, files: &[(&str, &str)]) {
    let folder = OutputFolder::prepare(target, kind).unwrap();
    fill(&folder.path(), files);
    folder.commit().unwrap();
}

fn fill(folder: &Path, files: &[(&str, &str)]) {
    for (name, text) in files {
        let path = folder.join(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, text).unwrap();
    }
}

#[test]
fn nothing_is_left_without_commit_not_even_the_folders_above() {
    let home = tempfile::tempdir().unwrap();
    let target = home.path().join("a/b/out");
    let folder = OutputFolder::prepare(&target, KIND).unwrap();
    fill(&folder.path(), &[("report.html", "x")]);
    drop(folder);
    assert_eq!(fs::read_dir(home.path()).unwrap().count(), 0);
}

#[test]
fn commit_replaces_an_earlier_run_and_leaves_other_files_alone() {
    let home = tempfile::tempdir().unwrap();
    let out = home.path().join("out");
    write_as(KIND, &out, &[("report.html", "old"), ("results.json", "old"), ("figures/old.svg", "old")]);
    fill(&out, &[("notes.txt", "mine"), ("figures/mine.svg", "mine"), ("paraview/tank.pvd", "x")]);
    write_as(KIND, &out, &[("report.html", "new"), ("figures/new.svg", "new")]);
    assert_eq!(
        tree(&out),
        ["figures/mine.svg", "figures/new.svg", MANIFEST_FILE, "notes.txt", "paraview/tank.pvd", "report.html"]
    );
    assert_eq!((text(&out.join("report.html")), text(&out.join("notes.txt"))), ("new".into(), "mine".into()));
    assert_eq!(fs::read_dir(home.path()).unwrap().count(), 1);
}

/// Names that results have, in a folder without a manifest, or with one that does not list them.
#[test]
fn files_that_this_program_did_not_write_are_never_touched() {
    for name in ["report.html", "results.json", "figures/mine.svg", MANIFEST_FILE] {
        let home = tempfile::tempdir().unwrap();
        fill(home.path(), &[(name, "mine")]);
        let error = OutputFolder::prepare(home.path(), KIND).unwrap_err();
        let first = name.split('/').next().unwrap();
        assert!(error.to_string().contains(&format!("`{first}`")), "{error}");
        assert_eq!(error.exit_code(), EXIT_INPUT);
        assert_eq!(tree(home.path()), [name]);
    }
    // One that appears during the run.
    let home = tempfile::tempdir().unwrap();
    let out = home.path().join("out");
    write_as(KIND, &out, &[("report.html", "old")]);
    let folder = OutputFolder::prepare(&out, KIND).unwrap();
    fill(&folder.path(), &[("report.html", "new"), ("figures/a.svg", "new")]);
    fill(&out, &[("figures/a.svg", "mine")]);
    let error = folder.commit().unwrap_err();
    assert!(error.to_string().contains("`figures"), "{error}");
    assert_eq!(text(&out.join("report.html")), "old");
    assert_eq!(text(&out.join("figures/a.svg")), "mine");
    assert_eq!(tree(&out).len(), 3);
}

#[test]
fn a_result_that_was_edited_is_not_overwritten() {
    let home = tempfile::tempdir().unwrap();
    write_as(KIND, home.path(), &[("report.html", "x"), ("results.json", "x")]);
    fs::write(home.path().join("report.html"), "x, signed").unwrap();
    let error = OutputFolder::prepare(home.path(), KIND).unwrap_err();
    assert!(error.to_string().contains("`report.html` has changed"), "{error}");
    // Removed is not edited.
    fs::remove_file(home.path().join("report.html")).unwrap();
    write_as(KIND, home.path(), &[("report.html", "new")]);
}

#[test]
fn results_of_another_kind_are_not_replaced_and_kept_names_stay() {
    let home = tempfile::tempdir().unwrap();
    write_as(KIND, home.path(), &[("report.html", "x"), ("results.json", "x")]);
    let other = Kind { id: "other", ..KIND };
    let error = OutputFolder::prepare(home.path(), other).unwrap_err();
    assert!(error.to_string().contains("tankcheck test"), "{error}");
    let report = Kind { names: |name| name == "report.html", keeps: |name| name == "results.json", ..KIND };
    write_as(report, home.path(), &[("report.html", "again")]);
    assert_eq!(tree(home.path()), [MANIFEST_FILE, "report.html", "results.json"]);
    // Both are still recognised as our own.
    write_as(KIND, home.path(), &[("report.html", "third")]);
    assert_eq!(tree(home.path()), [MANIFEST_FILE, "report.html"]);
}

/// A manifest with files outside its folder is rejected.
#[test]
fn a_manifest_reaches_no_further_than_its_folder() {
    for name in ["../precious.txt", "/etc/hostname", "figures/../../precious.txt", ""] {
        let home = tempfile::tempdir().unwrap();
        let out = home.path().join("out");
        fill(home.path(), &[("precious.txt", "x")]);
        fill(
            &out,
            &[(
                MANIFEST_FILE,
                &format!(r#"{{"format":"tankcheck-manifest/1","kind":"test","files":{{"{name}":"00"}}}}"#),
            )],
        );
        assert!(OutputFolder::prepare(&out, KIND).is_err(), "{name}");
        assert_eq!(text(&home.path().join("precious.txt")), "x");
    }
}

/// Leftover of a killed process: the folder without its lock, which is released with the handle.
fn killed(staging: Staging) -> std::path::PathBuf {
    let folder = staging.folder.clone();
    let kept = folder.with_extension("kept");
    fs::rename(&folder, &kept).unwrap();
    drop(staging);
    fs::rename(&kept, &folder).unwrap();
    folder
}

#[test]
fn staging_of_a_process_that_is_gone_is_swept_and_that_of_one_that_lives_is_kept() {
    let home = tempfile::tempdir().unwrap();
    let out = home.path().join("out");
    let alive = Staging::new(home.path(), "out", &out).unwrap();
    let dead = killed(Staging::new(home.path(), "out", &out).unwrap());
    fill(&dead.join("files"), &[("report.html", "half")]);
    // A folder of such a name that is not ours, and one killed before it had a marker.
    fill(home.path(), &[(".mine.1.partial/thesis.doc", "mine")]);
    fs::create_dir(home.path().join(".out.77.partial")).unwrap();
    settle(&out);
    assert!(alive.folder.exists() && !dead.exists());
    assert_eq!(text(&home.path().join(".mine.1.partial/thesis.doc")), "mine");
    assert!(!home.path().join(".out.77.partial").exists());
    write_as(KIND, &out, &[("report.html", "x")]);
    assert!(alive.folder.exists());
}

/// A commit is interrupted after each of its moves; the next run finishes it.
#[test]
fn a_commit_that_was_cut_off_anywhere_is_finished() {
    let new = [("figures/a.svg", "new"), ("figures/b.svg", "new"), ("report.html", "new")];
    for moved in 0..=new.len() + 2 {
        let home = tempfile::tempdir().unwrap();
        let out = home.path().join("out");
        write_as(KIND, &out, &[("report.html", "old"), ("results.json", "old"), ("figures/old.svg", "old")]);
        let staging = Staging::new(&out, "out", &out).unwrap();
        fill(&staging.files(), &new);
        let manifest = super::manifest::Manifest::of(&staging.files(), KIND.id).unwrap();
        fs::write(staging.files().join(MANIFEST_FILE), manifest.text().unwrap()).unwrap();
        let commit = Commit { target: out.clone(), stale: vec!["results.json".into(), "figures/old.svg".into()] };
        fs::write(staging.folder.join("commit.json"), serde_json::to_vec(&commit).unwrap()).unwrap();
        let files = staging.files();
        let folder = killed(staging);
        let order = ["figures/a.svg", "figures/b.svg", "report.html", MANIFEST_FILE];
        for name in order.iter().take(moved) {
            fs::rename(files.join(name), out.join(name)).unwrap();
        }
        if moved > order.len() {
            fs::remove_file(out.join("results.json")).unwrap();
        }
        settle(&out);
        assert!(!folder.exists());
        assert_eq!(tree(&out), ["figures/a.svg", "figures/b.svg", MANIFEST_FILE, "report.html"], "{moved}");
        assert_eq!(text(&out.join("report.html")), "new");
        // All files are recognised as our own.
        write_as(KIND, &out, &[("report.html", "third")]);
    }
}

/// Eight runs at once into one folder, new or with results: none fails, and the files are those of one of them.
#[test]
fn runs_at_once_replace_each_other_as_sets() {
    let home = tempfile::tempdir().unwrap();
    for round in 0..6 {
        let out = home.path().join(format!("out{}", round / 3));
        std::thread::scope(|scope| {
            for k in 0..8 {
                let (out, text) = (&out, format!("{round} {k}"));
                scope.spawn(move || {
                    let names = ["figures/a.svg", "report.html", "results.json"];
                    write_as(KIND, out, &names.map(|name| (name, text.as_str())));
                });
            }
        });
        let one = text(&out.join("report.html"));
        assert!(one.starts_with(&round.to_string()), "{one}");
        assert_eq!((text(&out.join("results.json")), text(&out.join("figures/a.svg"))), (one.clone(), one));
        assert_eq!(super::differing(&out, |_| true), None);
        assert_eq!(tree(&out).len(), 4);
    }
    assert_eq!(fs::read_dir(home.path()).unwrap().count(), 2);
}

/// A reader that holds the lock sees files of one set, whatever is written meanwhile.
#[test]
fn a_reader_sees_one_set() {
    let home = tempfile::tempdir().unwrap();
    let out = &home.path().join("out");
    write_as(KIND, out, &[("report.html", "0"), ("results.json", "0")]);
    std::thread::scope(|scope| {
        let writer = scope.spawn(move || {
            for k in 1..40 {
                let text = k.to_string();
                write_as(KIND, out, &[("report.html", &text), ("results.json", &text)]);
            }
        });
        while !writer.is_finished() {
            let _reading = settle(out);
            assert_eq!(text(&out.join("report.html")), text(&out.join("results.json")));
        }
    });
}

/// A pipe in the place of a result, of the manifest or of a marker is not waited for.
#[cfg(unix)]
#[test]
fn pipes_are_not_read() {
    let home = tempfile::tempdir().unwrap();
    let out = home.path().join("out");
    write_as(KIND, &out, &[("report.html", "x")]);
    let pipe = |path: &Path| {
        let _ = fs::remove_file(path);
        assert!(std::process::Command::new("mkfifo").arg(path).status().unwrap().success());
    };
    fs::create_dir(out.join(".out.7.partial")).unwrap();
    pipe(&out.join(".out.7.partial/staging.json"));
    write_as(KIND, &out, &[("report.html", "y")]);
    assert_eq!(super::unmarked(&out), [out.join(".out.7.partial")]);
    pipe(&out.join("report.html"));
    assert_eq!(super::differing(&out, |_| true), Some("report.html".into()));
    assert!(OutputFolder::prepare(&out, KIND).is_err());
    pipe(&out.join(MANIFEST_FILE));
    assert!(OutputFolder::prepare(&out, KIND).is_err());
}

#[test]
fn an_interrupted_process_leaves_a_started_commit_to_the_next() {
    let home = tempfile::tempdir().unwrap();
    let staging = Staging::new(home.path(), "out", &home.path().join("out")).unwrap();
    discard(&staging.folder);
    assert!(!staging.folder.exists());
    let staging = Staging::new(home.path(), "out", &home.path().join("out")).unwrap();
    fs::write(staging.folder.join("commit.json"), "{}").unwrap();
    discard(&staging.folder);
    assert!(staging.folder.exists());
}

#[test]
fn a_file_is_written_whole_or_not_at_all() {
    let home = tempfile::tempdir().unwrap();
    let path = home.path().join("x.json");
    write_whole(&path, b"one").unwrap();
    write_whole(&path, b"two").unwrap();
    assert_eq!((text(&path), tree(home.path())), ("two".into(), vec!["x.json".to_string()]));
    let error = write_whole(&home.path().join("missing/x.json"), b"x").unwrap_err();
    assert_eq!(error.exit_code(), EXIT_COMPUTATION);
}

fn is_work(name: &str) -> bool {
    name.starts_with("checkpoint-") || name.starts_with("ida.partial.json")
}

/// Foreign files and folders among unfinished work stay and do not block a run.
#[test]
fn files_of_others_among_unfinished_work_stay() {
    let home = tempfile::tempdir().unwrap();
    let out = home.path().join("out");
    let work = WorkFolder::open(&out, "ida", is_work, false).unwrap();
    fs::write(work.file("checkpoint-1"), "x").unwrap();
    fill(&out, &[("unfinished/notes.txt", "mine"), ("unfinished/sub/n.txt", "mine")]);
    drop(work);
    for resume in [true, false, false] {
        let work = WorkFolder::open(&out, "ida", is_work, resume).unwrap();
        assert_eq!(work.names().unwrap().len(), usize::from(resume));
        work.done();
        assert_eq!(text(&out.join("unfinished/notes.txt")), "mine");
        assert_eq!(text(&out.join("unfinished/sub/n.txt")), "mine");
        if resume {
            fill(&out, &[("unfinished/checkpoint-2", "x")]);
        }
    }
}

#[test]
fn unfinished_work_is_kept_for_a_resume_and_swept_otherwise() {
    let home = tempfile::tempdir().unwrap();
    let out = home.path().join("out");
    // A run without work leaves no folder.
    drop(WorkFolder::open(&out, "ida", is_work, false).unwrap());
    assert!(!out.exists());
    let work = WorkFolder::open(&out, "ida", is_work, false).unwrap();
    fs::write(work.file("ida.partial.json"), "x").unwrap();
    fs::write(work.file(&format!("checkpoint-1{PART}")), "half").unwrap();
    // A second process waits outside.
    let error = WorkFolder::open(&out, "ida", is_work, true).unwrap_err();
    assert!(error.to_string().contains("another process"), "{error}");
    drop(work);
    let work = WorkFolder::open(&out, "ida", is_work, true).unwrap();
    assert_eq!(work.names().unwrap(), ["ida.partial.json"]);
    drop(work);
    let work = WorkFolder::open(&out, "ida", is_work, false).unwrap();
    assert!(work.names().unwrap().is_empty());
    fs::write(work.file("ida.partial.json"), "x").unwrap();
    work.done();
    assert!(!out.join("unfinished").exists());
    // Other people's.
    fill(&out, &[("unfinished/symphony.txt", "mine")]);
    for resume in [false, true] {
        assert!(WorkFolder::open(&out, "ida", is_work, resume).is_err());
    }
    assert_eq!(text(&out.join("unfinished/symphony.txt")), "mine");
}
