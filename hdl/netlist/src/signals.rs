//! What the names of a kernel mean: the symbol table of one block.

use std::collections::BTreeMap;

use rust_hdl_core::ast::Verilog;
use rust_hdl_core::prelude::AtomKind;

use super::design::{Parameter, Port, SignalType};
use super::error::ErrorKind;
use super::graph::{MAX_WIDTH, Op};
use super::keywords::is_keyword;
use super::module::{REGISTER, RESET_REGISTER};
use super::probe::{AtomDecl, Scope};

/// What a name stands for when the kernel reads it, or that the kernel assigns it.
#[derive(Clone, Debug, PartialEq)]
pub enum Role {
    /// A value that arrives: an input, a register's or an instance's output.
    Source(Op),
    /// A `Constant` field.
    Constant(u128),
    /// The module's clock.
    Clock,
    /// Something the kernel assigns, by its position in [`Signals::targets`].
    Target(usize),
}

/// A name of the kernel.
#[derive(Clone, Debug)]
pub struct Signal {
    /// Width in bits.
    pub width: u32,
    /// How the bits are meant.
    pub signal_type: SignalType,
    /// What it stands for.
    pub role: Role,
}

/// Where an assigned value goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Destination {
    /// A local signal; its value is used inside the kernel only.
    Local,
    /// An output of the module, by position.
    Output(usize),
    /// The data input of a register, by position.
    RegisterData(usize),
    /// The enable input of a register, by position.
    RegisterEnable(usize),
    /// An input of an instance: instance and input by position.
    InstanceInput(usize, usize),
    /// A clock input of a register or an instance.
    Clock,
}

/// Something that the kernel assigns.
#[derive(Clone, Debug)]
pub struct Target {
    /// Name in the kernel.
    pub name: String,
    /// Width in bits.
    pub width: u32,
    /// How the bits are meant.
    pub signal_type: SignalType,
    /// Where the value goes.
    pub destination: Destination,
}

/// A register among the children of a block.
#[derive(Clone, Debug)]
pub struct RegisterDecl {
    /// Name of the child.
    pub name: String,
    /// Width in bits.
    pub width: u32,
    /// How the bits are meant.
    pub signal_type: SignalType,
    /// Value at power-up.
    pub initial: u128,
    /// Whether reset clears it.
    pub has_reset: bool,
    /// Whether it has an enable input.
    pub has_enable: bool,
}

/// The symbol table of a block, with the interface it implies.
#[derive(Clone, Debug, Default)]
pub struct Signals {
    /// Every name of the kernel.
    pub by_name: BTreeMap<String, Signal>,
    /// Value of each enum label, `Type$Label`.
    pub labels: BTreeMap<String, (u128, u32)>,
    /// Everything assignable.
    pub targets: Vec<Target>,
    /// Inputs without the clock.
    pub inputs: Vec<Port>,
    /// Outputs.
    pub outputs: Vec<Port>,
    /// Name of the clock input.
    pub clock: Option<String>,
    /// `Constant` fields.
    pub parameters: Vec<Parameter>,
    /// Children that are registers.
    pub registers: Vec<RegisterDecl>,
}

impl Scope {
    /// Whether the block is a register, by its first timing entry.
    pub fn is_register(&self) -> bool {
        self.timing.as_ref().is_some_and(|timing| [REGISTER, RESET_REGISTER].contains(&&*timing.name))
    }
}

impl Signals {
    /// The symbol table of `scope`. Instances are its children that are no registers, in order.
    pub fn of(scope: &Scope) -> Result<Self, ErrorKind> {
        let mut table = Self::default();
        for atom in &scope.atoms {
            table.add_atom(atom)?;
        }
        let mut instance = 0;
        for child in &scope.children {
            check_name(&child.name)?;
            if child.is_register() {
                table.add_register(child)?;
            } else {
                table.add_instance(child, instance)?;
                instance += 1;
            }
        }
        Ok(table)
    }

    fn add_atom(&mut self, atom: &AtomDecl) -> Result<(), ErrorKind> {
        let width = checked_width(atom)?;
        check_name(&atom.name)?;
        self.add_labels(atom, width);
        let port = Port { name: self.port_name(&atom.name), width, signal_type: atom.signal_type.clone() };
        let role = match atom.kind {
            AtomKind::InputParameter if atom.is_clock => {
                if self.clock.replace(self.port_name(&atom.name)).is_some() {
                    return Err(ErrorKind::Clock(atom.name.clone()));
                }
                Role::Clock
            }
            _ if atom.is_clock => return Err(ErrorKind::Clock(atom.name.clone())),
            AtomKind::InputParameter => {
                self.inputs.push(port);
                Role::Source(Op::Input(self.inputs.len() as u32 - 1))
            }
            AtomKind::OutputParameter => {
                self.outputs.push(port);
                self.add_target(&atom.name, atom, width, Destination::Output(self.outputs.len() - 1))
            }
            AtomKind::LocalSignal => self.add_target(&atom.name, atom, width, Destination::Local),
            AtomKind::Constant => {
                let value = parse_literal(&atom.literal)?.0;
                let name = atom.name.clone();
                self.parameters.push(Parameter { name, width, value, is_tied_input: false });
                Role::Constant(value)
            }
            other => return Err(ErrorKind::NotUnderstood(format!("a signal of kind {other:?}"))),
        };
        self.add(&atom.name, atom, width, role);
        Ok(())
    }

    /// The name of the port that the signal `name` is: that of [`field_name`], or the whole name if another port has it.
    fn port_name(&self, name: &str) -> String {
        let short = field_name(name);
        let mut ports = self.inputs.iter().chain(&self.outputs);
        if ports.any(|port| port.name == short) { name.to_owned() } else { short }
    }

    fn add_register(&mut self, child: &Scope) -> Result<(), ErrorKind> {
        let Some(timing) = &child.timing else { return Ok(()) };
        let malformed = || {
            ErrorKind::NotUnderstood(format!("the register `{}`: timing() must name its ports", child.name))
        };
        let index = self.registers.len();
        let output = timing.outputs.first().ok_or_else(malformed)?;
        for atom in &child.atoms {
            let width = checked_width(atom)?;
            let full = format!("{}${}", child.name, atom.name);
            let role = if atom.is_clock {
                self.add_target(&full, atom, width, Destination::Clock)
            } else if Some(&atom.name) == timing.inputs.first() {
                self.add_target(&full, atom, width, Destination::RegisterData(index))
            } else if Some(&atom.name) == timing.inputs.get(1) {
                self.add_target(&full, atom, width, Destination::RegisterEnable(index))
            } else if &atom.name == output {
                self.registers.push(RegisterDecl {
                    name: child.name.clone(),
                    width,
                    signal_type: atom.signal_type.clone(),
                    initial: power_up_value(&child.code, output)?,
                    has_reset: timing.name == RESET_REGISTER,
                    has_enable: timing.inputs.len() > 1,
                });
                self.add_labels(atom, width);
                Role::Source(Op::Register(index as u32))
            } else {
                return Err(malformed());
            };
            self.add(&full, atom, width, role);
        }
        if self.registers.len() == index { Err(malformed()) } else { Ok(()) }
    }

    fn add_instance(&mut self, child: &Scope, instance: usize) -> Result<(), ErrorKind> {
        let (mut inputs, mut outputs) = (0, 0);
        for atom in &child.atoms {
            let width = checked_width(atom)?;
            let full = format!("{}${}", child.name, atom.name);
            let role = match atom.kind {
                AtomKind::InputParameter if atom.is_clock => {
                    self.add_target(&full, atom, width, Destination::Clock)
                }
                AtomKind::InputParameter => {
                    inputs += 1;
                    self.add_target(&full, atom, width, Destination::InstanceInput(instance, inputs - 1))
                }
                AtomKind::OutputParameter => {
                    outputs += 1;
                    Role::Source(Op::Instance { instance: instance as u32, output: outputs - 1 })
                }
                _ => continue,
            };
            self.add_labels(atom, width);
            self.add(&full, atom, width, role);
        }
        Ok(())
    }

    fn add(&mut self, name: &str, atom: &AtomDecl, width: u32, role: Role) {
        self.by_name.insert(name.to_owned(), Signal { width, signal_type: atom.signal_type.clone(), role });
    }

    fn add_target(&mut self, name: &str, atom: &AtomDecl, width: u32, destination: Destination) -> Role {
        let signal_type = atom.signal_type.clone();
        self.targets.push(Target { name: name.to_owned(), width, signal_type, destination });
        Role::Target(self.targets.len() - 1)
    }

    fn add_labels(&mut self, atom: &AtomDecl, width: u32) {
        if let SignalType::Enum(labels) = &atom.signal_type {
            for (value, label) in labels.iter().enumerate() {
                self.labels.insert(label.replace("::", "$"), (value as u128, width));
            }
        }
    }
}

/// The name of an interface's field without that of the interface, if it is a port's by its ending: `bounds$1$min_x_i` is
/// `min_x_i$1`. Every other name stays.
pub fn field_name(name: &str) -> String {
    let is_position = |part: &&str| part.starts_with(|c: char| c.is_ascii_digit());
    let (positions, mut names): (Vec<&str>, Vec<&str>) = name.split('$').partition(is_position);
    match names.pop() {
        Some(field) if field.ends_with("_i") || field.ends_with("_o") => {
            std::iter::once(field).chain(positions).collect::<Vec<_>>().join("$")
        }
        _ => name.to_owned(),
    }
}

fn checked_width(atom: &AtomDecl) -> Result<u32, ErrorKind> {
    match u32::try_from(atom.width) {
        Ok(width) if (1..=MAX_WIDTH).contains(&width) => Ok(width),
        _ => Err(ErrorKind::UnsupportedWidth(atom.width)),
    }
}

fn check_name(name: &str) -> Result<(), ErrorKind> {
    if is_keyword(name) { Err(ErrorKind::Keyword(name.to_owned())) } else { Ok(()) }
}

/// Value and width of a literal as rust-hdl prints it: `8'hff`, `3'b101`.
pub fn parse_literal(text: &str) -> Result<(u128, u32), ErrorKind> {
    let malformed = || ErrorKind::NotUnderstood(format!("the literal {text}"));
    let (width, digits) = text.split_once('\'').ok_or_else(malformed)?;
    let radix = if digits.starts_with('b') { 2 } else { 16 };
    let value = u128::from_str_radix(digits.get(1..).unwrap_or(""), radix).map_err(|_| malformed())?;
    Ok((value, width.parse().map_err(|_| malformed())?))
}

/// The value that the register's own Verilog gives it at power-up, `q = 8'h0;` in its `initial` block; 0 without one.
fn power_up_value(code: &Verilog, output: &str) -> Result<u128, ErrorKind> {
    let Verilog::Custom(text) = code else { return Ok(0) };
    let Some((_, rest)) = text.split_once("initial") else { return Ok(0) };
    let assigned = rest.split_once(&format!("{output} =")).and_then(|(_, value)| value.split_once(';'));
    assigned.map_or(Ok(0), |(literal, _)| Ok(parse_literal(literal.trim())?.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fields_that_are_ports_by_their_ending_have_their_own_names() {
        for (signal, port) in [
            ("a_i", "a_i"),
            ("hit_o$3", "hit_o$3"),
            ("clocking$clk_i", "clk_i"),
            ("ray$origin$origin_x_i", "origin_x_i"),
            ("bounds$1$box_min_x_i", "box_min_x_i$1"),
            ("bus$data", "bus$data"),
            ("bus$2$data", "bus$2$data"),
        ] {
            assert_eq!(field_name(signal), port);
        }
    }
}
