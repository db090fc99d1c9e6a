//! Scene to text.
