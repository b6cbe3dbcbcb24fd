//! What is said about files that are wrong, and that nothing else happens to them.

mod first_attempts;
mod fixits;
mod hostile_input;
mod meaning_cases;
mod message_cases;
mod mutated_input;
mod request_cases;
