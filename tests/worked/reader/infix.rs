//! Infix with + − * / ^, brackets, `sqrt`, `abs`, functions of degrees and their inverses.

/// Whether a side has no letters but those of functions and π.
pub fn is_numbers(side: &str) -> bool {
    let known = ["sin", "cos", "tan", "arcsin", "arccos", "arctan", "exp", "sqrt", "abs", "pi"];
    let words = side.split(|c: char| !c.is_alphabetic()).filter(|w| !w.is_empty());
    words.clone().all(|word| known.contains(&word)) && !side.is_empty()
}

/// The value of a side.
pub fn value(text: &str) -> Result<f64, String> {
    let mut reader = Reader { rest: text };
    let value = reader.sum()?;
    reader.skip();
    if reader.rest.is_empty() { Ok(value) } else { Err(format!("`{}` is left", reader.rest)) }
}

struct Reader<'a> {
    rest: &'a str,
}

impl Reader<'_> {
    fn skip(&mut self) {
        self.rest = self.rest.trim_start();
    }

    fn takes(&mut self, c: char) -> bool {
        self.skip();
        match self.rest.strip_prefix(c) {
            Some(rest) => {
                self.rest = rest;
                true
            }
            None => false,
        }
    }

    fn sum(&mut self) -> Result<f64, String> {
        let mut sum = self.product()?;
        loop {
            if self.takes('+') {
                sum += self.product()?;
            } else if self.takes('-') {
                sum -= self.product()?;
            } else {
                return Ok(sum);
            }
        }
    }

    fn product(&mut self) -> Result<f64, String> {
        if self.takes('-') {
            return Ok(-self.product()?);
        }
        let mut product = self.power()?;
        loop {
            if self.takes('*') {
                product *= self.power()?;
            } else if self.takes('/') {
                product /= self.power()?;
            } else {
                self.skip();
                // factors next to each other
                let begins = |c: char| c.is_ascii_digit() || c.is_alphabetic() || c == '(';
                if !self.rest.starts_with(begins) {
                    return Ok(product);
                }
                product *= self.power()?;
            }
        }
    }

    fn power(&mut self) -> Result<f64, String> {
        let base = self.atom()?;
        if self.takes('^') {
            let exponent = self.atom()?;
            return Ok(libm::pow(base, exponent));
        }
        Ok(base)
    }

    fn atom(&mut self) -> Result<f64, String> {
        self.skip();
        if self.takes('(') {
            let inner = self.sum()?;
            return if self.takes(')') { Ok(inner) } else { Err("no `)`".to_owned()) };
        }
        if self.takes('-') {
            return Ok(-self.atom()?);
        }
        let end = |f: fn(char) -> bool, text: &str| text.find(|c| !f(c)).unwrap_or(text.len());
        let digits = end(|c| c.is_ascii_digit() || c == '.', self.rest);
        if digits > 0 {
            let (number, rest) = self.rest.split_at(digits);
            self.rest = rest;
            return number.parse().map_err(|_| format!("`{number}`"));
        }
        let letters = end(char::is_alphabetic, self.rest);
        let (word, rest) = self.rest.split_at(letters);
        self.rest = rest;
        if word == "pi" {
            return Ok(std::f64::consts::PI);
        }
        // a function binds its argument closer than a product
        let x = self.power()?;
        Ok(match word {
            "sin" => libm::sin(x.to_radians()),
            "cos" => libm::cos(x.to_radians()),
            "tan" => libm::tan(x.to_radians()),
            "arcsin" => libm::asin(x.clamp(-1.0, 1.0)).to_degrees(),
            "arccos" => libm::acos(x.clamp(-1.0, 1.0)).to_degrees(),
            "arctan" => libm::atan(x).to_degrees(),
            "exp" => libm::exp(x),
            "sqrt" => x.max(0.0).sqrt(),
            "abs" => x.abs(),
            _ => return Err(format!("`{word}` at `{}`", self.rest)),
        })
    }
}
