//! The structure of a text that may be JSON, or was before it was spoilt: enough to change fields and
//! values as such, and to keep the rest byte for byte.

use std::ops::Range;

/// A piece of the text.
#[derive(Clone, Debug)]
pub struct Token {
    /// Its bytes.
    pub range: Range<usize>,
    kind: Kind,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    /// In quotes.
    String,
    /// A number, or `true`, or rubbish.
    Word,
    /// One of `{}[],:`.
    Mark(u8),
}

impl Token {
    pub fn is_string(&self) -> bool {
        self.kind == Kind::String
    }

    pub fn is_word(&self) -> bool {
        self.kind == Kind::Word
    }

    fn is(&self, mark: u8) -> bool {
        self.kind == Kind::Mark(mark)
    }
}

/// The pieces of a text, without white space.
pub fn tokens(text: &[u8]) -> Vec<Token> {
    let mut found = Vec::new();
    let mut at = 0;
    while at < text.len() {
        let from = at;
        at += 1;
        let kind = match text[from] {
            b' ' | b'\t' | b'\n' | b'\r' => continue,
            mark @ (b'{' | b'}' | b'[' | b']' | b',' | b':') => Kind::Mark(mark),
            b'"' => {
                while at < text.len() && text[at] != b'"' && text[at] != b'\n' {
                    at += if text[at] == b'\\' { 2 } else { 1 };
                }
                at = (at + 1).min(text.len());
                Kind::String
            }
            _ => {
                while at < text.len() && !b" \t\n\r{}[],:\"".contains(&text[at]) {
                    at += 1;
                }
                Kind::Word
            }
        };
        found.push(Token { range: from..at, kind });
    }
    found
}

/// Where keys and values are among the pieces.
pub struct Structure {
    tokens: Vec<Token>,
    /// Pieces that are keys.
    pub keys: Vec<usize>,
    /// Pieces with which a value begins.
    pub values: Vec<usize>,
}

impl Structure {
    /// Of a text.
    pub fn of(text: &[u8]) -> Self {
        let tokens = tokens(text);
        let is_key =
            |i: usize| tokens[i].is_string() && tokens.get(i + 1).is_some_and(|t| t.is(b':'));
        let begins = |i: usize| match tokens[i].kind {
            Kind::Mark(mark) => mark == b'{' || mark == b'[',
            _ => !is_key(i),
        };
        let keys = (0..tokens.len()).filter(|&i| is_key(i)).collect();
        let values = (0..tokens.len()).filter(|&i| begins(i)).collect();
        Self { keys, values, tokens }
    }

    /// The bytes of a piece.
    pub fn bytes(&self, token: usize) -> Range<usize> {
        self.tokens[token].range.clone()
    }

    /// How many pieces there are.
    pub fn len(&self) -> usize {
        self.tokens.len()
    }

    /// Whether a piece is a number or another word without quotes.
    pub fn is_word(&self, token: usize) -> bool {
        self.tokens[token].is_word()
    }

    /// The bytes of the value that begins with a piece.
    pub fn value(&self, begin: usize) -> Range<usize> {
        let last = self.last(begin);
        self.tokens[begin].range.start..self.tokens[last].range.end
    }

    fn last(&self, begin: usize) -> usize {
        let mut depth = 0_usize;
        for (i, token) in self.tokens.iter().enumerate().skip(begin) {
            match token.kind {
                Kind::Mark(b'{' | b'[') => depth += 1,
                Kind::Mark(b'}' | b']') => depth = depth.saturating_sub(1),
                _ => {}
            }
            if depth == 0 {
                return i;
            }
        }
        self.tokens.len() - 1
    }

    /// The bytes of the member of an object, or the entry of a list, that a value belongs to: with its
    /// key, without the comma.
    pub fn member(&self, value: usize) -> Range<usize> {
        let Range { mut start, end } = self.value(value);
        if value >= 2 && self.tokens[value - 1].is(b':') {
            start = self.tokens[value - 2].range.start;
        }
        start..end
    }

    /// The same with the comma after it, or the one before it.
    pub fn member_and_comma(&self, value: usize) -> Range<usize> {
        let member = self.member(value);
        let after = self.tokens.iter().find(|token| token.range.start >= member.end);
        let before = self.tokens.iter().rev().find(|token| token.range.end <= member.start);
        match (before, after) {
            (_, Some(comma)) if comma.is(b',') => member.start..comma.range.end,
            (Some(comma), _) if comma.is(b',') => comma.range.start..member.end,
            _ => member,
        }
    }
}
