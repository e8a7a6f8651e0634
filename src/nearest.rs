//! What a mistyped name was meant to be.

/// The known name that differs by the fewest edits, if that is at most a third of its letters;
/// capitals do not count.
pub fn nearest<'a>(name: &str, known: &[&'a str]) -> Option<&'a str> {
    let name = name.to_lowercase();
    let (edits, best) = known.iter().map(|known| (edits(&name, known), *known)).min()?;
    (edits <= best.chars().count().div_ceil(3)).then_some(best)
}

/// The question after a name that is not known; nothing where no known one is near.
pub fn did_you_mean(name: &str, known: &[&str]) -> String {
    nearest(name, known).map_or_else(String::new, |meant| format!(", did you mean `{meant}`?"))
}

/// Letters to insert, remove or replace to turn one name into the other (Levenshtein's distance).
fn edits(a: &str, b: &str) -> usize {
    let b: Vec<char> = b.chars().collect();
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, x) in a.chars().enumerate() {
        let mut diagonal = row[0];
        row[0] = i + 1;
        for (j, &y) in b.iter().enumerate() {
            let replaced = diagonal + usize::from(x != y);
            diagonal = row[j + 1];
            row[j + 1] = replaced.min(row[j] + 1).min(diagonal + 1);
        }
    }
    row[b.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn edits_are_letters_that_are_missing_too_many_or_others() {
        for (a, b, expected) in [
            ("", "", 0),
            ("", "fibre", 5),
            ("fibre", "", 5),
            ("kitten", "sitting", 3),
            ("xfibre", "fibre", 1),
            ("fibre", "fibrex", 1),
            ("density", "dnesity", 2),
            ("abc", "xyz", 3),
        ] {
            assert_eq!((edits(a, b), edits(b, a)), (expected, expected), "{a} {b}");
        }
    }

    #[test]
    fn nearest_is_known_by_two_thirds_of_its_letters() {
        let known = ["area", "courant", "density"];
        assert_eq!(nearest("DENSTY", &known), Some("density"));
        assert_eq!(nearest("couXXXt", &known), Some("courant"));
        assert_eq!(nearest("coXXXXt", &known), None);
        assert_eq!(nearest("are", &[]), None);
        assert_eq!(did_you_mean("DENSTY", &known), ", did you mean `density`?");
        assert_eq!(did_you_mean("coXXXXt", &known), "");
    }
}
