//! A cam as a drawing: DXF R12, millimetres, the cam's centre in the origin, its axes those of the drawing.

use assur_math::element::cam::Shape;
use assur_math::math::Vec2;
use assur_model::model::PlateCam;
use std::f64::consts::TAU;
use std::fmt::Write;

/// Profile, pitch curve and base circle, each on a layer of its own, the curves as closed polylines of `steps` vertices at
/// equal steps of the cam angle.
#[must_use]
pub fn render(plate: &PlateCam, steps: usize) -> String {
    let mut out = String::new();
    let mut pair = |code: u16, value: &str| {
        let _ = write!(out, "{code:>3}\r\n{value}\r\n");
    };
    for (code, value) in [(0, "SECTION"), (2, "HEADER"), (9, "$ACADVER"), (1, "AC1009"), (0, "ENDSEC")] {
        pair(code, value);
    }
    pair(0, "SECTION");
    pair(2, "ENTITIES");
    let cam = &plate.cam;
    let curve = |of: fn(&assur_math::element::cam::CamPoint) -> Vec2| -> Vec<Vec2> {
        let angles = (0..steps).map(|i| TAU * i as f64 / steps as f64);
        angles.map(|phi| cam.in_cam(of(&cam.at(phi)), phi)).collect()
    };
    polyline(&mut pair, "PROFILE", &curve(|p| p.contact));
    if matches!(cam.follower.shape(), Shape::Roller(_)) {
        polyline(&mut pair, "PITCH", &curve(|p| p.tip));
    }
    pair(0, "CIRCLE");
    pair(8, "BASE");
    place(&mut pair, Vec2::zero());
    pair(40, &mm(cam.base_radius));
    pair(0, "POINT");
    pair(8, "CENTRE");
    place(&mut pair, Vec2::zero());
    pair(0, "ENDSEC");
    pair(0, "EOF");
    out
}

fn polyline(pair: &mut impl FnMut(u16, &str), layer: &str, points: &[Vec2]) {
    for (code, value) in [(0, "POLYLINE"), (8, layer), (66, "1")] {
        pair(code, value);
    }
    place(pair, Vec2::zero());
    pair(70, "1");
    for point in points {
        pair(0, "VERTEX");
        pair(8, layer);
        place(pair, *point);
    }
    pair(0, "SEQEND");
    pair(8, layer);
}

fn place(pair: &mut impl FnMut(u16, &str), at: Vec2) {
    pair(10, &mm(at.x));
    pair(20, &mm(at.y));
    pair(30, "0.0");
}

/// A length in millimetres to the picometre; zero has no sign.
fn mm(x: f64) -> String {
    let text = format!("{:.9}", x * 1e3);
    if text.trim_start_matches('-').chars().all(|c| c == '0' || c == '.') {
        "0.000000000".to_owned()
    } else {
        text
    }
}
