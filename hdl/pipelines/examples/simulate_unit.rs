//! Simulates the floating-point adder in rust-hdl: `cargo run -p dualsplit-pipelines --example simulate_unit`.

use pipelines::formats::binary32::FpAdd;
use units::clocking::Clocked;

fn main() {
    let mut adder = FpAdd::default();
    adder.en_i.next = true;
    let pairs = [(1.5, 2.25), (1.0, 1e-8), (f32::MAX, f32::MAX), (f32::INFINITY, f32::NEG_INFINITY)];
    // One pair goes in per cycle; the sum comes out after two rising edges.
    for cycle in 0..pairs.len() + 2 {
        if adder.valid_o.val() {
            let (a, b) = pairs[cycle - 2];
            println!("cycle {cycle}: {a} + {b} = {}", f32::from_bits(adder.result_o.val().to_u32()));
        }
        let pair = pairs.get(cycle);
        adder.valid_i.next = pair.is_some();
        if let Some((a, b)) = pair {
            adder.a_i.next = u64::from(a.to_bits()).into();
            adder.b_i.next = u64::from(b.to_bits()).into();
        }
        adder.tick();
    }
}
