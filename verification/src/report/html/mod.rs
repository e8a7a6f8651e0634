//! The record as a page: one file, no network, and no script needed to read it.

mod about;
mod cases;
mod cost;
mod examined;
mod first;
mod ledger;
mod matrix;
mod motion;
pub mod parts;
mod pictures;
pub mod style;
mod tolerances;

use maud::{DOCTYPE, Markup, PreEscaped, html};

use crate::pictures::Section;
use crate::record::Record;
use crate::report::words::line;
use style::STYLE;

/// Nothing is fetched from anywhere, whatever a record holds.
const POLICY: &str = "default-src 'none'; img-src data:; style-src 'unsafe-inline'; \
                      script-src 'unsafe-inline'; base-uri 'none'; form-action 'none'";

/// The parts below the first screen, with their names in links and what stands over them.
const PARTS: [(&str, &str); 9] = [
    ("claims", "What is proven, and what is not"),
    ("wrong", "What the paper got wrong"),
    ("cost", "How accurate for how much time"),
    ("figures", "Figures"),
    ("stability", "Stability"),
    ("tolerances", "Tolerances"),
    ("faults", "Which check catches which fault"),
    ("cases", "Every case"),
    ("about", "About this record"),
];

/// The text of the file.
pub fn render(record: &Record) -> String {
    let (all, passed) = record.tally();
    let tone = if all == passed && all > 0 { "good" } else { "bad" };
    html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta name="viewport" content="width=device-width, initial-scale=1";
                meta name="color-scheme" content="light dark";
                meta http-equiv="Content-Security-Policy" content=(POLICY);
                title { "crossfibre " (line(&record.version)) ": " (first::verdict(record)) }
                style { (PreEscaped(STYLE)) }
            }
            body {
                a.skip href="#main" { "To the content" }
                header {
                    p.kind { "Verification of crossfibre " (line(&record.version)) }
                    h1 class=(tone) { (first::verdict(record)) }
                    (first::lead())
                    nav aria-label="Parts of this page" {
                        ul { @for (id, title) in PARTS { li { a href={ "#" (id) } { (title) } } } }
                    }
                }
                main id="main" {
                    (cases::troubled(record))
                    (first::answers(record))
                    (part(0, html! { (ledger::claims(record)) }))
                    (part(1, html! { (ledger::ledger(record)) }))
                    (part(2, html! { (cost::cost(record)) (pictures::section(record, Section::Cost)) }))
                    (part(3, html! {
                        (motion::motion(record))
                        (pictures::section(record, Section::Figures))
                    }))
                    (part(4, html! { (pictures::section(record, Section::Stability)) }))
                    (part(5, html! { (tolerances::tolerances(record)) }))
                    (part(6, html! { (matrix::matrix(record)) (examined::examined(record)) }))
                    (part(7, html! { (cases::all(record)) }))
                    (part(8, html! { (about::about(record)) }))
                }
                @if record.motion.is_some() { script { (PreEscaped(motion::SCRIPT)) } }
            }
        }
    }
    .into_string()
}

fn part(k: usize, content: Markup) -> Markup {
    let (id, title) = PARTS[k];
    html! { section id=(id) aria-labelledby={ (id) "-title" } { h2 id={ (id) "-title" } { (title) } (content) } }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::record::made_up;

    #[test]
    fn hostile_names_are_text() {
        let page = render(&made_up::record());
        // The only script is our own.
        assert_eq!(page.matches("<script").count(), 0);
        for bad in
            ["alert(1)</script>", "href=\"javascript", "\u{0}", "\u{1b}", "\u{202e}", "<b>bold"]
        {
            assert!(!page.contains(bad), "{bad:?}");
        }
        assert!(page.contains("&lt;script&gt;alert(1)&lt;/script&gt; &quot;&amp;"));
    }

    #[test]
    fn what_failed_is_said_first_and_is_open() {
        let page = render(&made_up::record());
        assert!(
            page.contains("<h1 class=\"bad\">5 of 10 checks do not pass</h1>"),
            "{}",
            &page[..9000]
        );
        let (troubled, cases) =
            (page.find("id=\"troubled\"").unwrap(), page.find("id=\"cases\"").unwrap());
        let open = page.match_indices("<details class=\"case\" open").map(|(at, _)| at);
        let open: Vec<usize> = open.collect();
        assert_eq!(open.len(), 2);
        assert!(open.iter().all(|at| (troubled..cases).contains(at)));
        let passing = render(&made_up::passing());
        assert!(passing.contains("<h1 class=\"good\">All 4 checks pass</h1>"));
        assert!(!passing.contains("id=\"troubled\"") && !passing.contains(" open>"));
        let part = render(&Record { left_out: vec!["smith.kink".into()], ..made_up::passing() });
        assert!(part.contains("<h1 class=\"good\">All 4 checks that were run pass</h1>"));
        assert!(part.contains("Not all: </strong>1 case left out"), "{part}");
    }

    #[test]
    fn a_case_says_which_faults_it_catches_or_that_they_were_not_tried_on_it() {
        let page = render(&made_up::record());
        assert_eq!(page.matches("Catches 2 planted faults of 3").count(), 1);
        // The matrix knows the first of three cases only.
        assert_eq!(page.matches("were not tried on this case").count(), 2);
    }

    #[test]
    fn the_first_screen_names_the_equations_that_are_wrong() {
        let page = render(&made_up::record());
        assert!(page.contains("errata in equations (17)<"), "{page}");
    }

    #[test]
    fn every_link_into_the_page_finds_its_place_and_no_id_is_there_twice() {
        let page = render(&made_up::record());
        let names = |mark: &'static str| {
            page.split(mark).skip(1).filter_map(|rest| rest.split('"').next()).collect::<Vec<_>>()
        };
        let ids = names(" id=\"");
        let distinct: std::collections::BTreeSet<_> = ids.iter().collect();
        assert_eq!(distinct.len(), ids.len(), "{ids:?}");
        for link in names("href=\"#") {
            assert!(distinct.contains(&link), "{link}");
        }
    }

    #[test]
    fn headings_go_down_by_one() {
        let page = render(&made_up::record());
        let levels: Vec<u32> = page
            .match_indices("<h")
            .filter_map(|(at, _)| page[at + 2..].chars().next()?.to_digit(10))
            .collect();
        assert_eq!(levels.iter().filter(|&&level| level == 1).count(), 1);
        assert!(levels.windows(2).all(|two| two[1] <= two[0] + 1), "{levels:?}");
    }
}
