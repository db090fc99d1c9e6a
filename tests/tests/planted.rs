//! Faults planted in a copy of the engine, each of which the identity test must catch.
//!
//! A fault is a line of the engine's source and what replaces it. Lines that are gone make
//! the test fail, so the table stays in step with the code.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use catoptric_tests::scenes::root;

struct Fault {
    name: &'static str,
    file: &'static str,
    line: &'static str,
    instead: &'static str,
}

const FAULTS: &[Fault] = &[
    Fault {
        name: "another order of operations in a dot product",
        file: "vec3.rs",
        line: "self.x * other.x + self.y * other.y + self.z * other.z",
        instead: "self.x * other.x + (self.y * other.y + self.z * other.z)",
    },
    Fault {
        name: "a fused multiply-add where the levels are folded",
        file: "stack.rs",
        line: "local + back * k",
        instead: "{ use catoptric_scene::Scalar; let fuse = |a: L, b: L, c: L| { let (a, b, c) = \
            (a.to_array(), b.to_array(), c.to_array()); L::from_array(std::array::from_fn(\
            |i| Scalar::rounded(a[i].to_f64().mul_add(b[i].to_f64(), c[i].to_f64())))) }; \
            Vec3 { x: fuse(back.x, k, local.x), y: fuse(back.y, k, local.y), \
            z: fuse(back.z, k, local.z) } }",
    },
    Fault {
        name: "a fused multiply-add in a ball's discriminant",
        file: "ball.rs",
        line: "(b, L::splat(ball.radius_squared) - x.dot(x))",
        instead: "let (p, q, r) = (x.x.to_array(), x.y.to_array(), x.z.to_array()); \
            let sum = L::from_array(p) * L::from_array(p) + L::from_array(q) * L::from_array(q); \
            let (sum, f) = (sum.to_array(), catoptric_scene::Scalar::to_f64); \
            (b, L::splat(ball.radius_squared) - L::from_array(std::array::from_fn(\
            |i| catoptric_scene::Scalar::rounded(f(r[i]).mul_add(f(r[i]), f(sum[i]))))))",
    },
    Fault {
        name: "lanes off by one",
        file: "tile.rs",
        line: "columns[lane.min(live - 1) * self.samples + i]",
        instead: "columns[(lane + 1).min(live - 1) * self.samples + i]",
    },
    Fault {
        name: "a tie broken the other way",
        file: "nearest.rs",
        line: "found.met & found.t.lt(best)",
        instead: "found.met & found.t.le(best)",
    },
    Fault {
        name: "a lost tail lane",
        file: "hits.rs",
        line: "for lane in 0..LANES.min(packet.live as usize) {",
        instead: "for lane in 0..(LANES - 1).min(packet.live as usize) {",
    },
    Fault {
        name: "a product with the reciprocal in place of a quotient",
        file: "vec3.rs",
        line: "Self { x: self.x / divisor, y: self.y / divisor, z: self.z / divisor }",
        instead: "self * (L::constant(1.0) / divisor)",
    },
    Fault {
        name: "another form of a reciprocal root",
        file: "ball.rs",
        line: "L::constant(1.0) / x.length()",
        instead: "(L::constant(1.0) / x.dot(x)).sqrt()",
    },
    Fault {
        name: "a mirrored direction that is not made a unit vector again",
        file: "surfaces.rs",
        line: "Numerics::Robust => v * (L::constant(1.5) - L::constant(0.5) * v.dot(v)),",
        instead: "Numerics::Robust => v,",
    },
    Fault {
        name: "the primitive just left is met again",
        file: "ball.rs",
        line: "(b.gt(zero) & discriminant.ge(zero)).without(own)",
        instead: "(b.gt(zero) & discriminant.ge(zero))",
    },
    Fault {
        name: "a ray exactly at the cut is lost",
        file: "shade.rs",
        line: "product.ge(L::splat(world.scene.min_weight))",
        instead: "product.gt(L::splat(world.scene.min_weight))",
    },
    Fault {
        name: "a hidden lamp shines",
        file: "shade.rs",
        line: "lamp.hidden || !faces.any()",
        instead: "!faces.any()",
    },
    Fault {
        name: "lamps summed in another order",
        file: "shade.rs",
        line: "in lamps.lights.iter().zip(lamps.ends) {",
        instead: "in lamps.lights.iter().rev().zip(lamps.ends) {",
    },
    Fault {
        name: "a ball left out of a tile that shows its rim",
        file: "sight.rs",
        line: "self.axis.dot(*axis) >= self.cos * cos - self.sin * sin - MARGIN",
        instead: "self.axis.dot(*axis) >= self.cos * cos - self.sin * sin + 1e-5",
    },
    Fault {
        name: "a flat left out of a tile that shows its horizon",
        file: "sight.rs",
        line: ">= -self.sin - MARGIN",
        instead: ">= 1e-3 - self.sin",
    },
    Fault {
        name: "a shadow ray that is not counted",
        file: "shade.rs",
        line: "*shadow += faces.count();",
        instead: "if !lamp.hidden { *shadow += faces.count(); }",
    },
    Fault {
        name: "a ball left out of a shadow that its rim grazes",
        file: "occluders.rs",
        line: "v.dot(v).gt(limit)",
        instead: "v.dot(v).gt(limit * L::constant(0.9999))",
    },
    Fault {
        name: "a horizon left out of the shadow that it casts",
        file: "occluders.rs",
        line: "least > MARGIN * far",
        instead: "least > -0.1 * far",
    },
    Fault {
        name: "a surface with a highlight and nothing else that no lamp lights",
        file: "plan.rs",
        line: "material.specular == S::ZERO && r == S::ZERO",
        instead: "r == S::ZERO",
    },
    Fault {
        name: "a cut by weight that ends paths one reflection early",
        file: "plan.rs",
        line: "return depth;",
        instead: "return depth.saturating_sub(1);",
    },
    Fault {
        name: "bounds that forget a point",
        file: "surfaces.rs",
        line: "met.wave.packet(packet), distance);\n            (least, most) = (least.least(point), most.most(point));",
        instead: "met.wave.packet(packet), distance);\n            (least, most) = (point, point);",
    },
    Fault {
        name: "a mirrored ray that goes back to another pixel",
        file: "wave.rs",
        line: "self.waiting.parents[to] = parents[from];",
        instead: "self.waiting.parents[to] = parents[0];",
    },
    Fault {
        name: "a single ray with another's distance",
        file: "surfaces.rs",
        line: "self.distance[to] = met.nearest[packet % PACKETS].distance[from];",
        instead: "self.distance[to] = met.nearest[packet % PACKETS].distance[0];",
    },
    Fault {
        name: "f64 only: the lower half in place of the upper one",
        file: "lanes.rs",
        line: "(low | high << 4).cast_unsigned()",
        instead: "{ let _ = high; (low | low << 4).cast_unsigned() }",
    },
    Fault {
        name: "f64 only: a comparison that takes the equal",
        file: "lanes.rs",
        line: "Mask(Self(halves!(_mm256_cmp_pd::<_CMP_LT_OQ>; self.0, other.0)))",
        instead: "Mask(Self(halves!(_mm256_cmp_pd::<_CMP_LE_OQ>; self.0, other.0)))",
    },
    Fault {
        name: "f64 only: a series as short as f32's",
        file: "power.rs",
        line: "horner(L::Scalar::EXP2_SERIES, f)",
        instead: "horner(&L::Scalar::EXP2_SERIES[..8], f)",
    },
    Fault {
        name: "f64 only: the formulas' numbers rounded to f32",
        file: "lanes.rs",
        line: "Self::splat(Scalar::rounded(x))",
        instead: "Self::splat(Scalar::rounded(<f32 as Scalar>::rounded(x).to_f64()))",
    },
];

#[test]
fn every_fault_has_its_line() {
    for fault in FAULTS {
        let file = root().join("crates/core/src").join(fault.file);
        let source = fs::read_to_string(file).expect("the engine's source");
        assert_eq!(source.matches(fault.line).count(), 1, "{}: {:?}", fault.file, fault.line);
    }
}

#[test]
#[ignore = "builds the engine once a fault, 10 to 25 minutes; .ci/run asks for it"]
fn every_planted_fault_is_caught() {
    let copy = tempfile::tempdir().expect("a temporary folder");
    copy_workspace(copy.path());
    let mut missed = Vec::new();
    for fault in FAULTS {
        let file = copy.path().join("crates/core/src").join(fault.file);
        let sound = fs::read_to_string(&file).expect("the engine's source");
        fs::write(&file, sound.replace(fault.line, fault.instead)).expect("the copy is ours");
        let report = run_identity(copy.path());
        fs::write(&file, sound).expect("the copy is ours");

        assert!(report.contains("running "), "{} did not build:\n{report}", fault.name);
        let caught = report.lines().filter(|l| l.starts_with("test ") && l.ends_with("FAILED"));
        let caught: Vec<_> = caught.collect();
        println!("{}: {} tests fail", fault.name, caught.len());
        if caught.is_empty() || !report.contains(" differs, Backend") {
            missed.push(fault.name);
        }
    }
    assert!(missed.is_empty(), "not caught: {missed:#?}");
    let report = run_identity(copy.path());
    assert!(report.contains("test result: ok. "), "the copy without a fault passes:\n{report}");
}

/// What the identity tests of a copy print. Libraries are shared with the running build.
fn run_identity(workspace: &Path) -> String {
    let program = std::env::current_exe().expect("the test has a file");
    let target = program.ancestors().nth(3).expect("target/release/deps/all");
    let output = Command::new(env!("CARGO"))
        .args(["test", "--release", "--offline", "-p", "catoptric-tests", "--test", "all"])
        .arg("identity::")
        .current_dir(workspace)
        .env("CARGO_TARGET_DIR", target)
        .env("PROPTEST_CASES", "1000")
        // That it fails is enough; the smallest scene on which it does is not asked for.
        .env("PROPTEST_MAX_SHRINK_ITERS", "0")
        .output()
        .expect("cargo can be run");
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    text(&output.stderr) + &text(&output.stdout)
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
