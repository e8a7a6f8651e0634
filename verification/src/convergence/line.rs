//! The straight line of least squares.

/// y = mean_y + slope (x − mean_x).
#[derive(Clone, Copy, Debug)]
pub(super) struct Line {
    pub mean_x: f64,
    pub mean_y: f64,
    pub slope: f64,
    /// Σ(x − mean_x)².
    pub squares_x: f64,
    /// Σ(y − line)².
    pub residual: f64,
}

impl Line {
    /// The line through points of which two have different x.
    ///
    /// Both coordinates are taken from their means: sums of squares of the coordinates themselves
    /// would lose what a residual is made of.
    pub fn through(points: &[(f64, f64)]) -> Self {
        let n = points.len() as f64;
        let mean_x = points.iter().map(|p| p.0).sum::<f64>() / n;
        let mean_y = points.iter().map(|p| p.1).sum::<f64>() / n;
        let squares_x = points.iter().map(|p| (p.0 - mean_x) * (p.0 - mean_x)).sum::<f64>();
        let products = points.iter().map(|p| (p.0 - mean_x) * (p.1 - mean_y)).sum::<f64>();
        let slope = products / squares_x;
        let off = |p: &(f64, f64)| (p.1 - mean_y) - slope * (p.0 - mean_x);
        let residual = points.iter().map(|p| off(p) * off(p)).sum();
        Self { mean_x, mean_y, slope, squares_x, residual }
    }

    /// The line at an x.
    pub fn at(&self, x: f64) -> f64 {
        self.mean_y + self.slope * (x - self.mean_x)
    }
}
