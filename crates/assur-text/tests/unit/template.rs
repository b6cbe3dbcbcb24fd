//! A text with numbers between its pieces.

use assur_text::units::{Columns, Template};

/// The lines of a template for some columns.
fn filled(template: &Template, numbers: &[f64], lines: usize) -> Vec<String> {
    let columns = Columns { numbers, lines };
    let line = |i| {
        let mut out = b"> ".to_vec();
        template.pieces(columns).fill(columns, i, &mut out);
        String::from_utf8(out).expect("text")
    };
    (0..lines).map(line).collect()
}

#[test]
fn numbers_are_as_serde_json_writes_them() {
    let long = "a piece that is longer than the most that is copied at once";
    let template = Template::of(["x ", long, " ", "."].into_iter(), &[1.0, 2.0, 3.0], 3, |_| false);
    let numbers = [0.1 + 0.2, -0.0, 1e300, f64::MIN_POSITIVE, -f64::MIN_POSITIVE, 30.0];
    let want = [
        format!("> x 0.30000000000000004{long}1e+300 -2.2250738585072014e-308."),
        format!("> x 0.0{long}2.2250738585072014e-308 30.0."),
    ];
    assert_eq!(filled(&template, &numbers, 2), want);
}

#[test]
fn steady_numbers_are_written_where_they_change() {
    let template = Template::of(["", " ", " ", ""].into_iter(), &[1.0, 2.5, 4.0], 2, |i| i == 0);
    assert_eq!(filled(&template, &[1.0, 1.0, 7.0, 8.0], 2), ["> 1.0 7.0 4.0", "> 1.0 8.0 4.0"]);
    assert_eq!(filled(&template, &[1.0, 3.0, 7.0, 8.0], 2), ["> 1.0 7.0 4.0", "> 3.0 8.0 4.0"]);
}

#[test]
fn numbers_that_were_the_same_may_differ() {
    let template = Template::of(["", " ", ""].into_iter(), &[0.5, 0.5], 2, |_| false);
    assert_eq!(
        filled(&template, &[1.5, 0.0, 2.5, 1.5, -0.0, 3.5], 3),
        ["> 1.5 1.5", "> 0.0 0.0", "> 2.5 3.5"]
    );
}

#[test]
fn lines_have_any_number_of_numbers() {
    let example: Vec<f64> = (0..1000).map(|i| f64::from(i % 7)).collect();
    let pieces = std::iter::once("").chain(std::iter::repeat_n(" ", 999)).chain(std::iter::once(""));
    let template = Template::of(pieces, &example, 1000, |_| false);
    let want: Vec<String> = example.iter().map(|x| format!("{x:?}")).collect();
    assert_eq!(filled(&template, &example, 1), [format!("> {}", want.join(" "))]);
}
