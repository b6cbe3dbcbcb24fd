//! The language as data: what the checker, suggestions, completions and the reference read. Tables are statics: a constant would be copied to
//! every place that reads it.

mod codes;
mod dimension;
mod function;
mod functions;
mod kinds;
mod properties;
mod units;
mod words;

pub use codes::{CODES, Code, explain};
pub use dimension::{Dimension, Kind};
pub use function::{Argument, Form, FunctionGroup, FunctionRow, Gives, Takes};
pub use functions::{FUNCTIONS, Function, Index, letter_of};
pub use kinds::{COLLECTIONS, Collection};
pub use kinds::{CamLaw, JointKind, LAWS, PAIRS};
pub use properties::{
    BRAKE, CAM, COUNTERWEIGHT, FLYWHEEL, FOLLOWER, PROPERTIES, RIM, SPRING, STOP, TORSION_SPRING,
    properties_of_pair,
};
pub use properties::{Property, PropertyValue};
pub use units::{Symbol, UNITS, symbol};
pub use words::{
    CAM_MEMBERS, CONNECTING, CONTEXTUAL, MEMBERS, Place, SHAPES, STATEMENTS, WORDS, Word, words_of,
};
