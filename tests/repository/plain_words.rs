//! Texts for users avoid some phrases that are hard to understand, and what to write instead is listed with each.

use crate::folder;
use std::path::Path;

/// Folders that are not yet corrected; remove a name as soon as it is.
const NOT_YET: &[&str] = &[];

/// Phrases, in small letters, and what to write.
const PHRASES: &[(&str, &str)] = &[
    ("hangs", "depends on"),
    ("hang on", "depend on"),
    ("stands", "is, comes after, is next to"),
    ("stand on", "are on"),
    ("stand behind", "come after"),
    ("beside", "next to, in addition to"),
    ("besides", "in addition to"),
    ("told", "reported, shown"),
    ("is said", "is reported"),
    ("what is said", "the message"),
    ("a truth", "a condition"),
    ("truths", "conditions"),
    ("the one there is", "1 of 1"),
    ("so many", "the number"),
    ("so far", "until now"),
    ("not so:", "Wrong:"),
    ("but so:", "Right:"),
    ("mended", "corrected"),
    ("hold against", "compare with"),
    ("holds against", "compares with"),
    ("held against", "compared with"),
    ("holds every", "compares every"),
    ("is no value", "is not a value"),
    ("is no pair", "is not a pair"),
    ("is no group", "is not a group"),
    ("is no unit", "is not a unit"),
    ("is no link", "is not a link"),
    ("are no contact", "cannot form a contact"),
    ("are no group", "do not form a group"),
    ("less than nothing", "negative"),
    ("in play", "that occurs"),
    ("set aside", "not solved"),
    ("as it stands", "as written"),
    ("the usual slips", "common mistakes"),
    ("once it is whole", "only when complete"),
    ("handed out", "packages; distributed"),
    ("what rubs", "pairs with friction"),
    ("let go", "released"),
    ("lets go", "releases"),
    ("hold each other", "balance"),
    ("lose their way", "leave the solution"),
    ("loses its way", "leaves the solution"),
    ("gone again", "passed a second time"),
    ("goes by", "follows, uses"),
    ("says of itself", "prints, reports"),
    ("knows no", "does not use, has no"),
    ("what a run has", "the time, the error reached"),
    ("nothing else can be meant", "there is only one possible correction"),
    ("comes to no end", "does not converge"),
    ("called alike", "has the same name"),
    ("is said to", "is reported as"),
    ("are said to", "are reported as"),
    ("notices that", "finds that"),
    ("tidies", "cleans, releases"),
    ("beyond all bounds", "without bound"),
    ("spoils", "damages, affects"),
];

/// The same for pages alone: messages still have them.
const PHRASES_OF_PAGES: &[(&str, &str)] = &[
    ("rubs", "has friction, slides"),
    ("turns round", "reverses"),
    ("the way of the drive", "the range of the drive"),
    ("come again", "repeat; are periodic"),
];

/// A text without the names in its braces, as `{stands}`.
fn without_names(text: &str) -> String {
    let name = |part: &str| part.chars().all(|c| c.is_alphanumeric() || "_:.?#".contains(c));
    let parts = text.split('{').map(|part| match part.split_once('}') {
        Some((inside, rest)) if name(inside) => rest,
        _ => part,
    });
    parts.collect::<Vec<_>>().join(" … ")
}

/// The phrases of a text, as whole words; a line end counts as a blank.
fn phrases(text: &str) -> Vec<&'static (&'static str, &'static str)> {
    listed(PHRASES, text)
}

fn listed(
    list: &'static [(&'static str, &'static str)],
    text: &str,
) -> Vec<&'static (&'static str, &'static str)> {
    let text = text.to_lowercase().split_whitespace().collect::<Vec<_>>().join(" ");
    let is_word = |c: Option<char>| c.is_some_and(|c| c.is_alphanumeric() || c == '_');
    let whole = |phrase: &str| {
        text.match_indices(phrase).any(|(at, _)| {
            let after = text[at + phrase.len()..].chars().next();
            let goes_on = is_word(after) && !phrase.ends_with(':');
            // "there is no link `b`" is a sentence of another kind than "`b` is no link"
            let before = &text[..at];
            !goes_on && !is_word(before.chars().next_back()) && !before.ends_with("there ")
        })
    };
    list.iter().filter(|(phrase, _)| whole(phrase)).collect()
}

/// String literals of a Rust text, and with `docs` also the lines of its documentation, which clap shows as help. Each with
/// the number of its line.
fn texts(code: &str, docs: bool) -> Vec<(usize, String)> {
    let mut found = Vec::new();
    let mut rest = code;
    let line = |rest: &str| code[..code.len() - rest.len()].matches('\n').count() + 1;
    while let Some(first) = rest.chars().next() {
        let taken = if rest.starts_with("//") {
            let end = rest.find('\n').unwrap_or(rest.len());
            if docs && rest.starts_with("/// ") {
                found.push((line(rest), rest[4..end].to_owned()));
            }
            end
        } else if let Some((start, end)) = raw(rest) {
            let length = rest[start..].find(&end).expect("the end of a literal");
            found.push((line(rest), rest[start..start + length].to_owned()));
            start + length + end.len()
        } else if let Some(inside) = rest.strip_prefix('"') {
            let length = closing(inside);
            found.push((line(rest), inside[..length].replace("\\\n", "\n").replace("\\n", "\n")));
            length + 2
        } else {
            character(rest).unwrap_or(first.len_utf8())
        };
        rest = &rest[taken..];
    }
    found
}

/// Of `r#"…"#` where its text begins, and what ends it.
fn raw(rest: &str) -> Option<(usize, String)> {
    let after = rest.strip_prefix('r')?;
    let signs = after.len() - after.trim_start_matches('#').len();
    after[signs..].starts_with('"').then(|| (signs + 2, format!("\"{}", "#".repeat(signs))))
}

/// The length of a literal before its closing quote.
fn closing(inside: &str) -> usize {
    let mut escaped = false;
    let end = inside.bytes().position(|b| {
        let ends = b == b'"' && !escaped;
        escaped = b == b'\\' && !escaped;
        ends
    });
    end.expect("the end of a literal")
}

/// The length of a character such as `'"'` or `'\''`; `None` for a lifetime.
fn character(rest: &str) -> Option<usize> {
    let inside = rest.strip_prefix('\'')?;
    if inside.starts_with('\\') {
        return Some(inside[2..].find('\'')? + 4);
    }
    let length = inside.chars().next()?.len_utf8();
    inside[length..].starts_with('\'').then_some(length + 2)
}

#[test]
fn texts_for_users_are_plain() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut wrong = Vec::new();
    let mut look = |path: &Path, line: usize, text: &str| {
        let is_page = path.extension().is_some_and(|ending| ending == "md");
        let of_pages = if is_page { listed(PHRASES_OF_PAGES, text) } else { Vec::new() };
        for (phrase, instead) in phrases(text).into_iter().chain(of_pages) {
            wrong.push(format!("{}:{line}: \"{phrase}\": write: {instead}", path.display()));
        }
    };
    let mut pages = folder::files(&root.join("docs"), "md");
    pages.push(root.join("README.md"));
    for page in &pages {
        let text = std::fs::read_to_string(page).expect("a page");
        for (at, paragraph) in paragraphs(&text) {
            look(page, at, &paragraph);
        }
    }
    let sources =
        [folder::files(&root.join("crates"), "rs"), folder::files(&root.join("src"), "rs")].concat();
    let shown = |path: &Path| {
        let name = path.strip_prefix(root).map(|p| p.display().to_string()).unwrap_or_default();
        let of_a_crate = name.starts_with("src/") || name.contains("/src/");
        of_a_crate && !NOT_YET.iter().any(|folder| name.starts_with(folder))
    };
    let mut count = 0;
    for source in sources.iter().filter(|p| shown(p)) {
        let code = std::fs::read_to_string(source).expect("a source");
        for (line, text) in texts(&code, source.starts_with(root.join("src/cli"))) {
            count += 1;
            look(source, line, &without_names(&text));
        }
    }
    assert!(pages.len() > 100 && count > 2000, "texts are found: {} pages, {count} texts", pages.len());
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Paragraphs with the number of their first line.
fn paragraphs(text: &str) -> Vec<(usize, String)> {
    let mut found: Vec<(usize, String)> = Vec::new();
    let mut open = false;
    for (i, line) in text.lines().enumerate() {
        match found.last_mut() {
            _ if line.trim().is_empty() => {
                open = false;
                continue;
            }
            Some((_, paragraph)) if open => {
                paragraph.push('\n');
                paragraph.push_str(line);
            }
            _ => found.push((i + 1, line.to_owned())),
        }
        open = true;
    }
    found
}

#[test]
fn phrases_are_found_as_whole_words() {
    let found = |text: &str| phrases(text).iter().map(|p| p.0).collect::<Vec<_>>();
    assert_eq!(found("The load hangs\non the result."), ["hangs"]);
    assert_eq!(found("Not so: a truth"), ["a truth", "not so:"]);
    assert!(found("thousands of changes; tolerance_of_truth; there is no link").is_empty());
    assert_eq!(found(&without_names("it stands: {stands} {told:?}")), ["stands"]);
    let code = "let x = '\"'; // \"told\"\nlet y = \"a \\\"b\\\"\"; let z: &'a str = r#\"c\"#;";
    assert_eq!(texts(code, false), [(2, "a \\\"b\\\"".to_owned()), (2, "c".to_owned())]);
}
