//! Bad drawings and documents, and messages about them: rows of `docs/formats.md` as well.

use crate::bad_input::error;
use crate::harness::Folder;

#[test]
fn drawings_that_hold_no_points() {
    let svg = |inside: &str| format!("<svg xmlns=\"http://www.w3.org/2000/svg\">\n{inside}</svg>");
    for (content, says) in [
        (
            svg("<text x='1' y='2'>text</text>"),
            ": there are no circles and no paths",
        ),
        (
            svg("<use href='#a'/>"),
            ", line 2, column 1: `use` elements are not followed: put the shapes themselves in the drawing",
        ),
        (
            svg("<path d='M 1 2 L x'/>"),
            ", line 2, column 1: d is `M 1 2 L x`, which cannot be read",
        ),
        (
            svg("<circle cx='50%' cy='2'/>"),
            ", line 2, column 1: cx is `50%`, which cannot be read",
        ),
        (
            svg("<polyline points='0,0 1,1 2,foo 3,3'/>"),
            ", line 2, column 1: points is no list of numbers: invalid number at position 11",
        ),
        (
            svg("<polyline points='0,0 1'/>"),
            ", line 2, column 1: points has an odd number of coordinates: give pairs",
        ),
        (
            svg("<polyline points='0,0 1,NaN'/>"),
            ", line 2, column 1: points is no list of numbers: ",
        ),
        (
            svg("<polyline points='0,0 1,1e400'/>"),
            ", line 2, column 1: points is no list of numbers: ",
        ),
        (
            svg("<circle r='NaN'/>"),
            ", line 2, column 1: r is `NaN`, which cannot be read",
        ),
        (
            svg("<g transform='scale(1'><circle r='1'/></g>"),
            ", line 2, column 1: transform is no list of transforms: ",
        ),
        (svg("<circle cx='1e300' cy='2'/>"), ", line 2, column 1: `"),
        (String::from("<html/>"), ": this is no SVG document"),
        (String::from("<svg>\n<g></svg>"), ", line 2, column 4: "),
    ] {
        let found = error("p.svg", content);
        assert!(found.starts_with(&format!("p.svg{says}")), "{found}");
    }
}

#[test]
fn deep_documents_do_not_overflow() {
    let n = 100_000;
    let inside = "<g>".repeat(n) + "<circle r='1'/>" + &"</g>".repeat(n);
    let svg = format!("<svg xmlns='http://www.w3.org/2000/svg'>{inside}</svg>");
    let found = error("p.svg", svg);
    assert!(
        found.ends_with("more than 128 levels deep: simplify the document"),
        "{found}"
    );
    let found = error("p.json", "[".repeat(n));
    assert!(found.starts_with("p.json, line 1, column "), "{found}");
    let nested = format!(r#"{{"type": "Point", "coordinates": {}"#, "[".repeat(n));
    let found = error("p.geojson", nested);
    assert!(found.ends_with("recursion limit exceeded"), "{found}");
}

#[test]
fn messages_are_one_short_line() {
    let names: Vec<String> = (0..100_000).map(|i| format!("name{i}")).collect();
    assert_eq!(
        error("p.csv", names.join(",")),
        "p.csv, line 1: no columns are named x and y: there are `name0`, `name1`, `name2`, `name3`, \
         `name4`, `name5`, `name6`, `name7` and 99992 more; pass --x and --y with two of them"
    );
    let zeros = error("p.json", "[[1e300, 0]]");
    assert!(
        zeros.starts_with("p.json, line 1, column 11: `1e300` is out of range"),
        "{zeros}"
    );
    let equal = error("p.csv", "1e60,1e-40\n1e60,1e-40\n");
    assert!(equal.contains("are both (1e60, 1e-40)"), "{equal}");
    let long = error("p.svg", format!("<{}/>", "a".repeat(1 << 20)));
    assert!(long.len() < 20_000, "{}", long.len());
    let folder = Folder::new();
    assert_eq!(
        folder.run_args(&["reconstruct", "two\nlines.csv"]).error(),
        "error: two\\nlines.csv: No such file or directory (os error 2)"
    );
}

/// Each for a reader of XML that takes time quadratic in their number.
#[test]
fn crowded_documents_are_refused() {
    let attributes: String = (0..40_000).map(|i| format!(" a{i}=''")).collect();
    assert_eq!(
        error("p.svg", format!("<svg>\n<circle r='1'{attributes}/></svg>")),
        "p.svg: an element in line 2 has more than 1000 attributes: simplify it"
    );
    let entities: String = (0..10_000).map(|i| format!("<!ENTITY e{i} '1'>")).collect();
    assert_eq!(
        error("p.svg", format!("<!DOCTYPE svg [{entities}]><svg/>")),
        "p.svg: it declares more than 1000 entities: write out what they stand for"
    );
}

/// Also in any number: the line of each is found without counting from the start.
#[test]
fn elements_far_down_have_lines() {
    let count = 50_000;
    let point = |i| format!("<wpt lon='{i}' lat='1'/>\n");
    let many: String = (0..count).map(point).collect();
    let bad = format!("<gpx>\n{many}<wpt lon='x' lat='1'/></gpx>");
    let line = count + 2;
    assert_eq!(
        error("p.gpx", bad),
        format!("p.gpx, line {line}: `x` is not a number")
    );
    let point = |i| format!("<Point><coordinates>{i},1</coordinates></Point>\n");
    let many: String = (0..count).map(point).collect();
    let bad = format!("<kml>\n{many}<Point><coordinates>1</coordinates></Point></kml>");
    assert_eq!(
        error("p.kml", bad),
        format!("p.kml, line {line}: a point is x and y, but here is only `1`")
    );
}

/// Each refers to the next: no function calls itself for each.
#[test]
fn entities_in_entities_do_not_fill_the_stack() {
    let link = |i| format!("<!ENTITY e{i} '&e{};'>", i + 1);
    let entities: String = (0..100_000).map(link).collect();
    for name in ["svg", "gpx", "kml"] {
        let document = format!("<!DOCTYPE {name} [{entities}]><{name}>&e0;</{name}>");
        assert_eq!(
            error(&format!("p.{name}"), document),
            format!(
                "p.{name}: its entities stand for more than 16777216 bytes: write out what they \
                 stand for"
            )
        );
    }
}

#[test]
fn entities_do_not_fill_the_memory() {
    let long = "0 ".repeat(500_000);
    let uses = "&e;".repeat(200_000);
    let svg =
        format!("<!DOCTYPE svg [<!ENTITY e '{long}'>]><svg><polyline points='{uses}'/></svg>");
    assert_eq!(
        error("p.svg", svg),
        "p.svg: its entities stand for more than 16777216 bytes: write out what they stand for"
    );
}

/// Found by fuzzing: a message quotes the file, which may hold what steers a terminal.
#[test]
fn what_steers_a_terminal_is_not_printed() {
    let message = error("p.svg", "<svg\u{1b}[2J/>");
    assert!(message.contains("\\u{1b}"), "{message}");
    assert!(!message.chars().any(char::is_control), "{message}");
}
