//! Numbers modulo the prime.

use assur_model::structure::echelon::Number;

#[test]
fn inverses() {
    for seed in 0..100 {
        let x = Number::random(seed);
        assert_eq!(x * x.inverse(), Number::ONE);
        assert_eq!(x + -x, Number::ZERO);
    }
    assert_eq!(Number::ZERO.inverse(), Number::ZERO);
}

#[test]
fn products_wrap_around() {
    let minus_one = -Number::ONE;
    assert_eq!(minus_one * minus_one, Number::ONE);
    assert_eq!(Number(1 << 60) * Number(2), Number::ONE);
}
