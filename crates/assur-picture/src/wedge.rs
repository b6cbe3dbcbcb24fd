//! Wedges: links that only slide, along lines that are neither parallel nor across each other. They are the polygons between
//! their lines.

use crate::scene::Scene;
use assur_drawing::Rect;
use assur_math::math::Vec2;
use assur_model::model::{Guide, LinkId, PairId, PairKind};

/// Lines are parallel, or across each other, within this sine or cosine.
const STRAIGHT: f64 = 1e-3;
/// How far a face goes beyond what slides on it, and the least length of a face, as parts of the mechanism.
const BEYOND: f64 = 1.3;
const LEAST: f64 = 0.16;
/// Of a wedge with a blunt angle, the length of its other side against that of its face.
const BLUNT: f64 = 0.6;

/// A line of a link along which it slides, in its frame.
struct Face {
    at: Vec2,
    along: Vec2,
    /// What slides on it, m along it.
    way: (f64, f64),
    /// It slides on the ground.
    grounded: bool,
}

/// The corners of a link in its frame, where it is a wedge.
pub fn corners(scene: &Scene<'_>, link: LinkId) -> Option<Vec<Vec2>> {
    let mut faces: Vec<Face> = Vec::new();
    for (i, pair) in scene.mechanism().pairs.iter().enumerate() {
        if !pair.kind.links().contains(&link) {
            continue;
        }
        let PairKind::Prismatic(g) = &pair.kind else { return None };
        if pair.bearing.is_some() || g.contacts.is_some() {
            return None;
        }
        faces.push(face(g, link, scene.way(PairId::at(i))));
    }
    let across = |a: &Face, b: &Face| a.along.cross(b.along).abs();
    let inclined = |a: &Face, b: &Face| across(a, b) > STRAIGHT && a.along.dot(b.along).abs() > STRAIGHT;
    let any = faces.iter().enumerate().any(|(i, a)| faces[i + 1..].iter().any(|b| inclined(a, b)));
    if !any {
        return None;
    }
    let size = assur_solve::solve::extent(&scene.model);
    match faces.as_slice() {
        [a, b] => Some(triangle(a, b, size)),
        _ => polygon(scene, link, &faces, size),
    }
}

/// The middle of what the faces of two links share of a line, in ground axes; none where neither is a wedge.
pub fn middle(scene: &Scene<'_>, links: [LinkId; 2], (at, along): (Vec2, Vec2)) -> Option<Vec2> {
    let size = assur_solve::solve::extent(&scene.model);
    let shared = links.into_iter().filter_map(|link| {
        let corners = corners(scene, link)?.into_iter().map(|corner| scene.at(link, corner) - at);
        let on_line = corners.filter(|d| along.cross(*d).abs() < 1e-6 * size).map(|d| d.dot(along));
        let (from, to) = on_line.fold((f64::MAX, f64::MIN), |(a, b), s| (a.min(s), b.max(s)));
        (from < to).then_some((from, to))
    });
    let (from, to) = shared.reduce(|(a, b), (c, d)| (a.max(c), b.min(d)))?;
    Some(at + along * ((from + to) / 2.0))
}

fn face(g: &Guide, link: LinkId, (least, greatest): (f64, f64)) -> Face {
    let grounded = g.guide == LinkId::GROUND || g.slider == LinkId::GROUND;
    if g.guide == link {
        Face { at: g.through, along: g.along, way: (least, greatest), grounded }
    } else {
        Face { at: g.point, along: g.direction, way: (-greatest, -least), grounded }
    }
}

/// Between two lines: on the sides to which what slides on them is, else in the sharper angle.
fn triangle(a: &Face, b: &Face, size: f64) -> Vec<Vec2> {
    let (rail, face) = if b.grounded && !a.grounded { (b, a) } else { (a, b) };
    // from the point of each where they meet
    let apart = face.at - rail.at;
    let crossing = rail.along.cross(face.along);
    let on_rail = apart.cross(face.along) / crossing;
    let on_face = apart.cross(rail.along) / crossing;
    let apex = rail.at + rail.along * on_rail;
    let middle = |of: &Face, s: f64| (of.way.0 + of.way.1) / 2.0 - s;
    let known = |s: f64| if s.abs() > 1e-6 * size { Some(s.signum()) } else { None };
    let (s_rail, s_face) = (known(middle(rail, on_rail)), known(middle(face, on_face)));
    let cosine = rail.along.dot(face.along);
    let face_way = s_face.or(s_rail.map(|s| s * cosine.signum())).unwrap_or(1.0);
    // a rail says nothing of the side on which the wedge is
    let rail_way = cosine.signum() * face_way;
    let reach = [face.way.0, face.way.1].map(|s| (s - on_face) * face_way);
    let length = (reach[0].max(reach[1]) * BEYOND).max(LEAST * size);
    let foot = length * cosine.abs();
    let foot = if foot < 0.2 * length { BLUNT * length } else { foot };
    vec![apex, apex + face.along * (face_way * length), apex + rail.along * (rail_way * foot)]
}

/// What all lines leave of a box around all that is on the link.
fn polygon(scene: &Scene<'_>, link: LinkId, faces: &[Face], size: f64) -> Option<Vec<Vec2>> {
    let mut points: Vec<Vec2> = scene.mechanism().link(link).points.iter().map(|point| point.at).collect();
    for face in faces {
        points.extend([face.way.0, face.way.1].map(|s| face.at + face.along * s));
    }
    let mut bounds = Rect::NOTHING;
    points.iter().for_each(|point| bounds.add(*point));
    let inside = points.iter().fold(Vec2::zero(), |sum, p| sum + *p) * (1.0 / points.len().max(1) as f64);
    let grown = bounds.grown(size);
    let Rect { min, max } = grown;
    let mut corners = vec![min, Vec2::new(max.x, min.y), max, Vec2::new(min.x, max.y)];
    for face in faces {
        let side = face.along.cross(inside - face.at);
        if side.abs() < 1e-9 * size {
            return None;
        }
        corners = cut(&corners, face, side.signum());
    }
    let open = corners.iter().any(|c| {
        let d = (c.x - min.x).min(max.x - c.x).min((c.y - min.y).min(max.y - c.y));
        d < 1e-9 * size
    });
    if open {
        // no line closes it: it ends where what is on it ends
        let Rect { min, max } = bounds.grown(LEAST * size / 2.0);
        corners = vec![min, Vec2::new(max.x, min.y), max, Vec2::new(min.x, max.y)];
        for face in faces {
            corners = cut(&corners, face, face.along.cross(inside - face.at).signum());
        }
    }
    (corners.len() > 2).then_some(corners)
}

/// The part of a polygon on a side of a line.
fn cut(corners: &[Vec2], face: &Face, side: f64) -> Vec<Vec2> {
    let off = |p: Vec2| side * face.along.cross(p - face.at);
    let mut kept = Vec::new();
    for (i, a) in corners.iter().enumerate() {
        let b = corners[(i + 1) % corners.len()];
        let (d_a, d_b) = (off(*a), off(b));
        if d_a >= 0.0 {
            kept.push(*a);
        }
        if d_a * d_b < 0.0 {
            kept.push(*a + (b - *a) * (d_a / (d_a - d_b)));
        }
    }
    kept
}
