//! Truth against a little tracer of its own in 240-bit arithmetic.
//!
//! Independent in form too: directions keep the length that they happen to have, roots come
//! from the full quadratic, the camera's side of a surface is looked up ray by ray, and a
//! light is hidden if any root lies at 0 <= t < |L - p|.

use catoptric_reference::truth::{Precision, Truth, Vertex};
use catoptric_scene::{Draft, Scene, View};
use dashu_float::{FBig, round::mode::HalfEven};

use super::scenes::{closed_room, scatterer, workshop};

type Number = FBig<HalfEven, 2>;

const BITS: usize = 240;

fn number(x: f64) -> Number {
    Number::try_from(x).expect("finite").with_precision(BITS).value()
}

fn to_f64(x: &Number) -> f64 {
    x.to_f64().value()
}

#[derive(Clone)]
struct Point([Number; 3]);

impl Point {
    fn new(p: [f64; 3]) -> Self {
        Self(p.map(number))
    }

    fn dot(&self, other: &Self) -> Number {
        &self.0[0] * &other.0[0] + &self.0[1] * &other.0[1] + &self.0[2] * &other.0[2]
    }

    /// self + t · other
    fn along(&self, t: &Number, other: &Self) -> Self {
        Self([0, 1, 2].map(|c| &self.0[c] + t * &other.0[c]))
    }

    fn minus(&self, other: &Self) -> Self {
        self.along(&number(-1.0), other)
    }

    fn cross(&self, other: &Self) -> Self {
        let part = |a: usize, b: usize| &self.0[a] * &other.0[b] - &self.0[b] * &other.0[a];
        Self([part(1, 2), part(2, 0), part(0, 1)])
    }

    fn unit(&self) -> Self {
        let length = self.dot(self).sqrt();
        Self([0, 1, 2].map(|c| &self.0[c] / &length))
    }

    fn to_f64(&self) -> [f64; 3] {
        [0, 1, 2].map(|c| to_f64(&self.0[c]))
    }
}

/// One path: its hits, and the colour that it brings home.
struct Path {
    vertices: Vec<Vertex>,
    color: [f64; 3],
}

fn eye_ray(draft: &Draft, x: u32, y: u32) -> Point {
    let camera = &draft.camera;
    let eye = Point::new(camera.position);
    let forward = Point::new(camera.look_at).minus(&eye).unit();
    let side = forward.cross(&Point::new(camera.up)).unit();
    let up = side.cross(&forward);
    let half = number((camera.fov.to_radians() / 2.0).tan());
    let [width, height] = [draft.image.width, draft.image.height].map(|n| number(f64::from(n)));
    let [x, y] = [x, y].map(|n| number(f64::from(n) + 0.5));
    let right = (number(2.0) * x / &width - number(1.0)) * &half * width / &height;
    let rise = (number(1.0) - number(2.0) * y / height) * half;
    forward.along(&right, &side).along(&rise, &up)
}

/// Every t at which the ray meets primitive `id` as the model has it.
fn root(draft: &Draft, id: usize, o: &Point, d: &Point, left: bool) -> Option<Number> {
    let zero = number(0.0);
    let eye = Point::new(draft.camera.position);
    let Some(sphere) = draft.spheres.get(id) else {
        let plane = &draft.planes[id - draft.spheres.len()];
        let (point, normal) = (Point::new(plane.point), Point::new(plane.normal));
        let eye_height = normal.dot(&eye.minus(&point));
        let (height, slope) = (normal.dot(&o.minus(&point)), normal.dot(d));
        let approached = &eye_height * &slope < zero;
        return (!left && approached).then(|| -height / slope);
    };
    let (center, radius) = (Point::new(sphere.center), number(sphere.radius));
    let around = eye.minus(&center).dot(&eye.minus(&center)) < &radius * &radius;
    let f = o.minus(&center);
    let (a, half_b) = (d.dot(d), f.dot(d));
    let discriminant = &half_b * &half_b - &a * (f.dot(&f) - &radius * &radius);
    if around {
        Some((discriminant.sqrt() - half_b) / a)
    } else if left || half_b >= zero || discriminant < zero {
        None
    } else {
        Some((-discriminant.sqrt() - half_b) / a)
    }
}

fn trace(draft: &Draft, x: u32, y: u32) -> Path {
    let count = draft.spheres.len() + draft.planes.len();
    let bodies: Vec<_> = draft.bodies().collect();
    let material = |id: usize| &draft.materials[bodies[id].material()];
    let zero = number(0.0);
    let (mut o, mut d) = (Point::new(draft.camera.position), eye_ray(draft, x, y));
    let mut path = Path { vertices: Vec::new(), color: [0.0; 3] };
    let mut weight = 1.0;
    let mut own = None;
    for depth in 0..=draft.render.max_depth {
        let met = (0..count).filter_map(|id| Some((id, root(draft, id, &o, &d, own == Some(id))?)));
        let nearest = met.min_by(|a, b| a.1.partial_cmp(&b.1).expect("numbers"));
        let Some((id, t)) = nearest else {
            path.color = [0, 1, 2].map(|c| path.color[c] + weight * draft.render.background[c]);
            return path;
        };
        o = o.along(&t, &d);
        own = Some(id);
        let mut lit = Vec::new();

        let outward = match draft.spheres.get(id) {
            Some(sphere) => o.minus(&Point::new(sphere.center)),
            None => Point::new(draft.planes[id - draft.spheres.len()].normal),
        };
        let facing = outward.dot(&d) < zero;
        let n = if facing { outward } else { Point::new([0.0; 3]).minus(&outward) };
        let n = n.unit();
        let view = Point::new([0.0; 3]).minus(&d.unit());

        let m = material(id);
        let mut local = [0, 1, 2].map(|c| draft.render.ambient[c] * m.color[c]);
        for light in &draft.lights {
            let segment = Point::new(light.position).minus(&o);
            let l = segment.unit();
            let cosine = n.dot(&l);
            // The segment is its own unit of length: the light is at t = 1.
            let hides = |id: usize| {
                root(draft, id, &o, &segment, own == Some(id))
                    .is_some_and(|t| t >= zero && t < number(1.0))
            };
            lit.push(cosine > zero && !(0..count).any(hides));
            if lit.last() == Some(&false) {
                continue;
            }
            let mirrored = n.along(&zero, &n).0.map(|c| number(2.0) * &cosine * c);
            let mirrored = Point(mirrored).minus(&l);
            let highlight = to_f64(&mirrored.dot(&view)).max(0.0).powf(m.shininess);
            let light = |c: usize| {
                let diffuse = m.diffuse * m.color[c] * to_f64(&cosine);
                light.intensity[c] * (diffuse + m.specular * highlight)
            };
            local = [0, 1, 2].map(|c| local[c] + light(c));
        }
        let followed = m.mirror() > 0.0 && depth < draft.render.max_depth;
        let (point, rest) = (o.to_f64(), [0.0; 3]);
        path.vertices.push(Vertex { primitive: id, point, rest, lit, followed });
        // Summed forward: the same sum in the reals.
        path.color = [0, 1, 2].map(|c| path.color[c] + weight * local[c]);
        weight *= m.mirror();
        if m.mirror() <= 0.0 {
            break;
        }
        let turn = number(-2.0) * d.dot(&n);
        d = d.along(&turn, &n);
    }
    path
}

/// Compares every pixel's path and colour; answers the length of the longest path, in hits.
#[track_caller]
fn compare(draft: &Draft, point_error: f64, color_error: f64) -> usize {
    let scene = Scene::new(draft.clone()).expect("valid");
    let view = View::whole(&scene);
    let truth = Truth::new(&scene, Precision::DoubleDouble);
    let mut longest = 0;
    for (x, y) in (0..scene.image.height).flat_map(|y| (0..scene.image.width).map(move |x| (x, y)))
    {
        let exact = trace(draft, x, y);
        let found = truth.path(&view, x, y);
        let ids = |path: &[Vertex]| path.iter().map(|v| v.primitive).collect::<Vec<_>>();
        assert_eq!(ids(&found), ids(&exact.vertices), "pixel {x},{y}");
        for (depth, (f, e)) in found.iter().zip(&exact.vertices).enumerate() {
            let facts = |v: &Vertex| (v.lit.clone(), v.followed);
            assert_eq!(facts(f), facts(e), "pixel {x},{y} depth {depth}");
            for c in 0..3 {
                let error = (f.point[c] - e.point[c]).abs();
                assert!(error <= point_error, "pixel {x},{y} depth {depth}: {f:?}, exact {e:?}");
            }
        }
        let color = truth.radiance(&view, x, y).expect("not too deep");
        for c in 0..3 {
            let error = (color[c] - exact.color[c]).abs();
            assert!(error <= color_error, "pixel {x},{y}: {color:?}, exact {:?}", exact.color);
        }
        longest = longest.max(found.len());
    }
    longest
}

/// 130 paths. Points differ by no more than their rounding to f64: an ulp at 64.
#[test]
fn workshop_paths_are_exact() {
    let longest = compare(&workshop(13, 10, 12, 0.3), 1.5e-14, 4e-15);
    assert!(longest >= 4, "the longest path has {longest} hits");
}

/// 99 paths a view between convex mirrors that amplify errors about tenfold a bounce. A wide
/// view sees few bounces; the narrow ones look along the line of two centres from between
/// them, where a path goes on until its start, off by the pixel's angle, has grown to size. Fifteen
/// bounces make 5e-32 into the ulp that is compared.
#[test]
fn scatterer_paths_are_exact() {
    let mut draft = scatterer(11, 9);
    draft.render.max_depth = 15;
    compare(&draft, 1e-15, 4e-15);
    let ([ax, ay, az], [bx, by, bz]) = (draft.spheres[0].center, draft.spheres[1].center);
    draft.camera.position = [ax + 0.37 * (bx - ax), ay + 0.37 * (by - ay), az + 0.37 * (bz - az)];
    draft.camera.look_at = [bx, by, bz];
    for (fov, bounces) in [(20.0, 2), (1.0, 3), (1e-3, 6), (1e-6, 9), (1e-9, 12)] {
        draft.camera.fov = fov;
        let longest = compare(&draft, 1e-15, 4e-15);
        assert!(longest > bounces, "at {fov} degrees the longest path has {longest} hits");
    }
}

/// 30 paths of 25 bounces between curved mirrors, where f64 has lost about ten digits: of
/// double-double's 32 all that f64 can show are left.
#[test]
fn closed_room_paths_are_exact() {
    let longest = compare(&closed_room(6, 5, 25), 2e-15, 4e-14);
    assert_eq!(longest, 26);
}
