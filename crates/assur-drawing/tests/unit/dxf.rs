use assur_drawing::{Drawing, Dxf, Label, Role, Shape, Style, Text};
use assur_math::math::Vec2;

/// The values behind a code.
fn values(dxf: &str, code: &str) -> Vec<String> {
    let lines: Vec<&str> = dxf.split_terminator("\r\n").collect();
    lines.chunks(2).filter(|pair| pair[0].trim() == code).map(|pair| pair[1].to_owned()).collect()
}

#[test]
fn layers_have_allowed_names_and_no_two_have_one() {
    let mut dxf = Dxf::new();
    let long = "link_".to_owned() + &"x".repeat(40);
    for of in [
        "link_rod",
        "link_Rod",
        "link_rod",
        "link_стержень",
        "link_ω",
        long.as_str(),
        &(long.clone() + "y"),
        "",
    ] {
        let pen = dxf.pen(of, Role::Blue, "1.6 1");
        dxf.shape(pen, &Shape::Line(Vec2::zero(), Vec2::new(1.0, 2.0)));
    }
    let text = dxf.finish();
    let x = |n: usize| format!("LINK_{}", "X".repeat(n));
    let used =
        ["LINK_ROD", "LINK_ROD_2", "LINK_ROD", "LINK_________", "LINK_OMEGA", &x(26), &(x(24) + "_2"), "_"];
    assert_eq!(values(&text, "8"), used);
    assert_eq!(values(&text, "20")[0], "0.0");
    assert_eq!(values(&text, "21")[0], "-2.0");
    assert!(text.is_ascii() && values(&text, "6").contains(&"DASHED".to_owned()), "{text}");
}

#[test]
fn texts_have_signs_that_every_reader_has() {
    let said = |text: Text| {
        let mut drawing = Drawing::new("a", String::new(), String::new());
        drawing.line(Style::Link, Vec2::zero(), Vec2::new(50.0, 0.0));
        drawing.label(Label::at(text, 4.0, Vec2::zero(), 0.5));
        values(&drawing.placed().dxf(), "1").pop().unwrap_or_default()
    };
    for (text, wanted) in [
        (Text::name("omega2"), "omega_2"),
        (Text::upright("φ = 30°"), "phi = 30%%d"),
        (Text::upright("⌀20 ± 1 µm"), "%%c20 %%p 1 um"),
        (Text::upright("2·10⁻³ m/s²"), "2*10^ -3 m/s^ 2"),
        (Text::name("B'"), "B'"),
        (Text::upright("вал"), "\\U+0432\\U+0430\\U+043B"),
    ] {
        assert_eq!(said(text), wanted);
    }
}

/// What has no place is left out, and no number stops the writer.
#[test]
fn shapes_without_a_place_are_left_out() {
    let mut dxf = Dxf::new();
    let pen = dxf.pen("a", Role::Ink, "");
    let nowhere = Vec2::new(f64::NAN, 0.0);
    for shape in [
        Shape::Line(nowhere, Vec2::zero()),
        Shape::Circle { centre: Vec2::zero(), radius: f64::INFINITY },
        Shape::Lines { points: Vec::new(), closed: true },
    ] {
        dxf.shape(pen, &shape);
    }
    assert_eq!(values(&dxf.finish(), "8"), Vec::<String>::new());
}
