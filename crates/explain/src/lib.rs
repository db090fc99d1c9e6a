//! Explanations: the account of a scene, and the life of one eye ray.
//!
//! [`Account`] says what a scene has and needs, how deep its rays go, and which `max_depth` is
//! enough. [`Life`] is every call, hit, fold and return of one pixel's ray, as the recursion has
//! it beside what the engine's stack does. Both serialise as JSON documents and are written in
//! words; [`page()`] makes a life one page for a browser.
//!
//! ```text
//! account.rs    what a scene has and needs
//!   account/      its features, the engine's plan for it, its words
//! life.rs       one ray, as two rungs of the ladder have it
//!   life/         its words, its JSON document
//! page.rs       a life as a page
//!   page/         its steps, its look, its script
//! drawing.rs    the path in a view of the scene
//!   drawing/      the path, the view, and what is drawn of them
//! pixel.rs      whose ray it is
//! words.rs      words that every explanation uses
//! error.rs      why something is not explained
//! ```

mod account;
mod drawing;
mod error;
mod life;
mod page;
mod pixel;
mod words;

pub use account::Account;
pub use error::ExplainError;
pub use life::Life;
pub use page::{Picture, page};
pub use pixel::Pixel;
