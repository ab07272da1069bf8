//! The proof that our Verilog is rust-hdl's: a yosys script that shows the two equivalent.
//!
//! Registers are the cut points. Our file keeps the instance and register names of the source, rust-hdl's has a
//! module per register, so after flattening `mul.sum` here is `mul.sum.q` there; the script renames ours. Multiplier
//! arrays, on which no solver succeeds, become black boxes on both sides: their operands are proved equal and their
//! products assumed so, which is sound as the same kernel stands behind both.

use std::fmt::Write;

use rust_hdl_core::prelude::{Block, ModuleDefines};

use super::identifier::{CLOCK, Namespace, plain, port_names};
use crate::netlist::{Design, Module};

/// The Verilog that rust-hdl itself writes for a module: one module per instance, the top called `name`.
pub fn reference_verilog(module: &dyn Block, name: &str) -> String {
    let mut defines = ModuleDefines::default();
    module.accept(name, &mut defines);
    defines.defines()
}

/// A yosys script that fails unless `ours`, the file of [`super::text`], equals `reference`, the file of
/// [`reference_verilog`]. Instances of the kinds in `black_boxes` are matched by name and not looked into.
#[must_use]
pub fn equivalence_script(design: &Design, ours: &str, reference: &str, black_boxes: &[&str]) -> String {
    let top = design.top();
    let name = &top.name;
    let mut walk = Walk { design, black_boxes, registers: Vec::new(), boxes: Vec::new() };
    walk.module(top, "", "", name);
    let Walk { registers, boxes, .. } = walk;
    let mut text = String::new();

    let _ = writeln!(text, "read_verilog {reference}");
    for instance in &boxes {
        let _ = writeln!(text, "blackbox {}", instance.reference_module);
    }
    let _ = writeln!(text, "{}", flatten(name));
    for instance in &boxes {
        let _ = writeln!(text, "expose -evert {name}/c:{}", instance.reference_path);
    }
    let _ = writeln!(text, "cd {name}");
    let mut namespace = Namespace::default();
    let ports = port_names(top, &mut namespace);
    let sources = top.inputs.iter().chain(top.outputs.iter().map(|(port, _)| port));
    let clock = top.clock.iter().map(|clock| (clock.as_str(), CLOCK));
    let names = sources.zip(ports.inputs.iter().chain(&ports.outputs));
    for (theirs, ours) in clock.chain(names.map(|(port, ours)| (port.name.as_str(), ours.as_str()))) {
        rename(&mut text, theirs, ours);
    }
    let _ = writeln!(text, "cd\nrename {name} gold\ndesign -stash gold\n");

    let _ = writeln!(text, "read_verilog {ours}");
    for module in design.modules.iter().filter(|module| black_boxes.contains(&module.kind.as_str())) {
        let _ = writeln!(text, "blackbox {}", module.name);
    }
    let _ = writeln!(text, "{}", flatten(name));
    for instance in &boxes {
        let _ = writeln!(text, "expose -evert {name}/c:{}", instance.path);
    }
    let _ = writeln!(text, "cd {name}");
    for (ours, theirs) in &registers {
        rename(&mut text, ours, theirs);
    }
    for instance in &boxes {
        for (ours, theirs) in &instance.ports {
            let (path, reference_path) = (&instance.path, &instance.reference_path);
            rename(&mut text, &format!("{path}.{ours}"), &format!("{reference_path}.{theirs}"));
        }
    }
    let _ = write!(
        text,
        "cd\nrename {name} gate\ndesign -stash gate\n\n\
         design -copy-from gold -as gold gold\n\
         design -copy-from gate -as gate gate\n\
         equiv_make gold gate equiv\n\
         hierarchy -top equiv\n\
         opt -share_all\n\
         equiv_struct\n\
         equiv_simple -undef\n\
         equiv_induct -undef\n\
         equiv_status -assert\n"
    );
    text
}

fn flatten(top: &str) -> String {
    format!("hierarchy -top {top}\nproc\nflatten\nopt -full\nopt_clean")
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

/// Collects what has different names in the two files.
struct Walk<'d> {
    design: &'d Design,
    black_boxes: &'d [&'d str],
    registers: Vec<(String, String)>,
    boxes: Vec<BlackBox>,
}

impl Walk<'_> {
    fn module(&mut self, module: &Module, ours: &str, theirs: &str, reference_module: &str) {
        let mut namespace = Namespace::default();
        port_names(module, &mut namespace);
        for register in &module.registers {
            let name = namespace.claim(&plain(&register.name));
            self.registers.push((format!("{ours}{name}"), format!("{theirs}{}.q", register.name)));
        }
        for instance in &module.instances {
            let name = namespace.claim(&plain(&instance.name));
            let child = self.design.module(instance.module);
            let path = format!("{ours}{name}");
            let reference_path = format!("{theirs}{}", instance.name);
            let reference_module = format!("{reference_module}${}", instance.name);
            if !self.black_boxes.contains(&child.kind.as_str()) {
                self.module(child, &format!("{path}."), &format!("{reference_path}."), &reference_module);
                continue;
            }
            let names = port_names(child, &mut Namespace::default());
            let sources = child.inputs.iter().chain(child.outputs.iter().map(|(port, _)| port));
            let ours = names.inputs.into_iter().chain(names.outputs);
            let ports = ours.zip(sources.map(|port| port.name.clone())).collect();
            self.boxes.push(BlackBox { path, reference_path, reference_module, ports });
        }
    }
}
