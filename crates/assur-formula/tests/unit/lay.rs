use assur_formula::{Equation, Expr, Name, Unit, quantity, text_lines};

fn of(letter: &str, value: f64, unit: Unit) -> Expr {
    quantity(Name::new(letter, ""), value, unit)
}

fn line(value: f64, unit: Unit, right: Expr) -> String {
    text_lines(&Equation::new(Name::new("z", ""), value, unit, right).lines())
}

#[test]
fn negative_numbers_after_an_operator_are_in_brackets() {
    let (a, b) = (of("a", -1.5, Unit::Force), of("b", -2.0, Unit::Force));
    let sum = line(-3.5, Unit::Force, a.clone() + b.clone());
    assert_eq!(sum, "z = a + b = −1.5000 + (−2.0000) = −3.5000 N");
    let difference = line(0.5, Unit::Force, a.clone() - b.clone());
    assert_eq!(difference, "z = a − b = −1.5000 − (−2.0000) = 0.5000 N");
    let product = line(3.0, Unit::Force, a * b);
    assert_eq!(product, "z = a b = −1.5000·(−2.0000) = 3.0000 N");
}

#[test]
fn negative_bases_and_angles_are_in_brackets() {
    let a = of("a", -3.0, Unit::Length);
    assert_eq!(line(9.0, Unit::Area, a.squared()), "z = a² = (−3.0000)² = 9.0000 m²");
    let phi = of("φ", -30.0, Unit::Angle);
    assert_eq!(line(-0.5, Unit::One, phi.sin()), "z = sin φ = sin(−30.000°) = −0.50000");
}

#[test]
fn sums_in_products_are_in_brackets() {
    let (a, b, c) = (of("a", 1.0, Unit::One), of("b", 2.0, Unit::One), of("c", 3.0, Unit::One));
    assert_eq!(line(9.0, Unit::One, (a + b) * c), "z = (a + b) c = (1.0000 + 2.0000)·3.0000 = 9.0000");
}
