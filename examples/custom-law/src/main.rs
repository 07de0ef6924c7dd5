//! The whole `stickslip` command, with one more friction law, failure criterion and point model.

use custom_law as _;

fn main() -> std::process::ExitCode {
    stickslip::cli::main()
}
