//! Hidden lights: those that some primitive hides from all that the eye can see.
//!
//! The answer is that of double-double, with every primitive asked about every light. Two things
//! make that cheap, and change no answer:
//!
//! - Where f64 leaves no doubt about a sign, double-double is not asked. With u = 2^-53, the square
//!   of a distance is within 6u of itself, a radius squared within u, and their difference rounds
//!   by u of itself: the sign is right where it is further from 0 than 16u of the two squares' sum.
//!   A height over a plane is a sum of three products, each off by 2u and added with 2u more: its
//!   sign is right above 16u of the sum of their magnitudes. Double-double is off by less than
//!   100u^2 of the same sums.
//! - Lights stand in a tree of boxes. A primitive that surely hides no point of a box is not asked
//!   about the lights in it, nor about lights that are known to be hidden. A box counts as surely
//!   not hidden only with a margin of 1e-12 of the same sums, far above the error of f64.
//!
//! Primitives and lights that have a product of coordinates near 1e-290, where products round to
//! less than their share, are asked in double-double.

use super::forms::{power_of, scaled_height};
use crate::direction::tamed;
use crate::{DoubleDouble, Draft, Plane, Sphere};

/// Relative size below which a sign is in doubt in f64: a little above 16u.
const DOUBT: f64 = 2e-15;

/// Relative margin by which a box must be clear of a primitive to be skipped.
const ROOM: f64 = 1e-12;

/// Size below which products may be rounded by more than u of themselves.
const FAINT: f64 = 1e-290;

/// Most lights in a box that is not divided further.
const LEAF: usize = 8;

/// Whether each light is hidden: some primitive stands between it and all that the eye can see.
pub(super) fn hidden(scene: &Draft) -> Vec<bool> {
    hidden_in_steps(scene, &mut || ())
}

/// [`hidden`], calling `step` for every box and every light that a primitive is asked about.
fn hidden_in_steps(scene: &Draft, step: &mut impl FnMut()) -> Vec<bool> {
    let mut lights = Lights::new(scene.lights.iter().map(|light| light.position).collect());
    let eye = scene.camera.position;
    for sphere in &scene.spheres {
        lights.ask(&Body::around_or_not(sphere, eye), step);
    }
    for plane in &scene.planes {
        lights.ask(&Half::new(plane, eye), step);
    }
    lights.hidden
}

/// A primitive that hides the lights on its far side.
trait Hides {
    /// Whether a light at this point is hidden.
    fn hides(&self, light: [f64; 3]) -> bool;

    /// Whether surely no light of a box is hidden.
    fn spares(&self, least: [f64; 3], most: [f64; 3]) -> bool;
}

/// A sphere, and whether the eye is in it.
struct Body<'a> {
    sphere: &'a Sphere,
    around: bool,
}

impl<'a> Body<'a> {
    fn around_or_not(sphere: &'a Sphere, eye: [f64; 3]) -> Self {
        Self { sphere, around: is_below(power(sphere, eye), || power_of(sphere, eye)) }
    }
}

impl Hides for Body<'_> {
    fn hides(&self, light: [f64; 3]) -> bool {
        let (power, exact) = (power(self.sphere, light), || power_of(self.sphere, light));
        if self.around { is_above(power, exact) } else { is_below(power, exact) }
    }

    fn spares(&self, least: [f64; 3], most: [f64; 3]) -> bool {
        let mut square = 0.0;
        for axis in 0..3 {
            let (below, above) =
                (self.sphere.center[axis] - least[axis], most[axis] - self.sphere.center[axis]);
            let far = larger(below, above);
            let near = larger(larger(-below, -above), 0.0);
            let x = if self.around { far } else { near };
            square += x * x;
        }
        let radius_squared = self.sphere.radius * self.sphere.radius;
        if self.around {
            square * (1.0 + ROOM) < radius_squared
        } else {
            square > radius_squared * (1.0 + ROOM)
        }
    }
}

/// A plane, and on which side the eye is.
struct Half<'a> {
    plane: &'a Plane,
    /// Normal of any length, as [`scaled_height`] takes it.
    normal: [f64; 3],
    below: bool,
}

impl<'a> Half<'a> {
    fn new(plane: &'a Plane, eye: [f64; 3]) -> Self {
        let normal = tamed(plane.normal);
        let below = is_below(height(normal, plane.point, eye), || scaled_height(plane, eye));
        Self { plane, normal, below }
    }
}

impl Hides for Half<'_> {
    fn hides(&self, light: [f64; 3]) -> bool {
        let height = height(self.normal, self.plane.point, light);
        let exact = || scaled_height(self.plane, light);
        if self.below { is_above(height, exact) } else { is_below(height, exact) }
    }

    fn spares(&self, least: [f64; 3], most: [f64; 3]) -> bool {
        // How far the box reaches to the side where lights are hidden.
        let (mut height, mut size) = (0.0, FAINT);
        for axis in 0..3 {
            let n = if self.below { self.normal[axis] } else { -self.normal[axis] };
            let point = self.plane.point[axis];
            let (a, b) = (least[axis] - point, most[axis] - point);
            height += larger(n * a, n * b);
            size += larger((n * a).abs(), (n * b).abs());
        }
        height < -ROOM * size
    }
}

/// A number in f64, and the sum of magnitudes that its error is relative to.
type Near = (f64, f64);

/// |x - c|^2 - r^2 in f64.
fn power(sphere: &Sphere, x: [f64; 3]) -> Near {
    let d: [f64; 3] = std::array::from_fn(|i| x[i] - sphere.center[i]);
    let (square, r) = (d[0] * d[0] + d[1] * d[1] + d[2] * d[2], sphere.radius * sphere.radius);
    (square - r, square + r)
}

/// normal · (x - point) in f64.
fn height(normal: [f64; 3], point: [f64; 3], x: [f64; 3]) -> Near {
    let along: [f64; 3] = std::array::from_fn(|i| normal[i] * (x[i] - point[i]));
    (along[0] + along[1] + along[2], along[0].abs() + along[1].abs() + along[2].abs())
}

/// Whether a number is below 0; `exact` is asked where that is in doubt.
fn is_below((x, size): Near, exact: impl FnOnce() -> DoubleDouble) -> bool {
    if size > FAINT && x.abs() > DOUBT * size { x < 0.0 } else { exact() < DoubleDouble::default() }
}

/// Whether a number is above 0; `exact` is asked where that is in doubt.
fn is_above((x, size): Near, exact: impl FnOnce() -> DoubleDouble) -> bool {
    if size > FAINT && x.abs() > DOUBT * size { x > 0.0 } else { exact() > DoubleDouble::default() }
}

fn larger(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}

/// Lights in a tree of nested boxes.
struct Lights {
    positions: Vec<[f64; 3]>,
    hidden: Vec<bool>,
    /// Indices of lights; the lights of a box stand side by side.
    order: Vec<usize>,
    /// The tree in depth-first order: a box, all boxes of its lower half, all of its upper half.
    boxes: Vec<Node>,
}

struct Node {
    least: [f64; 3],
    most: [f64; 3],
    /// First of the box's lights in `order`.
    first: usize,
    /// End of the box's lights in `order`.
    end: usize,
    /// Index of the first box after this one that is not inside it.
    next: usize,
}

impl Lights {
    fn new(positions: Vec<[f64; 3]>) -> Self {
        let count = positions.len();
        let mut lights = Self {
            positions,
            hidden: vec![false; count],
            order: (0..count).collect(),
            boxes: Vec::new(),
        };
        if count > 0 {
            lights.divide(0, count);
        }
        lights
    }

    /// Adds the box of some lights, and the boxes in it. Recurses as deep as the logarithm of their
    /// number.
    fn divide(&mut self, first: usize, end: usize) {
        let (mut least, mut most) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
        for &light in &self.order[first..end] {
            for (axis, x) in self.positions[light].into_iter().enumerate() {
                least[axis] = if x < least[axis] { x } else { least[axis] };
                most[axis] = larger(x, most[axis]);
            }
        }
        let place = self.boxes.len();
        self.boxes.push(Node { least, most, first, end, next: 0 });
        if end - first > LEAF {
            let extent = |axis: usize| most[axis] - least[axis];
            let axis = (0..3).fold(0, |a, b| if extent(b) > extent(a) { b } else { a });
            let middle = (end - first) / 2;
            let positions = &self.positions;
            self.order[first..end].select_nth_unstable_by(middle, |&a, &b| {
                positions[a][axis].total_cmp(&positions[b][axis])
            });
            self.divide(first, first + middle);
            self.divide(first + middle, end);
        }
        self.boxes[place].next = self.boxes.len();
    }

    /// Asks a primitive about all lights that may be hidden by it.
    fn ask(&mut self, by: &impl Hides, step: &mut impl FnMut()) {
        let mut place = 0;
        while let Some(Node { least, most, first, end, next }) = self.boxes.get(place) {
            let lights = &self.order[*first..*end];
            // With one box of few lights, asking about each light is as fast.
            if self.boxes.len() > 1 {
                step();
                if by.spares(*least, *most) {
                    place = *next;
                    continue;
                }
            }
            place += 1;
            if place == *next {
                for &light in lights {
                    if !self.hidden[light] {
                        step();
                        self.hidden[light] = by.hides(self.positions[light]);
                    }
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{DoubleDouble, hidden_in_steps, power_of, scaled_height};
    use crate::{Draft, Light, MaterialId, Plane, Sphere};

    /// The plain answer: every primitive asked about every light, in double-double.
    fn all_pairs(scene: &Draft) -> Vec<bool> {
        let (zero, eye) = (DoubleDouble::default(), scene.camera.position);
        let apart = |eye, light| if eye < zero { light > zero } else { light < zero };
        let hides = |light: &Light| {
            let light = light.position;
            let by_sphere = |s: &Sphere| apart(power_of(s, eye), power_of(s, light));
            let by_plane = |p: &Plane| apart(scaled_height(p, eye), scaled_height(p, light));
            scene.spheres.iter().any(by_sphere) || scene.planes.iter().any(by_plane)
        };
        scene.lights.iter().map(hides).collect()
    }

    /// A sequence of numbers in [0, 1), the same on every machine.
    struct Draws(u64);

    impl Draws {
        fn next(&mut self) -> f64 {
            self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            (self.0 >> 11) as f64 / (1u64 << 53) as f64
        }

        fn point(&mut self) -> [f64; 3] {
            std::array::from_fn(|_| 2.0 * self.next() - 1.0)
        }
    }

    fn light(position: [f64; 3]) -> Light {
        Light { position, intensity: [1.0; 3] }
    }

    fn ball(center: [f64; 3], radius: f64) -> Sphere {
        Sphere { center, radius, material: MaterialId::at(0) }
    }

    /// Primitives pass through lights and the eye, or a hair beside them, where only double-double
    /// can tell.
    #[test]
    fn what_is_hidden_is_what_all_pairs_say() {
        let mut draws = Draws(3);
        let (mut some, mut none) = (0, 0);
        for round in 0..400 {
            // Eye and lights first, so that primitives can be put through them.
            let mut scene = Draft::default();
            scene.camera.position = draws.point();
            scene.lights = (0..1 + round % 60).map(|_| light(draws.point())).collect();
            let scale = 10f64.powf(-8.0 * draws.next());
            for i in 0..round % 30 {
                let through = match draws.next() {
                    x if x < 0.3 => scene.camera.position,
                    x if x < 0.8 => scene.lights[i % scene.lights.len()].position,
                    _ => draws.point(),
                };
                // Exactly through, less than an ulp beside, some ulps, or clearly apart.
                let off = [0.0, 1e-17, 1e-16, 1e-15, 1e-9][(draws.next() * 5.0) as usize];
                let normal = draws.point();
                let radius = scale * (0.01 + draws.next());
                let length = normal.iter().map(|x| x * x).sum::<f64>().sqrt();
                let at = |way: f64| std::array::from_fn(|k| through[k] + way * normal[k] / length);
                if draws.next() < 0.2 {
                    let normal = if draws.next() < 0.5 { [0.0, 1.0, 0.0] } else { normal };
                    scene.planes.push(Plane {
                        point: at(off),
                        normal,
                        material: MaterialId::at(0),
                    });
                } else {
                    scene.spheres.push(ball(at(radius), radius * (1.0 + off)));
                }
            }
            // One more light that f64 arithmetic cannot tell from the first.
            let first = scene.lights[0].position;
            scene.lights.push(light(first.map(f64::next_up)));
            // Rounds with both answers are counted, or the test could pass on empty scenes.
            let hidden = hidden_in_steps(&scene, &mut || ());
            assert_eq!(hidden, all_pairs(&scene), "round {round}: {scene:?}");
            some += usize::from(hidden.contains(&true));
            none += usize::from(hidden.contains(&false));
        }
        assert!(some > 50 && none > 50, "{some} rounds hide a light, {none} leave one");
    }

    /// Steps grow with primitives and with lights, and not with both.
    #[test]
    fn few_lights_are_asked_about() {
        let mut draws = Draws(5);
        let mut scene = Draft::default();
        scene.camera.position = [9.0; 3];
        scene.lights = (0..1000).map(|_| light(draws.point())).collect();
        scene.spheres = (0..20_000).map(|_| ball(draws.point(), 0.01)).collect();
        // Spheres around everything and planes below everything hide no light.
        scene.spheres.extend((0..2000).map(|i| ball([0.0; 3], 100.0 + f64::from(i))));
        scene.planes = (0..2000)
            .map(|i| Plane {
                point: [0.0, -2.0 - f64::from(i), 0.0],
                normal: [0.1, 1.0, 0.2],
                material: MaterialId::at(0),
            })
            .collect();
        let mut steps = 0;
        let hidden = hidden_in_steps(&scene, &mut || steps += 1);
        assert!(hidden.contains(&true) && hidden.contains(&false));
        let primitives = scene.spheres.len() + scene.planes.len();
        assert!(steps < 40 * primitives, "{steps} steps for {primitives} primitives");
    }
}
