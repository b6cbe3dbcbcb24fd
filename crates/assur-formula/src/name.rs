//! Letters of quantities.

/// The letters of a quantity: `R` with the index 12 and the mark t.
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Name {
    pub letter: String,
    pub sub: String,
    /// The mark above: n, t, k.
    pub sup: String,
    pub vector: bool,
}

impl Name {
    /// A letter with an index.
    #[must_use]
    pub fn new(letter: &str, sub: &str) -> Self {
        Self { letter: letter.to_owned(), sub: sub.to_owned(), ..Self::default() }
    }

    #[must_use]
    pub fn marked(&self, sup: &str) -> Self {
        Self { sup: sup.to_owned(), ..self.clone() }
    }

    /// With more behind its index; behind a word a letter is set apart.
    #[must_use]
    pub fn and(&self, more: &str) -> Self {
        let is_letter = more.len() == 1 && more.chars().all(char::is_alphabetic);
        let word = self.sub.chars().rev().take_while(|c| c.is_alphabetic()).count() > 2;
        let apart = if is_letter && word { "," } else { "" };
        Self { sub: format!("{}{apart}{more}", self.sub), ..self.clone() }
    }

    /// Its index, or its letter where it has none.
    #[must_use]
    pub fn sub_or_letter(&self) -> String {
        if self.sub.is_empty() { self.letter.clone() } else { self.sub.clone() }
    }

    #[must_use]
    pub fn arrow(&self) -> Self {
        Self { vector: true, ..self.clone() }
    }
}
