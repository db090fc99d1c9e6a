//! Scene to f32 constants.
