//! What rubs, holds and stops in motions, against closed forms and motions that were integrated apart.

mod driven;
mod scenes;
