//! Captions and line numbers in the reports of the examples.

mod kept;

use std::collections::BTreeSet;

use report::Level;

fn page(name: &str, level: Level) -> String {
    kept::page(name, level).html
}

/// Texts between two tags, without the tags within.
fn between(html: &str, open: &str, close: &str) -> Vec<String> {
    let parts = html.split(open).skip(1);
    let inside = parts.filter_map(|part| part.split_once(close).map(|(inside, _)| inside));
    inside
        .map(|text| {
            let mut out = String::new();
            for (i, piece) in text.split('<').enumerate() {
                out.push_str(if i == 0 { piece } else { piece.split_once('>').map_or("", |(_, rest)| rest) });
            }
            out.trim().to_owned()
        })
        .collect()
}

/// `Figure 2. Wave height. Over time …`: words behind the number of every figure; no two tables with one title.
#[test]
fn figures_say_what_they_show_and_tables_differ() {
    for place in kept::names() {
        let html = page(&place, Level::Full);
        let figures = between(&html, "<figcaption>", "</figcaption>");
        for caption in &figures {
            let (number, rest) = caption.split_once(". ").unwrap_or((caption, ""));
            assert!(number.starts_with("Figure") && rest.trim().len() > 3, "{place}: {caption}");
        }
        let tables = between(&html, "<caption>", "</caption>");
        let titles: Vec<&str> = (tables.iter()).map(|c| c.split_once(". ").map_or("", |c| c.1)).collect();
        let distinct: BTreeSet<&str> = titles.iter().copied().collect();
        let twice: Vec<&&str> = titles.iter().filter(|t| titles.iter().filter(|u| u == t).count() > 1).collect();
        assert_eq!(distinct.len(), titles.len(), "{place}: {twice:?}");
    }
}

/// A line of a sheet has one number at every level: name and symbol of the lines of the standard report stand in the full one
/// under the same number of the same sheet.
#[test]
fn lines_have_one_number_at_every_level() {
    let mut compared = 0;
    for name in kept::names() {
        let [standard, full] = [Level::Standard, Level::Full].map(|level| page(&name, level));
        let sheets = |html: &str| -> Vec<(String, BTreeSet<(usize, String)>)> {
            let parts = html.split("<details class=\"sheet\" id=\"").skip(1);
            parts
                .map(|part| {
                    let id = part.split('"').next().unwrap_or_default().to_owned();
                    let part = part.split("</details>").next().unwrap_or_default();
                    let lines = part.split("<span class=\"eno\">").skip(1).filter_map(|line| {
                        let (number, rest) = line.split_once("</span>")?;
                        let name = rest.trim_start_matches("<span class=\"name\">").trim_start();
                        let end = name.find(", <span").into_iter().chain(name.find('<')).min()?;
                        Some((number.trim().parse().ok()?, name[..end].trim().to_owned()))
                    });
                    (id, lines.collect())
                })
                .collect()
        };
        let full = sheets(&full);
        for (id, lines) in sheets(&standard) {
            let of_full = full.iter().find(|s| s.0 == id).map(|s| &s.1);
            for (number, line) in lines {
                // The full sheet leaves out lines that the sheet of the record has; lines of several grounds have one name here.
                let there = of_full.and_then(|all| all.iter().find(|l| l.0 == number));
                let Some((_, found)) = there.filter(|_| !line.contains(';')) else { continue };
                assert_eq!(&line, found, "{name} {id} line {number}");
                compared += 1;
            }
        }
    }
    assert!(compared > 200, "{compared}");
}

/// The labels of many courses stand above one another higher than a flat wall: all of them within the drawing, none over another.
#[test]
fn labels_of_many_courses_stay_within_the_sketch() {
    let (mut results, series) = kept::read("05_oil_tank");
    let wall = results.tank.tank.wall_height();
    let mut course = results.tank.tank.courses[0].clone();
    course.height = wall / 16.0;
    results.tank.tank.courses = vec![course; 16];
    let home = tempfile::tempdir().expect("a temporary folder");
    results::write(home.path(), &results, &series).expect("writable");
    let page = report::of_folder(home.path(), None, Level::Summary).expect("renders");
    let (_, svg) = (page.figures.iter().find(|f| f.0 == "sketch.svg")).expect("a sketch");
    let svg = roxmltree::Document::parse(svg).expect("XML");
    let number = |node: &roxmltree::Node, key: &str| node.attribute(key).and_then(|v| v.parse::<f64>().ok());
    let name = &results.tank.tank.courses[0].material.name;
    let labels = svg.descendants().filter(|n| n.has_tag_name("text"));
    let labels = labels.filter(|n| n.text().is_some_and(|t| t.contains('×') && t.contains(name.as_str())));
    let mut places: Vec<f64> = labels.filter_map(|n| number(&n, "y")).collect();
    places.sort_by(f64::total_cmp);
    // Letters of 11 units stand about 8 above their line.
    assert_eq!(places.len(), 16);
    assert!(places[0] >= 8.0, "{places:?}");
    assert!(places.windows(2).all(|p| p[1] - p[0] >= 11.0), "{places:?}");
}
