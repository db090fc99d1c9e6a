//! How a nudge of the eye ray spreads along a path, to first order.
//!
//! The transport of curvatures in a dispersing billiard (Chernov and Markarian, Chaotic
//! Billiards, 2006, chapters 3 and 4), in space: a thin bundle of rays is a field J of
//! displacements across the ray and its slope W = κJ.
//!
//! ```text
//! flight of length τ:    J += τW              that is Lambda = 1 + τκ, κ' = κ/(1 + τκ)
//! mirror of radius R:    W += gain · J        that is κ' = κ + gain, both mirrored
//!     gain: 2/(R cos φ) in the plane of incidence, 2 cos φ/R across it
//! ```
//!
//! A bundle that leaves the eye has J = 0 and infinite curvature, and so has one at a focus
//! of a hollow mirror: J and W stay finite there, which is why they are carried and κ is not.

use catoptric_reference::truth::Vertex;
use catoptric_scene::Scene;
use glam::DVec3;

/// How far a hit moves on its surface, for a unit nudge of the eye ray's direction along each
/// of two directions across it; to first order. Units: world units.
pub type Spread = [DVec3; 2];

/// The spread at each hit of a path. `nudges`: unit vectors across the eye ray and each other.
///
/// The path is taken from its points, rounded to f64. Lengths beyond f64's range are infinite
/// or NaN: some hundred bounces at a Lambda of 10.
#[must_use]
pub fn spreads(scene: &Scene, path: &[Vertex], nudges: [DVec3; 2]) -> Vec<Spread> {
    let mut origin = DVec3::from_array(scene.camera.position);
    let mut fields = nudges.map(|nudge| (DVec3::ZERO, nudge));
    let step = |vertex: &Vertex| {
        let point = DVec3::from_array(vertex.point);
        let flight = point - origin;
        let (distance, d) = (flight.length(), flight.normalize_or_zero());
        origin = point;
        let mirror = Mirror::of(scene, vertex.primitive, point, d);
        let mut spread = [DVec3::ZERO; 2];
        for ((j, w), spread) in fields.iter_mut().zip(&mut spread) {
            *j += distance * *w;
            // The displaced ray meets the surface a little earlier or later.
            *spread = *j + d * (mirror.normal.dot(*j) / mirror.cosine);
            *w = mirror.reflected(*w) + mirror.bent(*j, d);
            *j = mirror.reflected(*j);
        }
        spread
    };
    path.iter().map(step).collect()
}

/// The largest of the spreads that nudges in all directions have: the larger singular value.
#[must_use]
pub fn largest([a, b]: Spread) -> f64 {
    let (aa, bb, ab) = (a.dot(a), b.dot(b), a.dot(b));
    let half = (aa - bb) / 2.0;
    ((aa + bb) / 2.0 + (half * half + ab * ab).sqrt()).sqrt()
}

/// Lambda of a periodic orbit all of whose flights are `flight` long and all of whose bounces
/// add `gain` to the curvature: the fixed point of κ = κ/(1 + τκ) + gain, where Lambda =
/// 1 + τκ, so that (Lambda - 1)² = τ·gain·Lambda; the root above 1.
///
/// Two equal spheres, σ = distance/R: τ = (σ - 2)R, gain = 2/R, so Lambda =
/// (σ - 1) + sqrt(σ(σ - 2)). The triangle between three: see
/// [`super::Orbit::triangle`].
#[must_use]
pub fn periodic_lambda(flight: f64, gain: f64) -> f64 {
    let x = 1.0 + flight * gain / 2.0;
    x + (x * x - 1.0).sqrt()
}

/// A surface at a hit.
struct Mirror {
    /// Outward.
    normal: DVec3,
    /// Cosine of the angle of incidence; negative from inside, which makes a mirror hollow.
    cosine: f64,
    /// 1/R; 0 for a plane.
    curvature: f64,
}

impl Mirror {
    fn of(scene: &Scene, primitive: usize, point: DVec3, d: DVec3) -> Self {
        let (outward, curvature) = match scene.spheres.get(primitive) {
            Some(s) => ((point - DVec3::from_array(s.center)) / s.radius, 1.0 / s.radius),
            None => {
                let plane = &scene.planes[primitive - scene.spheres.len()];
                (DVec3::from_array(plane.normal), 0.0)
            }
        };
        let normal = outward.normalize_or_zero();
        Self { normal, cosine: -normal.dot(d), curvature }
    }

    fn reflected(&self, v: DVec3) -> DVec3 {
        v - 2.0 * self.normal.dot(v) * self.normal
    }

    /// What the mirror adds to the slope of a field, for the field before it.
    ///
    /// With t = n + cos φ d, which lies in the plane of incidence across d and is sin φ long,
    /// (2/R)(cos φ J + (t·J) t/cos φ) has both gains, since cos φ + sin²φ/cos φ = 1/cos φ. It
    /// needs no plane of incidence, which a ray straight on does not have.
    fn bent(&self, j: DVec3, d: DVec3) -> DVec3 {
        let t = self.normal + self.cosine * d;
        self.reflected(2.0 * self.curvature * (self.cosine * j + t.dot(j) / self.cosine * t))
    }
}
