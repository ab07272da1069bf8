//! The reset of the exported Verilog: it clears the valid bits, nothing depends on what it leaves, and it changes nothing else.

use equivalence::testbench as stimulus;
use netlist::verilog::testbench::{Start, vectors};
use netlist::verilog::{Form, Namespace, plain, port_names, text};
use netlist::{Design, Flat, NodeId, Op, flatten, register_depths};
use pipelines::catalogue::{StandardFormat, Top};
use std::collections::BTreeSet;
use std::fmt::Write as _;
use std::path::Path;
use testing::long;
use testing::tools::{available, in_parallel, run};

const FORM: Form<'static> = Form { reset: true, sources: &[] };

fn design(top: Top) -> Design {
    top.design(StandardFormat::Binary32).unwrap()
}

fn write(folder: &Path, name: &str, contents: &str) {
    std::fs::write(folder.join(name), contents).unwrap();
}

/// Each valid output with the outputs that it vouches for, by Verilog name.
fn vouched(design: &Design) -> Vec<(String, Vec<String>)> {
    let outputs = port_names(design.top(), &mut Namespace::default()).outputs;
    let valids = outputs.iter().filter(|name| name.contains("valid")).cloned();
    let pairs = valids.map(|valid| {
        let belongs = |name: &&String| match valid.split_once("valid").unwrap() {
            ("", _) => true,
            ("node_", _) => ["code", "near", "far", "tag_o"].iter().any(|start| name.starts_with(start)),
            ("box_", _) => ["hit", "t_entry", "tag_o"].iter().any(|start| name.starts_with(start)),
            (unit, lane) => name.starts_with(unit) && name.ends_with(lane),
        };
        let others = outputs.iter().filter(|name| !name.contains("valid")).filter(belongs).cloned().collect();
        (valid.clone(), others)
    });
    pairs.collect()
}

/// A simulation that starts with all registers unknown. Before the first clock edge, reset makes every valid output 0. Operations
/// follow at once, and no output is unknown that a valid output vouches for.
fn bench(design: &Design, cycles: usize) -> String {
    let top = design.top();
    let ports = port_names(top, &mut Namespace::default());
    let widths: Vec<u32> =
        top.inputs.iter().chain(top.outputs.iter().map(|(port, _)| port)).map(|p| p.width).collect();
    let total: u32 = widths.iter().sum();
    let mut text = format!(
        "module bench;\n    reg clk_i = 0, rst_ni = 1;\n    reg [{}:0] vectors [0:{}];\n",
        total - 1,
        cycles - 1
    );
    let _ = writeln!(text, "    integer index = 0;\n    wire [{}:0] vector = vectors[index];", total - 1);
    let mut low = total;
    for (name, width) in ports.inputs.iter().zip(&widths) {
        low -= width;
        let _ = writeln!(text, "    wire [{}:0] {name} = vector[{low} +: {width}];", width - 1);
    }
    for (name, width) in ports.outputs.iter().zip(&widths[ports.inputs.len()..]) {
        let _ = writeln!(text, "    wire [{}:0] {name};", width - 1);
    }
    let names =
        ["clk_i".to_owned(), "rst_ni".to_owned()].into_iter().chain(ports.inputs).chain(ports.outputs);
    let connections: Vec<String> = names.map(|name| format!(".{name}({name})")).collect();
    let _ = writeln!(text, "    {} dut ({});", top.name, connections.join(", "));
    let (mut cleared, mut known) = (String::new(), String::new());
    for (valid, others) in vouched(design) {
        let _ = writeln!(
            cleared,
            "        if ({valid} !== 1'b0) $fatal(1, \"{valid} is %b in reset\", {valid});"
        );
        let others = others.join(", ");
        let _ = writeln!(known, "        if ({valid} === 1'bx) $fatal(1, \"{valid} is unknown\");");
        let _ = writeln!(
            known,
            "        if ({valid} === 1'b1) begin shown = shown + 1; if (^{{{others}}} === 1'bx) \
             $fatal(1, \"cycle %0d: {valid} with %h\", index, {{{others}}}); end"
        );
    }
    let _ = write!(
        text,
        "    integer shown = 0;\n    initial begin\n        $readmemh(\"vectors.hex\", vectors);\n        #1 rst_ni = 0;\n        #1;\n\
         {cleared}        #1 rst_ni = 1;\n        repeat ({cycles}) begin\n        #5 clk_i = 1;\n        #5 clk_i = 0;\n        \
         index = index + 1;\n        #1;\n        if (index < {cycles}) begin\n{known}        end\n        end\n        \
         $display(\"PASS: %0d results\", shown);\n    end\nendmodule\n"
    );
    text
}

/// Runs [`bench`] on a source.
fn simulate(top: Top, source: &str) -> Result<String, String> {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let design = design(top);
    let cycles = stimulus(top, StandardFormat::Binary32, &flatten(&design).unwrap(), 200, 3);
    write(folder, "unit.v", source);
    write(folder, "bench.v", &bench(&design, cycles.len()));
    write(folder, "vectors.hex", &vectors(&design, &Start::default(), cycles).unwrap());
    run(folder, "iverilog", &["-g2012", "-s", "bench", "-o", "simulation", "bench.v", "unit.v"])?;
    run(folder, "vvp", &["-n", "simulation"])
}

#[test]
fn unknown_registers_reach_no_valid_output() {
    if !available("iverilog") {
        return;
    }
    in_parallel(Top::ALL.iter().rev().copied(), |top| {
        let source = FORM.text(&[&design(top)], top.name());
        assert!(!source.contains("reg valid = 1'b0"), "registers have no initial values");
        let printed = simulate(top, &source).unwrap_or_else(|error| panic!("{top}: {error}"));
        assert!(printed.contains("PASS") && !printed.contains("PASS: 0 "), "{top}: {printed}");
    });
    // Without the reset of one register, and with data that come too late, the bench fails.
    let source = FORM.text(&[&design(Top::FpAdd)], "fp_add");
    for (good, bad) in [
        ("            valid_2 <= 1'b0;\n", ""),
        ("result <= rounder_result_o;", "if (result != 1) result <= rounder_result_o;"),
    ] {
        assert!(source.contains(good), "{source}");
        simulate(Top::FpAdd, &source.replace(good, bad)).expect_err(bad);
    }
}

/// Valid outputs depend on no register that reset leaves as it was.
#[test]
fn valid_outputs_depend_on_reset_registers_only() {
    for &top in Top::ALL {
        let design = design(top);
        let netlist = flatten(&design).unwrap();
        for (port, node) in netlist.outputs.iter().filter(|(port, _)| port.name.contains("valid")) {
            let mut seen = BTreeSet::new();
            let mut pending = vec![*node];
            while let Some(node) = pending.pop() {
                if !seen.insert(node) {
                    continue;
                }
                let op = netlist.nodes[node.index()].op;
                pending.extend(op.operands());
                if let Op::Register(register) = op {
                    let register = &netlist.registers[register as usize];
                    pending.push(register.data);
                    pending.extend(register.enable);
                    assert!(
                        has_reset(&design, &netlist, node),
                        "{top}: {} depends on {}",
                        port.name,
                        register.name
                    );
                }
            }
        }
    }
}

/// Whether reset clears the register whose present value the node is.
fn has_reset(design: &Design, netlist: &Flat, node: NodeId) -> bool {
    let Op::Register(register) = netlist.nodes[node.index()].op else { return false };
    let register = &netlist.registers[register as usize];
    let module = design.module(netlist.scopes[register.scope as usize].module);
    module.registers.iter().any(|found| found.name == register.name && found.has_reset)
}

/// What is proved: the units, and in long runs both pipelines, whose modules the other tops have too.
fn proved() -> impl Iterator<Item = Top> {
    let units = [Top::FpMul, Top::FpAdd, Top::FpMinMax, Top::FpCmp, Top::IntAdd];
    let pipelines = [Top::RayBox, Top::DualSplit].into_iter().filter(|top| long(&format!("proofs of {top}")));
    pipelines.chain(units)
}

/// With `rst_ni` held high the export equals the form without reset. yosys proves it of every module that has valid bits; the others only
/// pass the reset on, and without those lines their text is the same.
#[test]
fn held_high_reset_changes_nothing() {
    if !available("yosys") {
        return;
    }
    in_parallel(proved(), |top| {
        let design = design(top);
        let [with, without] = [FORM.text(&[&design], top.name()), text(&design)];
        for module in &design.modules {
            let name = &module.name;
            if module.registers.iter().any(|register| register.has_reset) {
                prove_equal(name, &with, &without).unwrap_or_else(|error| panic!("{name}: {error}"));
            } else {
                let [with, without] = [&with, &without].map(|text| without_start(module_text(text, name)));
                assert_eq!(with, without, "{name}");
            }
        }
    });
    let design = design(Top::FpAdd);
    let [with, without] = [FORM.text(&[&design], "fp_add"), text(&design)];
    for (right, wrong) in [("valid_2 <= valid_1;", "valid_2 <= ~valid_1;"), ("else if (en_i)", "else")] {
        assert!(with.contains(right));
        prove_equal("fp_add", &with.replace(right, wrong), &without).expect_err(wrong);
    }
}

/// The lines of a module in a file.
fn module_text<'t>(text: &'t str, name: &str) -> &'t str {
    let (_, rest) = text.split_once(&format!("\nmodule {name} (")).unwrap();
    rest.split_once("\nendmodule").unwrap().0
}

/// Lines without the port that passes reset on, without initial values and without the spaces that line up columns.
fn without_start(text: &str) -> Vec<String> {
    let lines = text.lines().filter(|line| !line.contains("rst_ni"));
    let declared =
        lines.map(|line| if line.starts_with("    reg ") { line.split(" = ").next().unwrap() } else { line });
    declared.map(|line| line.trim_end_matches(';').split_whitespace().collect::<Vec<_>>().join(" ")).collect()
}

fn prove_equal(module: &str, with: &str, without: &str) -> Result<(), String> {
    let folder = tempfile::tempdir().unwrap();
    write(folder.path(), "with.v", with);
    write(folder.path(), "without.v", without);
    let side = |file: &str, name: &str, tie: &str| {
        format!(
            "design -reset\nread_verilog {file}.v\nhierarchy -top {module}\nproc\nflatten\nsetattr -unset init w:*\n{tie}opt_clean\n\
             opt_expr\nopt_dff\nopt_clean\nrename {module} {name}\ndesign -stash {name}\n"
        )
    };
    let script = format!(
        "{}{}design -copy-from gold gold\ndesign -copy-from gate gate\nequiv_make gold gate equiv\nhierarchy -top equiv\n\
         opt_clean\nequiv_struct -icells -fwd\nequiv_remove\nequiv_induct\nequiv_status -assert\n",
        side("without", "gold", ""),
        // The port becomes a constant.
        side("with", "gate", &format!("cd {module}\nconnect -set rst_ni 1'b1\ndelete -input w:rst_ni\ncd\n")),
    );
    write(folder.path(), "equal.ys", &script);
    run(folder.path(), "yosys", &["-q", "-s", "equal.ys"]).map(drop)
}

/// yosys proves by induction, from unknown registers on, that after reset every valid bit is `valid_i` of as many enabled cycles ago as
/// there are registers before it. The shared block, whose bits are routed, has the two tests above.
#[test]
fn valid_bits_follow_the_operations() {
    if !available("yosys") {
        return;
    }
    in_parallel(proved(), |top| {
        let design = design(top);
        let source = FORM.text(&[&design], top.name());
        prove_valid(&design, &source).unwrap_or_else(|error| panic!("{top}: {error}"));
        if top == Top::FpAdd {
            for (right, wrong) in [
                ("valid_2 <= 1'b0;", "valid_2 <= 1'b1;"),
                ("valid_2 <= valid_1;", "valid_2 <= valid_1 & nan;"),
            ] {
                assert!(source.contains(right));
                prove_valid(&design, &source.replace(right, wrong)).expect_err(wrong);
            }
        }
    });
}

fn prove_valid(design: &Design, source: &str) -> Result<(), String> {
    let top = design.top();
    let netlist = flatten(design).unwrap();
    let depths = register_depths(&netlist).unwrap();
    let (mut proved, mut kept) = (String::new(), String::new());
    let mut latency = 0;
    for register in netlist.registers.iter().filter(|register| has_reset(design, &netlist, register.output)) {
        let (depth, most) = depths[register.output.index()].unwrap();
        assert_eq!(depth, most);
        latency = latency.max(depth);
        let path = &netlist.scopes[register.scope as usize].path;
        let names = ["dut", path, &register.name].map(plain_path);
        let names: Vec<String> = names.into_iter().filter(|name| !name.is_empty()).collect();
        let _ = write!(proved, " -prove {} model_{depth}", names.join("."));
        let _ = write!(kept, " w:{} w:model_{depth}", names.join("."));
    }
    let ports = port_names(top, &mut Namespace::default());
    let mut model = "module monitor (input clk_i, input rst_ni".to_owned();
    for (name, port) in ports.inputs.iter().zip(&top.inputs) {
        let _ = write!(model, ", input [{}:0] {name}", port.width - 1);
    }
    model.push_str(");\n");
    let inputs: Vec<String> = ports.inputs.iter().map(|name| format!(", .{name}({name})")).collect();
    let _ = writeln!(model, "    {} dut (.clk_i(clk_i), .rst_ni(rst_ni){});", top.name, inputs.concat());
    let _ = writeln!(model, "    wire model_0 = valid_i;");
    for depth in 1..=latency {
        let before = depth - 1;
        let _ = writeln!(
            model,
            "    reg model_{depth};\n    always @(posedge clk_i or negedge rst_ni)\n        if (!rst_ni) model_{depth} <= 1'b0;\n        \
             else if (en_i) model_{depth} <= model_{before};"
        );
    }
    model.push_str("endmodule\n");
    let folder = tempfile::tempdir().unwrap();
    write(folder.path(), "unit.v", source);
    write(folder.path(), "monitor.v", &model);
    // The induction starts in reset, whatever the registers hold. What no valid bit depends on goes first.
    let script = format!(
        "read_verilog unit.v monitor.v\nhierarchy -top monitor\nproc\nflatten\nsetattr -set keep 1{kept}\nopt_clean -purge\nopt_expr\n\
         opt_clean -purge\nasync2sync\nsat -tempinduct -maxsteps 4 -set-at 1 rst_ni 0 -verify{proved} monitor\n"
    );
    write(folder.path(), "valid.ys", &script);
    run(folder.path(), "yosys", &["-q", "-s", "valid.ys"]).map(drop)
}

fn plain_path(path: &str) -> String {
    path.split('.').map(plain).collect::<Vec<_>>().join(".")
}
