//! What a mistyped name was meant to be.

/// The known name that differs by the fewest edits, if that is at most a third of its letters;
/// capitals do not count.
pub fn nearest<'a>(name: &str, known: &[&'a str]) -> Option<&'a str> {
    let name = name.to_lowercase();
    let (edits, best) = known.iter().map(|known| (edits(&name, known), *known)).min()?;
    (edits <= best.chars().count().div_ceil(3)).then_some(best)
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
