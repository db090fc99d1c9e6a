//! What is left where nothing is left out.

use catoptric_report::{Column, Table};
use catoptric_scene::Scene;

use crate::Watch;
use crate::formula::Formula;
use crate::metrics::Metrics;
use crate::stability::backward::{Backward, Judge};

/// What a formula leaves at full depth.
pub(super) struct Floor {
    formula: Formula,
    /// `None` where a path is deeper than a stack.
    backward: Option<Backward>,
}

const COLUMNS: &[Column] = &[
    Column { key: "scene", heading: "scene", meaning: "The scene's name." },
    Column { key: "formula", heading: "formula", meaning: "Formulas and precision." },
    Column { key: "rmse", heading: "RMSE", meaning: "Over all channels, linear, against truth." },
    Column { key: "max", heading: "max", meaning: "Largest error of a channel, linear." },
    Column {
        key: "off_by_more",
        heading: "off > 1",
        meaning: "Pixels with 8-bit levels, by the scene's transfer, that differ by more than one.",
    },
    Column {
        key: "backward_eye",
        heading: "backward, eye",
        meaning: "Largest error over what truth moves by when eye rays do by 1 to 4 u.",
    },
    Column {
        key: "backward_input",
        heading: "backward, input",
        meaning: "The same when the whole scene is moved by that too.",
    },
];

/// The table of floors by scene and formula.
pub(super) fn table() -> Table {
    Table::new(
        "floors",
        COLUMNS,
        "What formulas and precision leave at full depth. A backward ratio up to 4 says that the \
         picture is the true one of a scene nearly as stated: no arithmetic of that precision \
         can be asked for more.",
    )
}

impl Floor {
    /// What failed, in words.
    pub(super) fn failure(&self) -> Option<String> {
        let what = match self.backward {
            None => "a path is deeper than a stack".to_owned(),
            Some(Backward { raw, .. }) if raw.not_finite > 0 => {
                format!("{} values are not finite, and left out", raw.not_finite)
            }
            Some(_) => return None,
        };
        Some(format!("{}: {what}", self.formula.name()))
    }

    /// Adds it as a row.
    pub(super) fn push(&self, table: &mut Table, scene: &str) {
        let raw: Option<Metrics> = self.backward.map(|backward| backward.raw);
        table.push([
            scene.into(),
            self.formula.name().into(),
            raw.map(|raw| raw.rmse).into(),
            raw.map(|raw| raw.max).into(),
            raw.map(|raw| raw.off_by_more).into(),
            self.backward.map(|backward| backward.by_eye).into(),
            self.backward.map(|backward| backward.by_input).into(),
        ]);
    }
}

/// Judges every formula's picture of a scene at full depth; fewer where it is stopped.
pub(super) fn measure(scene: &Scene, watch: &dyn Watch) -> Vec<Floor> {
    let judge = Judge::new(scene).ok();
    let mut floors = Vec::new();
    for formula in Formula::ALL {
        if watch.stopped() {
            break;
        }
        let picture = formula.picture(scene).ok();
        let judged = judge.as_ref().zip(picture);
        let backward = judged.and_then(|(judge, picture)| judge.judge(&picture).ok());
        floors.push(Floor { formula, backward });
    }
    floors
}
