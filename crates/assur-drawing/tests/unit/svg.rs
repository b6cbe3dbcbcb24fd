use assur_drawing::{Drawing, Label, Shape, Style, Text, Theme, escaped, number};
use assur_math::math::Vec2;

#[test]
fn numbers_have_two_decimals_at_most() {
    let all = [(0.0, "0"), (-0.001, "0"), (1.5, "1.5"), (12.346, "12.35"), (-3.0, "-3"), (100.0, "100")];
    for (x, text) in all {
        assert_eq!(number(x).to_string(), text);
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

/// Numbers are written from whole hundredths where their digits do not matter, and as the formatter writes them.
#[test]
fn numbers_have_the_digits_of_the_formatter() {
    let formatted = |x: f64| {
        let text = format!("{x:.2}");
        let text = text.trim_end_matches('0').trim_end_matches('.').to_owned();
        if text == "-0" { "0".to_owned() } else { text }
    };
    let mut seed = 1_u64;
    for i in 0..100_000 {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        let part = (seed >> 11) as f64 / (1_u64 << 53) as f64 - 0.5;
        let sizes = [1e-3, 1.0, 200.0, 1e5, 1e8, 1e10, 1e13];
        // some of them halves of a hundredth
        let rounded = if i % 3 == 0 { (part * 2e5).round() / 200.0 } else { part };
        let x = rounded * sizes[i % sizes.len()];
        assert_eq!(number(x).to_string(), formatted(x), "{x:?}");
    }
    for x in [0.0, -0.0, 0.005, -0.005, 0.015, 0.125, 0.375, -0.004_999, 99.995, 999_999_999.995, 1e9, -1e300]
    {
        assert_eq!(number(x).to_string(), formatted(x), "{x:?}");
    }
}
