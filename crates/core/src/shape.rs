//! What rays meet: one file a form, and one that tells the forms apart.
//!
//! A form's constants reach its formulas as lanes, today one primitive in all of them. A new form
//! is a file here, and an arm in each of the two functions of `dispatch`.

mod dispatch;
mod foot;
mod form;
mod general_sphere;
mod horizon;
mod robust_sphere;
#[cfg(test)]
mod tests;
mod textbook;

pub(crate) use dispatch::{dispatch, facts};
pub(crate) use foot::Foot;
pub(crate) use form::{Blocker, Kind, Shape, ShapeVisitor, View};
pub(crate) use horizon::Horizon;
