//! Scenes so small that one step of the tracing dominates their picture.
//!
//! The engine's kernels are private, so they are timed through whole renderings: of 64
//! primitives of one form for an intersection, of one ball that fills the view for a step of
//! the shading. What remains in each is an eye ray and a pixel, which `empty` shows alone.

use catoptric_scene::{Draft, Light, Material, Numerics, Plane, Shape, Sphere};

/// Primitives in each scene of [`forms`].
pub const PRIMITIVES: u32 = 64;

/// A scene of [`PRIMITIVES`] primitives of one form.
pub struct Form {
    /// What it is called in reports.
    pub name: &'static str,
    /// No light, depth 0; every eye ray meets every primitive, and the first one is nearest.
    pub draft: Draft,
    /// Whether a shape is of that form, so that the bench cannot time another one.
    pub is: fn(&Shape) -> bool,
}

/// Every form of intersection.
#[must_use]
pub fn forms() -> Vec<Form> {
    let textbook = |mut draft: Draft| {
        draft.render.numerics = Numerics::Textbook;
        draft
    };
    vec![
        Form {
            name: "ball",
            draft: concentric(-20.0, |i| 10.0 - step(i)),
            is: |s| matches!(s, Shape::RobustSphere(b) if !b.encloses_eye()),
        },
        Form {
            name: "ball-around",
            draft: concentric(-1.0, |i| 3.0 + step(i)),
            is: |s| matches!(s, Shape::RobustSphere(b) if b.encloses_eye()),
        },
        Form {
            name: "flat-plane",
            draft: planes(),
            is: |s| matches!(s, Shape::GeneralSphere(f) if f.curvature == 0.0),
        },
        Form {
            name: "flat-sphere",
            draft: concentric(-1e4 - 1.0, |i| 1e4 - step(i)),
            is: |s| matches!(s, Shape::GeneralSphere(f) if f.curvature > 0.0),
        },
        Form {
            name: "textbook-sphere",
            draft: textbook(concentric(-20.0, |i| 10.0 - step(i))),
            is: |s| matches!(s, Shape::TextbookSphere(_)),
        },
        Form {
            name: "textbook-plane",
            draft: textbook(planes()),
            is: |s| matches!(s, Shape::TextbookPlane(_)),
        },
    ]
}

/// One ball that fills the view, a lamp beside the eye, and one step more in each scene.
///
/// Every pixel does the same: the whole picture is lit, and every highlight is above the cut
/// below which the power is taken as 0.
#[must_use]
pub fn shading() -> Vec<(&'static str, Draft)> {
    let matt = Material::matt([0.8, 0.6, 0.4]);
    let glossy = |shininess| Material { specular: 0.5, shininess, reflect: Some(0.0), ..matt };
    let mirror = Material { reflect: Some(0.5), ..matt };
    let lamp = || vec![Light { position: [0.0, 0.1, 0.0], intensity: [1.0; 3] }];
    let ball = |material, lights, max_depth| {
        let mut draft = narrow();
        let material = draft.materials.add(material);
        draft.spheres.push(Sphere { center: [0.0, 0.0, -20.0], radius: 10.0, material });
        draft.lights = lights;
        draft.render.max_depth = max_depth;
        draft
    };
    vec![
        ("empty", narrow()),
        ("ambient", ball(matt, Vec::new(), 0)),
        ("lamp", ball(matt, lamp(), 0)),
        ("highlight-20", ball(glossy(20.0), lamp(), 0)),
        ("highlight-200", ball(glossy(200.0), lamp(), 0)),
        ("highlight-20.5", ball(glossy(20.5), lamp(), 0)),
        ("mirror", ball(mirror, Vec::new(), 1)),
    ]
}

/// A view of 4 degrees along -z of nothing.
fn narrow() -> Draft {
    let mut draft = Draft::default();
    draft.camera.fov = 4.0;
    draft.render.max_depth = 0;
    draft
}

/// Spheres of one centre on the z axis.
fn concentric(z: f64, radius: impl Fn(u32) -> f64) -> Draft {
    let mut draft = narrow();
    let material = draft.materials.add(Material::matt([0.5; 3]));
    draft.spheres = (0..PRIMITIVES)
        .map(|i| Sphere { center: [0.0, 0.0, z], radius: radius(i), material })
        .collect();
    draft
}

/// Planes across the z axis, one behind the other.
fn planes() -> Draft {
    let mut draft = narrow();
    let material = draft.materials.add(Material::matt([0.5; 3]));
    draft.planes = (0..PRIMITIVES)
        .map(|i| Plane { point: [0.0, 0.0, -1.0 - step(i)], normal: [0.1, 0.2, 1.0], material })
        .collect();
    draft
}

/// How far apart they are.
fn step(i: u32) -> f64 {
    f64::from(i) / 16.0
}
