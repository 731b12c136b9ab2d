//! `puzzle`.

use crate::harness::{Folder, fixture, json};

fn bunny() -> String {
    fixture("curves/bunny.svg").display().to_string()
}

/// A dot of a table: its place and its colours.
type Dot = ([f64; 2], Vec<u32>);

fn dots(table: &str) -> Vec<Dot> {
    let mut lines = table.lines();
    assert_eq!(lines.next(), Some("x,y,colours"));
    let dot = |line: &str| {
        let fields: Vec<&str> = line.split(',').collect();
        let number = |i: usize| fields[i].parse::<f64>().unwrap();
        let colours = fields[2].split(' ').map(|colour| colour.parse().unwrap());
        ([number(0), number(1)], colours.collect())
    };
    lines.map(dot).collect()
}

/// What somebody with a ruler would draw: pairs of dots, ascending.
fn solved(dots: &[Dot]) -> Vec<[usize; 2]> {
    let mut edges = Vec::new();
    for (i, (p, colours)) in dots.iter().enumerate() {
        for colour in colours {
            let others = dots.iter().enumerate();
            let others = others.filter(|(j, (_, set))| *j != i && set.contains(colour));
            let far = |q: [f64; 2]| (p[0] - q[0]).hypot(p[1] - q[1]);
            let closest = others.min_by(|a, b| far(a.1.0).total_cmp(&far(b.1.0)));
            let j = closest.unwrap().0;
            edges.push([i.min(j), i.max(j)]);
        }
    }
    edges.sort_unstable();
    edges.dedup();
    edges
}

#[test]
fn a_table_of_dots_is_solved_by_hand() {
    let (folder, curve) = (Folder::new(), bunny());
    let run = folder.run(&format!("puzzle {curve} -o dots.csv --json"));
    assert!(run.stderr.contains(" dots in "), "{}", run.stderr);
    let object = json(&run.fine());
    let dots = dots(&folder.read("dots.csv"));
    let edges = solved(&dots);
    assert_eq!(object["edges"], serde_json::json!(edges));
    assert_eq!(object["count"], dots.len());
    // One closed curve.
    assert_eq!(edges.len(), dots.len());
    let mut colours: Vec<u32> = dots.iter().flat_map(|dot| dot.1.clone()).collect();
    colours.sort_unstable();
    colours.dedup();
    assert_eq!(object["colours"], colours.len());
    assert!(object["margin"].as_f64().unwrap() >= 0.1);
    // Their order does not tell the curve.
    assert!(dots.is_sorted_by(|a, b| a.0 <= b.0));
}

#[test]
fn a_picture_has_its_rules_and_shows_lines_only_if_asked() {
    let (folder, curve) = (Folder::new(), bunny());
    for (option, has_lines) in [("", false), ("--solved", true)] {
        let picture = folder.run(&format!("puzzle {curve} {option}")).fine();
        let document = roxmltree::Document::parse(&picture).unwrap();
        let by_id = |id: &str| {
            document
                .descendants()
                .find(|n| n.attribute("id") == Some(id))
        };
        assert!(by_id("dots").is_some());
        assert_eq!(by_id("joins").is_some(), has_lines);
        let rules = by_id("rules").unwrap();
        let words: Vec<&str> = rules.descendants().filter_map(|n| n.text()).collect();
        assert!(words.concat().contains("closest other dot of its colour"));
        assert!(picture.contains("prefers-color-scheme: dark"));
    }
}

#[test]
fn more_is_asked_for_by_options() {
    let (folder, curve) = (Folder::new(), bunny());
    let count = |options: &str, key: &str| {
        let run = folder.run(&format!("puzzle {curve} {options} --json --quiet"));
        json(&run.fine())[key].as_u64().unwrap()
    };
    assert!(count("--max-distance 0.2%", "count") > count("", "count"));
    assert!(count("--least-step 100%", "count") <= count("--least-step 20%", "count"));
    assert!(count("--margin 60%", "colours") > count("--margin 5%", "colours"));
}

#[test]
fn corners_and_strokes_that_cross_are_drawn_too() {
    let plus = r#"<svg xmlns="http://www.w3.org/2000/svg"><path d="M 0 0 H 10 V 10 H 0 Z" fill="none" stroke="black"/><path d="M -5 5 H 15" stroke="black"/></svg>"#;
    let folder = Folder::with("plus.svg", plus);
    let run = folder.run("puzzle plus.svg --json");
    assert!(run.stderr.contains("touch or cross"), "{}", run.stderr);
    let object = json(&run.fine());
    let has = |at: [f64; 2]| {
        let dots = object["dots"].as_array().unwrap();
        dots.iter().any(|dot| dot["at"] == serde_json::json!(at))
    };
    assert!(has([0.0, 0.0]) && has([10.0, 10.0]));
}

#[test]
fn what_cannot_be_done_is_one_line() {
    let (folder, curve) = (Folder::new(), bunny());
    for (line, says) in [
        (
            format!("puzzle {curve} --margin 0%"),
            "the margin is 0: it must be above 0",
        ),
        (
            format!("puzzle {curve} --least-step 0%"),
            "the least step is 0: it must be above 0",
        ),
        (
            format!("puzzle {curve} --max-distance 1e-9"),
            "too long for the condition",
        ),
        (
            format!("puzzle {curve} -o dots.gpx"),
            "this cannot be written as gpx",
        ),
        (
            String::from("puzzle missing.svg"),
            "cannot read missing.svg",
        ),
    ] {
        let error = folder.run(&line).error();
        assert!(
            error.starts_with("error: ") && error.contains(says),
            "{error}"
        );
    }
    // Said by the parser of arguments.
    for option in ["--margin many", "--max-distance -1"] {
        let run = folder.run(&format!("puzzle {curve} {option}"));
        assert_eq!(run.status, Some(2), "{}", run.stderr);
    }
}

/// The text around the numbers of a document, and the numbers.
fn parts(document: &str) -> (String, Vec<f64>) {
    let is_number = |c: char| c.is_ascii_digit() || "+-.".contains(c);
    let mut numbers = Vec::new();
    let text = document.split_inclusive(|c| !is_number(c)).map(|word| {
        let (number, rest) = word.split_at(word.trim_end_matches(|c| !is_number(c)).len());
        match number.parse() {
            Ok(value) => {
                numbers.push(value);
                format!("#{rest}")
            }
            Err(_) => word.to_owned(),
        }
    });
    (text.collect(), numbers)
}

/// But for the last digits of numbers, which another machine may round in another way.
#[test]
fn the_pictures_of_the_docs_are_what_is_drawn() {
    let (folder, curve) = (Folder::new(), bunny());
    for (option, name) in [
        ("", "docs/images/puzzle.svg"),
        ("--solved", "docs/images/puzzle-solved.svg"),
    ] {
        let drawn = folder.run(&format!("puzzle {curve} {option}")).fine();
        let (text, numbers) = parts(&drawn);
        let path = fixture("..").join(name);
        let (documented, there) = parts(&std::fs::read_to_string(path).unwrap());
        assert_eq!(text, documented, "draw {name} again");
        let close = numbers
            .iter()
            .zip(&there)
            .all(|(a, b)| (a - b).abs() < 1e-6);
        assert!(close && numbers.len() == there.len(), "draw {name} again");
    }
}
