//! Editions: without corrections the page to the bit, and each correction changes its own equations.

use crate::common::{Inputs, cases, evaluate, evaluate_corrected, evaluate_printed};
use crossfibre::corrected::{Corrected, Engineering};
use crossfibre::errata::{Corrections, Erratum, Kind, LEDGER};
use proptest::array::uniform16;
use proptest::prelude::*;

/// The equations that a correction really changes.
fn changed_by(erratum: Erratum) -> &'static [u8] {
    match erratum {
        Erratum::StrainDenominator => &[3],
        Erratum::ProjectileInterval | Erratum::ProjectileSign | Erratum::ProjectileInertia => &[8],
        Erratum::ThetaAtOrigin => &[11],
        Erratum::PerpendicularResolution => &[16],
        Erratum::PerpendicularSign => &[17],
        Erratum::CrossoverInertia => &[17, 18],
        _ => &[], // readings and reports
    }
}

#[test]
fn what_a_correction_changes_is_what_its_entry_names() {
    for (&erratum, entry) in Erratum::ALL.iter().zip(LEDGER) {
        assert_eq!(erratum.entry().id, entry.id);
        let changed = changed_by(erratum);
        assert!(changed.iter().all(|n| entry.equations.contains(n)), "{}", entry.id);
        assert_eq!(entry.kind == Kind::Erratum, !changed.is_empty(), "{}", entry.id);
        // (3) is not evaluated by a run.
        let in_a_run = changed.iter().any(|&n| n != 3);
        assert_eq!(erratum.changes_a_run(), in_a_run, "{}", entry.id);
    }
}

/// Numbers of both signs that are not special.
fn inputs() -> impl Strategy<Value = Inputs> {
    uniform16(prop_oneof![-9.7_f64..-0.013, 0.013_f64..9.7])
}

fn differing(a: &[(u8, Vec<u64>)], b: &[(u8, Vec<u64>)]) -> Vec<u8> {
    assert_eq!((a.len(), b.len()), (20, 20));
    a.iter().zip(b).filter(|(a, b)| a != b).map(|(a, _)| a.0).collect()
}

proptest! {
    #![proptest_config(cases(256))]
    #[test]
    fn without_corrections_the_edition_is_the_page_to_the_bit(r in inputs()) {
        let printed = evaluate_printed(&r);
        prop_assert_eq!(&evaluate_corrected(Corrections::NONE, &r), &printed);
        // The other measure of strain changes (4) and nothing else.
        let engineering = evaluate(&Corrected::<Engineering>::new(Corrections::NONE), &r);
        prop_assert_eq!(differing(&engineering, &printed), [4]);
    }

    #[test]
    fn a_single_correction_changes_its_own_equations_and_no_other(r in inputs()) {
        let printed = evaluate_printed(&r);
        for &erratum in Erratum::ALL {
            let edition = evaluate_corrected(Corrections::NONE.with(erratum), &r);
            let changed = differing(&edition, &printed);
            let (id, may) = (erratum.entry().id, changed_by(erratum));
            // The two forms of (11) may agree to the bit; all others differ by far.
            if erratum == Erratum::ThetaAtOrigin {
                prop_assert!(changed.is_empty() || changed == may, "{id}: {changed:?}");
            } else {
                prop_assert_eq!(changed, may, "{}", id);
            }
        }
    }

    #[test]
    fn taking_one_correction_back_changes_its_own_equations_and_no_other(r in inputs()) {
        let corrected = evaluate_corrected(Corrections::ALL, &r);
        for &erratum in Erratum::ALL {
            let edition = evaluate_corrected(Corrections::ALL.without(erratum), &r);
            let changed = differing(&edition, &corrected);
            let (id, may) = (erratum.entry().id, changed_by(erratum));
            prop_assert!(changed.iter().all(|n| may.contains(n)), "{id}: {changed:?}");
            if erratum != Erratum::ThetaAtOrigin {
                prop_assert_eq!(changed, may, "{}", id);
            }
        }
    }
}
