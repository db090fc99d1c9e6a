//! What is wrong with a command line, without what a terminal would obey.

use clap::error::{ContextKind, ContextValue};

/// Columns of what is shown of one argument.
const ARGUMENT: usize = 160;

/// The same error, its arguments shown as all text of others is.
///
/// The parser quotes them as they are. What it writes itself keeps its colours, but in a
/// suggestion that quotes an argument.
pub(crate) fn shown(mut error: clap::Error) -> clap::Error {
    let quoted: Vec<_> = error
        .context()
        .filter_map(|(kind, value)| Some((kind, shown_value(kind, value)?)))
        .collect();
    for (kind, value) in quoted {
        error.insert(kind, value);
    }
    error
}

/// What a part of the message becomes; `None` for a part that quotes nothing.
fn shown_value(kind: ContextKind, value: &ContextValue) -> Option<ContextValue> {
    let text = |text: &str| catoptric_scene::shown(text, ARGUMENT);
    match value {
        ContextValue::String(one) => Some(ContextValue::String(text(one))),
        ContextValue::Strings(all) => {
            Some(ContextValue::Strings(all.iter().map(|one| text(one)).collect()))
        }
        // The usage has colours of its own, and names options alone.
        _ if kind == ContextKind::Usage => None,
        ContextValue::StyledStr(one) => {
            Some(ContextValue::StyledStr(text(&one.to_string()).into()))
        }
        ContextValue::StyledStrs(all) => {
            let all = all.iter().map(|one| text(&one.to_string()).into());
            Some(ContextValue::StyledStrs(all.collect()))
        }
        _ => None,
    }
}
