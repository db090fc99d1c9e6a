//! Text to scene.
