use assur_formula::{
    Equation, Expr, Function, Lines, Name, Unit, latex_lines, mathml_lines, quantity, rounded, text_lines,
    typst_lines,
};

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
    assert!(page.contains("<mn>2.7349</mn><mtext>\u{a0}m/s²</mtext>"), "{page}");
}

#[test]
fn functions_are_set_apart_and_brackets_are_as_tall_as_what_they_hold() {
    let [phi, a, b] = ["φ", "a", "b"].map(|letter| quantity(Name::new(letter, ""), 2.0, Unit::Angle));
    let of = |right: Expr| {
        mathml_lines(&Equation::new(Name::new("x", ""), right.value(), Unit::One, right).lines())
    };
    let thin = "<mspace width=\"0.17em\"/>";
    let cosine = of(a.clone() * phi.cos());
    assert!(
        cosine.contains(&format!("<mo>\u{2062}</mo>{thin}<mrow><mi mathvariant=\"normal\">cos</mi>")),
        "{cosine}"
    );
    assert!(cosine.contains(&format!("<mo>\u{2061}</mo>{thin}<mrow><mi>φ</mi></mrow>")), "{cosine}");
    let ratio = of((a / b).of(Function::Arctan));
    assert!(ratio.contains("<mo class=\"tall\" style=\"--tall:2.1\">(</mo>"), "{ratio}");
}

#[test]
fn a_number_without_letters_is_rounded_among_letters_and_balances() {
    let omega = quantity(Name::new("ω", ""), 7.216_77, Unit::AngularVelocity);
    let right = Expr::Int(80) - rounded(80.0 / 157.079_632_68) * omega;
    let lines = Equation::new(Name::new("M", ""), right.value(), Unit::Torque, right).lines();
    assert_eq!(text_lines(&lines), "M = 80 − 0.50930 ω = 80 − 0.50930·7.2168 = 76.325 N·m");
}

#[test]
fn what_is_too_wide_for_a_line_opens_its_brackets_and_its_fraction() {
    let letters = ["a", "b", "c", "d", "e", "f", "g", "h", "i", "j"];
    let sum = Expr::sum(letters.map(|letter| quantity(Name::new(letter, ""), 1.234_56, Unit::Length)));
    let below = quantity(Name::new("k", ""), 2.5, Unit::Length);
    let right = Expr::Int(2) * sum.clone() * sum / below;
    let lines = Equation::new(Name::new("x", ""), right.value(), Unit::Length, right).lines();
    assert!(lines.fit() == 1.0 && lines.rows.len() > 3, "{lines:?}");
    let text = text_lines(&lines);
    let brackets = |sign| text.matches(sign).count();
    assert!(brackets('(') == brackets(')') && text.contains(") / 2.5000"), "{text}");
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

#[test]
fn units_are_in_cyrillic_where_they_are_units() {
    let of = assur_formula::units_in_cyrillic;
    assert_eq!(of("0,1 m"), "0,1 м");
    assert_eq!(of("0,04 kg·m²; 9,81 m/s²"), "0,04 кг·м²; 9,81 м/с²");
    assert_eq!(of(", rad/s"), ", рад/с");
    assert_eq!(of(" [N·m]"), " [Н·м]");
    assert_eq!(of("1500 rpm"), "1500 об/мин");
    assert_eq!(of(" = 0,1 (m/s²)/mm"), " = 0,1 (м/с²)/мм");
    assert_eq!(of("10³ N·m"), "10³ Н·м");
    assert_eq!(of("0 °/s"), "0 °/с");
    assert_eq!(of(", °/s"), ", °/с");
    assert_eq!(of("= 7,8e−12 N"), "= 7,8e−12 Н");
    assert_eq!(of("1/m"), "1/м");
    let header = assur_formula::header_in_cyrillic;
    assert_eq!(header("M_r, N·m"), "M_r, Н·м");
    assert_eq!(header("N [kN]"), "N [кН]");
    assert_eq!(header("N"), "N");
    // names are no units
    assert_eq!(of("звено m"), "звено m");
    assert_eq!(of("N"), "N");
    assert_eq!(of("A, N"), "A, N");
    assert_eq!(of("N–K"), "N–K");
    assert_eq!(of("t1–b1–t2"), "t1–b1–t2");
    assert_eq!(of("2, N"), "2, N");
    assert_eq!(of("link t1 N"), "link t1 N");
    assert_eq!(of("3 rods"), "3 rods");
    assert_eq!(of("2 N_x"), "2 N_x");
}
