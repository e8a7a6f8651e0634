//! Numbers as the summary writes them.

use std::fmt::{self, Formatter};

/// A length in millimetres.
pub fn mm(metres: f64) -> String {
    format!("{:.1} mm", metres * 1e3)
}

/// A strain in per cent.
pub fn percent(strain: f64) -> String {
    format!("{:.4} %", strain * 100.0)
}

/// run/exact − 1 in per cent; nothing where exact is zero.
pub fn relative(run: f64, exact: f64) -> String {
    if exact == 0.0 { String::new() } else { format!("{:+.2} %", (run / exact - 1.0) * 100.0) }
}

/// Five significant digits, with an exponent only where it is shorter.
pub fn significant(x: f64) -> String {
    let scientific = format!("{x:.4e}");
    let exponent = scientific.split('e').nth(1).and_then(|e| e.parse::<i32>().ok());
    match exponent {
        Some(e @ -3..=4) => format!("{x:.*}", usize::try_from(4 - e).unwrap_or(0)),
        _ => scientific,
    }
}

/// Writes a note, its lines broken before column 100.
pub fn write_note(to: &mut Formatter, note: &str) -> fmt::Result {
    let mut line = String::from("note        ");
    for word in note.split(' ') {
        if line.chars().count() + 1 + word.chars().count() > 99 {
            writeln!(to, "{line}")?;
            line = " ".repeat(12);
        }
        line.push(' ');
        line.push_str(word);
    }
    writeln!(to, "{line}")
}

#[cfg(test)]
mod tests {
    use super::*;

    struct Note(String);

    impl fmt::Display for Note {
        fn fmt(&self, to: &mut Formatter) -> fmt::Result {
            write_note(to, &self.0)
        }
    }

    /// What stands before the first word takes 13 columns.
    #[test]
    fn a_line_of_a_note_has_99_columns_at_most() {
        let lines = |first: usize| {
            let text = Note(format!("{} b", "a".repeat(first))).to_string();
            text.lines().map(|line| line.chars().count()).collect::<Vec<_>>()
        };
        assert_eq!(lines(84), [99]);
        assert_eq!(lines(85), [98, 14]);
        assert_eq!(lines(86), [99, 14]);
        assert_eq!(lines(87), [12, 100, 14]);
    }

    #[test]
    fn numbers_keep_five_digits() {
        let shown = [16.329_86, -0.001_234_56, 12_345.6, 0.0, 6.789_01e-7, 123_456.0];
        let expected = ["16.330", "-0.0012346", "12346", "0.0000", "6.7890e-7", "1.2346e5"];
        assert_eq!(shown.map(significant), expected);
    }
}
