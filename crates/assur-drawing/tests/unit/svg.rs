use assur_drawing::{Drawing, Label, Shape, Style, Text, Theme, escaped, number};
use assur_math::math::Vec2;

#[test]
fn numbers_have_two_decimals_at_most() {
    let all = [(0.0, "0"), (-0.001, "0"), (1.5, "1.5"), (12.346, "12.35"), (-3.0, "-3"), (100.0, "100")];
    for (x, text) in all {
        assert_eq!(number(x), text);
    }
}

#[test]
fn signs_of_the_document_are_escaped() {
    assert_eq!(escaped("a<b & \"c\"\u{1}"), "a&lt;b &amp; &quot;c&quot;");
}

#[test]
fn only_what_is_drawn_has_rules() {
    let mut drawing = Drawing::new("a b", "A line".to_owned(), "One line.".to_owned());
    drawing.begin("link", "x<y");
    drawing.line(Style::Link, Vec2::zero(), Vec2::new(10.0, 0.0));
    drawing.mark(Style::Force, Shape::Arrow(Vec2::zero(), Vec2::new(0.0, 10.0)));
    drawing.label(Label::at(Text::name("S2"), 4.0, Vec2::new(10.0, 0.0), 0.5));
    let text = drawing.placed().svg(Theme::Auto);
    assert!(text.contains("id=\"a-b-t\"") && text.contains(r#"data-name="x&lt;y""#), "{text}");
    assert!(
        text.contains(".fig .l{") && text.contains(".fig .f.head{") && !text.contains(".fig .h{"),
        "{text}"
    );
    assert!(text.contains(r#"aria-label="S_2""#) && text.contains("textLength"), "{text}");
}
