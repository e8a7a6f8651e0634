//! The text of pictures.

use super::*;

fn panel(points: Vec<(f64, f64)>) -> Panel {
    Panel {
        title: "A & B".into(),
        x: Axis::new("time, µs", 0.0, 30.0, 10.0),
        y: Axis::new("strain, %", 0.0, 2.0, 0.5),
        series: vec![Series::new("run", Colour::Blue, Style::Dashed(2.0), points)],
        width: 400.0,
    }
}

/// The path of the series in a picture of one panel; the legend's comes after it.
fn line(panel: Panel) -> String {
    let svg = svg(&[panel]);
    let path = svg.lines().find(|line| line.contains("stroke-dasharray")).unwrap();
    path.split('"').nth(1).unwrap().to_owned()
}

#[test]
fn what_was_drawn_before_does_not_show() {
    let panels = || [panel(vec![(1.7, 0.3), (28.3, 1.45)]), panel(vec![(2.9, 0.1), (3.1, 0.7)])];
    let first = svg(&panels());
    assert!(first.contains("clip-0") && first.contains("clip-1"), "{first}");
    assert!(!first.contains("kuva-clip") && !first.contains("clip-2"), "{first}");
    assert_eq!(first, svg(&panels()));
}

#[test]
fn a_coordinate_that_is_no_number_breaks_the_line() {
    let strokes = |points| line(panel(points)).matches('M').count();
    let around = |y| vec![(1.0, 0.3), (2.0, 0.4), (3.0, y), (4.0, 0.6), (5.0, 0.7)];
    assert_eq!(strokes(around(0.5)), 1);
    assert_eq!(strokes(around(-7.5e300)), 1);
    assert_eq!(strokes(around(f64::NAN)), 2);
    assert_eq!(strokes(around(f64::INFINITY)), 2);
}

#[test]
fn what_is_not_positive_breaks_a_line_on_a_logarithmic_axis() {
    let strokes = |y| {
        let points = vec![(1.0, 0.3), (2.0, 0.04), (3.0, y), (4.0, 0.006), (5.0, 0.7)];
        let y = Axis::logarithmic("error", 1e-3, 1.0);
        line(Panel { y, ..panel(points) }).matches('M').count()
    };
    assert_eq!((strokes(0.5), strokes(0.0), strokes(-0.5)), (1, 2, 2));
}

/// A number that an element has by a name.
fn attribute(of: &str, name: &str) -> f64 {
    let text = of.split(&format!(" {name}=\"")).nth(1).unwrap();
    text.split('"').next().unwrap().parse().unwrap()
}

/// Left end, upper end, width and height of what the axes enclose.
fn enclosed(svg: &str) -> [f64; 4] {
    let clip = svg.lines().find(|line| line.contains("<clipPath")).unwrap();
    ["x", "y", "width", "height"].map(|name| attribute(clip, name))
}

/// The numbers of a path.
fn numbers(path: &str) -> Vec<f64> {
    let d = path.split('"').nth(1).unwrap();
    let each = d.split(|c: char| c.is_ascii_alphabetic() || c == ' ');
    each.filter(|n| !n.is_empty()).map(|n| n.parse().unwrap()).collect()
}

/// What is drawn of a series in amber, and its sample in the legend.
fn drawn_and_sample(svg: &str) -> [Vec<f64>; 2] {
    let in_amber = |line: &&str| line.contains("<path") && line.contains("fill=\"#e69f00\"");
    let paths: Vec<&str> = svg.lines().filter(in_amber).collect();
    assert_eq!(paths.len(), 2);
    [numbers(paths[0]), numbers(paths[1])]
}

fn assert_near(found: &[f64], expected: &[f64]) {
    assert_eq!(found.len(), expected.len(), "{found:?} {expected:?}");
    // Largest deviation, 0.021 pixels: the hundredths of both, and of ends that differences are of.
    let apart = found.iter().zip(expected).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!(apart < 0.021, "{found:?} {expected:?}");
}

/// A cell from 6 to 12 of 30 to the right and from 0.5 to 1.25 of 2 upward.
#[test]
fn a_cell_lies_around_its_point() {
    let style = Style::Cells { width: 6.0, height: 0.75 };
    let series = vec![Series::new("stable", Colour::Amber, style, vec![(9.0, 0.875)])];
    let svg = svg(&[Panel { series, ..panel(vec![]) }]);
    let [left, top, width, height] = enclosed(&svg);
    let [cell, sample] = drawn_and_sample(&svg);
    let start = left + 0.2 * width;
    assert_near(
        &cell,
        &[start, top + 0.375 * height, left + 0.4 * width, top + 0.75 * height, start],
    );
    // The sample is 34 wide, and of 0.7 of a line of 22 in height, below the axes.
    assert_near(&[sample[2] - sample[0], sample[3] - sample[1]], &[34.0, 15.4]);
    assert!(sample[1] > top + height && sample[0] > 0.0 && sample[4] == sample[0], "{sample:?}");
}

/// A triangle whose corners are shares of the axes known by hand.
#[test]
fn an_area_is_what_its_points_go_round() {
    let points = vec![(3.0, 0.5), (15.0, 0.5), (24.0, 1.5)];
    let series = vec![Series::new("between", Colour::Amber, Style::Area, points)];
    let svg = svg(&[Panel { series, ..panel(vec![]) }]);
    let [left, top, width, height] = enclosed(&svg);
    let [area, sample] = drawn_and_sample(&svg);
    let at = |right: f64, up: f64| [left + right * width, top + (1.0 - up) * height];
    assert_near(&area, &[at(0.1, 0.25), at(0.5, 0.25), at(0.8, 0.75)].concat());
    // The sample is 34 wide, and 0.6 of 0.7 of a line of 22 in height.
    let [x, y] = [sample[0], sample[1]];
    assert_near(&sample, &[x, y, x + 34.0, y, x + 34.0, y + 9.24, x, y + 9.24]);
    assert!(y > top + height, "{sample:?}");
}

/// The ends of a line in the corners of the axes are on the ends of the drawn axes.
#[test]
fn the_ends_of_the_axes_are_where_kuva_draws_them() {
    let x = Axis::logarithmic("work", 2e3, 7e6);
    let drawn = svg(&[Panel { x, ..panel(vec![(2e3, 0.0), (7e6, 2.0)]) }]);
    let [left, top, width, height] = enclosed(&drawn);
    let d = numbers(drawn.lines().find(|line| line.contains("stroke-dasharray")).unwrap());
    // Largest deviation, 0.011 pixels: the hundredths of both.
    let apart = [left - d[0], top + height - d[1], left + width - d[2], top - d[3]];
    assert!(apart.iter().all(|x| x.abs() < 0.011), "{apart:?}");
    // 10⁴ stands log₁₀ 5 of log₁₀ 3500 to the right: 0.19722. A tenth of a pixel.
    let tick =
        drawn.lines().zip(drawn.lines().skip(1)).find(|(_, text)| text.ends_with(">10⁴</text>"));
    let at = attribute(tick.unwrap().0, "x1");
    assert!((at - left - 0.19722 * width).abs() < 0.1, "{at}");
}

/// The mark is some 10 pixels high, and 3 % of the axis below its end are 9 pixels.
#[test]
fn a_failure_at_infinity_stands_at_the_top() {
    let failed = |y| {
        let series = vec![Series::new("did not end", Colour::Grey, Style::Failed, vec![(7.3, y)])];
        let axis = Axis::logarithmic("error", 1e-3, 1.0);
        let svg = svg(&[Panel { y: axis, series, ..panel(vec![]) }]);
        let marks: Vec<&str> = svg.lines().filter(|l| l.contains("stroke-width=\"2.2\"")).collect();
        // The last is the legend's.
        marks[..marks.len() - 1]
            .iter()
            .map(|mark| mark.split('"').nth(1).unwrap().to_owned())
            .collect::<Vec<_>>()
    };
    // 0.97 of three decades is 10^-0.09.
    assert_eq!(failed(f64::INFINITY), failed(0.8128305161640992));
    assert_eq!(failed(0.02).len(), 1);
    assert_ne!(failed(0.02), failed(f64::INFINITY));
    assert_eq!(failed(f64::NAN).len(), 0);
}

/// A line does not show through an open mark, on either page: the fill is the ground's.
#[test]
fn open_marks_have_the_colour_of_the_ground() {
    let filled = |style| {
        let series = vec![Series::new("run", Colour::Blue, style, vec![(7.3, 0.4), (8.1, 0.2)])];
        let svg = svg(&[Panel { series, ..panel(vec![]) }]);
        svg.matches("stroke-width=\"1.5\" fill=\"#ffffff\"").count()
    };
    let (open, full) = (Style::MarkedDashed(Mark::Square), Style::Marked(Mark::Square));
    assert_eq!((filled(open), filled(full), filled(Style::Circles)), (2, 0, 0));
}

#[test]
fn looks_differ_without_colour() {
    use Mark::*;
    let marks = [Circle, Square, Triangle, Diamond, Plus];
    let styles =
        marks.into_iter().flat_map(|mark| [Style::Marked(mark), Style::MarkedDashed(mark)]);
    let looks: Vec<String> = styles
        .map(|style| {
            let points = vec![(1.3, 0.4), (7.1, 1.2)];
            svg(&[Panel {
                series: vec![Series::new("run", Colour::Black, style, points)],
                ..panel(vec![])
            }])
        })
        .collect();
    for (k, look) in looks.iter().enumerate() {
        assert!(!looks[..k].contains(look), "{k}");
    }
}

#[test]
fn a_picture_has_a_name_and_dark_colours() {
    let svg = svg(&[panel(vec![(1.7, 0.3), (28.3, 1.45)]), panel(vec![])]);
    let head: Vec<&str> = svg.lines().take(3).collect();
    assert!(head[0].starts_with("<svg ") && head[0].ends_with(" role=\"img\">"), "{head:?}");
    assert_eq!(head[1], "  <title>A &amp; B; A &amp; B</title>");
    // Every colour that is used has its rule: none but those of the palette is.
    let used = svg.lines().skip(3).flat_map(|line| {
        ["fill", "stroke"].into_iter().flat_map(move |what| {
            let colours = line.split(&format!(" {what}=\"")).skip(1).collect::<Vec<_>>();
            colours
                .into_iter()
                .map(move |rest| format!("[{what}=\"{}\"]", rest.split('"').next().unwrap()))
        })
    });
    let used: Vec<String> = used.filter(|rule| !rule.contains("none")).collect();
    assert!(used.len() > 20);
    for rule in used {
        assert!(head[2].contains(&rule), "{rule}");
    }
}
