//! A clock of processor time, so that a budget ends where it would on an idle machine.

use std::io;
use std::path::Path;

use stickslip::host::HOST as MACHINE;
use stickslip::scene::host::{Host, System};
use stickslip_laboratory::measure::thread_seconds;

/// The machine with the processor time of the thread for a clock.
pub(super) const HOST: Host = Host {
    system: &Processor,
    ..MACHINE
};

#[derive(Debug)]
struct Processor;

impl System for Processor {
    fn read(&self, path: &Path, most: u64) -> io::Result<Vec<u8>> {
        MACHINE.system.read(path, most)
    }

    fn length(&self, path: &Path) -> io::Result<u64> {
        MACHINE.system.length(path)
    }

    fn seconds(&self) -> f64 {
        thread_seconds().unwrap_or_else(|| MACHINE.seconds())
    }
}
