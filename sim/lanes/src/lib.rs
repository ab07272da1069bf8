//! What compiled simulations run on: lanes, instruction sets and the memory of a program.
//!
//! `codegen` turns each unit of a netlist (a module whose outputs come from registers) into one function over [`LANES`] lanes. Within a
//! cycle, the function computes the next values of its registers and the inputs of the units inside it from registers alone. Then it
//! lets those units step. So there is no order of evaluation to find, and nothing is computed twice. Registers lie in memory in the
//! order of the hierarchy; values between them stay in the processor's registers.
//!
//! [`include_programs!`] includes what a build script has written. [`Compiled`] simulates [`LANES`] copies of a program with the
//! fastest [`InstructionSet`] of the machine. The front page of the crate `compiled` shows a whole simulation.
//!
//! ```
//! use lanes::InstructionSet;
//!
//! let best = InstructionSet::best();
//! assert!(best.is_available());
//! // Every machine can run the scalar functions, which give the same results.
//! assert!(InstructionSet::Scalar.is_available());
//! println!("simulations on this machine use {best}");
//! ```

mod generated;
#[doc(hidden)]
pub mod sets;

use netlist::Engine;
pub use sets::LANES;
use sets::{Bits, Row};
use std::fmt;

/// Instructions that the compiled functions use.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum InstructionSet {
    /// AVX-512 F, BW, CD and DQ.
    Avx512,
    /// AVX2.
    Avx2,
    /// Instructions that every machine has.
    Scalar,
}

impl InstructionSet {
    /// All of them, the fastest first.
    pub const ALL: [Self; 3] = [Self::Avx512, Self::Avx2, Self::Scalar];

    /// Whether this machine has it.
    #[must_use]
    pub fn is_available(self) -> bool {
        match self {
            #[cfg(target_arch = "x86_64")]
            Self::Avx512 => {
                is_x86_feature_detected!("avx512f")
                    && is_x86_feature_detected!("avx512bw")
                    && is_x86_feature_detected!("avx512cd")
                    && is_x86_feature_detected!("avx512dq")
            }
            #[cfg(target_arch = "x86_64")]
            Self::Avx2 => is_x86_feature_detected!("avx2"),
            #[cfg(not(target_arch = "x86_64"))]
            Self::Avx512 | Self::Avx2 => false,
            Self::Scalar => true,
        }
    }

    /// The fastest that this machine has.
    #[must_use]
    pub fn best() -> Self {
        Self::ALL.into_iter().find(|set| set.is_available()).unwrap_or(Self::Scalar)
    }
}

impl fmt::Display for InstructionSet {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Avx512 => "AVX-512",
            Self::Avx2 => "AVX2",
            Self::Scalar => "scalar",
        })
    }
}

/// Where a value is in a program's memory, and its width in bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Slot {
    /// One bit.
    Bit(usize),
    /// Up to 32 bits, in one row.
    Word(usize, u32),
    /// Up to 64 bits, in two rows.
    Double(usize, u32),
}

/// A port of a program.
#[derive(Clone, Copy, Debug)]
pub struct ProgramPort {
    /// Name in the source.
    pub name: &'static str,
    /// Where its value is.
    pub slot: Slot,
}

/// A function of a program with one instruction set; safe to call where that set is available.
#[doc(hidden)]
pub type Function = unsafe fn(&mut [Row], &mut [Bits]);

/// A function of a program for the lane given.
#[doc(hidden)]
pub type LaneFunction = fn(&mut [Row], &mut [Bits], usize);

#[doc(hidden)]
#[derive(Debug)]
pub struct Functions {
    pub settle: Function,
    pub clock: Function,
}

#[doc(hidden)]
#[derive(Debug)]
pub struct Sets {
    #[cfg(target_arch = "x86_64")]
    pub avx512: Functions,
    #[cfg(target_arch = "x86_64")]
    pub avx2: Functions,
    pub scalar: Functions,
}

/// What the build script has made of a top.
#[derive(Debug)]
pub struct Program {
    #[doc(hidden)]
    pub rows: usize,
    #[doc(hidden)]
    pub bits: usize,
    /// Inputs without the clock, in order of declaration.
    pub inputs: &'static [ProgramPort],
    /// Outputs in order of declaration.
    pub outputs: &'static [ProgramPort],
    #[doc(hidden)]
    pub initial: &'static [(Slot, u64)],
    #[doc(hidden)]
    pub sets: Sets,
    #[doc(hidden)]
    pub flush: Option<LaneFunction>,
}

impl Program {
    /// Position of the input with this name.
    #[must_use]
    pub fn input(&self, name: &str) -> Option<usize> {
        self.inputs.iter().position(|port| port.name == name)
    }

    /// Position of the output with this name.
    #[must_use]
    pub fn output(&self, name: &str) -> Option<usize> {
        self.outputs.iter().position(|port| port.name == name)
    }
}

/// A simulation of [`LANES`] copies of a compiled netlist.
#[derive(Clone, Debug)]
pub struct Compiled {
    program: &'static Program,
    settle: Function,
    clock: Function,
    rows: Vec<Row>,
    bits: Vec<Bits>,
}

impl Compiled {
    /// The program at power-up, inputs zero, with the fastest instructions of this machine.
    #[must_use]
    pub fn new(program: &'static Program) -> Self {
        Self::with_instructions(program, InstructionSet::best()).expect("the best set is available")
    }

    /// The same with the instructions of `set`, or `None` if the machine lacks them.
    #[must_use]
    pub fn with_instructions(program: &'static Program, set: InstructionSet) -> Option<Self> {
        let functions = match set {
            _ if !set.is_available() => return None,
            #[cfg(target_arch = "x86_64")]
            InstructionSet::Avx512 => &program.sets.avx512,
            #[cfg(target_arch = "x86_64")]
            InstructionSet::Avx2 => &program.sets.avx2,
            _ => &program.sets.scalar,
        };
        let Functions { settle, clock } = *functions;
        let (rows, bits) = (vec![Row::default(); program.rows], vec![Bits::default(); program.bits]);
        let mut compiled = Self { program, settle, clock, rows, bits };
        compiled.reset();
        Some(compiled)
    }

    /// What is simulated.
    #[must_use]
    pub fn program(&self) -> &'static Program {
        self.program
    }

    /// The lanes of a slot of 2 to 32 bits.
    ///
    /// # Panics
    /// If it holds another kind of value.
    #[inline]
    #[must_use]
    pub fn words(&self, slot: Slot) -> &[u32; LANES] {
        let Slot::Word(row, _) = slot else { panic!("{slot:?} is no word") };
        &self.rows[row].0
    }

    /// The lanes of an input of 2 to 32 bits, to be driven. A value has to be below 2^width.
    ///
    /// # Panics
    /// If it holds another kind of value.
    #[inline]
    pub fn words_mut(&mut self, slot: Slot) -> &mut [u32; LANES] {
        let Slot::Word(row, _) = slot else { panic!("{slot:?} is no word") };
        &mut self.rows[row].0
    }

    /// The lanes of a slot of one bit, lane 0 lowest.
    ///
    /// # Panics
    /// If it holds another kind of value.
    #[inline]
    #[must_use]
    pub fn bits(&self, slot: Slot) -> u16 {
        let Slot::Bit(bit) = slot else { panic!("{slot:?} is no bit") };
        self.bits[bit].0
    }

    /// The lanes of an input of one bit, to be driven.
    ///
    /// # Panics
    /// If it holds another kind of value.
    #[inline]
    pub fn bits_mut(&mut self, slot: Slot) -> &mut u16 {
        let Slot::Bit(bit) = slot else { panic!("{slot:?} is no bit") };
        &mut self.bits[bit].0
    }

    /// Whether [`Compiled::flush`] exists.
    #[must_use]
    pub fn has_flush(&self) -> bool {
        self.program.flush.is_some()
    }

    /// Computes the outputs that one lane shows after its inputs have been held, with the clock enabled, for the
    /// latency. The function neither reads nor changes registers: it is the pipeline as a function, for one vector at
    /// a time.
    ///
    /// # Panics
    /// If the program has no such function ([`Compiled::has_flush`]), or there is no such lane.
    #[inline]
    pub fn flush(&mut self, lane: usize) {
        assert!(lane < LANES, "lane {lane} of {LANES}");
        let flush = self.program.flush.expect("a single pipeline");
        flush(&mut self.rows, &mut self.bits, lane);
    }

    #[inline]
    fn set(&mut self, slot: Slot, lane: usize, value: u64) {
        match slot {
            Slot::Bit(bit) => {
                sets::scalar::store_b(part::<Bits, 1>(&mut self.bits, bit), 0, lane, value & 1 == 1)
            }
            Slot::Word(row, width) => self.rows[row].0[lane] = value as u32 & (u32::MAX >> (32 - width)),
            Slot::Double(row, width) => {
                sets::scalar::store_d(
                    part::<Row, 2>(&mut self.rows, row),
                    0,
                    lane,
                    value & (u64::MAX >> (64 - width)),
                );
            }
        }
    }

    #[inline]
    fn get(&self, slot: Slot, lane: usize) -> u64 {
        match slot {
            Slot::Bit(bit) => u64::from(self.bits[bit].0 >> lane & 1),
            Slot::Word(row, _) => u64::from(self.rows[row].0[lane]),
            Slot::Double(row, _) => {
                let rows = self.rows[row..].first_chunk::<2>().expect("a double has two rows");
                sets::scalar::load_d(rows, 0, lane)
            }
        }
    }
}

impl Engine for Compiled {
    fn lanes(&self) -> usize {
        LANES
    }

    fn reset(&mut self) {
        let driven: Vec<[u64; LANES]> = self
            .program
            .inputs
            .iter()
            .map(|port| std::array::from_fn(|lane| self.get(port.slot, lane)))
            .collect();
        self.rows.fill(Row::default());
        self.bits.fill(Bits::default());
        for &(slot, value) in self.program.initial {
            (0..LANES).for_each(|lane| self.set(slot, lane, value));
        }
        for (port, values) in self.program.inputs.iter().zip(driven) {
            values.into_iter().enumerate().for_each(|(lane, value)| self.set(port.slot, lane, value));
        }
    }

    #[inline]
    fn set_input(&mut self, input: usize, lane: usize, value: u128) {
        self.set(self.program.inputs[input].slot, lane, value as u64);
    }

    fn drive(&mut self, input: usize, values: &[u32]) {
        let values: &[u32; LANES] = values.try_into().expect("a value for each lane");
        match self.program.inputs[input].slot {
            Slot::Bit(bit) => {
                let lanes = values.iter().zip(0..).map(|(value, lane)| (value & 1) << lane);
                self.bits[bit].0 = lanes.fold(0, |bits, lane| bits | lane as u16);
            }
            Slot::Word(row, _) => self.rows[row].0 = *values,
            slot @ Slot::Double(..) => panic!("{slot:?} is wider than 32 bits"),
        }
    }

    fn read(&self, output: usize, values: &mut [u32]) {
        let values: &mut [u32; LANES] = values.try_into().expect("room for each lane");
        match self.program.outputs[output].slot {
            Slot::Bit(bit) => {
                let bits = self.bits[bit].0;
                values.iter_mut().zip(0..).for_each(|(value, lane)| *value = u32::from(bits >> lane & 1));
            }
            Slot::Word(row, _) | Slot::Double(row, _) => *values = self.rows[row].0,
        }
    }

    #[inline]
    fn settle(&mut self) {
        // SAFETY: `with_instructions` found the instruction set to be available.
        unsafe { (self.settle)(&mut self.rows, &mut self.bits) }
    }

    #[inline]
    fn output(&self, output: usize, lane: usize) -> u128 {
        self.get(self.program.outputs[output].slot, lane).into()
    }

    #[inline]
    fn clock(&mut self) {
        // SAFETY: as in `settle`.
        unsafe { (self.clock)(&mut self.rows, &mut self.bits) }
    }
}

/// The memory of a unit inside another.
#[doc(hidden)]
#[inline(always)]
pub fn part<T, const N: usize>(memory: &mut [T], at: usize) -> &mut [T; N] {
    memory[at..].first_chunk_mut().expect("a unit's memory lies inside that of the unit around it")
}

/// The memory of a whole program.
#[doc(hidden)]
#[inline(always)]
pub fn whole<T, const N: usize>(memory: &mut [T]) -> &mut [T; N] {
    memory.try_into().expect("a program's memory has its size")
}
