//! Tables: of comma-separated values, with a head with units and numbers that read back to the same
//! bits; and of Markdown.

/// A table under way.
pub struct Table(String);

impl Table {
    /// A table with its columns; units in brackets, `[1]` for a pure number.
    pub fn new(columns: &[&str]) -> Self {
        Self(columns.join(",") + "\n")
    }

    /// A row; no text in it has a comma.
    pub fn row(&mut self, cells: &[String]) {
        self.0 += &(cells.join(",") + "\n");
    }

    /// The text.
    pub fn text(self) -> String {
        self.0
    }
}

/// A number by its shortest decimal, an empty cell for none.
pub fn cell(x: Option<f64>) -> String {
    x.map_or_else(String::new, |x| format!("{x}"))
}

/// A table of Markdown: the head, then rows.
pub fn markdown(head: &[&str], rows: &[Vec<String>]) -> String {
    let line = |cells: &[String]| format!("| {} |\n", cells.join(" | "));
    let rule = vec!["---".to_owned(); head.len()];
    let head: Vec<String> = head.iter().map(|&cell| cell.to_owned()).collect();
    let rows: String = rows.iter().map(|row| line(row)).collect();
    line(&head) + &line(&rule) + &rows
}
