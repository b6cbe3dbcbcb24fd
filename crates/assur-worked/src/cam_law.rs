//! The formulas of the laws of cams.

use assur_formula::{Expr, Function, Name, Unit, quantity};
use assur_math::element::cam::Law;
use assur_math::math::SAME;

/// The greatest acceleration of a modified law.
pub fn greatest_acceleration(law: Law) -> Expr {
    let int = Expr::Int;
    if law == Law::ModifiedSine {
        int(4) * Expr::Pi.squared() / (int(4) + Expr::Pi)
    } else {
        int(8) * Expr::Pi / (int(2) + Expr::Pi)
    }
}

/// Whether the formulas of a law are those of its first half alone: f(1 − x) = 1 − f(x) gives the second half.
pub const fn is_of_half(law: Law) -> bool {
    matches!(law, Law::ModifiedTrapezoid | Law::ModifiedSine)
}

/// The way h f(x) of a law, and h times its first and second derivative by x, with the law's constants.
fn shape(law: Law, h: &Expr, x: &Expr, place: f64, constants: &[Expr]) -> Option<[Expr; 3]> {
    let int = Expr::Int;
    let (h, x) = (|| h.clone(), || x.clone());
    let square = || x().squared();
    let rest = || int(1) - x();
    Some(match law {
        Law::Uniform => [h() * x(), h(), Expr::ZERO],
        Law::Parabolic if place < 0.5 => [int(2) * h() * square(), int(4) * h() * x(), int(4) * h()],
        Law::Parabolic => {
            [h() * (int(1) - int(2) * rest().squared()), int(4) * h() * rest(), -(int(4) * h())]
        }
        Law::Harmonic => {
            let angle = || Expr::Degrees(180) * x();
            [
                h() * (int(1) - angle().cos()) / int(2),
                h() * Expr::Pi * angle().sin() / int(2),
                h() * Expr::Pi.squared() * angle().cos() / int(2),
            ]
        }
        Law::Cycloidal => {
            let angle = || Expr::Degrees(360) * x();
            [
                h() * (x() - angle().sin() / (int(2) * Expr::Pi)),
                h() * (int(1) - angle().cos()),
                int(2) * Expr::Pi * h() * angle().sin(),
            ]
        }
        Law::Poly345 => {
            let sum = int(10) - int(15) * x() + int(6) * square();
            [
                h() * x().cubed() * sum,
                int(30) * h() * square() * rest().squared(),
                int(60) * h() * x() * rest() * (int(1) - int(2) * x()),
            ]
        }
        Law::Poly4567 => {
            let sum = int(35) - int(84) * x() + int(70) * square() - int(20) * x().cubed();
            [
                h() * square().squared() * sum,
                int(140) * h() * x().cubed() * rest().cubed(),
                int(420) * h() * square() * rest().squared() * (int(1) - int(2) * x()),
            ]
        }
        Law::ModifiedTrapezoid | Law::ModifiedSine => {
            let [constant] = constants else { return None };
            modified(law, &x(), place).map(|part| h() * constant.clone() * part)
        }
        Law::Spline(_) => {
            let [a, b, c] = constants else { return None };
            [
                a.clone() * x() + b.clone() * square() + c.clone() * x().cubed(),
                a.clone() + int(2) * b.clone() * x() + int(3) * c.clone() * square(),
                int(2) * b.clone() + int(6) * c.clone() * x(),
            ]
        }
        Law::Dwell => return None,
    })
}

/// The part of its stage at which a law has a way; none where this is no formula.
pub fn inverse(law: Law, h: &Expr, way: Expr, place: f64) -> Option<Expr> {
    let int = Expr::Int;
    match law {
        Law::Uniform => Some(way / h.clone()),
        Law::Parabolic if place < 0.5 => Some((way / (int(2) * h.clone())).root()),
        Law::Parabolic => Some(int(1) - ((h.clone() - way) / (int(2) * h.clone())).root()),
        Law::Harmonic => {
            let cosine = int(1) - int(2) * way / h.clone();
            Some(cosine.of(Function::Arccos) / Expr::Degrees(180))
        }
        _ => None,
    }
}

/// f, f′ and f″ of a modified law over its greatest acceleration, in the first half: one sine that is four times as fast, then
/// constant acceleration or a slower sine, each integrated twice.
fn modified(law: Law, x: &Expr, place: f64) -> [Expr; 3] {
    let int = Expr::Int;
    let x = || x.clone();
    let fourth = || int(4) * Expr::Pi;
    let square = || int(16) * Expr::Pi.squared();
    if place < 0.125 {
        let angle = || Expr::Degrees(720) * x();
        let way = x() / fourth() - angle().sin() / square();
        return [way, (int(1) - angle().cos()) / fourth(), angle().sin()];
    }
    if law == Law::ModifiedSine {
        let angle = || Expr::Degrees(240) * x() + Expr::Degrees(60);
        let way = x() / fourth() + (int(8) - int(9) * angle().sin()) / square();
        return [way, (int(1) - int(3) * angle().cos()) / fourth(), angle().sin()];
    }
    if place < 0.375 {
        let from = || x() - int(1) / int(8);
        let way = x() / fourth() - int(1) / square() + from().squared() / int(2);
        return [way, int(1) / fourth() + from(), int(1)];
    }
    let angle = || Expr::Degrees(720) * x() - Expr::Degrees(270);
    let way = x() / fourth() + x() / int(4) - int(1) / int(16) - angle().cos() / square();
    [way, int(1) / fourth() + int(1) / int(4) + angle().sin() / fourth(), angle().cos()]
}

/// The way of a law at a part of its stage and its derivatives by the cam's angle in rad, with the change of the lift in the unit of the
/// lift and in that of the derivatives (rad where it is an angle), and with the angle of the stage in rad. A law of halves has the
/// formulas of the first, mirrored.
pub fn derived(
    law: Law,
    [h, own]: [&Expr; 2],
    (place, part): (f64, Expr),
    constants: &[Expr],
    angle: &Expr,
) -> Option<[Expr; 3]> {
    let mirrored = is_of_half(law) && place > 0.5;
    let (place, part) = if mirrored { (1.0 - place, Expr::Int(1) - part) } else { (place, part) };
    let [way, ..] = shape(law, h, &part, place, constants)?;
    let [_, slope, bend] = shape(law, own, &part, place, constants)?;
    let [way, bend] = if mirrored { [h.clone() - way, -bend] } else { [way, bend] };
    // the terms of a spline of angles are in degrees
    let degrees = matches!(law, Law::Spline(_)) && h != own;
    let [slope, bend] = [slope, bend].map(|x| if degrees { Expr::Pi * x / Expr::Int(180) } else { x });
    Some([way, over(slope, angle.clone()), over(bend, angle.clone().squared())])
}

/// An angle in rad, from its degrees.
pub fn in_radians(angle: f64) -> Expr {
    let degrees = angle.to_degrees();
    let whole = degrees.round();
    let own = if (degrees - whole).abs() <= SAME {
        Expr::Degrees(whole as i64)
    } else {
        quantity(Name::default(), degrees, Unit::Angle)
    };
    own * Expr::Pi / Expr::Degrees(180)
}

/// A quotient without a fraction in its numerator and without what cancels: powers of π, whole numbers.
fn over(x: Expr, by: Expr) -> Expr {
    if let Expr::Neg(x) = x {
        return -over(*x, by);
    }
    let (mut top, mut bottom) = (Factors::default(), Factors::default());
    top.take(x, &mut bottom);
    bottom.take(by, &mut top);
    let common = gcd(top.whole, bottom.whole);
    let pi = top.pi.min(bottom.pi);
    top.product(common, pi) / bottom.product(common, pi)
}

/// A product: its whole number, the power of π, and the rest.
struct Factors {
    whole: i64,
    pi: u8,
    others: Vec<Expr>,
}

impl Default for Factors {
    fn default() -> Self {
        Self { whole: 1, pi: 0, others: Vec::new() }
    }
}

impl Factors {
    fn take(&mut self, x: Expr, below: &mut Self) {
        match x {
            Expr::Int(n) => self.whole *= n,
            Expr::Pi => self.pi += 1,
            Expr::Power(base, n) if *base == Expr::Pi => self.pi += n,
            Expr::Power(base, n) if matches!(*base, Expr::Int(_)) => {
                (0..n).for_each(|_| self.take((*base).clone(), below));
            }
            Expr::Product(factors) => factors.into_iter().for_each(|factor| self.take(factor, below)),
            Expr::Ratio(a, b) => {
                self.take(*a, below);
                below.take(*b, self);
            }
            other => self.others.push(other),
        }
    }

    fn product(self, common: i64, pi: u8) -> Expr {
        let powers = (0..self.pi - pi).fold(Expr::Int(1), |power, _| match power {
            Expr::Int(1) => Expr::Pi,
            Expr::Pi => Expr::Pi.squared(),
            other => other * Expr::Pi,
        });
        self.others.into_iter().fold(Expr::Int(self.whole / common) * powers, |product, x| product * x)
    }
}

fn gcd(a: i64, b: i64) -> i64 {
    if b == 0 { a.abs().max(1) } else { gcd(b, a % b) }
}
