//! Constants as Verilog writes them.

/// A sized constant.
#[must_use]
pub fn constant(value: u128, width: u32) -> String {
    match (width, value) {
        (1, _) => format!("1'b{value}"),
        (_, 0..10) => format!("{width}'d{value}"),
        _ => format!("{width}'h{value:x}"),
    }
}
