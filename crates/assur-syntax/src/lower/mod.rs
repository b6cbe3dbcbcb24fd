//! From pest's pairs to the document, by a hand walk.
//!
//! A function returns `None` where a pair has not the shape that the grammar promises; the statement is then `Bad`.
//! That does not happen, but a reader of texts should not depend on it.

mod body;
mod expr;
mod label;
mod lenient;
mod machine;
mod motion;
mod plane;
mod question;
mod simulation;
mod table;
mod walk;

use super::document::{Bad, Definition, Statement};
use super::prepare::whole_end;
use super::recover::{self, What};
use super::trivia::corrected;
use super::words::{Grammar, Rule};
use assur_text::diagnostic::{Diagnosis, Problems};
use assur_text::source::{Span, Spanned};
use pest::Parser;
use pest::iterators::Pairs;
use simulation::Lower;
use walk::{P, Parts, span, text};

/// All statements of a file.
pub(super) fn file(text: &str, read: &str, pairs: Pairs<'_, Rule>) -> (Vec<Spanned<Statement>>, Problems) {
    let mut lower = Lower::new(text, read);
    lenient::report(&mut lower, pairs.clone());
    let mut statements = Vec::new();
    for pair in pairs.flat_map(P::into_inner) {
        if pair.as_rule() != Rule::EOI {
            let at = span(&pair);
            let rest = (pair.as_rule() == Rule::bad_statement).then(|| trimmed(&pair));
            let before = lower.problems.len();
            let statement = lower.statement(pair).unwrap_or_else(|| lower.unreadable(at, before));
            statements.push(Spanned::new(statement, rest.unwrap_or(at)));
        }
    }
    plane::points(&mut statements);
    (statements, lower.problems)
}

/// Where a pair that holds plain text stands, without the blanks at its end.
fn trimmed(pair: &P<'_>) -> Span {
    let start = pair.as_span().start();
    Span::new(start, whole_end(pair.get_input(), start + pair.as_str().trim_end().len()))
}

impl Lower<'_> {
    fn statement(&mut self, pair: P<'_>) -> Option<Statement> {
        let rule = pair.as_rule();
        Some(match rule {
            Rule::bad_statement => Statement::Bad(self.bad(&pair, What::Statement)),
            Rule::edition => Statement::Edition(self.after_word(pair)?),
            Rule::title => Statement::Title(self.title(pair)?),
            Rule::given => Statement::Given(self.definition(pair)?),
            Rule::let_ => Statement::Let(self.definition(pair)?),
            Rule::gravity => {
                let mut parts = Parts::of(pair);
                parts.any()?;
                Statement::Gravity(self.expr(parts.any()?)?)
            }
            Rule::ground | Rule::link | Rule::shaft | Rule::slider => self.link(pair)?,
            Rule::joint => Statement::Joint(self.joint(pair)?),
            Rule::spring => Statement::Spring(self.spring(pair)?),
            Rule::group => Statement::Group(self.group(pair)?),
            Rule::all => Statement::All(self.all(pair)?),
            Rule::cam => Statement::Cam(self.cam(pair)?),
            Rule::counterweight => Statement::Counterweight(self.counterweight(pair)?),
            Rule::flywheel => Statement::Flywheel(self.flywheel(pair)?),
            Rule::brake => Statement::Brake(self.brake(pair)?),
            Rule::drive => Statement::Drive(self.drive(pair)?),
            Rule::pose => Statement::Pose(self.pose(pair)?),
            Rule::assemble => Statement::Assemble(self.assemble(pair)?),
            Rule::balance => Statement::Balance(self.balance(pair)?),
            Rule::load => Statement::Load(Box::new(self.load(pair)?)),
            Rule::start => Statement::Start(self.start(pair)?),
            Rule::equilibrium => Statement::Equilibrium(self.equilibrium(pair)?),
            Rule::find => Statement::Find(self.find(pair)?),
            Rule::expect => Statement::Expect(Box::new(self.expect(pair)?)),
            Rule::variants => Statement::Variants(self.rows(pair.into_inner())),
            Rule::curve => Statement::Curve(self.curve(pair)?),
            Rule::simulate => Statement::Simulate(self.simulate(pair)?),
            Rule::event => Statement::Event(self.event(pair)?),
            Rule::stop => Statement::Stop(self.stop(pair)?),
            Rule::until => Statement::Until(self.until(pair)?),
            Rule::ignore => {
                let mut parts = Parts::of(pair);
                parts.any()?;
                Statement::Ignore(parts.name()?)
            }
            _ => return None,
        })
    }

    /// The text of the part after a statement's word.
    fn after_word(&self, pair: P<'_>) -> Option<Spanned<String>> {
        let mut parts = Parts::of(pair);
        parts.any()?;
        parts.any().map(|p| text(&p))
    }

    fn title(&mut self, pair: P<'_>) -> Option<Spanned<String>> {
        let mut parts = Parts::of(pair);
        parts.any()?;
        let part = parts.any()?;
        let at = trimmed(&part);
        let written = self.text.get(at.start..at.end)?;
        let bare = |c: char| c.is_whitespace() || "\"“”„«»‟＂".contains(c);
        let title = written.trim_matches(bare).to_owned();
        let help = corrected(self.text, at, &format!("\"{title}\""));
        match part.as_rule() {
            Rule::lenient_unclosed_text => self.problems.push(
                Diagnosis::error("mech::syntax::unclosed_text", "a text is not closed")
                    .label(at, "the closing quote is missing on this line")
                    .help(help.certain()),
            ),
            Rule::lenient_bare_title => self.problems.push(
                Diagnosis::error("mech::syntax::title_without_quotes", "put the title in quotes")
                    .label(at, "the title")
                    .help(help.certain()),
            ),
            _ => {}
        }
        Some(Spanned::new(title, at))
    }

    fn definition(&mut self, pair: P<'_>) -> Option<Definition> {
        let mut parts = Parts::of(pair);
        parts.any()?;
        Some(Definition { name: parts.name()?, value: self.expr(parts.any()?)? })
    }

    /// Reports what an error production caught.
    fn bad(&mut self, pair: &P<'_>, what: What) -> Bad {
        let at = trimmed(pair);
        let brace = at.end.saturating_sub(1);
        if self.closing.contains(&brace) {
            let before = Span::new(at.start, brace);
            let rest = self.read.get(before.start..before.end).unwrap_or_default();
            if rest.trim().is_empty() || Grammar::parse(Rule::one_statement, rest.trim_end()).is_ok() {
                return self.names(before);
            }
        }
        recover::report(self.text, self.read, at, what, &mut self.problems, &mut self.reserved)
    }

    /// A pair that could not be lowered; reported, unless something has been since there were `before` problems.
    fn unreadable(&mut self, at: Span, before: usize) -> Statement {
        if self.problems.len() == before {
            self.problems.push(recover::unreadable(at));
        }
        Statement::Bad(self.names(at))
    }

    /// What cannot be read, with the names in it.
    fn names(&self, at: Span) -> Bad {
        Bad { names: recover::names(self.read.get(at.start..at.end).unwrap_or_default()) }
    }
}
