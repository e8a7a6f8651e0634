//! Tables of comma-separated values: a head with units, then numbers that read back to the same bits.

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
