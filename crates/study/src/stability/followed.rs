//! The measures that follow paths, one scene after the other: how many agree with truth's, what
//! errors are due to, what the input's rounding costs, and how far each pixel can be known.

use catoptric_reference::truth::{Precision, TooDeep, Truth};
use catoptric_report::{Picture, Plot, Report};
use catoptric_scene::family::{Kissing, Room};
use catoptric_scene::{Scene, View};

use super::agreement::{self, Agreement, COMPARED};
use super::causes::{self, Causes};
use super::condition::{self, AMPLIFIED, Foretold, MOVED};
use super::input::{self, InputRounding};
use crate::Watch;
use crate::formula::Formula;
use crate::subject::Subject;

/// What was found of all scenes.
#[derive(Default)]
struct Followed {
    agreements: Vec<(String, Agreement)>,
    causes: Vec<(String, Causes)>,
    inputs: Vec<(String, InputRounding)>,
    foretold: Vec<(String, &'static str, Foretold)>,
    plots: Vec<Plot>,
    maps: Vec<Picture>,
    notes: Vec<String>,
}

/// The suite's own scenes: the workshop's with a mirroring ground, kissing spheres, and a closed
/// room, each in a size that truth's seven pictures can be had in.
pub(crate) fn own_subjects() -> Vec<Subject> {
    let workshop = super::cases::scenes::workshop(320, 240, 8, 0.3);
    let mut kissing = Kissing::default().draft().expect("in range");
    (kissing.image.width, kissing.image.height) = (320, 240);
    kissing.render.max_depth = 32;
    // Mirrors that keep what they show: else no error of a late reflection is ever seen.
    let mut room = Room { balls: 3, reflect: 0.97, ..Room::default() }.draft().expect("in range");
    (room.image.width, room.image.height) = (80, 60);
    room.render.max_depth = 64;
    [("workshop", workshop), ("kissing", kissing), ("closed-room", room)]
        .map(|(name, draft)| Subject {
            name: name.to_owned(),
            scene: Scene::new(draft).expect("families are valid"),
        })
        .into()
}

/// Measures the scenes and adds what was found.
pub(crate) fn add(report: &mut Report, subjects: &[Subject], watch: &dyn Watch) {
    let mut followed = Followed::default();
    for subject in subjects {
        if watch.stopped() {
            break;
        }
        watch.say(&format!("{}: following paths", subject.name));
        if let Err(error) = followed.follow(subject) {
            followed.notes.push(format!("{}: not followed: {error}", subject.name));
        }
    }
    // How paths part from truth's, and what that costs.
    report.heading("Paths");
    report.text(
        "A picture is as right as its paths. Where a path meets what truth's meets, its error is \
         rounding, amplified by the mirrors on the way; where it parts, at a silhouette or the \
         edge of a shadow, it shows something else, and one such pixel owns the largest error.",
    );
    for note in followed.notes {
        report.text(note);
    }
    report.table(agreement::table(&followed.agreements));
    for plot in followed.plots {
        report.plot(plot);
    }
    report.table(causes::table(&followed.causes));
    report.table(input::table(&followed.inputs));
    // How well the condition map foretells errors.
    report.heading("What each pixel can be known to");
    report.text(
        "The condition map shows how far truth's own colour moves when its eye ray does by one \
         rounding of f32: amplified is the derivative alone, times u; moved is the largest change \
         within 4 u, with the edges within reach. It is made without trying f32, and foretells \
         where f32 is wrong: a pixel counts as foretold if its error is at most 4 times the map.",
    );
    report.table(condition::table(&followed.foretold));
    report.pictures(followed.maps);
}

impl Followed {
    fn follow(&mut self, subject: &Subject) -> Result<(), TooDeep> {
        let Subject { name, scene } = subject;
        let view = View::whole(scene);
        let truth = Truth::new(scene, Precision::DoubleDouble).render(&view)?.pixels;

        let agreement = agreement::agreement(scene, &view, &COMPARED);
        self.plots.push(agreement::plot(name, &agreement));
        self.agreements.push((name.clone(), agreement));

        let map = condition::condition(scene, &view)?;
        let zoom = if map.width <= 160 { 3 } else { 2 };
        self.maps.extend(condition::pictures(name, &map, zoom));

        for formula in Formula::F32 {
            let scene = formula.scene(scene);
            let Ok(found) = formula.picture(&scene) else { continue };
            let named = format!("{name}, {}", formula.name());
            self.causes.push((named.clone(), causes::causes(&scene, &view, &found, &truth)));
            for (name, values) in [(AMPLIFIED, &map.amplified), (MOVED, &map.moved)] {
                let foretold = condition::foretold(values, &found, &truth);
                self.foretold.push((named.clone(), name, foretold));
            }
            if formula == Formula::TextbookF32 {
                continue;
            }
            // Two numbers that only f64 tells apart make no scene in f32, which is no error.
            if let Ok(input) = input::input_rounding(&scene, &view, &found, &truth) {
                self.inputs.push((named, input));
            }
        }
        Ok(())
    }
}
