//! Answers that no program should give: what the runner must outlive.

use crossfibre_verification::random::SplitMix;

/// What a number or a bracket may turn into.
const STRANGE: &[&str] = &[
    "",
    "null",
    "\"NaN\"",
    "\"-inf\"",
    "-0",
    "1e308",
    "1e400",
    "5e-324",
    "18446744073709551616",
    "[]",
    "{}",
    "[[[[[[",
    "\"\\u0000\"",
    ",",
    "\u{fffd}",
    "true",
    "-1",
    "0.1e",
    "]]",
    "\"",
];

/// A line with a few of its pieces changed: lost, doubled, exchanged for something strange, or cut off.
pub fn scrambled(line: &str, random: &mut SplitMix) -> String {
    const MARKS: [char; 6] = [',', '[', ']', ':', '{', '}'];
    // Between two marks there is a number, a word or nothing; each is a piece, and each mark.
    let mut pieces: Vec<&str> = line
        .split_inclusive(MARKS)
        .flat_map(|piece| match piece.strip_suffix(MARKS) {
            Some(before) => [before, &piece[before.len()..]],
            None => [piece, ""],
        })
        .collect();
    for _ in 0..random.whole(0..4) {
        if pieces.is_empty() {
            break;
        }
        let at = random.whole(0..pieces.len());
        match random.whole(0..5) {
            0 => drop(pieces.remove(at)),
            1 => pieces.insert(at, pieces[at]),
            2 => pieces.truncate(at),
            3 => pieces.swap(at, 0),
            _ => pieces[at] = STRANGE[random.whole(0..STRANGE.len())],
        }
    }
    pieces.concat()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_stays_a_line_and_some_stay_as_they_are() {
        let line = r#"{"id":7,"out":[0.3,-1e-7]}"#;
        let random = &mut SplitMix::new(3);
        let lines: Vec<_> = (0..200).map(|_| scrambled(line, random)).collect();
        assert!(lines.iter().all(|line| !line.contains('\n')));
        let same = lines.iter().filter(|scrambled| *scrambled == line).count();
        // A quarter is not changed, and some changes change nothing.
        assert!((30..120).contains(&same), "{same}");
    }

    #[test]
    fn pieces_are_doubled_cut_off_and_put_first() {
        let line = r#"{"id":7,"out":[0.3,-1e-7]}"#;
        let random = &mut SplitMix::new(3);
        let lines: Vec<_> = (0..2000).map(|_| scrambled(line, random)).collect();
        for wanted in
            [r#"{"id":77,"out":[0.3,-1e-7]}"#, r#"{"id":7,"#, r#"7{"id":,"out":[0.3,-1e-7]}"#]
        {
            assert!(lines.iter().any(|line| line == wanted), "{wanted}");
        }
    }
}
