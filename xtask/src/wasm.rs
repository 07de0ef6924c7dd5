//! `cargo xtask wasm`: one scene in a WebAssembly runtime, and without threads, beside the same scene on this machine.
//!
//! The guest, `xtask/wasm-guest`, is built for `wasm32-unknown-unknown` and interpreted. It must list all friction laws, and its numbers
//! must be the native ones; what may differ is the rounding of functions that every platform computes in its own way, such as sines.
//! With `--without-threads` it is also built for this machine without the feature `parallel`, and must have the same bits as this program,
//! which works on several threads.

use std::path::{Path, PathBuf};
use std::process::Command;

use clap::Args;
use stickslip_wasm_guest as guest;
use wasmi::{Engine, Instance, Linker, Module, Store};

use crate::publish::{TaskError, cargo_build, root};

const TARGET: &str = "wasm32-unknown-unknown";

/// Largest difference of a number, over the largest of all.
const BOUND: f64 = 1e-9;

#[derive(Debug, Args)]
pub(crate) struct Options {
    /// Before that, build the guest for this machine without threads, which takes minutes, and compare the bits of its numbers
    #[arg(long)]
    without_threads: bool,
}

/// Builds, runs and compares; fails if an answer differs.
pub(crate) fn main(options: &Options) -> Result<bool, TaskError> {
    if options.without_threads {
        println!("{}", without_threads()?);
    }
    println!("{}", compared(&build()?)?);
    Ok(true)
}

/// Builds the guest, and returns the path of its module.
fn build() -> Result<PathBuf, TaskError> {
    let products = root().join("target");
    let package = [
        "--package",
        "stickslip-wasm-guest",
        "--lib",
        "--target",
        TARGET,
    ];
    if !cargo_build(&root(), &products, &package)?.success() {
        return Err(format!(
            "the guest cannot be built; `rustup target add {TARGET}` adds the target"
        )
        .into());
    }
    let module = products
        .join(TARGET)
        .join("release/stickslip_wasm_guest.wasm");
    Ok(module)
}

/// Builds the guest for this machine, alone and therefore without threads, and compares the bits of its numbers with those of this program.
fn without_threads() -> Result<String, TaskError> {
    // Apart from other builds, which would be replaced by ones without threads.
    let products = root().join("target/alone");
    let package = [
        "--package",
        "stickslip-wasm-guest",
        "--bin",
        "stickslip-wasm-guest",
    ];
    if !cargo_build(&root(), &products, &package)?.success() {
        return Err("the guest without threads cannot be built".into());
    }
    let program = products.join("release/stickslip-wasm-guest");
    let output = Command::new(program.with_extension(std::env::consts::EXE_EXTENSION)).output()?;
    if !output.status.success() {
        return Err(format!("the guest without threads ends with {}", output.status).into());
    }
    let bits = |number: &f64| format!("{:016x}", number.to_bits());
    let own: Vec<String> = guest::numbers().iter().map(bits).collect();
    let text = String::from_utf8(output.stdout)?;
    let others: Vec<&str> = text.lines().collect();
    let equal = own.iter().zip(&others).filter(|(own, other)| own == other);
    let (count, equal) = (own.len(), equal.count());
    if own.is_empty() || count != others.len() || equal != count {
        return Err(format!(
            "without threads {equal} of {count} numbers have the same bits, and there are {}",
            others.len()
        )
        .into());
    }
    Ok(format!(
        "without threads {count} numbers have the same bits"
    ))
}

/// Runs the module and compares its laws and numbers with those of this program.
fn compared(module: &Path) -> Result<String, TaskError> {
    let engine = Engine::default();
    let module = Module::new(&engine, &std::fs::read(module)?)?;
    let mut store = Store::new(&engine, ());
    // A module that imports nothing has no files, clock, threads or terminal.
    let instance = Linker::new(&engine).instantiate_and_start(&mut store, &module)?;
    let mut guest = Guest { instance, store };
    guest.call("initialise")?;

    let laws = guest.laws()?;
    if laws != guest::laws() || laws.is_empty() {
        return Err(format!(
            "laws of the guest: {laws}\nlaws of this program: {}",
            guest::laws()
        )
        .into());
    }
    let numbers = guest.numbers()?;
    let native = guest::numbers();
    if numbers.len() != native.len() || native.is_empty() {
        let (guest, native) = (numbers.len(), native.len());
        return Err(format!("the guest has {guest} numbers, this program {native}").into());
    }
    let difference = difference(&numbers, native);
    // Not-a-number is beyond any bound.
    if difference <= BOUND {
        let (laws, numbers) = (laws.lines().count(), numbers.len());
        Ok(format!(
            "{laws} laws and {numbers} numbers agree; largest difference {difference:.1e} of the largest number"
        ))
    } else {
        Err(
            format!("numbers differ by {difference:.1e} of the largest, more than {BOUND:.0e}")
                .into(),
        )
    }
}

/// Largest difference over the largest number; NaN where one of the numbers is NaN.
fn difference(first: &[f64], second: &[f64]) -> f64 {
    let largest = |most: f64, number: f64| {
        if most.is_nan() || number.abs() <= most {
            most
        } else {
            number.abs()
        }
    };
    let differences = first.iter().zip(second).map(|(a, b)| a - b);
    differences.fold(0.0, largest) / second.iter().copied().fold(0.0, largest)
}

/// A running module.
struct Guest {
    instance: Instance,
    store: Store<()>,
}

impl Guest {
    fn call(&mut self, name: &str) -> Result<(), TaskError> {
        let function = self.instance.get_typed_func::<(), ()>(&self.store, name)?;
        Ok(function.call(&mut self.store, ())?)
    }

    fn count(&mut self, name: &str) -> Result<usize, TaskError> {
        let function = self.instance.get_typed_func::<(), u32>(&self.store, name)?;
        Ok(function.call(&mut self.store, ())? as usize)
    }

    fn laws(&mut self) -> Result<String, TaskError> {
        let (start, length) = (self.count("text_start")?, self.count("text_length")?);
        let memory = self
            .instance
            .get_memory(&self.store, "memory")
            .ok_or("the guest has no memory")?;
        let mut text = vec![0; length];
        memory.read(&self.store, start, &mut text)?;
        Ok(String::from_utf8(text)?)
    }

    fn numbers(&mut self) -> Result<Vec<f64>, TaskError> {
        let count = self.count("solve")?;
        let number = self
            .instance
            .get_typed_func::<u32, f64>(&self.store, "number")?;
        let number = |index| Ok(number.call(&mut self.store, index as u32)?);
        (0..count).map(number).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::difference;

    #[test]
    fn differences_are_relative_and_not_a_number_stays_so() {
        assert_eq!(difference(&[1.0, 4.0], &[2.0, 4.0]), 0.25);
        assert_eq!(difference(&[2.0], &[2.0]), 0.0);
        assert!(difference(&[f64::NAN, 1.0], &[1.0, 1.0]).is_nan());
        assert!(difference(&[1.0, f64::NAN], &[1.0, 1.0]).is_nan());
    }
}
