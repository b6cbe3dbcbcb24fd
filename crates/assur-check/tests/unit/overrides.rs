//! Values from outside as text.

use assur_check::parts::value;
use assur_check::parts::{Type, Typed};
use assur_text::units::Dimension;

#[test]
fn values_with_and_without_blanks() {
    for (text, si) in [("120mm", 0.12), ("-30 mm", -0.03), ("1.5e2 cm", 1.5), ("−2 m", -2.0), ("0", 0.0)] {
        let t = value("r", text, Type::number(Dimension::LENGTH), "mm").unwrap();
        assert_eq!(t, Typed::constant(si, Dimension::LENGTH), "{text}");
    }
}

#[test]
fn what_is_wrong_is_said() {
    let length = Type::number(Dimension::LENGTH);
    for (text, says) in [
        ("120", "needs a unit"),
        ("2 kg", "a mass"),
        ("2 mn", "not a unit"),
        ("mm", "not a number"),
        ("1,5 mm", "decimal point"),
        ("1,500 mm", "thousands"),
    ] {
        let (why, _) = value("r", text, length, "mm").unwrap_err();
        assert!(why.contains(says), "{text}: {why}");
    }
}
