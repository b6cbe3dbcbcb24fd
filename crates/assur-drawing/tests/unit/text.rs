use assur_drawing::{Level, Text};

/// Letters with what is lowered behind `_` and raised behind `^`.
fn read(text: &Text) -> String {
    let run = |r: &assur_drawing::Run| match r.level {
        Level::Base => r.letters.clone(),
        Level::Sub => format!("_{}", r.letters),
        Level::Sup => format!("^{}", r.letters),
    };
    text.runs.iter().map(run).collect()
}

#[test]
fn names_become_letters_with_indices() {
    let of = |name: &str| read(&Text::name(name));
    assert_eq!(of("S2"), "S_2");
    assert_eq!(of("v_F"), "v_F");
    assert_eq!(of("phi1"), "φ_1");
    assert_eq!(of("l_AB"), "l_AB");
    assert_eq!(of("B'"), "B′");
    assert_eq!(of("Mb"), "M_b");
    assert_eq!(of("O"), "O");
    assert_eq!(of("铰链2"), "铰链_2");
    assert_eq!(of("12"), "12");
}

#[test]
fn long_names_are_shortened_and_said_in_full() {
    let name = "a".repeat(200);
    let text = Text::name(&name);
    assert!(text.bounds(4.0).size().x < 60.0);
    assert_eq!(text.plain(), name);
}

#[test]
fn widths_are_of_the_table() {
    // A of Times is 0.722 em, a Chinese sign one em
    assert!((Text::upright("A").bounds(10.0).size().x - 7.22).abs() < 0.01);
    assert!((Text::upright("铰").bounds(10.0).size().x - 10.0).abs() < 1e-12);
    // an exponent and an index share their place
    let stacked = Text::italic("a").raised("t").lowered("FB");
    let one = Text::italic("a").lowered("FB");
    assert!((stacked.bounds(4.0).size().x - one.bounds(4.0).size().x).abs() < 1e-12);
}

/// Fonts have ² and no ⁻⁸.
#[test]
fn exponents_are_raised_digits() {
    let text = Text::upright("μ = 10⁻⁸ m/s² and 4·10⁶");
    assert_eq!(read(&text), "μ = 10^−8 m/s² and 4·10^6");
    assert_eq!(text.plain(), "μ = 10⁻⁸ m/s² and 4·10⁶");
    assert_eq!(read(&Text::upright("a²b")), "a²b");
}
