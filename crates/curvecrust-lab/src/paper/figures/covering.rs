//! Draws Figure 8; its geometry is in [`rolling`](super::rolling).

use super::rolling::{CONFIGURATIONS, Configuration, Geometry, Surface, UNCOVERED};
use crate::figure::{Ball, Figure, Label, Layer, Panel, Polyline};
use crate::paper::page::Exhibit;
use curvecrust::DVec2;
use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_4, TAU};

/// How many positions of a ball are drawn for a turn of its centre around a free disk.
pub(super) const BALLS: u32 = 72;
/// Points of a drawn turn.
const FINE: u32 = 180;

/// The eight configurations, and a ninth that is not covered.
pub(super) fn figure_8() -> Exhibit {
    let text = "Why s2 is the half neighbour of s1 for ρ = 0.9. Balls that touch the curve, or \
        the x axis as a bound of it, hold no sample; they cover what O(s1, |s1 s2|) and the \
        half-plane H beyond the bisector of s0 and s1 have in common on the side of s0. So no \
        sample there can be nearer than s2. The ratio is that of |x s1| to |s1 y|, α and β are \
        the angles of x and y below the tangent at s1: at most 26.7° for y, and less for an x \
        nearer than y. In the fourth case the balls reach the corner barely. The ninth is not in \
        the paper: at this ratio they do not reach it, and a sample z there makes Theorem 2 \
        false for ρ > 0.8950; see docs/theorem-2.md.";
    Exhibit {
        number: 8,
        heading: "rolling balls around s1".to_owned(),
        text: text.to_owned(),
        figure: Figure {
            title: "Tangent balls that cover the disk around s1 in the half-plane H, in eight \
                   configurations, and fail to in a ninth"
                .to_owned(),
            columns: 3,
            panels: CONFIGURATIONS
                .iter()
                .map(panel)
                .chain([uncovered()])
                .collect(),
        },
    }
}

fn panel(configuration: &Configuration) -> Panel {
    let geometry = configuration.geometry();
    let [alpha, beta] = geometry.angles.map(f64::to_degrees);
    let surface = match configuration.surface {
        Surface::Disk => "the disk of lfs(y)",
        Surface::Axis => "the x axis",
    };
    let labels = labels(&geometry).into_iter();
    // Names that would stand on each other are left out, s0 and x for the smallest ratio.
    let apart = |label: &Label| geometry.s0.length() > 0.1 || !["s0", "x"].contains(&&*label.name);
    let balls = geometry.rolling(BALLS).into_iter();
    let layers = vec![
        Layer::Balls(
            balls
                .map(|ball| Ball {
                    centre: page(ball.centre),
                    ..ball
                })
                .collect(),
        ),
        Layer::Region(turned(geometry.region(FINE))),
        Layer::Construction(construction(&geometry, configuration.surface)),
        Layer::Curve(vec![(turned(curve(&geometry)), false)]),
        Layer::Marks([geometry.x, geometry.y].map(page).to_vec()),
        Layer::Points([geometry.s0, DVec2::ZERO, geometry.s2].map(page).to_vec()),
        Layer::Labels(labels.filter(apart).collect()),
    ];
    Panel {
        caption: format!(
            "ratio {}, α {alpha:.1}°, β {beta:.1}°,\nrolling on {surface}",
            written(configuration.ratio)
        ),
        frame: Some([DVec2::new(-2.65, -2.05), DVec2::new(2.2, 2.0)]),
        layers,
    }
}

/// The ninth, with a point that the balls do not reach.
fn uncovered() -> Panel {
    let mut panel = panel(&UNCOVERED);
    let corner = page(UNCOVERED.geometry().corner());
    let label = Label {
        at: corner,
        towards: DVec2::new(-1.0, -1.0),
        name: "z".to_owned(),
    };
    panel.layers.push(Layer::Points(vec![corner]));
    panel.layers.push(Layer::Labels(vec![label]));
    panel.caption = panel
        .caption
        .replace("rolling on the disk of lfs(y)", "z is not covered");
    panel
}

/// A ratio as the paper has it.
fn written(ratio: f64) -> String {
    let named = [(1.0 / 3.0, "1/3"), (FRAC_1_SQRT_2, "1/√2")];
    let known = named
        .iter()
        .find(|(value, _)| (ratio - value).abs() < 1e-12);
    known.map_or_else(|| ratio.to_string(), |(_, name)| (*name).to_owned())
}

/// Names on the free side of the curve: below it left of s1, where balls are above, and outside on
/// the right. That of x is beside the bisector, which runs below x.
fn labels(geometry: &Geometry) -> [Label; 5] {
    let [alpha, beta] = geometry.angles;
    let label = |name: &str, at: DVec2, towards: DVec2| Label {
        at: page(at),
        towards: page(towards),
        name: name.to_owned(),
    };
    // Where the curve has turned by so much.
    let below = |turn: f64| DVec2::from_angle(turn).rotate(DVec2::NEG_Y);
    let (y_side, s2_side) = if beta > 0.0 {
        (-below(-2.0 * beta), -below(-4.0 * beta))
    } else {
        (DVec2::NEG_Y, DVec2::new(1.0, -1.0))
    };
    [
        label("s0", geometry.s0, below(4.0 * alpha)),
        label("x", geometry.x, below(2.0 * alpha + 0.6)),
        label("s1", DVec2::ZERO, below(FRAC_PI_4)),
        label("y", geometry.y, y_side),
        label("s2", geometry.s2, s2_side),
    ]
}

/// Upwards in the geometry is downwards on the page.
fn page(p: DVec2) -> DVec2 {
    DVec2::new(p.x, -p.y)
}

fn turned(points: Vec<DVec2>) -> Vec<DVec2> {
    points.into_iter().map(page).collect()
}

/// From s0 to s2, of constant curvature on both sides of s1.
fn curve(geometry: &Geometry) -> Vec<DVec2> {
    let [alpha, beta] = geometry.angles;
    let side = |angle: f64, end: DVec2| {
        let (turn, length) = (4.0 * angle, end.length());
        (1..=FINE).map(move |i| {
            let part = f64::from(i) / f64::from(FINE);
            if angle > 0.0 {
                let radius = length / (2.0 * (2.0 * angle).sin());
                let (sin, cos) = (part * turn).sin_cos();
                radius * DVec2::new(sin * end.x.signum(), cos - 1.0)
            } else {
                part * end
            }
        })
    };
    let mut points: Vec<DVec2> = side(alpha, geometry.s0).collect();
    points.reverse();
    points.push(DVec2::ZERO);
    points.extend(side(beta, geometry.s2));
    points
}

/// The disk around s1, the bisector of s0 and s1, and what the balls roll on.
fn construction(geometry: &Geometry, surface: Surface) -> Vec<Polyline> {
    let circle = |centre: DVec2, radius: f64| {
        let turn = (0..FINE).map(|i| TAU * f64::from(i) / f64::from(FINE));
        let points = turn.map(|angle| centre + radius * DVec2::from_angle(angle));
        (turned(points.collect()), true)
    };
    let middle = geometry.s0 / 2.0;
    let along = geometry.s0.normalize().perp();
    let reach = (geometry.radius().powi(2) - middle.length_squared()).sqrt();
    let bisector = [-1.08, 1.0].map(|sign| middle + sign * reach * along);
    let surface = match surface {
        Surface::Disk => circle(DVec2::new(0.0, -geometry.bend), geometry.bend),
        Surface::Axis => (
            [DVec2::new(-2.6, 0.0), DVec2::new(1.95, 0.0)].to_vec(),
            false,
        ),
    };
    vec![
        circle(DVec2::ZERO, geometry.radius()),
        (turned(bisector.to_vec()), false),
        surface,
    ]
}
