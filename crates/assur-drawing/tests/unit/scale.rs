use assur_drawing::{SERIES, Scale, plain, round_length};

#[test]
fn the_smallest_factor_of_the_series_fits() {
    let scale = Scale::fitting(0.7, 150.0).expect("a scale");
    assert_eq!((scale.factor(), scale.text().as_str()), (0.005, "0.005"));
    for exponent in -12..12 {
        for units in [1.0, 1.7, 2.3, 3.9, 4.4, 9.99] {
            let units = units * libm::pow(10.0, f64::from(exponent));
            let scale = Scale::fitting(units, 100.0).expect("a scale");
            assert!(SERIES.contains(&scale.mantissa));
            assert!(units / scale.factor() <= 100.0 * (1.0 + 1e-9), "{units} in {}", scale.text());
            // the next smaller one does not fit: steps are at most 2
            assert!(units / scale.factor() > 50.0 * (1.0 - 1e-9), "{units} in {}", scale.text());
        }
    }
}

#[test]
fn the_largest_factor_up_to_a_number() {
    let largest = |most: f64| Scale::largest(most).map(|scale| scale.text());
    assert_eq!(largest(0.3 / 12.0).as_deref(), Some("0.025"));
    assert_eq!(largest(0.0399).as_deref(), Some("0.025"));
    assert_eq!(largest(0.99).as_deref(), Some("0.5"));
    assert_eq!(largest(7e9).as_deref(), Some("5·10⁹"));
    assert_eq!(largest(0.0), None);
}

#[test]
fn nothing_has_no_scale() {
    assert!(Scale::fitting(0.0, 100.0).is_none());
    assert!(Scale::fitting(f64::NAN, 100.0).is_none());
}

#[test]
fn factors_are_printed_with_few_digits() {
    assert_eq!(plain(2.5, -3), "0.0025");
    assert_eq!(plain(4.0, -9), "4·10⁻⁹");
    assert_eq!(plain(1.0, 6), "10⁶");
}

#[test]
fn bars_are_round() {
    let scale = Scale { mantissa: 4.0, exponent: -3 };
    assert_eq!(round_length(&scale, 25.0), (1.0, -1));
}
