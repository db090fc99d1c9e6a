//! Bytes of a picture that is read: a file or stdin, forwards and only once, so that a pipe is
//! as good as a file.

use std::fs::File;
use std::io::{self, BufRead, BufReader, Cursor, ErrorKind, Read, Seek, SeekFrom};
use std::path::Path;

use crate::input::is_stream;

/// A picture's bytes.
pub(super) struct Source {
    from: BufReader<Box<dyn Read>>,
    /// The first bytes, two where there are as many. They are still to be read.
    magic: Vec<u8>,
    taken: u64,
    /// Bytes of a regular file in all; nobody knows them of a pipe or a device.
    length: Option<u64>,
}

impl Source {
    /// Opens a file, or stdin for `-`, and looks at its first bytes.
    pub(super) fn open(path: &Path) -> io::Result<Self> {
        let (mut from, length): (Box<dyn Read>, _) = if is_stream(path) {
            (Box::new(io::stdin().lock()), None)
        } else {
            let file = File::open(path)?;
            let found = file.metadata()?;
            // Files of /proc are regular and have no length.
            let length = Some(found.len()).filter(|&length| found.is_file() && length > 0);
            (Box::new(file), length)
        };
        let mut magic = Vec::new();
        from.by_ref().take(2).read_to_end(&mut magic)?;
        let all = Cursor::new(magic.clone()).chain(from);
        Ok(Self { from: BufReader::new(Box::new(all)), magic, taken: 0, length })
    }

    /// The first bytes, two where there are as many.
    pub(super) fn magic(&self) -> &[u8] {
        &self.magic
    }

    /// Bytes that have been read.
    pub(super) fn taken(&self) -> u64 {
        self.taken
    }

    /// Bytes that are still to come, where that is known.
    pub(super) fn left(&self) -> Option<u64> {
        self.length.and_then(|length| length.checked_sub(self.taken))
    }

    /// The next byte; `None` at the end.
    pub(super) fn byte(&mut self) -> io::Result<Option<u8>> {
        loop {
            match self.fill_buf() {
                Ok(bytes) => {
                    let byte = bytes.first().copied();
                    self.consume(usize::from(byte.is_some()));
                    return Ok(byte);
                }
                Err(error) if error.kind() == ErrorKind::Interrupted => {}
                Err(error) => return Err(error),
            }
        }
    }

    /// Reads until `to` is full or the bytes end; how many there were.
    pub(super) fn fill(&mut self, to: &mut [u8]) -> io::Result<usize> {
        let mut filled = 0;
        while filled < to.len() {
            match self.read(&mut to[filled..]) {
                Ok(0) => break,
                Ok(more) => filled += more,
                Err(error) if error.kind() == ErrorKind::Interrupted => {}
                Err(error) => return Err(error),
            }
        }
        Ok(filled)
    }
}

impl Read for Source {
    fn read(&mut self, to: &mut [u8]) -> io::Result<usize> {
        let read = self.from.read(to)?;
        self.taken += read as u64;
        Ok(read)
    }
}

impl BufRead for Source {
    fn fill_buf(&mut self) -> io::Result<&[u8]> {
        self.from.fill_buf()
    }

    fn consume(&mut self, bytes: usize) {
        self.taken += bytes as u64;
        self.from.consume(bytes);
    }
}

/// The PNG decoder asks for this and never does it.
impl Seek for Source {
    fn seek(&mut self, _: SeekFrom) -> io::Result<u64> {
        Err(ErrorKind::Unsupported.into())
    }
}
