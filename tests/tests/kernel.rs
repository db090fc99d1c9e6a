//! The compiled AVX2 kernels, f32 and f64: 256-bit operations, none of them fused, no call left
//! in them.
//!
//! A function that was not inlined under the AVX2 entry would be compiled without AVX2 and
//! pass its lanes through memory, ten times slower; a fused operation would have other bits.

use std::collections::HashMap;
use std::path::Path;
use std::process::Command;

/// The function behind which AVX2 is enabled.
const ENTRY: &str = "catoptric_core::simd::dispatch::run_avx2";

/// What the kernel may call: what does not return, and the stack's growth, which is cold and
/// touches no lanes.
const ALLOWED: [&str; 9] = [
    "core::panicking::",
    "slice_index",
    "unwrap_failed",
    "stack::Stack<S>::grow",
    // Of a film's last columns, fewer than eight.
    "memcpy",
    // By a table of methods: an observer's hooks, where there is one.
    "*0x18(%r",
    "*0x20(%r",
    "*0x28(%r",
    "_Unwind_Resume",
];

#[test]
fn the_avx2_kernels_are_whole() {
    if !cfg!(target_arch = "x86_64") {
        println!("skipped: not x86-64, so there is no AVX2 kernel");
        return;
    }
    let program = std::env::current_exe().expect("the test has a file");
    let Some(code) = objdump(&program, &["-d", "-C", "--no-show-raw-insn"]) else {
        assert!(
            std::env::var_os("CATOPTRIC_REQUIRE_TOOLS").is_none(),
            "objdump is required here and cannot be run"
        );
        println!("skipped: objdump cannot be run (it comes with GNU binutils)");
        return;
    };
    let functions: Vec<Vec<&str>> =
        code.split("\n\n").map(|function| function.trim_start().lines().collect()).collect();
    let is_kernel = |function: &&Vec<&str>| {
        function.first().is_some_and(|line| line.ends_with(">:") && line.contains(ENTRY))
    };
    let kernels: Vec<_> = functions.iter().filter(is_kernel).collect();
    for multiply in ["vmulps", "vmulpd"] {
        let count = |kernel: &&&Vec<&str>| {
            let wide = |l: &&&str| l.contains(multiply) && l.contains("%ymm");
            kernel.iter().filter(wide).count() > 100
        };
        assert_eq!(kernels.iter().filter(count).count(), 1, "kernels that multiply by {multiply}");
    }
    assert_eq!(kernels.len(), 5, "two that trace, two that fill a film, and one that makes levels");
    for kernel in kernels {
        is_whole(&program, kernel);
    }
}

/// A kernel is of 256-bit operations, none of them fused and none a store under a mask, on an
/// aligned stack, and calls nothing out of line.
fn is_whole(program: &Path, kernel: &[&str]) {
    let wide = kernel.iter().filter(|line| line.contains("%ymm")).count();
    assert!(wide > 10, "{ENTRY} has {wide} lines of 256-bit code; was it compiled without AVX2?");

    let fused: Vec<_> =
        kernel.iter().filter(|l| l.contains("\tvfm") || l.contains("\tvfn")).collect();
    assert!(fused.is_empty(), "fused operations: {fused:#?}");

    let masked: Vec<_> = kernel.iter().filter(|line| line.contains("\tvmaskmov")).collect();
    assert!(masked.is_empty(), "stores under a mask: {masked:#?}");
    let aligned = kernel.iter().any(|line| line.contains("\tand ") && line.ends_with("c0,%rsp"));
    assert!(aligned, "the stack of {ENTRY} is not aligned: lanes on it cross cache lines");

    let callees = callees(program, kernel);
    assert!(!callees.is_empty(), "the kernel calls at least a panic");
    let forbidden: Vec<_> = callees
        .iter()
        .filter(|name| !ALLOWED.iter().any(|allowed| name.contains(allowed)))
        .collect();
    assert!(forbidden.is_empty(), "out of line: {forbidden:#?}");
}

/// The names of all that a function calls, directly or through the table of global offsets.
fn callees(program: &Path, function: &[&str]) -> Vec<String> {
    let relocations = objdump(program, &["-R", "-C"]).expect("objdump ran before");
    let symbols = objdump(program, &["-t", "-C"]).expect("objdump ran before");
    let names: HashMap<u64, &str> = symbols.lines().filter_map(symbol).collect();
    let targets: HashMap<u64, &str> = relocations.lines().filter_map(relocation).collect();
    let calls = function.iter().filter(|line| line.contains("\tcall"));
    calls
        .map(|line| {
            let Some((_, slot)) = line.split_once("# ") else {
                return (*line).to_owned();
            };
            let slot = hex(slot.split(' ').next().unwrap_or_default());
            let target = slot.and_then(|slot| targets.get(&slot)).copied().unwrap_or(line);
            match target.strip_prefix("*ABS*+0x").and_then(hex) {
                Some(address) => names.get(&address).copied().unwrap_or(line).to_owned(),
                None => target.to_owned(),
            }
        })
        .collect()
}

/// `ADDRESS FLAGS SECTION<tab>SIZE NAME`.
fn symbol(line: &str) -> Option<(u64, &str)> {
    let (start, end) = line.split_once('\t')?;
    let (_, name) = end.split_once(' ')?;
    Some((hex(start.split(' ').next()?)?, name))
}

/// `SLOT TYPE TARGET`.
fn relocation(line: &str) -> Option<(u64, &str)> {
    let mut words = line.split_whitespace();
    let (slot, _, target) = (words.next()?, words.next()?, words.next()?);
    Some((hex(slot)?, target))
}

fn hex(digits: &str) -> Option<u64> {
    u64::from_str_radix(digits, 16).ok()
}

fn objdump(program: &Path, options: &[&str]) -> Option<String> {
    let output = Command::new("objdump").args(options).arg(program).output().ok()?;
    output.status.success().then(|| String::from_utf8_lossy(&output.stdout).into_owned())
}
