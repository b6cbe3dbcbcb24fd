//! Designed cams in contact with their followers: the follower must be the one the cam was designed for.

use crate::expr::context::Context;
use crate::values::format_value::format_value;
use assur_math::element::cam::{Cam, Follower, Shape};
use assur_math::math::Vec2;
use assur_model::model::{CamContact, Guide, LinkId, PairId, PairKind, Pin, Profile, ProfileShape};
use assur_text::diagnostic::Diagnosis;
use assur_text::units::Dimension;

/// Lengths of design and mechanism that agree to this part of the base radius are equal.
const EQUAL: f64 = 1e-6;

/// Finds the follower of every cam in contact.
pub(crate) fn contacts(cx: &mut Context<'_>) {
    for index in 0..cx.builder.mech.pairs.len() {
        let PairKind::Contact { first, second, .. } = &cx.builder.mech.pairs[index].kind else { continue };
        let (rim, other, rim_first) = match (first.shape, second.shape) {
            (ProfileShape::Rim(_), _) => (first.clone(), second.clone(), true),
            (_, ProfileShape::Rim(_)) => (second.clone(), first.clone(), false),
            _ => continue,
        };
        let pair = PairId::at(index);
        // a contact takes its rim from the profiles of the link
        let profiles = &cx.builder.mech.link(rim.link).cam_profiles;
        let Some(found) = profiles.iter().find(|r| r.name == rim.name) else { continue };
        let (cam, centre) = (found.cam, found.centre);
        let Some(plate) = cx.builder.mech.cams.get(cam) else { continue };
        let roller = roller(cx, &other);
        let carried = roller.as_ref().map_or(&other, |(carrier, _)| carrier);
        match build(cx, &plate.cam, (pair, cam, centre), &rim, carried) {
            Ok(contact) => {
                let roller = roller.map(|(_, hinge)| (other.link, hinge));
                cx.builder.mech.cam_contacts.push(CamContact { roller, ..contact });
            }
            Err((message, help)) => {
                let (declared, cam) = (&cx.builder.mech.pairs[index], plate.span);
                let (pair, span) = (declared.name.clone(), declared.span);
                cx.error(
                    Diagnosis::error("mech::cam::other_follower", format!("`{pair}`: {message}"))
                        .primary(span, "touches here")
                        .label(cam, "designed here")
                        .help(help),
                );
                continue;
            }
        }
        let place = cx.builder.mech.cam_contacts.len() - 1;
        if let PairKind::Contact { first, second, .. } = &mut cx.builder.mech.pairs[index].kind {
            let rim = if rim_first { first } else { second };
            rim.shape = ProfileShape::Rim(place);
        }
    }
}

/// The pin of a roller that is a link of its own, as a profile of the link that carries it: the roller has one hinge, in the
/// centre of its circle, and nothing else but contacts.
fn roller(cx: &Context<'_>, profile: &Profile) -> Option<(Profile, PairId)> {
    let ProfileShape::Circle(centre, radius) = profile.shape else { return None };
    let mut hinge = None;
    for (i, pair) in cx.builder.mech.pairs.iter().enumerate() {
        match &pair.kind {
            PairKind::Contact { .. } => {}
            PairKind::Revolute(pins) if pins.iter().any(|p| p.link == profile.link) => {
                let [first, second] = pins.as_slice() else { return None };
                let (own, carrier) =
                    if first.link == profile.link { (first, second) } else { (second, first) };
                if own.at != centre || carrier.link == LinkId::GROUND || hinge.is_some() {
                    return None;
                }
                let shape = ProfileShape::Circle(carrier.at, radius);
                let carried = Profile { link: carrier.link, name: carrier.name.clone(), shape };
                hinge = Some((carried, PairId::at(i)));
            }
            kind if kind.links().contains(&profile.link) => return None,
            _ => {}
        }
    }
    hinge
}

/// The difference, and the correction.
type Difference = (String, String);

fn mm(x: f64) -> String {
    format_value(x, Dimension::LENGTH)
}

/// The same of two lengths, or what differs.
fn same(what: &str, here: f64, designed: f64, scale: f64) -> Result<(), Difference> {
    if (here - designed).abs() <= EQUAL * scale {
        return Ok(());
    }
    let message = format!("{what} is {} here, but {} in the design of the cam", mm(here), mm(designed));
    Err((message, format!("write {} in both", mm(designed))))
}

/// A place where the cam stands: frame, its pin, the cam's pin.
struct CamPlace<'a> {
    frame: LinkId,
    pin: &'a Pin,
}

fn build(
    cx: &Context<'_>,
    cam: &Cam,
    (pair, index, centre): (PairId, usize, Vec2),
    rim: &Profile,
    other: &Profile,
) -> Result<CamContact, Difference> {
    let name = |link: LinkId| cx.builder.mech.link(link).name.clone();
    let (disk, follower) = (rim.link, other.link);
    let scale = cam.base_radius;
    let tip = tip(cam, other, scale, &name(follower))?;
    let places_of = places_of(cx, disk, centre, scale);
    if places_of.is_empty() {
        let message = format!("`{}` has no hinge in the centre of its profile", name(disk));
        let help = format!("join the centre to the frame: `revolute O: ground - {}`", name(disk));
        return Err((message, help));
    }
    let mut contact = CamContact {
        pair,
        cam: index,
        disk,
        centre,
        frame: places_of[0].frame,
        frame_centre: places_of[0].pin.at,
        towards: Vec2::new(1.0, 0.0),
        follower,
        roller: None,
        point: tip,
        beside: 0.0,
        direction: Vec2::new(1.0, 0.0),
        face: match other.shape {
            ProfileShape::Line(p, d) => Some((p, d)),
            _ => None,
        },
        tip,
    };
    let oscillates = cam.follower.oscillates();
    for stand in &places_of {
        contact.frame = stand.frame;
        contact.frame_centre = stand.pin.at;
        for kind in cx.builder.mech.pairs.iter().map(|p| &p.kind) {
            match kind {
                PairKind::Revolute(pins) if oscillates => {
                    let pin = |link: LinkId| pins.iter().find(|p| p.link == link).map(|p| p.at);
                    if let (Some(base), Some(own)) = (pin(stand.frame), pin(follower)) {
                        oscillating(cam, &mut contact, base, own, scale)?;
                        return Ok(contact);
                    }
                }
                PairKind::Prismatic(g) if !oscillates => {
                    let ends = [g.slider, g.guide];
                    if ends.contains(&stand.frame) && ends.contains(&follower) {
                        translating(cam, &mut contact, g, scale)?;
                        return Ok(contact);
                    }
                }
                _ => {}
            }
        }
    }
    let (motion, pair) = if oscillates { ("turns", "revolute pair") } else { ("slides", "prismatic pair") };
    let (frame, follower) = (name(places_of[0].frame), name(follower));
    let message = format!(
        "the cam is designed for a follower that {motion}, but no {pair} joins \
         `{follower}` and `{frame}`"
    );
    Err((
        message,
        format!("join `{follower}` to `{frame}` by a {pair}: cam and follower need the same frame"),
    ))
}

/// The end of the follower: knife edge, centre of the roller, a point of the face.
fn tip(cam: &Cam, other: &Profile, scale: f64, link: &str) -> Result<Vec2, Difference> {
    let (designed, wanted) = match cam.follower.shape() {
        Shape::Roller(r) => ("a roller", format!("`circle roller centre P radius {}`", mm(r))),
        Shape::Knife => ("a knife edge", "a point".to_owned()),
        Shape::Flat => ("a flat face", "a line".to_owned()),
    };
    match (cam.follower.shape(), other.shape) {
        (Shape::Roller(r), ProfileShape::Circle(c, radius)) => {
            same("the radius of the roller", radius, r, scale).map(|()| c)
        }
        (Shape::Knife, ProfileShape::Point(p)) | (Shape::Flat, ProfileShape::Line(p, _)) => Ok(p),
        _ => {
            let message =
                format!("the cam is designed for {designed}, but `{link}.{}` is not {designed}", other.name);
            Err((message, format!("name {wanted} of `{link}`")))
        }
    }
}

/// The hinges in the centre of the cam.
fn places_of<'a>(cx: &'a Context<'_>, disk: LinkId, centre: Vec2, scale: f64) -> Vec<CamPlace<'a>> {
    let mut found = Vec::new();
    for pair in &cx.builder.mech.pairs {
        let PairKind::Revolute(pins) = &pair.kind else { continue };
        let in_centre = |p: &Pin| p.link == disk && (p.at - centre).norm() <= EQUAL * scale;
        if pins.iter().any(in_centre) {
            let others = pins.iter().filter(|p| p.link != disk);
            found.extend(others.map(|pin| CamPlace { frame: pin.link, pin }));
        }
    }
    found
}

fn oscillating(
    cam: &Cam,
    contact: &mut CamContact,
    base: Vec2,
    own: Vec2,
    scale: f64,
) -> Result<(), Difference> {
    let Follower::Oscillating { shape, arm, pivot_distance, with_cam, offset } = cam.follower else {
        return Ok(());
    };
    let away = base - contact.frame_centre;
    same("the distance from the cam's centre to the pivot", away.norm(), pivot_distance, scale)?;
    contact.towards = away / away.norm();
    contact.point = own;
    if shape != Shape::Flat {
        let along = contact.tip - own;
        same("the arm of the follower", along.norm(), arm, scale)?;
        contact.direction = along / along.norm();
        return Ok(());
    }
    let Some((face, along)) = contact.face else { return Ok(()) };
    // side of the arm on which the cam lies: the arm points along the face, or against it
    let side = if with_cam == cam.ccw { 1.0 } else { -1.0 };
    let height = side * (own - face).dot(along.perp());
    contact.direction = if (height - offset).abs() <= EQUAL * scale { along } else { -along };
    if (height.abs() - offset.abs()).abs() > EQUAL * scale {
        return same("the distance of the face from the pivot", height.abs(), offset.abs(), scale);
    }
    Ok(())
}

fn translating(cam: &Cam, contact: &mut CamContact, guide: &Guide, scale: f64) -> Result<(), Difference> {
    let Follower::Translating { shape, offset } = cam.follower else { return Ok(()) };
    let slides = guide.slider == contact.follower;
    // a line of the frame on which a point of the follower slides, or the other way round
    let (on_frame, towards, on_follower, direction) = if slides {
        (guide.through, guide.along, guide.point, guide.direction)
    } else {
        (guide.point, guide.direction, guide.through, guide.along)
    };
    contact.towards = towards;
    contact.direction = direction;
    contact.beside =
        towards.cross(on_frame - contact.frame_centre) + (contact.tip - on_follower).turned_back(direction).y;
    if let (Shape::Flat, Some((_, along))) = (shape, contact.face) {
        let cosine = along.dot(direction).abs();
        if cosine > EQUAL {
            let off = format_value(libm::asin(cosine.min(1.0)), Dimension::ANGLE);
            let message = format!("the face deviates by {off} from the normal of the follower's path");
            return Err((
                message,
                "make its line perpendicular to the path: `line face through P along 90 deg`".into(),
            ));
        }
        return Ok(());
    }
    let here = if cam.ccw { -contact.beside } else { contact.beside };
    if (here + offset).abs() <= EQUAL * scale && offset.abs() > EQUAL * scale {
        let message = format!(
            "the follower passes the cam's centre on the other side than in the design, at {}",
            mm(offset.abs())
        );
        let help = format!(
            "write `offset {}` in the design, or reverse the guide: the follower \
             rises in the direction of its guide",
            mm(-offset)
        );
        return Err((message, help));
    }
    same("the offset of the follower", here, offset, scale)
}
