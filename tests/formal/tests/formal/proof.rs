//! One proof: two sides in Verilog, brought into the same form by yosys, compared by ABC.

use netlist::verilog::{Namespace, plain, port_names, text};
use netlist::{Design, Instance, Module};
use pipelines::catalogue::StandardFormat;
use std::fmt::Write;
use testing::tools::prove;

/// The references, in Verilog.
const FOLDER: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/verilog");

/// What a proof leaves out: a black box, whose operands are proved equal on both sides and whose results are any words.
#[derive(Clone, Copy, PartialEq)]
pub enum LeftOut {
    /// Nothing.
    Nothing,
    /// The multiplier's arrays. Their results are any words that products can be.
    Products,
    /// Adders and multipliers.
    Arithmetic,
}

/// The top of `design` against a reference.
pub struct Proof<'d> {
    pub design: &'d Design,
    pub format: StandardFormat,
    /// Modules `gold` and `gate`, with equal ports.
    pub sides: String,
    /// Files of `FOLDER` that are read besides the units' references.
    pub files: &'static [&'static str],
    pub left_out: LeftOut,
}

impl LeftOut {
    fn includes(self, module: &Module) -> bool {
        let kinds: &[&str] = match self {
            Self::Nothing => &[],
            Self::Products => netlist::module::MULTIPLIER_KINDS,
            Self::Arithmetic => &["fp_add", "fp_mul"],
        };
        kinds.contains(&module.kind.as_str())
    }
}

impl Proof<'_> {
    /// Whether both sides are equal for all inputs.
    pub fn run(&self) -> Result<(), String> {
        let folder = tempfile::tempdir().unwrap();
        let write = |name: &str, text: &str| std::fs::write(folder.path().join(name), text).unwrap();
        write("unit.v", &text(self.design));
        write("sides.v", &self.sides);
        write("stubs.v", &self.stubs());
        write("proof.ys", &self.script());
        prove(folder.path(), "proof.ys", "cec")
    }

    fn boxes(&self) -> impl Iterator<Item = &Module> {
        self.design.modules.iter().filter(|module| self.left_out.includes(module))
    }

    /// Adders and multipliers with any result, in place of those that are left out.
    fn stubs(&self) -> String {
        let mut stubs = String::new();
        if self.left_out != LeftOut::Arithmetic {
            return stubs;
        }
        for module in self.boxes() {
            let _ = writeln!(stubs, "module {} (\n    {}\n);", module.name, ports(module).join(",\n    "));
            for output in port_names(module, &mut Namespace::default()).outputs {
                let _ = match output.strip_suffix("_o") {
                    Some("result") => writeln!(stubs, "    wire [31:0] free;\n    assign result_o = free;"),
                    name => writeln!(stubs, "    assign {output} = {}_i;", name.unwrap_or_default()),
                };
            }
            stubs.push_str("endmodule\n");
        }
        stubs
    }

    fn script(&self) -> String {
        let mut script =
            format!("read_verilog {FOLDER}/transparent.v\ndesign -stash map\nread_verilog unit.v\n");
        for module in self.boxes() {
            let _ = writeln!(script, "delete {}", module.name);
        }
        let top = &self.design.top().name;
        let mut read = |what: &str| {
            let _ = writeln!(script, "read_verilog -sv -I{FOLDER} -D TOP={top} {what}");
        };
        for file in ["units.v", "any_result.v"].iter().chain(self.files) {
            read(&format!("{FOLDER}/{file}"));
        }
        read("stubs.v sides.v");
        if self.left_out == LeftOut::Products {
            let bits = self.format.format().significand_bits();
            let half = bits.div_ceil(2);
            let mut any = |name: &str, low: u32, width: u32| {
                let size = format!("-D S={bits} -D LOW={low} -D W={width}");
                read(&format!("-D NAME={name} {size} {FOLDER}/any_product.v"));
            };
            any("reference_product", 0, bits);
            for array in self.boxes() {
                let is_upper = array.generics.ends_with("upper");
                any(&array.name, if is_upper { half } else { 0 }, if is_upper { bits - half } else { half });
            }
        }
        let cut = match self.operands().as_slice() {
            [] => String::new(),
            operands => format!("expose {}\nsetundef -undriven -expose\n", operands.join(" ")),
        };
        script.push_str("design -save both\n");
        for side in ["gold", "gate"] {
            let _ = write!(
                script,
                "design -load both\nhierarchy -top {side}\nproc\nflatten\nsetattr -unset init w:*\n{cut}opt_expr -mux_undef -fine\n\
                 opt_clean\ntechmap -map %map\nopt\ntechmap\nopt -fast\naigmap\nwrite_aiger -symbols {side}.aig\n"
            );
        }
        script
    }

    /// The operands of the parts that are left out: wires of the flattened sides, which become outputs.
    fn operands(&self) -> Vec<String> {
        let left_out = |instance: &&Instance| self.left_out.includes(self.design.module(instance.module));
        let instances = self.design.top().instances.iter().filter(left_out);
        instances
            .flat_map(|i| ["a_i", "b_i"].map(|port| format!("w:unit.{}.{port}", plain(&i.name))))
            .collect()
    }
}

/// Declarations of a module's ports.
fn ports(module: &Module) -> Vec<String> {
    let names = port_names(module, &mut Namespace::default());
    let inputs = names.inputs.iter().zip(&module.inputs).map(|(name, port)| (name, port, "input"));
    let outputs = names.outputs.iter().zip(&module.outputs).map(|(name, (port, _))| (name, port, "output"));
    let clock = module.clock.iter().map(|_| "input wire clk_i".to_owned());
    let declare = |(name, port, direction): (&String, &netlist::Port, _)| {
        format!("{direction} wire [{}:0] {name}", port.width - 1)
    };
    clock.chain(inputs.chain(outputs).map(declare)).collect()
}

/// The sides for a unit: `gold` with a module of the references, whose inputs have the values that are tied in the unit, and
/// `gate` with the unit itself, always enabled.
pub fn unit_sides(design: &Design, reference: &str) -> String {
    let unit = design.top();
    let outside: Vec<String> = ports(unit).into_iter().filter(|port| !port.ends_with(" en_i")).collect();
    let names = port_names(unit, &mut Namespace::default());
    let is_operation =
        |name: &&String| !["en_i", "valid_i", "tag_i", "valid_o", "tag_o"].contains(&name.as_str());
    let operation: Vec<String> = (names.inputs.iter().chain(&names.outputs).filter(is_operation))
        .map(|name| format!(".{name}({name})"))
        .collect();
    let tied = unit.parameters.iter().filter(|p| p.is_tied_input && is_operation(&&p.name));
    let tied: Vec<String> = tied.map(|p| format!(".{}({}'d{})", p.name, p.width, p.value)).collect();
    let mut gold = format!("    {reference} unit ({});\n", [operation, tied].concat().join(", "));
    for port in ["valid", "tag"] {
        if names.outputs.contains(&format!("{port}_o")) {
            let _ = writeln!(gold, "    assign {port}_o = {port}_i;");
        }
    }
    let gate = format!("    wire en_i = 1'b1;\n    {} unit (.*);\n", unit.name);
    let side = |name: &str, body: &str| {
        format!("module {name} (\n    {}\n);\n{body}endmodule\n", outside.join(",\n    "))
    };
    side("gold", &gold) + &side("gate", &gate)
}
