//! Ropes: over idlers, under pulleys on sliders, to wheels and sliders.
//!
//! With s the speed of the rope along its path towards its first end: a slider at the first end moves away by v = s, one at
//! the last end by v = −s; a wheel keeps the rope from slipping, s = ±ω r; under a pulley on slider P the rope grows by two
//! parts, s after − s before = 2 v_P. A slider counts positive where the rope pays out of a wheel turning ccw, and wheels
//! on one rope keep their sense: from a rope that begins with a wheel, ω counts with −r.

use crate::expr::context::Context;
use crate::names::declared::ThingKind;
use crate::statements::written::{end_text, line_of};
use crate::trains::size::label;
use assur_model::model::{Law, LinkId, Rate, Wheel};
use assur_syntax::document::{End, Joint, Name, Statement};
use assur_text::diagnostic::Diagnosis;

/// Part of a rope's path.
enum Station {
    Slider(Rate, LinkId),
    Wheel(Wheel),
    Anchor,
    Over,
    Under(Rate, LinkId),
}

/// The laws of a rope, one for each part between wheels, and the links in the order written.
pub(crate) fn rope(cx: &mut Context<'_>, joint: &Joint) -> Option<(Vec<Law>, Vec<LinkId>)> {
    let stations: Vec<Option<Station>> = joint.ends.iter().map(|e| station(cx, e)).collect();
    let stations = stations.into_iter().collect::<Option<Vec<_>>>()?;
    let last = stations.len() - 1;
    for (i, (station, end)) in stations.iter().zip(&joint.ends).enumerate() {
        let outer = i == 0 || i == last;
        let message = match station {
            Station::Over | Station::Under(..) if outer => "a rope ends at a slider, a wheel or the ground",
            Station::Slider(..) | Station::Anchor if !outer => "a rope can be fastened only at its ends",
            _ => continue,
        };
        let help = match end {
            End::Over(_) => match rope_end(cx, joint) {
                Some(end) => format!("continue the rope: write `{}`", continued(joint, i == 0, end)),
                None => format!(
                    "continue the rope to a wheel or a slider, as in `{}`",
                    continued(joint, i == 0, "w1")
                ),
            },
            End::Under(_) => format!("fasten its end: write `{}`", continued(joint, i == 0, "ground")),
            End::At(path) if outer => format!("name the slider itself: `{}`", path.head.node),
            End::At(path) => format!(
                "write `under({})` for a pulley on the slider, or two ropes that end there",
                path.head.node
            ),
        };
        cx.error(
            Diagnosis::error("mech::train::rope_end", message).primary(end.span(), "this end").help(help),
        );
        return None;
    }
    let begins_with_wheel = matches!(stations.first(), Some(Station::Wheel(_)));
    let sense = if begins_with_wheel { -1.0 } else { 1.0 };
    let (mut laws, mut links) = (Vec::new(), Vec::new());
    // the speed at the part's end nearer to the rope's first end, negative, and all that is added on the way
    let mut terms: Vec<(Rate, f64)> = Vec::new();
    for (i, station) in stations.iter().enumerate() {
        match station {
            Station::Slider(rate, link) => {
                links.push(*link);
                terms.push((*rate, -1.0));
            }
            Station::Anchor => links.push(LinkId::GROUND),
            Station::Over => {}
            Station::Under(rate, link) => {
                links.push(*link);
                terms.push((*rate, -2.0));
            }
            Station::Wheel(wheel) => {
                links.push(wheel.link);
                let speed = (Rate::Turn(wheel.link), sense * wheel.radius);
                if i > 0 {
                    terms.push(speed);
                    laws.push(std::mem::take(&mut terms));
                }
                terms.push((speed.0, -speed.1));
            }
        }
    }
    if !matches!(stations.last(), Some(Station::Wheel(_))) {
        laws.push(terms);
    }
    let laws: Vec<Law> = laws
        .into_iter()
        .map(|terms| Law { terms: merged(terms), constant: 0.0, force: 1.0, efficiency: None })
        .collect();
    if laws.iter().any(|l| l.terms.iter().all(|(r, _)| *r == Rate::Turn(LinkId::GROUND))) {
        cx.error(
            Diagnosis::error("mech::train::rope_end", format!("rope `{}` moves nothing", joint.name.node))
                .primary(joint.name.span, "this rope")
                .help("begin the rope at a slider or a wheel: `rope a: A - over(C) - w1`"),
        );
        return None;
    }
    Some((laws, links))
}

/// Where a rope may end: a thing that no joint names, else any wheel or slider.
fn rope_end<'c>(cx: &'c Context<'_>, joint: &Joint) -> Option<&'c str> {
    let joints = cx.doc.statements.iter().filter_map(|s| match &s.node {
        Statement::Joint(joint) => Some(joint),
        _ => None,
    });
    let named = joints.flat_map(|j| &j.ends).filter_map(|end| match end {
        End::At(path) => Some(path.head.node.as_str()),
        _ => None,
    });
    let named = named.collect::<Vec<_>>();
    let fits = cx
        .names
        .things
        .iter()
        .filter(|(name, d)| ends_rope(joint, name, d.what))
        .map(|(name, _)| name.as_str());
    let fits = fits.collect::<Vec<_>>();
    fits.iter().copied().find(|name| !named.contains(name)).or_else(|| fits.first().copied())
}

/// Whether a rope may end at a thing that is not in it.
fn ends_rope(joint: &Joint, name: &str, kind: ThingKind) -> bool {
    let used = joint.ends.iter().any(|end| match end {
        End::At(path) => path.head.node == name,
        End::Over(other) | End::Under(other) => other.node == name,
    });
    !used && matches!(kind, ThingKind::Wheel | ThingKind::Slider)
}

/// The line of a rope with one more end before its first one, or after its last one.
fn continued(joint: &Joint, first: bool, end: &str) -> String {
    let line = line_of(joint, end_text);
    let ends = joint.ends.iter().map(end_text).collect::<Vec<_>>().join(" - ");
    let longer = if first { format!("{end} - {ends}") } else { format!("{ends} - {end}") };
    line.replacen(&ends, &longer, 1)
}

/// Terms of one rate are added up; what adds up to nothing is left out.
pub(crate) fn merged(terms: Vec<(Rate, f64)>) -> Vec<(Rate, f64)> {
    let mut out: Vec<(Rate, f64)> = Vec::new();
    for (rate, coefficient) in terms {
        match out.iter_mut().find(|(r, _)| *r == rate) {
            Some(term) => term.1 += coefficient,
            None => out.push((rate, coefficient)),
        }
    }
    out.retain(|(_, c)| *c != 0.0);
    out
}

fn station(cx: &mut Context<'_>, end: &End) -> Option<Station> {
    match end {
        End::Over(_) => Some(Station::Over),
        End::Under(name) => slider(cx, name).map(|(rate, link)| Station::Under(rate, link)),
        End::At(path) => {
            cx.names.note_thing(&path.head);
            if path.head.node == "ground" {
                if let Some(point) = &path.tail {
                    cx.point(LinkId::GROUND, point)?;
                }
                return Some(Station::Anchor);
            }
            if let Some(part) = &path.tail {
                cx.error(
                    Diagnosis::error(
                        "mech::train::rope_end",
                        "a rope cannot be fastened to a point of a moving link yet",
                    )
                    .primary(part.span, "this point")
                    .help("fasten it to the ground, a slider or a wheel"),
                );
                return None;
            }
            match cx.names.things.get(&path.head.node).map(|d| d.what) {
                Some(ThingKind::Slider) => {
                    slider(cx, &path.head).map(|(rate, link)| Station::Slider(rate, link))
                }
                Some(ThingKind::Idler) => {
                    let name = &path.head;
                    cx.error(
                        Diagnosis::error(
                            "mech::train::rope_end",
                            format!("`{}` is an idler, which turns freely", name.node),
                        )
                        .primary(name.span, "this idler")
                        .help(format!(
                            "write `over({})`, or give a shaft a wheel of another name",
                            name.node
                        )),
                    );
                    None
                }
                _ => {
                    let what = &[ThingKind::Wheel, ThingKind::Slider];
                    crate::pairs::transmission::known(cx, &path.head, "wheel or slider", what);
                    cx.wheel(&path.head.node).map(Station::Wheel)
                }
            }
        }
    }
}

fn slider(cx: &mut Context<'_>, name: &Name) -> Option<(Rate, LinkId)> {
    cx.names.note_thing(name);
    if !cx.names.things.get(&name.node).is_some_and(|d| d.what == ThingKind::Slider) {
        cx.no_thing(name, "slider", "a slider", |k| k == ThingKind::Slider);
        return None;
    }
    Some((Rate::Slide(cx.find_pair(&name.node)?), cx.find_link(&name.node)?))
}

/// Reports a rope's efficiency where the rope has more than two ends that move.
pub(crate) fn two_sides(cx: &mut Context<'_>, joint: &Joint, laws: &[Law]) -> Option<()> {
    if let [law] = laws
        && law.terms.len() == 2
    {
        return Some(());
    }
    cx.error(
        Diagnosis::error("mech::train::sizes", "the efficiency of a rope needs exactly two moving parts")
            .labels(vec![label("more than two parts", joint.name.span)])
            .help("leave it out, or divide the rope"),
    );
    None
}
