//! The style of pages: that of reports, and of what `conform` writes.

/// The style sheet.
pub const STYLE: &str = include_str!("style.css");

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use super::*;
    use crate::plot::contrast;

    /// The colours of a scheme by their names: those of the light one first, then those of the dark.
    fn colours() -> [BTreeMap<&'static str, &'static str>; 2] {
        let mut parts = STYLE.split("prefers-color-scheme: dark");
        let of = |text: Option<&'static str>| -> BTreeMap<&str, &str> {
            let block = text.unwrap().split('}').next().unwrap();
            let colour = |d: &'static str| {
                let (name, value) =
                    d.trim().trim_start_matches([':', '{', ' ', ')', '\n']).split_once(':')?;
                let name = name.rsplit("--").next()?;
                Some((name.trim(), value.trim())).filter(|(_, value)| value.starts_with('#'))
            };
            block.split(';').filter_map(colour).collect()
        };
        [of(parts.next()), of(parts.next())]
    }

    #[test]
    fn text_stands_out_from_everything_that_is_behind_it() {
        for scheme in colours() {
            assert!(scheme.len() >= 12, "{scheme:?}");
            for text in ["ink", "soft", "good", "bad", "warn", "link"] {
                for behind in ["ground", "panel"] {
                    let found = contrast(scheme[text], scheme[behind]);
                    assert!(found >= 4.5, "{text} on {behind}: {found}");
                }
            }
            // Parts of drawings, and what shows the focus.
            for part in ["bar", "one", "two", "focus"] {
                for behind in ["ground", "panel"] {
                    let found = contrast(scheme[part], scheme[behind]);
                    assert!(found >= 3.0, "{part} on {behind}: {found}");
                }
            }
        }
    }
}
