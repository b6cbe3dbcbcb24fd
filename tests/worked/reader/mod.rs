//! A reader of printed equations that shares no code with the writers: MathML and LaTeX → infix → numbers.

pub mod infix;
pub mod latex;
pub mod mathml;

/// What the sides of an equation come to.
#[derive(Clone, Debug, PartialEq)]
pub struct Read {
    /// The sides in numbers, as infix.
    pub sides: Vec<String>,
    /// The result as printed: without its unit.
    pub result: String,
    /// It is marked as approximate.
    pub approximate: bool,
}

/// How an equation fails.
#[derive(Debug, PartialEq)]
pub enum Fault {
    /// It cannot be read.
    Unreadable(String),
    /// A side misses the result by this many units of its last digit.
    Misses(String, f64),
}

impl Read {
    /// An equation from its infix form.
    pub fn of(infix: &str) -> Result<Self, Fault> {
        let approximate = infix.contains('≈');
        let sides: Vec<String> = infix.split(['=', '≈']).map(|s| s.trim().to_owned()).collect();
        let [_, middle @ .., last] = sides.as_slice() else {
            return Err(Fault::Unreadable(format!("one side: {infix}")));
        };
        let numbers = middle.iter().filter(|side| infix::is_numbers(side)).cloned();
        Ok(Self { sides: numbers.collect(), result: last.clone(), approximate })
    }

    /// Whether every side comes to the result within one unit of its last digit.
    pub fn judge(&self) -> Result<(), Fault> {
        let bad = |e: String| Fault::Unreadable(format!("{e} in {self:?}"));
        let result = infix::value(&self.result).map_err(bad)?;
        let unit = last_digit(&self.result);
        for side in &self.sides {
            let value = infix::value(side).map_err(bad)?;
            let off = (value - result).abs() / unit;
            // what is added in another order differs by rounding
            if off > 1.0 + 1e-6 || off.is_nan() {
                return Err(Fault::Misses(format!("{side} = {}", self.result), off));
            }
        }
        Ok(())
    }
}

/// One unit of the last digit of a number.
fn last_digit(text: &str) -> f64 {
    let plain = text.replace(['(', ')', ' '], "");
    let (digits, power) = match plain.split_once("*10^") {
        Some((digits, power)) => (digits, power.parse::<i32>().unwrap_or(0)),
        None => (plain.as_str(), 0),
    };
    let digits = digits.trim_matches(|c: char| !c.is_ascii_digit() && c != '.');
    let decimals = digits.split_once('.').map_or(0, |(_, d)| d.len());
    10_f64.powi(power - i32::try_from(decimals).unwrap_or(0))
}
