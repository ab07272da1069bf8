//! The pipelines with ready and valid: random back-pressure in Icarus, and the layout of the packed words.

use equivalence::testbench as stimulus;
use netlist::verilog::testbench::hex_line;
use netlist::verilog::{Form, GeneratedFile, Namespace, PackageOptions, package, port_names};
use netlist::{Design, Evaluator, flatten};
use pipelines::catalogue::{StandardFormat, Top};
use std::fmt::Write as _;
use std::path::Path;
use testing::tools::{available, in_parallel, run};

const LATENCY: usize = 8;

fn pipelines() -> impl Iterator<Item = Top> {
    Top::ALL.iter().rev().copied().filter(|top| top.is_pipeline())
}

/// The exported package of a pipeline, without vectors.
fn files(top: Top, format: StandardFormat) -> (Design, Vec<GeneratedFile>) {
    let design = top.design(format).unwrap();
    let form = Form { reset: true, ..Form::default() };
    let options = PackageOptions { form, is_pipeline: true, ..PackageOptions::default() };
    let files = package(&design, &options, &[]).unwrap();
    (design, files)
}

fn write_all(folder: &Path, files: &[GeneratedFile]) {
    files.iter().for_each(|file| std::fs::write(folder.join(&file.name), &file.contents).unwrap());
}

/// Names and widths of the ports that belong to an operation: of the inputs, and of the outputs.
fn payload(design: &Design) -> [Vec<(String, u32)>; 2] {
    let top = design.top();
    let names = port_names(top, &mut Namespace::default());
    let widths = [
        top.inputs.iter().map(|port| port.width).collect::<Vec<_>>(),
        top.outputs.iter().map(|(port, _)| port.width).collect(),
    ];
    let [inputs, outputs] = [names.inputs, names.outputs].map(Vec::into_iter);
    let [in_widths, out_widths] = widths;
    let data = |(name, _): &(String, u32)| !["en_i", "valid_i", "valid_o"].contains(&name.as_str());
    [inputs.zip(in_widths).filter(data).collect(), outputs.zip(out_widths).filter(data).collect()]
}

/// Operations as lines of their operands, and as many lines of their results, from the netlist without stalls.
fn operations(top: Top, design: &Design) -> [String; 2] {
    let flat = flatten(design).unwrap();
    let position = |name: &str| flat.input(name).unwrap();
    let mut cycles = stimulus(top, StandardFormat::Binary32, &flat, 300, 5);
    for inputs in &mut cycles {
        (inputs[position("en_i")], inputs[position("valid_i")]) = (1, 1);
    }
    let count = cycles.len();
    cycles.extend(vec![cycles[0].clone(); LATENCY]);
    let mut evaluator = Evaluator::new(&flat);
    let mut lines = [String::new(), String::new()];
    for (cycle, inputs) in cycles.iter().enumerate() {
        let outputs = evaluator.cycle(inputs);
        let handshake = |name: &str| ["en_i", "valid_i", "valid_o"].contains(&name);
        let inputs = inputs.iter().zip(&flat.inputs).filter(|(_, port)| !handshake(&port.name));
        let words: Vec<(u128, u32)> = inputs.map(|(&value, port)| (value, port.width)).collect();
        if cycle < count {
            lines[0].push_str(&hex_line(&words));
        }
        let outputs = outputs.iter().zip(&flat.outputs).filter(|(_, (port, _))| !handshake(&port.name));
        let words: Vec<(u128, u32)> = outputs.map(|(&value, (port, _))| (value, port.width)).collect();
        if cycle >= LATENCY {
            lines[1].push_str(&hex_line(&words));
        }
    }
    lines
}

/// Does not read until a result shows. Sends all operations, first without a pause, then with random pauses of writer and reader. Toggles `ready_i` within each cycle, which must
/// change neither `valid_o` nor `ready_o`.
fn bench(design: &Design, count: usize) -> String {
    let top = &design.top().name;
    let ports = payload(design);
    let bits = |wires: &[(String, u32)]| wires.iter().map(|(_, width)| width).sum::<u32>();
    let [operand_bits, result_bits] = [bits(&ports[0]), bits(&ports[1])];
    let mut wires = String::new();
    let mut connections = String::new();
    for (ports, word) in [(&ports[0], "operands"), (&ports[1], "results")] {
        let mut low = bits(ports);
        for (name, width) in ports {
            low -= width;
            let _ = write!(connections, ", .{name}({word}[{low} +: {width}])");
        }
    }
    let _ = write!(
        wires,
        "    wire [{}:0] operands = all_operands[sent];\n    wire [{}:0] results;\n    reg [{}:0] held;\n",
        operand_bits - 1,
        result_bits - 1,
        result_bits - 1
    );
    let (operands, results) = (operand_bits - 1, result_bits - 1);
    format!(
        "module bench;\n    reg clk_i = 0, rst_ni = 1, valid_i = 0, ready_i = 0, was_held = 0, v, r;\n    wire ready_o, valid_o;\n\
         \x20   integer sent = 0, received = 0, cycles = 0, first = 0;\n    reg [{operands}:0] all_operands [0:{count}];\n    reg [{results}:0] all_results [0:{count}];\n\
         {wires}    {top}_stream dut (.clk_i(clk_i), .rst_ni(rst_ni), .valid_i(valid_i), .ready_o(ready_o), .valid_o(valid_o), .ready_i(ready_i){connections});\n\
         \x20   localparam HALF = {half}, COUNT = {count};\n\
         \x20   initial begin\n        $readmemh(\"operands.hex\", all_operands, 0, COUNT - 1);\n        $readmemh(\"results.hex\", all_results, 0, COUNT - 1);\n\
         \x20       #1 rst_ni = 0; #1 if (valid_o !== 0 || ready_o !== 1) $fatal(1, \"reset\");\n        #1 rst_ni = 1; valid_i = 1;\n\
         \x20       while (received < COUNT) begin\n            #4;\n            v = valid_o; r = ready_o;\n            ready_i = ~ready_i; #1;\n\
         \x20           if (valid_o !== v || ready_o !== r) $fatal(1, \"a path from ready_i\");\n            ready_i = ~ready_i; #1;\n\
         \x20           if (was_held && (valid_o !== 1 || results !== held)) $fatal(1, \"a result that nobody took has gone\");\n\
         \x20           was_held = valid_o & ~ready_i; held = results;\n\
         \x20           if (valid_o && ready_i) begin\n                if (results !== all_results[received]) $fatal(1, \"result %0d is %h, not %h\", received, results, all_results[received]);\n\
         \x20               if (received == 0) first = cycles;\n                received = received + 1;\n\
         \x20               if (received == HALF && cycles - first != HALF - 1) $fatal(1, \"%0d results in %0d cycles\", HALF, cycles);\n            end\n\
         \x20           if (cycles == 2 * {LATENCY} - 1 && valid_o !== 1) $fatal(1, \"valid_o waits for ready_i\");\n            v = valid_i & ready_o;\n            clk_i = 1; #5;\n            cycles = cycles + 1;\n\
         \x20           if (v) sent = sent + 1;\n\
         \x20           if (v | ~valid_i) valid_i = sent < COUNT && (sent < HALF + {LATENCY} || $random % 3 != 0);\n\
         \x20           ready_i = cycles < 2 * {LATENCY} ? 0 : received < HALF || $random % 3 == 0 || received > COUNT - 20;\n\
         \x20           clk_i = 0; #5;\n        end\n        #20 if (valid_o) $fatal(1, \"a result too many\");\n        $display(\"PASS: %0d results\", received);\n    end\nendmodule\n",
        half = count / 2,
    )
}

fn simulate(top: Top, design: &Design, files: &[GeneratedFile]) -> Result<String, String> {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    write_all(folder, files);
    let [operands, results] = operations(top, design);
    let count = operands.lines().count();
    for (name, text) in
        [("operands.hex", &operands), ("results.hex", &results), ("bench.v", &bench(design, count))]
    {
        std::fs::write(folder.join(name), text).unwrap();
    }
    let sources = [format!("{top}.v"), format!("{top}_stream.v")];
    run(
        folder,
        "iverilog",
        &["-g2012", "-Wall", "-s", "bench", "-o", "simulation", "bench.v", &sources[0], &sources[1]],
    )?;
    run(folder, "vvp", &["-n", "simulation"])
}

#[test]
fn streams_keep_order_under_back_pressure() {
    if !available("iverilog") {
        return;
    }
    in_parallel(pipelines(), |top| {
        let (design, files) = files(top, StandardFormat::Binary32);
        let printed = simulate(top, &design, &files).unwrap_or_else(|error| panic!("{top}: {error}"));
        assert!(printed.contains("PASS"), "{top}: {printed}");
    });
    // A stream that forgets what came after it stopped, one that stops too late, and one with a path from ready to ready.
    let (design, good) = files(Top::DualSplit, StandardFormat::Binary32);
    for (right, wrong) in [
        ("waiting <= ~moves & (waiting | valid_i)", "waiting <= 1'b0"),
        ("ready_i | ~valid_o", "1'b1"),
        ("assign ready_o = ~waiting", "assign ready_o = moves"),
        ("ready_i | ~valid_o", "ready_i"),
    ] {
        let mut spoilt = good.clone();
        let stream = spoilt.iter_mut().find(|file| file.name.ends_with("_stream.v")).unwrap();
        assert!(stream.contents.contains(right));
        stream.contents = stream.contents.replace(right, wrong);
        simulate(Top::DualSplit, &design, &spoilt).expect_err(wrong);
    }
}

/// Each field of the SystemVerilog package, alone all ones, arrives at its port and nowhere else.
#[test]
fn package_and_ports_agree() {
    if !available("iverilog") {
        return;
    }
    for (top, format) in [
        (Top::DualSplit, StandardFormat::Binary32),
        (Top::RayBoxX2, StandardFormat::Binary32),
        (Top::RayBox, StandardFormat::Binary16),
    ] {
        let (design, files) = files(top, format);
        let name = &design.top().name;
        let folder = tempfile::tempdir().unwrap();
        write_all(folder.path(), &files);
        let [operands, results] = payload(&design);
        let is_field = |(name, _): &&(String, u32)| !name.starts_with("tag_");
        let inputs: Vec<_> = operands.iter().filter(is_field).collect();
        let ports: Vec<String> = inputs.iter().map(|(port, _)| format!("dut.stream.{port}")).collect();
        let total: u32 = inputs.iter().map(|(_, width)| width).sum();
        let mut checks = String::new();
        for (port, width) in &inputs {
            let group = match port.split('_').next().unwrap() {
                "header" | "plane" => "node",
                "box" => "bounds",
                _ => "ray",
            };
            let field = port.strip_suffix("_i").unwrap();
            let _ = writeln!(
                checks,
                "        o = 0; o.{group}.{field} = {{{width}{{1'b1}}}}; #1 if (dut.stream.{port} !== {{{width}{{1'b1}}}} || ones({{{}}}) != {width}) \
                 $fatal(1, \"{port}\");",
                ports.join(", ")
            );
        }
        for (port, width) in results.iter().filter(is_field) {
            let field = port.strip_suffix("_o").unwrap();
            let _ = writeln!(
                checks,
                "        force dut.{port} = {{{width}{{1'b1}}}}; #1 if (r.{field}[{}:0] !== {{{width}{{1'b1}}}}) $fatal(1, \"{port}\"); release dut.{port};",
                width - 1
            );
        }
        let bench = format!(
            "module bench;\n    import {name}_pkg::*;\n    function automatic integer ones(input [{total}-1:0] word);\n        ones = 0;\n        \
             for (integer i = 0; i < {total}; i = i + 1) ones = ones + word[i];\n    endfunction\n    operands_t o;\n    result_t r;\n    reg [0:0] t = 0;\n    wire [$bits(result_t)-1:0] data;\n\
             \x20   assign r = data;\n\
             \x20   {name}_axis dut (.aclk(1'b0), .aresetn(1'b1), .s_axis_tvalid(1'b0), .s_axis_tready(), .s_axis_tdata(o), .s_axis_tuser(t),\n\
             \x20       .m_axis_tvalid(), .m_axis_tready(1'b1), .m_axis_tdata(data), .m_axis_tuser());\n\
             \x20   initial begin\n        if ($bits(dut.s_axis_tdata) != $bits(operands_t) || $bits(dut.m_axis_tdata) != $bits(result_t) || {total} > $bits(operands_t)) $fatal(1, \"size\");\n\
             {checks}        $display(\"PASS\");\n    end\nendmodule\n"
        );
        std::fs::write(folder.path().join("bench.sv"), bench).unwrap();
        let sources = ["_pkg.sv", ".v", "_stream.v", "_axis.v"].map(|suffix| format!("{name}{suffix}"));
        let mut arguments = vec!["-g2012", "-s", "bench", "-o", "simulation"];
        arguments.extend(sources.iter().map(String::as_str));
        arguments.push("bench.sv");
        run(folder.path(), "iverilog", &arguments).unwrap_or_else(|error| panic!("{name}: {error}"));
        let printed = run(folder.path(), "vvp", &["-n", "simulation"])
            .unwrap_or_else(|error| panic!("{name}: {error}"));
        assert!(printed.contains("PASS"), "{printed}");
    }
}

/// The C structures hold the fields in the order of the ports, without gaps.
#[test]
fn header_and_ports_agree() {
    if !available("g++") {
        return;
    }
    for (top, format) in [(Top::DualSplit, StandardFormat::Binary32), (Top::RayBox, StandardFormat::Binary16)]
    {
        let (design, files) = files(top, format);
        let name = &design.top().name;
        let folder = tempfile::tempdir().unwrap();
        write_all(folder.path(), &files);
        let mut text = format!(
            "#include <stddef.h>\n#include \"{name}.h\"\n#define WORD sizeof(((struct {name}_ray *)0)->t_min)\n"
        );
        let [operands, results] = payload(&design);
        let fields = |wires: &[(String, u32)]| -> Vec<String> {
            let names = wires.iter().filter(|(name, _)| !name.starts_with("tag_"));
            names.map(|(name, _)| name[..name.len() - 2].to_owned()).collect()
        };
        for (i, field) in fields(&operands).iter().enumerate() {
            let group = match field.split('_').next().unwrap() {
                "header" | "plane" => "node",
                "box" => "bounds",
                _ => "ray",
            };
            let _ = writeln!(
                text,
                "_Static_assert(offsetof(struct {name}_operands, {group}.{field}) == {i} * WORD, \"{field}\");"
            );
        }
        for (i, field) in fields(&results).iter().enumerate() {
            let _ = writeln!(
                text,
                "_Static_assert(offsetof(struct {name}_result, {field}) == {i} * WORD, \"{field}\");"
            );
        }
        text.push_str("int main(void) { return 0; }\n");
        std::fs::write(folder.path().join("check.c"), text).unwrap();
        run(folder.path(), "gcc", &["-std=c11", "-Wall", "-Wextra", "-Werror", "-fsyntax-only", "check.c"])
            .unwrap_or_else(|error| panic!("{error}"));
    }
}
