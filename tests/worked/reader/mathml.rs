//! MathML → infix.

/// An element or a text.
enum Element {
    Tag(String, Vec<Element>),
    Text(String),
}

/// All block equations of a page, as infix.
pub fn equations(page: &str) -> Vec<String> {
    // those that may break on paper too
    let bodies = page.split("<div class=\"eq").skip(1).filter_map(|rest| {
        let body = rest.strip_prefix("\">").or_else(|| rest.strip_prefix(" long\">"))?;
        // several lines are in a grid of their own
        body.strip_prefix("<div class=\"rows\">").unwrap_or(body).split_once("</div>")
    });
    bodies.map(|(body, _)| infix(body)).collect()
}

/// One formula as infix.
pub fn infix(text: &str) -> String {
    let mut rest = text;
    let mut out = String::new();
    children(&mut rest).iter().for_each(|e| write(e, &mut out));
    out
}

fn children(rest: &mut &str) -> Vec<Element> {
    let mut found = Vec::new();
    loop {
        let at = rest.find('<').unwrap_or(rest.len());
        let words = rest[..at].replace(['\u{2061}', '\u{2062}'], "").replace('\u{202f}', " ");
        if !words.is_empty() {
            found.push(Element::Text(words));
        }
        *rest = &rest[at..];
        let Some((tag, after)) = rest.strip_prefix('<').and_then(|r| r.split_once('>')) else { return found };
        *rest = after;
        if tag.starts_with('/') {
            return found;
        }
        let name = tag.split([' ', '/']).next().unwrap_or_default().to_owned();
        let inner = if tag.ends_with('/') { Vec::new() } else { children(rest) };
        found.push(Element::Tag(name, inner));
    }
}

fn inner(element: &Element) -> String {
    let mut out = String::new();
    write(element, &mut out);
    out
}

fn write(element: &Element, out: &mut String) {
    let Element::Tag(name, parts) = element else {
        if let Element::Text(words) = element {
            out.push_str(&words.replace('−', "-").replace('·', "*").replace('°', "").replace('π', " pi "));
        }
        return;
    };
    let both = |i: usize| parts.get(i).map(inner).unwrap_or_default();
    match (name.as_str(), parts.len()) {
        ("mfrac", 2) => *out += &format!("(({})/({}))", both(0), both(1)),
        ("msup", 2) => *out += &format!("({})^({})", both(0), both(1)),
        ("msqrt", _) => *out += &format!("sqrt({})", parts.iter().map(inner).collect::<String>()),
        ("mtext" | "mspace", _) => {}
        // letters of quantities are no numbers, whatever their index
        ("msub" | "msubsup" | "mover", _) => *out += " x ",
        ("mrow", n) if n >= 3 && inner(&parts[0]) == "|" && inner(&parts[n - 1]) == "|" => {
            *out += &format!("abs({})", parts[1..n - 1].iter().map(inner).collect::<String>());
        }
        _ => {
            if name == "mi" {
                out.push(' ');
            }
            parts.iter().for_each(|part| write(part, out));
            if name == "mi" {
                out.push(' ');
            }
        }
    }
}
