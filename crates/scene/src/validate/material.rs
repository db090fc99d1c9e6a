//! Materials: their factors, and that the light they send back stays within f32.

use super::allowed::{AMOUNT, LIGHT, MIRROR, SPECULAR};
use super::check::{list, one, triple};
use crate::error::{Fault, Trail, number};
use crate::{Draft, Material};

/// The light of a scene, as the brightest point of a material can meet it: per channel,
/// the ambient light and all lights together, each straight above and all visible.
pub(super) struct Brightest {
    ambient: [f64; 3],
    lights: [f64; 3],
}

impl Brightest {
    /// The brightest light of a scene whose lights and ambient were found in their ranges.
    pub(super) fn of(draft: &Draft) -> Self {
        let mut lights = [0.0; 3];
        for light in &draft.lights {
            for (sum, intensity) in lights.iter_mut().zip(light.intensity) {
                *sum += intensity;
            }
        }
        Self { ambient: draft.render.ambient, lights }
    }
}

pub(super) fn material(
    trail: Trail<'_>,
    material: &Material,
    brightest: &Brightest,
) -> Result<(), Fault> {
    // Each factor alone is in its range. The mirror's may be stated by `specular`.
    let &Material { color, diffuse, specular, shininess, reflect } = material;
    triple(trail.key("color"), color, &AMOUNT)?;
    one(trail.key("diffuse"), diffuse, &AMOUNT)?;
    one(trail.key("specular"), specular, &SPECULAR)?;
    one(trail.key("shininess"), shininess, &AMOUNT)?;
    match reflect {
        Some(reflect) => one(trail.key("reflect"), reflect, &MIRROR)?,
        None if MIRROR.holds(specular) => {}
        None => {
            return Err(Fault::new(trail.key("specular"), number(specular), SPECULAR.text));
        }
    }
    // The factors together send back no more light than sums in f32 can hold.
    for channel in 0..3 {
        let colour = color[channel];
        let factor = diffuse * colour + specular;
        let back = brightest.ambient[channel] * colour + brightest.lights[channel] * factor;
        // The factor is formed before a light multiplies it, so it is bounded also where all lights
        // are weak. With these bounds 2^32 reflections and 256 x 256 samples stay far below the
        // largest f32.
        if !LIGHT.holds(factor) || !LIGHT.holds(back) {
            let allowed = format!(
                "a material that sends back at most {}, so that no sum over reflections and samples overflows f32; in channel {channel} diffuse·color + specular is {}, and ambient·color + (all intensities)·(diffuse·color + specular) is {}",
                number(LIGHT.most()),
                number(factor),
                number(back)
            );
            return Err(Fault::new(trail.key("color"), list(color), allowed));
        }
    }
    Ok(())
}
