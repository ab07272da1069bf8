//! All pairs of operands of a format of at most 16 bits, in every mode of the unit.
//!
//! A block is one first operand in one mode with all second operands. They are fed back to back, one in each lane and
//! cycle.

use super::Totals;
use super::oracle::Oracle;
use crate::interpreter::Interpreter;
use fp::{Format, NanMode, Rounding};
use lanes::Compiled;
use netlist::Engine;
use netlist::{Flat, flatten};
use pipelines::catalogue::{StandardFormat, Top};
use rayon::prelude::*;
use serde::{Deserialize, Serialize};
use std::fmt;
use std::str::FromStr;

/// Widest format whose pairs are all checked.
pub const MAX_WIDTH: u32 = 16;

/// An operation of two operands.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Operation {
    /// Sum, in all five directions.
    Add,
    /// Difference, likewise.
    Sub,
    /// Product, likewise.
    Mul,
    /// Minimum, with either treatment of NaN.
    Min,
    /// Maximum, likewise.
    Max,
    /// Less.
    Lt,
    /// Less or equal.
    Le,
    /// Equal.
    Eq,
}

impl Operation {
    /// All of them.
    pub const ALL: [Self; 8] =
        [Self::Add, Self::Sub, Self::Mul, Self::Min, Self::Max, Self::Lt, Self::Le, Self::Eq];

    /// The name on the command line.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Add => "add",
            Self::Sub => "sub",
            Self::Mul => "mul",
            Self::Min => "min",
            Self::Max => "max",
            Self::Lt => "lt",
            Self::Le => "le",
            Self::Eq => "eq",
        }
    }

    /// The unit that computes the operation.
    #[must_use]
    pub fn top(self) -> Top {
        match self {
            Self::Add | Self::Sub => Top::FpAdd,
            Self::Mul => Top::FpMul,
            Self::Min | Self::Max => Top::FpMinMax,
            Self::Lt | Self::Le | Self::Eq => Top::FpCmp,
        }
    }

    /// Modes of the unit that the operation is checked in.
    #[must_use]
    pub fn modes(self) -> u32 {
        match self {
            Self::Add | Self::Sub | Self::Mul => Rounding::ALL.len() as u32,
            Self::Min | Self::Max => 2,
            Self::Lt | Self::Le | Self::Eq => 1,
        }
    }

    fn output(self) -> &'static str {
        match self {
            Self::Lt => "lt_o",
            Self::Le => "le_o",
            Self::Eq => "eq_o",
            _ => "result_o",
        }
    }

    /// The inputs that select the operation, with their values in a mode.
    fn control(self, mode: u32) -> Vec<(&'static str, u32)> {
        match self {
            Self::Add | Self::Sub => {
                vec![("subtract_i", u32::from(self == Self::Sub)), ("rounding_i", rounding(mode) as u32)]
            }
            Self::Mul => vec![("rounding_i", rounding(mode) as u32)],
            Self::Min | Self::Max => {
                vec![("maximum_i", u32::from(self == Self::Max)), ("propagate_nan_i", mode)]
            }
            Self::Lt | Self::Le | Self::Eq => Vec::new(),
        }
    }

    fn expected(self, oracle: &Oracle, mode: u32, a: u32, b: u32) -> u32 {
        let nan_mode = if mode == 1 { NanMode::Propagate } else { NanMode::Number };
        match self {
            Self::Add => oracle.add(a, b, false, rounding(mode)),
            Self::Sub => oracle.add(a, b, true, rounding(mode)),
            Self::Mul => oracle.mul(a, b, rounding(mode)),
            Self::Min => oracle.min_max(a, b, false, nan_mode),
            Self::Max => oracle.min_max(a, b, true, nan_mode),
            Self::Lt => oracle.compare(a, b).lt.into(),
            Self::Le => oracle.compare(a, b).le.into(),
            Self::Eq => oracle.compare(a, b).eq.into(),
        }
    }
}

impl fmt::Display for Operation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for Operation {
    type Err = String;

    fn from_str(name: &str) -> Result<Self, String> {
        Self::ALL.into_iter().find(|operation| operation.name() == name).ok_or_else(|| {
            let known = Self::ALL.map(Self::name).join(", ");
            format!("no operation is called `{name}`; there are {known}")
        })
    }
}

fn rounding(mode: u32) -> Rounding {
    Rounding::ALL[mode as usize]
}

/// The progress of a check of all pairs, as plain data, so that the check can be interrupted.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Progress {
    /// Name of the format.
    pub format: String,
    /// The operation.
    pub operation: Operation,
    /// Blocks done, in order.
    pub blocks: u64,
    /// Pairs compared, each mode counted.
    pub vectors: u64,
    /// Results that were wrong.
    pub mismatches: u64,
    /// The first of them.
    pub first: Option<String>,
}

/// The check of one operation in one format.
#[derive(Debug)]
pub struct Exhaustive {
    format: StandardFormat,
    operation: Operation,
    netlist: Flat,
    oracle: Oracle,
}

/// A format with too many pairs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "{0} has 2^{pairs} pairs of operands, too many to go through: name a format of at most {MAX_WIDTH} bits (binary16, \
     bfloat16, e5m2, e4m3), or draw random ones with --vectors", pairs = 2 * .0.format().width()
)]
pub struct TooManyPairs(StandardFormat);

impl Exhaustive {
    /// The check of `operation` in `format`.
    ///
    /// # Errors
    /// For a format wider than [`MAX_WIDTH`].
    ///
    /// # Panics
    /// If the unit does not elaborate, which a test of `pipelines` rules out.
    pub fn new(format: StandardFormat, operation: Operation) -> Result<Self, TooManyPairs> {
        if format.format().width() > MAX_WIDTH {
            return Err(TooManyPairs(format));
        }
        let design = operation.top().design(format).expect("the units elaborate");
        Ok(Self {
            format,
            operation,
            netlist: flatten(&design).expect("the units have no loop"),
            oracle: Oracle::new(format.format()),
        })
    }

    /// The same check for another netlist with the unit's ports.
    #[must_use]
    pub fn with_netlist(self, netlist: Flat) -> Self {
        Self { netlist, ..self }
    }

    /// Nothing done yet.
    #[must_use]
    pub fn start(&self) -> Progress {
        Progress {
            format: self.format.name().to_owned(),
            operation: self.operation,
            blocks: 0,
            vectors: 0,
            mismatches: 0,
            first: None,
        }
    }

    /// Blocks in all.
    #[must_use]
    pub fn blocks(&self) -> u64 {
        u64::from(self.operation.modes()) << self.format.format().width()
    }

    /// Checks the next `blocks`, or those that are left, with the compiled unit if there is one, and otherwise with
    /// the interpreter.
    pub fn advance(&self, progress: &mut Progress, blocks: u64) {
        match compiled::program(self.operation.top(), self.format) {
            Some(program) => self.advance_with(progress, blocks, || Compiled::new(program)),
            None => self.advance_with(progress, blocks, || Interpreter::new(&self.netlist)),
        }
    }

    /// [`Exhaustive::advance`] with engines of the netlist.
    pub fn advance_with<E: Engine>(
        &self,
        progress: &mut Progress,
        blocks: u64,
        engine: impl Fn() -> E + Sync + Send,
    ) {
        let until = self.blocks().min(progress.blocks + blocks);
        let results: Vec<Totals> = (progress.blocks..until)
            .into_par_iter()
            .map_init(engine, |engine, block| self.block(engine, block))
            .collect();
        let mut totals = Totals::default();
        results.into_iter().for_each(|result| totals.add(result));
        progress.blocks = until;
        progress.vectors += totals.vectors;
        progress.mismatches += totals.mismatches;
        progress.first = progress.first.take().or(totals.first);
    }

    fn block<E: Engine>(&self, engine: &mut E, block: u64) -> Totals {
        let format: Format = self.format.format();
        let (mode, a) = ((block >> format.width()) as u32, block as u32 & format.mask());
        let input = |name: &str| self.netlist.input(name).expect("a port of the unit");
        let lanes = engine.lanes();
        for (name, value) in [("en_i", 1), ("valid_i", 1), ("tag_i", 0), ("a_i", a)]
            .into_iter()
            .chain(self.operation.control(mode))
        {
            engine.drive(input(name), &vec![value; lanes]);
        }
        let b_port = input("b_i");
        let output = self.netlist.output(self.operation.output()).expect("a port of the unit");
        let latency = if matches!(self.operation.top(), Top::FpAdd | Top::FpMul) { 2 } else { 1 };
        let cycles = (1usize << format.width()).div_ceil(lanes);
        let (mut bs, mut shown) = (vec![0; lanes], vec![0; lanes]);
        let mut totals = Totals::default();
        for cycle in 0..cycles + latency {
            // After the last operand, bubbles empty the pipeline.
            for (lane, b) in bs.iter_mut().enumerate() {
                *b = (cycle * lanes + lane) as u32 & format.mask();
            }
            engine.drive(b_port, &bs);
            engine.settle();
            if let Some(origin) = cycle.checked_sub(latency) {
                engine.read(output, &mut shown);
                for (lane, &found) in shown.iter().enumerate() {
                    let b = (origin * lanes + lane) as u32;
                    let expected = self.operation.expected(&self.oracle, mode, a, b);
                    if found != expected {
                        totals.mismatches += 1;
                        totals.first.get_or_insert_with(|| self.describe(mode, a, b, expected, found));
                    }
                }
                totals.vectors += lanes as u64;
            }
            engine.clock();
            totals.cycles += lanes as u64;
        }
        totals
    }

    fn describe(&self, mode: u32, a: u32, b: u32, expected: u32, found: u32) -> String {
        let control: Vec<String> =
            self.operation.control(mode).iter().map(|(name, value)| format!("{name} = {value}")).collect();
        format!(
            "{} {} of {a:#x} and {b:#x} is {found:#x}, and should be {expected:#x} ({})",
            self.format,
            self.operation,
            control.join(", ")
        )
    }
}
