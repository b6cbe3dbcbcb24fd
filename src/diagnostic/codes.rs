//! Every code there is, with its page.

/// A code and the page that explains it.
#[derive(Clone, Copy, Debug)]
pub struct Code {
    /// `mech::<stage>::<what_is_wrong>`
    pub code: &'static str,
    /// The page, in Markdown: what it means, why it matters, an example and its fix.
    pub page: &'static str,
}

/// A row is a stage and a name; its page is `docs/explain/<stage>/<name>.md`.
macro_rules! codes {
    ($($stage:literal / $name:literal,)*) => {
        &[$(Code {
            code: concat!("mech::", $stage, "::", $name),
            page: include_str!(concat!("../../docs/explain/", $stage, "/", $name, ".md")),
        }),*]
    };
}

/// All codes, in the order of the stages.
pub const CODES: &[Code] = codes! {
    // syntax
    "syntax" / "empty_file",
    "syntax" / "full_width",
    "syntax" / "curly_quotes",
    "syntax" / "foreign_sign",
    "syntax" / "invisible_character",
    "syntax" / "lone_carriage_return",
    "syntax" / "too_deep",
    "syntax" / "bare_decimal_point",
    "syntax" / "number_too_large",
    "syntax" / "decimal_comma",
    "syntax" / "brace_on_its_own_line",
    "syntax" / "missing_brace",
    "syntax" / "unclosed_bracket",
    "syntax" / "unmatched_bracket",
    "syntax" / "equals_expected",
    "syntax" / "colon_expected",
    "syntax" / "unclosed_text",
    "syntax" / "title_without_quotes",
    "syntax" / "title_twice",
    "syntax" / "unknown_edition",
    "syntax" / "edition_not_first",
    "syntax" / "unit_in_row",
    "syntax" / "misspelt_word",
    "syntax" / "unknown_statement",
    "syntax" / "misplaced_member",
    "syntax" / "reserved_name",
    "syntax" / "two_statements",
    "syntax" / "missing_word",
    "syntax" / "missing_operator",
    "syntax" / "third_coordinate",
    "syntax" / "comment_sign",
    "syntax" / "point_without_coordinates",
    "syntax" / "unexpected",
    "syntax" / "other_word",
    "syntax" / "needless_sign",
    "syntax" / "comma_between",
    "syntax" / "without_brackets",
    "syntax" / "digit_first",
    // check

    // structure

    // plan

    // solve

    // element

    // exercise

};

/// The page of a code; the leading `mech::` may be left out.
#[must_use]
pub fn explain(code: &str) -> Option<&'static str> {
    let wanted = code.strip_prefix("mech::").unwrap_or(code);
    CODES.iter().find(|c| c.code.strip_prefix("mech::") == Some(wanted)).map(|c| c.page)
}
