//! The exported Verilog in Verilator: an independent simulation of the same hardware, for comparison and as a yardstick.
//!
//! A small C++ program around Verilator's model reads all inputs of all cycles from a file, runs them, writes all outputs
//! of every cycle to another, and says how long the runs took. Values are 64-bit little-endian words.

use netlist::verilog;
use netlist::{Design, Port};
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::{fs, io};

/// Verilator's compiled model of a design.
#[derive(Clone, Debug)]
pub struct Verilated {
    program: PathBuf,
    folder: PathBuf,
    outputs: usize,
}

/// The results of a run.
#[derive(Clone, Debug, PartialEq)]
pub struct Run {
    /// All outputs of each cycle of the first pass, before the clock edge.
    pub outputs: Vec<Vec<u64>>,
    /// Processor seconds of all passes except the first. They include reading the inputs from memory.
    pub seconds: f64,
    /// Sum of each output over the cycles of all passes except those skipped, modulo 2^64.
    pub sums: Vec<u64>,
}

/// Why there is no model, or no result.
#[derive(Debug, thiserror::Error)]
pub enum VerilatedError {
    /// A port is too wide.
    #[error("port `{0}` is wider than 64 bits")]
    TooWide(String),
    /// A file cannot be written or read, or a program is missing.
    #[error("{0}: {1}")]
    Io(String, io::Error),
    /// A program has failed.
    #[error("{0} has failed: {1}")]
    Failed(String, String),
}

impl Verilated {
    /// Verilates `design` in `folder`, with all optimisations for this machine and without threads.
    ///
    /// # Errors
    /// When Verilator or the C++ compiler is missing or fails, or a port is wider than 64 bits.
    pub fn build(design: &Design, folder: &Path) -> Result<Self, VerilatedError> {
        let top = design.top();
        let ports = top.inputs.iter().chain(top.outputs.iter().map(|(port, _)| port));
        if let Some(wide) = ports.clone().find(|port| port.width > 64) {
            return Err(VerilatedError::TooWide(wide.name.clone()));
        }
        let name = &top.name;
        write(&folder.join(format!("{name}.v")), &verilog::text(design))?;
        let clock = top.clock.as_deref().unwrap_or("clk_i");
        let outputs: Vec<&Port> = top.outputs.iter().map(|(port, _)| port).collect();
        write(&folder.join(format!("{name}_main.cpp")), &harness(name, clock, &top.inputs, &outputs))?;
        let (model, main) = (format!("{name}.v"), format!("{name}_main.cpp"));
        run(Command::new("verilator").current_dir(folder).args([
            "--cc",
            "--exe",
            "--build",
            "-O3",
            "--x-assign",
            "fast",
            "--x-initial",
            "fast",
            "--noassert",
            "-Wno-fatal",
            "-Wno-lint",
            "--Mdir",
            "model",
            "-MAKEFLAGS",
            "OPT_FAST='-O3 -march=native' OPT_GLOBAL='-O3 -march=native'",
            "-o",
            "simulation",
            &model,
            &main,
        ]))?;
        let program = folder.join("model").join("simulation");
        Ok(Self { program, folder: folder.to_owned(), outputs: outputs.len() })
    }

    /// Runs the inputs of all cycles, in order, `passes` times without a reset; sums leave out the first `skipped`
    /// cycles of each pass.
    ///
    /// # Errors
    /// When the program fails or a file cannot be written or read.
    pub fn run(&self, inputs: &[Vec<u64>], passes: u32, skipped: usize) -> Result<Run, VerilatedError> {
        let bytes: Vec<u8> = inputs.iter().flatten().flat_map(|value| value.to_le_bytes()).collect();
        let (given, shown) = (self.folder.join("inputs.bin"), self.folder.join("outputs.bin"));
        fs::write(&given, bytes).map_err(|error| VerilatedError::Io(given.display().to_string(), error))?;
        let output = run(Command::new(&self.program).args([&given, &shown]).args([
            inputs.len().to_string(),
            passes.to_string(),
            skipped.to_string(),
        ]))?;
        let text = String::from_utf8_lossy(&output.stdout).into_owned();
        let unreadable = || VerilatedError::Failed(self.program.display().to_string(), text.clone());
        let mut words = text.split_whitespace();
        let seconds = words.next().and_then(|word| word.parse().ok()).ok_or_else(unreadable)?;
        let sums: Vec<u64> = words.map(str::parse).collect::<Result<_, _>>().map_err(|_| unreadable())?;
        let bytes =
            fs::read(&shown).map_err(|error| VerilatedError::Io(shown.display().to_string(), error))?;
        let values: Vec<u64> = bytes.as_chunks().0.iter().map(|bytes| u64::from_le_bytes(*bytes)).collect();
        Ok(Run { outputs: values.chunks(self.outputs).map(<[u64]>::to_vec).collect(), seconds, sums })
    }
}

/// The program around the model.
fn harness(name: &str, clock: &str, inputs: &[Port], outputs: &[&Port]) -> String {
    let member = |port: &Port| port.name.replace('$', "_");
    let mut drive = String::new();
    for (position, port) in inputs.iter().enumerate() {
        let _ = write!(drive, " top.{} = in[{position}];", member(port));
    }
    let (mut sum, mut keep) = (String::new(), String::new());
    for (position, port) in outputs.iter().enumerate() {
        let _ = write!(sum, " sums[{position}] += top.{};", member(port));
        let _ = write!(keep, " *kept++ = top.{};", member(port));
    }
    let (given, shown) = (inputs.len(), outputs.len());
    format!(
        "#include \"V{name}.h\"
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <vector>

static double seconds() {{
    timespec t;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return t.tv_sec + 1e-9 * t.tv_nsec;
}}

int main(int argc, char** argv) {{
    if (argc != 6) return 2;
    const size_t cycles = strtoull(argv[3], 0, 10), passes = strtoull(argv[4], 0, 10), skipped = strtoull(argv[5], 0, 10);
    std::vector<uint64_t> given(cycles * {given}), shown(cycles * {shown});
    FILE* file = fopen(argv[1], \"rb\");
    if (!file || fread(given.data(), 8, given.size(), file) != given.size()) return 2;
    fclose(file);
    V{name} top;
    uint64_t sums[{shown}] = {{}};
    uint64_t* kept = shown.data();
    double spent = 0;
    for (size_t pass = 0; pass < passes; ++pass) {{
        const uint64_t* in = given.data();
        const double start = seconds();
        for (size_t cycle = 0; cycle < cycles; ++cycle, in += {given}) {{
           {drive}
            top.{clock} = 0;
            top.eval();
            if (cycle >= skipped) {{
               {sum}
            }}
            if (pass == 0) {{
               {keep}
            }}
            top.{clock} = 1;
            top.eval();
        }}
        if (pass > 0) spent += seconds() - start;
    }}
    file = fopen(argv[2], \"wb\");
    if (!file || fwrite(shown.data(), 8, shown.size(), file) != shown.size() || fclose(file)) return 2;
    printf(\"%.9f\", spent);
    for (uint64_t sum : sums) printf(\" %llu\", (unsigned long long)sum);
    printf(\"\\n\");
    top.final();
}}
"
    )
}

fn write(path: &Path, text: &str) -> Result<(), VerilatedError> {
    fs::write(path, text).map_err(|error| VerilatedError::Io(path.display().to_string(), error))
}

fn run(command: &mut Command) -> Result<Output, VerilatedError> {
    let name = command.get_program().to_string_lossy().into_owned();
    let output = command.output().map_err(|error| VerilatedError::Io(name.clone(), error))?;
    if output.status.success() {
        Ok(output)
    } else {
        let said = [&output.stdout[..], &output.stderr[..]].concat();
        Err(VerilatedError::Failed(name, String::from_utf8_lossy(&said).into_owned()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use equivalence::Stimulus;
    use lanes::{Compiled, LANES};
    use netlist::Engine;
    use netlist::{Change, Mutation, flatten, mutate};
    use pipelines::catalogue::{StandardFormat, Top};
    use testing::tools::available;

    /// All outputs of a compiled top in every cycle, lane after lane.
    fn compiled(top: Top, cycles: &[Vec<Vec<u64>>]) -> Vec<Vec<Vec<u64>>> {
        let program = compiled::program(top, StandardFormat::Binary32).unwrap();
        let mut engine = Compiled::new(program);
        let mut shown = vec![Vec::new(); cycles.len()];
        for cycle in 0..cycles[0].len() {
            for (lane, inputs) in cycles.iter().enumerate() {
                (inputs[cycle].iter().enumerate()).for_each(|(i, &x)| engine.set_input(i, lane, x.into()));
            }
            engine.settle();
            for (lane, shown) in shown.iter_mut().enumerate() {
                shown.push((0..program.outputs.len()).map(|o| engine.output(o, lane) as u64).collect());
            }
            engine.clock();
        }
        shown
    }

    fn streams(top: Top, cycles: usize) -> Vec<Vec<Vec<u64>>> {
        let netlist = flatten(&top.design(StandardFormat::Binary32).unwrap()).unwrap();
        let stream = |lane: usize| {
            let stimulus = Stimulus::new(top, StandardFormat::Binary32, &netlist, lane as u64);
            stimulus.take(cycles).map(|inputs| inputs.into_iter().map(|x| x as u64).collect()).collect()
        };
        (0..LANES).map(stream).collect()
    }

    /// Verilator's model starts each stream at power-up: each lane is a run of its own.
    #[test]
    fn verilator_shows_the_same_outputs_in_every_cycle() {
        if !available("verilator") {
            return;
        }
        for top in [Top::FpAdd, Top::DualSplit] {
            let folder = tempfile::tempdir().unwrap();
            let model =
                Verilated::build(&top.design(StandardFormat::Binary32).unwrap(), folder.path()).unwrap();
            let streams = streams(top, 4_000);
            for (lane, (inputs, shown)) in streams.iter().zip(compiled(top, &streams)).enumerate() {
                let run = model.run(inputs, 1, 0).unwrap();
                assert!(run.outputs == shown, "{top}, lane {lane}");
            }
        }
    }

    #[test]
    fn verilator_shows_a_fault() {
        if !available("verilator") {
            return;
        }
        let folder = tempfile::tempdir().unwrap();
        let design = Top::FpCmp.design(StandardFormat::Binary32).unwrap();
        let fault =
            Mutation { module: "fp_cmp".into(), value: "ordered".into(), change: Change::Constant(1) };
        let model = Verilated::build(&mutate(&design, &fault).unwrap(), folder.path()).unwrap();
        let streams = streams(Top::FpCmp, 2_000);
        let run = model.run(&streams[0], 1, 0).unwrap();
        assert!(run.outputs != compiled(Top::FpCmp, &streams)[0]);
    }
}
