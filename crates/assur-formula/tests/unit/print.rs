use assur_formula::{Equation, Expr, Lines, Name, Unit, latex_lines, mathml_lines, quantity, typst_lines};

fn lines() -> Lines {
    let omega = quantity(Name::new("ω", "2"), -3.0193, Unit::AngularVelocity);
    let length = quantity(Name::new("l", "BC"), 0.3, Unit::Length);
    let right: Expr = omega.squared() * length;
    Equation::new(Name::new("a", "CB").marked("n"), 3.0193 * 3.0193 * 0.3, Unit::Acceleration, right).lines()
}

#[test]
fn latex() {
    assert_eq!(
        latex_lines(&lines()),
        "a_{\\mathrm{CB}}^{\\mathrm{n}} = \\omega_{\\mathrm{2}}^{2}\\,l_{\\mathrm{BC}} = {\\left(-3.0193\\right)}^{2} \\cdot 0.30000 = 2.7349\\,\\mathrm{m/s^2}"
    );
}

#[test]
fn mathml() {
    let page = mathml_lines(&lines());
    assert!(page.starts_with("<math displaystyle=\"true\"><mrow><msubsup><mi>a</mi>"), "{page}");
    assert!(page.contains("<msubsup><mi>ω</mi><mn>2</mn><mn>2</mn></msubsup>"), "{page}");
    assert!(page.contains("<mn>2.7349</mn><mtext>\u{202f}m/s²</mtext>"), "{page}");
}

#[test]
fn typst() {
    let words = typst_lines(&lines());
    assert!(words.contains("a_\"CB\"^\"n\"  & = ω_\"2\"^2 thin l_\"BC\""), "{words}");
}

#[test]
fn commas() {
    assert!(mathml_lines(&lines().with_commas()).contains("<mn>2,7349</mn>"));
    assert!(latex_lines(&lines().with_commas()).contains("2{,}7349"));
}
