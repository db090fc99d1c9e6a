//! The horizon of a large sphere, which it casts shadows over.

use glam::DVec3;

/// A large sphere, as far as shadows ask: it stands before a light only where the height over it
/// falls first.
#[derive(Clone, Copy)]
pub(crate) struct Horizon {
    pub(super) scaled_center: DVec3,
    pub(super) curvature: f64,
}

impl Horizon {
    /// What the bound is widened by, relative; 20u are lost.
    const MARGIN: f64 = 1e-5;

    /// Whether the height over it rises on every way to a light, from its start within `radius` of
    /// q.
    ///
    /// At q + e it rises with (N(q) + curvature·e)·(light - q - e), |e| at most the radius. The
    /// reference's slope is off by 20u of the lengths of its terms.
    #[inline(always)]
    pub(crate) fn is_left(&self, light: DVec3, q: DVec3, radius: f64) -> bool {
        let (scaled_center, curvature) = (self.scaled_center, self.curvature);
        let gradient: DVec3 = q * curvature - scaled_center;
        let to_light = light - q;
        let far = to_light.length() + radius;
        let least = gradient.dot(to_light) - radius * (gradient.length() + curvature * far);
        least > Self::MARGIN * far * (curvature * (q.length() + radius) + scaled_center.length())
    }
}
