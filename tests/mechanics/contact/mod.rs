//! What rubs, holds, stops and parts in motions, against closed forms and motions that were integrated apart.

mod driven;
mod parting;
mod scenes;
