//! Where a cam stands: in its mechanism at a position, or alone at the angle of its greatest pressure angle.

use super::Subject;
use assur_math::element::cam::{Cam, CamPoint, Quantity};
use assur_math::math::Vec2;
use assur_model::model::{CamContact, PlateCam};

/// A cam in its place.
pub struct PlacedCam<'a> {
    pub plate: &'a PlateCam,
    /// The contact in which it is.
    pub contact: Option<&'a CamContact>,
    /// How far it has turned, rad.
    pub phi: f64,
    /// What belongs to that angle.
    pub at: CamPoint,
    /// Its centre, m.
    centre: Vec2,
    /// Unit direction towards the follower.
    towards: Vec2,
}

impl<'a> PlacedCam<'a> {
    /// The cam of an index.
    pub fn of(subject: &Subject<'_, 'a>, index: usize, plate: &'a PlateCam) -> Self {
        let contact = subject.mechanism.cam_contacts.iter().find(|c| c.cam == index);
        let cam = &plate.cam;
        let (Some(contact), Some(scene)) = (contact, subject.scene) else {
            let (phi, _) = cam.extreme(Quantity::PressureAngle, true);
            let up = if cam.follower.oscillates() { Vec2::new(1.0, 0.0) } else { Vec2::new(0.0, 1.0) };
            return Self { plate, contact: None, phi, at: cam.at(phi), centre: Vec2::zero(), towards: up };
        };
        let (frame, disk) = (scene.body(contact.frame), scene.body(contact.disk));
        let towards = contact.towards.turned(frame.u);
        let sense = if cam.ccw { -1.0 } else { 1.0 };
        let phi = sense * towards.turned_back(disk.u).angle();
        let phi = phi.rem_euclid(std::f64::consts::TAU);
        let centre = frame.position(contact.frame_centre);
        Self { plate, contact: Some(contact), phi, at: cam.at(phi), centre, towards }
    }

    pub const fn cam(&self) -> &'a Cam {
        &self.plate.cam
    }

    /// A place in the axes of the frame (x from the cam's centre towards the follower), on the ground, m.
    pub fn on_ground(&self, v: Vec2) -> Vec2 {
        self.centre + v.turned(self.towards)
    }

    /// A direction of the frame's axes, on the ground.
    pub fn direction(&self, v: Vec2) -> Vec2 {
        v.turned(self.towards)
    }

    /// A place in the axes of the cam, on the ground, m.
    pub fn of_cam(&self, v: Vec2) -> Vec2 {
        let turned = Vec2::direction(if self.cam().ccw { -self.phi } else { self.phi });
        self.on_ground(v.turned_back(turned))
    }

    /// Points of a curve of the cam, on the ground, m.
    pub fn around(&self, of: impl Fn(&CamPoint) -> Vec2) -> Vec<Vec2> {
        let cam = self.cam();
        let place = |i: u32| {
            let phi = f64::from(i).to_radians();
            self.of_cam(cam.in_cam(of(&cam.at(phi)), phi))
        };
        (0..360).map(place).collect()
    }
}
