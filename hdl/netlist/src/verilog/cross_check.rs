//! The proof that our Verilog is rust-hdl's: a yosys script that brings both into the same form for ABC.
//!
//! Both files become a sequential and-inverter graph with the same ports, whose registers start at zero, and ABC's
//! `dsec` decides whether they give equal outputs for every sequence of inputs. Multiplier arrays, on which no solver
//! succeeds, become black boxes on both sides: their operands are outputs of the graphs, and so proved equal, and
//! their products are inputs, any word at all. That is sound because both multiplier arrays come from the same
//! kernel. Other products are mapped by [`MULTIPLICATION`], because yosys' own choice of adder tree depends on names,
//! and ABC would meet two different trees.

use std::collections::BTreeMap;
use std::fmt::Write;

use rust_hdl_core::prelude::{Block, ModuleDefines};

use super::identifier::{CLOCK, Namespace, plain, port_names};
use crate::probe::read;
use crate::signals::field_name;
use crate::{Design, Module};

/// How both sides multiply: the file `multiply.v` that [`equivalence_script`] reads.
pub const MULTIPLICATION: &str = include_str!("multiply.v");

/// The Verilog that rust-hdl itself writes for a module: one module per instance, the top called `name`.
pub fn reference_verilog(module: &dyn Block, name: &str) -> String {
    let mut defines = ModuleDefines::default();
    module.accept(name, &mut defines);
    defines.defines()
}

/// A yosys script for `module`, elaborated as `design`, that writes `gold.aig` from `reference`, the file of [`reference_verilog`], and `gate.aig` from `ours`,
/// the file of [`super::text`]. Instances of the kinds in `black_boxes` are matched by name and not looked into.
#[must_use]
pub fn equivalence_script(
    module: &dyn Block,
    design: &Design,
    ours: &str,
    reference: &str,
    black_boxes: &[&str],
) -> String {
    let top = design.top();
    let name = &top.name;
    let mut boxes = Vec::new();
    find_boxes(design, top, black_boxes, ["", ""], name, &mut boxes);
    let mut text = String::new();

    let _ = writeln!(text, "read_verilog {reference}");
    for instance in &boxes {
        let _ = writeln!(text, "blackbox {}", instance.reference_module);
    }
    flatten(&mut text, name, boxes.iter().map(|instance| &instance.reference_path));
    let ports = port_names(top, &mut Namespace::default());
    let signals = signals_of_ports(module, name);
    let sources = top.inputs.iter().chain(top.outputs.iter().map(|(port, _)| port));
    let clock = top.clock.iter().map(|clock| (clock.as_str(), CLOCK));
    let names = sources.zip(ports.inputs.iter().chain(&ports.outputs));
    for (theirs, ours) in clock.chain(names.map(|(port, ours)| (port.name.as_str(), ours.as_str()))) {
        rename(&mut text, signals.get(theirs).map_or(theirs, String::as_str), ours);
    }
    text.push_str(&write_graph("gold.aig"));

    let _ = writeln!(text, "\ndesign -reset\nread_verilog {ours}");
    for module in design.modules.iter().filter(|module| black_boxes.contains(&module.kind.as_str())) {
        let _ = writeln!(text, "blackbox {}", module.name);
    }
    flatten(&mut text, name, boxes.iter().map(|instance| &instance.path));
    for instance in &boxes {
        for (ours, theirs) in &instance.ports {
            let (path, reference_path) = (&instance.path, &instance.reference_path);
            rename(&mut text, &format!("{path}.{ours}"), &format!("{reference_path}.{theirs}"));
        }
    }
    text.push_str(&write_graph("gate.aig"));
    text
}

/// The signal of each port, where that is the field of an interface: the reference has its whole name.
fn signals_of_ports(module: &dyn Block, name: &str) -> BTreeMap<String, String> {
    let atoms = read(module, name).map(|scope| scope.atoms).unwrap_or_default();
    atoms.into_iter().map(|atom| (field_name(&atom.name), atom.name)).collect()
}

/// Dissolves the hierarchy, turns the ports of black boxes into ports of the top, and goes into it.
fn flatten<'b>(text: &mut String, top: &str, boxes: impl Iterator<Item = &'b String>) {
    let boxes: Vec<String> = boxes.map(|path| format!(" {top}/c:{path}")).collect();
    let _ = writeln!(text, "hierarchy -top {top}\nproc\nflatten\nopt_expr -mux_undef -undriven -fine");
    if !boxes.is_empty() {
        let _ = writeln!(text, "expose -evert{}", boxes.concat());
    }
    let _ = writeln!(text, "cd {top}");
}

/// Leaves the top and writes it as a graph.
fn write_graph(file: &str) -> String {
    format!(
        "cd\nwreduce\nopt_merge\nopt_clean\ntechmap -map multiply.v\ntechmap\nsimplemap\naigmap\n\
         write_aiger -zinit -symbols {file}\n"
    )
}

fn rename(text: &mut String, from: &str, to: &str) {
    if from != to {
        let _ = writeln!(text, "rename {from} {to}");
    }
}

/// An instance that is not looked into.
struct BlackBox {
    path: String,
    reference_path: String,
    reference_module: String,
    /// Our and the reference's name of each port.
    ports: Vec<(String, String)>,
}

/// Collects the black boxes beneath `module`. `paths` are those of the module's instance here and in the reference,
/// each with a dot at its end.
fn find_boxes(
    design: &Design,
    module: &Module,
    kinds: &[&str],
    [ours, theirs]: [&str; 2],
    reference_module: &str,
    boxes: &mut Vec<BlackBox>,
) {
    let mut namespace = Namespace::default();
    port_names(module, &mut namespace);
    for register in &module.registers {
        namespace.claim(&plain(&register.name));
    }
    for instance in &module.instances {
        let child = design.module(instance.module);
        let path = format!("{ours}{}", namespace.claim(&plain(&instance.name)));
        let reference_path = format!("{theirs}{}", instance.name);
        let reference_module = format!("{reference_module}${}", instance.name);
        if !kinds.contains(&child.kind.as_str()) {
            let paths = [&*format!("{path}."), &*format!("{reference_path}.")];
            find_boxes(design, child, kinds, paths, &reference_module, boxes);
            continue;
        }
        let names = port_names(child, &mut Namespace::default());
        let sources = child.inputs.iter().chain(child.outputs.iter().map(|(port, _)| port));
        let ours = names.inputs.into_iter().chain(names.outputs);
        let ports = ours.zip(sources.map(|port| port.name.clone())).collect();
        boxes.push(BlackBox { path, reference_path, reference_module, ports });
    }
}
