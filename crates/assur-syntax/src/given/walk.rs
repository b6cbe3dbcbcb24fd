//! The data of a statement.

use super::datum::{GivenLine, GivenValue, Shown, datum, flag, one};
use super::members::{body, cam, is_right_angle, properties};
use super::requests::{balanced, curve, expect, find, simulate, start, stop};
use crate::document::{
    AssembleClause, Balance, Definition, Direction, Drive, End, Event, Expr, Joint, Link, Load, LoadKind,
    Path, Place, Sensed, Site, Spring, SpringSite, Statement, Turn, Way,
};
use assur_text::source::Spanned;

/// The line of a statement.
pub(super) fn line(number: usize, statement: &Statement) -> GivenLine<'_> {
    let mut line = GivenLine::new(number, subject(statement));
    match statement {
        Statement::Edition(_)
        | Statement::Title(_)
        | Statement::Group(_)
        | Statement::Variants(_)
        | Statement::Ignore(_)
        | Statement::Bad(_) => {}
        Statement::Given(value) => definition(&mut line, "given", value),
        Statement::Let(value) => definition(&mut line, "let", value),
        Statement::Gravity(value) => line.add(one("gravity", value)),
        Statement::Ground(ground) => body(&mut line, &ground.body, "0"),
        Statement::Link(own) => link(&mut line, own),
        Statement::Shaft(shaft) => {
            line.named(&[&shaft.name.node]);
            line.join(&shaft.name.node);
            shaft.on.iter().for_each(|on| line.join(&on.node));
            body(&mut line, &shaft.body, &shaft.name.node);
        }
        Statement::Slider(slider) => {
            line.named(&[&slider.name.node]);
            line.join(&slider.name.node);
            body(&mut line, &slider.body, &slider.name.node);
        }
        Statement::Joint(own) => joint(&mut line, own),
        Statement::Spring(own) => spring(&mut line, own),
        Statement::Drive(own) => drive(&mut line, own),
        Statement::Pose(pose) => {
            for setting in &pose.settings {
                line.join(&setting.target.head.node);
                hidden(&mut line, &setting.value.value, Shown::Heading);
            }
        }
        Statement::Assemble(own) => own.clauses.iter().for_each(|clause| assemble(&mut line, &clause.node)),
        Statement::Balance(own) => balance(&mut line, own),
        Statement::Load(own) => load(&mut line, own),
        Statement::Brake(brake) => {
            line.named(&[&brake.name.node, &brake.on.node]);
            [&brake.name, &brake.on].into_iter().for_each(|name| line.join(&name.node));
            properties(&mut line, "brake", &brake.name.node, &brake.properties);
        }
        Statement::Cam(own) => cam(&mut line, own),
        Statement::Counterweight(own) => {
            line.named(&[&own.name.node, &own.on.node]);
            [&own.name, &own.on].into_iter().for_each(|name| line.join(&name.node));
            properties(&mut line, "counterweight", &own.name.node, &own.properties);
        }
        Statement::Flywheel(own) => {
            line.named(&[&own.name.node, &own.on.node]);
            [&own.name, &own.on].into_iter().chain(&own.torque).for_each(|name| line.join(&name.node));
            properties(&mut line, "flywheel", &own.name.node, &own.properties);
        }
        Statement::All(all) => {
            line.named(&[all.kind.node.word()]);
            properties(&mut line, all.kind.node.word(), "", &all.properties);
        }
        Statement::Find(own) => find(&mut line, own),
        Statement::Expect(own) => expect(&mut line, own),
        Statement::Curve(own) => curve(&mut line, own),
        Statement::Start(own) => start(&mut line, own),
        Statement::Equilibrium(all) => all.iter().for_each(|own| balanced(&mut line, own)),
        Statement::Simulate(own) => simulate(&mut line, own),
        Statement::Event(Event { name, passing }) => {
            line.named(&[&name.node]);
            line.join(&name.node);
            line.add(datum("event", GivenValue::Passing(passing)));
        }
        Statement::Until(own) => line.add(datum("until", GivenValue::Passing(&own.passing))),
        Statement::Stop(own) => stop(&mut line, own),
    }
    line
}

/// What the line of a statement is about.
fn subject(statement: &Statement) -> &'static str {
    match statement {
        Statement::Ground(_) => "ground",
        Statement::Link(_) => "link",
        Statement::Shaft(_) => "shaft",
        Statement::Slider(_) => "slider",
        Statement::Joint(joint) => joint.kind.node.word(),
        Statement::Spring(spring) => {
            let is_elastic = spring.properties.iter().any(|p| p.name.node == "stiffness");
            if is_elastic { "spring" } else { "damper" }
        }
        Statement::Drive(_) => "drive",
        Statement::Balance(_) => "unknown",
        Statement::Load(_) => "load",
        Statement::Brake(_) => "brake",
        Statement::Cam(_) => "cam",
        Statement::Counterweight(_) => "counterweight",
        Statement::Flywheel(_) => "flywheel",
        Statement::All(_) => "all",
        Statement::Start(_) => "start",
        Statement::Equilibrium(_) => "equilibrium",
        Statement::Event(_) => "event",
        Statement::Edition(_)
        | Statement::Title(_)
        | Statement::Given(_)
        | Statement::Let(_)
        | Statement::Gravity(_)
        | Statement::Group(_)
        | Statement::Pose(_)
        | Statement::Assemble(_)
        | Statement::Find(_)
        | Statement::Expect(_)
        | Statement::Variants(_)
        | Statement::Curve(_)
        | Statement::Simulate(_)
        | Statement::Until(_)
        | Statement::Stop(_)
        | Statement::Ignore(_)
        | Statement::Bad(_) => "",
    }
}

/// A value that is not under "Given".
pub(super) fn hidden<'d>(line: &mut GivenLine<'d>, value: &'d Expr, shown: Shown) {
    let key = match shown {
        Shown::Heading => "drive.position",
        Shown::Figure => "assemble",
        Shown::Question => "find",
        Shown::Key => "expect",
        Shown::Text | Shown::Method => "method",
    };
    line.add(one(key, value).map(|datum| datum.shown(shown)));
}

fn definition<'d>(line: &mut GivenLine<'d>, key: &str, own: &'d Definition) {
    let mut value = one(key, &own.value);
    value.iter_mut().for_each(|datum| datum.own = Some(&own.name.node));
    line.add(value);
}

fn link<'d>(line: &mut GivenLine<'d>, own: &'d Link) {
    let number = own.number.as_ref().map_or("", |number| &number.node);
    line.named(&[&own.name.node, number]);
    line.join(&own.name.node);
    if let Some(bar) = &own.bar {
        let ends = joined(&bar.from.node, &bar.to.node);
        line.add(one("bar", &bar.length).map(|datum| datum.of(ends)));
    }
    body(line, &own.body, if number.is_empty() { &own.name.node } else { number });
}

/// Two points as one index.
fn joined(from: &str, to: &str) -> String {
    let short = |name: &str| name.chars().filter(|c| c.is_alphabetic()).count() <= 1;
    if short(from) && short(to) { format!("{from}{to}") } else { format!("{from},{to}") }
}

pub(super) fn written(path: &Path) -> String {
    let tail = path.tail.as_ref().map_or_else(String::new, |tail| format!(".{}", tail.node));
    format!("{}{tail}", path.head.node)
}

fn joint<'d>(line: &mut GivenLine<'d>, own: &'d Joint) {
    line.join(&own.name.node);
    let end = |end: &'d End| match end {
        End::At(path) => (written(path), &path.head.node),
        End::Over(name) | End::Under(name) => (name.node.clone(), &name.node),
    };
    let ends: Vec<_> = own.ends.iter().map(end).collect();
    ends.iter().for_each(|(_, name)| line.join(name));
    let ends = ends.into_iter().map(|(written, _)| written).collect::<Vec<_>>().join("–");
    line.named(&[&own.name.node, &ends]);
    properties(line, own.kind.node.word(), &own.name.node, &own.properties);
}

fn spring<'d>(line: &mut GivenLine<'d>, own: &'d Spring) {
    line.join(&own.name.node);
    let (site, index) = match &own.site {
        SpringSite::Points(from, to) => {
            [from, to].into_iter().for_each(|end| line.join(&end.head.node));
            (format!("{}–{}", written(from), written(to)), own.name.node.as_str())
        }
        SpringSite::Pair(pair) => {
            line.join(&pair.node);
            (pair.node.clone(), own.name.node.as_str())
        }
    };
    line.named(&[&own.name.node, &site]);
    properties(line, "spring", index, &own.properties);
}

/// A value with its sense.
pub(super) fn sensed<'d>(line: &mut GivenLine<'d>, key: &str, value: &'d Sensed, index: &str) {
    let sense = value.sense.as_ref().map(|sense| sense.node);
    line.add(datum(key, GivenValue::One(&value.value, sense)).map(|datum| datum.of(index)));
}

fn drive<'d>(line: &mut GivenLine<'d>, own: &'d Drive) {
    let name = written(&own.target);
    line.named(&[&name]);
    line.join(&own.target.head.node);
    if let Some(position) = &own.position {
        let at = datum("drive.position", GivenValue::Positions(position));
        line.add(at.map(|datum| datum.of(&*name).shown(Shown::Heading)));
    }
    own.rate.iter().for_each(|rate| sensed(line, "drive.at", rate, &name));
    own.acceleration.iter().for_each(|rate| sensed(line, "drive.accelerating", rate, &name));
    if let Some(direction) = &own.direction {
        line.add(flag("drive.sense").map(|datum| datum.called(&[word_of(direction)])));
    }
}

/// A sense as the language writes it.
fn word_of(direction: &Spanned<Direction>) -> &'static str {
    match direction.node {
        Direction::Turning(Turn::Ccw) => "ccw",
        Direction::Turning(Turn::Cw) => "cw",
        Direction::Moving(Way::Forward) => "forward",
        Direction::Moving(Way::Back) => "back",
    }
}

fn assemble<'d>(line: &mut GivenLine<'d>, clause: &'d AssembleClause) {
    match clause {
        AssembleClause::Near { what, at } => {
            line.join(&what.head.node);
            hidden(line, at, Shown::Method);
        }
        AssembleClause::Phase { what, phase } => {
            line.join(&what.head.node);
            let index = written(what);
            line.add(one("assemble.phase", phase).map(|datum| datum.called(&[&*index]).of(&*index)));
        }
        AssembleClause::Sign { what, op: _, bound } => {
            line.join(&what.head.node);
            hidden(line, bound, Shown::Figure);
        }
        AssembleClause::Side { .. } | AssembleClause::Order { .. } => {}
    }
}

/// What a load acts on, and its point: said after the datum before it.
fn site<'d>(line: &mut GivenLine<'d>, site: &'d Site) {
    match site {
        Site::Pair(name) | Site::Pin(name) => line.join(&name.node),
        Site::Segment { link, .. } => line.join(&link.node),
        Site::Link { link, at } => {
            line.join(&link.node);
            match at {
                Some(Place::Point(point)) => line.add(flag("mass.at").map(|d| d.called(&[&point.node]))),
                Some(Place::Ground(place)) => line.add(one("force.place", place)),
                None => {}
            }
        }
    }
}

fn on(site: &Site) -> &str {
    match site {
        Site::Pair(name) | Site::Pin(name) => &name.node,
        Site::Segment { link, .. } | Site::Link { link, .. } => &link.node,
    }
}

fn balance<'d>(line: &mut GivenLine<'d>, own: &'d Balance) {
    line.named(&[&own.name.node]);
    line.join(&own.name.node);
    own.also.iter().for_each(|name| line.join(&name.node));
    if let Some(along) = &own.along {
        let shown = if is_right_angle(along) && own.frame.is_none() { Shown::Figure } else { Shown::Text };
        line.add(one("balance.along", along).map(|datum| datum.of(&*own.name.node).shown(shown)));
    }
    own.frame.iter().for_each(|link| line.add(flag("in.frame").map(|datum| datum.called(&[&link.node]))));
    match &own.site {
        Site::Link { at: Some(Place::Ground(_)), .. } => site(line, &own.site),
        _ => line.join(on(&own.site)),
    }
}

fn load<'d>(line: &mut GivenLine<'d>, own: &'d Load) {
    line.named(&[on(&own.site)]);
    own.name.iter().for_each(|name| line.join(&name.node));
    let (key, ends) = match (&own.site, own.kind.node) {
        (Site::Segment { from, to, .. }, _) => ("distributed", vec![from.node.as_str(), &to.node]),
        (_, LoadKind::Force) => ("force", Vec::new()),
        (_, LoadKind::Torque) => ("torque", Vec::new()),
    };
    let value = match &own.last {
        Some(last) => GivenValue::Several(vec![&own.value.value, last]),
        None => GivenValue::One(&own.value.value, own.value.sense.as_ref().map(|sense| sense.node)),
    };
    let mut load = datum(key, value).map(|datum| datum.called(&ends).of(on(&own.site)));
    load.iter_mut().for_each(|datum| datum.own = own.name.as_ref().map(|name| name.node.as_str()));
    line.add(load);
    own.frame.iter().for_each(|link| line.add(flag("in.frame").map(|datum| datum.called(&[&link.node]))));
    site(line, &own.site);
    own.against_motion.iter().for_each(|_| line.add(flag("against")));
    own.when.iter().for_each(|when| line.add(one("when", when)));
}
