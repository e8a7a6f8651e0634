//! The lines of a file of any size, in bounded memory.

use std::io::{self, ErrorKind, Read};
use std::ops::Range;

use memchr::memchr;

/// What is asked of the file at a time, at first.
const BUFFER: usize = 1 << 18;

/// Why there is no line.
#[derive(Debug)]
pub enum Trouble {
    /// The file cannot be read.
    Io(io::Error),
    /// The line goes on beyond the limit.
    TooLong,
}

/// Lines, one at a time.
pub struct Lines<R> {
    from: R,
    buffer: Vec<u8>,
    /// The part of the buffer that has been read from the file and not been gone past.
    filled: Range<usize>,
    line: Range<usize>,
    number: u64,
    cut: bool,
}

impl<R: Read> Lines<R> {
    /// Before the first line.
    pub fn of(from: R) -> Self {
        Self { from, buffer: vec![0; BUFFER], filled: 0..0, line: 0..0, number: 0, cut: false }
    }

    /// Goes on to the next line; whether there is one of at most `limit` bytes.
    pub fn advance(&mut self, limit: usize) -> Result<bool, Trouble> {
        let mut looked_through = 0;
        let length = loop {
            let unread = &self.buffer[self.filled.clone()];
            if let Some(more) = memchr(b'\n', &unread[looked_through..]) {
                break looked_through + more;
            }
            looked_through = unread.len();
            if looked_through > limit {
                self.number += 1;
                return Err(Trouble::TooLong);
            }
            if self.fill().map_err(Trouble::Io)? == 0 {
                self.cut = true;
                break looked_through;
            }
        };
        if self.cut && length == 0 {
            return Ok(false);
        }
        self.number += 1;
        let start = self.filled.start;
        self.line = start..start + length;
        self.filled.start = (self.line.end + 1).min(self.filled.end);
        if length > limit { Err(Trouble::TooLong) } else { Ok(true) }
    }

    /// Reads more, and makes room for it first. How many bytes came.
    fn fill(&mut self) -> io::Result<usize> {
        if self.filled.end == self.buffer.len() {
            self.buffer.copy_within(self.filled.clone(), 0);
            self.filled = 0..self.filled.len();
            if self.filled.end > self.buffer.len() / 2 {
                self.buffer.resize(2 * self.buffer.len(), 0);
            }
        }
        loop {
            match self.from.read(&mut self.buffer[self.filled.end..]) {
                Err(error) if error.kind() == ErrorKind::Interrupted => (),
                Err(error) => return Err(error),
                Ok(count) => {
                    self.filled.end += count;
                    return Ok(count);
                }
            }
        }
    }

    /// The line, without its end.
    pub fn line(&self) -> &[u8] {
        &self.buffer[self.line.clone()]
    }

    /// Its number, from 1, of a line that is too long as well.
    pub fn number(&self) -> u64 {
        self.number
    }

    /// Whether the file has ended without the end of this line.
    pub fn is_cut(&self) -> bool {
        self.cut
    }
}

#[cfg(test)]
mod tests {
    use std::collections::VecDeque;

    use super::*;

    /// Gives a few bytes at a time, as a pipe may.
    struct Dribble<'a>(&'a [u8], usize);

    impl Read for Dribble<'_> {
        fn read(&mut self, to: &mut [u8]) -> io::Result<usize> {
            let count = self.1.min(to.len());
            self.0.read(&mut to[..count])
        }
    }

    #[test]
    fn lines_are_those_of_the_standard_library_whatever_their_length() {
        let lengths = [0, 3, BUFFER - 1, BUFFER, 0, BUFFER + 1, 17, 3 * BUFFER, 1];
        let text: Vec<u8> = lengths
            .iter()
            .zip(b'a'..)
            .flat_map(|(&length, letter)| [vec![letter; length], b"\n".to_vec()].concat())
            .collect();
        for end in [text.len(), text.len() - 1] {
            for at_a_time in [4093, usize::MAX] {
                let text = &text[..end];
                let mut lines = Lines::of(Dribble(text, at_a_time));
                for (expected, number) in text.split(|&b| b == b'\n').zip(1..) {
                    if number == lengths.len() as u64 + 1 {
                        break; // what `split` has after the last end of a line
                    }
                    assert!(lines.advance(3 * BUFFER).unwrap());
                    assert!(lines.line() == expected, "line {number}");
                    assert_eq!(lines.number(), number);
                }
                assert_eq!(lines.is_cut(), end < text.len() + 1 && text.last() != Some(&b'\n'));
                assert!(!lines.advance(3 * BUFFER).unwrap());
            }
        }
    }

    #[test]
    fn a_line_may_be_as_long_as_the_limit_and_no_longer_and_memory_is_bounded() {
        let limit = 2 * BUFFER;
        let mut endless = Lines::of(io::repeat(b'x'));
        assert!(matches!(endless.advance(limit), Err(Trouble::TooLong)));
        assert!(endless.buffer.len() <= 4 * limit);
        let text = [vec![b'y'; 40], b"\n".to_vec()].concat();
        assert!(Lines::of(&*text).advance(40).unwrap());
        assert!(matches!(Lines::of(&*text).advance(39), Err(Trouble::TooLong)));
    }

    /// What a reader gives, one after the other.
    struct Told(VecDeque<Result<&'static [u8], ErrorKind>>);

    impl Read for Told {
        fn read(&mut self, to: &mut [u8]) -> io::Result<usize> {
            let bytes = self.0.pop_front().unwrap_or(Ok(b""))?;
            to[..bytes.len()].copy_from_slice(bytes);
            Ok(bytes.len())
        }
    }

    #[test]
    fn an_interrupted_reader_is_asked_again_and_one_that_fails_is_not() {
        let interrupted = Err(ErrorKind::Interrupted);
        let pieces: [&[u8]; 2] = [b"ab", b"c\nd"];
        let [first, second] = pieces.map(Ok);
        let told = [interrupted, first, interrupted, interrupted, second];
        let mut lines = Lines::of(Told(told.into()));
        assert!(lines.advance(3).unwrap());
        assert_eq!(lines.line(), b"abc");
        let told = [first, Err(ErrorKind::BrokenPipe)];
        let trouble = Lines::of(Told(told.into())).advance(3).unwrap_err();
        assert!(matches!(&trouble, Trouble::Io(e) if e.kind() == ErrorKind::BrokenPipe));
    }

    #[test]
    fn a_line_of_the_limit_may_have_its_end_in_the_next_piece() {
        let pieces: [&[u8]; 2] = [b"abc", b"\n"];
        assert!(Lines::of(Told(pieces.map(Ok).into())).advance(3).unwrap());
    }

    #[test]
    fn memory_grows_by_doubling_and_only_for_a_line_that_needs_it() {
        let text = [vec![b'x'; 999], b"\n".to_vec()].concat().repeat(5 * BUFFER / 1000);
        let mut lines = Lines::of(&*text);
        while lines.advance(1000).unwrap() {}
        assert_eq!((lines.number(), lines.buffer.len()), (5 * BUFFER as u64 / 1000, BUFFER));
        // Full twice over without the end of a line, and only then too long.
        let mut endless = Lines::of(io::repeat(b'x'));
        assert!(endless.advance(2 * BUFFER).is_err());
        assert_eq!(endless.buffer.len(), 4 * BUFFER);
    }
}
