//! Cams: names and units are checked, nothing of it can be solved yet.

use super::context::Context;
use super::element::known;
use super::error::NameError;
use super::link::positive;
use super::lookup::suggestion;
use super::names::ThingKind;
use super::property::{Spec, Takes, read};
use crate::syntax::document::{Cam, CamMember, Follower, Name, Property, Statement};
use crate::units::Dimension;

const CAM: &[Spec] =
    &[Spec { name: "base_radius", takes: Takes::Positive(Dimension::LENGTH), example: "base_radius 50 mm" }];

const FOLLOWER: &[Spec] = &[
    Spec { name: "arm", takes: Takes::Positive(Dimension::LENGTH), example: "arm 130 mm" },
    Spec {
        name: "pivot_distance",
        takes: Takes::Positive(Dimension::LENGTH),
        example: "pivot_distance 140 mm",
    },
    Spec { name: "radius", takes: Takes::Positive(Dimension::LENGTH), example: "radius 15 mm" },
    Spec { name: "offset", takes: Takes::Any(Dimension::LENGTH), example: "offset 10 mm" },
    Spec { name: "with_cam", takes: Takes::Flag, example: "with_cam" },
    Spec { name: "against_cam", takes: Takes::Flag, example: "against_cam" },
];

/// Checks all cams.
pub(super) fn cams(cx: &mut Context<'_>) {
    let doc = cx.doc;
    for statement in &doc.statements {
        if let Statement::Cam(c) = &statement.node {
            cam(cx, c);
            cx.unsupported("the design of a cam", statement.span);
        }
    }
    profiles(cx);
}

fn cam(cx: &mut Context<'_>, cam: &Cam) {
    let mut properties = Vec::<Property>::new();
    let mut oscillating = None;
    for member in &cam.members {
        match &member.node {
            CamMember::Property(p) => properties.push(p.clone()),
            CamMember::Follower(f) => {
                oscillating = Some(f.motion.node == "oscillating");
                follower(cx, f);
            }
            CamMember::Turning(_) | CamMember::Phase(_) | CamMember::Bad(_) => {}
        }
    }
    read(cx, "a cam", &properties, CAM);
    let way = match oscillating {
        Some(true) => Some(Dimension::ANGLE),
        Some(false) => Some(Dimension::LENGTH),
        None => None,
    };
    for member in &cam.members {
        let CamMember::Phase(phase) = &member.node else { continue };
        positive(cx, &phase.angle, Dimension::ANGLE, "the angle the cam turns");
        if let (Some(through), Some(way)) = (&phase.through, way) {
            positive(cx, through, way, "the way of the follower");
        }
    }
}

fn follower(cx: &mut Context<'_>, follower: &Follower) {
    one_of(cx, &follower.motion, "follower motion", &["oscillating", "translating"]);
    one_of(cx, &follower.shape, "follower", &["roller", "knife", "flat"]);
    read(cx, "a follower", &follower.properties, FOLLOWER);
}

fn one_of(cx: &mut Context<'_>, word: &Name, kind: &'static str, words: &[&str]) {
    if words.contains(&word.node.as_str()) {
        return;
    }
    let help = suggestion(&word.node, words, &format!("{kind}s"));
    let (name, span) = (word.node.clone(), word.span);
    cx.error(NameError::Unknown { kind, name, place: String::new(), span, help });
}

/// Cams that profiles of links refer to.
fn profiles(cx: &mut Context<'_>) {
    use crate::syntax::document::Member;
    let doc = cx.doc;
    for statement in &doc.statements {
        let body = match &statement.node {
            Statement::Ground(ground) => &ground.body,
            Statement::Link(link) => &link.body,
            _ => continue,
        };
        for member in body {
            if let Member::Profile(profile) = &member.node {
                known(cx, &profile.of, "cam", &[ThingKind::Cam]);
            }
        }
    }
}
