//! ABC as another mapper, where it is installed: a graph goes there as AIGER, and comes back as cells of the library.
//!
//! The scripts are fixed here and in [`netlist::verilog`], whose packages use the fastest, so that comparisons with them stay
//! comparable. `{D}` is the delay in picoseconds that ABC may use between registers. Every script buffers and sizes its cells.

use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use crate::aig::{Aig, Lit, Node, Origin};
use crate::aiger::{self, Form};
use crate::liberty::{LibertyError, Library, file_text};
use crate::map::netlist::{clock_gating, enables};
use crate::map::{Gate, Mapped, Register};
use crate::prove::copy;

/// A script: what it does to the graph, and how it maps to cells within the delay `{D}`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Script {
    /// Its name in tables.
    pub name: &'static str,
    /// Commands on the graph.
    pub restructure: &'static str,
    /// Commands that map it.
    pub map: &'static str,
}

/// The smallest, the usual and the fastest.
pub const SCRIPTS: [Script; 3] = [
    Script {
        name: "area",
        restructure: "strash; dc2",
        map: "map -a; topo; buffer -c; topo; upsize -D {D}; dnsize -D {D}",
    },
    Script {
        name: "usual",
        restructure: "strash; dch",
        map: "map -D {D}; topo; buffer -c; topo; upsize -D {D}; dnsize -D {D}",
    },
    Script { name: "restructuring", restructure: netlist::verilog::RESTRUCTURE, map: netlist::verilog::MAP },
];

/// Why ABC gives no netlist.
#[derive(Debug, thiserror::Error)]
pub enum AbcError {
    /// The tool cannot be run.
    #[error("ABC: {0}; install yosys-abc or berkeley-abc, or leave out what needs it")]
    Missing(std::io::Error),
    /// A file cannot be written or read.
    #[error("{path}: {source}", path = .path.display())]
    File {
        /// The file.
        path: PathBuf,
        /// The system's reason.
        source: std::io::Error,
    },
    /// A liberty file cannot be read.
    #[error(transparent)]
    Liberty(#[from] LibertyError),
    /// It ends without a netlist.
    #[error("ABC writes no netlist: {0}")]
    Refused(String),
    /// Its netlist is not of this graph and library.
    #[error("ABC's netlist: {0}")]
    Netlist(String),
}

/// The name under which ABC is installed, if it is.
#[must_use]
pub fn installed() -> Option<&'static str> {
    let starts = |name: &&str| Command::new(name).args(["-q", "quit"]).stdin(Stdio::null()).output().is_ok();
    ["yosys-abc", "berkeley-abc"].into_iter().find(starts)
}

/// Maps a graph by a script within each of some delays in picoseconds. Files go into `folder`. ABC sees no origins: a cell gets
/// the one that [`Mapped::attribute`] finds.
///
/// # Errors
/// [`AbcError`] when ABC is missing or refuses, or uses a cell that `library` has not.
pub fn map(
    aig: &Aig,
    library: &Library,
    liberty: &[PathBuf],
    script: &Script,
    delays_ps: &[f64],
    folder: &Path,
) -> Result<Vec<Mapped>, AbcError> {
    let write = |name: &str, bytes: &[u8]| {
        let path = folder.join(name);
        std::fs::write(&path, bytes).map_err(|source| AbcError::File { path, source })
    };
    let mut bytes = Vec::new();
    aiger::write(&between_registers(aig), Form::Binary, &mut bytes).expect("memory can be written");
    write("graph.aig", &bytes)?;
    let inverter = &library.cells[library.inverter()];
    let load_ff = 4.0 * inverter.capacitance_ff[0];
    write("constraint", format!("set_driving_cell {}\nset_load {load_ff}\n", inverter.name).as_bytes())?;
    let mut commands = String::new();
    for (position, path) in liberty.iter().enumerate() {
        let name = format!("cells{position}.lib");
        write(&name, file_text(path)?.as_bytes())?;
        commands += &format!("read_lib {}-w {name}; ", if position == 0 { "" } else { "-m " });
    }
    commands += &format!("read_constr constraint; read_aiger graph.aig; {}; backup; ", script.restructure);
    for (position, delay) in delays_ps.iter().enumerate() {
        let map = script.map.replace("{D}", &format!("{delay:.0}"));
        commands += &format!("restore; {map}; write_blif mapped{position}.blif; ");
    }
    let name = installed().unwrap_or("yosys-abc");
    let output = Command::new(name)
        .args(["-q", &commands])
        .current_dir(folder)
        .stdin(Stdio::null())
        .output()
        .map_err(AbcError::Missing)?;
    let mut mapped = Vec::new();
    for position in 0..delays_ps.len() {
        let path = folder.join(format!("mapped{position}.blif"));
        let Ok(text) = std::fs::read_to_string(&path) else {
            let log = String::from_utf8_lossy(&output.stdout).into_owned();
            return Err(AbcError::Refused(log.lines().last().unwrap_or("no message").to_owned()));
        };
        let _ = std::fs::remove_file(path);
        mapped.push(read(&text, aig, library)?);
    }
    Ok(mapped)
}

/// The logic between registers: a latch's output is an input; its data is an output, as is each enable.
fn between_registers(aig: &Aig) -> Aig {
    let mut result = Aig::default();
    let count = aig.inputs().len();
    let sources: Vec<Lit> =
        (0..count + aig.latches().len()).map(|position| result.add_input(format!("i{position}"))).collect();
    let map = copy(aig, &mut result, |node| match node {
        Node::Latch(latch) => sources[count + latch as usize],
        Node::Input(input) => sources[input as usize],
        Node::False | Node::And(..) => Lit::FALSE,
    });
    let data = aig.latches().iter().map(|latch| latch.data);
    let outputs = aig.outputs.iter().map(|output| output.lit);
    for (position, lit) in outputs.chain(data).chain(enables(aig)).enumerate() {
        result.add_output(format!("o{position}"), map[lit.node()].complement_if(lit.is_complemented()));
    }
    result
}

/// Reads a mapped netlist in BLIF. Its nets get numbers in the order in which they are named.
fn read(text: &str, aig: &Aig, library: &Library) -> Result<Mapped, AbcError> {
    let wrong = |what: &str| AbcError::Netlist(what.to_owned());
    let cells: HashMap<&str, usize> =
        library.cells.iter().enumerate().map(|(position, cell)| (cell.name.as_str(), position)).collect();
    let text = text.replace("\\\n", " ");
    // Net 0 is false and net 1 true.
    let mut nets: HashMap<&str, u32> = HashMap::new();
    let mut count = 2u32;
    let (mut inputs, mut outputs) = (Vec::new(), Vec::new());
    let mut gates: Vec<Gate> = Vec::new();
    let mut aliases: HashMap<u32, u32> = HashMap::new();
    let mut lines = text.lines().peekable();
    while let Some(line) = lines.next() {
        let mut words = line.split_whitespace();
        let kind = words.next().unwrap_or_default();
        let mut net = |name| {
            *nets.entry(name).or_insert_with(|| {
                count += 1;
                count - 1
            })
        };
        match kind {
            ".inputs" => inputs.extend(words.map(net)),
            ".outputs" => outputs.extend(words.map(net)),
            ".gate" => {
                let name = words.next().unwrap_or_default();
                let tie =
                    library.ties.iter().position(|tie| tie.as_ref().is_some_and(|(tie, _)| tie == name));
                let pins: HashMap<&str, &str> = words.filter_map(|word| word.split_once('=')).collect();
                if let Some(value) = tie {
                    for driven in pins.values() {
                        aliases.insert(net(driven), value as u32);
                    }
                    continue;
                }
                let Some(&position) = cells.get(name) else {
                    return Err(AbcError::Netlist(format!("the library has no cell {name} to map to")));
                };
                let cell = &library.cells[position];
                let mut pin = |pin: &String| pins.get(pin.as_str()).map(|name| net(name));
                let found: Option<Vec<u32>> = cell.inputs.iter().map(&mut pin).collect();
                let (Some(inputs), Some(output)) = (found, pin(&cell.output)) else {
                    return Err(AbcError::Netlist(format!("a {name} lacks a pin")));
                };
                gates.push(Gate { cell: position, inputs, output, origin: Origin::default() });
            }
            ".names" => {
                let named: Vec<u32> = words.map(net).collect();
                let row = lines.next_if(|line| !line.starts_with('.')).unwrap_or_default().trim();
                let (from, to) = match (named.as_slice(), row) {
                    ([to], "1") => (1, *to),
                    ([to], _) => (0, *to),
                    ([from, to], "1 1") => (*from, *to),
                    _ => return Err(wrong("a table is neither a constant nor a wire")),
                };
                aliases.insert(to, from);
            }
            _ => (),
        }
    }
    let driver = |net: u32| {
        let mut net = net;
        while let Some(&from) = aliases.get(&net) {
            net = from;
        }
        net
    };
    if inputs.len() != aig.inputs().len() + aig.latches().len()
        || outputs.len() != aig.outputs.len() + aig.latches().len() + enables(aig).count()
    {
        return Err(wrong("it has other ports than the graph"));
    }
    for gate in &mut gates {
        gate.inputs.iter_mut().for_each(|net| *net = driver(*net));
    }
    let registers = inputs.split_off(aig.inputs().len());
    let mut data = outputs.split_off(aig.outputs.len());
    let gated = data.split_off(aig.latches().len());
    let registers = (registers.into_iter().zip(data).enumerate())
        .map(|(latch, (output, data))| {
            let origin = aig.latches()[latch].origin;
            Register { latch, data: driver(data), output, origin }
        })
        .collect();
    let mut mapped = Mapped {
        gates: in_order(gates, count as usize).ok_or_else(|| wrong("it has a loop"))?,
        registers,
        clock_gating: clock_gating(aig, gated.into_iter().map(driver)),
        inputs,
        outputs: outputs.into_iter().map(driver).collect(),
        nets: count as usize,
        literals: Vec::new(),
    };
    mapped.attribute(aig, library);
    Ok(mapped)
}

/// Gates with operands before users; none if there is a loop.
fn in_order(gates: Vec<Gate>, nets: usize) -> Option<Vec<Gate>> {
    let mut driver: Vec<Option<usize>> = vec![None; nets];
    for (position, gate) in gates.iter().enumerate() {
        driver[gate.output as usize] = Some(position);
    }
    // Of each gate: not seen, open, placed.
    let mut state = vec![0u8; gates.len()];
    let mut order = Vec::with_capacity(gates.len());
    for root in 0..gates.len() {
        let mut stack = vec![root];
        while let Some(&gate) = stack.last() {
            let mut open = gates[gate].inputs.iter().filter_map(|&net| driver[net as usize]);
            if state[gate] == 2 {
                stack.pop();
            } else if std::mem::replace(&mut state[gate], 1) == 0 {
                stack.extend(open.filter(|&below| state[below] != 2));
            } else if open.any(|below| state[below] != 2) {
                return None;
            } else {
                state[gate] = 2;
                order.push(gate);
                stack.pop();
            }
        }
    }
    let mut gates: Vec<Option<Gate>> = gates.into_iter().map(Some).collect();
    order.into_iter().map(|gate| gates[gate].take()).collect()
}
