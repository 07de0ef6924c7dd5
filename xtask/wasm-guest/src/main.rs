//! The bits of the numbers that a WebAssembly module computes, in hexadecimal, one a line, from a program for this machine without threads.

fn main() {
    for number in stickslip_wasm_guest::numbers() {
        println!("{:016x}", number.to_bits());
    }
}
