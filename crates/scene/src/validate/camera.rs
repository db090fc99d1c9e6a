//! The camera: that it sees a picture at all.

use super::allowed::{COMPONENT, COORDINATE, FIELD_OF_VIEW};
use super::check::{direction, list, one, triple};
use crate::direction::{parallel, unit};
use crate::error::{Fault, Trail, number};
use crate::{Camera, Image};

pub(super) fn camera(trail: Trail<'_>, camera: &Camera, image: &Image) -> Result<(), Fault> {
    let &Camera { position, look_at, up, fov } = camera;
    triple(trail.key("position"), position, &COORDINATE)?;
    triple(trail.key("look_at"), look_at, &COORDINATE)?;
    triple(trail.key("up"), up, &COMPONENT)?;
    one(trail.key("fov"), fov, &FIELD_OF_VIEW)?;

    // The difference of two f64 is zero only where they are equal.
    let view = [0, 1, 2].map(|axis| look_at[axis] - position[axis]);
    let Some(view) = unit(view) else {
        return Err(Fault::new(
            trail.key("look_at"),
            list(look_at),
            "a point apart from the camera's `position`",
        ));
    };
    let up_unit = direction(trail.key("up"), up)?;
    if parallel(view, up_unit) {
        let allowed =
            "a direction that is not parallel to the view, which goes from `position` to `look_at`";
        return Err(Fault::new(trail.key("up"), list(up), allowed));
    }
    extent(trail.key("fov"), fov, image)
}

/// Checks that half the picture's height and width at distance 1 are normal numbers of f32; else
/// the eye rays could not be told apart.
fn extent(trail: Trail<'_>, fov: f64, image: &Image) -> Result<(), Fault> {
    let half_height = (fov.to_radians() / 2.0).tan();
    let half_width = half_height * (f64::from(image.width) / f64::from(image.height));
    let normal = f64::from(f32::MIN_POSITIVE)..=f64::from(f32::MAX);
    if normal.contains(&half_height) && normal.contains(&half_width) {
        return Ok(());
    }
    let allowed = format!(
        "degrees for which f32 can hold tan(fov/2) and tan(fov/2)·width/height, from 1.2e-38 on; here they are {} and {}",
        number(half_height),
        number(half_width)
    );
    Err(Fault::new(trail, number(fov), allowed))
}
