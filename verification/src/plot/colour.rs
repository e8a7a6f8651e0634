//! The colours, on a light and on a dark page.
//!
//! Those of lines follow Okabe and Ito's, which people of any colour vision tell apart; their orange,
//! sky blue, vermillion and grey are darker here, so that a thin line stands out from a white page.
//! The dark ones are of the same hues, with the lightness found anew for the dark page.

/// A colour.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Colour {
    /// Of lines and marks: black, and near white on a dark page.
    Black,
    /// Of lines and marks.
    Grey,
    /// Of lines and marks.
    Blue,
    /// Of lines and marks.
    Sky,
    /// Of lines and marks.
    Green,
    /// Of lines and marks.
    Orange,
    /// Of lines and marks.
    Vermillion,
    /// Of lines and marks.
    Purple,
    /// Of areas, the nearest to the ground. From here on each stands out more than the one before.
    Mist,
    /// Of areas.
    Sand,
    /// Of areas.
    Amber,
    /// Of areas.
    Rust,
    /// Of areas, the farthest from the ground.
    Brown,
}

/// All colours.
const COLOURS: [Colour; 13] = {
    use Colour::*;
    [Black, Grey, Blue, Sky, Green, Orange, Vermillion, Purple, Mist, Sand, Amber, Rust, Brown]
};

/// On a light page, and on a dark one.
type Pair = (&'static str, &'static str);

/// The ground.
pub const GROUND: Pair = ("#ffffff", "#16181d");

/// Lines of the grid.
pub const GRID: Pair = ("#e4e4e4", "#343840");

impl Colour {
    /// No two are the same on a light page.
    const fn pair(self) -> Pair {
        match self {
            Self::Black => ("#000000", "#e8e8e8"),
            Self::Grey => ("#6b6b6b", "#7a7a7a"),
            Self::Blue => ("#0072b2", "#2f86c8"),
            Self::Sky => ("#0096fa", "#3fd0ff"),
            Self::Green => ("#009e73", "#00b87a"),
            Self::Orange => ("#a77b00", "#ffcd3c"),
            Self::Vermillion => ("#ad4604", "#ff7a1a"),
            Self::Purple => ("#cc79a7", "#ff94c0"),
            Self::Mist => ("#e3ecf4", "#1f2c38"),
            Self::Sand => ("#f8dfa8", "#40371a"),
            Self::Amber => ("#e69f00", "#9c6a00"),
            Self::Rust => ("#d55e00", "#e0701f"),
            Self::Brown => ("#7a2e00", "#ffc3a0"),
        }
    }

    /// On a light page: what is written into attributes, so that every program shows it.
    pub const fn hex(self) -> &'static str {
        self.pair().0
    }
}

/// Rules that give a drawing its dark colours where the page is dark; paper is not.
pub fn style(drawing: &str) -> String {
    let mut rules = String::new();
    for (light, dark) in [GROUND, GRID].into_iter().chain(COLOURS.map(Colour::pair)) {
        for what in ["fill", "stroke"] {
            let attribute = format!("{what}=\"{light}\"");
            if drawing.contains(&attribute) {
                rules += &format!("[{attribute}]{{{what}:{dark}}}");
            }
        }
    }
    format!("<style>@media screen and (prefers-color-scheme:dark){{{rules}}}</style>")
}

/// Red, green and blue in proportion to light, from 0 to 1: the inverse of sRGB's transfer function
/// (IEC 61966-2-1).
#[cfg(test)]
fn light_of(hex: &str) -> [f64; 3] {
    [1, 3, 5].map(|from| {
        let c = f64::from(u8::from_str_radix(&hex[from..from + 2], 16).unwrap()) / 255.0;
        if c <= 0.04045 { c / 12.92 } else { pxfm::f_pow((c + 0.055) / 1.055, 2.4) }
    })
}

/// Relative luminance, from 0 to 1 (Web Content Accessibility Guidelines 2.2).
#[cfg(test)]
pub fn luminance(hex: &str) -> f64 {
    let [r, g, b] = light_of(hex);
    0.2126 * r + 0.7152 * g + 0.0722 * b
}

/// (L₁ + 0.05) / (L₂ + 0.05), of the lighter over the darker (Web Content Accessibility Guidelines
/// 2.2).
#[cfg(test)]
pub fn contrast(one: &str, other: &str) -> f64 {
    let (a, b) = (luminance(one), luminance(other));
    (a.max(b) + 0.05) / (a.min(b) + 0.05)
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    /// Of lines and marks, and of areas.
    fn lines_and_areas() -> (&'static [Colour], &'static [Colour]) {
        COLOURS.split_at(8)
    }

    const SCHEMES: [fn(Pair) -> &'static str; 2] = [|pair| pair.0, |pair| pair.1];

    #[test]
    fn contrast_is_that_of_the_guidelines() {
        // 21, the largest, and 4.54, which the guidelines' readers know of the grey #767676. Absolute,
        // 0.005: half of the last digit.
        assert!((contrast("#000000", "#ffffff") - 21.0).abs() < 0.005);
        assert!((contrast("#ffffff", "#767676") - 4.54).abs() < 0.005);
    }

    #[test]
    fn lines_and_text_stand_out_from_both_grounds() {
        for of in SCHEMES {
            let ground = of(GROUND);
            for &colour in lines_and_areas().0 {
                let found = contrast(of(colour.pair()), ground);
                assert!(found >= 3.0, "{colour:?} on {ground}: {found}");
            }
            // Text, ticks and axes are black, on the ground and across the grid.
            for behind in [ground, of(GRID)] {
                let found = contrast(of(Colour::Black.pair()), behind);
                assert!(found >= 4.5, "text on {behind}: {found}");
            }
        }
    }

    #[test]
    fn areas_stand_out_more_and_more() {
        for of in SCHEMES {
            let contrasts: Vec<f64> = lines_and_areas()
                .1
                .iter()
                .map(|area| contrast(of(area.pair()), of(GROUND)))
                .collect();
            assert!(contrasts.is_sorted(), "{contrasts:?}");
            // The two that most of a map is made of bear a black line.
            for area in [Colour::Mist, Colour::Sand] {
                assert!(contrast(of(area.pair()), of(Colour::Black.pair())) >= 4.5);
            }
        }
    }

    /// What people see of red, green and blue light: with all cones, and without those for long,
    /// middle and short waves (Machado, Oliveira and Fernandes 2009, severity 1).
    const VISIONS: [[[f64; 3]; 3]; 4] = [
        [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        [
            [0.152286, 1.052583, -0.204868],
            [0.114503, 0.786281, 0.099216],
            [-0.003882, -0.048116, 1.051998],
        ],
        [
            [0.367322, 0.860646, -0.227968],
            [0.280085, 0.672501, 0.047413],
            [-0.011820, 0.042940, 0.968881],
        ],
        [
            [1.255528, -0.076749, -0.178779],
            [-0.078411, 0.930809, 0.147602],
            [0.004733, 0.691367, 0.303900],
        ],
    ];

    fn times(matrix: [[f64; 3]; 3], vector: [f64; 3]) -> [f64; 3] {
        matrix.map(|row| row.iter().zip(vector).map(|(a, b)| a * b).sum())
    }

    /// Coordinates in which differences are as seen, black 0 and white 1 apart (Oklab, Ottosson
    /// 2020), of a colour by a vision.
    fn seen(hex: &str, vision: [[f64; 3]; 3]) -> [f64; 3] {
        let light = times(vision, light_of(hex)).map(|c| c.clamp(0.0, 1.0));
        let cones = [
            [0.4122214708, 0.5363325363, 0.0514459929],
            [0.2119034982, 0.6806995451, 0.1073969566],
            [0.0883024619, 0.2817188376, 0.6299787005],
        ];
        let opponents = [
            [0.2104542553, 0.7936177850, -0.0040720468],
            [1.9779984951, -2.4285922050, 0.4505937099],
            [0.0259040371, 0.7827717662, -0.8086757660],
        ];
        times(opponents, times(cones, light).map(pxfm::f_cbrt))
    }

    /// 0.06 is three times what is just seen side by side (0.02); Okabe and Ito's own colours, with
    /// the grey #808080, come down to 0.031.
    #[test]
    fn lines_are_told_apart_by_any_colour_vision() {
        for of in SCHEMES {
            for vision in VISIONS {
                let lines = lines_and_areas().0;
                for (k, &one) in lines.iter().enumerate() {
                    for &other in &lines[..k] {
                        let [a, b] = [one, other].map(|colour| seen(of(colour.pair()), vision));
                        let square: f64 = a.iter().zip(b).map(|(a, b)| (a - b) * (a - b)).sum();
                        let apart = square.sqrt();
                        assert!(apart > 0.06, "{one:?}, {other:?}: {apart} by {vision:?}");
                    }
                }
            }
        }
    }

    #[test]
    fn a_rule_finds_one_colour() {
        let light: BTreeSet<&str> = COLOURS.map(Colour::hex).into();
        assert_eq!(light.len(), COLOURS.len());
        assert!(!light.contains(GROUND.0) && !light.contains(GRID.0));
        let rules = style(r##"<path stroke="#000000" fill="none"/><rect fill="#e69f00"/>"##);
        assert_eq!(
            rules,
            "<style>@media screen and (prefers-color-scheme:dark){[stroke=\"#000000\"]\
             {stroke:#e8e8e8}[fill=\"#e69f00\"]{fill:#9c6a00}}</style>"
        );
    }
}
