//! Whether a text is well-formed XML, as far as our documents go.

/// Checks tags, attributes, entities and ids.
///
/// # Errors
/// The first fault.
pub fn check(text: &str) -> Result<(), String> {
    let mut open: Vec<&str> = Vec::new();
    let mut ids: Vec<&str> = Vec::new();
    let mut rest = text;
    while let Some(at) = rest.find('<') {
        entities(&rest[..at])?;
        let after = &rest[at + 1..];
        let end = after.find('>').ok_or("a tag without end")?;
        let tag = &after[..end];
        rest = &after[end + 1..];
        if let Some(name) = tag.strip_prefix('/') {
            let opened = open.pop().ok_or(format!("</{name}> closes nothing"))?;
            if opened != name {
                return Err(format!("</{name}> closes <{opened}>"));
            }
            continue;
        }
        let (tag, empty) = tag.strip_suffix('/').map_or((tag, false), |tag| (tag, true));
        let (name, attributes) = tag.split_once(' ').unwrap_or((tag, ""));
        if name.is_empty() || !name.chars().all(|c| c.is_ascii_alphanumeric()) {
            return Err(format!("<{name}> is not a name"));
        }
        for (key, value) in of_tag(attributes)? {
            if key == "id" {
                if ids.contains(&value) {
                    return Err(format!("the id {value} is there twice"));
                }
                ids.push(value);
            }
        }
        if !empty {
            open.push(name);
        }
    }
    if open.is_empty() && rest.trim().is_empty() { Ok(()) } else { Err(format!("not closed: {open:?}")) }
}

fn of_tag(text: &str) -> Result<Vec<(&str, &str)>, String> {
    let mut found: Vec<(&str, &str)> = Vec::new();
    let mut rest = text.trim();
    while !rest.is_empty() {
        let (key, after) = rest.split_once("=\"").ok_or(format!("no value: {rest}"))?;
        let (value, behind) = after.split_once('"').ok_or(format!("no end: {after}"))?;
        if found.iter().any(|(k, _)| *k == key) {
            return Err(format!("{key} is there twice"));
        }
        if !key.chars().all(|c| c.is_ascii_alphanumeric() || "-:".contains(c)) {
            return Err(format!("{key} is no name"));
        }
        entities(value)?;
        found.push((key, value));
        rest = behind.trim_start();
    }
    Ok(found)
}

fn entities(text: &str) -> Result<(), String> {
    let bad = text.chars().find(|c| c.is_control() && *c != '\n');
    if let Some(bad) = bad {
        return Err(format!("the sign {bad:?}"));
    }
    let known = ["&amp;", "&lt;", "&gt;", "&quot;"];
    let wrong = text.match_indices('&').find(|(at, _)| !known.iter().any(|k| text[*at..].starts_with(k)));
    wrong.map_or(Ok(()), |(at, _)| {
        Err(format!("no entity: {}", text[at..].chars().take(12).collect::<String>()))
    })
}
