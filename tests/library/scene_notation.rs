//! Scenes as people write them: with comments, with a schema for their editor, and with what belongs to
//! another notation.

use crossfibre::scene_file::read;

/// Comments, of which one looks like a string, and strings with two slashes.
const GOOD: &str = r#"// µ "
{ // "format": "crossfibre-scene/7",
  "$schema": "https://nowhere/scene.schema.json",
  "format": "crossfibre-scene/1",
  "title": "a // b \" // c",
  "primary": { "length": 0.287, // 287 mm
    "elements": 139, "density": 1443.0, "area": 0.87e-6,
    "material": { "law": "linear", "modulus": 71.3e9 } },
  // "secondary": {},
  "projectile": { "velocity": 317.0 },
  "courant": 0.937, "duration": 31.3e-6 }
// the end"#;

#[test]
fn comments_and_a_schema_are_no_part_of_a_scene() {
    let scene = read(GOOD).unwrap();
    assert_eq!(scene.title, "a // b \" // c");
    assert!(scene.secondary.is_none());
    // Places are those of the file, and what the span names is what is wrong.
    let bad = GOOD.replace("139", "-139");
    let fault = read(&bad).unwrap_err();
    assert_eq!((fault.line, fault.column, &bad[fault.span]), (7, 17, "-139"));
    let bad = GOOD.replace("\"https://nowhere/scene.schema.json\"", "[1]");
    let fault = read(&bad).unwrap_err();
    assert_eq!((fault.path.as_str(), fault.line, fault.column), ("$schema", 3, 14));
    assert_eq!(read("// nothing else").unwrap_err().message, "the text is empty");
    let inside = GOOD.replace("\"velocity\"", "\"$schema\": \"\", \"velocity\"");
    assert_eq!(read(&inside).unwrap_err().path, "projectile.$schema");
}

/// What is replaced in the good scene, by what; where the fault is shown, and part of the help.
#[rustfmt::skip] // a case a line
const OTHERWISE: &[(&str, &str, &str, &str)] = &[
    ("0.287,", "0.287 m,", "m", "numbers stand alone, in SI units"),
    ("0.287", "\"287 mm\"", "\"287 mm\"", "write the number alone, in SI units"),
    ("0.287", "\"0.287\"", "\"0.287\"", "write the number without quotation marks"),
    ("0.287", "0,287", "2", "decimals stand behind a point"),
    ("0.287", ".287", ".", "a number begins with a digit"),
    ("0.287", "+0.287", "+", "a number begins with a digit"),
    ("0.287", "287e", "e", "a number is written like"),
    ("139,", "139", "\"", "is a comma missing before this?"),
    ("\"courant\"", "courant", "courant", "names stand in double quotes"),
    ("\"courant\"", "'courant'", "'", "stand in double quotes"),
    ("\"linear\"", "linear", "linear", "words stand in double quotes"),
    ("\"courant\"", "/* here */ \"courant\"", "/", "from // to the end of the line"),
    ("\"courant\"", "# here\n \"courant\"", "#", "from // to the end of the line"),
    ("\"courant\":", "\"courant\" =", "=", "set apart by a colon"),
    ("139,", "139;", ";", "set apart by a comma"),
    ("31.3e-6 }", "31.3e-6, }", "}", "leave out the comma before this"),
    ("31.3e-6 }", "31.3e-6", "", "is not closed"),
    ("31.3e-6 }", "31.3e-6 }}", "}", "is a bracket too many?"),
    ("\"projectile\": {", "\"projectile\": {{", "{", "one too many"),
    ("\"courant\"", "\"Courant\"", "\"Courant\"", "known here: format"),
    ("\"linear\", \"modulus\"", "\"linear\" modulus", "modulus", "is a comma missing before this?"),
    ("\"courant\"", "3 \"courant\"", "3", "decimals stand behind a point"),
    ("{ \"velocity\"", "{ 3 \"velocity\"", "3", "names stand in double quotes"),
    ("\"courant\"", "$courant", "$", "names stand in double quotes"),
    ("\"projectile\": {", "\"projectile\" {", "{", "set apart by a colon"),
    ("\"linear\",", "\"linear 1,\n", "\"linear 1,", "is a quotation mark missing?"),
    ("\"linear\"", "\"linear\tlaw\"", "", "a tab is written \\t"),
    ("\"law\"", "\"tension_only\": \"no\", \"law\"", "\"no\"", "write true or false"),
    ("\"courant\":", "\"courant\": =", "=", "set apart by a colon"),
    ("31.3e-6 }", "31.3e-6 } {", "{", "the scene ends before this"),
    ("\"courant\"", "\ncourant", "courant", "names stand in double quotes"),
    ("0.937", "", ",", ""),
    ("317.0", "true", "true", ""),
    (GOOD, "<html>", "<", "`crossfibre new` writes one"),
    (GOOD, "primary:\n  length: 0.287", "p", "`crossfibre new` writes one"),
    (GOOD, "\n[primary]\nlength = 0.287", "[", "`crossfibre new` writes one"),
];

#[test]
fn another_notation_is_answered_in_plain_words() {
    for &(from, to, piece, help) in OTHERWISE {
        assert!(GOOD.contains(from), "{from:?} is not in the good scene");
        let text = GOOD.replacen(from, to, 1);
        let fault = read(&text).expect_err(to);
        let (seen, found) = (fault.help.clone().unwrap_or_default(), &text[fault.span.clone()]);
        assert!(seen.contains(help) && seen.is_empty() == help.is_empty(), "{to:?} gives: {fault}");
        assert!(found.starts_with(piece), "{to:?} is shown at {found:?}: {fault}");
    }
}

#[test]
fn a_name_in_capitals_is_recognised() {
    let fault = read(&GOOD.replace("\"courant\"", "\"Courant\"")).unwrap_err();
    assert_eq!(fault.message, "unknown field `Courant`, did you mean `courant`?");
    let fault = read(&GOOD.replace("\"linear\"", "\"LINEAR\"")).unwrap_err();
    assert_eq!(fault.message, "unknown name `LINEAR`, did you mean `linear`?");
}

#[test]
fn brackets_without_end_are_told_as_that() {
    let fault = read(&GOOD.replace("139", &"[".repeat(1000))).unwrap_err();
    assert_eq!(fault.message, "brackets in brackets without end");
}
