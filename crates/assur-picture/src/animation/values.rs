//! The numbers of each frame: what drives, and what the file asks for.

use crate::figures::{cleared, unit_text};
use crate::plot::Curves;
use crate::scene::Scene;
use crate::words::drive_name;
use assur_model::model::Display;
use assur_solve::solve::DriveValue;
use assur_text::units::Dimension;

/// Digits of the greatest number.
const DIGITS: i32 = 4;
/// The most decimals; smaller numbers have a power of ten.
const DECIMALS: i32 = 6;

/// A number of all frames.
pub struct Column {
    /// `φ₁`, `Mb`.
    pub name: String,
    /// What stands behind it: `°`, ` N·m`.
    pub unit: String,
    pub decimals: u8,
    /// It in units of the last decimal; none where it has no value.
    pub numbers: Vec<Option<i64>>,
}

/// The numbers of all frames, in the order in which they are said.
pub fn columns(frames: &[Scene<'_>], curves: Option<&Curves>) -> Vec<Column> {
    let mut all: Vec<Column> = time(frames).into_iter().chain(drives(frames)).collect();
    let Some(curves) = curves else { return all };
    for i in 0..curves.count() {
        let mut named = None;
        let values = frames.iter().map(|frame| {
            let (name, display, y) = curves.of(i, frame.along().unwrap_or(f64::NAN));
            named.get_or_insert((name, display));
            y.map(|y| cleared(y, frame.greatest.in_si(display.dimension)))
        });
        let values: Vec<Option<f64>> = values.collect();
        all.extend(named.map(|(name, display)| Column::of(name, display, &values)));
    }
    all
}

/// The instants of a motion under loads.
fn time(frames: &[Scene<'_>]) -> Option<Column> {
    let mechanism = frames.first()?.mechanism();
    mechanism.simulation.as_ref()?;
    let times: Vec<Option<f64>> = frames.iter().map(|frame| Some(frame.solved.state.motion.time)).collect();
    Some(Column::of("t", &mechanism.display_of(Dimension::TIME), &times))
}

/// Where the drives are; of driven points both coordinates.
fn drives(frames: &[Scene<'_>]) -> Vec<Column> {
    let Some(first) = frames.first() else { return Vec::new() };
    let mut all = Vec::new();
    for (i, drive) in first.mechanism().drives.iter().enumerate() {
        let display = first.mechanism().drive_display(drive.target);
        let values = |part: &dyn Fn(&DriveValue) -> Option<f64>| {
            let of = |frame: &Scene<'_>| {
                let carried = if i == 0 { frame.carried } else { 0.0 };
                let x = frame.pose.drives.get(i).and_then(part)? + carried;
                Some(cleared(x, frame.greatest.in_si(display.dimension)))
            };
            frames.iter().map(of).collect::<Vec<_>>()
        };
        let (name, point) = (&drive.name, |value: &DriveValue| match value {
            DriveValue::Point(p) => Some(*p),
            _ => None,
        });
        match first.pose.drives.get(i) {
            Some(DriveValue::Scalar(_)) => {
                let scalar = |value: &DriveValue| match value {
                    DriveValue::Scalar(x) => Some(*x),
                    _ => None,
                };
                let name = drive_name(first.mechanism(), drive);
                all.push(Column::of(&name, &display, &values(&scalar)));
            }
            Some(DriveValue::Point(_)) => {
                let x = values(&|value| point(value).map(|p| p.x));
                let y = values(&|value| point(value).map(|p| p.y));
                all.push(Column::of(&format!("{name}.x"), &display, &x));
                all.push(Column::of(&format!("{name}.y"), &display, &y));
            }
            _ => {}
        }
    }
    all
}

/// The numbers of a frame in words, with a sign before decimals.
pub fn said(columns: &[Column], frame: usize, decimal: char) -> String {
    let said = columns.iter().map(|column| match column.numbers.get(frame).copied().flatten() {
        Some(number) => {
            #[allow(clippy::cast_precision_loss)] // four digits
            let value = number as f64 / 10_f64.powi(i32::from(column.decimals));
            let figures = format!("{value:.*}", usize::from(column.decimals)).replace('-', "−");
            let figures = figures.replace('.', &decimal.to_string());
            format!("{} = {figures}{}", column.name, column.unit)
        }
        None => format!("{} = —", column.name),
    });
    said.collect::<Vec<_>>().join("   ")
}

impl Column {
    /// With as many decimals as the greatest number has beyond its first digits.
    fn of(name: &str, display: &Display, values: &[Option<f64>]) -> Self {
        let printed: Vec<Option<f64>> =
            values.iter().map(|si| si.map(|si| display.of_si(si)).filter(|x| x.is_finite())).collect();
        let greatest = printed.iter().flatten().fold(0.0_f64, |most, x| most.max(x.abs()));
        #[allow(clippy::cast_possible_truncation)] // logarithms of numbers
        let exponent = if greatest > 0.0 { libm::floor(libm::log10(greatest)) as i32 } else { 0 };
        let plain = (DIGITS - 1 - exponent).max(0);
        let power = if plain > DECIMALS || exponent > 9 { exponent } else { 0 };
        let decimals = (DIGITS - 1 - (exponent - power)).max(0);
        #[allow(clippy::cast_possible_truncation)] // less than ten digits
        let last = |x: f64| (x * libm::pow(10.0, f64::from(decimals - power))).round() as i64;
        let unit = match unit_text(&display.unit).as_str() {
            "" => String::new(),
            "°" => "°".to_owned(),
            unit => format!(" {unit}"),
        };
        let power = if power == 0 { String::new() } else { format!("·{}", assur_drawing::ten_to(power)) };
        Self {
            name: name.to_owned(),
            unit: power + &unit,
            decimals: u8::try_from(decimals).unwrap_or(0),
            numbers: printed.into_iter().map(|x| x.map(last)).collect(),
        }
    }
}
