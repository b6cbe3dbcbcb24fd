//! Animations as GIF and APNG, in builds with them and without.

use crate::cli::GOOD;
use crate::run::{Folder, assur};

#[cfg(not(feature = "gif"))]
#[test]
fn a_build_without_gif_says_so() {
    let folder = Folder::new("no-gif").with("a.mech", GOOD);
    for name in ["a.gif", "a.apng"] {
        let out = assur(&folder, &["draw", "a.mech", "animation", "-o", name]);
        assert_eq!((out.status, out.stdout.as_str()), (2, ""));
        assert!(out.stderr.contains("takes the feature `gif`"), "{}", out.stderr);
        assert!(out.stderr.contains("`cargo install --path . --features gif`"), "{}", out.stderr);
    }
    assert_eq!(folder.names(), ["a.mech"]);
}

#[test]
fn options_of_films_are_of_films() {
    let folder = Folder::new("no-film").with("a.mech", GOOD);
    for (option, value) in [("--width", "320"), ("--time", "2s")] {
        let out = assur(&folder, &["draw", "a.mech", "animation", option, value, "-o", "a.svg"]);
        assert_eq!((out.status, out.stdout.as_str()), (2, ""));
        assert!(out.stderr.contains(&format!("`{option}` changes no picture")), "{}", out.stderr);
        assert!(out.stderr.contains("it is for GIF and APNG"), "{}", out.stderr);
    }
    for (option, value) in [("--width", "39"), ("--width", "4001"), ("--time", "6"), ("--time", "0s")] {
        let out = assur(&folder, &["draw", "a.mech", "animation", option, value, "-o", "a.gif"]);
        assert_eq!((out.status, out.stdout.as_str()), (2, ""), "{option} {value}");
    }
    assert_eq!(folder.names(), ["a.mech"]);
}

#[cfg(feature = "gif")]
mod with_gif {
    use super::{Folder, GOOD, assur};
    use assur::internals::Solved;
    use assur::internals::check::Overrides;
    use assur::internals::drawing::Theme;
    use assur::internals::picture::{KINDS, Options, Scene, film};
    use assur::internals::pipeline::{solve_drawn, turn_in};
    use assur::internals::source::Source;
    use assur::internals::worked::Language;
    use resvg::tiny_skia::{Color, Pixmap, Transform};
    use resvg::usvg;
    use std::io::Cursor;

    /// Every frame as red, green and blue, and the times of the frames in hundredths of a second.
    struct Read {
        size: (u32, u32),
        frames: Vec<Vec<[u8; 3]>>,
        delays: Vec<u16>,
        endless: bool,
    }

    impl Read {
        fn new(size: (u32, u32), endless: bool) -> Self {
            Self { size, frames: Vec::new(), delays: Vec::new(), endless }
        }

        /// Adds what is new in a frame.
        fn add(&mut self, [left, top, width]: [u32; 3], pixels: &[u8], delay: u16) {
            let all = (self.size.0 * self.size.1) as usize;
            let mut frame = self.frames.last().cloned().unwrap_or_else(|| vec![[1, 2, 3]; all]);
            for (i, pixel) in (0..).zip(pixels.as_chunks::<4>().0) {
                let [red, green, blue, alpha] = *pixel;
                if alpha > 0 {
                    let at = (top + i / width) * self.size.0 + left + i % width;
                    frame[at as usize] = [red, green, blue];
                }
            }
            self.frames.push(frame);
            self.delays.push(delay);
        }

        fn gif(bytes: &[u8]) -> Self {
            let mut options = gif::DecodeOptions::new();
            options.set_color_output(gif::ColorOutput::RGBA);
            let mut decoder = options.read_info(bytes).expect("a GIF");
            let size = (u32::from(decoder.width()), u32::from(decoder.height()));
            let mut read = Self::new(size, false);
            while let Some(frame) = decoder.read_next_frame().expect("a frame") {
                let part = [frame.left, frame.top, frame.width].map(u32::from);
                read.add(part, &frame.buffer, frame.delay);
            }
            read.endless = decoder.repeat() == gif::Repeat::Infinite;
            read
        }

        fn apng(bytes: &[u8]) -> Self {
            let mut reader = png::Decoder::new(Cursor::new(bytes)).read_info().expect("a PNG");
            let info = reader.info();
            let control = info.animation_control.expect("an animation");
            let mut read = Self::new(info.size(), control.num_plays == 0);
            let mut buffer = vec![0; reader.output_buffer_size().expect("a size")];
            for _ in 0..control.num_frames {
                let size = reader.next_frame(&mut buffer).expect("a frame").buffer_size();
                let of = *reader.info().frame_control().expect("a frame's place");
                assert_eq!(of.delay_den, 100);
                read.add([of.x_offset, of.y_offset, of.width], &buffer[..size], of.delay_num);
            }
            read
        }
    }

    /// The mean difference of the parts of colours.
    fn mean(a: &[[u8; 3]], b: &[[u8; 3]]) -> f64 {
        assert_eq!(a.len(), b.len());
        let parts = a.as_flattened().iter().zip(b.as_flattened());
        parts.map(|(a, b)| f64::from(a.abs_diff(*b))).sum::<f64>() / (3 * a.len()) as f64
    }

    /// A frame of the animation as this test draws it.
    fn drawn(text: &str, count: usize, frame: usize, width: u32) -> Vec<[u8; 3]> {
        let source = Source::new("a.mech", text);
        let solved: Solved = solve_drawn(&source, &Overrides::none(), &KINDS).0.expect("it is solved");
        let turn = turn_in(&solved.compiled, &solved.solution, count);
        let scene = Scene::of(solved.compiled.model(), &solved.solution, ("a.mech", text), None);
        let scene = Scene { turn: &turn, ..scene.expect("a position") };
        let options = Options { frames: Some(count), ..Options::default() };
        let film = film(&scene, &options, Theme::Light, &Language::English).expect("a film");
        assert_eq!(film.count(), count);
        let mut fonts = usvg::Options::default();
        fonts.fontdb_mut().load_system_fonts();
        let tree = usvg::Tree::from_str(&film.frame(frame), &fonts).expect("a picture");
        let factor = width as f32 / tree.size().width();
        let mut pixels = Pixmap::new(width, (tree.size().height() * factor).ceil() as u32).expect("a size");
        pixels.fill(Color::WHITE);
        resvg::render(&tree, Transform::from_scale(factor, factor), &mut pixels.as_mut());
        pixels.pixels().iter().map(|p| [p.red(), p.green(), p.blue()]).collect()
    }

    #[test]
    fn a_gif_and_an_apng_have_the_frames_of_the_animation() {
        let folder = Folder::new("gif").with("a.mech", GOOD);
        let arguments = ["draw", "a.mech", "animation", "--width", "301", "--frames", "7", "--time", "500ms"];
        let draw = |name: &str| {
            let out = assur(&folder, &[&arguments[..], &["-o", name]].concat());
            let has_fonts = !out.stderr.contains("no font for its letters");
            assert!(!has_fonts || (out.status, out.stderr.as_str()) == (0, ""), "{}", out.stderr);
            has_fonts.then(|| std::fs::read(folder.path(name)).expect("a picture"))
        };
        // a machine without fonts draws none
        let (Some(gif), Some(apng)) = (draw("a.gif"), draw("a.apng")) else { return };
        assert!(draw("b.gif").as_ref() == Some(&gif) && draw("b.apng").as_ref() == Some(&apng));
        let (gif, apng) = (Read::gif(&gif), Read::apng(&apng));
        for read in [&gif, &apng] {
            assert_eq!((read.size.0, read.frames.len(), read.endless), (301, 7, true));
            assert_eq!(read.delays, [7, 7, 7, 7, 7, 7, 8], "they add up to half a second");
        }
        assert_eq!(gif.size, apng.size);
        for (k, (few, true_colours)) in gif.frames.iter().zip(&apng.frames).enumerate() {
            assert!(mean(few, true_colours) < 1.0, "frame {k} is off by {}", mean(few, true_colours));
        }
        for frame in [0, 3, 6] {
            assert!(drawn(GOOD, 7, frame, 301) == apng.frames[frame], "frame {frame}");
        }
        let moved = apng.frames.windows(2).all(|pair| mean(&pair[0], &pair[1]) > 0.2);
        assert!(moved, "each frame shows another position");
    }

    #[test]
    fn a_gif_is_of_48_frames_640_wide_in_six_seconds() {
        let folder = Folder::new("gif-plain").with("a.mech", GOOD);
        let out = assur(
            &folder,
            &["draw", "a.mech", "animation", "--theme", "dark", "-o", "out", "--format", "gif"],
        );
        if out.stderr.contains("no font for its letters") {
            return;
        }
        assert_eq!((out.status, out.stdout.as_str(), out.stderr.as_str()), (0, "", ""));
        let bytes = std::fs::read(folder.path("out/a-animation.gif")).expect("a picture");
        assert!(bytes.len() < 350_000, "{} bytes", bytes.len());
        let read = Read::gif(&bytes);
        assert_eq!((read.size.0, read.frames.len(), read.delays.iter().sum::<u16>()), (640, 48, 600));
        assert_eq!(read.frames[0][0], [0x16, 0x18, 0x1c], "the paper is dark");
    }

    #[test]
    fn a_gif_is_of_an_animation() {
        let folder = Folder::new("gif-scheme").with("a.mech", GOOD);
        let says = |arguments: &[&str], words: &str| {
            let out = assur(&folder, &[&["draw", "a.mech"], arguments].concat());
            assert_eq!((out.status, out.stdout.as_str()), (2, ""), "{arguments:?}");
            assert!(out.stderr.contains(words), "{}", out.stderr);
        };
        says(&["-o", "a.gif"], "`assur draw a.mech animation -o a.gif`");
        says(&["velocities", "--format", "apng"], "`assur draw a.mech animation --format apng`");
        says(&["animation", "scheme", "-o", "a.gif"], "cannot show the picture `scheme`");
        says(&["animation", "--arrows", "velocities", "-o", "a.gif"], "`--arrows` changes no picture");
        says(&["animation", "--frames", "301", "-o", "a.gif"], "write `--frames 300` or less");
        assert_eq!(folder.names(), ["a.mech"]);
    }
}
