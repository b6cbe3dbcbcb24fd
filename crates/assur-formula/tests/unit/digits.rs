use assur_formula::{Equation, Expr, Figures, Name, Unit, quantity, with_decimals, with_digits};

fn of(letter: &str, value: f64) -> Expr {
    quantity(Name::new(letter, ""), value, Unit::Length)
}

#[test]
fn numbers_have_their_significant_digits() {
    assert_eq!(with_digits(0.05, 5).text(), "0.050000");
    assert_eq!(with_digits(-8141.019, 5).text(), "−8141.0");
    assert_eq!(with_digits(9.99999, 3).text(), "10.0");
    assert_eq!(with_digits(2.5e-7, 5).text(), "2.5000·10⁻⁷");
    assert_eq!(with_digits(1.23456e9, 5).text(), "1.2346·10⁹");
    assert_eq!(with_decimals(-0.001, 2).text(), "0.00");
}

#[test]
fn a_number_has_the_value_that_is_read_from_it() {
    for x in [0.049_029, -3.019_268_5, 1.2e-9, 7.7e12, 360.0] {
        let figures = with_digits(x, 6);
        assert!((figures.value() - x).abs() <= 0.5001 * figures.last_digit(), "{figures:?}");
    }
    assert_eq!(Figures::whole(-3).value(), -3.0);
}

#[test]
fn a_sum_that_cancels_has_the_digits_of_its_largest_term() {
    let set =
        Equation::new(Name::new("z", ""), -3.897, Unit::Length, of("a", 30.723) - of("b", 34.620)).set();
    assert_eq!(set.result.text(), "−3.897");
    assert!(!set.approximate);
}

#[test]
fn operands_get_more_digits_until_the_equation_balances() {
    let (a, b) = (1.000_004_4, 1.000_000_1);
    let right = (of("a", a) - of("b", b)) * of("c", 1e5);
    let set = Equation::new(Name::new("z", ""), (a - b) * 1e5, Unit::Length, right).set();
    assert!(!set.approximate);
    let numbers = assur_formula::text(&set.numbers.expect("numbers"));
    assert!(numbers.contains("1.0000044"), "{numbers}");
}

#[test]
fn rounding_is_nothing() {
    let right = of("a", 0.3) - of("b", 0.1 + 0.2);
    let equation = Equation::new(Name::new("z", ""), -5.6e-17, Unit::Length, right);
    assert_eq!(equation.set().result.text(), "0.00000");
    assert_eq!(equation.disagrees(), None);
}

#[test]
fn a_wrong_value_disagrees() {
    let equation = Equation::new(Name::new("z", ""), 3.000_001, Unit::Length, of("a", 1.0) + of("b", 2.0));
    assert!(equation.disagrees().is_some());
}
