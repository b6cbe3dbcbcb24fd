//! The machine itself: what it is, how it moves, what acts on it.

use super::context::Context;
use super::{
    assemble, balance, drive, flywheel, friction, gravity, link, load, mass, pair, plate, plate_contact,
    pose, simulation, spring, train, value,
};

/// Enters links, pairs, drives, loads and all that belongs to the machine into the mechanism.
pub(super) fn machine(cx: &mut Context<'_>) {
    plate::cams(cx);
    link::shapes(cx);
    train::shafts(cx);
    pair::pairs(cx);
    train::wheels(cx);
    train::transmissions(cx);
    plate_contact::contacts(cx);
    pair::groups(cx);
    gravity::gravity(cx);
    mass::masses(cx);
    value::results(cx);
    drive::drives(cx);
    pose::poses(cx);
    balance::balances(cx);
    load::loads(cx);
    spring::springs(cx);
    assemble::hints(cx);
    flywheel::flywheels(cx);
    simulation::simulation(cx);
    friction::no_motion(cx);
}
