//! The packed words of a pipeline's stream: which field lies where, as a SystemVerilog package and as a C header.
//!
//! Every field is one word, so that a C structure has no gaps. Fields are grouped into what they describe: ray, node, box, result.

use std::fmt::Write;

use super::ResultCode;
use super::meaning::meaning;
use super::stream::Payload;
use crate::Design;

/// A field of a packed word.
pub(super) struct Field {
    /// The pipeline's port.
    pub port: String,
    /// Width in bits.
    pub width: u32,
    /// Position of the lowest bit.
    pub low: u32,
    /// What it describes: the structure that it is in.
    group: &'static str,
}

/// The fields of both directions, without the tag.
pub(super) struct Words<'a> {
    /// Bits of a field's word: 8, 16 or 32, as many as the widest field needs.
    pub word_bits: u32,
    /// Fields of the operands, the lowest first.
    pub operands: Vec<Field>,
    /// Fields of the results, the lowest first.
    pub results: Vec<Field>,
    codes: &'a [ResultCode],
}

impl Field {
    /// The field's bits of the signal `word`.
    pub fn slice(&self, word: &str) -> String {
        match self.width {
            1 => format!("{word}[{}]", self.low),
            width => format!("{word}[{}:{}]", self.low + width - 1, self.low),
        }
    }

    /// The bits of its word above the field, if there are any.
    pub fn padding(&self, word: &str, word_bits: u32) -> Option<String> {
        (self.width < word_bits)
            .then(|| format!("{word}[{}:{}]", self.low + word_bits - 1, self.low + self.width))
    }

    /// The port without its direction.
    fn name(&self) -> &str {
        self.port.strip_suffix("_i").or_else(|| self.port.strip_suffix("_o")).unwrap_or(&self.port)
    }
}

impl<'a> Words<'a> {
    pub fn of(payload: &Payload, codes: &'a [ResultCode]) -> Self {
        let widest =
            payload.operands.iter().chain(&payload.results).map(|(_, width)| *width).max().unwrap_or(1);
        let word_bits = widest.next_power_of_two().max(8);
        let fields = |wires: &[(String, u32)]| -> Vec<Field> {
            let data = wires.iter().filter(|(name, _)| !name.starts_with("tag_"));
            (0..)
                .zip(data)
                .map(|(i, (port, width))| Field {
                    port: port.clone(),
                    width: *width,
                    low: i * word_bits,
                    group: group(port),
                })
                .collect()
        };
        Self { word_bits, operands: fields(&payload.operands), results: fields(&payload.results), codes }
    }

    /// The structures with their fields: each group of operands in order, then the results.
    fn structures(&self) -> Vec<(&'static str, Vec<&Field>)> {
        let mut list: Vec<(&'static str, Vec<&Field>)> = Vec::new();
        for field in self.operands.iter().chain(&self.results) {
            match list.last_mut() {
                Some((name, fields)) if *name == field.group => fields.push(field),
                _ => list.push((field.group, vec![field])),
            }
        }
        list
    }

    /// `<top>_pkg.sv`.
    pub fn package(&self, design: &Design) -> String {
        let top = &design.top().name;
        let mut text = format!(
            "// {top}_pkg: the words of {top}_axis; written by dualsplit {}, do not edit.\n\
             package {top}_pkg;\n\n  typedef logic [{}:0] word_t;\n",
            env!("CARGO_PKG_VERSION"),
            self.word_bits - 1
        );
        let structures = self.structures();
        for (name, fields) in &structures {
            text.push_str("\n  typedef struct packed {\n");
            // The first member of a packed structure is its highest.
            for field in fields.iter().rev() {
                let _ = writeln!(
                    text,
                    "    word_t {};  // {}",
                    field.name(),
                    meaning(&field.port).unwrap_or_default()
                );
            }
            let _ = writeln!(text, "  }} {name}_t;");
        }
        text.push_str("\n  typedef struct packed {\n");
        for (name, _) in structures.iter().rev().filter(|(name, _)| *name != RESULT) {
            let member = if *name == BOX { "bounds" } else { name };
            let _ = writeln!(text, "    {name}_t {member};");
        }
        text.push_str("  } operands_t;\n");
        if !self.codes.is_empty() {
            text.push_str("\n  // verilator lint_off UNUSEDPARAM");
            for ResultCode { name, value, meaning } in self.codes {
                let bits = self.word_bits;
                let _ = write!(text, "\n  localparam word_t Code{name} = {bits}'d{value};  // {meaning}");
            }
            text.push_str("\n  // verilator lint_on UNUSEDPARAM");
        }
        text.push_str("\nendpackage\n");
        text
    }

    /// `<top>.h`.
    pub fn header(&self, design: &Design) -> String {
        let top = &design.top().name;
        let guard = format!("DUALSPLIT_{}_H", top.to_uppercase());
        let word = format!("uint{}_t", self.word_bits);
        let mut text = format!(
            "/* {top}.h: the words of {top}_axis; written by dualsplit {}, do not edit.\n\
             \x20* On a little-endian machine, the bytes of a structure are those of TDATA, the lowest first. */\n\
             #ifndef {guard}\n#define {guard}\n\n#include <stdint.h>\n",
            env!("CARGO_PKG_VERSION")
        );
        let structures = self.structures();
        for (name, fields) in &structures {
            let _ = writeln!(text, "\nstruct {top}_{name} {{");
            for field in fields {
                let _ = writeln!(
                    text,
                    "    {word} {}; /* {} */",
                    field.name(),
                    meaning(&field.port).unwrap_or_default()
                );
            }
            text.push_str("};\n");
        }
        let _ = writeln!(text, "\nstruct {top}_operands {{");
        for (name, _) in structures.iter().filter(|(name, _)| *name != RESULT) {
            let member = if *name == BOX { "bounds" } else { name };
            let _ = writeln!(text, "    struct {top}_{name} {member};");
        }
        text.push_str("};\n");
        for ResultCode { name, value, meaning } in self.codes {
            let _ = write!(
                text,
                "\n#define {}_CODE_{} {value} /* {meaning} */",
                top.to_uppercase(),
                name.to_uppercase()
            );
        }
        text.push_str("\n#endif\n");
        text
    }
}

const BOX: &str = "box";
const RESULT: &str = "result";

fn group(port: &str) -> &'static str {
    let starts = |names: &[&str]| names.iter().any(|name| port.starts_with(name));
    match port {
        _ if port.ends_with("_o") => RESULT,
        _ if starts(&["header", "plane"]) => "node",
        _ if starts(&["box"]) => BOX,
        _ => "ray",
    }
}
