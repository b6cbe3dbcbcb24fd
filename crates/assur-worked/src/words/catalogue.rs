//! The texts of the languages: one file each, sections of keys and texts.

use super::Language;
use std::collections::BTreeMap;
use std::sync::OnceLock;

/// A key and its text.
type Row = (&'static str, &'static str);

/// The texts of a language.
struct Catalogue {
    /// The rows of every section, in the order of the file: a pattern may begin as a later one does.
    sections: BTreeMap<&'static str, Vec<Row>>,
    texts: BTreeMap<Row, &'static str>,
}

impl Catalogue {
    fn of(file: &'static str) -> Self {
        let mut all = Self { sections: BTreeMap::new(), texts: BTreeMap::new() };
        let mut section = "";
        for line in file.lines() {
            if let Some(name) = line.strip_prefix('[').and_then(|name| name.strip_suffix(']')) {
                section = name;
            } else if let Some((key, text)) = line.split_once(" | ").filter(|_| !line.starts_with('#')) {
                all.sections.entry(section).or_default().push((key, text));
                all.texts.entry((section, key)).or_insert(text);
            }
        }
        all
    }
}

fn catalogue(language: Language) -> &'static Catalogue {
    static ALL: [OnceLock<Catalogue>; 3] = [const { OnceLock::new() }; 3];
    let (index, file) = match language {
        Language::English => (0, include_str!("../../messages/en.txt")),
        Language::Chinese => (1, include_str!("../../messages/zh.txt")),
        Language::Russian => (2, include_str!("../../messages/ru.txt")),
    };
    ALL[index].get_or_init(|| Catalogue::of(file))
}

/// The text of a key; the key itself where a file lacks it, which `tests/worked/languages.rs` rules out.
pub(super) fn text(language: Language, section: &'static str, key: &'static str) -> &'static str {
    catalogue(language).texts.get(&(section, key)).copied().unwrap_or(key)
}

/// The key of this name, if the section has it.
pub(super) fn key(section: &str, name: &str) -> Option<&'static str> {
    rows(Language::English, section).iter().find_map(|row| (row.0 == name).then_some(row.0))
}

/// The rows of a section, in the order of the file.
pub(super) fn rows(language: Language, section: &str) -> &'static [Row] {
    catalogue(language).sections.get(section).map_or(&[], Vec::as_slice)
}
