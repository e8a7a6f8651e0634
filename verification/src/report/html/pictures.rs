//! Pictures: each a file of its own within the page, so that its names and its style stay its own.

use maud::{Markup, html};

use super::parts::{data_uri, wide};
use crate::pictures::{Picture, Section};
use crate::record::Record;
use crate::report::words::{anchor, visible};

/// The pictures of a part of the page.
pub fn section(record: &Record, section: Section) -> Markup {
    let of = record.pictures.iter().filter(|picture| picture.section == section);
    html! { @for picture in of { (figure(picture)) } }
}

fn figure(picture: &Picture) -> Markup {
    let Picture { id, title, caption, alt, svg, .. } = picture;
    let (width, height) = (length(svg, "width"), length(svg, "height"));
    html! {
        figure id={ "picture-" (anchor(id)) } {
            h3 { (visible(title)) }
            (wide(title, html! {
                img src=(data_uri(svg)) alt=(visible(alt)) width=[width] height=[height] loading="lazy";
            }))
            figcaption { (visible(caption)) }
        }
    }
}

/// A length of the drawing in whole pixels, as its first element has it: room is kept for it.
fn length(svg: &str, name: &str) -> Option<u32> {
    let element = svg.split('>').next()?;
    let (_, after) = element.split_once(&format!(" {name}=\""))?;
    after.split(['"', '.']).next()?.parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn room_is_kept_for_a_picture() {
        let svg = "<svg xmlns=\"x\" width=\"1075\" height=\"450.5\"><rect width=\"3\"/></svg>";
        assert_eq!((length(svg, "width"), length(svg, "height")), (Some(1075), Some(450)));
        assert_eq!(length("<svg><rect width=\"3\"/></svg>", "width"), None);
    }
}
