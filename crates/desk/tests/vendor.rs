//! Libraries of third parties are the files that `vendor/versions.json` names, under licences that `deny.toml` allows.

use std::path::Path;

use serde_json::Value;
use sha2::{Digest, Sha256};

#[test]
fn vendored_files_are_those_that_are_listed() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let vendor = root.join("page/vendor");
    let text = |path: &Path| std::fs::read_to_string(path).unwrap();
    let allowed = text(&root.join("../../deny.toml"));
    let versions: Value = serde_json::from_str(&text(&vendor.join("versions.json"))).unwrap();
    let mut listed = Vec::new();
    for library in versions["libraries"].as_array().unwrap() {
        let (package, version) = (library["package"].as_str().unwrap(), library["version"].as_str().unwrap());
        let licence = library["licence"].as_str().unwrap();
        assert!(allowed.contains(&format!("\"{licence}\"")), "{package}: {licence}");
        let files = library["files"].as_object().unwrap();
        assert!(files.keys().any(|name| name.ends_with(".LICENSE")), "{package} has no licence");
        for (name, hash) in files {
            let bytes = std::fs::read(vendor.join(name)).unwrap();
            let found: String = Sha256::digest(&bytes).iter().map(|byte| format!("{byte:02x}")).collect();
            assert_eq!(hash.as_str(), Some(found.as_str()), "{name} is not what vendor/renew wrote");
            if name.ends_with(".js") {
                assert!(bytes.starts_with(format!("/* {package} {version},").as_bytes()), "{name}");
            }
            listed.push(name.clone());
        }
    }
    // Nothing is served that is not listed.
    for entry in std::fs::read_dir(&vendor).unwrap() {
        let name = entry.unwrap().file_name().to_string_lossy().into_owned();
        assert!(!(name.ends_with(".js") || name.ends_with(".css")) || listed.contains(&name), "{name}");
    }
}
