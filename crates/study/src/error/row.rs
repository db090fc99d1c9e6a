//! One setting of one knob with one formula.

use catoptric_report::{Cell, Column, Table};

use crate::formula::Formula;
use crate::metrics::Metrics;
use crate::timing::Times;

/// What is varied.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Sweep {
    /// `max_depth`, without a weight cut.
    Depth,
    /// `min_weight`, at full depth.
    Weight,
    /// Samples a side, at full depth, on a smaller picture.
    Samples,
}

pub(super) struct Row {
    pub(super) sweep: Sweep,
    /// `max_depth`, `min_weight` or samples a side.
    pub(super) setting: f64,
    pub(super) formula: Formula,
    pub(super) times: Times,
    /// Against truth; `None` where a path is deeper than the renderer's stack.
    pub(super) error: Option<Metrics>,
    /// What the error is made of. Not of samples, where every pixel has many paths.
    pub(super) parts: Option<Parts>,
}

/// The parts of an error.
#[derive(Clone, Copy)]
pub(super) struct Parts {
    /// Truth at this setting against truth, over all pixels: largest difference.
    pub(super) truncation: f64,
    /// What that is at most, known before anything is traced.
    pub(super) bound_truncation: f64,
    /// Pixels whose path is not truth's: another primitive, or another light in view.
    pub(super) flipped: usize,
    /// All other pixels; `None` where there are none.
    pub(super) unflipped: Option<Unflipped>,
}

/// Over the pixels whose path is truth's.
#[derive(Clone, Copy)]
pub(super) struct Unflipped {
    /// Against truth.
    pub(super) error: Metrics,
    /// Against truth at the same setting: what formula and precision leave, without what the
    /// setting leaves out.
    pub(super) floor: Metrics,
}

impl Sweep {
    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Depth => "depth",
            Self::Weight => "weight",
            Self::Samples => "samples",
        }
    }
}

impl Parts {
    /// Bounds the error of unflipped pixels: a picture is no further from truth than from truth at
    /// its setting, and that from truth.
    pub(super) fn bound(&self) -> Option<f64> {
        Some(self.bound_truncation + self.unflipped?.floor.max)
    }
}

pub(super) const COLUMNS: &[Column] = &[
    Column { key: "scene", heading: "scene", meaning: "The scene's name." },
    Column { key: "sweep", heading: "knob", meaning: "What is varied: depth, weight or samples." },
    Column { key: "setting", heading: "setting", meaning: "max_depth, min_weight, or N of N x N." },
    Column { key: "formula", heading: "formula", meaning: "Formulas and precision." },
    Column { key: "min_ms", heading: "min ms", meaning: "Least time of tracing alone, ms." },
    Column { key: "median_ms", heading: "median ms", meaning: "Median time of tracing alone, ms." },
    Column { key: "rmse", heading: "RMSE", meaning: "Over all channels, linear, against truth." },
    Column { key: "max", heading: "max", meaning: "Largest error of a channel, linear." },
    Column { key: "p999", heading: "99.9 %", meaning: "99.9th percentile of a pixel's error." },
    Column {
        key: "off",
        heading: "levels off",
        meaning: "Pixels whose 8-bit levels differ, by the scene's transfer.",
    },
    Column {
        key: "off_by_more",
        heading: "off > 1",
        meaning: "Pixels with levels that differ by more than one.",
    },
    Column {
        key: "not_finite",
        heading: "not finite",
        meaning: "Values of the picture that are NaN or infinite, which the errors leave out.",
    },
    Column {
        key: "truncation",
        heading: "truncation",
        meaning: "Largest error that the setting makes in exact arithmetic, of any pixel.",
    },
    Column {
        key: "bound_truncation",
        heading: "its bound",
        meaning: "A-priori bound of the truncation, known before anything is traced.",
    },
    Column {
        key: "flipped",
        heading: "flipped",
        meaning: "Pixels whose path is not truth's: another primitive, or another lamp in view.",
    },
    Column {
        key: "floor",
        heading: "floor",
        meaning: "Largest error against truth at the same setting, without flipped pixels: what \
                  formula and precision leave.",
    },
    Column {
        key: "max_unflipped",
        heading: "max, unflipped",
        meaning: "Largest error against truth, without flipped pixels: to be within the bound.",
    },
    Column {
        key: "bound",
        heading: "bound",
        meaning: "The truncation's bound plus the floor; none where every pixel is flipped.",
    },
    Column {
        key: "front",
        heading: "front",
        meaning: "Whether nothing cheaper has less RMSE; not asked of samples, which are another \
                  picture's.",
    },
    Column {
        key: "runs",
        heading: "runs",
        meaning: "How often it was timed: once when it was made, then in turn with all.",
    },
    Column { key: "note", heading: "note", meaning: "What failed." },
];

impl Row {
    /// The error, unless the row is a failure.
    pub(super) fn sound(&self) -> Option<&Metrics> {
        self.error.as_ref().filter(|error| error.not_finite == 0)
    }

    /// Samples are measured on another picture.
    pub(super) fn is_swept(&self) -> bool {
        self.sweep != Sweep::Samples
    }

    /// The knob, its setting and the formula.
    pub(super) fn name(&self) -> String {
        let (knob, formula) = (self.sweep.name(), self.formula.name());
        format!("{knob} {} with {formula}", Cell::from(self.setting))
    }

    fn note(&self) -> Cell {
        match self.error {
            None => "a path is deeper than the stack".into(),
            Some(error) if error.not_finite > 0 => "values are not finite".into(),
            Some(_) if self.times.runs() == 0 => "interrupted".into(),
            Some(_) => Cell::Nothing,
        }
    }

    pub(super) fn push(&self, table: &mut Table, scene: &str, on_front: Option<bool>) {
        let setting = match self.sweep {
            Sweep::Weight => self.setting.into(),
            Sweep::Depth | Sweep::Samples => (self.setting as u64).into(),
        };
        let unflipped = self.parts.and_then(|parts| parts.unflipped);
        table.push([
            scene.into(),
            self.sweep.name().into(),
            setting,
            self.formula.name().into(),
            self.times.min_ms().into(),
            self.times.median_ms().into(),
            self.error.map(|error| error.rmse).into(),
            self.error.map(|error| error.max).into(),
            self.error.map(|error| error.p999).into(),
            self.error.map(|error| error.off).into(),
            self.error.map(|error| error.off_by_more).into(),
            self.error.map(|error| error.not_finite).into(),
            self.parts.map(|parts| parts.truncation).into(),
            self.parts.map(|parts| parts.bound_truncation).into(),
            self.parts.map(|parts| parts.flipped).into(),
            unflipped.map(|unflipped| unflipped.floor.max).into(),
            unflipped.map(|unflipped| unflipped.error.max).into(),
            self.parts.and_then(|parts| parts.bound()).into(),
            on_front.into(),
            self.times.runs().into(),
            self.note(),
        ]);
    }
}
