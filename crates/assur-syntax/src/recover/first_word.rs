//! Pieces that begin with a wrong word.

use super::case::Case;
use super::foreign;
use super::phrase::What;
use crate::recover::{comment_sign, misplaced, misspelling};
use crate::trivia::{Line, corrected};
use crate::words::{self, Grammar, Rule, is_name_char};
use assur_text::diagnostic::{Diagnosis, Help, did_you_mean};
use assur_text::language::{Place, words_of};
use assur_text::source::Span;
use pest::Parser;

pub(super) fn explain(case: &Case<'_>) -> Option<Diagnosis> {
    let word = case.token(0);
    if let Some(sign) = ["%", "--", "'"].into_iter().find(|s| case.slice.starts_with(s)) {
        let at = case.span(0, sign.len());
        return Some(comment_sign(at, sign, case.help(0, sign.len(), "//")));
    }
    let known = match case.what {
        What::Statement => words::statements().collect::<Vec<_>>(),
        What::Member => words_of(Place::Member).collect(),
        What::CamMember => words_of(Place::CamMember).collect(),
        What::Property | What::Header | What::Row => return None,
    };
    if known.contains(&word) && case.what == What::Statement {
        // `slider D: piston.C - ground.guide`
        return synonym(case, word);
    }
    if known.contains(&word) || !word.starts_with(is_name_char) {
        return None;
    }
    if case.what != What::Statement {
        return misspelt(case, word, &known);
    }
    let member = words::is_member(word) || words::is_cam_member(word);
    let exactly = if member { displaced(case, word) } else { None };
    wheel_on_shaft(case, word)
        .or(exactly)
        .or_else(|| question(case, word))
        .or_else(|| synonym(case, word))
        .or_else(|| misspelt(case, word, &known))
        .or_else(|| displaced(case, word))
        .or_else(|| Some(unknown(case, word)))
}

/// A word that is near one that could stand there.
fn misspelt(case: &Case<'_>, word: &str, known: &[&str]) -> Option<Diagnosis> {
    if DRAWINGS.contains(&word) {
        return None;
    }
    let near = did_you_mean(word, known.iter().copied());
    let fits = near.iter().find(|w| case.reads(&case.with(0, word.len(), w)));
    let defines = case.slice[word.len()..].trim_start().starts_with('=');
    let wanted = match (fits, near.first()) {
        (Some(fits), _) => fits,
        (None, Some(first)) if case.what == What::Statement && !defines => first,
        _ => return None,
    };
    Some(misspelling(word, case.span(0, word.len()), wanted, fits.map(|w| case.help(0, word.len(), w))))
}

/// A member outside its braces.
fn displaced(case: &Case<'_>, word: &str) -> Option<Diagnosis> {
    if case.slice[word.len()..].trim_start().starts_with('=') {
        return None;
    }
    let member = Grammar::parse(Rule::one_member, case.slice).is_ok();
    let point = member && case.slice[word.len()..].trim_start().starts_with('(');
    let (place, owner) = match word {
        "wheel" => ("this goes inside the braces of a shaft or a link", "shaft"),
        _ if words::is_cam_member(word) => ("this goes inside the braces of a cam", "cam"),
        _ if point || words::is_member(word) => ("this goes inside the braces of a link", "link"),
        _ => return None,
    };
    let written = case.slice.trim();
    let help = of_link(case, word)
        .or_else(|| link_with_point(case))
        .map(Help::from)
        .or_else(|| if word == "wheel" { on_a_shaft(case, written) } else { None })
        .unwrap_or_else(|| format!("put it there: {owner} NAME {{ {written} }}").into());
    let found = word.to_owned();
    Some(misplaced(&found, case.span(0, word.len()), place, help))
}

/// A wheel in the braces of a shaft: of the shafts that have none, else of any; only where they are few.
fn on_a_shaft(case: &Case<'_>, member: &str) -> Option<Help> {
    /// The most shafts that are proposed.
    const MOST: usize = 3;
    let names = case.text.lines().filter_map(|line| line.trim().strip_prefix("shaft "));
    let names = names.filter_map(|rest| rest.split([' ', '{']).next());
    let all = names.filter_map(|name| line_of(case, name)).collect::<Vec<_>>();
    let bare = all.iter().copied().filter(|line| !line.contains("wheel ")).collect::<Vec<_>>();
    let fits = if bare.is_empty() { all } else { bare };
    let lines = || fits.iter().map(|line| with_member(line, member));
    match fits.len() {
        0 => None,
        1 => lines().next().map(Help::from),
        2..=MOST => {
            let lines = lines().map(|line| line.replacen("put it there: ", "", 1)).collect::<Vec<_>>();
            Some(format!("put it in the braces of its shaft:\n  {}", lines.join("\nor\n  ")).into())
        }
        _ => None,
    }
}

/// What other programs call a wheel.
const WHEELS: &[&str] = &["wheel", "gear", "gearwheel", "cogwheel", "sprocket", "pulley"];

/// `gear z1 on sun teeth 20`: the wheel in the braces of its shaft.
fn wheel_on_shaft(case: &Case<'_>, word: &str) -> Option<Diagnosis> {
    if !WHEELS.contains(&word) {
        return None;
    }
    let mut words: Vec<&str> = case.slice.split_whitespace().skip(1).collect();
    let on = words.iter().position(|w| *w == "on");
    let owner = match on.filter(|on| on + 1 < words.len()) {
        Some(on) => words.drain(on..on + 2).nth(1),
        // without a word on its shaft it is a member outside the braces
        None if word == "wheel" => return None,
        None => None,
    };
    let internal = words.iter().position(|w| *w == "internal").map(|at| words.remove(at));
    let member = format!("wheel {}", words.join(" "));
    Grammar::parse(Rule::one_member, &member).ok()?;
    let line = owner.and_then(|owner| line_of(case, owner));
    let mut help = match line {
        Some(line) => with_member(line, &member),
        None => format!("put it there: shaft {} {{ {member} }}", owner.unwrap_or("NAME")),
    };
    if internal.is_some() {
        help += "\nand say in the pair which wheel is a ring, as in `mesh k: w2 - w3 { internal }`";
    }
    let place = "a wheel goes inside the braces of its shaft or link";
    Some(misplaced(word, case.span(0, word.len()), place, help.into()))
}

/// The line that declares a shaft or a link, if nothing else is on it.
fn line_of<'a>(case: &Case<'a>, name: &str) -> Option<&'a str> {
    let declares = |line: &&str| {
        let mut words = line.split_whitespace();
        matches!(words.next(), Some("shaft" | "link")) && words.next() == Some(name)
    };
    let line = case.text.lines().map(str::trim).find(declares)?;
    (line.ends_with('}') || !line.contains(['{', ';', '/'])).then_some(line)
}

/// `mass of coupler = 3 kg`, `mass coupler = 3 kg`: the line of that link with the member in its braces.
fn of_link(case: &Case<'_>, word: &str) -> Option<String> {
    let rest = case.slice.get(word.len()..)?.trim_start();
    let rest = rest.strip_prefix("of ").unwrap_or(rest);
    let (name, value) = rest.split_once('=')?;
    let is_link = |line: &&str| {
        let mut words = line.split_whitespace();
        words.next() == Some("link") && words.any(|w| w == name.trim())
    };
    let line = case.text.lines().map(str::trim).find(is_link)?;
    let at = if word == "inertia" { "" } else { " at POINT" };
    let member = format!("{word} {}{at}", value.trim());
    Some(match line.strip_suffix('}') {
        None if line.contains('{') => format!("put it there: {member}"),
        _ => with_member(line, &member),
    })
}

/// The line of a link with one more member in its braces.
fn with_member(line: &str, member: &str) -> String {
    match line.strip_suffix('}').map(str::trim_end) {
        Some(open) if open.ends_with('{') => format!("put it there: {open} {member} }}"),
        Some(open) => format!("put it there: {open}; {member} }}"),
        None => format!("put it there: {line} {{ {member} }}"),
    }
}

/// `circle rim centre R radius 20 mm`: the line of the link that has the point `R`; of several the nearest above.
fn link_with_point(case: &Case<'_>) -> Option<String> {
    let words = case.words();
    let named = words.windows(2).filter(|pair| matches!(pair[0].1, "centre" | "at" | "through" | "about"));
    let point = named.map(|pair| pair[1].1).next()?;
    let code = |line: &'_ str| line.split_once("//").map_or(line, |(code, _)| code).trim().to_owned();
    let with_it =
        |text: &str| text.lines().map(code).filter(|line| has_point(line, point)).collect::<Vec<_>>();
    let above = with_it(case.text.get(..case.offset)?);
    let all = with_it(case.text);
    let line = above.last().or(if all.len() == 1 { all.first() } else { None })?;
    (!line.contains('{') || line.ends_with('}')).then(|| with_member(line, case.slice.trim()))
}

/// Whether a line is that of a link with a point of that name, at an end of its bar or in its braces.
fn has_point(line: &str, point: &str) -> bool {
    let (head, body) = line.split_once('{').unwrap_or((line, ""));
    let mut words = head.split_whitespace();
    let link = matches!(words.next(), Some("link" | "ground" | "slider" | "shaft"));
    let ends = |word: &str| word.split_once('-').is_some_and(|(from, to)| from == point || to == point);
    let members = || body.split([';', '}']).filter_map(|member| member.split_once('('));
    link && (words.any(ends) || members().any(|(name, _)| name.trim() == point))
}

/// What other programs and languages call the statements.
const SYNONYMS: &[(&[&str], &[&str])] = &[
    (&["hinge", "pin", "pivot", "joint", "rotary", "rotational", "turning_pair"], &["revolute"]),
    (
        &["slider", "sliding", "slide", "guide", "translational", "translation", "linear"],
        &["prismatic", "slot"],
    ),
    (&["roller", "roller_support", "rolling_support"], &["slot"]),
    (
        &[
            "welded",
            "rigid",
            "fixed",
            "fixed_joint",
            "built_in",
            "clamped",
            "glue",
            "bolt",
            "clamp",
            "fix",
            "rivet",
        ],
        &["weld"],
    ),
    (&["gear", "gears", "gearing", "teeth", "engage"], &["mesh"]),
    (&["cable", "string", "cord"], &["rope"]),
    (&["freewheel", "overrunning", "ratchet", "coupling"], &["clutch"]),
    (&["spindle", "leadscrew", "ballscrew"], &["screw"]),
    (&["piston", "hydraulic", "hydraulics", "jack", "actuator"], &["cylinder"]),
    (&["body", "bar", "rod", "member", "element", "part", "beam", "crank", "lever"], &["link"]),
    (&["frame", "base", "fixed", "earth", "fixed_link"], &["ground"]),
    (&["input", "motor", "driver", "sweep"], &["drive"]),
    (&["unknown", "reaction", "effort"], &["balance"]),
    (&["load", "apply", "weight_force"], &["force", "torque"]),
    (&["moment", "couple"], &["torque"]),
    (&["print", "output", "calculate", "compute", "solve", "show", "determine", "report", "get"], &["find"]),
    (&["title", "name", "model", "problem"], &["mechanism"]),
    (&["var", "const", "param", "parameter", "set", "def", "input"], &["given", "let"]),
    (&["assert", "verify", "answer", "result"], &["expect"]),
    (&["table", "data", "rows"], &["variants"]),
    (&["damper", "dashpot", "shock_absorber"], &["spring"]),
    (&["initial", "init", "ic"], &["start"]),
    (&["integrate", "run", "transient"], &["simulate"]),
    (&["position", "configuration", "assembly"], &["assemble"]),
];

/// A word for a statement that another program has, where the rest reads as that statement.
fn synonym(case: &Case<'_>, word: &str) -> Option<Diagnosis> {
    let lower = word.to_lowercase();
    let found = SYNONYMS.iter().filter(|(words, _)| words.contains(&lower.as_str()));
    let mut wanted = found.flat_map(|(_, wanted)| wanted.iter());
    let wanted = wanted.find(|w| case.reads(&case.with(0, word.len(), w)))?;
    Some(misspelling(word, case.span(0, word.len()), wanted, Some(case.help(0, word.len(), wanted))))
}

/// `what is Mb, F?`
fn question(case: &Case<'_>, word: &str) -> Option<Diagnosis> {
    let asks = ["what", "which", "how", "where"].contains(&word.to_lowercase().as_str());
    let words = case.words();
    let verb = words.get(1).filter(|(_, verb)| ["is", "are", "large", "big"].contains(verb));
    let end = verb.map_or(word.len(), |(at, verb)| at + verb.len());
    let new = format!("find{}", case.slice.get(end..)?.trim_end().trim_end_matches(['?', '.']));
    (asks && case.reads(&new)).then(|| {
        misspelling(word, case.span(0, word.len()), "find", Some(case.help(0, case.slice.len(), &new)))
    })
}

/// Words that other programs have for the instants of a motion.
const OF_A_RUN: &[&str] =
    &["output", "step", "timestep", "dt", "t_end", "tend", "tstop", "tspan", "sampling"];

/// Words that ask for a drawing.
const DRAWINGS: &[&str] = &["plot", "draw", "graph", "chart", "animate", "figure"];

/// Words for points, which have no statement.
const POINTS: &[&str] = &["point", "points", "node", "nodes", "coordinates"];

fn unknown(case: &Case<'_>, word: &str) -> Diagnosis {
    let help = if POINTS.contains(&word) {
        "a point is declared in the braces of its link, as in: ground { O (0, 0); D (300 mm, 0) }".into()
    } else if DRAWINGS.contains(&word) {
        let asked = case.slice.get(word.len()..).unwrap_or_default().trim();
        let find = format!("find {asked}");
        let find = if case.reads(&find) { format!("`{find}`") } else { "`find …`".to_owned() };
        format!("nothing is drawn from a file: write {find} and draw it with `assur draw FILE plot`").into()
    } else if OF_A_RUN.contains(&word) && case.text.lines().any(|l| l.trim_start().starts_with("simulate ")) {
        "the instants that are printed belong to `simulate`: write for example `simulate 0 s .. 2 s in 2000 steps`"
            .into()
    } else {
        lines_meant(case).unwrap_or_else(|| {
            "begin with the word of a statement: `given`, `ground`, `link`, `revolute`, `drive`, `force`, `find`, …; \
             the command `assur explain mech::syntax::unknown_statement` lists all"
                .into()
        })
    };
    Diagnosis::error("mech::syntax::unknown_statement", format!("no statement begins with `{word}`"))
        .label(case.span(0, word.len()), "not a statement")
        .help(help)
}

/// The line that reads with a statement's word before it.
fn lines_meant(case: &Case<'_>) -> Option<Help> {
    if let Some(help) = list_goes_on(case) {
        return Some(help);
    }
    if case.slice.contains(":=") {
        let line = format!("given {}", case.slice.replace(":=", "="));
        return case.reads(&line).then(|| case.help(0, case.slice.len(), &line));
    }
    let asked = case.slice.contains('(') || case.slice.contains(" as ");
    let bar = case.slice.contains('-') && !case.slice.contains([':', '=']);
    let tried = [
        ("revolute", true),
        ("given", true),
        ("let", true),
        ("expect", !foreign::is_prose(case.slice) || asked),
        ("link", bar),
        ("find", asked),
    ];
    let reads = |(before, may): &(&str, bool)| *may && case.reads(&format!("{before} {}", case.slice));
    if let Some((before, _)) = tried.into_iter().find(reads) {
        return Some(case.help(0, 0, &format!("{before} ")));
    }
    if foreign::is_prose(case.slice) && !asked {
        return Some(
            case.help(0, 0, "// ").in_words(format!("if it is a remark, write: // {}", case.slice.trim())),
        );
    }
    // a word of another language
    let length = case.token(0).len();
    let instead = |wanted: &&str| case.reads(&case.with(0, length, wanted));
    let wanted = ["given", "link", "ground", "drive", "assemble"].into_iter().find(instead)?;
    Some(case.help(0, length, wanted))
}

/// `find a; b`: the list of the statement before goes on after a semicolon.
fn list_goes_on(case: &Case<'_>) -> Option<Help> {
    let line = Line::around(case.text, case.offset);
    let before = case.text.get(line.start..case.offset)?.trim_end().strip_suffix(';')?;
    let statement = before.rsplit([';', '{', '}']).next()?;
    let new = format!("{}, {}", statement.trim(), case.slice);
    let list = statement.trim_start().starts_with("find ") && case.reads(&new);
    let start = line.start + before.trim_end().len();
    list.then(|| corrected(case.text, Span::new(start, case.offset), ", "))
}
