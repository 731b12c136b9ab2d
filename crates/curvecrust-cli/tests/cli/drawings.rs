//! Drawings as people have them: strokes that touch, corners, elements to choose from.

use crate::harness::{Folder, json};
use serde_json::Value;

fn path(d: &str) -> String {
    format!(r#"<svg xmlns="http://www.w3.org/2000/svg"><path d="{d}"/></svg>"#)
}

fn count(list: &Value) -> usize {
    list.as_array().unwrap().len()
}

#[test]
fn corners_are_sampled_at_every_count() {
    let folder = Folder::with(
        "square.svg",
        path("M0 0H4V4H0Z M6 0A1 1 0 1 0 8 0A1 1 0 1 0 6 0Z"),
    );
    let run = |count: &str| {
        let line = format!("sample square.svg --rho 0.5 --json --count {count}");
        json(&folder.run(&line).fine())
    };
    let [fewest, greedy, verified] = ["fewest", "greedy", "verified"].map(run);
    for (found, decoder) in [
        (&fewest, "least-detour"),
        (&greedy, "least-detour"),
        (&verified, "hnn-crust"),
    ] {
        assert_eq!(found["guaranteed"], "running");
        assert_eq!(found["decoder"], decoder);
        assert_eq!(count(&found["components"]), 2);
        let samples = found["samples"].as_array().unwrap();
        for corner in [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]] {
            assert!(samples.contains(&serde_json::json!(corner)), "{found}");
        }
    }
    let [fewest, greedy, verified] =
        [fewest, greedy, verified].map(|found| count(&found["samples"]));
    assert!(
        verified < fewest && fewest <= greedy,
        "{verified}, {fewest}, {greedy}"
    );
    // The samples of the verified one come back.
    folder
        .run("sample square.svg --rho 0.5 --count verified -o samples.csv")
        .fine();
    folder
        .run("evaluate square.svg samples.csv --algorithm hnn-crust")
        .fine();
}

#[test]
fn sharp_corners_are_beyond_hnn_crust() {
    let folder = Folder::with("thorn.svg", path("M0 0H4L0 1Z"));
    let error = folder
        .run("sample thorn.svg --rho 0.5 --count verified")
        .error();
    assert!(error.contains("hnn-crust does not return"), "{error}");
    let line = "sample thorn.svg --rho 0.5 --count verified --decoder least-detour --json";
    let found = json(&folder.run(line).fine());
    assert_eq!(found["guaranteed"], "running");
}

#[test]
fn strokes_that_touch_are_cut() {
    let folder = Folder::with("plus.svg", path("M0 1H2M1 0V2"));
    let run = folder.run("sample plus.svg --rho 0.9 --json");
    let says = "plus.svg: strokes touch or cross in 1 place, at (1, 1) on <path> in line 1: one runs through, \
                others";
    assert!(run.stderr.contains(says), "{}", run.stderr);
    let found = json(&run.fine());
    assert_eq!(found["strokes"], "cut");
    assert_eq!(found["guaranteed"], "running");
    assert_eq!(count(&found["components"]), 3);
    // The place is a sample of the stroke that runs through.
    assert_eq!(found["places"], serde_json::json!([[1.0, 1.0]]));
    let samples = found["samples"].as_array().unwrap();
    assert!(samples.contains(&serde_json::json!([1.0, 1.0])));
    // The samples come back, and keep the condition on what was sampled.
    folder
        .run("sample plus.svg --rho 0.9 -o samples.csv")
        .fine();
    folder.run("check plus.svg samples.csv --rho 0.9").fine();
    folder.run("evaluate plus.svg samples.csv").fine();
    folder.run("lfs plus.svg").fine();
    folder.run("medial-axis plus.svg").fine();
}

#[test]
fn what_touches_itself_is_cut_too() {
    for (d, strands) in [
        // A loop, a figure eight, an end on a corner, a stroke drawn twice.
        ("M0 0C4 4 -2 4 2 0", 2),
        ("M0 0C3 3 3 -3 0 0C-3 3 -3 -3 0 0Z", 1),
        ("M0 4H4V0M4 4L8 8", 2),
        ("M0 0H4M0 0H4M0 2H4", 2),
    ] {
        let folder = Folder::with("a.svg", path(d));
        let found = json(&folder.run("sample a.svg --rho 0.9 --json").fine());
        assert_eq!(found["strokes"], "cut", "{d}");
        assert_eq!(count(&found["components"]), strands, "{d}");
    }
}

/// Found in icons: an outline that goes on for a bit past its start, and back.
#[test]
fn spikes_are_left_out_on_request() {
    let folder = Folder::with("a.svg", path("M0 4V0H10V10H0V3.98Z"));
    let error = folder.run("sample a.svg --rho 0.9").error();
    let says = "a larger --snap leaves out spikes of drawing programs";
    assert!(error.ends_with(says), "{error}");
    let run = folder.run("sample a.svg --rho 0.9 --snap 0.3% --json");
    assert!(
        run.stderr.contains("joined, first at (0, 4)"),
        "{}",
        run.stderr
    );
    assert_eq!(json(&run.fine())["guaranteed"], "running");
}

#[test]
fn strokes_are_apart_or_together_on_request() {
    let folder = Folder::with("plus.svg", path("M0 1H2M1 0V2"));
    let apart = folder.run("sample plus.svg --rho 0.9 --json --strokes apart");
    let found = json(&apart.fine());
    assert_eq!(found["strokes"], "apart");
    assert_eq!(found["count"], 4);
    let error = folder
        .run("sample plus.svg --rho 0.9 --strokes together")
        .error();
    assert!(
        error.contains("cross") || error.contains("touches"),
        "{error}"
    );
    // Strokes that do not touch are sampled together.
    folder.write("two.svg", path("M0 1H2M0 2H2"));
    let found = json(&folder.run("sample two.svg --rho 0.9 --json").fine());
    assert_eq!(found["strokes"], "together");
    assert_eq!(found["places"], serde_json::json!([]));
}

#[test]
fn samples_are_added_for_a_decoder() {
    let folder = Folder::with("two.svg", path("M0 0H10M0 1H10"));
    let run = folder.run("sample two.svg --rho 0.5 --json");
    assert!(run.stderr.contains("8 more than the condition asks for"));
    let found = json(&run.fine());
    assert_eq!(found["decoder"], "least-detour");
    assert_eq!(
        (&found["guaranteed"], &found["added"]),
        (&"running".into(), &8.into())
    );
    let other = json(
        &folder
            .run("sample two.svg --rho 0.5 --json --decoder hnn-crust")
            .fine(),
    );
    assert_eq!(other["decoder"], "hnn-crust");
    // Of a theorem nothing is run, unless an algorithm is asked for.
    folder.write(
        "circle.svg",
        r#"<svg xmlns="http://www.w3.org/2000/svg"><circle r="1"/></svg>"#,
    );
    let found = json(&folder.run("sample circle.svg --rho 0.5 --json").fine());
    assert_eq!(
        (&found["guaranteed"], &found["decoder"]),
        (&"theorem".into(), &"hnn-crust".into())
    );
    let run = folder.run("sample circle.svg --rho 0.5 --json --decoder crust");
    assert_eq!(json(&run.fine())["guaranteed"], "running");
}

#[test]
fn corners_are_samples_in_a_check() {
    let folder = Folder::with("box.svg", path("M0 0H10V4H0Z"));
    let samples = folder.run("sample box.svg --rho 0.9 --quiet").fine();
    folder.write("all.csv", &samples);
    folder.run("check box.svg all.csv --rho 0.9").fine();
    let found = json(&folder.run("check box.svg all.csv --json").fine());
    assert!(found["effective_rho"]["upper"].as_f64().unwrap() < 0.9);
    let without: Vec<&str> = samples.lines().filter(|&row| row != "0,10,4").collect();
    folder.write("without.csv", without.join("\n"));
    let run = folder.run("check box.svg without.csv --rho 0.9");
    assert_eq!(run.status, Some(1));
    let says = "no sample is at 1 of the corners, first (10, 4)";
    assert!(run.stderr.contains(says), "{}", run.stderr);
}

#[test]
fn what_draws_nothing_is_told_and_elements_are_chosen() {
    let svg = r#"<svg xmlns="http://www.w3.org/2000/svg">
<rect id="background" width="40" height="40"/>
<circle class="ring" cx="9" cy="9" r="4"/>
<path id="dot" d="M 1 1 Z"/>
<path id="page" d="M 0 0 H 24 V 24 H 0 Z" stroke="none" fill="none"/></svg>"#;
    let folder = Folder::with("a.svg", svg);
    let run = folder.run("sample a.svg --rho 0.5 --exclude background --json");
    let says = "a.svg: a subpath of a single point, which draws nothing and is left out: \
                <path id=\"dot\"> in line 4";
    assert!(run.stderr.contains(says), "{}", run.stderr);
    let says = "a.svg: an element with neither fill nor stroke, which draws nothing and is left \
                out: <path id=\"page\"> in line 5";
    assert!(run.stderr.contains(says), "{}", run.stderr);
    let found = json(&run.fine());
    assert_eq!(
        (&found["guaranteed"], count(&found["components"])),
        (&"theorem".into(), 1)
    );
    let ring = folder.run("lfs a.svg --select ring --json --quiet").fine();
    assert_eq!(count(&json(&ring)["components"]), 1);
    assert_eq!(
        folder.run("lfs a.svg --select rings").error(),
        "error: a.svg: no element has the id, the class or the label \"rings\": give one that is \
         there"
    );
}

#[test]
fn a_picture_of_reasons_has_a_legend_and_a_dark_page() {
    let folder = Folder::with("a.svg", path("M0 0H10M0 1H10"));
    folder.run("sample a.svg --rho 0.2 -o a.csv").fine();
    let draw = "draw --curve a.svg --medial-axis --points a.csv --edges --why";
    let picture = folder.run(draw).fine();
    let document = roxmltree::Document::parse(&picture).unwrap();
    let by_id = |id: &str| {
        document
            .descendants()
            .find(|n| n.attribute("id") == Some(id))
    };
    let legend = by_id("reasons").unwrap();
    let named: Vec<&str> = legend
        .descendants()
        .filter_map(|n| n.text())
        .map(str::trim)
        .collect();
    let axis = by_id("medial-axis").unwrap().attribute("stroke");
    for reason in [
        "certified",
        "completed",
        "exchanged",
        "required",
        "rejected",
    ] {
        let drawn = by_id(reason);
        assert_eq!(named.contains(&reason), drawn.is_some(), "{reason}");
        assert!(
            drawn.is_none_or(|n| n.attribute("stroke") != axis),
            "{reason}"
        );
    }
    assert!(named.contains(&"certified"));
    assert!(picture.contains("prefers-color-scheme: dark"));
    // A picture is a drawing, too: with its page left out, the curve is there again.
    folder.write("picture.svg", picture);
    let again = folder
        .run("lfs picture.svg --select curve --json --quiet")
        .fine();
    assert_eq!(count(&json(&again)["components"]), 2);
}
