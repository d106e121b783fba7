//! ParaView files: one collection and two well-formed files a moment. `tests/tools` reads them with meshio.

use results::vtu;

use crate::vtu_sample::snapshots;

#[test]
fn files_are_well_formed() {
    let home = tempfile::tempdir().expect("a temporary folder");
    vtu::write(home.path(), &snapshots()).expect("writable");
    let files = std::fs::read_dir(home.path()).expect("readable").count();
    assert_eq!(files, 5);
    for entry in std::fs::read_dir(home.path()).expect("readable").flatten() {
        let text = std::fs::read_to_string(entry.path()).expect("text");
        roxmltree::Document::parse(&text).unwrap_or_else(|e| panic!("{:?}: {e}", entry.path()));
    }
}
