use super::freed;
use super::newton_euler::{Bodies, followed, last};
use crate::support::reference::Reference;
use crate::support::run::{Run, scalar, vector};
use assur::internals::math::Vec2;
use assur::internals::model::{LinkId, PointRef, Query};

#[test]
fn dbg() {
    let seed: u64 = std::env::var("DBG").unwrap().parse().unwrap();
    let to: f64 = std::env::var("TO").unwrap_or("1e-4".into()).parse().unwrap();
    let mut draft =
        if seed >= 30_000 && seed < 40_000 { super::follow::smooth(seed, 4).unwrap() } else { freed(seed) };
    if seed >= 40_000 {
        draft.mechanism.loads.clear();
        draft.mechanism.springs.iter_mut().for_each(|s| s.damping = 0.0);
    }
    let m = &draft.mechanism;
    for d in &m.drives {
        println!("drive free {} {:?} {:?} {:?} {:?}", d.free, d.target, d.positions, d.speed, d.acceleration);
    }
    for p in &m.pairs {
        println!("pair {:?}", p.kind);
    }
    for (i, l) in m.links.iter().enumerate() {
        println!("link {i} {:?}", l.mass);
    }
    for l in &m.loads {
        println!("load {:?} when {:?}", l.kind, l.when);
    }
    for l in &m.springs {
        println!("spring {l:?}");
    }
    println!("{:?} {:?}", m.gravity, draft.made);
    println!("rollers {:?}", draft.rollers);
    let reference = Reference::new(&draft.mechanism, &draft.frames).unwrap();
    let mut bodies = Bodies::new(&draft.mechanism).unwrap();
    let (want, doubtful) = bodies.accelerations(&draft.frames, &reference.rates, 0.0).unwrap();
    println!("doubtful {doubtful} condition {:?}", super::condition(&draft));
    let mut mechanism = draft.mechanism.clone();
    followed(&mut mechanism, to, Some(10), 1e-10);
    let run = Run::new(&mechanism).unwrap();
    let s = run.solution.as_ref().unwrap();
    println!("{:?}", s.simulation);
    println!(
        "{:?}",
        s.poses
            .iter()
            .map(|p| (
                p.name.clone(),
                p.outcome.as_ref().map(|o| (o.condition, o.residuals.power)).map_err(|e| format!("{e:?}"))
            ))
            .collect::<Vec<_>>()
    );
    let (solved, view) = (run.solved(0).unwrap(), run.view(0).unwrap());
    println!("sigma {}", solved.condition);
    for (i, rates) in want.iter().enumerate().skip(1) {
        let link = LinkId::at(i);
        let got = vector(&view, &Query::Acceleration(PointRef::Fixed(link, Vec2::zero())));
        let alpha = scalar(&view, &Query::Alpha(link));
        println!("{i} {got:?} {:?} {alpha} {} v {:?} {}", rates.a, rates.alpha, rates.v, rates.omega);
    }
    for within in [1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-13] {
        followed(&mut mechanism, to, Some(4), within);
        let run = Run::new(&mechanism).unwrap();
        let e: Vec<f64> = (0..5)
            .map(|i| {
                let v = run.view(i).unwrap();
                scalar(&v, &Query::KineticEnergy) + scalar(&v, &Query::PotentialEnergy)
            })
            .collect();
        let v: Vec<f64> = (0..5)
            .map(|i| {
                let v = run.view(i).unwrap();
                vector(&v, &Query::Velocity(PointRef::Fixed(LinkId::at(1), Vec2::zero()))).x
            })
            .collect();
        let p: Vec<f64> = (0..5)
            .map(|i| {
                let v = run.view(i).unwrap();
                vector(&v, &Query::Position(PointRef::Fixed(LinkId::at(1), Vec2::zero()))).x
            })
            .collect();
        let s = run.solution.as_ref().unwrap().simulation.as_ref().unwrap();
        println!(
            "{within:e} {:e} {} steps {} {:?} {v:?} {p:?}",
            s.error,
            s.worst,
            s.steps,
            e.iter().map(|x| x - e[0]).collect::<Vec<_>>()
        );
    }
    if seed < 40000 {
        println!("differs {:?}", super::follow::differs(&draft));
    }
    let _ = last(&run);
}
