//! A trace as the library writes it: a header and an event a line, or the failure of the output.

use std::cell::Cell;
use std::io::{self, Write};

use crossfibre::march;
use crossfibre::paper::Paper;
use crossfibre::place::Fibre;
use crossfibre::result::{WithPaper, with_paper};
use crossfibre::scene::Scene;
use crossfibre::scene_file;
use crossfibre::state::{State, Wavefront};
use crossfibre::trace::Traced;
use crossfibre::trace_file::{Filter, JsonLines};
use serde_json::Value;

/// Seven steps of a scene, traced to an output.
struct Trace<'a, W>(&'a Scene, Filter, W);

impl<W: Write> WithPaper<f64> for Trace<'_, W> {
    type Out = io::Result<u64>;
    fn with(self, paper: &impl Paper<f64>) -> io::Result<u64> {
        let Self(scene, filter, out) = self;
        let traced = Traced::new(paper, JsonLines::start(out, scene, paper, filter)?);
        let mut state = State::<f64>::at_impact(scene, Wavefront::Flagged);
        assert!(march::run(&traced, &mut state, 7, |_| ()).is_completed());
        traced.into_sink().finish()
    }
}

fn lines(text: &str, filter: Filter) -> (u64, Vec<Value>) {
    let scene = scene_file::read(text).unwrap();
    let mut out = Vec::new();
    let written = with_paper(&scene, Trace(&scene, filter, &mut out)).unwrap();
    let text = String::from_utf8(out).unwrap();
    (written, text.lines().map(|line| serde_json::from_str(line).unwrap()).collect())
}

#[test]
fn a_trace_is_a_header_and_the_events_that_are_kept() {
    let filter =
        || Filter { equations: vec![4, 7], fibre: Some(Fibre::Primary), ..Filter::default() };
    let single = include_str!("../../verification/scenes/single-400.json");
    let (written, lines_of_single) = lines(single, filter());
    // The front gains an element a step: 1 + 2 + … + 7 elements, two equations each.
    assert_eq!((written, lines_of_single.len()), (56, 57));
    let header = &lines_of_single[0];
    assert_eq!(header["format"], "crossfibre-trace/1");
    let scene: Scene = serde_json::from_value(header["scene"].clone()).unwrap();
    assert_eq!(scene, scene_file::read(single).unwrap());
    assert_eq!(header["equations"].as_array().unwrap().len(), 20);
    assert!(header["equations"].as_array().unwrap().iter().all(|e| e["lines_by_law"].is_null()));
    assert!(lines_of_single[1..].iter().all(|e| e["eq"] == "4" || e["eq"] == "7"));

    let (_, lines_by_law) = lines(include_str!("../../verification/scenes/eyring.json"), filter());
    let seventh = &lines_by_law[0]["equations"][6];
    assert_eq!(seventh["lines_by_law"][0]["expression"], "{area} * {stress}");
    let others = lines_by_law[0]["equations"].as_array().unwrap().iter().filter(|e| *e != seventh);
    assert!(others.map(|e| &e["lines_by_law"]).all(Value::is_null));
}

/// Takes so many bytes and no more, and counts what it has refused.
struct Full<'a> {
    room: usize,
    refused: &'a Cell<u32>,
}

impl Write for Full<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match self.room.checked_sub(bytes.len()) {
            None => {
                self.refused.set(self.refused.get() + 1);
                Err(io::Error::other("no room"))
            }
            Some(left) => {
                self.room = left;
                Ok(bytes.len())
            }
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

#[test]
fn an_output_that_fails_is_told_at_the_start_or_the_end_and_not_asked_again() {
    let scene = scene_file::read(include_str!("../../verification/scenes/fig3.json")).unwrap();
    for room in [0, 20_000] {
        let refused = Cell::new(0);
        let full = Full { room, refused: &refused };
        let failed = with_paper(&scene, Trace(&scene, Filter::default(), full)).unwrap_err();
        assert_eq!(failed.to_string(), "no room", "{room}");
        assert_eq!(refused.get(), 1, "{room}");
    }
}
