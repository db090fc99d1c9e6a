//! Memory that reading a scene takes: counted, and refused before it is taken.

use crate::error::Problem;

/// Bytes that reading may take, beside the text itself.
///
/// Lasting memory is counted as it grows. Passing memory, such as the parsed values of a part of
/// the text, is checked beforehand against what is left and against what the system grants: parsers
/// cannot report that memory was refused, they end the program.
pub(super) struct Memory {
    limit: u64,
    left: u64,
}

/// Bytes that the system must grant on top of a request, for small things that are not counted.
const SLACK: u64 = 1 << 18;

impl Memory {
    pub(super) fn new(limit: u64) -> Self {
        Self { limit, left: limit }
    }

    /// Counts bytes that are kept.
    ///
    /// # Errors
    /// More than are left.
    pub(super) fn take(&mut self, bytes: u64) -> Result<(), Problem> {
        self.left = self.left.checked_sub(bytes).ok_or(Problem::Limit(self.limit))?;
        Ok(())
    }

    /// Checks bytes that are needed for a moment.
    ///
    /// # Errors
    /// More than are left, or than the system grants.
    pub(super) fn for_a_moment(&self, bytes: u64) -> Result<(), Problem> {
        if bytes > self.left {
            return Err(Problem::Limit(self.limit));
        }
        let asked = usize::try_from(bytes.saturating_add(SLACK)).unwrap_or(usize::MAX);
        // The black box keeps the compiler from leaving out memory that is given back at once.
        let probe = std::hint::black_box(Vec::<u8>::new()).try_reserve_exact(asked);
        probe.map_err(|_| Problem::NotGranted(bytes))
    }

    /// Adds an entry to a list and counts the list's bytes. While a list grows, the old and the new
    /// one are in memory together.
    ///
    /// # Errors
    /// No room within the limit, or in the system's memory.
    pub(super) fn push<T>(&mut self, list: &mut Vec<T>, entry: T) -> Result<(), Problem> {
        if list.len() == list.capacity() {
            self.grow(list)?;
        }
        list.push(entry);
        Ok(())
    }

    #[cold]
    fn grow<T>(&mut self, list: &mut Vec<T>) -> Result<(), Problem> {
        let size = size_of::<T>() as u64;
        let old = list.capacity() as u64;
        // Grows by a half or, where that is too much, by a sixteenth.
        let fits = |more: &u64| (old + more).saturating_mul(size) <= self.left;
        let more = [(old / 2).max(64), (old / 16).max(64)].into_iter().find(fits);
        let more = more.ok_or(Problem::Limit(self.limit))?;
        let refused = |_| Problem::NotGranted((old + more) * size);
        let entries = usize::try_from(more).unwrap_or(usize::MAX);
        list.try_reserve_exact(entries).map_err(refused)?;
        self.for_a_moment(0)?;
        self.take(more * size)
    }
}
