//! The data of questions, expectations, curves and motions under loads.

use super::datum::{GivenLine, GivenValue, Shown, datum, flag, one};
use super::members::properties;
use super::walk::{hidden, sensed, written};
use crate::document::{
    Balanced, CompareOp, Curve, CurveBetween, CurveBeyond, Expect, ExpectAt, Find, Simulate, Start, Steady,
    Stop, TimeCourse,
};

pub(super) fn find<'d>(line: &mut GivenLine<'d>, own: &'d Find) {
    for item in &own.items {
        item.name.iter().for_each(|name| line.join(&name.node));
        hidden(line, &item.value, Shown::Question);
        item.steps.iter().for_each(|steps| hidden(line, steps, Shown::Question));
    }
}

pub(super) fn expect<'d>(line: &mut GivenLine<'d>, own: &'d Expect) {
    let settings = match &own.at {
        Some(ExpectAt::Settings(settings)) => settings.as_slice(),
        Some(ExpectAt::Pose(_) | ExpectAt::Event(..)) | None => &[],
    };
    let values = std::iter::once(&own.what).chain(&own.values).chain(&own.within);
    let values = values.chain(settings.iter().map(|setting| &setting.value.value));
    values.for_each(|value| hidden(line, value, Shown::Key));
}

pub(super) fn curve<'d>(line: &mut GivenLine<'d>, own: &'d Curve) {
    line.join(&own.name.node);
    line.add(datum("curve", GivenValue::Curve(own)).map(|datum| datum.called(&[&own.name.node])));
    line.add(flag(match own.between {
        Some(CurveBetween::Linear) => "curve.linear",
        Some(CurveBetween::Smooth) | None => "curve.smooth",
    }));
    match own.beyond {
        Some(CurveBeyond::Periodic) => line.add(flag("curve.periodic")),
        Some(CurveBeyond::Held) => line.add(flag("curve.held")),
        None => {}
    }
}

pub(super) fn start<'d>(line: &mut GivenLine<'d>, own: &'d Start) {
    let name = written(&own.target);
    line.named(&[&name]);
    line.join(&own.target.head.node);
    own.value.iter().for_each(|value| sensed(line, "start", value, &name));
    own.rate.iter().for_each(|rate| sensed(line, "start.rate", rate, &name));
}

pub(super) fn balanced<'d>(line: &mut GivenLine<'d>, own: &'d Balanced) {
    let name = written(&own.target);
    line.named(&[&name]);
    line.join(&own.target.head.node);
    own.sought.values().for_each(|value| hidden(line, value, Shown::Method));
    own.rate.iter().for_each(|rate| sensed(line, "equilibrium.rate", rate, &name));
}

pub(super) fn simulate<'d>(line: &mut GivenLine<'d>, own: &'d Simulate) {
    match &own.course {
        TimeCourse::Between { from: None, to } => line.add(one("simulate", to)),
        TimeCourse::Between { from: Some(from), to } => {
            line.add(datum("simulate", GivenValue::Several(vec![from, to])));
        }
        TimeCourse::Steady(Steady { of, .. }) => {
            line.join(&of.head.node);
            line.add(flag("steady"));
        }
    }
    own.steps.iter().chain(&own.within).for_each(|value| hidden(line, value, Shown::Method));
}

pub(super) fn stop<'d>(line: &mut GivenLine<'d>, own: &'d Stop) {
    line.join(&own.pair.node);
    let op = match own.op.node {
        CompareOp::Less => "<",
        CompareOp::LessOrEqual => "≤",
        CompareOp::Greater => ">",
        CompareOp::GreaterOrEqual => "≥",
    };
    let names = format!("{} {op}", own.pair.node);
    line.add(one("stop", &own.bound).map(|datum| datum.called(&[&*names])));
    properties(line, "stop", &own.pair.node, &own.properties);
}
