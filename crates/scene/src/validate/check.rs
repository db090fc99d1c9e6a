//! Single values in their ranges.

use super::allowed::{Allowed, COMPONENT};
use crate::direction::unit;
use crate::error::{Fault, Trail, number};

/// Checks one number against its range.
pub(super) fn one(trail: Trail<'_>, x: f64, allowed: &Allowed) -> Result<(), Fault> {
    if allowed.holds(x) { Ok(()) } else { Err(Fault::new(trail, number(x), allowed.text)) }
}

/// Checks three numbers against one range; the fault names the first that is outside.
pub(super) fn triple(trail: Trail<'_>, v: [f64; 3], allowed: &Allowed) -> Result<(), Fault> {
    v.into_iter().enumerate().try_for_each(|(axis, x)| one(trail.index(axis), x, allowed))
}

/// Checks a direction, of any length but zero; gives its unit vector.
pub(super) fn direction(trail: Trail<'_>, v: [f64; 3]) -> Result<[f64; 3], Fault> {
    triple(trail, v, &COMPONENT)?;
    unit(v).ok_or_else(|| Fault::new(trail, list(v), "a direction that is not zero"))
}

/// Three numbers as messages show them.
pub(super) fn list(v: [f64; 3]) -> String {
    format!("[{}]", v.map(number).join(", "))
}
