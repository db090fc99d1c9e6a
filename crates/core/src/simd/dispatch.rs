//! Kernels: code written once over [`Lanes`] and compiled for each instruction set.
//!
//! `wide` chooses its instructions when it is compiled, which for a plain build is SSE2. So kernels
//! are compiled twice: over `wide`'s own operations, and over 256-bit AVX2 operations behind one
//! entry that enables them. FMA is not enabled: a fused operation has other bits.
//!
//! Rule: everything between that entry and an operation is `#[inline(always)]`. A function left out
//! of line is compiled without AVX2 and passes its lanes through memory; a test reads the compiled
//! kernel and allows none.
#![expect(unsafe_code, reason = "the one call into AVX2 code, once it is detected")]

use wide::{f32x8, f64x8};

use super::isa::Isa;
use super::lanes::{Lane, Lanes};
use super::portable::Portable;

/// Work that is written over [`Lanes`].
pub(crate) trait Kernel {
    type Scalar: Lane;
    type Output;
    /// Must be `#[inline(always)]`, with all that it calls.
    fn run<L: Lanes<Scalar = Self::Scalar>>(self) -> Self::Output;
}

/// Runs a kernel on an instruction set, lowered to what the processor has.
pub(crate) fn run<K: Kernel>(isa: Isa, kernel: K) -> K::Output {
    match isa.min(Isa::detected()) {
        Isa::Portable => run_portable(kernel),
        #[cfg(target_arch = "x86_64")]
        // SAFETY: `detected` found every feature that the function enables.
        Isa::Avx2 => unsafe { run_avx2(kernel) },
        #[cfg(not(target_arch = "x86_64"))]
        Isa::Avx2 => unreachable!("only detected on x86-64"),
    }
}

#[inline(never)]
fn run_portable<K: Kernel>(kernel: K) -> K::Output {
    kernel.run::<<K::Scalar as Lane>::Portable>()
}

#[cfg(target_arch = "x86_64")]
#[inline(never)]
#[target_feature(enable = "avx2,bmi1,bmi2,popcnt,lzcnt")]
fn run_avx2<K: Kernel>(kernel: K) -> K::Output {
    // Makes the compiler align the stack. It keeps lanes there that find no register, and left
    // alone would put some across two cache lines: a fifth of the time, by luck.
    #[repr(align(64))]
    struct Aligned([u8; 64]);
    let mut aligned = Aligned([0; 64]);
    std::hint::black_box(&mut aligned.0);
    kernel.run::<<K::Scalar as Lane>::Avx2>()
}

impl Lane for f32 {
    type Portable = Portable<f32x8>;
    #[cfg(target_arch = "x86_64")]
    type Avx2 = super::avx2::Avx2<std::arch::x86_64::__m256>;

    #[inline(always)]
    fn from_index(i: u32) -> Self {
        Self::from_bits(i)
    }
    #[inline(always)]
    fn to_index(self) -> u32 {
        self.to_bits()
    }
}

impl Lane for f64 {
    type Portable = Portable<f64x8>;
    #[cfg(target_arch = "x86_64")]
    type Avx2 = super::avx2::Avx2<[std::arch::x86_64::__m256d; 2]>;

    #[inline(always)]
    fn from_index(i: u32) -> Self {
        Self::from_bits(i64::from(i.cast_signed()).cast_unsigned())
    }
    #[inline(always)]
    #[expect(clippy::cast_possible_truncation, reason = "the upper half repeats the sign")]
    fn to_index(self) -> u32 {
        self.to_bits() as u32
    }
}
