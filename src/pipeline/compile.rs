//! Text → mechanism, structure and plan. A text is read once, however often it is checked.

use super::equilibrium::settle;
use assur_check as check;
use assur_check::Overrides;
use assur_model::model::Mechanism;
use assur_model::structure::{self, Structure};
use assur_position::plan::{self, Plan};
use assur_solve::message::clause;
use assur_solve::solve::{Model, assemblies};
use assur_syntax as syntax;
use assur_syntax::document::Document;
use assur_text::diagnostic::{DiagnosticView, Problems};
use assur_text::source::{Edit, Source, edited};
use std::sync::Arc;

/// A checked mechanism with its structure and its plan.
#[derive(Clone, Debug)]
pub struct Compiled {
    pub mechanism: Mechanism,
    pub structure: Structure,
    /// How it is solved.
    pub plan: Plan,
    /// Its source, if its answers need other solutions: see [`Mechanism::asks_again`].
    pub origin: Option<Origin>,
}

/// A document with the values that replace some of its own.
#[derive(Clone, Debug)]
pub struct Origin {
    pub document: Arc<Document>,
    pub overrides: Overrides,
}

impl Compiled {
    /// As the solver sees it.
    #[must_use]
    pub fn model(&self) -> Model<'_> {
        Model { mechanism: &self.mechanism, structure: &self.structure, plan: &self.plan }
    }
}

/// Text → [`Mechanism`], with all problems found. There is no mechanism if there is an error.
#[must_use]
pub fn check_source(source: &Source, overrides: &Overrides) -> (Option<Mechanism>, Problems) {
    let (document, mut problems) = syntax::parse(source);
    let (mechanism, found) = check::check(&document, overrides);
    problems.append_later(found);
    (mechanism.filter(|_| !problems.has_errors()), problems)
}

/// Text → [`Compiled`]: checked, decomposed into structural groups, planned. Nothing is solved. The result can be
/// used even if the problems contain an error: forces that are asked for but not determined.
#[must_use]
pub fn compile(source: &Source, overrides: &Overrides) -> (Option<Compiled>, Problems) {
    let (document, found) = syntax::parse(source);
    compile_document(source, &Arc::new(document), found, overrides)
}

/// As [`compile`], of a document in which `found` was found on reading.
#[must_use]
pub fn compile_document(
    source: &Source,
    document: &Arc<Document>,
    found: Problems,
    overrides: &Overrides,
) -> (Option<Compiled>, Problems) {
    compile_checked(source, document, found, overrides, check::check(document, overrides))
}

/// What is found in a document before anything is solved.
#[derive(Debug)]
pub struct CompileFindings {
    /// It compiled, as [`compile_document`] does.
    pub compiled: Option<Compiled>,
    /// All that was found wrong.
    pub problems: Problems,
    /// Where names are used, in a text with errors too.
    pub uses: Vec<check::Use>,
    /// The definitions that are constant numbers, in the units of the text.
    pub constants: Vec<(String, String)>,
}

/// As [`compile_document`], with what an editor asks for.
#[must_use]
pub fn analyze(source: &Source, document: &Arc<Document>, found: Problems) -> CompileFindings {
    let is_read = !found.has_errors();
    let of_file = look_with(source, document, found, &Overrides::none());
    let row = if is_read && of_file.problems.has_errors() { first_row(document) } else { None };
    let Some(row) = row else { return of_file };
    // what every row replaces is no mistake
    let overrides = Overrides { row, ..Overrides::none() };
    let of_row = look_with(source, document, assur_syntax::parse(source).1, &overrides);
    if of_row.problems.has_errors() {
        return of_file;
    }
    CompileFindings { compiled: of_row.compiled, problems: of_row.problems, ..of_file }
}

fn look_with(
    source: &Source,
    document: &Arc<Document>,
    found: Problems,
    overrides: &Overrides,
) -> CompileFindings {
    let check::CheckFindings { mechanism, problems, uses, constants } = check::analyze(document, overrides);
    let (compiled, problems) = compile_checked(source, document, found, overrides, (mechanism, problems));
    CompileFindings { compiled, problems, uses, constants }
}

/// The first row of a table of variants.
pub(super) fn first_row(document: &Document) -> Option<check::Row> {
    let table = check::table(document)?;
    let columns: Arc<[check::RowColumn]> = check::columns(document, &Overrides::none(), table).0?.into();
    Some(check::file_rows(table, &columns).into_iter().next()?.row)
}

fn compile_checked(
    source: &Source,
    document: &Arc<Document>,
    mut found: Problems,
    overrides: &Overrides,
    (mechanism, checked): (Option<Mechanism>, Problems),
) -> (Option<Compiled>, Problems) {
    let is_read = !found.has_errors();
    let Some(mechanism) = mechanism.filter(|_| is_read && !checked.has_errors()) else {
        match if is_read { structural_cause(source, document, overrides, &checked) } else { None } {
            Some(defects) => found.append(defects),
            None => found.append_later(checked),
        }
        return (None, found);
    };
    found.append_later(checked);
    let origin = mechanism
        .asks_again()
        .then(|| Origin { document: Arc::clone(document), overrides: overrides.clone() });
    plan_mechanism(mechanism, None, found, origin, Some(Text { source, document, overrides }))
}

/// Where a mechanism is written.
#[derive(Clone, Copy)]
pub(super) struct Text<'a> {
    pub source: &'a Source,
    pub document: &'a Document,
    pub overrides: &'a Overrides,
}

/// Errors of guides and bars may be those of a pair that is missing or too many.
const FOLLOW: [&str; 2] = ["mech::geometry::no_guide", "mech::request::bends"];

/// The defects of the structure, where the errors of the check all follow from them: names of a pair that is missing, and
/// those that may follow from any.
fn structural_cause(
    source: &Source,
    document: &Document,
    overrides: &Overrides,
    checked: &Problems,
) -> Option<Problems> {
    let sound = check::sound_part(document, overrides);
    if let Some(error) = super::lost::undeclared(checked, &sound, Text { source, document, overrides }) {
        return Some(Problems::of([error]));
    }
    let defects = structure::structure(&sound).err()?;
    let mut structural = Problems::new();
    structural.extend(defects.into_iter().map(super::mends::with_lines));
    let proposed = structural.views(source).iter().flat_map(proposed_names).collect::<Vec<_>>();
    let pins = structural.views(source).iter().any(|d| proposed_lines(d).any(|l| l.starts_with("revolute ")));
    let follows = |d: &DiagnosticView| {
        d.severity != "error"
            || d.code.as_deref().is_some_and(|code| FOLLOW.contains(&code))
            // wheels need a bearing
            || pins && d.code.as_deref() == Some("mech::train::no_carrier")
            // a pair that is there and has an error is not missing
            || d.code.as_deref().is_some_and(|code| code.starts_with("mech::name::"))
                && proposed.iter().any(|name| d.message.contains(&format!("`{name}`")))
    };
    (checked.has_errors() && checked.views(source).iter().all(follows)).then_some(structural)
}

/// The names of the pairs that a help proposes to add.
fn proposed_names(defect: &DiagnosticView) -> Vec<String> {
    proposed_lines(defect)
        .filter_map(|line| Some(line.split_once(':')?.0.split_once(' ')?.1.to_owned()))
        .collect()
}

/// The lines that a help proposes to add.
fn proposed_lines(defect: &DiagnosticView) -> impl Iterator<Item = &str> {
    let lines = defect.help.iter().flat_map(|help| help.lines());
    lines.filter(|line| line.starts_with("  ")).map(str::trim)
}

/// Structure and plan of a mechanism; the structure is known where another row of the same text has the same.
pub(super) fn plan_mechanism(
    mut mechanism: Mechanism,
    known: Option<Structure>,
    mut problems: Problems,
    origin: Option<Origin>,
    text: Option<Text<'_>>,
) -> (Option<Compiled>, Problems) {
    if let Err(misfit) = super::repeated::leave_out(&mut mechanism) {
        problems.extend([misfit]);
        return (None, problems);
    }
    structure::start_what_parts(&mut mechanism);
    let found = known.map_or_else(|| structure::structure(&mechanism), |known| Ok((known, Vec::new())));
    match found {
        Ok((structure, warnings)) => {
            problems.extend(warnings);
            if let Err(unsettled) = settle(&mut mechanism) {
                problems.extend([unsettled]);
                return (None, problems);
            }
            let plan = plan::plan(&mechanism, &structure);
            problems.extend(structure.force_defect.clone().filter(|_| plan.effects.forces));
            (Some(Compiled { mechanism, structure, plan, origin }), problems)
        }
        Err(mut errors) => {
            super::agrees::tell(&mechanism, &mut errors);
            let with_fixes = |error| match text {
                Some(text) => super::mends::with_fixes(error, &mechanism, text),
                None => error,
            };
            problems.extend(errors.into_iter().map(with_fixes));
            (None, problems)
        }
    }
}

// The clauses that choose between the assemblies of a mechanism at its first position.

/// The clauses of all groups that have several assemblies, as they follow `assemble`; whether the file chooses so.
#[must_use]
pub fn assembly_clauses(compiled: &Compiled) -> Vec<(String, bool)> {
    let model = compiled.model();
    let groups = assemblies(&model).map(|found| found.groups).unwrap_or_default();
    let all = groups.iter().flat_map(|group| &group.assemblies);
    all.filter_map(|one| {
        let line = clause(&model, one.clause.as_ref()?);
        Some((line.strip_prefix("assemble ").unwrap_or(&line).to_owned(), one.chosen))
    })
    .collect()
}

// Applies fixes about which there is no doubt.

/// How often a text is looked at again: a fix can reveal what it hid.
const ROUNDS: usize = 20;

/// A text with all certain fixes, and how many were applied.
#[must_use]
pub fn fixed(source: &Source, overrides: &Overrides) -> (Source, usize) {
    let mut source = source.clone();
    let mut count = 0;
    for _ in 0..ROUNDS {
        let (edits, fixes) = certain_edits(&compile(&source, overrides).1);
        if fixes == 0 {
            break;
        }
        source.text = edited(&source.text, &edits);
        count += fixes;
    }
    (source, count)
}

/// The edits of the certain fixes that do not touch each other, in order, and how many fixes they are.
#[must_use]
pub fn certain_edits(problems: &Problems) -> (Vec<Edit>, usize) {
    let mut fixes = problems.fixes();
    fixes.retain(|fix| fix.certain && !fix.edits.is_empty());
    fixes.sort_by(|a, b| a.edits.cmp(&b.edits));
    let (mut edits, mut count, mut end) = (Vec::<Edit>::new(), 0, None);
    for fix in fixes {
        let start = fix.edits[0].span.start;
        if end.is_none_or(|end| start > end) {
            end = fix.edits.last().map(|edit| edit.span.end);
            edits.extend(fix.edits);
            count += 1;
        }
    }
    (edits, count)
}
