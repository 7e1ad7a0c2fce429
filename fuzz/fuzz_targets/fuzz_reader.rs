//! libFuzzer on the reader that `CDPR_FUZZ` names; `make fuzz` runs all of them.

#![no_main]

use std::sync::LazyLock;

use cdpr_fuzz::{MEMORY, Memory, Reader, reader};
use libfuzzer_sys::fuzz_target;

#[global_allocator]
static ALLOCATOR: Memory = Memory::new(std::alloc::System, MEMORY);

static READER: LazyLock<Reader> = LazyLock::new(|| {
    let name = std::env::var("CDPR_FUZZ").expect("CDPR_FUZZ names a reader");
    reader(&name)
});

fuzz_target!(|bytes: &[u8]| (READER.read)(bytes));
