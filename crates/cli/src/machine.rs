//! What this machine offers: instruction sets, threads and their stacks, memory.

mod cgroup;
mod limits;
mod threads;

use std::env;

use catoptric_core::Isa;

use crate::exit::Failure;
pub(crate) use cgroup::memory_left;
pub(crate) use threads::{STACK, Wanted, available as available_threads, on_enough_stack};

/// The instruction set that `CATOPTRIC_ISA` asks for, lowered to what the processor has.
/// Empty is as good as not set.
///
/// # Errors
/// Exit code 2 for an unknown name.
pub(crate) fn instruction_set() -> Result<Isa, Failure> {
    let best = Isa::detected();
    let asked = env::var_os("CATOPTRIC_ISA").unwrap_or_default();
    if asked.is_empty() {
        return Ok(best);
    }
    match asked.to_str().and_then(Isa::named) {
        Some(isa) => Ok(isa.min(best)),
        None => {
            let known = Isa::ALL.map(Isa::name).join(" and ");
            let asked = asked.display();
            Err(Failure::wrong_use(format_args!(
                "CATOPTRIC_ISA is {asked:?}: allowed are {known}; unset it for the best of this processor"
            )))
        }
    }
}
