//! Units as words, and their table.

use assur_text::language::UNITS;
use assur_text::units::{Dimension, Kind, Unit, UnitError, lookup};
use proptest::prelude::*;

fn unit(word: &str) -> Unit {
    lookup(word).unwrap_or_else(|e| panic!("{word}: {e}"))
}

#[test]
fn composite_words() {
    for (word, factor, dimension) in [
        ("kN*m", 1e3, Dimension::TORQUE),
        ("kg·m²", 1.0, Dimension::INERTIA),
        ("kg⋅m^2", 1.0, Dimension::INERTIA),
        ("m/s^2", 1.0, Dimension::ACCELERATION),
        ("m*s^-2", 1.0, Dimension::ACCELERATION),
        ("m·s⁻²", 1.0, Dimension::ACCELERATION),
        ("N*m*s", 1.0, Dimension::ROTARY_DAMPING),
        ("N/m^3", 1.0, Dimension::WEIGHT_DENSITY),
        ("mm^2", 1e-6, Dimension::AREA),
        ("1/mm", 1e3, Dimension { length: -1, ..Dimension::TIME.over(Dimension::TIME) }),
        ("%", 0.01, Dimension::NUMBER),
    ] {
        let found = unit(word);
        assert!((found.factor / factor - 1.0).abs() < 1e-15, "{word}: {}", found.factor);
        assert_eq!(found.dimension, dimension, "{word}");
    }
}

/// Every unit of the table with what it is in SI, written out.
#[test]
fn every_unit_has_its_value() {
    let (pound, gravity) = (0.453_592_37, 9.806_65);
    let values = [
        ("m", 1.0, Dimension::LENGTH),
        ("mm", 0.001, Dimension::LENGTH),
        ("cm", 0.01, Dimension::LENGTH),
        ("km", 1000.0, Dimension::LENGTH),
        ("inch", 0.0254, Dimension::LENGTH),
        ("ft", 0.3048, Dimension::LENGTH),
        ("kg", 1.0, Dimension::MASS),
        ("g", 0.001, Dimension::MASS),
        ("t", 1000.0, Dimension::MASS),
        ("lb", pound, Dimension::MASS),
        ("slug", 14.593_902_937_206_362, Dimension::MASS),
        ("s", 1.0, Dimension::TIME),
        ("ms", 0.001, Dimension::TIME),
        ("min", 60.0, Dimension::TIME),
        ("h", 3600.0, Dimension::TIME),
        ("rad", 1.0, Dimension::ANGLE),
        ("deg", 0.017_453_292_519_943_295, Dimension::ANGLE),
        ("°", 0.017_453_292_519_943_295, Dimension::ANGLE),
        ("rev", std::f64::consts::TAU, Dimension::ANGLE),
        ("rpm", 0.104_719_755_119_659_77, Dimension::ANGULAR_VELOCITY),
        ("Hz", 1.0, Dimension::FREQUENCY),
        ("N", 1.0, Dimension::FORCE),
        ("daN", 10.0, Dimension::FORCE),
        ("kN", 1000.0, Dimension::FORCE),
        ("MN", 1_000_000.0, Dimension::FORCE),
        ("lbf", 4.448_221_615_260_5, Dimension::FORCE),
        ("kgf", gravity, Dimension::FORCE),
        ("J", 1.0, Dimension::TORQUE),
        ("kJ", 1000.0, Dimension::TORQUE),
        ("W", 1.0, Dimension::POWER),
        ("kW", 1000.0, Dimension::POWER),
        ("Pa", 1.0, Dimension::PRESSURE),
        ("kPa", 1000.0, Dimension::PRESSURE),
        ("MPa", 1_000_000.0, Dimension::PRESSURE),
        ("GPa", 1e9, Dimension::PRESSURE),
        ("bar", 100_000.0, Dimension::PRESSURE),
        ("psi", 6_894.757_293_168_361, Dimension::PRESSURE),
        ("dm", 0.1, Dimension::LENGTH),
        ("um", 1e-6, Dimension::LENGTH),
        ("µm", 1e-6, Dimension::LENGTH),
        ("gon", 0.015_707_963_267_948_967, Dimension::ANGLE),
        ("kp", gravity, Dimension::FORCE),
        ("MW", 1_000_000.0, Dimension::POWER),
        ("hp", 745.699_871_582_270_2, Dimension::POWER),
        ("PS", 735.498_75, Dimension::POWER),
        ("%", 0.01, Dimension::NUMBER),
    ];
    for (word, factor, dimension) in values {
        let found = unit(word);
        assert!((found.factor / factor - 1.0).abs() <= f64::EPSILON, "{word}: {}", found.factor);
        assert_eq!(found.dimension, dimension, "{word}");
    }
    for symbol in UNITS {
        assert!(values.iter().any(|v| v.0 == symbol.text), "`{}` has no value in this test", symbol.text);
    }
}

#[test]
fn angle_is_a_kind() {
    let number = Dimension::NUMBER;
    assert_eq!(unit("rad/s").dimension, Dimension::ANGULAR_VELOCITY);
    assert_eq!(unit("rev/min").dimension, Dimension::ANGULAR_VELOCITY);
    assert_eq!(unit("rpm").dimension, Dimension::ANGULAR_VELOCITY);
    assert_eq!(unit("deg/s^2").dimension, Dimension::ANGULAR_ACCELERATION);
    assert_eq!(unit("1/s").dimension.kind, Kind::Free);
    assert_eq!(unit("N*m/rad").dimension.kind, Kind::Free);
    // `1/s` fits rad/s, Hz does not, and a plain number is no angle
    assert!(unit("1/s").dimension.fits(Dimension::ANGULAR_VELOCITY));
    assert!(unit("s^-1").dimension.fits(Dimension::ANGULAR_VELOCITY));
    assert!(!unit("Hz").dimension.fits(Dimension::ANGULAR_VELOCITY));
    assert!(!number.fits(Dimension::ANGLE));
    // a plain number keeps the kind
    assert_eq!(number.times(Dimension::ANGLE), Dimension::ANGLE);
    assert_eq!(Dimension::ANGLE.over(number), Dimension::ANGLE);
    assert_eq!(Dimension::ANGULAR_VELOCITY.times(number), Dimension::ANGULAR_VELOCITY);
    // with any other dimension it becomes free
    let velocity = Dimension::ANGULAR_VELOCITY.times(Dimension::LENGTH);
    assert_eq!(velocity, Dimension::VELOCITY);
    let rate = Dimension::VELOCITY.over(Dimension::LENGTH);
    assert!(rate.fits(Dimension::ANGULAR_VELOCITY) && rate.fits(Dimension::FREQUENCY));
    assert!(Dimension::ANGULAR_VELOCITY.times(Dimension::TIME).fits(Dimension::ANGLE));
    assert!(Dimension::LENGTH.over(Dimension::LENGTH).fits(number));
    assert!(Dimension::ANGLE.over(Dimension::ANGLE).fits(number));
}

#[test]
fn unknown_words_name_what_is_near() {
    for (word, near) in [
        ("Nm", "N*m"),
        ("kNm", "kN*m"),
        ("mmm", "mm"),
        ("m2", "m^2"),
        ("kgm2", "kg*m^2"),
        ("kg*m2", "kg*m^2"),
        ("sec", "s"),
        ("rad/sec", "rad/s"),
        ("RPM", "rpm"),
        ("degrees", "deg"),
        ("KG", "kg"),
        ("lbs", "lb"),
        ("об/мин", "rev/min"),
        ("мм", "mm"),
    ] {
        let error = lookup(word).expect_err(word);
        let UnitError::Unknown { nearest, .. } = &error else { panic!("{word}: {error}") };
        assert!(nearest.iter().any(|n| n == near), "{word}: {nearest:?}");
        for spelling in nearest {
            unit(spelling);
        }
    }
    assert_eq!(lookup("kN*foo").expect_err("foo").range(), (3, 6));
    assert!(matches!(lookup("m^999"), Err(UnitError::Power { .. })));
    assert_eq!(lookup(""), Err(UnitError::Empty));
}

#[test]
fn conversions_round_once() {
    assert_eq!(unit("mm").to_si(69.34).to_bits(), 0.06934_f64.to_bits());
    assert_eq!(unit("mm").from_si(0.35).to_bits(), 350.0_f64.to_bits());
    assert_eq!(unit("kN").to_si(8.0).to_bits(), 8000.0_f64.to_bits());
}

#[test]
fn roots() {
    assert_eq!(Dimension::AREA.sqrt(), Some(Dimension::LENGTH));
    assert_eq!(Dimension::LENGTH.sqrt(), None);
    assert_eq!(Dimension::NUMBER.sqrt(), Some(Dimension::NUMBER));
    assert_eq!(Dimension::VELOCITY.powi(2).over(Dimension::LENGTH), Dimension::ACCELERATION);
}

fn word() -> impl Strategy<Value = String> {
    let factor = (0..UNITS.len(), 1..4_i8).prop_map(|(i, n)| match n {
        1 => UNITS[i].text.to_owned(),
        n => format!("{}^{n}", UNITS[i].text),
    });
    let joined = (factor.clone(), any::<bool>())
        .prop_map(|(f, times)| if times { format!("*{f}") } else { format!("/{f}") });
    (factor, prop::collection::vec(joined, 0..3)).prop_map(|(first, rest)| first + &rest.concat())
}

fn dimension() -> impl Strategy<Value = Dimension> {
    let kind = prop_oneof![Just(Kind::Free), Just(Kind::Angle), Just(Kind::Plain)];
    (-4..5_i8, -4..5_i8, -4..5_i8, kind).prop_map(|(length, mass, time, kind)| {
        let kind = if length == 0 && mass == 0 { kind } else { Kind::Free };
        Dimension { length, mass, time, kind }
    })
}

proptest! {
    #[test]
    fn what_is_printed_is_read(word in word()) {
        let first = unit(&word);
        prop_assert_eq!(&unit(&first.to_string()), &first);
    }

    #[test]
    fn the_si_spelling_has_the_dimension(dimension in dimension()) {
        let text = dimension.si_text();
        let read = if text.is_empty() { Unit::si(Dimension::NUMBER) } else { unit(&text) };
        prop_assert!(read.dimension.fits(dimension), "{text}");
        prop_assert_eq!(read.factor.to_bits(), 1.0_f64.to_bits());
    }

    #[test]
    fn algebra(a in dimension(), b in dimension()) {
        prop_assert_eq!(a.times(b), b.times(a));
        prop_assert!(a.times(b).over(b).fits(a));
        prop_assert_eq!(a.fits(b), b.fits(a));
        prop_assert!(a.powi(2).sqrt().is_some_and(|root| root.fits(a)));
        prop_assert!(a.powi(-1).times(a).is_dimensionless());
    }

    #[test]
    fn any_word_is_looked_up(word in "\\PC{0,12}") {
        if let Err(error) = lookup(&word) {
            let (start, end) = error.range();
            prop_assert!(word.get(start..end).is_some());
        }
    }
}
