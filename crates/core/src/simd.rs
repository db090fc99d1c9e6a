//! Eight lanes on every instruction set. All of `wide`, all intrinsics and all unsafe code stand
//! here.

#[cfg(target_arch = "x86_64")]
mod avx2;
mod bits;
mod dispatch;
mod isa;
mod lanes;
#[cfg(test)]
pub(crate) mod numbers;
mod portable;
mod power;
#[cfg(test)]
mod tests;
mod vec3;

pub(crate) use dispatch::{Kernel, run};
pub use isa::Isa;
pub(crate) use lanes::{LANES, Lane, Lanes, Mask};
pub(crate) use power::power;
pub(crate) use vec3::{Packed, Vec3, in_f64};
