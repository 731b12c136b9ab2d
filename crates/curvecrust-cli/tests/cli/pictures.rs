//! What pictures show, and where.

use crate::harness::{Folder, fixture, json};
use roxmltree::{Document, Node};

/// The attributes that are lengths or places.
const LENGTHS: [&str; 12] = [
    "viewBox",
    "d",
    "cx",
    "cy",
    "r",
    "x",
    "y",
    "width",
    "height",
    "stroke-width",
    "font-size",
    "dy",
];

/// All numbers of some text, whatever is between them.
fn numbers(text: &str) -> Vec<f64> {
    let fields = text.split(|c: char| c.is_whitespace() || c == ',');
    fields.filter_map(|field| field.parse().ok()).collect()
}

fn by_id<'a>(document: &'a Document<'_>, id: &str) -> Node<'a, 'a> {
    let found = document
        .descendants()
        .find(|n| n.attribute("id") == Some(id));
    found.unwrap_or_else(|| panic!("nothing is named {id}"))
}

/// The places along the paths in a group, path by path.
fn paths(group: Node<'_, '_>) -> Vec<Vec<[f64; 2]>> {
    let data = group.descendants().filter_map(|n| n.attribute("d"));
    let places = |d| numbers(d).as_chunks().0.to_vec();
    data.map(places).collect()
}

fn distance(p: [f64; 2], q: [f64; 2]) -> f64 {
    (p[0] - q[0]).hypot(p[1] - q[1])
}

/// A bent stroke over a straight one.
fn drawing(scale: f64) -> String {
    let [a, b, c, d, e] = [4.0, 8.0, 2.0, 12.0, 6.0].map(|n: f64| n * scale);
    let (y, x) = (3.0 * scale, 10.0 * scale);
    format!(
        r#"<svg xmlns="http://www.w3.org/2000/svg"><path d="M 0 0 C {a} 0 {b} {c} {d} {e} M 0 {y} H {x}"/></svg>"#
    )
}

/// A power of two loses no digit: every length is as many times as large, to the last one.
#[test]
fn pictures_of_larger_data_are_larger() {
    const SCALE: f64 = 1024.0;
    let folder = Folder::new();
    for (name, scale) in [("small", 1.0), ("large", SCALE)] {
        folder.write(&format!("{name}.svg"), drawing(scale));
        let rows = (0..40).map(|i| {
            let [x, y] = [f64::from(i) / 4.0, f64::from(i % 3) / 8.0].map(|n| n * scale);
            format!("{x} {y}\n")
        });
        folder.write(&format!("{name}.xy"), rows.collect::<String>());
    }
    for line in [
        "draw --curve IN.svg --lfs --medial-axis --points IN.xy --edges --why --violations",
        "draw --points IN.xy --edges hnn-crust",
        "draw --points IN.xy --fit",
        "puzzle IN.svg --solved",
    ] {
        let picture = |name| folder.run(&line.replace("IN", name)).fine();
        let [small, large] = ["small", "large"].map(picture);
        let [small, large] = [&small, &large].map(|text| Document::parse(text).unwrap());
        let lengths = |document: &Document<'_>| -> Vec<f64> {
            // The page itself has a size in pixels.
            let all = document.root_element().children();
            let all = all.flat_map(|node| node.descendants());
            let all = all.flat_map(|node| node.attributes());
            let lengths = all.filter(|a| LENGTHS.contains(&a.name()));
            lengths.flat_map(|a| numbers(a.value())).collect()
        };
        let (small, large) = (lengths(&small), lengths(&large));
        assert!(small.len() > 40, "{line}");
        assert_eq!(small.len(), large.len(), "{line}");
        for (small, large) in small.into_iter().zip(large) {
            // Flags of arcs and shares of gradients have no length.
            let is_a_flag = [0.0, 1.0].contains(&small) && small.to_bits() == large.to_bits();
            let difference = (small * SCALE - large).abs();
            assert!(
                is_a_flag || difference <= 1e-9 * large.abs(),
                "{line}: {small}, {large}"
            );
        }
    }
}

/// 800 pixels of data, 24 around them, and 48 below for each legend.
#[test]
fn each_legend_has_its_place_below() {
    let folder = Folder::with("a.svg", drawing(1.0));
    folder.write("a.xy", "0 0\n4 1\n8 2\n12 6\n");
    for (options, legends) in [
        ("--edges", 0.0),
        ("--edges --why", 1.0),
        ("--lfs", 1.0),
        ("--lfs --edges --why", 2.0),
    ] {
        let picture = folder.run(&format!("draw --curve a.svg --points a.xy {options}"));
        let picture = picture.fine();
        let document = Document::parse(&picture).unwrap();
        let found = numbers(document.root_element().attribute("viewBox").unwrap());
        // The data are 12 wide and 6 high.
        let pixel = 12.0 / 800.0;
        let expected = [
            -24.0 * pixel,
            -24.0 * pixel,
            12.0 + 48.0 * pixel,
            6.0 + (48.0 + 48.0 * legends) * pixel,
        ];
        let differences = found.iter().zip(expected).map(|(a, b)| (a - b).abs());
        assert!(
            differences.fold(0.0, f64::max) < 1e-12,
            "{options}: {found:?}"
        );
    }
}

/// Stretches of one colour follow each other without a gap, and no two in a row are alike.
#[test]
fn lfs_colours_the_whole_curve() {
    let folder = Folder::new();
    let curve = fixture("curves/bunny.svg").display().to_string();
    let picture = folder.run(&format!("draw --curve {curve} --lfs")).fine();
    let document = Document::parse(&picture).unwrap();
    let group = by_id(&document, "lfs");
    let stretches = paths(group);
    assert!(stretches.len() > 20, "{}", stretches.len());
    let colours: Vec<_> = group
        .children()
        .filter_map(|n| n.attribute("stroke"))
        .collect();
    assert_eq!(colours.len(), stretches.len());
    for (pair, colours) in stretches.windows(2).zip(colours.windows(2)) {
        let [last, first] = [pair[0].last(), pair[1].first()].map(Option::unwrap);
        assert!(distance(*last, *first) <= 0.0, "{last:?}, {first:?}");
        assert_ne!(colours[0], colours[1]);
    }
    let [first, last] = [&stretches[0][0], stretches.last().unwrap().last().unwrap()];
    assert!(distance(*first, *last) <= 0.0);
}

/// A dot of several colours is cut like a cake.
#[test]
fn sectors_of_a_dot_are_alike() {
    let folder = Folder::new();
    let curve = fixture("curves/bunny.svg").display().to_string();
    let picture = folder.run(&format!("puzzle {curve}")).fine();
    let document = Document::parse(&picture).unwrap();
    let sectors: Vec<Vec<f64>> = by_id(&document, "dots")
        .descendants()
        .filter_map(|n| n.attribute("d"))
        .map(numbers)
        .collect();
    assert!(!sectors.is_empty());
    // The centre, a place on the rim, the radius twice, three flags, another place on the rim.
    let mut at = 0;
    while at < sectors.len() {
        let centre = |sector: &Vec<f64>| [sector[0], sector[1]];
        let of_dot = sectors[at..].iter();
        let of_dot = of_dot.take_while(|s| distance(centre(s), centre(&sectors[at])) <= 0.0);
        let of_dot: Vec<_> = of_dot.collect();
        assert!(of_dot.len() > 1);
        let [middle, radius] = [centre(of_dot[0]), [of_dot[0][4], of_dot[0][5]]];
        let chord = 2.0 * radius[0] * (std::f64::consts::PI / of_dot.len() as f64).sin();
        for (i, sector) in of_dot.iter().enumerate() {
            let [from, to] = [[sector[2], sector[3]], [sector[9], sector[10]]];
            let next = of_dot[(i + 1) % of_dot.len()];
            let slack = 1e-9 * radius[0];
            assert!((distance(from, middle) - radius[0]).abs() < slack);
            assert!((distance(from, to) - chord).abs() < slack);
            assert!(distance(to, [next[2], next[3]]) < slack);
        }
        at += of_dot.len();
    }
}

/// The joints of a fitted curve lie in the middle of its band, two standard errors from each side.
#[test]
fn a_band_is_around_its_curve() {
    let folder = Folder::new();
    let noisy = (0..200).map(|i| {
        let noise = [0.03, -0.02, 0.01, -0.04, 0.025, -0.005, 0.015][i * i % 7];
        let x = i as f64;
        format!("{} {}\n", x / 20.0, 2.0 * (x / 30.0).sin() + noise)
    });
    folder.write("noisy.xy", noisy.collect::<String>());
    let found = json(&folder.run("fit noisy.xy --json -o fit.svg").fine());
    assert_eq!(found["curves"].as_array().unwrap().len(), 1);
    let errors = found["curves"][0]["standard_error"].as_array().unwrap();
    let picture = folder.read("fit.svg");
    let document = Document::parse(&picture).unwrap();
    let [band, curve] = ["band", "fitted"].map(|id| paths(by_id(&document, id)).concat());
    let joints = curve.len() / 3 + 1;
    // Along one side and back along the other.
    assert_eq!((band.len(), errors.len()), (2 * joints, joints));
    for (i, joint) in curve.iter().step_by(3).enumerate() {
        let [left, right] = [band[i], band[2 * joints - 1 - i]];
        let middle = [(left[0] + right[0]) / 2.0, (left[1] + right[1]) / 2.0];
        assert!(distance(middle, *joint) < 1e-9, "{middle:?}, {joint:?}");
        let width = 4.0 * errors[i].as_f64().unwrap();
        assert!((distance(left, right) - width).abs() < 1e-9, "{i}: {width}");
    }
}

/// Each is a regular polygon of ten pixels around its vertex, the first corner above it. What is
/// wrong shows in the number of corners.
#[test]
fn marks_are_regular_polygons() {
    let points = "0 0\n1 0\n2 0\n-0.5 0.87\n-1 1.73\n-0.5 -0.87\n-1 -1.73\n9 9\n";
    let folder = Folder::with("y.xy", points);
    let line = "draw --points y.xy --edges beta-skeleton --violations";
    let picture = folder.run(line).fine();
    let document = Document::parse(&picture).unwrap();
    let marks = paths(by_id(&document, "violations"));
    // Three ends, a point alone, and where three edges meet.
    let expected = [
        ([2.0, 0.0], 24),
        ([-1.0, 1.73], 24),
        ([-1.0, -1.73], 24),
        ([9.0, 9.0], 4),
        ([0.0, 0.0], 3),
    ];
    assert_eq!(marks.len(), expected.len());
    let radius = 10.0 * (9.0 + 1.73) / 800.0;
    for (mark, (vertex, corners)) in marks.iter().zip(expected) {
        assert_eq!(mark.len(), corners);
        let above = [vertex[0], vertex[1] - radius];
        assert!(distance(mark[0], above) < 1e-12);
        let side = 2.0 * radius * (std::f64::consts::PI / corners as f64).sin();
        for (i, &corner) in mark.iter().enumerate() {
            let next = mark[(i + 1) % corners];
            assert!((distance(corner, vertex) - radius).abs() < 1e-12);
            assert!((distance(corner, next) - side).abs() < 1e-12);
        }
    }
}

/// The logarithm of lfs is on a scale from the least to the largest, whose colours the legend has.
#[test]
fn lfs_has_the_colours_of_the_legend() {
    let folder = Folder::new();
    let curve = fixture("curves/bunny.svg").display().to_string();
    let table = folder.run(&format!("lfs {curve}")).fine();
    let rows = table
        .lines()
        .skip(1)
        .map(|row| numbers(&row.replace(',', " ")));
    let values: Vec<([f64; 2], f64)> = rows.map(|row| ([row[1], row[2]], row[3])).collect();
    let finite = || values.iter().map(|v| v.1).filter(|lfs| lfs.is_finite());
    let low = finite().fold(f64::INFINITY, f64::min);
    let high = finite().fold(0.0, f64::max);
    let picture = folder.run(&format!("draw --curve {curve} --lfs")).fine();
    let document = Document::parse(&picture).unwrap();
    let channels = |colour: &str| {
        let inside = colour
            .strip_prefix("rgb(")
            .and_then(|c| c.strip_suffix(')'));
        <[f64; 3]>::try_from(numbers(&inside.unwrap().replace(',', " "))).unwrap()
    };
    let stops = document.descendants().filter(|n| n.has_tag_name("stop"));
    let stops: Vec<_> = stops
        .map(|n| channels(n.attribute("stop-color").unwrap()))
        .collect();
    for stretch in by_id(&document, "lfs").children().filter(Node::is_element) {
        let from = numbers(stretch.attribute("d").unwrap());
        let here = values
            .iter()
            .find(|v| distance(v.0, [from[0], from[1]]) <= 0.0);
        let share = (here.unwrap().1 / low).ln() / (high / low).ln();
        let at = share * (stops.len() - 1) as f64;
        let mut before = (0..stops.len() - 1).rev();
        let below = before.find(|&stop| stop as f64 <= at).unwrap();
        let found = channels(stretch.attribute("stroke").unwrap());
        for channel in 0..3 {
            let [a, b] = [stops[below][channel], stops[below + 1][channel]];
            // There are eight shades from each stop to the next.
            let slack = (b - a).abs() / 16.0 + 1.0;
            let expected = a + (b - a) * (at - below as f64);
            assert!(
                (found[channel] - expected).abs() <= slack,
                "{share}: {found:?}"
            );
        }
    }
}

#[test]
fn legends_are_below_the_data() {
    let folder = Folder::with("a.svg", drawing(1.0));
    folder.write(
        "a.xy",
        "0 0\n1 0\n2 0\n-0.5 0.87\n-1 1.73\n-0.5 -0.87\n-1 -1.73\n9 6\n",
    );
    let line = "draw --curve a.svg --points a.xy --lfs --edges --why";
    let picture = folder.run(line).fine();
    let document = Document::parse(&picture).unwrap();
    let frame = numbers(document.root_element().attribute("viewBox").unwrap());
    let [left, right, bottom] = [frame[0], frame[0] + frame[2], frame[1] + frame[3]];
    for (id, least) in [("legend", 3), ("reasons", 4)] {
        let group = by_id(&document, id);
        let mut places = paths(group).concat();
        for node in group.children().filter(|n| n.has_attribute("x")) {
            let [x, y, width, height] = ["x", "y", "width", "height"].map(|name| {
                node.attribute(name)
                    .map_or(0.0, |n| n.parse::<f64>().unwrap())
            });
            places.extend([[x, y], [x + width, y + height]]);
        }
        assert!(places.len() >= 2 * least, "{id}");
        for [x, y] in places {
            assert!(left < x && x < right, "{id}: {x}");
            assert!(6.0 < y && y < bottom, "{id}: {y}");
        }
    }
}
