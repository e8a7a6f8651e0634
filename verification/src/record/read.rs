//! Reads a record from text, and says in a line what is wrong with one that cannot be read.

use std::fmt;

use serde::Deserialize;
use serde_json::error::Category;

use super::{FORMAT, Record};
use crate::cases::{self, Verdict};

/// What to do about what is no record.
pub const RIGHT_FILE: &str = "name the report.json that `crossfibre verify` has written";

/// Why a text is no record.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Fault {
    /// There is nothing in it.
    Empty,
    /// It ends in the middle.
    CutShort {
        /// Its last line.
        line: usize,
    },
    /// Not JSON.
    NotJson(Place),
    /// JSON, and no report at all.
    NoReport,
    /// A report of a format that this version does not read.
    Format(String),
    /// A field that is missing, unknown, or not what it should be.
    Field(Place),
    /// A verdict that the numbers of its check do not bear out.
    Verdict {
        /// The case.
        case: String,
        /// The claim of the check.
        claim: String,
        /// What the record says.
        said: Verdict,
        /// What the numbers give.
        found: Verdict,
    },
}

/// A place in the text and what is the matter there. Lines and columns count from 1.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Place {
    line: usize,
    column: usize,
    message: String,
}

impl Place {
    fn of(error: &serde_json::Error) -> Self {
        let (line, column) = (error.line(), error.column());
        let whole = error.to_string();
        let end = format!(" at line {line} column {column}");
        Self { line, column, message: whole.strip_suffix(&end).unwrap_or(&whole).to_owned() }
    }
}

impl fmt::Display for Place {
    fn fmt(&self, to: &mut fmt::Formatter) -> fmt::Result {
        write!(to, "line {}, column {}: {}", self.line, self.column, self.message)
    }
}

impl fmt::Display for Fault {
    fn fmt(&self, to: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::Empty => write!(to, "the file is empty")?,
            Self::CutShort { line } => write!(to, "ends at line {line}: cut short?")?,
            Self::NotJson(place) => write!(to, "not JSON: {place}")?,
            Self::NoReport => write!(to, "no report: it has no `format`")?,
            Self::Format(found) => {
                write!(to, "the format is `{found}`; this version reads `{FORMAT}`")?;
            }
            Self::Field(place) => write!(to, "{place}")?,
            Self::Verdict { case, claim, said, found } => {
                return write!(
                    to,
                    "case {case}, `{claim}`: the record says `{}`, its numbers `{}`\n  help: a record is \
                     not to be edited; make it anew with `crossfibre verify`",
                    said.words(),
                    found.words()
                );
            }
        }
        write!(to, "\n  help: {RIGHT_FILE}")
    }
}

impl std::error::Error for Fault {}

impl Record {
    /// Reads a record, and holds its verdicts against its numbers.
    pub fn read(text: &str) -> Result<Self, Fault> {
        #[derive(Deserialize)]
        struct Head {
            format: Option<String>,
        }
        if text.trim().is_empty() {
            return Err(Fault::Empty);
        }
        let fault = |error: serde_json::Error| match error.classify() {
            Category::Eof => Fault::CutShort { line: text.lines().count() },
            Category::Data => Fault::Field(Place::of(&error)),
            Category::Syntax | Category::Io => Fault::NotJson(Place::of(&error)),
        };
        let head: Head = serde_json::from_str(text).map_err(|error| match fault(error) {
            Fault::Field(_) => Fault::NoReport,
            other => other,
        })?;
        match head.format {
            None => return Err(Fault::NoReport),
            Some(format) if format != FORMAT => return Err(Fault::Format(format)),
            Some(_) => {}
        }
        let record: Self = serde_json::from_str(text).map_err(fault)?;
        record.verdicts_hold().map(|()| record)
    }

    fn verdicts_hold(&self) -> Result<(), Fault> {
        for case in &self.cases {
            let checks: Vec<_> = case.checks.iter().map(|record| record.check.clone()).collect();
            for (record, found) in case.checks.iter().zip(cases::verdicts(&checks)) {
                if record.verdict != found {
                    let (case, claim) = (case.id.clone(), record.check.claim.clone());
                    return Err(Fault::Verdict { case, claim, said: record.verdict, found });
                }
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::record::made_up;

    fn said(text: &str) -> String {
        Record::read(text).unwrap_err().to_string()
    }

    #[test]
    fn what_is_written_is_read_back_whatever_was_measured() {
        let record = made_up::record();
        assert!(made_up::measured(&record).any(f64::is_nan), "the record should hold a NaN");
        let back = Record::read(&record.json()).unwrap();
        let bits =
            |record: &Record| made_up::measured(record).map(f64::to_bits).collect::<Vec<_>>();
        assert_eq!(bits(&back), bits(&record));
        assert_eq!(back.json(), record.json());
    }

    #[test]
    fn an_empty_file_and_one_cut_short_are_told() {
        assert!(said("").starts_with("the file is empty\n  help: name the report.json"));
        assert!(said(" \n\n").starts_with("the file is empty"));
        let text = made_up::record().json();
        for at in [text.find("\"cases\"").unwrap(), text.len() / 2, text.len() - 3] {
            let at = (at..).find(|&at| text.is_char_boundary(at)).unwrap();
            let cut = &text[..at];
            let expected = format!("ends at line {}: cut short?", cut.lines().count());
            assert!(said(cut).starts_with(&expected), "{}", said(cut));
        }
    }

    #[test]
    fn what_is_no_report_is_told_from_one_of_another_format() {
        assert!(said("# Validation").starts_with("not JSON: line 1, column 1: expected value"));
        for no_report in ["{}", "[1]", "7", "{\"format\": 1}", "{\"cases\": []}"] {
            assert!(said(no_report).starts_with("no report: it has no `format`"), "{no_report}");
        }
        assert!(said("{\"format\": \"crossfibre-report/2\", \"more\": 1}").starts_with(
            "the format is `crossfibre-report/2`; this version reads `crossfibre-report/1`"
        ));
    }

    #[test]
    fn an_unknown_field_is_told_with_its_place() {
        let text = made_up::record().json().replacen("\"claims\"", "\"clams\"", 1);
        let message = said(&text);
        assert!(message.contains("unknown field `clams`"), "{message}");
        let line = 1 + text[..text.find("\"clams\"").unwrap()].matches('\n').count();
        assert!(message.starts_with(&format!("line {line}, column ")), "{message}");
        let text = made_up::record().json().replacen("\"norm\"", "\"nrm\"", 1);
        assert!(said(&text).contains("missing field `norm`"), "{}", said(&text));
        let text = made_up::record().json().replacen("\"verdict\"", "\"extra\": 7, \"verdict\"", 1);
        assert!(said(&text).contains("unknown field `extra`"), "{}", said(&text));
    }

    #[test]
    fn a_verdict_that_the_numbers_do_not_bear_out_is_told() {
        let mut record = made_up::record();
        let check = &mut record.cases[0].checks[0];
        assert_eq!(check.verdict, Verdict::Passed);
        check.check.measured *= 30.7;
        let message = said(&record.json());
        assert!(
            message.contains("the record says `passed`, its numbers `out of bounds`"),
            "{message}"
        );
    }
}
