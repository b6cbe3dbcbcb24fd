//! Series through the ends of an interval.

use assur_math::math::chebyshev;
use assur_math::math::lobatto::{Extremes, PLACES};

#[test]
fn half_of_the_places_are_those_of_half_the_degree() {
    let places = Extremes::new();
    let (from, to) = (0.3, 1.1);
    let values = std::array::from_fn::<_, PLACES, _>(|place| libm::exp(places.at(from, to, place)));
    assert_eq!((places.at(from, to, 0), places.at(from, to, PLACES - 1)), (from, to));
    for (step, error) in [(1, 1e-15), (2, 1e-11)] {
        let series = places.series(from, to, &values, step);
        assert_eq!(series.coefficients().len(), PLACES / step + usize::from(step == 2));
        for x in [0.3, 0.42, 0.7, 1.1] {
            let off = (series.value(x) - libm::exp(x)).abs();
            assert!(off < 4.0 * error, "{step} {x} {off:e}");
            assert!(off < 100.0 * series.tail().max(1e-16));
        }
        assert!((series.integral() - (libm::exp(1.1) - libm::exp(0.3))).abs() < error);
    }
}

#[test]
fn polynomials_come_out_as_they_are() {
    let places = Extremes::new();
    let cube = |x: f64| (x - 1.0) * (x - 2.0) * (x - 3.5);
    let values = std::array::from_fn::<_, PLACES, _>(|place| cube(places.at(0.0, 4.0, place)));
    for step in [1, 2] {
        let mut roots = Vec::new();
        let series = places.series(0.0, 4.0, &values, step);
        chebyshev::roots((0.0, 4.0), series.coefficients(), |x| roots.push(x));
        assert_eq!(roots.len(), 3);
        assert!(roots.iter().zip([1.0, 2.0, 3.5]).all(|(got, x)| (got - x).abs() < 1e-13), "{roots:?}");
    }
}
