//! Every code there is, with its page.

/// A code and the page that explains it.
#[derive(Clone, Copy, Debug)]
pub struct Code {
    /// `mech::<stage>::<what_is_wrong>`
    pub code: &'static str,
    /// The page, in Markdown: what it means, why it matters, an example and its fix.
    pub page: &'static str,
}

/// All codes by stage and name.
pub const CODES: &[Code] = &[];

/// The page of a code; the leading `mech::` may be left out.
#[must_use]
pub fn explain(code: &str) -> Option<&'static str> {
    let wanted = code.strip_prefix("mech::").unwrap_or(code);
    CODES.iter().find(|c| c.code.strip_prefix("mech::") == Some(wanted)).map(|c| c.page)
}
