//! What is reported about wrong files, and that no file does harm.

mod case;
mod first_attempts;
mod fixits;
mod hostile_input;
mod line_cases;
mod meaning_cases;
mod message_cases;
mod mutated_input;
mod paste;
mod request_cases;
mod table_cases;
