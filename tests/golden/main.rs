//! Golden reports of the examples, and the rendering of reports.

mod examples;
mod sample;

/// Writes the samples and their reports for looking at them: `TANKCHECK_LOOK=folder cargo test --test golden look`.
#[test]
fn look() {
    let Some(folder) = std::env::var_os("TANKCHECK_LOOK") else {
        return;
    };
    use sample::Kind;
    let names = [
        (Kind::Compare, "Broad tank of Manos and Clough, 1982", "compare"),
        (Kind::Check, "Broad tank, codes alone", "check"),
        (Kind::Rectangle, "Concrete strip", "rectangle"),
    ];
    for (kind, name, sub) in names {
        let out = std::path::Path::new(&folder).join(sub);
        std::fs::create_dir_all(&out).expect("the folder can be made");
        sample::write(&out, kind, name);
        let start = std::time::Instant::now();
        let path = tankcheck::report::render(&out, None).expect("the sample renders");
        let size = std::fs::metadata(&path).expect("the report exists").len();
        println!("{} {} bytes {:?}", path.display(), size, start.elapsed());
    }
}
