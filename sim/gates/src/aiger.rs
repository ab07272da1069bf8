//! AIGER files, the exchange format of and-inverter graphs (Biere, "The AIGER And-Inverter Graph (AIG) Format Version
//! 20071012", and its extension 1.9 for latch reset values), ASCII and binary.
//!
//! A latch with a clock enable is written with a multiplexer before it. Dead nodes are not written.

use std::collections::BTreeMap;
use std::io::{self, Write};

use super::aig::{Aig, Lit, Node};

/// Why a file is no AIGER file.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("AIGER, byte {at}: {what}; write the file anew, in version 1 without properties")]
pub struct AigerError {
    /// Position in the file.
    pub at: usize,
    /// What is wrong there.
    pub what: &'static str,
}

/// The two forms of the format.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// `aag`, a line for each gate.
    Ascii,
    /// `aig`, a few bytes for each gate.
    Binary,
}

/// Writes a graph with the names of inputs, latches and outputs.
///
/// # Errors
/// Those of `out`.
pub fn write(aig: &Aig, form: Form, out: &mut dyn Write) -> io::Result<()> {
    let mut aig = aig.clone();
    let next: Vec<Lit> = (0..aig.latches().len()).map(|latch| aig.next_state(latch)).collect();
    let live = aig.cone(next.iter().copied().chain(aig.outputs.iter().map(|output| output.lit)));
    // The format numbers inputs first, then latches, then gates.
    let mut numbers = vec![0u32; aig.nodes().len()];
    let sources = aig.inputs().iter().map(|i| i.lit).chain(aig.latches().iter().map(|l| l.lit));
    let mut count = 0;
    for lit in sources {
        count += 1;
        numbers[lit.node()] = count;
    }
    let mut gates = Vec::new();
    for (node, found) in aig.nodes().iter().enumerate() {
        if let (Node::And(a, b), true) = (*found, live[node]) {
            count += 1;
            numbers[node] = count;
            gates.push((node, a, b));
        }
    }
    let code = |lit: Lit| numbers[lit.node()] << 1 | u32::from(lit.is_complemented());
    let (inputs, latches) = (aig.inputs().len(), aig.latches().len());
    let magic = if form == Form::Ascii { "aag" } else { "aig" };
    writeln!(out, "{magic} {count} {inputs} {latches} {} {}", aig.outputs.len(), gates.len())?;
    if form == Form::Ascii {
        for input in aig.inputs() {
            writeln!(out, "{}", code(input.lit))?;
        }
    }
    for (latch, next) in aig.latches().iter().zip(next) {
        if form == Form::Ascii {
            write!(out, "{} ", code(latch.lit))?;
        }
        writeln!(out, "{}{}", code(next), if latch.initial { " 1" } else { "" })?;
    }
    for output in &aig.outputs {
        writeln!(out, "{}", code(output.lit))?;
    }
    for (node, a, b) in gates {
        let (low, high) = (code(a).min(code(b)), code(a).max(code(b)));
        let own = numbers[node] << 1;
        match form {
            Form::Ascii => writeln!(out, "{own} {high} {low}")?,
            Form::Binary => {
                write_delta(out, own - high)?;
                write_delta(out, high - low)?;
            }
        }
    }
    for (position, input) in aig.inputs().iter().enumerate() {
        writeln!(out, "i{position} {}", input.name)?;
    }
    for (position, latch) in aig.latches().iter().enumerate() {
        writeln!(out, "l{position} {}", latch.name)?;
    }
    for (position, output) in aig.outputs.iter().enumerate() {
        writeln!(out, "o{position} {}", output.name)?;
    }
    Ok(())
}

/// Seven bits a byte, the lowest first.
fn write_delta(out: &mut dyn Write, mut delta: u32) -> io::Result<()> {
    while delta >= 0x80 {
        out.write_all(&[delta as u8 | 0x80])?;
        delta >>= 7;
    }
    out.write_all(&[delta as u8])
}

/// Reads a file of either form. Latches that may start at any value start at zero.
///
/// # Errors
/// [`AigerError`] when the bytes are no AIGER file of version 1, or gates are not in order.
pub fn read(bytes: &[u8]) -> Result<Aig, AigerError> {
    Reader { bytes, at: 0 }.read()
}

struct Reader<'b> {
    bytes: &'b [u8],
    at: usize,
}

impl<'b> Reader<'b> {
    fn error(&self, what: &'static str) -> AigerError {
        AigerError { at: self.at, what }
    }

    fn line(&mut self) -> Result<&'b str, AigerError> {
        let rest = &self.bytes[self.at..];
        let length =
            rest.iter().position(|&byte| byte == b'\n').ok_or_else(|| self.error("no end of line"))?;
        let line = std::str::from_utf8(&rest[..length]).map_err(|_| self.error("not UTF-8"))?;
        self.at += length + 1;
        Ok(line)
    }

    fn numbers(&mut self) -> Result<Vec<u32>, AigerError> {
        let line = self.line()?;
        let parsed: Result<Vec<u32>, _> = line.split_whitespace().map(str::parse).collect();
        parsed.map_err(|_| self.error("not a number"))
    }

    fn delta(&mut self) -> Result<u32, AigerError> {
        let mut value = 0u32;
        for shift in (0..32).step_by(7) {
            let byte = *self.bytes.get(self.at).ok_or_else(|| self.error("the file ends in a gate"))?;
            self.at += 1;
            value |= u32::from(byte & 0x7f)
                .checked_shl(shift)
                .ok_or_else(|| self.error("a difference is too large"))?;
            if byte & 0x80 == 0 {
                return Ok(value);
            }
        }
        Err(self.error("a difference is too large"))
    }

    fn read(mut self) -> Result<Aig, AigerError> {
        let header = self.line()?;
        let binary = match header.get(..4) {
            Some("aag ") => false,
            Some("aig ") => true,
            _ => return Err(AigerError { at: 0, what: "neither `aag` nor `aig`" }),
        };
        let counts: Result<Vec<usize>, _> = header[4..].split_whitespace().map(str::parse).collect();
        let counts = counts.ok().filter(|counts| counts.len() == 5);
        let [_, inputs, latches, outputs, gates] = counts
            .and_then(|counts| <[usize; 5]>::try_from(counts).ok())
            .ok_or(AigerError { at: 4, what: "not five counts" })?;
        if inputs.max(latches).max(outputs).max(gates) > self.bytes.len() * 16 {
            return Err(AigerError { at: 4, what: "counts beyond the file's length" });
        }
        let mut aig = Aig::default();
        // The literal of each of the file's variables, once it is known.
        let mut map: BTreeMap<u32, Lit> = BTreeMap::from([(0, Lit::FALSE)]);
        for position in 0..inputs {
            let variable =
                if binary { position as u32 + 1 } else { self.numbers()?.first().copied().unwrap_or(0) / 2 };
            map.insert(variable, aig.add_input(format!("i{position}")));
        }
        let mut next = Vec::new();
        for position in 0..latches {
            let mut numbers = self.numbers()?;
            if binary {
                numbers.insert(0, 2 * (inputs + position + 1) as u32);
            }
            let [own, data, rest @ ..] = numbers.as_slice() else {
                return Err(self.error("a latch without next state"));
            };
            map.insert(own / 2, aig.add_latch(format!("l{position}"), rest == [1]));
            next.push(*data);
        }
        let mut driven = Vec::new();
        for _ in 0..outputs {
            driven.push(*self.numbers()?.first().ok_or_else(|| self.error("an output without literal"))?);
        }
        for position in 0..gates {
            let [own, high, low] = if binary {
                let own = 2 * (inputs + latches + position + 1) as u32;
                let first = self.delta()?;
                let second = self.delta()?;
                let high = own.checked_sub(first).ok_or_else(|| self.error("a negative literal"))?;
                [own, high, high.checked_sub(second).ok_or_else(|| self.error("a negative literal"))?]
            } else {
                <[u32; 3]>::try_from(self.numbers()?).map_err(|_| self.error("a gate has three numbers"))?
            };
            let [high, low] = [high, low].map(|code| lookup(&map, code));
            let (Some(high), Some(low)) = (high, low) else {
                return Err(self.error("a gate before its operands"));
            };
            let gate = aig.and(high, low);
            map.insert(own / 2, gate);
        }
        for (latch, code) in next.into_iter().enumerate() {
            let data = lookup(&map, code).ok_or_else(|| self.error("a latch of an unknown literal"))?;
            aig.drive_latch(latch, data, Lit::TRUE);
        }
        for (position, code) in driven.into_iter().enumerate() {
            let lit = lookup(&map, code).ok_or_else(|| self.error("an output of an unknown literal"))?;
            aig.add_output(format!("o{position}"), lit);
        }
        self.names(&mut aig)?;
        Ok(aig)
    }

    fn names(&mut self, aig: &mut Aig) -> Result<(), AigerError> {
        while self.at < self.bytes.len() {
            let line = self.line()?;
            if line == "c" {
                break;
            }
            let (symbol, name) = line.split_once(' ').ok_or_else(|| self.error("a symbol without name"))?;
            let position = symbol.get(1..).and_then(|digits| digits.parse().ok());
            let position: usize = position.ok_or_else(|| self.error("a symbol without position"))?;
            let known = match symbol.as_bytes()[0] {
                b'i' => aig.rename_input(position, name),
                b'l' => aig.rename_latch(position, name),
                b'o' => aig.outputs.get_mut(position).map(|output| name.clone_into(&mut output.name)),
                _ => None,
            };
            known.ok_or_else(|| self.error("a symbol of nothing"))?;
        }
        Ok(())
    }
}

fn lookup(map: &BTreeMap<u32, Lit>, code: u32) -> Option<Lit> {
    map.get(&(code / 2)).map(|lit| lit.complement_if(code & 1 == 1))
}
