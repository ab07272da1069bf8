//! A mapped netlist as structural Verilog, for tools that time or place it.

use std::fmt::Write;

use super::Mapped;
use crate::liberty::Library;

impl Mapped {
    /// The netlist as one module. Nets are `n` and their number, inputs `i` and outputs `o` and their position, instances `g` and
    /// the gate's position, and `r` and the register's. The clock is `clk`. Set and reset of flip-flops are open, as are
    /// clock gates: a netlist for function has none.
    #[must_use]
    pub fn verilog(&self, library: &Library, name: &str) -> String {
        let list = |letter: char, count: usize| -> Vec<String> {
            (0..count).map(|i| format!("{letter}{i}")).collect()
        };
        let (inputs, outputs) = (list('i', self.inputs.len()), list('o', self.outputs.len()));
        let mut text =
            format!("module {name} (clk, {});\ninput clk;\n", [&inputs[..], &outputs].concat().join(", "));
        inputs.iter().for_each(|input| text += &format!("input {input};\n"));
        outputs.iter().for_each(|output| text += &format!("output {output};\n"));
        let driven = self.gates.iter().map(|gate| gate.output).chain(self.registers.iter().map(|r| r.output));
        for net in driven.chain(self.inputs.iter().copied()) {
            let _ = writeln!(text, "wire n{net};");
        }
        for (input, net) in inputs.iter().zip(&self.inputs) {
            let _ = writeln!(text, "assign n{net} = {input};");
        }
        let net = |net: u32| match net {
            0 => "1'b0".to_owned(),
            1 => "1'b1".to_owned(),
            net => format!("n{net}"),
        };
        for (position, gate) in self.gates.iter().enumerate() {
            let cell = &library.cells[gate.cell];
            let pins =
                cell.inputs.iter().zip(&gate.inputs).map(|(pin, &input)| format!(".{pin}({}), ", net(input)));
            let pins: String = pins.collect();
            let _ = writeln!(text, "{} g{position} ({pins}.{}(n{}));", cell.name, cell.output, gate.output);
        }
        let flip_flop = &library.flip_flop;
        for (position, register) in self.registers.iter().enumerate() {
            let _ = writeln!(
                text,
                "{} r{position} (.{}(clk), .{}({}), .{}(n{}));",
                flip_flop.name,
                flip_flop.clock,
                flip_flop.data,
                net(register.data),
                flip_flop.output,
                register.output
            );
        }
        for (output, &driver) in outputs.iter().zip(&self.outputs) {
            let _ = writeln!(text, "assign {output} = {};", net(driver));
        }
        text + "endmodule\n"
    }
}
