//! A flake of 91 mirror spheres: many primitives, paths that end early and unevenly.

use catoptric_scene::{Draft, Light, Material, Sphere};

/// A sphere, nine children of a third of its radius that touch it, and nine of each of those.
///
/// Around its axis, which points away from its parent, a sphere has six children on the
/// equator and three at 60 degrees above it. Only square roots are taken, so the scene is the
/// same on every machine.
#[must_use]
pub fn flake() -> Draft {
    let mut draft = Draft::default();
    draft.camera.position = [2.1, 1.3, 4.4];
    draft.camera.look_at = [0.0, 0.15, 0.0];
    draft.camera.fov = 42.0;
    draft.render.background = [0.25, 0.35, 0.5];
    draft.lights = vec![Light { position: [4.0, 6.0, 5.0], intensity: [0.9; 3] }];
    grow(&mut draft.spheres, [0.0; 3], 1.0, [0.0, 1.0, 0.0], 2);
    draft
}

/// Adds a sphere and `levels` generations below it.
fn grow(spheres: &mut Vec<Sphere>, center: [f64; 3], radius: f64, axis: [f64; 3], levels: u32) {
    spheres.push(Sphere { center, radius, material: material(levels) });
    if levels == 0 {
        return;
    }
    // Two vectors that with the axis form an orthonormal frame.
    let aside = if axis[0].abs() < 0.5 { [1.0, 0.0, 0.0] } else { [0.0, 1.0, 0.0] };
    let u = cross(axis, aside);
    let length = u.iter().map(|x| x * x).sum::<f64>().sqrt();
    let u = u.map(|x| x / length);
    let v = cross(axis, u);
    for [a, b, up] in children() {
        let way: [f64; 3] = std::array::from_fn(|i| a * u[i] + b * v[i] + up * axis[i]);
        let away = radius + radius / 3.0;
        let child = std::array::from_fn(|i| center[i] + away * way[i]);
        grow(spheres, child, radius / 3.0, way, levels - 1);
    }
}

/// Unit vectors towards the nine children; the axis is the third component.
fn children() -> [[f64; 3]; 9] {
    let (half, sine) = (0.5, 0.75f64.sqrt());
    [
        [1.0, 0.0, 0.0],
        [half, sine, 0.0],
        [-half, sine, 0.0],
        [-1.0, 0.0, 0.0],
        [-half, -sine, 0.0],
        [half, -sine, 0.0],
        [half * sine, half * half, sine],
        [-half * sine, half * half, sine],
        [0.0, -half, sine],
    ]
}

fn material(levels: u32) -> Material {
    let color = match levels {
        2 => [0.85, 0.75, 0.55],
        1 => [0.55, 0.7, 0.85],
        _ => [0.8, 0.45, 0.4],
    };
    Material { color, diffuse: 0.4, specular: 0.5, shininess: 40.0, reflect: Some(0.6) }
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}
