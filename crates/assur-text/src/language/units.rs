//! The units, as data.

use super::Dimension;
use std::f64::consts::PI;

/// A unit of one word without power.
#[derive(Debug)]
pub struct Symbol {
    /// How it is written.
    pub text: &'static str,
    /// How many SI units it is.
    pub factor: f64,
    pub dimension: Dimension,
    pub also: &'static [&'static str],
}

const fn row(text: &'static str, factor: f64, dimension: Dimension, also: &'static [&'static str]) -> Symbol {
    Symbol { text, factor, dimension, also }
}

/// Standard gravity, which defines lbf and kgf.
const G: f64 = 9.806_65;
const LB: f64 = 0.453_592_37;
/// The international foot and inch.
const FT: f64 = 0.3048;
const INCH: f64 = 0.0254;

/// All units of one word without power.
pub static UNITS: &[Symbol] = &[
    row("m", 1.0, Dimension::LENGTH, &["meter", "metre", "meters", "metres", "м"]),
    row("mm", 1e-3, Dimension::LENGTH, &["millimeter", "millimetre", "millimeters", "millimetres", "мм"]),
    row("um", 1e-6, Dimension::LENGTH, &["micron", "microns", "micrometer", "micrometre", "мкм"]),
    row("µm", 1e-6, Dimension::LENGTH, &["μm"]),
    row("cm", 1e-2, Dimension::LENGTH, &["centimeter", "centimetre", "centimeters", "centimetres", "см"]),
    row("dm", 1e-1, Dimension::LENGTH, &["decimeter", "decimetre", "дм"]),
    row("km", 1e3, Dimension::LENGTH, &["kilometer", "kilometre", "kilometers", "kilometres", "км"]),
    row("inch", INCH, Dimension::LENGTH, &["in", "inches", "zoll"]),
    row("ft", FT, Dimension::LENGTH, &["foot", "feet"]),
    row("kg", 1.0, Dimension::MASS, &["kilogram", "kilograms", "kilo", "кг"]),
    row("g", 1e-3, Dimension::MASS, &["gram", "grams", "gr", "г"]),
    row("t", 1e3, Dimension::MASS, &["ton", "tons", "tonne", "tonnes", "т"]),
    row("lb", LB, Dimension::MASS, &["lbs", "lbm", "pound", "pounds"]),
    row("slug", LB * G / FT, Dimension::MASS, &["slugs"]),
    row("s", 1.0, Dimension::TIME, &["sec", "second", "seconds", "с"]),
    row("ms", 1e-3, Dimension::TIME, &["msec", "millisecond", "milliseconds", "мс"]),
    row("min", 60.0, Dimension::TIME, &["minute", "minutes", "мин"]),
    row("h", 3600.0, Dimension::TIME, &["hr", "hour", "hours", "ч"]),
    row("rad", 1.0, Dimension::ANGLE, &["radian", "radians", "рад"]),
    row("deg", PI / 180.0, Dimension::ANGLE, &["degree", "degrees", "grad", "град"]),
    row("°", PI / 180.0, Dimension::ANGLE, &["º"]),
    row("gon", PI / 200.0, Dimension::ANGLE, &["gons", "gradian", "gradians", "grad"]),
    row("rev", 2.0 * PI, Dimension::ANGLE, &["turn", "turns", "revolution", "revolutions", "r", "U", "об"]),
    row("rpm", PI / 30.0, Dimension::ANGULAR_VELOCITY, &["RPM", "upm"]),
    row("Hz", 1.0, Dimension::FREQUENCY, &["hertz", "Гц"]),
    row("N", 1.0, Dimension::FORCE, &["newton", "newtons", "Н"]),
    row("daN", 10.0, Dimension::FORCE, &["dekanewton", "даН"]),
    row("kN", 1e3, Dimension::FORCE, &["кН"]),
    row("MN", 1e6, Dimension::FORCE, &["МН"]),
    row("lbf", LB * G, Dimension::FORCE, &["pound-force"]),
    row("kgf", G, Dimension::FORCE, &["кгс"]),
    row("kp", G, Dimension::FORCE, &["кп"]),
    row("J", 1.0, Dimension::TORQUE, &["joule", "joules", "Дж"]),
    row("kJ", 1e3, Dimension::TORQUE, &["кДж"]),
    row("W", 1.0, Dimension::POWER, &["watt", "watts", "Вт"]),
    row("kW", 1e3, Dimension::POWER, &["кВт"]),
    row("MW", 1e6, Dimension::POWER, &["МВт"]),
    row("hp", 550.0 * FT * LB * G, Dimension::POWER, &["HP", "horsepower", "bhp"]),
    row("PS", 75.0 * G, Dimension::POWER, &["ps", "cv", "CV", "лс"]),
    row("Pa", 1.0, Dimension::PRESSURE, &["pascal", "Па"]),
    row("kPa", 1e3, Dimension::PRESSURE, &["кПа"]),
    row("MPa", 1e6, Dimension::PRESSURE, &["МПа"]),
    row("GPa", 1e9, Dimension::PRESSURE, &["ГПа"]),
    row("bar", 1e5, Dimension::PRESSURE, &["bars", "бар"]),
    row("psi", LB * G / (INCH * INCH), Dimension::PRESSURE, &["lbf/in2"]),
    row("%", 1e-2, Dimension::NUMBER, &["percent", "pct"]),
];

/// The unit of that spelling.
#[must_use]
pub fn symbol(text: &str) -> Option<&'static Symbol> {
    UNITS.iter().find(|s| s.text == text)
}
