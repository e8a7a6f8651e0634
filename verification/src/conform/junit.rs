//! A report as JUnit XML: a suite for each depth, a test for each question.

use std::time::Duration;

use quick_junit::{NonSuccessKind, TestCase, TestCaseStatus, TestSuite};

use super::protocol::Depth;
use super::record::{ItemRecord, Report, Verdict};

/// The text of the file.
pub fn render(report: &Report) -> Result<String, quick_junit::SerializeError> {
    let mut junit =
        quick_junit::Report::new(format!("crossfibre conform {}", report.candidate.name));
    for depth in Depth::ALL {
        let items: Vec<_> = report.items.iter().filter(|item| item.depth == depth).collect();
        if items.is_empty() {
            continue;
        }
        let mut suite = TestSuite::new(depth.name());
        suite.add_test_cases(items.into_iter().map(|item| {
            let mut test = TestCase::new(&item.id, status(item));
            test.set_classname(format!("conform.{}", depth.name()));
            test
        }));
        junit.add_test_suite(suite);
    }
    // The only time there is would make every file another.
    junit.set_time(Duration::ZERO);
    junit.to_string()
}

fn status(item: &ItemRecord) -> TestCaseStatus {
    let reason = item.reason.clone().unwrap_or_default();
    let mut status = match item.verdict {
        Verdict::Bits | Verdict::Rounding => return TestCaseStatus::success(),
        Verdict::Skipped | Verdict::NotJudged => TestCaseStatus::skipped(),
        Verdict::Wrong => TestCaseStatus::non_success(NonSuccessKind::Failure),
        Verdict::Broken => TestCaseStatus::non_success(NonSuccessKind::Error),
    };
    status.set_message(match item.departs_at_step {
        Some(step) => format!("{reason}; wrong from step {step} on"),
        None => reason,
    });
    status
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::conform::example::of_everything;

    #[test]
    fn every_question_is_a_test_with_what_became_of_it() {
        let text = render(&of_everything()).unwrap();
        for part in [
            "name=\"crossfibre conform &lt;made&gt; up\" tests=\"9\" skipped=\"3\" failures=\"3\" \
             errors=\"1\"",
            "<testsuite name=\"equation\" tests=\"3\"",
            "<testsuite name=\"step\" tests=\"2\"",
            "<testsuite name=\"run\" tests=\"4\"",
            "<testcase name=\"run/huge\" classname=\"conform.run\"",
            "<failure message=\"a sign\"/>",
            "<failure message=\"too late; wrong from step 17 on\"/>",
            "<error message=\"it ended\"/>",
            "<skipped message=\"over- or underflow\"/>",
        ] {
            assert!(text.contains(part), "{part}\nis not in\n{text}");
        }
        let count = |what: &str| text.matches(what).count();
        assert_eq!((count("<testcase"), count("<skipped"), count("<failure")), (9, 3, 3));
    }
}
