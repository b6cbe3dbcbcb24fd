//! What the table of functions says of a name.

use crate::names::declared::ThingKind;
use assur_syntax::document::JointKind;
use assur_text::language::Function;

/// Whether a function's arguments are values; those of an unknown one are taken for values.
pub fn takes_values(function: &str) -> bool {
    Function::named(function).is_none_or(|f| f.row().takes_values())
}

/// The function of that name, if what it asks of things is known only once the mechanism is solved.
pub fn of_things(name: &str) -> Option<Function> {
    Function::named(name).filter(|f| f.row().is_result() && !f.row().takes_values())
}

/// How a function is written.
pub fn usage(function: &str) -> String {
    Function::named(function).map_or_else(String::new, |f| f.row().usage.to_owned())
}

/// What may be asked of a thing whose name stands where a value is due.
pub fn ask_of(kind: ThingKind, name: &str) -> Option<String> {
    let asked = match kind {
        ThingKind::Link => [format!("angle({name})"), format!("omega({name})")],
        ThingKind::Joint(JointKind::Revolute) => {
            [format!("position({name})"), format!("mag(reaction({name}))")]
        }
        ThingKind::Joint(JointKind::Prismatic | JointKind::Slot | JointKind::Cylinder) => {
            [format!("displacement({name})"), format!("relative_velocity({name})")]
        }
        ThingKind::Shaft | ThingKind::Wheel => [format!("omega({name})"), format!("alpha({name})")],
        ThingKind::Slider => [format!("speed({name})"), format!("velocity({name})")],
        _ => return None,
    };
    Some(format!("ask for one of its quantities: `{}` or `{}`", asked[0], asked[1]))
}
