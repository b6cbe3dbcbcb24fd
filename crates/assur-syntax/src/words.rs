//! Words of the language, and what the grammar's rules are called when speaking to people.

use crate::grammar::Rule;

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
pub(super) fn expected(rule: Rule) -> Vec<Expected> {
    if let Some(kind) = kind(rule) {
        return vec![kind];
    }
    let debug = format!("{rule:?}");
    let words = match rule {
        Rule::law => LAWS,
        Rule::kind => PAIRS,
        Rule::side => &["left", "right"],
        Rule::turn => &["cw", "ccw"],
        Rule::load_kind => &["force", "torque"],
        Rule::site => &["on", "in"],
        Rule::order => &["ahead", "behind"],
        Rule::m_along => &["along"],
        Rule::m_to => &["to"],
        Rule::near => &["near"],
        Rule::frame => &["in"],
        Rule::against => &["against"],
        Rule::within => &["within"],
        Rule::p_comma => &[","],
        Rule::p_dash => &["-"],
        Rule::p_dots => &[".."],
        Rule::p_close => &[")"],
        Rule::p_equals => &["="],
        Rule::p_colon => &[":"],
        Rule::p_end => &["}"],
        Rule::p_brace | Rule::body | Rule::properties => &["{"],
        // The rule of a word is named after it.
        _ => return debug.strip_prefix("w_").map(|w| Expected::Literal(w.to_owned())).into_iter().collect(),
    };
    words.iter().map(|w| Expected::Literal((*w).to_owned())).collect()
}

/// Rules that are not words.
fn kind(rule: Rule) -> Option<Expected> {
    Some(match rule {
        Rule::ident
        | Rule::pose_name
        | Rule::path
        | Rule::end
        | Rule::clause
        | Rule::setting
        | Rule::column => Expected::Name,
        Rule::expr
        | Rule::post
        | Rule::arg
        | Rule::list
        | Rule::sensed
        | Rule::position
        | Rule::find_item
        | Rule::w_not => Expected::Kind("a value"),
        Rule::number | Rule::quantity | Rule::count | Rule::cell | Rule::row => Expected::Kind("a number"),
        Rule::string => Expected::Kind("a text in quotes"),
        Rule::unit => Expected::Kind("a unit"),
        Rule::place => Expected::Kind("a point"),
        Rule::property => Expected::Kind("a property"),
        Rule::header => Expected::Kind("a header of names"),
        Rule::tight | Rule::loose | Rule::joining | Rule::compare | Rule::compared | Rule::p_polar => {
            Expected::Operator
        }
        Rule::EOI => Expected::End,
        _ => return None,
    })
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
pub const CAM_MEMBERS: &[&str] = &["turning", "follower", "rise", "dwell", "fall"];

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

/// Functions that are often written without brackets.
pub(super) const FUNCTIONS: &[&str] = &[
    "over",
    "under",
    "sqrt",
    "abs",
    "sin",
    "cos",
    "tan",
    "asin",
    "acos",
    "atan",
    "mag",
    "unit",
    "dir",
    "position",
    "velocity",
    "acceleration",
    "angle",
    "omega",
    "alpha",
    "displacement",
    "relative_velocity",
    "relative_acceleration",
    "coriolis",
    "reaction",
    "moment",
    "normal",
    "friction",
    "inertia_force",
    "inertia_torque",
    "transmission_angle",
    "pressure_angle",
    "speed",
    "power",
    "effort",
    "max",
    "min",
    "mean",
    "integral",
    "table",
    "travel",
    "stroke",
];

/// Whether a word cannot be a name.
pub(super) fn is_reserved(word: &str) -> bool {
    CONNECTING.contains(&word) || LAWS.contains(&word)
}

/// Whether a character may stand in a name.
pub(super) fn is_name_char(c: char) -> bool {
    c.is_alphanumeric() || matches!(c, '_' | '\'' | '\u{2080}'..='\u{2089}')
}
