//! What rubs, holds, stops and parts in motions, against closed forms and motions that were integrated apart.

mod cells;
mod determined;
mod driven;
mod freewheel;
mod oracle;
mod parting;
mod parting_cams;
mod plane;
mod rolling_resistance;
mod scenes;
