//! The record as JUnit XML, for continuous integration.

use std::time::Duration;

use quick_junit::{NonSuccessKind, Property, Report, TestCase, TestCaseStatus, TestSuite};

use super::words::{advice, argument, bound, line, visible};
use crate::cases::Verdict;
use crate::record::{CaseRecord, CheckRecord, Record};

/// A suite for each case, a test for each check.
///
/// # Panics
/// If text cannot be written to memory: a fault of this program.
pub fn render(record: &Record) -> String {
    let mut report = Report::new("crossfibre verify");
    for case in &record.cases {
        let mut suite = TestSuite::new(line(&case.id));
        // A record that somebody has written may hold any number.
        suite.set_time(Duration::try_from_secs_f64(case.seconds).unwrap_or_default());
        suite.add_property(Property::new("source", visible(&record.build.source)));
        suite.add_test_cases(case.checks.iter().map(|check| {
            let mut test = TestCase::new(line(&check.check.claim), status(case, check));
            test.set_classname(line(&case.id));
            test
        }));
        report.add_test_suite(suite);
    }
    report.to_string().expect("text can be written to memory")
}

fn status(case: &CaseRecord, check: &CheckRecord) -> TestCaseStatus {
    if check.verdict == Verdict::Passed {
        return TestCaseStatus::success();
    }
    let mut status = TestCaseStatus::non_success(NonSuccessKind::Failure);
    let kind = check.verdict.words();
    let c = &check.check;
    status.set_type(kind);
    status.set_message(format!("{:e}, bound {}: {kind}", c.measured, bound(c.bound)));
    status.set_description(visible(&format!(
        "oracle: {}\nnorm: {}\nreason of the bound: {}\nto do: {}\nagain: crossfibre verify --filter {}",
        c.oracle,
        c.norm,
        c.reason,
        advice(check.verdict),
        argument(&case.id)
    )));
    status
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::record::made_up;

    #[test]
    fn every_check_that_did_not_pass_is_a_failure_and_hostile_names_are_escaped() {
        let record = made_up::record();
        let (all, passed) = record.tally();
        let xml = render(&record);
        let head = format!("tests=\"{all}\" skipped=\"0\" failures=\"{}\"", all - passed);
        assert!(xml.contains(&head), "{xml}");
        assert!(xml.contains("&lt;script&gt;alert(1)&lt;/script&gt; &quot;&amp;"), "{xml}");
        for bad in ["<script", "]]>", "-->", "\u{0}", "\u{1b}", "\u{202e}"] {
            assert!(!xml.contains(bad), "{bad:?} in {xml}");
        }
    }

    #[test]
    fn a_time_that_is_none_is_no_fault() {
        let mut record = made_up::passing();
        record.cases[0].seconds = -1e300;
        assert!(render(&record).contains("time=\"0.000\""));
    }
}
