//! LaTeX → infix.

/// All block equations of a document, as infix.
pub fn equations(document: &str) -> Vec<String> {
    document.split("$$\n").skip(1).step_by(2).map(infix).collect()
}

/// One formula as infix.
pub fn infix(text: &str) -> String {
    let mut reader = Reader { rest: text };
    reader.group('\0')
}

struct Reader<'a> {
    rest: &'a str,
}

impl Reader<'_> {
    /// Up to a closing sign.
    fn group(&mut self, close: char) -> String {
        let mut out = String::new();
        while let Some(c) = self.rest.chars().next() {
            self.rest = &self.rest[c.len_utf8()..];
            match c {
                c if c == close => return out,
                '\\' => self.command(&mut out),
                '{' => out += &format!("({})", self.group('}')),
                '_' => {
                    self.argument();
                    out += "x ";
                }
                '^' => {
                    let power = self.argument();
                    // a mark above a letter is no power, nor are degrees
                    if power.contains("deg") {
                        continue;
                    }
                    out += &format!("^({power})");
                }
                '&' | '\n' => out.push(' '),
                c => out.push(c),
            }
        }
        out
    }

    fn argument(&mut self) -> String {
        self.rest = self.rest.trim_start();
        match self.rest.strip_prefix('{') {
            Some(rest) => {
                self.rest = rest;
                self.group('}')
            }
            None => {
                let Some(c) = self.rest.chars().next() else { return String::new() };
                self.rest = &self.rest[c.len_utf8()..];
                c.to_string()
            }
        }
    }

    fn command(&mut self, out: &mut String) {
        let end = self.rest.find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(self.rest.len());
        if end == 0 {
            let sign = self.rest.chars().next().unwrap_or(' ');
            self.rest = &self.rest[sign.len_utf8()..];
            out.push(' ');
            return;
        }
        let (word, rest) = self.rest.split_at(end);
        self.rest = rest;
        match word {
            "frac" => {
                let (a, b) = (self.argument(), self.argument());
                *out += &format!("(({a})/({b}))");
            }
            "sqrt" => {
                let inner = self.argument();
                *out += &format!("sqrt({inner})");
            }
            "left" => {
                let open = self.argument();
                out.push_str(if open == "|" { "abs(" } else { "(" });
            }
            "right" => {
                self.argument();
                out.push(')');
            }
            "cdot" => out.push('*'),
            "circ" => out.push_str("deg"),
            "approx" => out.push('≈'),
            "begin" | "end" | "text" | "mathrm" => {
                self.argument();
            }
            "mathit" | "vec" => {
                self.argument();
                out.push_str(" x ");
            }
            "qquad" | "quad" => out.push(' '),
            "sin" | "cos" | "tan" | "arcsin" | "arccos" | "arctan" | "exp" | "pi" => {
                *out += &format!(" {word} ")
            }
            _ => out.push_str(" x "),
        }
    }
}
