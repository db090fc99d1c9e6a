//! One line of the history.

use std::fmt;
use std::str::FromStr;

/// What one recording found on one scene.
///
/// Texts hold no comma, quote or line break: see [`plain`]. The speed-ups are those of the
/// engine over the recursion, formed from the rounds' minima and from their medians.
#[derive(Clone, Debug, PartialEq)]
pub struct Entry {
    /// When the recording began: UTC, ISO 8601, to the second.
    pub date: String,
    /// The short commit, `+` behind it where tracked files had changed, or `unknown`.
    pub commit: String,
    /// The processor's model as the system names it.
    pub processor: String,
    /// The engine's instruction set.
    pub isa: String,
    /// Threads of the engine.
    pub threads: usize,
    /// The scene's name.
    pub scene: String,
    /// Columns, `x`, rows.
    pub size: String,
    /// Reflections followed.
    pub depth: u32,
    /// Rays of all kinds in one picture.
    pub rays: u64,
    /// Rounds measured.
    pub rounds: usize,
    /// Speed-up over the recursion on 1 thread, from minima.
    pub over_one_min: f64,
    /// Speed-up over the recursion on 1 thread, from medians.
    pub over_one_median: f64,
    /// Speed-up over the recursion on the same number of threads, from minima.
    pub over_same_min: f64,
    /// Speed-up over the recursion on the same number of threads, from medians.
    pub over_same_median: f64,
    /// Interquartile range of the rounds' own speed-ups over the same number of threads,
    /// divided by their median.
    pub over_same_spread: f64,
    /// The engine's least time, in nanoseconds a ray.
    pub ns_per_ray_min: f64,
    /// The engine's median time, in nanoseconds a ray.
    pub ns_per_ray_median: f64,
}

/// The columns, in the order of [`Entry`]'s fields.
pub const COLUMNS: [&str; 17] = [
    "date",
    "commit",
    "processor",
    "isa",
    "threads",
    "scene",
    "size",
    "depth",
    "rays",
    "rounds",
    "over_one_min",
    "over_one_median",
    "over_same_min",
    "over_same_median",
    "over_same_spread",
    "ns_per_ray_min",
    "ns_per_ray_median",
];

/// The text with what a field must not hold turned into spaces, trimmed; never empty.
#[must_use]
pub fn plain(text: &str) -> String {
    let special = |c: char| c == ',' || c == '"' || c.is_control();
    let plain = text.replace(special, " ").trim().to_owned();
    if plain.is_empty() { "unknown".to_owned() } else { plain }
}

impl Entry {
    /// The line of a file, without its end. Ratios and times have four decimals.
    #[must_use]
    pub fn to_line(&self) -> String {
        let texts = [&self.date, &self.commit, &self.processor, &self.isa].map(|t| plain(t));
        let numbers = [
            self.over_one_min,
            self.over_one_median,
            self.over_same_min,
            self.over_same_median,
            self.over_same_spread,
            self.ns_per_ray_min,
            self.ns_per_ray_median,
        ];
        let mut fields = texts.to_vec();
        fields.push(self.threads.to_string());
        fields.extend([plain(&self.scene), plain(&self.size)]);
        fields.extend([self.depth.to_string(), self.rays.to_string(), self.rounds.to_string()]);
        fields.extend(numbers.map(|x| format!("{x:.4}")));
        fields.join(",")
    }

    /// The entry of a line.
    ///
    /// # Errors
    /// Which column holds what it should not, or how many fields there are.
    pub fn from_line(line: &str) -> Result<Self, String> {
        let fields: Vec<&str> = line.split(',').collect();
        if fields.len() != COLUMNS.len() {
            return Err(format!("{} fields instead of {}", fields.len(), COLUMNS.len()));
        }
        let text = |i: usize| match fields[i] {
            "" => Err(format!("{} is empty", COLUMNS[i])),
            text => Ok(text.to_owned()),
        };
        let number = |i: usize, zero: bool| {
            let found: f64 = parsed(&fields, i)?;
            let allowed = found.is_finite() && (found > 0.0 || zero && found == 0.0);
            let range = if zero { "0 or more" } else { "above 0" };
            allowed
                .then_some(found)
                .ok_or_else(|| format!("{} is {found}: allowed is a number {range}", COLUMNS[i]))
        };
        Ok(Self {
            date: text(0)?,
            commit: text(1)?,
            processor: text(2)?,
            isa: text(3)?,
            threads: parsed(&fields, 4)?,
            scene: text(5)?,
            size: text(6)?,
            depth: parsed(&fields, 7)?,
            rays: parsed(&fields, 8)?,
            rounds: parsed(&fields, 9)?,
            over_one_min: number(10, false)?,
            over_one_median: number(11, false)?,
            over_same_min: number(12, false)?,
            over_same_median: number(13, false)?,
            over_same_spread: number(14, true)?,
            ns_per_ray_min: number(15, false)?,
            ns_per_ray_median: number(16, false)?,
        })
    }

    /// Whether the two were measured on the same work: the same scene, size, depth and
    /// threads, and as many rays, or the scene itself has changed between them.
    #[must_use]
    pub fn same_work(&self, other: &Self) -> bool {
        (&self.scene, &self.size, self.depth, self.threads, self.rays)
            == (&other.scene, &other.size, other.depth, other.threads, other.rays)
    }

    /// Whether the two were measured on the same kind of processor.
    #[must_use]
    pub fn same_machine(&self, other: &Self) -> bool {
        (&self.processor, &self.isa) == (&other.processor, &other.isa)
    }
}

fn parsed<T: FromStr>(fields: &[&str], i: usize) -> Result<T, String>
where
    T::Err: fmt::Display,
{
    let (name, found) = (COLUMNS[i], fields[i]);
    found.parse().map_err(|error| format!("{name} is {found:?}: {error}"))
}
