//! How the number is made, compared, printed and stored.

use super::*;
use crate::place::{Fibre, Place};
use crate::trace::{Event, Value};

#[test]
fn a_double_stays_the_double_it_is_and_a_tenth_is_a_quotient() {
    let double = DoubleDouble::from_f64(0.1);
    assert_eq!((double.hi(), double.lo()), (0.1, 0.0));
    let tenth = DoubleDouble::one() / DoubleDouble::from_f64(10.0);
    // 1/10 − 0.1 = −5.55e-18, and ten of it is one but for the quotient's and the product's error.
    assert!((tenth.lo() + 5.551115123125783e-18).abs() < 1e-33, "{tenth}");
    let ten_tenths = tenth * DoubleDouble::from_f64(10.0);
    assert_within(QUOTIENT + PRODUCT, ten_tenths, f256::from(1.0), "10/10");
    assert_eq!(tenth.to_f64(), 0.1);
}

#[test]
fn parts_in_any_order_and_overlapping_are_made_into_nearest_double_and_rest() {
    for (a, b) in [(1.3e-17, -2.7), (-2.7, 1.3e-17), (0.7, 0.6), (2.3, -2.3), (0.7, 4.1e-200)] {
        let x = DoubleDouble::new(a, b);
        assert_eq!(exact(x), f256::from(a) + f256::from(b), "{a} {b}");
        assert_eq!(x.hi(), a + b);
        assert_eq!(x.hi() + x.lo(), x.hi());
    }
}

#[test]
fn order_is_decided_by_the_second_part_where_the_first_is_the_same() {
    let x = DoubleDouble::new(-2.7, 1.3e-17);
    for (less, greater) in [
        (DoubleDouble::new(-2.7, 1.2e-17), x),
        (DoubleDouble::new(-2.7, -1.2e-17), x),
        (x, DoubleDouble::new(-2.6, -1.3e-17)),
    ] {
        assert!(less < greater && less != greater);
        assert_eq!(greater.partial_cmp(&less), Some(std::cmp::Ordering::Greater));
        assert_eq!(Number::max(less, greater), greater);
        assert_eq!(Number::max(greater, less), greater);
    }
    assert_eq!(x.partial_cmp(&DoubleDouble::from_f64(f64::NAN)), None);
    assert_eq!(Number::abs(x), DoubleDouble::new(2.7, -1.3e-17));
}

/// The numbers in what is printed.
fn read(text: &str) -> DoubleDouble {
    // The sign of the second part is the last that does not follow an "e".
    let signs = text.match_indices(['+', '-']);
    let at = signs.map(|(i, _)| i).rfind(|&i| i > 0 && &text[i - 1..i] != "e");
    let (hi, lo) = text.split_at(at.unwrap_or(text.len()));
    DoubleDouble::new(hi.parse().unwrap(), if lo.is_empty() { 0.0 } else { lo.parse().unwrap() })
}

#[test]
fn what_is_printed_are_the_two_parts() {
    for (x, text) in [
        (DoubleDouble::new(0.1, 1.3e-18), "0.1+1.3e-18"),
        (DoubleDouble::new(-4.7e-200, -1.1e-217), "-4.7e-200-1.1e-217"),
        (DoubleDouble::from_f64(1.75), "1.75"),
        (DoubleDouble::from_f64(f64::NEG_INFINITY), "-inf"),
        (DoubleDouble::from_f64(f64::NAN), "NaN"),
    ] {
        assert_eq!(x.to_string(), text);
    }
}

proptest! {
    #![proptest_config(cases(1000))]

    #[test]
    fn what_is_written_reads_back_to_the_same_bits(x in numbers(-900..1023, true)) {
        assert_eq!(read(&x.to_string()), x);
        let json: serde_json::Value =
            serde_json::from_str(&serde_json::to_string(&x).unwrap()).unwrap();
        let part = |name| json[name].as_f64().unwrap();
        assert_eq!((part("hi"), part("lo")), (x.hi(), x.lo()));
    }
}

#[test]
fn a_trace_has_both_parts_of_every_number_and_names_what_is_not_finite() {
    let v = [DoubleDouble::new(0.1, 1.3e-18), DoubleDouble::from_f64(-2.7)];
    let event = Event {
        place: Place { step: 7, fibre: Fibre::Primary, index: 12 },
        equation: 4,
        inputs: &[("v", Value::Vector(&v))],
        output: Value::Scalar(DoubleDouble::from_f64(-1.3) / DoubleDouble::zero()),
    };
    assert_eq!(
        serde_json::to_string(&event).unwrap(),
        "{\"step\":7,\"fibre\":\"primary\",\"index\":12,\"eq\":\"4\",\
         \"in\":{\"v\":[{\"hi\":0.1,\"lo\":1.3e-18},{\"hi\":-2.7,\"lo\":0.0}]},\"out\":\"-inf\"}"
    );
}
