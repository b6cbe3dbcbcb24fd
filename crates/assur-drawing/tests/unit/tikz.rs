use assur_drawing::{Drawing, Label, Shape, Style, Text, Theme};
use assur_math::math::Vec2;

/// The text of a label of a picture.
fn said(text: Text) -> String {
    let mut drawing = Drawing::new("a", String::new(), String::new());
    drawing.line(Style::Link, Vec2::zero(), Vec2::new(50.0, 0.0));
    drawing.label(Label::at(text, 4.0, Vec2::zero(), 0.5));
    let tikz = drawing.placed().tikz(Theme::Auto);
    let node = tikz.lines().find(|line| line.starts_with("\\node")).expect("a label");
    let begin = node.find(") {").expect("a text") + 3;
    node[begin..].trim_end_matches("};").to_owned()
}

#[test]
fn labels_are_maths() {
    for (text, wanted) in [
        (Text::name("omega2"), "$\\omega _{2}$"),
        (Text::name("v_F"), "$v_{\\mathrm{F}}$"),
        (Text::name("B'"), "$B'$"),
        (Text::name("rod"), "$\\mathit{rod}$"),
        (Text::name("Mb"), "$M_{\\mathrm{b}}$"),
        (Text::upright("10 % of {a_b} & #1"), "10 \\% of \\{a\\_b\\} \\& \\#1"),
        (Text::upright("−2 m/s²"), "$-$2 m/s$^{2}{}$"),
        (Text::upright("2·10⁻³"), "2$\\cdot $10$^{-3}$"),
        (Text::upright("ва"), "\\assurletter{0432}{^^d0^^b2}\\assurletter{0430}{^^d0^^b0}"),
        (Text::italic("a").lowered("1").lowered("2"), "$a_{1}{}_{2}$"),
    ] {
        assert_eq!(said(text), wanted);
    }
}

#[test]
fn only_what_is_drawn_has_a_style() {
    let mut drawing = Drawing::new("a", "A \n\\end{x} ω".to_owned(), String::new());
    drawing.mark(Style::VelocityPart, Shape::Arrow(Vec2::zero(), Vec2::new(0.0, 10.0)));
    drawing.mark(Style::Way, Shape::Circle { centre: Vec2::new(f64::NAN, 0.0), radius: 1.0 });
    let text = drawing.placed().tikz(Theme::Mono);
    assert!(text.starts_with("% A ?\\end{x} ?\n"), "{text}");
    assert!(text.contains("assur velocity part/.style={draw=assurBlue, line width=0.3mm}"), "{text}");
    assert!(text.contains("\\path[assur velocity part head] (0,-10) --"), "{text}");
    assert!(!text.contains("assur link") && !text.contains("NaN"), "{text}");
}
