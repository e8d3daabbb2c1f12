//! A program whose size is measured: see `sizes.sh`.

#![no_main]
#![no_std]

use panic_halt as _;

#[cortex_m_rt::entry]
fn main() -> ! {
    loop {
        core::hint::spin_loop();
    }
}
