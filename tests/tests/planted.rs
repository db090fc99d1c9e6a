//! Faults planted in a copy of the engine, each of which the identity test must catch.
//!
//! A fault names a function of the engine, wherever it stands, and says which expressions in it
//! become what, with holes for what may be called otherwise ([`Change`]). Where a function or an
//! expression is gone the test fails, so the table stays in step with the code. All faults are
//! planted in one copy, `if fault(i) { instead } else { sound }`, built once and run with one of
//! them at a time.

use std::fs;
use std::io::{BufRead, BufReader};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::Instant;

use catoptric_tests::scenes::root;
use catoptric_tests::source::{Change, Place, Source};

/// Names the fault to the copy.
const CHOSEN: &str = "CATOPTRIC_PLANTED_FAULT";

struct Fault {
    name: &'static str,
    /// Function that it is planted in: `name` or `Type::name`, if need be after its module.
    function: &'static str,
    changes: &'static [Change],
}

/// A change of the only expression of that shape.
const fn one(find: &'static str, instead: &'static str) -> Change {
    Change { find, nth: 0, instead }
}

/// A change of the n-th expression of that shape.
const fn nth(nth: usize, find: &'static str, instead: &'static str) -> Change {
    Change { find, nth, instead }
}

const FAULTS: &[Fault] = &[
    Fault {
        name: "another order of operations in a dot product",
        function: "Vec3::dot",
        changes: &[one("$a + $b + $c", "$a + ($b + $c)")],
    },
    Fault {
        name: "a fused multiply-add where the levels are folded",
        function: "fold",
        changes: &[one(
            "$local + $back * $k",
            "{ use catoptric_scene::Scalar; let fuse = |a: L, b: L, c: L| { let (a, b, c) = \
            (a.to_array(), b.to_array(), c.to_array()); L::from_array(std::array::from_fn(\
            |i| Scalar::rounded(a[i].to_f64().mul_add(b[i].to_f64(), c[i].to_f64())))) }; \
            Vec3 { x: fuse($back.x, $k, $local.x), y: fuse($back.y, $k, $local.y), \
            z: fuse($back.z, $k, $local.z) } }",
        )],
    },
    Fault {
        name: "a fused multiply-add in a ball's discriminant",
        function: "RobustSphere::perpendicular",
        changes: &[one(
            "$x.dot($x)",
            "{ let (p, q, r) = ($x.x.to_array(), $x.y.to_array(), $x.z.to_array()); \
            let sum = L::from_array(p) * L::from_array(p) + L::from_array(q) * L::from_array(q); \
            let (sum, f) = (sum.to_array(), catoptric_scene::Scalar::to_f64); \
            L::from_array(std::array::from_fn(\
            |i| catoptric_scene::Scalar::rounded(f(r[i]).mul_add(f(r[i]), f(sum[i]))))) }",
        )],
    },
    Fault {
        name: "lanes off by one",
        function: "Tile::trace",
        changes: &[one("$lane.min($last)", "($lane + 1).min($last)")],
    },
    Fault {
        name: "a tie broken the other way",
        function: "take",
        changes: &[one("$t.lt($best)", "$t.le($best)")],
    },
    Fault {
        name: "a lost tail lane",
        function: "NearestHits::forget_idle",
        changes: &[one("Mask::first($live)", "Mask::first($live - 1)")],
    },
    Fault {
        name: "levels rounded in place of truncated",
        function: "Avx2<__m256>::bytes",
        changes: &[one("_mm256_cvttps_epi32($x)", "_mm256_cvtps_epi32($x)")],
    },
    Fault {
        name: "a product with the reciprocal in place of a quotient",
        function: "Vec3::div",
        changes: &[one("$body", "self * (L::constant(1.0) / $1)")],
    },
    Fault {
        name: "another form of a quotient by a root",
        function: "RobustSphere::arm",
        changes: &[one("$r / $x.length()", "$r * (L::constant(1.0) / $x.length())")],
    },
    Fault {
        name: "a mirrored direction that is not made a unit vector again",
        function: "reflected",
        changes: &[one("$v * ($a - $b * $v.dot($v))", "$v")],
    },
    Fault {
        name: "the primitive just left is met again",
        function: "Foot::without",
        changes: &[one("$own.or_nan($x)", "$x")],
    },
    Fault {
        name: "a ray exactly at the cut is lost",
        function: "spawn_reflected",
        changes: &[one("$product.ge($cut)", "$product.gt($cut)")],
    },
    Fault {
        name: "a hidden lamp shines",
        function: "add_light",
        changes: &[one("$lamp.hidden", "false")],
    },
    Fault {
        name: "lamps summed in another order",
        function: "Shade::visit",
        changes: &[one(
            "$lamps.iter().zip(&*$ends).enumerate()",
            "$lamps.iter().rev().copied().collect::<Vec<_>>().leak().iter().zip(&*$ends).enumerate()",
        )],
    },
    Fault {
        name: "a ball left out of a tile that shows its rim",
        function: "TileCone::meets",
        changes: &[one(
            "$axes >= $a * $b - $c * $d - $margin",
            "$axes >= $a * $b - $c * $d + 1e-5",
        )],
    },
    Fault {
        name: "a flat left out of a tile that shows its horizon",
        function: "TileCone::meets",
        changes: &[one("$axes >= -$sin - $margin", "$axes >= 1e-3 - $sin")],
    },
    Fault {
        name: "a shadow ray that is not counted",
        function: "add_light",
        changes: &[one("$bits.count_ones()", "($bits & 0x7f).count_ones()")],
    },
    Fault {
        name: "a ball left out of a shadow that its rim grazes",
        function: "Occluders::find",
        changes: &[one("$v.dot($v).gt($limit)", "$v.dot($v).gt($limit * L::constant(0.9999))")],
    },
    Fault {
        name: "a cone of shadow that its ball stands out of",
        function: "Cone::new",
        changes: &[one("($radius + $by) / $distance + $spread", "$radius / $distance * 0.999")],
    },
    Fault {
        name: "bounds on a shadow's way that forget what its start is rounded by",
        function: "HitGroups::bounds",
        changes: &[one("$radius + POINT * ($by + $radius)", "$radius")],
    },
    Fault {
        name: "a small surface close to the eye, from afar by the form for its neighbourhood",
        function: "GeneralSphere::discriminant",
        changes: &[one("$far.select($a, $near)", "$near")],
    },
    Fault {
        name: "a ball's normal from its distance",
        function: "RobustSphere::arm",
        changes: &[one(
            "$x - $d * ($g + $s)",
            "{ let _ = ($g, $s); $x * (self.radius / $x.length()) }",
        )],
    },
    Fault {
        name: "a lamp seen from a ball's point as it is rounded",
        function: "add_light",
        changes: &[
            one("$shape.relative($light)", "$light"),
            one("$from - Vec3::from_arrays($arm)", "$from - $1.point(Vec3::from_arrays($arm))"),
        ],
    },
    Fault {
        name: "a cone of shadow that holds beyond its reach",
        function: "shadows_side_by_side",
        changes: &[one(
            "$far | reached::<L>($cones, $n, $points)",
            "reached::<L>($cones, $n, $points)",
        )],
    },
    Fault {
        name: "a horizon left out of the shadow that it casts",
        function: "Horizon::is_left",
        changes: &[one("$least > Self::MARGIN * $far * $by", "$least > -0.1 * $far * $by")],
    },
    Fault {
        name: "a surface with a highlight and nothing else that no lamp lights",
        function: "Shade::visit",
        changes: &[one(
            "$m.is_unlit()",
            "{ let [r, ..]: [S; 3] = $m.diffuse.into(); r == S::ZERO }",
        )],
    },
    Fault {
        name: "a cut by weight that ends paths one reflection early",
        function: "reflections_by",
        changes: &[nth(2, "return $depth", "return $depth.saturating_sub(1)")],
    },
    Fault {
        name: "bounds that forget all lanes but one",
        function: "HitGroups::bounds",
        changes: &[nth(1, "if $b > $most { $b } else { $most }", "$b")],
    },
    Fault {
        name: "a mirrored ray that goes back to another pixel",
        function: "Regroup::add",
        changes: &[one("$group.slots[$to] = $slots[$from]", "$group.slots[$to] = $slots[0]")],
    },
    Fault {
        name: "a single ray with another's distance",
        function: "HitGroups::collect",
        changes: &[one("$met.distance.gather($slots)", "$met.distance.gather(|_| $slots(0))")],
    },
    Fault {
        name: "rays of two materials owed to one",
        function: "ReturnSlot::each",
        changes: &[one(
            "$owed & !Self::FLAG",
            "if Self::packet($1).is_some() { $owed & !Self::FLAG } else { $owed }",
        )],
    },
    Fault {
        name: "a primitive that some packet met is forgotten there",
        function: "Test::one_pass",
        changes: &[one("$found |= 1 << $i", "$found |= 1 << ($i / 2)")],
    },
    Fault {
        name: "a ball that not all rays of a packet meet is forgotten there",
        function: "Test::two_passes",
        changes: &[one("$met.any()", "$met.all()")],
    },
    Fault {
        name: "a lane without a ray whose colour its first lane gets",
        function: "Vec3Column::scatter",
        changes: &[one("LANES - 1 - $i", "$i")],
    },
    Fault {
        name: "rays that met nothing keep an earlier ray's colour",
        function: "trace_bounce",
        changes: &[one("$count.hits < $count.rays", "$count.hits + (LANES as u64) < $count.rays")],
    },
    Fault {
        name: "packets that left two primitives taken for one's",
        function: "RayQueue::add",
        changes: &[one("$1 != $last", "$1 != $last && self.len == 0")],
    },
    Fault {
        name: "a ball left out that stands out of the one around it",
        function: "inside",
        changes: &[one("$d + $r + $gap < $outer", "$d + $r - $gap < $outer")],
    },
    Fault {
        name: "f64 only: the lower half in place of the upper one",
        function: "Avx2<Halves>::signs",
        changes: &[one("$low | $high << 4", "{ let _ = $high; $low | $low << 4 }")],
    },
    Fault {
        name: "f64 only: a comparison that takes the equal",
        function: "Avx2<Halves>::lt",
        changes: &[one("$body", "self.le($1)")],
    },
    Fault {
        name: "f64 only: a series as short as f32's",
        function: "exp2",
        changes: &[one("horner($series, $f)", "horner(&$series[..8], $f)")],
    },
    Fault {
        name: "f64 only: the formulas' numbers rounded to f32",
        function: "Lanes::constant",
        changes: &[one(
            "$body",
            "Self::splat(Scalar::rounded(<f32 as Scalar>::rounded($1).to_f64()))",
        )],
    },
];

#[test]
fn every_fault_has_its_place() {
    let engine = Source::new(&root().join("crates/core/src"));
    for fault in FAULTS {
        assert!(!places(&engine, fault).is_empty());
    }
}

/// Where a fault is planted.
fn places(engine: &Source, fault: &Fault) -> Vec<Place> {
    let place = |change| match engine.place(fault.function, change) {
        Ok(place) => place,
        Err(why) => panic!("{}: {why}", fault.name),
    };
    fault.changes.iter().map(place).collect()
}

#[test]
#[ignore = "builds the engine once more and runs it once a fault, minutes; .ci/run asks for it"]
fn every_planted_fault_is_caught() {
    let folder = target().join("planted");
    let copy = folder.join("workspace");
    if copy.exists() {
        fs::remove_dir_all(&copy).expect("the last copy is ours");
    }
    fs::create_dir_all(&copy).expect("a folder beside the other builds");
    copy_workspace(&copy);
    plant(&copy.join("crates/core/src"));
    let program = build(&copy, &folder.join("target"));
    let mut missed = Vec::new();
    for (fault, i) in FAULTS.iter().zip(1..) {
        let start = Instant::now();
        let caught = run_identity(&program, &copy, i);
        let seconds = start.elapsed().as_secs_f64();
        println!("{} ({seconds:.1} s): {}", fault.name, caught.as_deref().unwrap_or("not caught"));
        if caught.is_none() {
            missed.push(fault.name);
        }
    }
    assert!(missed.is_empty(), "not caught: {missed:#?}");
    let caught = run_identity(&program, &copy, 0);
    assert_eq!(caught, None, "the copy without a fault passes");
}

/// Plants all faults, none of them chosen.
fn plant(source: &Path) {
    let engine = Source::new(source);
    let mut all: Vec<(u32, Place)> = Vec::new();
    for (fault, i) in FAULTS.iter().zip(1..) {
        all.extend(places(&engine, fault).into_iter().map(|place| (i, place)));
    }
    // From the last one of a file on, so that the others stay where they are.
    all.sort_by_key(|(_, place)| (place.file.clone(), place.range.start));
    for pair in all.windows(2) {
        let [(_, a), (_, b)] = pair else { unreachable!("windows of two") };
        assert!(a.file != b.file || a.range.end <= b.range.start, "{a:?} and {b:?} overlap");
    }
    for (i, Place { file, range, sound, instead }) in all.into_iter().rev() {
        let file = source.join(file);
        let mut text = fs::read_to_string(&file).expect("the engine's source");
        let both = if sound.starts_with('{') {
            format!("{{ if crate::fault({i}) {{ {instead} }} else {sound} }}")
        } else {
            format!("(if crate::fault({i}) {{ {instead} }} else {{ {sound} }})")
        };
        text.replace_range(range, &both);
        fs::write(&file, text).expect("the copy is ours");
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

/// The folder that this test was built into.
fn target() -> PathBuf {
    let program = std::env::current_exe().expect("the test has a file");
    program.ancestors().nth(3).expect("target/release/deps/all").to_owned()
}

/// Builds the tests of a copy; their program. In a folder of its own: a later build would take the
/// copy's libraries for its own.
fn build(workspace: &Path, target: &Path) -> PathBuf {
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
