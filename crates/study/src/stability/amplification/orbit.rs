//! Periodic orbits between equal mirror spheres, and eye rays that stay near them.
//!
//! Between two spheres the orbit of period 2 runs along their centres. Between three at the
//! corners of an equilateral triangle of side σR the orbit of period 3 is a triangle too: it
//! bounces where each sphere is nearest to the middle, which is σR/√3 from every centre, so
//! its own corners are σR/√3 - R from the middle and its side is τ = √3(σR/√3 - R) =
//! (σ - √3)R. Its angles are 60 degrees, hence φ = 30 degrees, cos φ = √3/2, and the gains are
//! 4/(√3 R) in the plane of the triangle and √3/R across it. With x = 1 + τ·gain/2, which is
//! 2σ/√3 - 1 in the plane and (√3σ - 1)/2 across, Lambda = x + sqrt(x² - 1). Between two of the
//! three the orbit of period 2 is the pair's. (Gaspard and Rice, J. Chem. Phys. 90, 2225,
//! 1989, study the same orbits between discs; the formulas are derived here.)
//!
//! An eye ray taken at random leaves such a scene after a few bounces. So rays are aimed: the
//! ray's n-th hit is made to be the orbit's n-th point, n rising, by Newton's method with the
//! spreads of [`super::tangent`]. Such a ray runs into the orbit and stays until n.

use catoptric_reference::truth::{Precision, Truth, Vertex};
use catoptric_scene::{Camera, Draft, Image, Material, Materials, Scene, Sphere, View};
use glam::DVec3;

use super::tangent::{periodic_lambda, spreads};

/// Equal spheres, and an orbit between them.
#[derive(Clone, Debug)]
pub struct Orbit {
    /// Mirrors of factor 1, radius [`RADIUS`].
    pub centers: Vec<DVec3>,
    /// Points at which it bounces: each on the sphere of the same index.
    pub bounces: Vec<DVec3>,
    /// A unit vector across the orbit's first flight, which is from its last bounce to its
    /// first; in the triangle's plane. Eyes stand aside of the flight in it.
    pub aside: DVec3,
    /// A unit vector across the first flight: in which direction rays are nudged.
    pub nudge: DVec3,
    /// Growth of an error per bounce: the closed form, for that direction.
    pub lambda: f64,
}

/// A scene whose first pixel's eye ray, nudged, stays near an orbit.
#[derive(Clone, Debug)]
pub struct Aimed {
    /// The scene; its image is 3 x 3.
    pub scene: Scene,
    /// What is left to add to the eye ray's unit direction; below 1e-15.
    pub nudge: [f64; 3],
}

/// Radius of the orbits' spheres: no neat number, like their places.
pub const RADIUS: f64 = 1.37;

/// The middle of every orbit.
const MIDDLE: DVec3 = DVec3::new(0.713, -1.291, 2.553);

/// Three unit vectors at right angles, in no neat direction.
fn axes() -> [DVec3; 3] {
    let x = DVec3::new(0.31, -0.72, 0.62).normalize();
    let y = x.cross(DVec3::new(0.83, 0.21, -0.44)).normalize();
    [x, y, x.cross(y)]
}

/// The first of 3 x 3 pixels: ahead, to the right and up, at a field of view of 90 degrees.
const FIRST_PIXEL: DVec3 = DVec3::new(1.0, -2.0 / 3.0, 2.0 / 3.0);

impl Orbit {
    /// Two spheres, their centres `sigma` radii apart, `sigma` > 2.
    #[must_use]
    pub fn pair(sigma: f64) -> Self {
        let [x, y, _] = axes();
        let half = sigma / 2.0 * RADIUS * x;
        let centers = vec![MIDDLE - half, MIDDLE + half];
        let bounces = vec![centers[0] + RADIUS * x, centers[1] - RADIUS * x];
        let lambda = periodic_lambda((sigma - 2.0) * RADIUS, 2.0 / RADIUS);
        Self { centers, bounces, aside: y, nudge: y, lambda }
    }

    /// Three spheres, every two centres `sigma` radii apart, `sigma` > 2, and the triangle: its
    /// flights are (σ - √3)R long, its angles of incidence 30 degrees.
    #[must_use]
    pub fn triangle(sigma: f64) -> Self {
        let root = 3.0_f64.sqrt();
        let [x, y, _] = axes();
        let corners = [x, -0.5 * x + root / 2.0 * y, -0.5 * x - root / 2.0 * y];
        let centers = corners.map(|c| MIDDLE + sigma * RADIUS / root * c);
        let bounces = corners.map(|c| MIDDLE + (sigma / root - 1.0) * RADIUS * c);
        let flight = (bounces[0] - bounces[2]).normalize();
        let lambda = periodic_lambda((sigma - root) * RADIUS, 4.0 / (root * RADIUS));
        let aside = flight.cross(x.cross(y)).normalize();
        let (centers, bounces) = (centers.into(), bounces.into());
        Self { centers, bounces, aside, nudge: aside, lambda }
    }

    /// The triangle nudged out of its plane, where errors grow slower.
    #[must_use]
    pub fn triangle_nudged_across(sigma: f64) -> Self {
        let root = 3.0_f64.sqrt();
        let [x, y, _] = axes();
        let lambda = periodic_lambda((sigma - root) * RADIUS, root / RADIUS);
        Self { nudge: x.cross(y), lambda, ..Self::triangle(sigma) }
    }

    /// A unit vector at right angles to the orbits' planes.
    #[must_use]
    pub fn plane_normal() -> DVec3 {
        axes()[2]
    }

    /// An eye on the orbit's first flight, moved aside of it by up to a tenth of its length
    /// or of the radius, in the way numbered `index`; and its ray, aimed to stay for `bounces`
    /// bounces, or as many as double-double can.
    #[must_use]
    pub fn aimed(&self, index: u32, bounces: usize) -> Aimed {
        let from = self.bounces[self.bounces.len() - 1];
        let flight = self.bounces[0] - from;
        // Multiples of the golden ratio and of another irrational number spread evenly.
        let part = |ratio: f64| (f64::from(index + 1) * ratio).fract() - 0.5;
        let (along, off) = (0.5 + 0.4 * part(0.618_033_988_75), 0.2 * part(0.754_877_666_25));
        let eye = from + along * flight + off * flight.length().min(RADIUS) * self.aside;
        // First in what f64 can state as a camera, then what it cannot.
        let straight = Aimed { scene: self.scene(eye, self.bounces[0], bounces), nudge: [0.0; 3] };
        let digits = (1e12_f64.ln() / self.lambda.ln()) as usize;
        let rough = self.refined(straight, digits.clamp(1, bounces));
        // A target far away states a direction to an ulp.
        let target = eye + 64.0 * (rough.direction() + DVec3::from_array(rough.nudge));
        let stated = Aimed { scene: self.scene(eye, target, bounces), nudge: [0.0; 3] };
        self.refined(stated, bounces)
    }

    /// The orbit's ray is that of the first pixel, askew to all three axes of the camera, in which
    /// everything is computed: a ray straight ahead has coordinates that are 0, and flatters.
    fn scene(&self, eye: DVec3, target: DVec3, bounces: usize) -> Scene {
        // The axes that have the pixel in that direction: those of the ray, mirrored so that the
        // ray's own is the pixel's.
        let ray = (target - eye).normalize();
        let (p, q) = ray.any_orthonormal_pair();
        let k = (FIRST_PIXEL.normalize() - DVec3::X).normalize();
        let mirrored = |v: DVec3| v - 2.0 * k.dot(v) * k;
        let turned = |v: DVec3| v.x * ray + v.y * p + v.z * q;
        let [forward, side, up] = [DVec3::X, DVec3::Y, DVec3::Z].map(|v| turned(mirrored(v)));
        // Right-handed: the side is to the right.
        let up = if forward.cross(up).dot(side) < 0.0 { -up } else { up };
        let mut materials = Materials::default();
        let material = materials.add(Material { reflect: Some(1.0), ..Material::matt([0.4; 3]) });
        let sphere = |c: &DVec3| Sphere { center: c.to_array(), radius: RADIUS, material };
        let mut draft = Draft {
            image: Image { width: 3, height: 3, ..Image::default() },
            camera: Camera {
                position: eye.to_array(),
                look_at: (eye + 64.0 * forward).to_array(),
                up: up.to_array(),
                fov: 90.0,
            },
            spheres: self.centers.iter().map(sphere).collect(),
            materials,
            ..Draft::default()
        };
        draft.render.max_depth = u32::try_from(bounces).expect("a depth") + 32;
        Scene::new(draft).expect("spheres apart from the eye")
    }

    /// Newton's method for hit after hit; keeps the nudge that came furthest.
    fn refined(&self, start: Aimed, bounces: usize) -> Aimed {
        let Aimed { scene, nudge } = start;
        let (truth, view) = (Truth::new(&scene, Precision::DoubleDouble), View::whole(&scene));
        let mut best = DVec3::from_array(nudge);
        let d = Aimed { scene: scene.clone(), nudge }.direction();
        let across: [DVec3; 2] = d.any_orthonormal_pair().into();
        let mut hit = 0;
        // Aim at a hit a little further on each time: a nudge solved for one is near the next.
        while hit < bounces {
            hit = bounces.min(hit + 1 + hit / 4);
            let mut nudge = best;
            let mut solved = false;
            for _ in 0..12 {
                let path = truth.path_nudged(&view, 0, 0, nudge.to_array());
                let Some(miss) = self.miss(&path, hit) else { break };
                solved = miss.length() < 1e-9 * RADIUS;
                if solved {
                    break;
                }
                // A Newton step: least squares in the two directions across the ray.
                let [a, b] = spreads(&scene, &path[..=hit], across)[hit];
                let (aa, bb, ab) = (a.dot(a), b.dot(b), a.dot(b));
                let determinant = aa * bb - ab * ab;
                let (ma, mb) = (miss.dot(a), miss.dot(b));
                nudge -= across[0] * ((ma * bb - mb * ab) / determinant)
                    + across[1] * ((mb * aa - ma * ab) / determinant);
            }
            if !solved {
                break;
            }
            // Only a nudge that was solved is kept.
            best = nudge;
        }
        Aimed { scene, nudge: best.to_array() }
    }

    /// The way from the orbit's point to a path's hit, if the path followed the orbit so far.
    fn miss(&self, path: &[Vertex], hit: usize) -> Option<DVec3> {
        let period = self.bounces.len();
        let followed =
            path.iter().take(hit + 1).enumerate().all(|(i, v)| v.primitive == i % period);
        let vertex = path.get(hit).filter(|_| followed)?;
        let target = self.bounces[hit % period];
        Some(DVec3::from_array(vertex.point) - target + DVec3::from_array(vertex.rest))
    }
}

impl Aimed {
    /// The eye ray's unit direction, without the nudge, in f64.
    #[must_use]
    pub fn direction(&self) -> DVec3 {
        let camera = &self.scene.camera;
        let ahead = DVec3::from_array(camera.look_at) - DVec3::from_array(camera.position);
        let forward = ahead.normalize();
        let side = forward.cross(DVec3::from_array(camera.up)).normalize();
        let up = side.cross(forward);
        let DVec3 { x, y, z } = FIRST_PIXEL;
        (x * forward + y * side + z * up).normalize()
    }
}
