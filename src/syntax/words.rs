//! Words of the language, and what the grammar's rules are called when speaking to people.

use super::Rule;

/// What may stand at a place.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Expected {
    /// A word or sign, literally.
    Literal(String),
    /// A name to be chosen.
    Name,
    /// Something that is described.
    Kind(&'static str),
    /// An operator, behind something complete.
    Operator,
    /// The end of what is being read.
    End,
}

/// What a rule is called; nothing for plumbing, slips and error productions.
pub(super) fn expected(rule: Rule) -> Option<Expected> {
    let debug = format!("{rule:?}");
    if let Some(word) = debug.strip_prefix("w_") {
        return match rule {
            Rule::w_and | Rule::w_or => Some(Expected::Operator),
            Rule::w_not => Some(Expected::Kind("a value")),
            _ => Some(Expected::Literal(word.to_owned())),
        };
    }
    let literal = |sign: &str| Some(Expected::Literal(sign.to_owned()));
    match rule {
        Rule::p_comma => literal(","),
        Rule::p_dash => literal("-"),
        Rule::p_dots => literal(".."),
        Rule::p_close => literal(")"),
        Rule::p_equals => literal("="),
        Rule::p_colon => literal(":"),
        Rule::p_brace => literal("{"),
        Rule::p_end => literal("}"),
        Rule::ident
        | Rule::pose_name
        | Rule::path
        | Rule::end
        | Rule::clause
        | Rule::setting
        | Rule::column => Some(Expected::Name),
        Rule::expr
        | Rule::conjunct
        | Rule::truth
        | Rule::comparison
        | Rule::sum
        | Rule::polar
        | Rule::product
        | Rule::signed
        | Rule::exponent
        | Rule::power
        | Rule::post
        | Rule::arg
        | Rule::list
        | Rule::sensed
        | Rule::position
        | Rule::find_item => Some(Expected::Kind("a value")),
        Rule::number | Rule::quantity | Rule::count | Rule::cell | Rule::row => {
            Some(Expected::Kind("a number"))
        }
        Rule::string => Some(Expected::Kind("a text in quotes")),
        Rule::unit => Some(Expected::Kind("a unit")),
        Rule::place => Some(Expected::Kind("a point")),
        Rule::site => Some(Expected::Kind("`on` a link or `in` a pair")),
        Rule::side => Some(Expected::Kind("`left` or `right`")),
        Rule::turn => Some(Expected::Kind("`cw` or `ccw`")),
        Rule::kind => Some(Expected::Kind("a kind of pair")),
        Rule::law => Some(Expected::Kind("a law of motion")),
        Rule::load_kind => Some(Expected::Kind("`force` or `torque`")),
        Rule::body | Rule::properties => literal("{"),
        Rule::property => Some(Expected::Kind("a property")),
        Rule::header => Some(Expected::Kind("a header of names")),
        Rule::add | Rule::multiply | Rule::compare | Rule::p_polar | Rule::p_caret => {
            Some(Expected::Operator)
        }
        Rule::EOI => Some(Expected::End),
        _ => None,
    }
}

/// The words behind rules that stand for a choice of words.
pub(super) fn words_of(rule: Rule) -> &'static [&'static str] {
    match rule {
        Rule::law => LAWS,
        Rule::side => &["left", "right"],
        Rule::turn => &["cw", "ccw"],
        Rule::load_kind => &["force", "torque"],
        Rule::site => &["on", "in"],
        Rule::kind => PAIRS,
        _ => &[],
    }
}

/// What may be said to be expected: `` `=` or a value ``.
pub(super) fn list(mut expected: Vec<Expected>) -> String {
    expected.sort();
    expected.dedup();
    // Behind something complete an operator and the end are always possible; they help only where nothing else is.
    if expected.iter().any(|e| !matches!(e, Expected::Operator | Expected::Kind("a unit"))) {
        expected.retain(|e| !matches!(e, Expected::Operator | Expected::Kind("a unit")));
    }
    let mut said = expected.into_iter().map(say).collect::<Vec<_>>();
    said.truncate(6);
    match said.pop() {
        None => "this does not belong here".to_owned(),
        Some(only) if said.is_empty() => format!("expected {only}"),
        Some(last) => format!("expected {} or {last}", said.join(", ")),
    }
}

fn say(expected: Expected) -> String {
    match expected {
        Expected::Literal(word) => format!("`{word}`"),
        Expected::Name => "a name".to_owned(),
        Expected::Kind(kind) => kind.to_owned(),
        Expected::Operator => "an operator".to_owned(),
        Expected::End => "the end of it".to_owned(),
    }
}

/// What a statement begins with.
pub(super) const STATEMENTS: &[&str] = &[
    "mech",
    "mechanism",
    "given",
    "let",
    "gravity",
    "ground",
    "link",
    "shaft",
    "slider",
    "revolute",
    "prismatic",
    "slot",
    "contact",
    "cylinder",
    "mesh",
    "rope",
    "belt",
    "chain",
    "rack",
    "worm",
    "screw",
    "spring",
    "all",
    "group",
    "drive",
    "pose",
    "assemble",
    "balance",
    "force",
    "torque",
    "cam",
    "flywheel",
    "find",
    "expect",
    "variants",
    "start",
    "simulate",
    "until",
    "ignore",
];

/// What a member of a link begins with, unless it is a point.
pub(super) const MEMBERS: &[&str] = &["line", "circle", "profile", "mass", "weight", "inertia", "wheel"];

/// What a member of a cam begins with, unless it is a property.
pub(super) const CAM_MEMBERS: &[&str] = &["turning", "follower", "rise", "dwell", "fall"];

/// The kinds of pairs and transmissions.
const PAIRS: &[&str] = &[
    "revolute",
    "prismatic",
    "slot",
    "contact",
    "cylinder",
    "mesh",
    "rope",
    "belt",
    "chain",
    "rack",
    "worm",
    "screw",
];

/// The laws of a follower's motion.
const LAWS: &[&str] = &[
    "uniform",
    "parabolic",
    "harmonic",
    "cycloidal",
    "poly345",
    "poly4567",
    "modified_trapezoid",
    "modified_sine",
];

/// The connecting words, which are reserved.
pub(super) const CONNECTING: &[&str] = &[
    "accelerating",
    "against",
    "along",
    "and",
    "as",
    "at",
    "between",
    "ccw",
    "cw",
    "for",
    "from",
    "in",
    "module",
    "moving",
    "near",
    "not",
    "of",
    "on",
    "or",
    "steps",
    "through",
    "to",
    "turning",
    "when",
    "within",
];

/// Connecting words that are not reserved.
pub(super) const CONTEXTUAL: &[&str] = &[
    "about", "ahead", "behind", "centre", "diameter", "forward", "back", "left", "right", "motion", "over",
    "radius", "teeth", "under",
];

/// Whether a word cannot be a name.
pub(super) fn is_reserved(word: &str) -> bool {
    CONNECTING.contains(&word) || LAWS.contains(&word)
}

/// Whether a character may stand in a name.
pub(super) fn is_name_char(c: char) -> bool {
    c.is_alphanumeric() || matches!(c, '_' | '\'' | '\u{2080}'..='\u{2089}')
}
