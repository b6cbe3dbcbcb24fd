//! Numbers between the pieces of a text.

use assur_text::units::Template;

#[test]
fn numbers_stand_between_pieces() {
    let pieces = ["x ", "; y ", ", ", "."].map(str::to_owned);
    let template = Template::of(&pieces, &[4.0]);
    let mut out = b"> ".to_vec();
    template.fill(&[1.0, -0.0], &mut out);
    assert_eq!(String::from_utf8(out).unwrap_or_default(), "> x 1.0; y 0.0, 4.0.");
}
