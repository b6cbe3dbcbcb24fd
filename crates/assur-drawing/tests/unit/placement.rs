use assur_drawing::{Drawing, Label, Later, Shape, Sheet, Style, Text, touches};
use assur_math::math::Vec2;

/// Numbers without an end, always the same.
struct Numbers(u64);

impl Numbers {
    fn next(&mut self, most: f64) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64 * most
    }
}

/// Labels at hinges, and lines that end so far away at most.
fn crowd(seed: u64, labels: usize, far: f64) -> Sheet {
    let mut numbers = Numbers(seed);
    let mut drawing = Drawing::new("crowd", "A crowd".to_owned(), "Many labels.".to_owned());
    for i in 0..labels {
        let at = Vec2::new(numbers.next(120.0), numbers.next(80.0));
        let to = Vec2::new(numbers.next(far), numbers.next(far));
        if i % 3 == 0 {
            drawing.line(Style::Link, at, to);
        }
        drawing.mark(Style::Hinge, Shape::Circle { centre: at, radius: 1.5 });
        let text = Text::name(&format!("N{i}"));
        drawing.label(match i % 4 {
            0 => Label::along(text, 4.0, at, to),
            1 => Label::at(text, 3.7, at, 1.5).ringed(2.5),
            _ => Label::at(text, 4.4, at, 1.5),
        });
    }
    drawing.placed()
}

#[test]
fn no_label_touches_another_or_what_is_thick() {
    for (seed, far) in (0..20).flat_map(|seed| [100.0, 700.0, 1e4].map(|far| (seed, far))) {
        let sheet = crowd(seed, 60, far);
        assert_eq!(sheet.placed.len(), 60);
        for (i, a) in sheet.placed.iter().enumerate() {
            assert!(sheet.placed[i + 1..].iter().all(|b| !a.bounds.overlaps(&b.bounds)), "{seed}");
            assert!(sheet.bounds.contains(&a.bounds), "{seed}");
            let round = a.label.ring.is_some_and(|r| a.label.half().x <= r);
            for mark in sheet.drawing.marks.iter().filter(|m| m.style.is_solid()) {
                let obstacles = mark.shape.obstacles(mark.style.half_width());
                assert!(
                    obstacles.iter().all(|o| !touches(&a.bounds, round, o, 0.0)),
                    "{seed}: {:?}",
                    a.label.text
                );
            }
        }
    }
}

#[test]
fn the_same_labels_come_to_the_same_places() {
    let (first, second) = (crowd(7, 40, 100.0), crowd(7, 40, 100.0));
    assert_eq!(first.placed, second.placed);
}

#[test]
fn a_label_with_room_is_where_it_is_best() {
    let mut drawing = Drawing::new("one", "One".to_owned(), "One label.".to_owned());
    drawing.mark(Style::Hinge, Shape::Circle { centre: Vec2::zero(), radius: 1.5 });
    drawing.label(Label::at(Text::name("A"), 4.0, Vec2::zero(), 1.5).towards(Vec2::new(0.0, -1.0)));
    let sheet = drawing.placed();
    let middle = sheet.placed[0].bounds.centre();
    assert!(middle.y < -2.0 && middle.x.abs() < 0.5, "{middle:?}");
}

/// A crank that turns under the name of its pin, and a name beside it that does not move.
#[test]
fn labels_keep_off_what_moves() {
    let pin = |angle: f64| Vec2::direction(angle) * 20.0;
    let crank = |angle: f64| {
        let mut drawing = Drawing::new("crank", "A crank".to_owned(), "It turns.".to_owned());
        drawing.line(Style::Link, Vec2::zero(), pin(angle));
        drawing.mark(Style::Hinge, Shape::Circle { centre: pin(angle), radius: 1.5 });
        // best where the bar comes along later
        let label = Label::at(Text::name("B"), 4.0, pin(angle), 1.5);
        drawing.label(label.towards(Vec2::new(0.0, 1.0)));
        drawing.label(Label::at(Text::name("A"), 4.0, Vec2::zero(), 1.5).towards(pin(2.0)));
        drawing
    };
    let frame = |i: i32| {
        let angle = 0.26 * f64::from(i);
        Later { marks: crank(angle).marks, shifts: vec![pin(angle) - pin(0.0), Vec2::zero()] }
    };
    let frames: Vec<Later> = (0..24).map(frame).collect();
    let covered = |sheet: &Sheet| {
        let on = |later: &&Later| {
            sheet.placed.iter().zip(&later.shifts).any(|(placed, by)| {
                let there = placed.bounds.shifted(*by);
                let solid = later.marks.iter().filter(|m| m.style.is_solid());
                let mut all = solid.flat_map(|m| m.shape.obstacles(m.style.half_width()));
                all.any(|o| touches(&there, false, &o, 0.0))
            })
        };
        frames.iter().filter(on).count()
    };
    let (first, all) = (covered(&crank(0.0).placed()), covered(&crank(0.0).placed_through(&frames)));
    assert!(first >= 9 && all <= 6, "{first} frames, then {all}");
}
