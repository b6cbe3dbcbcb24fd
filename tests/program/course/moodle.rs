//! Reads a file as Moodle does, as far as its rules are written down: a small reader of XML, gaps by their signs, first hit wins.

/// An element with what is in it.
#[derive(Clone, Debug, Default)]
pub struct Element {
    pub name: String,
    pub attributes: Vec<(String, String)>,
    pub text: String,
    pub inside: Vec<Element>,
}

impl Element {
    pub fn all<'e>(&'e self, name: &str) -> impl Iterator<Item = &'e Self> + use<'e> {
        let name = name.to_owned();
        self.inside.iter().filter(move |one| one.name == name)
    }

    pub fn one(&self, name: &str) -> &Self {
        self.all(name).next().unwrap_or_else(|| panic!("<{name}> in <{}>", self.name))
    }

    /// The text of `<name><text>`, or of `<name>`.
    pub fn said(&self, name: &str) -> &str {
        let one = self.one(name);
        one.all("text").next().map_or(one.text.as_str(), |text| text.text.as_str())
    }

    pub fn attribute(&self, name: &str) -> &str {
        self.attributes.iter().find(|(known, _)| known == name).map_or("", |(_, value)| value)
    }
}

/// Reads a whole document.
///
/// # Errors
/// What is not well-formed.
pub fn read(text: &str) -> Result<Element, String> {
    let strange =
        |c: char| c.is_control() && !matches!(c, '\n' | '\t') || matches!(c, '\u{FFFE}' | '\u{FFFF}');
    if text.contains(strange) {
        return Err("a sign that XML does not have".to_owned());
    }
    let mut rest =
        text.strip_prefix("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n").ok_or("the first byte")?;
    let mut open = vec![Element::default()];
    while !rest.is_empty() {
        let last = open.last_mut().ok_or("nothing is open")?;
        if let Some(data) = rest.strip_prefix("<![CDATA[") {
            let (data, after) = data.split_once("]]>").ok_or("CDATA without end")?;
            last.text += data;
            rest = after;
        } else if let Some(name) = rest.strip_prefix("</") {
            let (name, after) = name.split_once('>').ok_or("a tag without end")?;
            let done =
                open.pop().filter(|one| one.name == name).ok_or(format!("</{name}> closes nothing"))?;
            open.last_mut().ok_or("too many ends")?.inside.push(done);
            rest = after;
        } else if let Some(tag) = rest.strip_prefix('<') {
            let (tag, after) = tag.split_once('>').ok_or("a tag without end")?;
            let (name, mut attributes) = tag.split_once(' ').unwrap_or((tag, ""));
            let mut element = Element { name: name.to_owned(), ..Element::default() };
            while let Some((key, value)) = attributes.trim_start().split_once("=\"") {
                let (value, more) = value.split_once('"').ok_or("an attribute without end")?;
                element.attributes.push((key.to_owned(), decoded(value)?));
                attributes = more;
            }
            open.push(element);
            rest = after;
        } else {
            let end = rest.find('<').unwrap_or(rest.len());
            if rest[..end].contains("]]>") {
                return Err("]]> in a text".to_owned());
            }
            last.text += &decoded(&rest[..end])?;
            rest = &rest[end..];
        }
    }
    match open.as_mut_slice() {
        [root] if root.inside.len() == 1 && root.text.trim().is_empty() => Ok(root.inside.remove(0)),
        _ => Err("not one element".to_owned()),
    }
}

/// A text without its entities.
pub fn decoded(text: &str) -> Result<String, String> {
    let mut parts = text.split('&');
    let mut out = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let (name, rest) = part.split_once(';').ok_or(format!("a bare & before {part}"))?;
        out.push(match name {
            "lt" => '<',
            "gt" => '>',
            "amp" => '&',
            "quot" => '"',
            _ => {
                let code = name.strip_prefix('#').and_then(|code| code.parse().ok()).and_then(char::from_u32);
                code.ok_or(format!("&{name};"))?
            }
        });
        out += rest;
    }
    Ok(out)
}

/// An answer of a gap or of a number.
#[derive(Clone, Debug)]
pub struct Option {
    /// Percent.
    pub fraction: f64,
    pub answer: f64,
    /// As a student sees it.
    pub text: String,
    pub tolerance: f64,
    pub words: String,
}

/// A gap, or a numerical question.
#[derive(Clone, Debug)]
pub struct Asked {
    pub weight: f64,
    pub options: Vec<Option>,
    /// Names, and how many make one of the first.
    pub units: Vec<(String, f64)>,
}

impl Asked {
    /// Percent and words for a number: the first that holds it.
    pub fn hit(&self, x: f64) -> (f64, &str) {
        let hit = self.options.iter().find(|one| (x - one.answer).abs() <= one.tolerance);
        hit.map_or((0.0, ""), |one| (one.fraction, one.words.as_str()))
    }

    /// A number from a response with its unit: blanks are taken out, the number is divided by the unit's.
    pub fn number(&self, response: &str) -> std::option::Option<f64> {
        let response: String = response.split_whitespace().collect();
        let starts_unit = |(i, c): &(usize, char)| {
            let exponent = matches!(c, 'e' | 'E')
                && response[i + 1..].starts_with(|d: char| d.is_ascii_digit() || d == '-');
            !(c.is_ascii_digit() || matches!(c, '.' | '-' | '+') || exponent)
        };
        let end = response.char_indices().find(starts_unit).map_or(response.len(), |(at, _)| at);
        let (number, unit) = response.split_at(end);
        let known = self.units.iter().find(|(name, _)| name == unit).map(|(_, many)| *many);
        Some(
            number.parse::<f64>().ok()?
                / known.or((self.units.is_empty() && unit.is_empty()).then_some(1.0))?,
        )
    }
}

/// The gaps of a text, with the text between them.
pub fn gaps(text: &str) -> (Vec<Asked>, String) {
    let mut parts = text.split('{');
    let mut between = parts.next().unwrap_or_default().to_owned();
    let mut gaps = Vec::new();
    for part in parts {
        let (gap, after) = part.split_once('}').expect("a gap ends");
        assert!(!after.contains('}'), "a brace that is none of a gap: {after}");
        let (weight, rest) = gap.split_once(":NM:").expect("a gap of numbers");
        let options = rest.split('~').map(|one| {
            let (numbers, words) = one.split_once('#').expect("words");
            let (fraction, numbers) = match numbers.strip_prefix('=') {
                Some(numbers) => (100.0, numbers),
                None => {
                    let (percent, numbers) = numbers[1..].split_once('%').expect("a part in percent");
                    (percent.parse().expect("a part"), numbers)
                }
            };
            let (answer, tolerance) = numbers.split_once(':').expect("a tolerance");
            option(fraction, answer, tolerance, &decoded(words).expect("words"))
        });
        gaps.push(Asked {
            weight: weight.parse::<u32>().expect("a whole weight").into(),
            options: options.collect(),
            units: Vec::new(),
        });
        between += after;
    }
    (gaps, between)
}

/// A numerical question.
pub fn numerical(question: &Element) -> Asked {
    let options = question.all("answer").map(|answer| {
        let fraction = answer.attribute("fraction").parse().expect("a part");
        option(fraction, answer.said("text"), answer.said("tolerance"), answer.said("feedback"))
    });
    let units = question.all("units").flat_map(|units| units.all("unit"));
    let unit = |unit: &Element| {
        (unit.said("unit_name").to_owned(), unit.said("multiplier").parse().expect("a multiplier"))
    };
    Asked {
        weight: question.said("defaultgrade").parse().expect("a mark"),
        options: options.collect(),
        units: units.map(unit).collect(),
    }
}

fn option(fraction: f64, answer: &str, tolerance: &str, words: &str) -> Option {
    let number = |text: &str| text.parse::<f64>().unwrap_or_else(|_| panic!("{text} is no number"));
    Option {
        fraction,
        answer: number(answer),
        text: answer.to_owned(),
        tolerance: number(tolerance),
        words: decoded(words).expect("HTML"),
    }
}
