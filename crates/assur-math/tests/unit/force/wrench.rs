//! Force and moment about a point.

use assur_math::force::Wrench;
use assur_math::math::Vec2;

#[test]
fn transport_there_and_back() {
    let (F, r) = (Vec2::new(3.0, -2.0), Vec2::new(0.5, 4.0));
    let w = Wrench::at(F, r);
    assert_eq!(w.M, -13.0);
    assert_eq!(w.about(r), Wrench { F, M: 0.0 });
    assert_eq!(w.about(r).about(-r), w);
    assert_eq!(Wrench { F: Vec2::new(3.0, 4.0), M: -10.0 }.arm(), 2.0);
}

#[test]
fn power_does_not_depend_on_the_reference_point() {
    let (F, r) = (Vec2::new(3.0, -2.0), Vec2::new(0.5, 4.0));
    let (w, v, omega) = (Wrench { F, M: 7.0 }, Vec2::new(1.0, -1.0), 2.0);
    let moved = w.about(r).power(v + r.perp() * omega, omega);
    assert_eq!(moved, w.power(v, omega));
    let none = w - w + Wrench::zero() + (-w + w);
    assert_eq!(none, Wrench::zero());
}
