//! The rectangle that a panel's axes enclose, in pixels.

use super::Panel;

/// Where a panel's values stand.
pub struct Frame<'a> {
    /// Left end, pixels from the left.
    pub left: f64,
    /// Upper end, pixels from above.
    pub top: f64,
    /// From left to right, pixels.
    pub width: f64,
    /// From above to below, pixels.
    pub height: f64,
    /// The panel.
    pub panel: &'a Panel,
}

/// Pixels outside of a page that a renderer need not follow a line.
const FAR: f64 = 1e5;

impl Frame<'_> {
    /// Where a point stands; none if an axis has no place for it.
    pub fn at(&self, (x, y): (f64, f64)) -> Option<(f64, f64)> {
        let (right, up) = (self.panel.x.share(x)?, self.panel.y.share(y)?);
        let x = self.left + self.width * right;
        let y = self.top + self.height * (1.0 - up);
        Some((x.clamp(-FAR, FAR), y.clamp(-FAR, FAR)))
    }

    /// Left end, right end, upper end and lower end.
    pub fn ends(&self) -> (f64, f64, f64, f64) {
        (self.left, self.left + self.width, self.top, self.top + self.height)
    }
}
