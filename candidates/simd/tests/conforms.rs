//! The engine as a candidate: every bit of what it is asked.

#![allow(clippy::unwrap_used)] // a test may

use std::time::Duration;

use crossfibre_verification::conform::interview::conform;
use crossfibre_verification::conform::record::Verdict;
use crossfibre_verification::conform::session::Options;

#[test]
fn the_engine_conforms_to_the_bit() {
    for seed in [1, 7, 1980] {
        let options = Options {
            depths: vec![],
            filter: None,
            seed,
            exact: true,
            single: false,
            timeout: Duration::from_secs(600),
        };
        let command = [env!("CARGO_BIN_EXE_crossfibre-simd").into()];
        let report = conform(&command, &options, |_, _| ()).unwrap().0;
        let failures: Vec<_> = report.failures().map(|f| (&f.id, &f.reason)).collect();
        assert!(report.conforms, "seed {seed}: {failures:?}");
        // Steps and runs with all corrections: most of some seventy drawn ones and the golden ones.
        assert!(report.count(Verdict::Bits) > 50, "seed {seed}");
    }
}
