//! Short sums of files, by which they are known again.

use serde::{Deserialize, Serialize};

/// What a file holds, in short. The document keeps it of every other file of its report, so that
/// a later report removes only what is still as it was written.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Sum {
    /// The file's name within the report's folder.
    pub file: String,
    /// How many bytes it has.
    pub bytes: u64,
    /// FNV-1a sum of the file's bytes, 64 bits, in hexadecimal digits.
    pub fnv1a_64: String,
}

impl Sum {
    /// The sum of a file.
    #[must_use]
    pub fn of(name: &str, bytes: &[u8]) -> Self {
        let step =
            |sum: u64, byte: &u8| (sum ^ u64::from(*byte)).wrapping_mul(0x0000_0100_0000_01b3);
        let sum = bytes.iter().fold(0xcbf2_9ce4_8422_2325, step);
        let (file, bytes) = (name.to_owned(), bytes.len() as u64);
        Self { file, bytes, fnv1a_64: format!("{sum:016x}") }
    }
}
