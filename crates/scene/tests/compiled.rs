//! Compilation in two scalars: the same decisions, and each constant rounded once.

use catoptric_scene::{
    Camera, CameraAxes, Compiled, Draft, Grid, Light, Material, Numerics, Plane, Scalar, Scene,
    Shape, Sphere, View,
};
use dashu_float::FBig;
use dashu_float::round::mode::HalfEven;
use proptest::collection::vec;
use proptest::prelude::*;

type Exact = FBig<HalfEven, 2>;

fn exact(x: f64) -> Exact {
    Exact::try_from(x).expect("finite").with_precision(600).value()
}

fn dot(a: &[Exact; 3], b: &[Exact; 3]) -> Exact {
    &a[0] * &b[0] + &a[1] * &b[1] + &a[2] * &b[2]
}

fn cross(a: &[Exact; 3], b: &[Exact; 3]) -> [Exact; 3] {
    [[1, 2], [2, 0], [0, 1]].map(|[i, j]| &a[i] * &b[j] - &a[j] * &b[i])
}

fn unit(v: &[Exact; 3]) -> [Exact; 3] {
    let length = dot(v, v).sqrt();
    v.clone().map(|x| x / &length)
}

fn minus(a: [f64; 3], b: [f64; 3]) -> [Exact; 3] {
    std::array::from_fn(|i| exact(a[i]) - exact(b[i]))
}

/// The f64 nearest to the exact number, but for one in a thousand millions that lies so close
/// to the middle of two that double-double cannot tell.
#[track_caller]
fn assert_rounded(found: f64, wanted: &Exact) {
    let nearest = wanted.to_f64().value();
    assert!(found == nearest, "{found:e} is not the nearest, {nearest:e}");
}

#[track_caller]
fn assert_rounded3(found: glam::DVec3, wanted: &[Exact; 3]) {
    found.to_array().iter().zip(wanted).for_each(|(found, wanted)| assert_rounded(*found, wanted));
}

/// A direction, or a point relative to the eye, in the camera's axes.
fn turned(camera: &Camera, v: &[Exact; 3]) -> [Exact; 3] {
    let f = unit(&minus(camera.look_at, camera.position));
    let s = unit(&cross(&f, &camera.up.map(exact)));
    let back = f.clone().map(|x| -x);
    [dot(&s, v), dot(&cross(&s, &f), v), dot(&back, v)]
}

const EYE: [f64; 3] = [1e6 + 0.1, -3e5 - 0.7, 12.3];

fn scene(numerics: Numerics) -> (Draft, Scene) {
    let material = Material::matt([1.0; 3]);
    let mut draft = Draft::default();
    draft.render.numerics = numerics;
    draft.camera.position = EYE;
    draft.camera.look_at = [EYE[0] + 0.3, EYE[1] + 0.2, EYE[2] - 1.7];
    // Almost along the view: its cross product with it keeps nine digits of f64's sixteen.
    draft.camera.up = [0.3, 0.2, -1.7 + 3e-7];
    draft.lights.push(Light { position: [7.1, 8.3, 9.7], intensity: [1.0; 3] });
    let center = [EYE[0] + 6.1e11, EYE[1] - 5.3e11, EYE[2] + 5.9e11];
    draft.spheres.push(Sphere { center, radius: 1e12, material: draft.materials.add(material) });
    let center = [EYE[0] + 1.1, EYE[1] - 3.7, EYE[2] - 9.1];
    draft.spheres.push(Sphere { center, radius: 0.3, material: draft.materials.add(material) });
    let (point, normal) = ([-7.7e5, 3.1e4, 1.1e6], [0.3e200, -0.5e200, 0.7e200]);
    draft.planes.push(Plane { point, normal, material: draft.materials.add(material) });
    (draft.clone(), Scene::new(draft).expect("valid"))
}

#[test]
fn constants_in_f64_are_rounded_once() {
    let (draft, scene) = scene(Numerics::Robust);
    let compiled = Compiled::<f64>::of(&scene);
    let camera = draft.camera;
    let at = |point| turned(&camera, &minus(point, EYE));
    assert_rounded3(compiled.lights[0].position, &at(draft.lights[0].position));

    for (sphere, primitive) in draft.spheres.iter().zip(&compiled.primitives) {
        let (c, r) = (at(sphere.center), exact(sphere.radius));
        match primitive.shape {
            Shape::RobustSphere(ball) => {
                assert_rounded3(ball.center, &c);
                assert_rounded(ball.radius_squared, &(&r * &r));
            }
            Shape::GeneralSphere(flat) => {
                let power = dot(&c, &c) - &r * &r;
                let side = exact(if flat.encloses_eye() { -1.0 } else { 1.0 });
                assert_rounded(flat.curvature, &(&side / &r));
                assert_rounded3(flat.scaled_center, &c.map(|c| &side * c / &r));
                assert_rounded(flat.cocurvature, &(&side * power / &r));
            }
            _ => unreachable!("robust"),
        }
    }

    let plane = draft.planes[0];
    let normal = unit(&plane.normal.map(exact));
    let height = dot(&normal, &minus(EYE, plane.point));
    let Shape::GeneralSphere(flat) = compiled.primitives[2].shape else { unreachable!("a plane") };
    let side = exact(if height < exact(0.0) { 1.0 } else { -1.0 });
    assert_rounded3(flat.scaled_center, &turned(&camera, &normal.map(|x| &side * x)));
    assert_rounded(flat.cocurvature, &(exact(-2.0) * side * height));
}

#[test]
fn the_camera_in_f64_is_rounded_once() {
    let (draft, scene) = scene(Numerics::Textbook);
    let eye = Compiled::<f64>::of(&scene).eye;
    let camera = draft.camera;
    let h = exact((camera.fov.to_radians() / 2.0).tan());
    let wide = &h * exact(640.0) / exact(480.0);
    assert_rounded(eye.half_width, &wide);
    assert_rounded(eye.half_height, &h);
    assert_rounded(eye.distance, &exact(1.0));

    let view = View::new(&scene, None, 3).expect("whole");
    let columns = Grid::<f64>::of(&view).columns;
    for (i, column) in (0..).zip(columns) {
        assert_rounded(column, &(exact(f64::from(2 * i + 1 - 1920)) / exact(1920.0)));
    }
}

/// The numbers of a shape, its kind first.
fn numbers<S: Scalar>(shape: &Shape<S>) -> Vec<f64> {
    let (kind, vector, scalars) = match *shape {
        Shape::RobustSphere(b) => (0, b.center, vec![b.radius, b.radius_squared, b.side]),
        Shape::GeneralSphere(f) => (1, f.scaled_center, vec![f.curvature, f.cocurvature]),
        Shape::TextbookSphere(s) => (2, s.center, vec![s.radius]),
        Shape::TextbookPlane(p) => (3, p.normal, vec![p.offset]),
    };
    let vector: [S; 3] = vector.into();
    let scalars = vector.into_iter().chain(scalars).map(S::to_f64);
    std::iter::once(f64::from(kind)).chain(scalars).collect()
}

proptest! {
    /// What the two scalars hold are roundings of the same numbers, of the same forms, and the
    /// same lamps are hidden.
    #[test]
    fn the_scalars_agree(
        eye in prop::array::uniform3(-30.0..30.0),
        spheres in vec((prop::array::uniform3(-30.0..30.0), -2.0..3.0), 0..8),
        planes in vec((prop::array::uniform3(-30.0..30.0), prop::array::uniform3(0.1..1.0)), 0..3),
        lights in vec(prop::array::uniform3(-30.0..30.0), 0..4),
        textbook in any::<bool>(),
    ) {
        let mut draft = Draft::default();
        let material = draft.materials.add(Material::matt([0.3; 3]));
        draft.render.numerics = if textbook { Numerics::Textbook } else { Numerics::Robust };
        draft.camera.position = eye;
        draft.camera.look_at = [eye[0] + 1.0, eye[1] + 0.1, eye[2]];
        draft.spheres = spheres
            .into_iter()
            .map(|(center, e): ([f64; 3], f64)| Sphere { center, radius: 10f64.powf(e), material })
            .collect();
        draft.planes =
            planes.into_iter().map(|(point, normal)| Plane { point, normal, material }).collect();
        draft.lights =
            lights.into_iter().map(|position| Light { position, intensity: [0.7; 3] }).collect();
        let scene = Scene::new(draft).expect("valid");
        let (single, double) = (Compiled::new(&scene), Compiled::<f64>::of(&scene));

        for (a, b) in single.lights.iter().zip(&double.lights) {
            prop_assert_eq!(a.hidden, b.hidden);
        }
        prop_assert_eq!(single.primitives.len(), double.primitives.len());
        for (a, b) in single.primitives.iter().zip(&double.primitives) {
            prop_assert_eq!(a.material, b.material);
            let (a, b) = (numbers(&a.shape), numbers(&b.shape));
            prop_assert_eq!(a.len(), b.len());
            for (a, b) in a.into_iter().zip(b) {
                let half_ulp = f64::from(f32::EPSILON) / 2.0 * b.abs();
                prop_assert!((a - b).abs() <= half_ulp, "{a:e} is no rounding of {b:e}");
            }
        }
    }
}

/// A light whose offset from the eye lies in the middle between two f32, and the same scene turned:
/// the even one is taken both times.
#[test]
fn ties_are_even_however_the_scene_is_turned() {
    let camera = |position, look_at, up| Camera { position, look_at, up, fov: 1.0 };
    let x = 14_035.618_652_343_75;
    let as_stated = CameraAxes::new(&camera([x, 0.0, 0.0], [x, 0.0, -44.0], [11.0, 0.0, 0.0]));
    let [a, b] = [-8_931.757_324_218_75, 7_655.791_992_187_5];
    let turned =
        CameraAxes::new(&camera([a, b, b], [a - 24.0, b + 8.0, b - 36.0], [-7.0, 6.0, 6.0]));
    let lights = [as_stated.point([0.0, 0.0, 11.0]), turned.point([6.0, -2.0, 9.0])];
    let [stated, turned] = lights.map(|light| light.map(|x| x.to_f32().to_bits()));
    assert_eq!(stated, turned);
}
