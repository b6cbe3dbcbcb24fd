//! What is said about a text, built where the fault arises.

use super::{CODES, Fix, Help, Problem, Undeclared};
use crate::source::Span;
use miette::{Diagnostic, LabeledSpan, Severity};
use std::fmt::{self, Display};

/// An error, a warning or advice: what it says, where, and what to do about it.
#[derive(Clone, Debug)]
pub struct Diagnosis(Box<Parts>);

#[derive(Clone, Debug)]
struct Parts {
    /// Empty where no page explains it.
    code: &'static str,
    severity: Severity,
    message: String,
    labels: Vec<LabeledSpan>,
    help: Option<Help>,
    fixes: Vec<Fix>,
    undeclared: Option<Undeclared>,
    subject: Option<String>,
}

impl Diagnosis {
    /// Something without which the text cannot be used. `code` is `mech::<stage>::<what_is_wrong>`.
    #[must_use]
    pub fn error(code: &'static str, message: impl Into<String>) -> Self {
        Self::new(code, Severity::Error, message.into())
    }

    /// Something that is probably not meant.
    #[must_use]
    pub fn warning(code: &'static str, message: impl Into<String>) -> Self {
        Self::new(code, Severity::Warning, message.into())
    }

    /// Something to know.
    #[must_use]
    pub fn advice(code: &'static str, message: impl Into<String>) -> Self {
        Self::new(code, Severity::Advice, message.into())
    }

    fn new(code: &'static str, severity: Severity, message: String) -> Self {
        let (labels, fixes) = (Vec::new(), Vec::new());
        let (help, undeclared, subject) = (None, None, None);
        Self(Box::new(Parts { code, severity, message, labels, help, fixes, undeclared, subject }))
    }

    /// What another diagnostic says, without its fixes: they are for the text alone.
    #[must_use]
    pub fn copied(problem: &dyn Diagnostic) -> Self {
        let severity = problem.severity().unwrap_or_default();
        let mut copy = Self::new("", severity, problem.to_string());
        let code = problem.code().map(|code| code.to_string());
        copy.0.code =
            CODES.iter().map(|known| known.code).find(|known| Some(*known) == code.as_deref()).unwrap_or("");
        copy.0.labels = problem.labels().into_iter().flatten().collect();
        copy.0.help = problem.help().map(|help| help.to_string().into());
        copy
    }

    /// The same, of this row of variants: `row` is it in words, `span` its place in the file's own table.
    #[must_use]
    pub fn of_row(mut self, row: &str, span: Option<Span>) -> Self {
        self.0.message = format!("{row}: {}", self.0.message);
        self.label(span, "with this row")
    }

    /// The same as something that does not make the text useless.
    #[must_use]
    pub fn as_warning(mut self) -> Self {
        self.0.severity = Severity::Warning;
        self
    }

    /// The place it is about; of several labels without such a place, the first.
    #[must_use]
    pub fn primary(mut self, at: impl Into<Option<Span>>, text: impl Into<String>) -> Self {
        let label = |at| LabeledSpan::new_primary_with_span(Some(text.into()), at);
        self.0.labels.extend(at.into().map(label));
        self
    }

    /// A place, if there is one, with what is said of it.
    #[must_use]
    pub fn label(mut self, at: impl Into<Option<Span>>, text: impl Into<String>) -> Self {
        let label = |at| LabeledSpan::new_with_span(Some(text.into()), at);
        self.0.labels.extend(at.into().map(label));
        self
    }

    /// Several places of which the same is said.
    #[must_use]
    pub fn each(self, places: impl IntoIterator<Item = Span>, text: &str) -> Self {
        places.into_iter().fold(self, |all, at| all.label(at, text))
    }

    /// Several places.
    #[must_use]
    pub fn labels(mut self, labels: impl IntoIterator<Item = LabeledSpan>) -> Self {
        self.0.labels.extend(labels);
        self
    }

    /// What to do. The fixes from which it is printed are offered.
    #[must_use]
    pub fn help(self, help: impl Into<Help>) -> Self {
        self.help_if(Some(help))
    }

    /// What to do, where that is known.
    #[must_use]
    pub fn help_if(mut self, help: Option<impl Into<Help>>) -> Self {
        self.0.help = help.map(Into::into);
        self
    }

    /// Offers the words that the help quotes, each in a place: see [`Fix::quoted`].
    #[must_use]
    pub fn quoted(self, at: Span) -> Self {
        let help = self.0.help.as_ref().map(ToString::to_string).unwrap_or_default();
        self.fixes(Fix::quoted(&help, at))
    }

    /// Offers the lines that the help sets apart: see [`Fix::added`].
    #[must_use]
    pub fn added(self) -> Self {
        let help = self.0.help.as_ref().map(ToString::to_string).unwrap_or_default();
        self.fixes(Fix::added(&help))
    }

    /// Offers to leave out what is in a place.
    #[must_use]
    pub fn left_out(self, what: &str, at: Span) -> Self {
        self.fixes([Fix::left_out(what, at)])
    }

    /// Offers changes of the text.
    #[must_use]
    pub fn fixes(mut self, fixes: impl IntoIterator<Item = Fix>) -> Self {
        self.0.fixes.extend(fixes);
        self
    }

    /// It is about a word that is written, or that is to be.
    #[must_use]
    pub fn about(mut self, word: &str) -> Self {
        self.0.subject = Some(word.to_owned());
        self
    }

    /// The word that it is about.
    #[must_use]
    pub fn subject(&self) -> Option<&str> {
        self.0.subject.as_deref()
    }

    /// Whether it has this code.
    #[must_use]
    pub fn is(&self, code: &str) -> bool {
        self.0.code == code
    }

    /// It is about a name that is used and not declared.
    #[must_use]
    pub fn undeclared(mut self, name: Undeclared) -> Self {
        self.0.undeclared = Some(name);
        self
    }
}

impl Display for Diagnosis {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0.message)
    }
}

impl std::error::Error for Diagnosis {}

impl Diagnostic for Diagnosis {
    fn code<'a>(&'a self) -> Option<Box<dyn Display + 'a>> {
        (!self.0.code.is_empty()).then(|| Box::new(self.0.code) as _)
    }

    fn severity(&self) -> Option<Severity> {
        Some(self.0.severity)
    }

    fn help<'a>(&'a self) -> Option<Box<dyn Display + 'a>> {
        self.0.help.as_ref().map(|help| Box::new(help) as _)
    }

    fn labels(&self) -> Option<Box<dyn Iterator<Item = LabeledSpan> + '_>> {
        (!self.0.labels.is_empty()).then(|| Box::new(self.0.labels.iter().cloned()) as _)
    }
}

impl Problem for Diagnosis {
    fn fixes(&self) -> Vec<Fix> {
        let of_help = self.0.help.iter().flat_map(Help::fixes);
        of_help.chain(&self.0.fixes).cloned().collect()
    }

    fn undeclared(&self) -> Option<&Undeclared> {
        self.0.undeclared.as_ref()
    }
}
