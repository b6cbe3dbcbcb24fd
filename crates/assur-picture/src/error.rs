//! Pictures that cannot exist.

use crate::no_diagram::NoDiagram;
use crate::scene::Scene;
use crate::words::offered;
use assur_model::model::{LinkId, Mechanism};
use assur_position::position::turns;
use assur_solve::solve::Solution;
use assur_text::diagnostic::did_you_mean;
use assur_text::source::Span;
use miette::Diagnostic;
use thiserror::Error;

/// Why there is no picture.
#[derive(Clone, Debug, Error, Diagnostic)]
pub enum Missing {
    #[error(transparent)]
    #[diagnostic(transparent)]
    Diagram(#[from] NoDiagram),
    /// No position is solved.
    #[error("there is no position to draw{named}")]
    #[diagnostic(code("mech::picture::no_position"))]
    NoPosition {
        /// `: no solved pose is named `9``, or empty.
        named: String,
        /// What it is about.
        #[label("these are the positions")]
        at: Option<Span>,
        #[help]
        help: String,
    },
    /// No drive has a speed.
    #[error("there are no {what} to draw: {why}")]
    #[diagnostic(code("mech::picture::no_speed"))]
    NoSpeed {
        /// `velocities` or `accelerations`.
        what: &'static str,
        /// What the file does not give.
        why: &'static str,
        /// What it is about.
        #[label("without a speed")]
        at: Option<Span>,
        #[help]
        help: String,
    },
    #[error("there are no forces to draw: {why}")]
    #[diagnostic(code("mech::picture::no_forces"))]
    NoForces {
        why: String,
        /// What it is about.
        #[label("{what}")]
        at: Option<Span>,
        what: &'static str,
        #[help]
        help: String,
    },
    #[error("there is no point `{name}` whose path could be drawn")]
    #[diagnostic(code("mech::picture::no_point"))]
    NoPoint {
        name: String,
        /// Its link, where there is one.
        #[label("this link has no such point")]
        at: Option<Span>,
        /// What may be meant.
        #[help]
        help: String,
    },
    /// No way of the drive.
    #[error("there is no motion over which paths or other poses could be drawn")]
    #[diagnostic(
        code("mech::picture::no_way"),
        help("give the only drive a range: `drive crank = 0 deg .. 360 deg in 12 steps`")
    )]
    NoWay {
        #[label("one position")]
        at: Option<Span>,
    },
    #[error("there is no friction to draw: no pair has a friction circle or a coefficient")]
    #[diagnostic(
        code("mech::picture::no_friction"),
        help(
            "give a pair friction: `revolute A: ground - crank {{ friction_circle 5 mm }}`, or `prismatic D: … {{ friction 0.1 }}`"
        )
    )]
    NoFriction,
    #[error("there is no train to draw: no shaft or slider is declared without a position")]
    #[diagnostic(
        code("mech::picture::no_train"),
        help("draw the `scheme`, or declare shafts: `shaft I {{ wheel a teeth 20 }}`")
    )]
    NoTrain,
    /// A scale that does not fit.
    #[error("the scale {wanted} does not fit: {why}")]
    #[diagnostic(code("mech::picture::no_scale"))]
    NoScale {
        /// `length = 0.001 m/mm`.
        wanted: String,
        /// What would come of it.
        why: &'static str,
        #[help]
        help: String,
    },
    /// No link has a place.
    #[error("no link has a position: {needs}")]
    #[diagnostic(
        code("mech::picture::not_placed"),
        help(
            "give the axes positions: `ground {{ O1 (0, 0) }}` and `shaft I {{ wheel a teeth 20 module 2 mm at O1 }}`"
        )
    )]
    NotPlaced {
        /// `a plan shows velocities of points`.
        needs: &'static str,
        #[label("has no position")]
        at: Option<Span>,
    },
}

impl assur_text::diagnostic::Problem for Missing {}

impl Missing {
    /// No such point; the help names those that are meant.
    pub(crate) fn no_point(scene: &Scene<'_>, name: &str) -> Self {
        let links = scene.mechanism().links.iter().skip(1);
        let all = links.flat_map(|link| link.points.iter().map(|p| format!("{}.{}", link.name, p.name)));
        let all: Vec<String> = all.collect();
        let near = did_you_mean(name, all.iter().map(String::as_str));
        let help = match near.first() {
            Some(near) => format!("did you mean `{near}`?"),
            None => format!("the points are {}", offered(&all)),
        };
        let own = name.split_once('.').map_or(name, |(link, _)| link);
        let link = scene
            .mechanism()
            .links
            .iter()
            .skip(1)
            .find(|l| l.name == own || l.number.as_deref() == Some(own));
        Self::NoPoint { name: name.to_owned(), at: link.map(|link| link.span), help }
    }

    pub(crate) fn no_forces(why: &str, help: &str) -> Self {
        Self::NoForces { why: why.to_owned(), at: None, what: "", help: help.to_owned() }
    }

    /// No forces, because of a drive.
    pub(crate) fn no_forces_by_drive(scene: &Scene<'_>, why: &str, what: &'static str, help: &str) -> Self {
        let at = scene.mechanism().drives.first().map(|drive| drive.span);
        Self::NoForces { why: why.to_owned(), at, what, help: help.to_owned() }
    }

    /// No motion over which something could be drawn.
    pub(crate) fn no_way(scene: &Scene<'_>) -> Self {
        Self::NoWay { at: scene.mechanism().drives.first().map(|drive| drive.span) }
    }

    /// No link has a place.
    pub(crate) fn nothing_placed(scene: &Scene<'_>, needs: &'static str) -> Self {
        let links = &scene.mechanism().links;
        let open = (1..links.len()).find(|i| !scene.is_placed(LinkId::at(*i)));
        Self::NotPlaced { needs, at: open.map(|i| links[i].span) }
    }

    /// No drive has a speed; the help writes one behind the first.
    pub(crate) fn no_speed(scene: &Scene<'_>, what: &'static str) -> Self {
        let mechanism = scene.mechanism();
        let why = match mechanism.drives.is_empty() {
            true => "the file has no drive",
            false if scene.model.plan.effects.moving => "no drive has a speed, only a sense",
            false => "no drive has a speed",
        };
        let line = mechanism.drives.first().map_or_else(
            || "drive crank = 45 deg at 80 rpm".to_owned(),
            |drive| {
                let speed = if turns(&scene.model, drive) { "80 rpm" } else { "0.1 m/s" };
                match &drive.written {
                    Some(written) => format!("drive {} = {written} at {speed}", drive.name),
                    None => format!("drive {} at {speed}", drive.name),
                }
            },
        );
        let at = mechanism.drives.first().map(|drive| drive.span);
        Self::NoSpeed { what, why, at, help: format!("give the drive a speed: `{line}`") }
    }

    /// No position, or none of a name, is solved.
    pub(crate) fn no_position(mechanism: &Mechanism, solution: &Solution, name: Option<&str>) -> Self {
        let at = mechanism.drives.first().map(|drive| drive.span);
        let solved = solution.poses.iter().filter(|p| p.outcome.is_ok());
        let known: Vec<String> = solved.map(|p| p.name.clone()).collect();
        match name {
            Some(name) if !known.is_empty() => Self::NoPosition {
                named: format!(": no solved pose is named `{name}`"),
                at,
                help: format!("the poses are {}", offered(&known)),
            },
            _ => Self::NoPosition {
                named: String::new(),
                at: None,
                help: "declare a link with a drive: `drive crank = 45 deg`".to_owned(),
            },
        }
    }
}
