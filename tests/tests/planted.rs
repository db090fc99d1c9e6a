//! Faults planted in a copy of the engine, each of which the identity test must catch.
//!
//! A fault is an expression of the engine's source and what replaces it. Expressions that are gone
//! make the test fail, so the table stays in step with the code. All faults are planted in one
//! copy, `if fault(i) { instead } else { sound }`, built once and run with one of them at a time.

use std::fs;
use std::io::{BufRead, BufReader};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use catoptric_tests::scenes::root;

/// Names the fault to the copy.
const CHOSEN: &str = "CATOPTRIC_PLANTED_FAULT";

struct Fault {
    name: &'static str,
    file: &'static str,
    /// Found once in the file.
    sound: &'static str,
    instead: &'static str,
}

const FAULTS: &[Fault] = &[
    Fault {
        name: "another order of operations in a dot product",
        file: "simd/vec3.rs",
        sound: "self.x * other.x + self.y * other.y + self.z * other.z",
        instead: "self.x * other.x + (self.y * other.y + self.z * other.z)",
    },
    Fault {
        name: "a fused multiply-add where the levels are folded",
        file: "trace/stack.rs",
        sound: "local + back * reflectance",
        instead: "{ use catoptric_scene::Scalar; let fuse = |a: L, b: L, c: L| { let (a, b, c) = \
            (a.to_array(), b.to_array(), c.to_array()); L::from_array(std::array::from_fn(\
            |i| Scalar::rounded(a[i].to_f64().mul_add(b[i].to_f64(), c[i].to_f64())))) }; \
            let k = reflectance; Vec3 { x: fuse(back.x, k, local.x), \
            y: fuse(back.y, k, local.y), z: fuse(back.z, k, local.z) } }",
    },
    Fault {
        name: "a fused multiply-add in a ball's discriminant",
        file: "shape/robust_sphere.rs",
        sound: "self.radius_squared - from_center",
        instead: "{ let (p, q, r) = (x.x.to_array(), x.y.to_array(), x.z.to_array()); \
            let sum = L::from_array(p) * L::from_array(p) + L::from_array(q) * L::from_array(q); \
            let (sum, f) = (sum.to_array(), catoptric_scene::Scalar::to_f64); \
            let _ = from_center; self.radius_squared - L::from_array(std::array::from_fn(\
            |i| catoptric_scene::Scalar::rounded(f(r[i]).mul_add(f(r[i]), f(sum[i]))))) }",
    },
    Fault {
        name: "lanes off by one",
        file: "trace/tile.rs",
        sound: "columns[lane.min(live - 1) * self.samples + i]",
        instead: "columns[(lane + 1).min(live - 1) * self.samples + i]",
    },
    Fault {
        name: "a tie broken the other way",
        file: "trace/nearest.rs",
        sound: "found.met & found.t.lt(best)",
        instead: "found.met & found.t.le(best)",
    },
    Fault {
        name: "a lost tail lane",
        file: "trace/nearest.rs",
        sound: "Mask::first(queue.live(packet))",
        instead: "Mask::first(queue.live(packet) - 1)",
    },
    Fault {
        name: "levels rounded in place of truncated",
        file: "simd/avx2.rs",
        sound: "_mm256_cvttps_epi32(lanes.0)",
        instead: "_mm256_cvtps_epi32(lanes.0)",
    },
    Fault {
        name: "a product with the reciprocal in place of a quotient",
        file: "simd/vec3.rs",
        sound: "Self { x: self.x / divisor, y: self.y / divisor, z: self.z / divisor }",
        instead: "self * (L::constant(1.0) / divisor)",
    },
    Fault {
        name: "another form of a quotient by a root",
        file: "shape/robust_sphere.rs",
        sound: "self.radius / x.length()",
        instead: "self.radius * (L::constant(1.0) / x.length())",
    },
    Fault {
        name: "a mirrored direction that is not made a unit vector again",
        file: "trace/shade.rs",
        sound: "v * (L::constant(1.5) - L::constant(0.5) * v.dot(v))",
        instead: "v",
    },
    Fault {
        name: "the primitive just left is met again",
        file: "shape/foot.rs",
        sound: "on_self.or_nan(self.discriminant)",
        instead: "self.discriminant",
    },
    Fault {
        name: "a ray exactly at the cut is lost",
        file: "trace/shade.rs",
        sound: "product.ge(L::splat(min_weight))",
        instead: "product.gt(L::splat(min_weight))",
    },
    Fault {
        name: "a hidden lamp shines",
        file: "trace/light.rs",
        sound: "light.hidden",
        instead: "false",
    },
    Fault {
        name: "lamps summed in another order",
        file: "trace/shade.rs",
        sound: "lights.iter().zip(&*ends)",
        instead: "lights.iter().rev().copied().collect::<Vec<_>>().leak().iter().zip(&*ends)",
    },
    Fault {
        name: "a ball left out of a tile that shows its rim",
        file: "cull/tile.rs",
        sound: "self.axis.dot(*axis) >= self.cos * cos - self.sin * sin - MARGIN",
        instead: "self.axis.dot(*axis) >= self.cos * cos - self.sin * sin + 1e-5",
    },
    Fault {
        name: "a flat left out of a tile that shows its horizon",
        file: "cull/tile.rs",
        sound: "self.axis.dot(*axis) >= -self.sin - MARGIN",
        instead: "self.axis.dot(*axis) >= 1e-3 - self.sin",
    },
    Fault {
        name: "a shadow ray that is not counted",
        file: "trace/light.rs",
        sound: "(faces.bits() & ((1 << at.live) - 1)).count_ones()",
        instead: "if light.hidden { 0 } else { (faces.bits() & ((1 << at.live) - 1)).count_ones() }",
    },
    Fault {
        name: "a ball left out of a shadow that its rim grazes",
        file: "cull/shadow.rs",
        sound: "v.dot(v).gt(limit)",
        instead: "v.dot(v).gt(limit * L::constant(0.9999))",
    },
    Fault {
        name: "a cone of shadow that its ball stands out of",
        file: "cull/shadow.rs",
        sound: "(radius + POINT * light.length()) / distance + SPREAD",
        instead: "radius / distance * 0.999",
    },
    Fault {
        name: "bounds on a shadow's way that forget what its start is rounded by",
        file: "trace/hit_groups.rs",
        sound: "radius + POINT * (center.length() + radius)",
        instead: "radius",
    },
    Fault {
        name: "a small surface close to the eye, from afar by the form for its neighbourhood",
        file: "shape/general_sphere.rs",
        sound: "far.select(one - across.dot(across), near)",
        instead: "near",
    },
    Fault {
        name: "a ball's normal from its distance",
        file: "shape/robust_sphere.rs",
        sound: "x - rays.direction * (g + s)",
        instead: "{ let _ = (g, s); x * (self.radius / x.length()) }",
    },
    Fault {
        name: "a lamp seen from a ball's point as it is rounded",
        file: "trace/light.rs",
        sound: "position - Vec3::from_arrays(&group.arm)",
        instead: "Vec3::splat(light.position) - shape.point(Vec3::from_arrays(&group.arm))",
    },
    Fault {
        name: "a cone of shadow that holds beyond its reach",
        file: "trace/shadow.rs",
        sound: "far | reached::<L>(cones, number, points)",
        instead: "reached::<L>(cones, number, points)",
    },
    Fault {
        name: "a horizon left out of the shadow that it casts",
        file: "shape/horizon.rs",
        sound: "least > Self::MARGIN * far * (curvature * (q.length() + radius) + lean.length())",
        instead: "least > -0.1 * far * (curvature * (q.length() + radius) + lean.length())",
    },
    Fault {
        name: "a surface with a highlight and nothing else that no lamp lights",
        file: "trace/shade.rs",
        sound: "material.is_unlit()",
        instead: "{ let [r, ..]: [S; 3] = material.diffuse.into(); r == S::ZERO }",
    },
    Fault {
        name: "a cut by weight that ends paths one reflection early",
        file: "plan/reflections.rs",
        sound: "return depth",
        instead: "return depth.saturating_sub(1)",
    },
    Fault {
        name: "bounds that forget all lanes but one",
        file: "trace/hit_groups.rs",
        sound: "if b > most { b } else { most }",
        instead: "b",
    },
    Fault {
        name: "a mirrored ray that goes back to another pixel",
        file: "trace/regroup.rs",
        sound: "self.slots[to] = slots[lane]",
        instead: "self.slots[to] = slots[0]",
    },
    Fault {
        name: "a single ray with another's distance",
        file: "trace/hit_groups.rs",
        sound: "nearest.distance.gather(slots)",
        instead: "nearest.distance.gather(|_| slots(0))",
    },
    Fault {
        name: "rays of two materials owed to one",
        file: "trace/pending.rs",
        sound: "Self(slot.0 & !Self::FLAG).at(material)",
        instead: "Self(if packet { slot.0 & !Self::FLAG } else { slot.0 }).at(material)",
    },
    Fault {
        name: "a primitive that some packet met is forgotten there",
        file: "trace/nearest.rs",
        sound: "met |= 1 << i",
        instead: "met |= 1 << (i / 2)",
    },
    Fault {
        name: "a ball that not all rays of a packet meet is forgotten there",
        file: "trace/nearest.rs",
        sound: "u64::from(foot.met().any())",
        instead: "u64::from(foot.met().all())",
    },
    Fault {
        name: "a lane without a ray whose colour its first lane gets",
        file: "ray/column.rs",
        sound: "LANES - 1 - i",
        instead: "i",
    },
    Fault {
        name: "rays that met nothing keep an earlier ray's colour",
        file: "trace/wavefront.rs",
        sound: "count.hits < count.rays",
        instead: "count.hits + (LANES as u64) < count.rays",
    },
    Fault {
        name: "packets that left two primitives taken for one's",
        file: "ray/queue.rs",
        sound: "from != self.from_last",
        instead: "from != self.from_last && self.len == 0",
    },
    Fault {
        name: "a ball left out that stands out of the one around it",
        file: "plan/nested.rs",
        sound: "outer.0.distance(center) + radius + gap < outer.1",
        instead: "outer.0.distance(center) + radius - gap < outer.1",
    },
    Fault {
        name: "f64 only: the lower half in place of the upper one",
        file: "simd/avx2.rs",
        sound: "(low | high << 4).cast_unsigned()",
        instead: "{ let _ = high; (low | low << 4).cast_unsigned() }",
    },
    Fault {
        name: "f64 only: a comparison that takes the equal",
        file: "simd/avx2.rs",
        sound: "Mask(Self(halves!(_mm256_cmp_pd::<_CMP_LT_OQ>; self.0, other.0)))",
        instead: "Mask(Self(halves!(_mm256_cmp_pd::<_CMP_LE_OQ>; self.0, other.0)))",
    },
    Fault {
        name: "f64 only: a series as short as f32's",
        file: "simd/power.rs",
        sound: "horner(L::Scalar::EXP2_SERIES, f)",
        instead: "horner(&L::Scalar::EXP2_SERIES[..8], f)",
    },
    Fault {
        name: "f64 only: the formulas' numbers rounded to f32",
        file: "simd/lanes.rs",
        sound: "Self::splat(Scalar::rounded(x))",
        instead: "Self::splat(Scalar::rounded(<f32 as Scalar>::rounded(x).to_f64()))",
    },
];

#[test]
fn every_fault_has_its_place() {
    for fault in FAULTS {
        let file = root().join("crates/core/src").join(fault.file);
        let source = fs::read_to_string(file).expect("the engine's source");
        assert_eq!(source.matches(fault.sound).count(), 1, "{}: {:?}", fault.file, fault.sound);
    }
}

#[test]
#[ignore = "builds the engine once more and runs it once a fault, minutes; .ci/run asks for it"]
fn every_planted_fault_is_caught() {
    let copy = tempfile::tempdir().expect("a temporary folder");
    copy_workspace(copy.path());
    plant(&copy.path().join("crates/core/src"));
    let program = build(copy.path());
    let mut missed = Vec::new();
    for (fault, i) in FAULTS.iter().zip(1..) {
        let caught = run_identity(&program, copy.path(), i);
        println!("{}: {}", fault.name, caught.as_deref().unwrap_or("not caught"));
        if caught.is_none() {
            missed.push(fault.name);
        }
    }
    assert!(missed.is_empty(), "not caught: {missed:#?}");
    let caught = run_identity(&program, copy.path(), 0);
    assert_eq!(caught, None, "the copy without a fault passes");
}

/// Plants all faults, none of them chosen.
fn plant(source: &Path) {
    for (fault, i) in FAULTS.iter().zip(1..) {
        let file = source.join(fault.file);
        let text = fs::read_to_string(&file).expect("the engine's source");
        let Fault { sound, instead, .. } = fault;
        let both = format!("(if crate::fault({i}) {{ {instead} }} else {{ {sound} }})");
        fs::write(&file, text.replace(sound, &both)).expect("the copy is ours");
    }
    let file = source.join("lib.rs");
    let lib = fs::read_to_string(&file).expect("the engine's source");
    let chosen = format!(
        "static CHOSEN: std::sync::LazyLock<u32> = std::sync::LazyLock::new(|| \
         std::env::var({CHOSEN:?}).ok().and_then(|chosen| chosen.parse().ok()).unwrap_or(0));\n\
         #[inline(always)]\npub(crate) fn fault(i: u32) -> bool {{ *CHOSEN == i }}\n"
    );
    fs::write(&file, lib + &chosen).expect("the copy is ours");
}

/// Builds the tests of a copy; their program. Libraries are shared with the running build.
fn build(workspace: &Path) -> PathBuf {
    let program = std::env::current_exe().expect("the test has a file");
    let target = program.ancestors().nth(3).expect("target/release/deps/all");
    let output = Command::new(env!("CARGO"))
        .args(["test", "--release", "--offline", "-p", "catoptric-tests", "--test", "all"])
        .args(["--no-run", "--message-format", "json-render-diagnostics"])
        .current_dir(workspace)
        .env("CARGO_TARGET_DIR", target)
        .output()
        .expect("cargo can be run");
    let messages = String::from_utf8_lossy(&output.stdout);
    let program = messages
        .lines()
        .rev()
        .find_map(|line| line.split_once("\"executable\":\"")?.1.split('"').next());
    let errors = String::from_utf8_lossy(&output.stderr);
    program.unwrap_or_else(|| panic!("the copy does not build:\n{errors}")).into()
}

/// What the identity tests of a copy with one fault say first, if they find that bits differ.
fn run_identity(program: &Path, workspace: &Path, fault: usize) -> Option<String> {
    let mut tests = Command::new(program)
        .args(["identity::", "--nocapture"])
        .current_dir(workspace.join("tests"))
        .env(CHOSEN, fault.to_string())
        .env("PROPTEST_CASES", "1000")
        // That it fails is enough; the smallest scene on which it does is not asked for.
        .env("PROPTEST_MAX_SHRINK_ITERS", "0")
        .stdout(Stdio::null())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the copy's tests can be run");
    let said = BufReader::new(tests.stderr.take().expect("a pipe")).lines();
    let differs = said.map_while(Result::ok).find(|line| line.contains(" differs, Backend"));
    if differs.is_some() {
        tests.kill().expect("the tests can be stopped");
    }
    let ended = tests.wait().expect("the tests were started");
    assert!(differs.is_some() || ended.success(), "fault {fault}: tests fail for another reason");
    differs
}

fn copy_workspace(to: &Path) {
    for name in ["Cargo.toml", "Cargo.lock", "crates", "tests", "benches", "scenes"] {
        copy(&root().join(name), &to.join(name));
    }
}

fn copy(from: &Path, to: &PathBuf) {
    if from.is_dir() {
        fs::create_dir(to).expect("the copy is ours");
        for entry in fs::read_dir(from).expect("a folder of the workspace") {
            let entry = entry.expect("an entry");
            copy(&entry.path(), &to.join(entry.file_name()));
        }
    } else {
        fs::copy(from, to).expect("a file of the workspace");
    }
}
