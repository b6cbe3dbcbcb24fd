//! Every wrong file below `tests/errors/<stage>/<code>/`, and what its author sees.
//!
//! A file's snapshot stands beside it. The folder's name is the code that must be among those reported.

mod folder;

use assur::internals::check::Overrides;
use assur::internals::diagnostic::{Diagnosis, Problems, Style, render};
use assur::internals::drawing::Scale;
use assur::internals::exercise::grade::{Credit, Points, Rules, Sheet, grade};
use assur::internals::exercise::table::{Fault, Lines, Table};
use assur::internals::handout::course::{
    Chapter, CourseError, Moodle, Page, Picture, QuizOptions, Steps, checked_credit,
};
use assur::internals::handout::{Handout, Sheets};
use assur::internals::picture::{KINDS, Options, Scaled, Scene, true_size};
use assur::internals::source::Source;
use assur::internals::worked::Language;
use libtest_mimic::{Arguments, Failed, Trial};
use std::path::Path;

fn main() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/errors");
    let mut trials = folder::files(&root, "mech")
        .into_iter()
        .map(|path| {
            let name = path.strip_prefix(&root).unwrap_or(&path).display().to_string();
            Trial::test(name, move || shows(&path))
        })
        .collect::<Vec<_>>();
    trials.push(Trial::test("every code has its page and its smallest file", every_code));
    libtest_mimic::run(&Arguments::from_args(), trials).exit();
}

/// The code that a file's folders name.
fn code_of(path: &Path) -> Option<String> {
    let folder = path.parent()?;
    let name = folder.file_name()?.to_str()?;
    let stage = folder.parent()?.file_name()?.to_str()?;
    Some(format!("mech::{stage}::{name}"))
}

/// `syntax` of `mech::syntax::empty_file`
fn stage_of(code: &str) -> &str {
    code.split("::").nth(1).unwrap_or_default()
}

/// What is said about a text; a first line `// --set r=120mm` gives it a value from outside, `// --within 1e-9` an accuracy. The files of the early
/// stages are no whole mechanisms: they are read, or checked, but not solved.
fn said(source: &Source, stage: &str) -> String {
    if stage == "syntax" {
        return render(&assur::internals::syntax::parse(source).1, source, Style::PLAIN);
    }
    if let Some(shown) = beside(source) {
        return shown;
    }
    if stage == "course" {
        return render(&asked(source), source, Style::PLAIN);
    }
    if stage == "sheet" {
        let (document, found) = assur::internals::syntax::parse(source);
        let handout = Handout::new(source, document.into(), Overrides::none(), Language::English, None);
        return render(&Sheets::of(&handout, found).for_all().1, source, Style::PLAIN);
    }
    let set = source.text.lines().next().and_then(|line| line.strip_prefix("// --set ")?.split_once('='));
    let values = set.into_iter().map(|(name, value)| (name.to_owned(), value.to_owned())).collect();
    let overrides = Overrides::set(values);
    let within = source.text.lines().next().and_then(|line| line.strip_prefix("// --within ")?.parse().ok());
    if let Some(within) = within {
        let (compiled, mut problems) = assur::internals::compile(source, &Overrides::none());
        if let Some(compiled) = compiled {
            problems.append(assur::internals::solve_within(compiled, Some(within)).1);
        }
        return render(&problems, source, Style::PLAIN);
    }
    let problems = match stage {
        "picture" => drawn(source),
        "name" | "unit" | "geometry" => assur::internals::check_source(source, &overrides).1,
        _ => assur::internals::test_source(source, &overrides).1,
    };
    render(&problems, source, Style::PLAIN)
}

/// What is said about the pictures of a text, of all kinds; a first line `// --pose 9` names the position, `// --path crank.B`
/// a point, `// --length 0.0001` the scale, `// --true-size` true size.
fn drawn(source: &Source) -> Problems {
    let (solved, mut problems) = assur::internals::pipeline::solve_drawn(source, &Overrides::none(), &KINDS);
    let Some(solved) = solved else { return problems };
    let option = |word: &str| source.text.lines().next().and_then(|line| line.strip_prefix(word));
    let (name, path) = (option("// --pose "), option("// --path "));
    let mut options = Options::default();
    options.scheme.paths.extend(path.map(str::to_owned));
    let scale = option("// --length ").and_then(|factor| Scale::fitting(factor.parse().ok()?, 1.0));
    if let Some(scale) = scale {
        options.scheme.scales = options.scheme.scales.with(Scaled::Length, scale);
    }
    let turn = assur::internals::pipeline::turn(&solved.compiled, &solved.solution);
    let file = (source.name.as_str(), source.text.as_str());
    match Scene::of(solved.compiled.model(), &solved.solution, file, name) {
        Ok(scene) => {
            let scene = Scene { turn: &turn, ..scene };
            if option("// --true-size").is_some() {
                problems.extend(true_size(&scene, &options.scheme).err());
                return problems;
            }
            // what a first line names is of the scheme
            let of_all = options.scheme.paths.is_empty() && scale.is_none();
            let kinds = if of_all { &KINDS[..] } else { &KINDS[..1] };
            let drawn = kinds.iter().map(|kind| assur::internals::picture::draw(*kind, &scene, &options));
            problems.extend(drawn.filter_map(Result::err));
        }
        Err(missing) => problems.push(missing),
    }
    problems
}

/// What is said about a question for a course; a first line `// course --credit sign=0.37` gives an option.
fn asked(source: &Source) -> Problems {
    let first = source.text.lines().next().unwrap_or_default();
    let option = |word: &str| first.strip_prefix("// course ").and_then(|line| line.strip_prefix(word));
    let rules = Rules {
        credit: Credit::read(option("--credit ").unwrap_or_default()).unwrap_or_default(),
        points: Points::read(option("--points ").unwrap_or_default()).unwrap_or_default(),
        ..Rules::default()
    };
    if let Err(error) = checked_credit(&rules.credit) {
        return Problems::of([error]);
    }
    if option("--picture png").is_some() {
        return Problems::of([CourseError::NoPixels]);
    }
    let (document, found) = assur::internals::syntax::parse(source);
    let handout = Handout::new(source, document.into(), Overrides::none(), Language::English, None);
    let sheets = Sheets::of(&handout, found);
    let options = QuizOptions { rules: &rules, steps: &Steps::None, pictures: false };
    let (mut problems, mut all) = (sheets.problems.clone(), Vec::new());
    sheets.quizzes(&sheets.rows, options, |row, quiz, found| {
        problems.append(found);
        let row = row.name();
        let moodle = Moodle {
            file: "a",
            title: "A",
            row: &row,
            several: true,
            pose: None,
            one_per_answer: false,
            unit_penalty: 1.0,
            picture: Picture::None,
        };
        if let Some(quiz) = quiz {
            problems.extend(quiz.verdicts.iter().map(|name| CourseError::VerdictIsNoNumber {
                file: source.name.clone(),
                name: name.clone(),
            }));
            match moodle.questions(&quiz, &|_| Ok::<_, CourseError>(Vec::new())) {
                Ok(questions) => all.extend(questions.into_iter().map(|one| (row.clone(), one))),
                Err(error) => problems.push(error),
            }
        }
        true
    });
    problems.extend(Page::new("week 3").add(Chapter { file: "a", title: "A", questions: &all }).err());
    problems
}

/// What is said about the tables that a first line names: `// --variants table.csv`, `// grade key.csv answers.csv`.
fn beside(source: &Source) -> Option<String> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/errors");
    let open = |name: &str| std::fs::File::open(folder.join(name)).ok().map(std::io::BufReader::new);
    let shown = |(source, error): Fault| {
        let mut problems = Problems::new();
        problems.push(*error);
        render(&problems, &source, Style::PLAIN)
    };
    let line = source.text.lines().next()?;
    if let Some(name) = line.strip_prefix("// --variants ") {
        let mut table = match Table::open(name, open(name)?).ok()? {
            Ok(table) => table,
            Err(fault) => return Some(shown(fault)),
        };
        let (document, _) = assur::internals::syntax::parse(source);
        let (columns, problems) =
            assur::internals::check::columns(&document, &Overrides::none(), &table.columns);
        let Some(columns) = columns else { return Some(render(&problems, &table.header, Style::PLAIN)) };
        let (columns, mut lines) = (columns.into(), Lines::default());
        table.lines(1000, &mut lines).ok()?;
        let rows = (0..lines.len()).filter_map(|i| lines.get(i)?.read(name, &columns, table.separator).err());
        return Some(rows.chain(table.without_rows()).map(shown).collect::<Vec<_>>().join("\n"));
    }
    let (key, answers) = line.strip_prefix("// grade ")?.split_once(' ')?;
    let graded = match Sheet::read(key, open(key)?, None).ok()? {
        Err(fault) => Err(fault),
        Ok(key) => match Sheet::read(answers, open(answers)?, Some(&key)).ok()? {
            Err(fault) => Err(fault),
            Ok(answers) => grade(&key, answers, &Rules::default()),
        },
    };
    let warned = |(source, error): Fault| {
        render(&Problems::of([Diagnosis::copied(&*error).as_warning()]), &source, Style::PLAIN)
    };
    Some(match graded {
        Err(fault) => shown(fault),
        Ok(graded) => graded.left_out.into_iter().map(warned).collect::<Vec<_>>().join("\n"),
    })
}

fn shows(path: &Path) -> Result<(), Failed> {
    let name = path.file_name().and_then(|n| n.to_str()).ok_or("a name")?.to_owned();
    let source = Source::new(&name, std::fs::read_to_string(path)?);
    let code = code_of(path).ok_or("a stage and a code")?;
    let shown = said(&source, stage_of(&code));
    if assur::internals::diagnostic::explain(&code).is_none() {
        return Err(format!("{code} has no page").into());
    }
    if !shown.contains(&code) {
        return Err(format!("{code} is not among what is reported:\n{shown}").into());
    }
    let folder = path.parent().ok_or("a folder")?;
    let snapshot = std::panic::catch_unwind(|| {
        insta::with_settings!({
            snapshot_path => folder,
            prepend_module_to_snapshot => false,
            omit_expression => true,
        }, {
            insta::assert_snapshot!(name.trim_end_matches(".mech"), shown);
        });
    });
    snapshot.map_err(|_| "the snapshot beside the file differs".into())
}

/// Every code has a folder of files and a page; the page's examples are what it says they are.
fn every_code() -> Result<(), Failed> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/errors");
    for code in assur::internals::diagnostic::CODES {
        let path = code.code.strip_prefix("mech::").ok_or("a code begins with mech::")?;
        let (stage, name) = path.split_once("::").ok_or("a code names its stage")?;
        if !root.join(stage).join(name).is_dir() {
            return Err(format!("no file shows {}", code.code).into());
        }
        if !code.page.starts_with(&format!("# {}\n", code.code)) {
            return Err(format!("the page of {} does not begin with its code", code.code).into());
        }
        if let Some(text) = examples(code.page, " wrong").find(|text| !reports(text, code.code)) {
            return Err(format!("this example of {} is not wrong:\n{text}", code.code).into());
        }
        if examples(code.page, "").next().is_none() {
            return Err(format!("{} has no right example", code.code).into());
        }
        for text in examples(code.page, "") {
            if reports(text, code.code) {
                return Err(format!("this example of {} is wrong:\n{text}", code.code).into());
            }
            let (_, problems) =
                assur::internals::solve_source(&Source::new("page.mech", text), &Overrides::none());
            if problems.has_errors() {
                let shown = render(&problems, &Source::new("page.mech", text), Style::PLAIN);
                return Err(
                    format!("the right example of {} is not solved:\n{text}\n{shown}", code.code).into()
                );
            }
        }
    }
    Ok(())
}

/// The blocks of a page whose fence ends so.
fn examples<'a>(page: &'a str, kind: &'static str) -> impl Iterator<Item = &'a str> {
    let blocks = page.split("```mech").skip(1).filter_map(|block| block.split("```").next());
    blocks
        .filter_map(|block| block.split_once('\n'))
        .filter(move |(head, _)| *head == kind)
        .map(|(_, text)| text)
}

fn reports(text: &str, code: &str) -> bool {
    said(&Source::new("page.mech", text), stage_of(code)).contains(code)
}
