//! The two layouts of the same entries.

use super::entries::{Entries, Section};
use super::text::{key, text};

/// Writes TOML: a line for each key, a blank line between tables.
pub(super) fn toml(sections: &[Section]) -> String {
    let mut toml = String::new();
    let mut table = |header: String, entries: &Entries| {
        if !toml.is_empty() {
            toml.push('\n');
        }
        toml += &header;
        toml.push('\n');
        for (key, value) in entries {
            toml.extend([*key, " = ", value.as_str(), "\n"]);
        }
    };
    for section in sections {
        match section {
            Section::Table(name, entries) => table(format!("[{name}]"), entries),
            Section::Named(parent, tables) => {
                for (name, entries) in tables {
                    table(format!("[{parent}.{}]", key(name)), entries);
                }
            }
            Section::Array(name, tables) => {
                for entries in tables {
                    table(format!("[[{name}]]"), entries);
                }
            }
        }
    }
    toml
}

/// Writes JSON: a line for each table.
pub(super) fn json(sections: &[Section]) -> String {
    let sections = sections.iter().map(|section| match section {
        Section::Table(name, entries) => format!("  \"{name}\": {}", object(entries)),
        Section::Named(parent, tables) => {
            let line =
                |(name, entries): &(String, _)| format!("    {}: {}", text(name), object(entries));
            format!("  \"{parent}\": {{\n{}\n  }}", separated(tables.iter().map(line), ",\n"))
        }
        Section::Array(name, tables) => {
            let line = |entries| format!("    {}", object(entries));
            format!("  \"{name}\": [\n{}\n  ]", separated(tables.iter().map(line), ",\n"))
        }
    });
    format!("{{\n{}\n}}\n", separated(sections, ",\n"))
}

fn object(entries: &Entries) -> String {
    let pairs = entries.iter().map(|(key, value)| format!("\"{key}\": {value}"));
    format!("{{{}}}", separated(pairs, ", "))
}

fn separated(parts: impl Iterator<Item = String>, separator: &str) -> String {
    parts.collect::<Vec<_>>().join(separator)
}
