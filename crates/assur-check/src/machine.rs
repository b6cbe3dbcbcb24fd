//! The machine itself: what it is, how it moves, what acts on it.

use crate::elements::{cam, cam_contact, flywheel, geneva};
use crate::expr::context::Context;
use crate::links::link;
use crate::loads::{balance, counterweight, gravity, load, mass, slipping, spring};
use crate::motion::{assemble, drive, equilibrium, no_motion, pose, simulation, spacing};
use crate::pairs::pair;
use crate::requests::definitions;
use crate::trains::{shaft, size, transmission};

/// Enters links, pairs, drives, loads and all that belongs to the machine into the mechanism.
pub(crate) fn machine(cx: &mut Context<'_>) {
    cam::cams(cx);
    link::shapes(cx);
    shaft::shafts(cx);
    pair::pairs(cx);
    size::wheels(cx);
    transmission::transmissions(cx);
    cam_contact::contacts(cx);
    geneva::genevas(cx);
    pair::groups(cx);
    gravity::gravity(cx);
    mass::masses(cx);
    counterweight::counterweights(cx);
    definitions::results(cx);
    drive::drives(cx);
    simulation::starts(cx);
    equilibrium::equilibria(cx);
    pose::poses(cx);
    balance::balances(cx);
    load::loads(cx);
    spring::springs(cx);
    simulation::stops(cx);
    slipping::loads(cx);
    assemble::hints(cx);
    flywheel::flywheels(cx);
    simulation::simulation(cx);
    no_motion::no_motion(cx);
    spacing::spacing(cx);
}
