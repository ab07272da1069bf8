//! Self-checking testbenches and their vectors.
//!
//! One line of the vector file is one clock cycle: all inputs in order of declaration, then the outputs expected once
//! they have settled and before the rising edge, concatenated and written in hex. The first lines of a registered module expect
//! what its registers hold at the [`Start`].

use std::fmt::Write;

use super::constant::constant;
use super::emit::range;
use super::identifier::{CLOCK, Namespace, RESET, port_names};
use super::{Checker, Form};
use crate::{Design, ElaborateError, Evaluator, flatten, register_depths};

/// What a testbench does before the first vector.
///
/// Registers without initial value are unknown at first, and reset clears the valid bits only. So reset lasts until known
/// operands have gone through all registers.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Start {
    /// Clock cycles in reset; none if there is no reset.
    reset_cycles: u32,
    /// The inputs in these cycles.
    inputs: Vec<u128>,
}

impl Start {
    /// That of a design's Verilog in this form: all inputs zero but the clock enable.
    ///
    /// # Errors
    /// When the design has a combinational loop.
    pub fn of(design: &Design, form: &Form) -> Result<Self, ElaborateError> {
        if !form.resets(design) {
            return Ok(Self::default());
        }
        let flat = flatten(design)?;
        let depths = register_depths(&flat).unwrap_or_default();
        let deepest = depths.iter().flatten().map(|&(_, most)| most).max();
        let inputs = flat.inputs.iter().map(|port| u128::from(port.name == "en_i")).collect();
        Ok(Self { reset_cycles: deepest.unwrap_or(1), inputs })
    }
}

/// The vector file for a stimulus: each item gives the values of all inputs in one cycle, in order. The expected
/// outputs come from the interpreter of the netlist.
///
/// # Errors
/// When the design has a combinational loop.
pub fn vectors(
    design: &Design,
    start: &Start,
    stimulus: impl IntoIterator<Item = Vec<u128>>,
) -> Result<String, ElaborateError> {
    let flat = flatten(design)?;
    let mut evaluator = Evaluator::new(&flat);
    for _ in 0..start.reset_cycles {
        evaluator.cycle(&start.inputs);
    }
    let mut text = String::new();
    for inputs in stimulus {
        let outputs = evaluator.cycle(&inputs);
        let ports = flat.inputs.iter().chain(flat.outputs.iter().map(|(port, _)| port));
        let words: Vec<(u128, u32)> =
            inputs.iter().chain(&outputs).zip(ports).map(|(&value, port)| (value, port.width)).collect();
        text.push_str(&hex_line(&words));
    }
    Ok(text)
}

/// The concatenation of words, first word highest, in hex, with a line end.
#[must_use]
pub fn hex_line(words: &[(u128, u32)]) -> String {
    let mut digits: Vec<u8> = Vec::new();
    let (mut digit, mut filled) = (0u8, 0);
    for &(value, width) in words.iter().rev() {
        for bit in 0..width {
            digit |= ((value >> bit & 1) as u8) << filled;
            filled += 1;
            if filled == 4 {
                digits.push(digit);
                (digit, filled) = (0, 0);
            }
        }
    }
    if filled > 0 {
        digits.push(digit);
    }
    let mut line: String =
        digits.iter().rev().filter_map(|&digit| char::from_digit(u32::from(digit), 16)).collect();
    line.push('\n');
    line
}

/// The testbench of a design's top, in SystemVerilog for its `$fatal`. Without plus arguments it reads `<top>_vectors.hex` of
/// `count` lines; `+vectors=FILE +count=N` give another file. It prints `PASS` or `FAIL` with the number of mismatches, and each
/// of the first ten mismatches, to which an assertion of the checker counts, if there is one. After `FAIL`, the simulator ends with another exit code than 0.
#[must_use]
pub fn testbench(design: &Design, start: &Start, checker: Option<&Checker>, count: u64) -> String {
    let top = design.top();
    let ports = port_names(top, &mut Namespace::default());
    let inputs: Vec<(&String, u32)> =
        ports.inputs.iter().zip(top.inputs.iter().map(|port| port.width)).collect();
    let outputs: Vec<(&String, u32)> =
        ports.outputs.iter().zip(top.outputs.iter().map(|(port, _)| port.width)).collect();
    let total: u32 = inputs.iter().chain(&outputs).map(|(_, width)| width).sum();
    let name = &top.name;
    let mut text = format!(
        "// Self-checking testbench of {name}: one vector per clock cycle, inputs and then expected outputs.\n\
         // Plus arguments: +vectors=FILE +count=N. A failure ends the simulation by $fatal, with an exit code that is not 0.\n\
         \n\
         module {name}_tb;\n    parameter integer CAPACITY = {count};\n\n"
    );
    let _ = writeln!(text, "    reg [{}:0] vectors [CAPACITY];", total - 1);
    let _ = writeln!(text, "    reg [{}:0] vector;", total - 1);
    text.push_str("    reg [8*1024-1:0] path;\n    integer count, index, mismatches;\n");
    let _ = writeln!(text, "    reg {CLOCK};");
    let has_reset = start.reset_cycles > 0;
    if has_reset {
        let _ = writeln!(text, "    reg {RESET};");
    }
    let mut offset = total;
    let mut slices = Vec::new();
    for (_, width) in inputs.iter().chain(&outputs) {
        offset -= width;
        slices.push(if *width == 1 {
            format!("vector[{offset}]")
        } else {
            format!("vector[{}:{offset}]", offset + width - 1)
        });
    }
    for (position, ((port, width), slice)) in inputs.iter().zip(&slices).enumerate() {
        let value = match start.inputs.get(position) {
            Some(&value) => format!("{RESET} ? {slice} : {}", constant(value, *width)),
            None => slice.clone(),
        };
        let _ = writeln!(text, "    wire {}{port} = {value};", range(*width));
    }
    for ((port, width), slice) in outputs.iter().zip(&slices[inputs.len()..]) {
        let _ = writeln!(text, "    wire {}{port};", range(*width));
        let _ = writeln!(text, "    wire {}expected_{port} = {slice};", range(*width));
    }
    let clock = top.clock.iter().map(|_| CLOCK.to_owned());
    let reset = has_reset.then(|| RESET.to_owned());
    let names = clock.chain(reset).chain(ports.inputs.iter().cloned()).chain(ports.outputs.iter().cloned());
    let connections: Vec<String> = names.map(|port| format!("        .{port}({port})")).collect();
    let _ = write!(text, "\n    {name} dut (\n{}\n    );\n", connections.join(",\n"));
    let mut differs: Vec<String> =
        ports.outputs.iter().map(|port| format!("({port} !== expected_{port})")).collect();
    if let Some(checker) = checker {
        let ports =
            [CLOCK, RESET].into_iter().chain(checker.ports.iter().map(String::as_str)).chain(["holds_o"]);
        let connections: Vec<String> = ports.map(|port| format!("        .{port}({port})")).collect();
        let _ = write!(
            text,
            "\n    wire holds_o;\n    {name}_checker assertions (\n{}\n    );\n",
            connections.join(",\n")
        );
        differs.push("(holds_o !== 1'b1)".to_owned());
    }
    let formats: Vec<String> = ports.outputs.iter().map(|port| format!("{port} %h (%h)")).collect();
    let values: Vec<String> = ports.outputs.iter().map(|port| format!("{port}, expected_{port}")).collect();
    let _ = write!(
        text,
        r#"
    initial begin
        if (!$value$plusargs("vectors=%s", path)) path = "{name}_vectors.hex";
        if (!$value$plusargs("count=%d", count)) count = CAPACITY;
        $readmemh(path, vectors, 0, count - 1);
        mismatches = 0;
        index = {first};
        vector = vectors[0];
        {CLOCK} = 1'b0;{reset}
    end

    always #5 {CLOCK} = ~{CLOCK};

    always @(posedge {CLOCK}){guard} begin
        if (^vector === 1'bx) begin
            $display("FAIL: vector %0d is missing", index);
            $fatal(1);
        end
        if ({differs}) begin
            mismatches = mismatches + 1;
            if (mismatches <= 10)
                $display("vector %0d: {formats}", index,
                    {values});
        end
        index = index + 1;
        if (index < count) vector <= vectors[index];
        else begin
            if (mismatches == 0) $display("PASS: {name}, %0d vectors", count);
            else begin
                $display("FAIL: {name}, %0d of %0d vectors differ", mismatches, count);
                $fatal(1);
            end
            $finish;
        end
    end
endmodule
"#,
        first = if has_reset { format!("-{}", start.reset_cycles) } else { "0".to_owned() },
        reset = if has_reset { format!("\n        {RESET} = 1'b0;") } else { String::new() },
        guard = match has_reset {
            true => format!(
                "\n    if (index < 0) begin\n        index = index + 1;\n        if (index == 0) {RESET} <= 1'b1;\n    end else"
            ),
            false => String::new(),
        },
        differs = differs.join(" || "),
        formats = formats.join(", "),
        values = values.join(", "),
    );
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_is_the_concatenation_in_hex() {
        assert_eq!(hex_line(&[(0x5, 3), (0x1, 1), (0xabc, 12)]), "babc\n");
        assert_eq!(hex_line(&[(1, 1), (0x7f, 7), (1, 2)]), "3fd\n");
        assert_eq!(hex_line(&[(u128::MAX, 128), (0, 3)]), format!("7{}8\n", "f".repeat(31)));
    }
}
