use assur_formula::{Expr, Name, Unit, quantity};

fn x() -> Expr {
    quantity(Name::new("x", "B"), 2.0, Unit::Length)
}

#[test]
fn what_is_nothing_is_left_out() {
    assert_eq!(x() + Expr::ZERO, x());
    assert!((x() * Expr::ZERO).is_zero());
    assert!((x() - x()).is_zero());
    assert_eq!(x() * Expr::Int(1), x());
    assert!((Expr::ZERO / x()).is_zero());
}

#[test]
fn what_is_added_and_taken_off_again_is_not_there() {
    let y = quantity(Name::new("y", "B"), 3.0, Unit::Length);
    assert_eq!(x() + y.clone() - x(), y);
    assert_eq!(y.clone() - x() + x(), y);
}

#[test]
fn signs_go_before_products_and_fractions() {
    assert_eq!(-x() * -x(), x() * x());
    assert_eq!((-x()) / x(), -(x() / x()));
    assert_eq!(-(-x()), x());
}

#[test]
fn functions_of_right_angles_are_whole() {
    assert_eq!(Expr::Degrees(90).cos(), Expr::ZERO);
    assert_eq!(Expr::Degrees(-90).sin(), Expr::Int(-1));
    assert_eq!(Expr::Degrees(180).cos(), Expr::Int(-1));
}
