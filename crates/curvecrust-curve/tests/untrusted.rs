//! Documents that nobody vouches for: none of them fills the memory, takes long or reads a file.
//! Levels, elements and segments have their tests in `bad_input.rs`.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

use curvecrust_curve::svg::{MAX_EXPANSION, expansion};
use curvecrust_curve::{Curve, CurveError};

fn document(entities: &str, content: &str) -> String {
    format!(
        "<!DOCTYPE svg [{entities}]><svg xmlns='http://www.w3.org/2000/svg' \
         xmlns:xlink='http://www.w3.org/1999/xlink' viewBox='0 0 9 9'>{content}</svg>"
    )
}

#[test]
fn a_long_entity_used_often_is_refused() {
    // 100 GB, from a megabyte.
    let long = "H1 ".repeat(200_000);
    let d = format!("M0 0{}", "&e;".repeat(170_000));
    let svg = document(
        &format!("<!ENTITY e '{long}'>"),
        &format!("<path d='{d}'/>"),
    );
    assert!(expansion(&svg) > 100_000_000_000);
    let error = Curve::from_svg(&svg).unwrap_err();
    assert!(matches!(&error, CurveError::Unsupported { .. }));
    assert!(error.to_string().contains("16777216 bytes"), "{error}");
}

#[test]
fn entities_of_entities_are_refused() {
    let mut entities = "<!ENTITY l0 'lollollollollollol'>".to_owned();
    for k in 0..60 {
        let ten = format!("&l{k};").repeat(10);
        entities += &format!("<!ENTITY l{} \"{ten}\">", k + 1);
    }
    let svg = document(&entities, "<title>&l60;</title>");
    assert_eq!(expansion(&svg), usize::MAX);
    assert!(Curve::from_svg(&svg).is_err());
    // Loops too, by the reader of XML.
    let looped = document("<!ENTITY a '&b;'><!ENTITY b '&a;'>", "<title>&a;</title>");
    assert!(expansion(&looped) < MAX_EXPANSION);
    assert!(matches!(
        Curve::from_svg(&looped),
        Err(CurveError::Xml { .. })
    ));
}

/// Each refers to the next: no function calls itself for each.
#[test]
fn a_long_chain_of_entities_is_refused() {
    let link = |i| format!("<!ENTITY e{i} '&e{};'>", i + 1);
    let entities: String = (0..100_000).map(link).collect();
    let svg = document(&entities, "<title>&e0;</title>");
    assert_eq!(expansion(&svg), usize::MAX);
    assert!(Curve::from_svg(&svg).is_err());
}

/// Each is some 400 KB that the readers of XML and of style would take seconds for, or minutes.
#[test]
fn crowded_documents_are_refused() {
    let many =
        |count: usize, item: &dyn Fn(usize) -> String| (0..count).map(item).collect::<String>();
    let path = "<path d='M0 0h1'/>";
    let attributes = many(40_000, &|i| format!(" a{i}=''"));
    let nested = many(10_000, &|i| format!("<g xmlns:a{i}='u'>")) + &"</g>".repeat(10_000);
    let declarations = many(40_000, &|i| format!("a{i}:1;"));
    let rules = "path{fill:red}".repeat(10_000);
    let classes = many(10_000, &|i| format!(".a{i}{{fill:red}}"));
    let classed = format!("<g class='{}'>{path}</g>", "b ".repeat(100)).repeat(1_000);
    for (entities, content, says) in [
        (
            "",
            format!("<path d='M0 0h1'{attributes}/>"),
            "more than 1000 attributes",
        ),
        ("", nested, "more than 100 prefixes"),
        (
            "",
            format!("<path d='M0 0h1' style='{declarations}'/>"),
            "more than 1000 declarations",
        ),
        (
            "",
            format!("<style>path{{{declarations}}}</style>{path}"),
            "more than 1000 declarations",
        ),
        (
            "",
            format!("<style>{rules}</style>{}", path.repeat(10_000)),
            "selectors and declarations",
        ),
        (
            "",
            format!("<style>{classes}</style>{classed}"),
            "selectors and declarations",
        ),
        (
            &*many(20_000, &|i| format!("<!ENTITY e{i} '1'>")),
            path.to_owned(),
            "more than 1000 entities",
        ),
        (
            // In the value of an entity.
            &*format!("<!ENTITY e \"<g {attributes}/>\">"),
            format!("&e;{path}"),
            "more than 1000 attributes",
        ),
    ] {
        let error = Curve::from_svg(&document(entities, &content))
            .unwrap_err()
            .to_string();
        assert!(error.contains(says), "{error}");
    }
}

/// A kilobyte that stands for 10 million paths, drawn or not.
#[test]
fn elements_are_counted_before_they_are_laid_out() {
    let mut content = "<g id='a0'><path d='M0 0h1'/></g>".to_owned();
    for k in 0..7 {
        let ten = format!("<use href='#a{k}'/>").repeat(10);
        content += &format!("<g id='a{}'>{ten}</g>", k + 1);
    }
    let used = "<use xlink:href='#a7'/>";
    for content in [
        format!("<defs>{content}</defs>{used}"),
        format!("<path d='M0 0h1'/><pattern id='p'>{content}{used}</pattern>"),
    ] {
        let error = Curve::from_svg(&document("", &content))
            .unwrap_err()
            .to_string();
        assert!(
            error.contains("more than 1000000 elements, each drawn once per use"),
            "{error}"
        );
    }
    // Each element as often as it is used.
    let twice = "<path id='a' d='M0 0h1'/><use href='#a'/>";
    assert_eq!(
        Curve::from_svg(&document("", twice))
            .unwrap()
            .components()
            .len(),
        2
    );
}

#[test]
fn what_is_below_the_limit_is_read() {
    let steps = "h1 ".repeat(1_000);
    let path = "<path d='M0 0 &e;'/><path d='M0 5 &e;'/>";
    let svg = document(&format!("<!ENTITY e '{steps}'>"), path);
    assert_eq!(expansion(&svg), 2 * steps.len());
    assert!((Curve::from_svg(&svg).unwrap().extent() - 1_000.0).abs() < 1e-9);
}

/// The files are there; what they hold is in no curve and in no message.
#[test]
fn nothing_outside_of_the_document_is_read() {
    let folder = concat!("file://", env!("CARGO_MANIFEST_DIR"));
    let drawing = "<path d='M0 0 h1'/>";
    let entity = format!("<!ENTITY e SYSTEM '{folder}/Cargo.toml'>");
    let read = Curve::from_svg(&document(&entity, &format!("{drawing}<title>&e;</title>")));
    assert!(matches!(read, Err(CurveError::Xml { .. })));
    assert!(Curve::from_svg(&document(&entity, drawing)).is_ok());
    for element in ["image", "use"] {
        for attribute in ["href", "xlink:href"] {
            let far = format!("{folder}/../../fixtures/curves/bunny.svg#bunny");
            let svg = document(
                "",
                &format!("{drawing}<{element} {attribute}='{far}' width='9' height='9'/>"),
            );
            match Curve::from_svg(&svg) {
                // Images are no curves.
                Ok(curve) => assert_eq!((element, curve.components().len()), ("image", 1)),
                Err(error) => assert!(
                    error.to_string().contains("no element of the document"),
                    "{error}"
                ),
            }
        }
    }
    let sheet = format!(
        "<style>@import url('{folder}/a.css'); path {{ fill: url('{folder}/b.svg#c') }}</style>"
    );
    assert_eq!(
        Curve::from_svg(&document("", &(sheet + drawing)))
            .unwrap()
            .components()
            .len(),
        1
    );
}
