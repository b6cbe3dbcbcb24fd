//! What is reported about wrong files, and that no file does harm.

#[path = "../busy/mod.rs"]
mod busy;
mod case;
mod first_attempts;
mod fixes;
mod fixits;
#[path = "../folder/mod.rs"]
mod folder;
mod hostile_input;
mod line_cases;
mod meaning_cases;
mod message_cases;
mod mistakes;
mod mutated_input;
mod paste;
mod request_cases;
#[path = "../share/mod.rs"]
mod share;
mod table_cases;
mod use_cases;
