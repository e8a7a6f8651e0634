//! A result as a table: a row for each node, and in it the element that begins there.

use std::io::{self, Write};

use crossfibre::result::RunResult;

use super::{element_places, fibres, node_places};

const HEADER: &str = "fibre,index,node place [m],x [m],y [m],z [m],vx [m/s],vy [m/s],vz [m/s],\
                      element place [m],strain,tension [N]";

/// Writes it. The last node of a fibre has no element after it: its cells are empty.
pub fn write(result: &RunResult, to: &mut impl Write) -> io::Result<()> {
    writeln!(to, "{HEADER}")?;
    for (name, fibre) in fibres(result) {
        let (nodes, elements) = (node_places(fibre), element_places(fibre));
        for (i, place) in nodes.iter().enumerate() {
            write!(to, "{name},{i},{place:?}")?;
            for vector in [&fibre.position[i], &fibre.velocity[i]] {
                // The primary stays in the plane z = 0.
                (0..3).try_for_each(|k| write!(to, ",{:?}", vector.get(k).unwrap_or(&0.0)))?;
            }
            match elements.get(i) {
                Some(middle) => {
                    writeln!(to, ",{middle:?},{:?},{:?}", fibre.strain[i], fibre.tension[i])?;
                }
                None => writeln!(to, ",,,")?,
            }
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cases::support::shipped;
    use crate::wide;

    #[test]
    fn every_number_is_in_its_column_to_the_last_bit() {
        let result = wide::run(&shipped("unequal"), |_| ());
        let mut text = Vec::new();
        write(&result, &mut text).unwrap();
        let text = String::from_utf8(text).unwrap();
        let rows: Vec<Vec<&str>> = text.lines().map(|line| line.split(',').collect()).collect();
        let secondary = result.secondary.as_ref().unwrap();
        let nodes = [result.primary.position.len(), secondary.position.len()];
        assert_eq!(rows.len(), 1 + nodes[0] + nodes[1]);
        assert!(rows.iter().all(|row| row.len() == 12));
        let number = |row: &[&str], column: usize| row[column].parse::<f64>().unwrap();
        let (first, second) = rows[1..].split_at(nodes[0]);
        assert_eq!(first[37][..2], ["primary", "37"]);
        assert_eq!(number(&first[37], 3), result.primary.position[37][0]);
        assert_eq!(number(&first[37], 5), 0.0);
        assert_eq!(number(&first[37], 11), result.primary.tension[37]);
        assert_eq!(second[5][..2], ["secondary", "5"]);
        assert_eq!(number(&second[5], 5), secondary.position[5][2]);
        assert_eq!(number(&second[5], 7), secondary.velocity[5][1]);
        assert_eq!(number(&second[5], 10), secondary.strain[5]);
        // 0.1639 m in 97 elements, in `unequal.json`; a product and a quotient are rounded.
        assert!((number(&second[5], 2) - 5.0 * 0.1639 / 97.0).abs() < 1e-16);
        assert!((number(&second[5], 9) - 5.5 * 0.1639 / 97.0).abs() < 1e-16);
        assert_eq!(second.last().unwrap()[9..], ["", "", ""]);
    }
}
