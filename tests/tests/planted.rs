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
        line: "self.local + back * self.k",
        instead: "{ let fuse = |a: L, b: L, c: L| { let (a, b, c) = \
            (a.to_array(), b.to_array(), c.to_array()); L::from_array(std::array::from_fn(\
            |i| a[i].mul_add(b[i], c[i]))) }; Vec3 { x: fuse(back.x, self.k, self.local.x), \
            y: fuse(back.y, self.k, self.local.y), z: fuse(back.z, self.k, self.local.z) } }",
    },
    Fault {
        name: "a fused multiply-add in a ball's discriminant",
        file: "ball.rs",
        line: "let discriminant = L::splat(ball.radius_squared) - x.dot(x);",
        instead: "let (p, q, r) = (x.x.to_array(), x.y.to_array(), x.z.to_array()); \
            let discriminant = L::from_array(std::array::from_fn(|i| ball.radius_squared \
            - r[i].mul_add(r[i], p[i] * p[i] + q[i] * q[i])));",
    },
    Fault {
        name: "lanes off by one",
        file: "tile.rs",
        line: "let rays = eye_rays(scene, L::from_array(columns), L::splat(row));\n        return",
        instead: "let mut columns = columns; columns.rotate_left(1);\n        \
            let rays = eye_rays(scene, L::from_array(columns), L::splat(row));\n        return",
    },
    Fault {
        name: "a tie broken the other way",
        file: "packet.rs",
        line: "distance.met & distance.t.lt(best)",
        instead: "distance.met & distance.t.le(best)",
    },
    Fault {
        name: "a lost tail lane",
        file: "tile.rs",
        line: "Mask::first(live), stack)",
        instead: "Mask::first(live - 1), stack)",
    },
    Fault {
        name: "a product with the reciprocal in place of a quotient",
        file: "tile.rs",
        line: "Ok(Vec3 { x: sum.x / samples, y: sum.y / samples, z: sum.z / samples })",
        instead: "let samples = L::splat(1.0) / samples; Ok(sum * samples)",
    },
    Fault {
        name: "another form of a reciprocal root",
        file: "ball.rs",
        line: "L::splat(1.0) / x.length()",
        instead: "(L::splat(1.0) / x.dot(x)).sqrt()",
    },
    Fault {
        name: "a mirrored direction that is not made a unit vector again",
        file: "shade.rs",
        line: "Numerics::Robust => v * (L::splat(1.5) - L::splat(0.5) * v.dot(v)),",
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
        file: "packet.rs",
        line: "product.ge(L::splat(scene.min_weight))",
        instead: "product.gt(L::splat(scene.min_weight))",
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
        line: "for lamp in &scene.lights {",
        instead: "for lamp in scene.lights.iter().rev() {",
    },
    Fault {
        name: "a ball left out of a tile that shows its rim",
        file: "sight.rs",
        line: "self.axis.dot(*axis) >= self.cos * cos - self.sin * sin - MARGIN",
        instead: "self.axis.dot(*axis) >= self.cos * cos - self.sin * sin + 1e-3",
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
        line: "count.shadow += faces.count();",
        instead: "if !lamp.hidden { count.shadow += faces.count(); }",
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
#[ignore = "builds the engine once a fault, about 4 minutes; .ci/run asks for it"]
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
