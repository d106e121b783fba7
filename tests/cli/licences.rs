//! Every dependency's licence is on the list of `deny.toml`.

use std::process::Command;

/// Whether an SPDX expression can be satisfied by allowed licences (`A OR B`, `A AND B`, `A/B`, parentheses).
fn satisfied(expression: &str, allowed: &[String]) -> bool {
    let expression = expression.replace('/', " OR ").replace('(', " ( ").replace(')', " ) ");
    let mut tokens: Vec<String> = Vec::new();
    for word in expression.split_whitespace() {
        match tokens.last_mut() {
            // `Apache-2.0 WITH LLVM-exception` is one licence.
            Some(last) if word == "WITH" || last.ends_with(" WITH") => {
                last.push(' ');
                last.push_str(word);
            }
            _ => tokens.push(word.to_owned()),
        }
    }
    let mut at = 0;
    let result = alternatives(&tokens, &mut at, allowed);
    result && at == tokens.len()
}

fn alternatives(tokens: &[String], at: &mut usize, allowed: &[String]) -> bool {
    let mut result = all(tokens, at, allowed);
    while tokens.get(*at).is_some_and(|t| t == "OR") {
        *at += 1;
        result |= all(tokens, at, allowed);
    }
    result
}

fn all(tokens: &[String], at: &mut usize, allowed: &[String]) -> bool {
    let mut result = one(tokens, at, allowed);
    while tokens.get(*at).is_some_and(|t| t == "AND") {
        *at += 1;
        result &= one(tokens, at, allowed);
    }
    result
}

fn one(tokens: &[String], at: &mut usize, allowed: &[String]) -> bool {
    let token = tokens.get(*at).map(String::as_str).unwrap_or("");
    *at += 1;
    if token == "(" {
        let result = alternatives(tokens, at, allowed);
        *at += 1;
        return result;
    }
    allowed.iter().any(|a| a == token)
}

#[test]
fn dependencies_have_allowed_licences() {
    let root = env!("CARGO_MANIFEST_DIR");
    let deny = std::fs::read_to_string(format!("{root}/deny.toml")).expect("deny.toml is in the repository");
    let list = deny.split_once("allow = [").and_then(|(_, rest)| rest.split_once(']')).expect("deny.toml has a list").0;
    let allowed: Vec<String> = list.split('"').skip(1).step_by(2).map(str::to_owned).collect();
    let rustc = Command::new("rustc").arg("-vV").output().expect("rustc runs");
    let version = String::from_utf8_lossy(&rustc.stdout).into_owned();
    let host = version.lines().find_map(|l| l.strip_prefix("host: ")).expect("rustc names its host");
    // Only this platform's packages have been downloaded; the others need not be.
    let output = Command::new(env!("CARGO"))
        .args(["metadata", "--format-version", "1", "--locked", "--offline", "--filter-platform", host])
        .current_dir(root)
        .output()
        .expect("cargo runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let metadata: serde_json::Value = serde_json::from_slice(&output.stdout).expect("cargo metadata writes JSON");
    let packages = metadata["packages"].as_array().expect("a list of packages");
    let bad: Vec<String> = packages
        .iter()
        .filter(|p| !p["license"].as_str().is_some_and(|l| satisfied(l, &allowed)))
        .map(|p| format!("{} {}: {}", p["name"], p["version"], p["license"]))
        .collect();
    assert!(packages.len() > 50, "only {} packages found", packages.len());
    assert!(bad.is_empty(), "licences not in deny.toml:\n{}", bad.join("\n"));
}

/// An advisory is ignored in `deny.toml` only as long as its package is needed.
#[test]
fn ignored_advisories_are_still_needed() {
    let root = env!("CARGO_MANIFEST_DIR");
    let read = |name: &str| std::fs::read_to_string(format!("{root}/{name}")).expect("in the repository");
    let (deny, lock) = (read("deny.toml"), read("Cargo.lock"));
    let ignored: Vec<&str> = deny.lines().filter(|l| l.contains("RUSTSEC-")).collect();
    assert_eq!(ignored.len(), 1, "{ignored:?}");
    assert!(ignored[0].contains("RUSTSEC-2024-0436") && ignored[0].contains("reason"));
    assert!(lock.contains("name = \"paste\"\n"), "paste is gone: remove the advisory from deny.toml");
}

#[test]
fn expressions_are_read_right() {
    let allowed = ["MIT".to_string(), "Apache-2.0 WITH LLVM-exception".to_string()];
    assert!(satisfied("MIT OR GPL-3.0", &allowed));
    assert!(satisfied("Apache-2.0/MIT", &allowed));
    assert!(satisfied("GPL-3.0 OR Apache-2.0 WITH LLVM-exception", &allowed));
    assert!(!satisfied("MIT AND GPL-3.0", &allowed));
    assert!(!satisfied("(MIT OR GPL-3.0) AND LGPL-3.0", &allowed));
    assert!(!satisfied("", &allowed));
}
