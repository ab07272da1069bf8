//! Writes the Verilog of the binary16 multiplier to stdout: `cargo run -p hdl --example export > fp_mul.v`.
//!
//! `dualsplit export` adds testbench, vectors, scripts and a README.

use hdl::catalogue::{StandardFormat, Top};
use hdl::verilog::text;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    print!("{}", text(&Top::FpMul.design(StandardFormat::Binary16)?));
    Ok(())
}
