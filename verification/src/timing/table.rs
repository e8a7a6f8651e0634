//! Times for people.

use super::Timed;

/// Those who took turns, held against the first: how many times as long each takes; the least time of
/// an element-step, also in links of the calibration loop, which takes `link` seconds for one; by how
/// much the median and the greatest time exceed the least.
pub fn side_by_side(all: &[Timed], link: f64) -> String {
    let head = ["", "times the first", "ns/element-step", "links", "median", "greatest"];
    let rows = all.iter().map(|timed| {
        let each = timed.per_element_step();
        vec![
            timed.name.clone(),
            format!("{:.3}", timed.ratio(&all[0])),
            format!("{:.3}", 1e9 * each),
            format!("{:.4}", each / link),
            format!("{:+.0} %", 100.0 * (timed.median / timed.least - 1.0)),
            format!("{:+.0} %", 100.0 * timed.spread()),
        ]
    });
    aligned(&head.map(str::to_owned), rows)
}

/// How numbers grow: a row for each name, a column for each size.
pub fn growth(what: &str, sizes: &[usize], rows: &[(String, Vec<f64>)]) -> String {
    let head: Vec<_> =
        [what.to_owned()].into_iter().chain(sizes.iter().map(|n| format!("n = {n}"))).collect();
    let rows = rows.iter().map(|(name, numbers)| {
        let numbers = numbers.iter().map(|number| format!("{number:.3}"));
        [name.clone()].into_iter().chain(numbers).collect()
    });
    aligned(&head, rows)
}

/// Columns of equal width, the first to the left and the others to the right.
fn aligned(head: &[String], rows: impl Iterator<Item = Vec<String>>) -> String {
    let lines: Vec<_> = [head.to_vec()].into_iter().chain(rows).collect();
    let width = |column: usize| lines.iter().map(|line| line[column].chars().count()).max();
    let widths: Vec<_> = (0..head.len()).filter_map(width).collect();
    let line = |cells: &Vec<String>| {
        let rest =
            cells.iter().zip(&widths).skip(1).map(|(cell, width)| format!("  {cell:>width$}"));
        format!("{:first$}{}\n", cells[0], rest.collect::<String>(), first = widths[0])
    };
    lines.iter().map(line).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_table_holds_all_against_the_first() {
        let timed = |name: &str, least| Timed {
            name: name.into(),
            least,
            median: 1.25 * least,
            greatest: 1.5 * least,
            element_steps: 2_000_000,
            checksum: None,
        };
        // 5 ms and 8 ms for two million element-steps; a link of 16 ns.
        assert_eq!(
            side_by_side(&[timed("first", 5e-3), timed("another", 8e-3)], 16e-9),
            "         times the first  ns/element-step   links  median  greatest\n\
             first              1.000            2.500  0.1562   +25 %     +50 %\n\
             another            1.600            4.000  0.2500   +25 %     +50 %\n"
        );
    }

    #[test]
    fn growth_has_a_column_for_each_size() {
        assert_eq!(
            growth(
                "ns",
                &[150, 1000],
                &[("first".into(), vec![2.5, 2.25]), ("μ".into(), vec![31.0, 7.0])]
            ),
            "ns     n = 150  n = 1000\nfirst    2.500     2.250\nμ       31.000     7.000\n"
        );
    }
}
