//! The record as JUnit XML, for continuous integration.

use std::time::Duration;

use quick_junit::{NonSuccessKind, Report, TestCase, TestCaseStatus, TestSuite};

use crate::cases::Verdict;
use crate::record::{CheckRecord, Record};
use crate::report::markdown::bound;

/// A suite for each case, a test for each check.
pub fn render(record: &Record) -> Result<String, quick_junit::SerializeError> {
    let mut report = Report::new("crossfibre verify");
    for case in &record.cases {
        let mut suite = TestSuite::new(&case.id);
        // A record that was read may hold any number.
        suite.set_time(Duration::try_from_secs_f64(case.seconds).unwrap_or_default());
        suite.add_test_cases(case.checks.iter().map(|check| {
            let mut test = TestCase::new(&check.check.claim, status(check));
            test.set_classname(&case.id);
            test
        }));
        report.add_test_suite(suite);
    }
    report.to_string()
}

fn status(check: &CheckRecord) -> TestCaseStatus {
    if check.verdict == Verdict::Passed {
        return TestCaseStatus::success();
    }
    let mut status = TestCaseStatus::non_success(NonSuccessKind::Failure);
    let kind = if check.verdict == Verdict::Loose { "bound too loose" } else { "out of bounds" };
    status.set_type(kind);
    let c = &check.check;
    status.set_message(format!("{:e} is {kind}: {}", c.measured, bound(c.bound)));
    status.set_description(format!(
        "oracle: {}\nnorm: {}\nreason of the bound: {}",
        c.oracle, c.norm, c.reason
    ));
    status
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cases::{Bound, Check};
    use crate::record::CaseRecord;

    #[test]
    fn a_failed_check_is_a_failure_and_hostile_names_are_escaped() {
        let check = |claim: &str, measured| {
            let check = Check {
                claim: claim.into(),
                oracle: "an oracle".into(),
                norm: "a norm".into(),
                measured,
                bound: Bound::AtMost(1.0),
                reason: "a reason".into(),
            };
            CheckRecord { verdict: check.verdict(), check }
        };
        let case = CaseRecord {
            id: "a.case".into(),
            title: String::new(),
            equations: vec![],
            checks: vec![check("holds", 0.9), check("<&\"'> fails", 1.1)],
            seconds: 0.25,
        };
        let xml = render(&Record { cases: vec![case], ..Record::empty() }).unwrap();
        assert!(xml.contains("tests=\"2\" skipped=\"0\" failures=\"1\""), "{xml}");
        assert!(xml.contains("&lt;&amp;&quot;"), "{xml}");
        assert!(!xml.contains("<&"), "{xml}");
    }
}
