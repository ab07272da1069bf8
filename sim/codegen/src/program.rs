//! The files: for each set of lanes the functions of all units, and a table of the programs.

use super::emit::Emitter;
use super::flush::flush;
use super::schedule::schedule;
use super::unit::{ENABLE, Kind, Logic, Place, Slot, Source, Unit, Units};
use netlist::{Design, Port, flatten};
use std::fmt::Write;
use std::path::Path;

/// Sets of lanes, by module, with the processor features that their functions need.
const SETS: [(&str, &str); 3] = [
    ("avx512", "#[target_feature(enable = \"avx512f,avx512bw,avx512cd,avx512dq\")]\n"),
    ("avx2", "#[target_feature(enable = \"avx2\")]\n"),
    ("scalar", ""),
];

/// Programs that share their units.
#[derive(Default)]
pub struct Programs {
    units: Units,
    list: Vec<Program>,
}

struct Program {
    /// The program's function names begin with this.
    name: String,
    /// Rust text of the key in the table.
    key: String,
    unit: usize,
    inputs: Vec<(Port, Slot)>,
    outputs: Vec<(Port, Slot)>,
    /// Memory of the unit and of the outputs behind it.
    size: Place,
    /// Text of the outputs as a function of the inputs alone.
    flush: Option<String>,
}

impl Programs {
    /// Adds the program of a design, with a function that flushes its pipeline if wanted.
    pub fn add(&mut self, design: &Design, key: &str, flushed: bool) {
        let position = self.units.add(design);
        let unit = &self.units.list[position];
        let top = design.top();
        let mut size = unit.size;
        let outputs: Vec<_> =
            top.outputs.iter().map(|(port, _)| (port.clone(), size.take(port.width))).collect();
        let inputs: Vec<_> = top.inputs.iter().cloned().zip(unit.inputs.iter().copied()).collect();
        let flush = flushed.then(|| {
            let flat = flatten(design).unwrap_or_else(|error| panic!("{}: {error}", top.name));
            let (graph, values) = flush(&flat).unwrap_or_else(|error| panic!("{}: {error}", top.name));
            let sources: Vec<Source> = unit.inputs.iter().map(|slot| Source::Memory(*slot)).collect();
            let mut emitter = Emitter::new(&graph, &sources);
            values.iter().for_each(|value| emitter.value(*value));
            outputs.iter().zip(&values).for_each(|((_, slot), value)| emitter.store(*slot, *value));
            emitter.text
        });
        let name = format!("program_{}_{}", self.list.len(), top.name);
        self.list.push(Program { name, key: key.to_owned(), unit: position, inputs, outputs, size, flush });
    }

    /// Writes `<set>_<stem>.rs` for each set, and `<stem>.rs` with the table.
    pub fn write(&self, folder: &Path, stem: &str, key_type: &str) {
        for (set, attribute) in SETS {
            let mut text = String::new();
            for (unit, name) in self.units.list.iter().zip(&self.units.names) {
                text += &self.steps(unit, name, attribute);
            }
            for program in &self.list {
                text += &self.entries(program, attribute, set == "scalar");
            }
            save(folder, &format!("{set}_{stem}.rs"), &text);
        }
        save(folder, &format!("{stem}.rs"), &self.table(key_type));
    }

    /// The functions that take a unit from one cycle to the next: one for any clock enable, and one for cycles in
    /// which all lanes are enabled.
    fn steps(&self, unit: &Unit, name: &str, attribute: &str) -> String {
        let any = self.step(unit, &unit.logic, name, attribute, |_, name| name.to_owned());
        let enabled = unit.enabled.as_ref().map(|logic| {
            self.step(unit, logic, &enabled_name(name), attribute, |child, name| match child.enabled {
                Some(_) => enabled_name(name),
                None => name.to_owned(),
            })
        });
        any + &enabled.unwrap_or_default()
    }

    fn step(
        &self,
        unit: &Unit,
        logic: &Logic,
        name: &str,
        attribute: &str,
        name_of_child: impl Fn(&Unit, &str) -> String,
    ) -> String {
        let mut emitter = Emitter::new(&logic.graph, &logic.sources);
        let (ordered, circular) = schedule(logic);
        for sink in ordered {
            emitter.value(sink.value);
            emitter.store(sink.slot, sink.value);
        }
        circular.iter().for_each(|sink| emitter.value(sink.value));
        circular.iter().for_each(|sink| emitter.store(sink.slot, sink.value));
        for child in &unit.children {
            let Place { row, bit } = child.place;
            let function = name_of_child(&self.units.list[child.unit], &self.units.names[child.unit]);
            let _ = writeln!(emitter.text, "    {function}(part(rows, {row}), part(bits, {bit}), chunk);");
        }
        format!("{attribute}#[inline(never)]\nfn {name}({}) {{\n{}}}\n\n", memory(unit.size), emitter.text)
    }

    /// The functions that the table names: clock, settle and, for one lane, flush.
    fn entries(&self, program: &Program, attribute: &str, is_scalar: bool) -> String {
        let Program { name, size, .. } = program;
        let (unit, step) = (&self.units.list[program.unit], &self.units.names[program.unit]);
        let mut emitter = Emitter::new(&unit.logic.graph, &unit.logic.sources);
        for ((_, slot), value) in program.outputs.iter().zip(&unit.logic.outputs) {
            emitter.value(*value);
            emitter.store(*slot, *value);
        }
        let enable =
            program.inputs.iter().find(|(port, _)| port.name == ENABLE).filter(|_| unit.enabled.is_some());
        let enabled = enable.map(|(_, slot)| {
            format!(
                "        if all_set(bits[{}], chunk) {{\n            {}(part(rows, 0), part(bits, 0), chunk);\n            \
                 continue;\n        }}\n",
                slot.place.bit,
                enabled_name(step)
            )
        });
        let whole = format!(
            "    let rows: &mut [Row; {}] = whole(rows);\n    let bits: &mut [Bits; {}] = whole(bits);\n    \
             for chunk in 0..CHUNKS {{\n",
            size.row, size.bit
        );
        let mut text = format!(
            "{attribute}#[inline(never)]\nfn {name}_outputs({}) {{\n{}}}\n\n\
             {attribute}pub fn {name}_settle(rows: &mut [Row], bits: &mut [Bits]) {{\n{whole}        \
             {name}_outputs(rows, bits, chunk);\n    }}\n}}\n\n\
             {attribute}pub fn {name}_clock(rows: &mut [Row], bits: &mut [Bits]) {{\n{whole}{}        \
             {step}(part(rows, 0), part(bits, 0), chunk);\n    }}\n}}\n\n",
            memory(*size),
            emitter.text,
            enabled.unwrap_or_default()
        );
        if let Some(flush) = program.flush.as_ref().filter(|_| is_scalar) {
            let _ = write!(
                text,
                "fn {name}_flush_chunk({}) {{\n{flush}}}\n\n\
                 pub fn {name}_flush(rows: &mut [Row], bits: &mut [Bits], lane: usize) {{\n    \
                 {name}_flush_chunk(whole(rows), whole(bits), lane);\n}}\n\n",
                memory(*size)
            );
        }
        text
    }

    fn table(&self, key_type: &str) -> String {
        let mut text = format!("pub static PROGRAMS: [({key_type}, Program); {}] = [\n", self.list.len());
        for program in &self.list {
            let ports = |ports: &[(Port, Slot)]| {
                ports.iter().map(|(port, slot)| port_text(port, *slot)).collect::<String>()
            };
            let initial = self.units.list[program.unit].initial.iter().filter(|(_, value)| *value != 0);
            let initial: String =
                initial.map(|(slot, value)| format!("({}, {value:#x}), ", slot_text(*slot))).collect();
            let flush = match &program.flush {
                Some(_) => format!("Some(scalar::{}_flush)", program.name),
                None => "None".to_owned(),
            };
            let _ = writeln!(
                text,
                "    ({}, Program {{ rows: {}, bits: {}, inputs: &[{}], outputs: &[{}], initial: &[{initial}], \
                 sets: sets!({name}_settle, {name}_clock), flush: {flush} }}),",
                program.key,
                program.size.row,
                program.size.bit,
                ports(&program.inputs),
                ports(&program.outputs),
                name = program.name,
            );
        }
        text + "];\n"
    }
}

/// The function of a unit for cycles in which all lanes are enabled.
fn enabled_name(name: &str) -> String {
    format!("{name}_enabled")
}

/// Parameters of a function on memory of this size.
fn memory(size: Place) -> String {
    format!("rows: &mut [Row; {}], bits: &mut [Bits; {}], chunk: usize", size.row, size.bit)
}

fn port_text(port: &Port, slot: Slot) -> String {
    format!("ProgramPort {{ name: {:?}, slot: {} }}, ", port.name, slot_text(slot))
}

fn slot_text(slot: Slot) -> String {
    let Slot { width, place } = slot;
    match Kind::of(width) {
        Kind::Bit => format!("Slot::Bit({})", place.bit),
        Kind::Word => format!("Slot::Word({}, {width})", place.row),
        Kind::Double => format!("Slot::Double({}, {width})", place.row),
    }
}

fn save(folder: &Path, file: &str, text: &str) {
    let path = folder.join(file);
    std::fs::write(&path, text).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
}
