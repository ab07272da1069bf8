//! A thread that executes a program's operations.

use super::fault::{Fault, Mistake};
use super::local_store::LocalStore;
use super::memory::Memory;
use super::set_up::{POISON, SetUp};
use super::special::Special;
use crate::core::Tape;
use crate::program::{
    CONDITION, Edge, EntryId, FIRST_FLOAT, MOST_LANES, NodeId, Opcode, Operation, Program, Register, SINK,
    Test,
};
use golden::Aabb;
use golden::bvh::BoxStep;
use golden::dst::Step;
use golden::ray::PlaneRay;
use std::collections::{BTreeMap, BTreeSet};

/// Lanes of boxes, numbered from 1.
const LANES: usize = MOST_LANES as usize;

/// Most instructions of an item.
const MOST_INSTRUCTIONS: u64 = 1 << 27;

/// Where the dimensions that `RAND` goes through begin: behind the two of the place in the pixel.
const FIRST_DIMENSION: u32 = 2;

/// Where a thread has come to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stop {
    /// The operation with this index needs an item; the program goes on at an entry point.
    Counter(usize, EntryId),
    /// The program ends behind the operation with this index.
    End(usize),
}

/// The state of a thread.
#[derive(Clone, Debug)]
pub struct Thread {
    /// Registers by their numbers.
    pub registers: [u32; 256],
    /// The local store.
    pub local: LocalStore,
    /// Words of the local store that items have read as their thread's set-up has left them, by entry point.
    pub inherited: Vec<BTreeSet<usize>>,
    /// Words of the local store that the item has read although nothing or another item has written them, with the operation.
    pub poisoned_reads: BTreeMap<usize, usize>,
    /// What the item has stored to global memory: address and value.
    pub stored: Vec<[u32; 2]>,
    /// Exact decisions of triangle tests.
    pub exact_tests: u64,
    lanes: [[f32; 6]; LANES],
    entries: [f32; LANES],
    item: u32,
    dimension: u32,
}

/// What a thread executes, and what surrounds it.
pub struct Surroundings<'a, S> {
    /// The program.
    pub program: &'a Program,
    /// Global memory.
    pub memory: &'a Memory,
    /// The machine's own operations.
    pub special: &'a S,
}

impl<S> Clone for Surroundings<'_, S> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<S> Copy for Surroundings<'_, S> {}

impl Thread {
    /// A thread before its first instruction.
    #[must_use]
    pub fn new(program: &Program) -> Self {
        Self {
            registers: [0; 256],
            local: LocalStore::new(),
            inherited: vec![BTreeSet::new(); program.graph.entries.len()],
            poisoned_reads: BTreeMap::new(),
            stored: vec![],
            exact_tests: 0,
            lanes: [[0.0; 6]; LANES],
            entries: [0.0; LANES],
            item: 0,
            dimension: 0,
        }
    }

    /// Begins item `item`.
    pub fn begin(&mut self, item: u32) {
        self.local.begin();
        self.stored.clear();
        self.poisoned_reads.clear();
        self.item = item;
        self.dimension = FIRST_DIMENSION;
    }

    #[inline(always)]
    fn get(&self, register: Register) -> u32 {
        self.registers[usize::from(register)]
    }

    #[inline(always)]
    fn set(&mut self, register: Register, value: u32) {
        self.registers[usize::from(register)] = value;
    }

    #[inline(always)]
    fn float(&self, register: Register) -> f32 {
        f32::from_bits(self.get(register))
    }

    #[inline(always)]
    fn set_float(&mut self, register: Register, value: f32) {
        self.set(register, value.to_bits());
    }

    #[inline(always)]
    fn floats<const N: usize>(&self, registers: &[Register]) -> [f32; N] {
        std::array::from_fn(|i| self.float(registers[i]))
    }

    /// Executes from the entry point `entry` on, until an item is needed or the program is over. `set_up` is the state there.
    ///
    /// # Errors
    /// What the program does wrong.
    pub fn run<S: Special>(
        &mut self,
        around: Surroundings<'_, S>,
        entry: EntryId,
        set_up: &SetUp,
        tape: &mut Tape<'_>,
    ) -> Result<Stop, Box<Fault>> {
        let Surroundings { program, .. } = around;
        let graph = &program.graph;
        let mut node: NodeId = graph.entries[usize::from(entry)];
        let mut executed = 0;
        let mut context = Context { around, entry, set_up };
        tape.begin();
        loop {
            let here = &graph.nodes[node as usize];
            let body = here.body.start as usize..here.body.end as usize;
            executed += body.len() as u64 + 2;
            if executed > MOST_INSTRUCTIONS {
                let mistake = Mistake::NoProgress(MOST_INSTRUCTIONS);
                return Err(Fault::new(program, body.start, self.item, mistake));
            }
            for (at, operation) in (body.start..).zip(&program.operations[body.clone()]) {
                self.execute(at, operation, &mut context, tape)?;
            }
            let mut edge = here.next;
            if let Some(branch) = &here.branch {
                let taken = self.holds(branch.test, branch.a, branch.b);
                let slot = branch.slot as usize;
                self.execute(slot, &program.operations[slot], &mut context, tape)?;
                if taken {
                    edge = branch.taken;
                }
            }
            match edge {
                Edge::Node(next) => node = next,
                Edge::Entry(run, entry) => {
                    tape.end(run);
                    node = graph.entries[usize::from(entry)];
                    tape.begin();
                }
                Edge::Counter(run, entry) => {
                    tape.end(run);
                    return Ok(Stop::Counter(body.end, entry));
                }
                Edge::End(run) => {
                    tape.end(run);
                    return Ok(Stop::End(body.end));
                }
            }
        }
    }

    #[inline(always)]
    fn holds(&self, test: Test, a: Register, b: Register) -> bool {
        let (a, b) = (self.get(a), self.get(b));
        match test {
            Test::Always => true,
            Test::Equal => a == b,
            Test::NotEqual => a != b,
            Test::Negative => (a as i32) < 0,
            Test::NotNegative => (a as i32) >= 0,
            Test::Positive => (a as i32) > 0,
            Test::NotPositive => (a as i32) <= 0,
        }
    }

    #[inline(always)]
    fn execute<S: Special>(
        &mut self,
        at: usize,
        operation: &Operation,
        context: &mut Context<'_, S>,
        tape: &mut Tape<'_>,
    ) -> Result<(), Box<Fault>> {
        use Opcode as O;
        let Operation { opcode, d, a, b, immediate } = *operation;
        let special = context.around.special;
        match opcode {
            O::Nop | O::Branch | O::Counter => {}
            O::Add => self.set(d, self.get(a).wrapping_add(self.get(b))),
            O::AddImmediate => self.set(d, self.get(a).wrapping_add(immediate as u32)),
            O::Subtract => self.set(d, self.get(a).wrapping_sub(self.get(b))),
            O::Multiply => self.set(d, self.get(a).wrapping_mul(self.get(b))),
            O::And => self.set(d, self.get(a) & self.get(b)),
            O::AndImmediate => self.set(d, self.get(a) & immediate as u32),
            O::Or => self.set(d, self.get(a) | self.get(b)),
            O::OrImmediate => self.set(d, self.get(a) | immediate as u32),
            O::Xor => self.set(d, self.get(a) ^ self.get(b)),
            O::XorImmediate => self.set(d, self.get(a) ^ immediate as u32),
            O::Nor => self.set(d, !(self.get(a) | self.get(b))),
            O::ShiftLeft => self.set(d, self.get(a) << (immediate & 31)),
            O::ShiftRight => self.set(d, self.get(a) >> (immediate & 31)),
            O::ShiftRightArithmetic => self.set(d, (self.get(a) as i32 >> (immediate & 31)) as u32),
            O::ShiftLeftBy => self.set(d, self.get(a) << (self.get(b) & 31)),
            O::ShiftRightBy => self.set(d, self.get(a) >> (self.get(b) & 31)),
            O::SetLess => self.set(d, u32::from((self.get(a) as i32) < self.get(b) as i32)),
            O::SetLessImmediate => self.set(d, u32::from((self.get(a) as i32) < immediate)),
            O::SetLessUnsigned => self.set(d, u32::from(self.get(a) < self.get(b))),
            O::SetLessUnsignedImmediate => self.set(d, u32::from(self.get(a) < immediate as u32)),
            O::Constant | O::PoolConstant => self.set(d, immediate as u32),
            O::Copy => self.set(d, self.get(a)),
            O::CopyIf => {
                let value = if self.get(b) != 0 { self.get(a) } else { self.get(d) };
                self.set(d, value);
            }
            O::CopyUnless => {
                let value = if self.get(b) == 0 { self.get(a) } else { self.get(d) };
                self.set(d, value);
            }
            O::FloatAdd => self.set_float(d, self.float(a) + self.float(b)),
            O::FloatSubtract => self.set_float(d, self.float(a) - self.float(b)),
            O::FloatMultiply => self.set_float(d, self.float(a) * self.float(b)),
            O::FloatDivide => self.set_float(d, self.float(a) / self.float(b)),
            O::FloatSquareRoot => self.set_float(d, self.float(a).sqrt()),
            O::FloatNegate => self.set(d, self.get(a) ^ 1 << 31),
            O::FloatAbsolute => self.set(d, self.get(a) & !(1 << 31)),
            O::FloatMinimum => self.set_float(d, special.minimum(self.float(a), self.float(b))),
            O::FloatMaximum => self.set_float(d, special.maximum(self.float(a), self.float(b))),
            O::InverseSquareRoot => self.set_float(d, special.inverse_square_root(self.float(a))),
            O::Sine => self.set_float(d, special.sine(self.float(a))),
            O::Cosine => self.set_float(d, special.cosine(self.float(a))),
            O::Random => {
                if self.dimension >= render::SAMPLE_DIMENSIONS {
                    return Err(Fault::new(context.around.program, at, self.item, Mistake::Random));
                }
                self.set_float(d, special.random(self.item, self.dimension));
                self.dimension += 1;
            }
            O::IntegerToFloat => self.set_float(d, self.get(a) as i32 as f32),
            O::FloatToInteger => self.set(d, to_integer(self.float(a).round_ties_even())),
            O::FloatTruncate => self.set(d, to_integer(self.float(a).trunc())),
            O::Equal => self.set(CONDITION, u32::from(self.float(a) == self.float(b))),
            O::Less => self.set(CONDITION, u32::from(self.float(a) < self.float(b))),
            O::LessOrEqual => self.set(CONDITION, u32::from(self.float(a) <= self.float(b))),
            O::Unordered => {
                self.set(CONDITION, u32::from(self.float(a).partial_cmp(&self.float(b)).is_none()));
            }
            O::EqualOrUnordered => {
                let (a, b) = (self.float(a), self.float(b));
                self.set(CONDITION, u32::from(a.partial_cmp(&b).is_none_or(std::cmp::Ordering::is_eq)));
            }
            O::LessOrUnordered => {
                let greater_or_equal = self.float(a) >= self.float(b);
                self.set(CONDITION, u32::from(!greater_or_equal));
            }
            O::LessOrEqualOrUnordered => {
                let greater = self.float(a) > self.float(b);
                self.set(CONDITION, u32::from(!greater));
            }
            O::LoadLocal => {
                let value = self.load_local(at, self.get(a).wrapping_add(immediate as u32), context)?;
                self.set(d, value);
            }
            O::StoreLocal => {
                self.store_local(at, self.get(a).wrapping_add(immediate as u32), self.get(d), context)?;
            }
            // Of a pair, the odd register holds the upper half, which comes first in memory.
            O::LoadLocalPair => {
                let address = self.get(a).wrapping_add(immediate as u32);
                let pair = [0, 4].map(|offset| self.load_local(at, address.wrapping_add(offset), context));
                let [upper, lower] = pair;
                self.set(d + 1, upper?);
                self.set(d, lower?);
            }
            O::StoreLocalPair => {
                let address = self.get(a).wrapping_add(immediate as u32);
                self.store_local(at, address, self.get(d + 1), context)?;
                self.store_local(at, address.wrapping_add(4), self.get(d), context)?;
            }
            O::LoadLocalByte | O::LoadLocalByteUnsigned => {
                let address = self.get(a).wrapping_add(immediate as u32);
                let word = self.load_local(at, address & !3, context)?;
                let byte = word.to_be_bytes()[address as usize & 3];
                let value = if opcode == O::LoadLocalByte { byte as i8 as u32 } else { byte.into() };
                self.set(d, value);
            }
            O::StoreLocalByte => {
                let address = self.get(a).wrapping_add(immediate as u32);
                let mut bytes = self.load_local(at, address & !3, context)?.to_be_bytes();
                bytes[address as usize & 3] = self.get(d) as u8;
                self.store_local(at, address & !3, u32::from_be_bytes(bytes), context)?;
            }
            O::Load => {
                let value = self.load(at, operation, 0, context, tape)?;
                self.set(d, value);
            }
            O::LoadWords => {
                let words = &context.around.program.lists[immediate as usize >> 16];
                let base = self.get(a);
                for (word, register) in (0..).zip(words) {
                    let value = self.load_from(at, base, operation, word, context, tape)?;
                    self.set(if *register == 0 { SINK } else { *register }, value);
                }
            }
            O::LoadLane => {
                let value = self.load(at, operation, 0, context, tape)?;
                let lane = self.lane(at, self.get(d), context)?;
                self.lanes[lane][operation.offset() as usize - 1] = f32::from_bits(value);
            }
            O::Store => {
                let base = self.get(a);
                if b != 0 {
                    tape.address(base);
                }
                let address = base.wrapping_add(operation.offset());
                let around = context.around;
                let value = self.get(d);
                around.memory.store(address, value, self.item).map_err(|denied| {
                    Fault::new(around.program, at, self.item, Mistake::Store(address, denied))
                })?;
                self.stored.push([address, value]);
            }
            O::DualSplitStep => {
                let list = &context.around.program.lists[immediate as usize];
                self.dual_split_step(list, special);
            }
            O::BoxTest => {
                let list = &context.around.program.lists[immediate as usize];
                let ray = self.plane_ray(&list[8..]);
                let BoxStep { hit, t_entry, .. } =
                    special.box_test(&aabb(self.floats(&list[2..])), &ray, self.float(list[17]));
                self.set(list[0], hit.into());
                self.set_float(list[1], t_entry);
            }
            O::BoxTestPair => {
                let list = &context.around.program.lists[immediate as usize];
                let (ray, t_max) = (self.plane_ray(&list[15..]), self.float(list[24]));
                let steps = [3, 9].map(|at| special.box_test(&aabb(self.floats(&list[at..])), &ray, t_max));
                self.set(list[0], u32::from(steps[0].hit) | u32::from(steps[1].hit) << 1);
                self.set_float(list[1], steps[0].t_entry);
                self.set_float(list[2], steps[1].t_entry);
            }
            O::BoxTestLanes => {
                let list = &context.around.program.lists[immediate as usize];
                let (ray, t_max) = (self.plane_ray(&list[2..]), self.float(list[11]));
                let first = self.lane(at, self.get(list[1]), context)?;
                let mut hits = 0;
                for lane in 0..=first {
                    let BoxStep { hit, t_entry, .. } = special.box_test(&aabb(self.lanes[lane]), &ray, t_max);
                    self.entries[lane] = t_entry;
                    hits |= u32::from(hit) << (first - lane);
                }
                self.set(list[0], hits);
            }
            O::LaneEntry => {
                let lane = self.lane(at, self.get(a), context)?;
                self.set_float(d, self.entries[lane]);
            }
            O::ExactTest => self.exact_test(at, immediate as usize, context)?,
        }
        Ok(())
    }

    /// Origin and reciprocals in nine registers.
    #[inline(always)]
    fn plane_ray(&self, registers: &[Register]) -> PlaneRay {
        PlaneRay {
            origin: self.floats(registers),
            inv_entry: self.floats(&registers[3..]),
            inv_exit: self.floats(&registers[6..]),
        }
    }

    #[inline(always)]
    fn dual_split_step<S: Special>(&mut self, list: &[Register], special: &S) {
        let ray = self.plane_ray(&list[10..]);
        let words = [7, 8, 9].map(|at| self.get(list[at]));
        let Step { code, near, far } = special.step(words, &ray, self.floats(&list[3..]));
        self.set(list[0], code as u32);
        self.set(list[1], near.offset);
        self.set(list[2], far.offset);
        for (register, t) in list[3..7].iter().zip([near.t_min, near.t_max, far.t_min, far.t_max]) {
            self.set_float(*register, t);
        }
    }

    #[cold]
    fn exact_test<S: Special>(
        &mut self,
        at: usize,
        list: usize,
        context: &mut Context<'_, S>,
    ) -> Result<(), Box<Fault>> {
        let Surroundings { program, memory, special } = context.around;
        let list = &program.lists[list];
        let triangle = self.get(list[4]);
        let mut words = [0.0; 9];
        for (address, word) in (0..).map(|word| triangle.wrapping_add(word)).zip(&mut words) {
            let bits = memory
                .load(address, self.item)
                .map_err(|denied| Fault::new(program, at, self.item, Mistake::Load(address, denied)))?;
            *word = f32::from_bits(bits);
        }
        // A triangle lies in memory axis by axis.
        let corners = std::array::from_fn(|corner| std::array::from_fn(|axis| words[3 * axis + corner]));
        let ray: [f32; 6] = self.floats(&list[5..]);
        if !words.iter().chain(&ray).all(|number| number.is_finite()) {
            return Err(Fault::new(program, at, self.item, Mistake::NotFinite));
        }
        let hit = special.exact(self.floats(&list[5..]), self.floats(&list[8..]), &corners);
        self.exact_tests += 1;
        self.set(list[0], hit.is_some().into());
        let values = hit.map_or([0.0; 3], |hit| [hit.t, hit.u, hit.v]);
        list[1..4].iter().zip(values).for_each(|(register, value)| self.set_float(*register, value));
        Ok(())
    }

    /// The index of lane `number`.
    fn lane<S>(&self, at: usize, number: u32, context: &Context<'_, S>) -> Result<usize, Box<Fault>> {
        let program = context.around.program;
        if (1..=program.lanes).contains(&number) {
            Ok(number as usize - 1)
        } else {
            Err(Fault::new(program, at, self.item, Mistake::Lane(number, program.lanes)))
        }
    }

    #[inline(always)]
    fn load<S>(
        &self,
        at: usize,
        operation: &Operation,
        word: u32,
        context: &Context<'_, S>,
        tape: &mut Tape<'_>,
    ) -> Result<u32, Box<Fault>> {
        self.load_from(at, self.get(operation.a), operation, word, context, tape)
    }

    /// Word `word` of what a load from `base` brings.
    #[inline(always)]
    fn load_from<S>(
        &self,
        at: usize,
        base: u32,
        operation: &Operation,
        word: u32,
        context: &Context<'_, S>,
        tape: &mut Tape<'_>,
    ) -> Result<u32, Box<Fault>> {
        if operation.b != 0 && word == 0 {
            tape.address(base);
        }
        let address = base.wrapping_add(operation.offset()).wrapping_add(word);
        let Surroundings { program, memory, .. } = context.around;
        memory
            .load(address, self.item)
            .map_err(|denied| Fault::new(program, at, self.item, Mistake::Load(address, denied)))
    }

    #[inline(always)]
    fn load_local<S>(
        &mut self,
        at: usize,
        address: u32,
        context: &mut Context<'_, S>,
    ) -> Result<u32, Box<Fault>> {
        let program = context.around.program;
        let index = LocalStore::index(address)
            .map_err(|misplaced| Fault::new(program, at, self.item, Mistake::Local(address, misplaced)))?;
        Ok(match self.local.load(index) {
            Some(value) => value,
            None => self.inherit(at, index, context),
        })
    }

    /// A word that the item has not written: what the thread's set-up has left there.
    #[inline(never)]
    fn inherit<S>(&mut self, at: usize, index: usize, context: &Context<'_, S>) -> u32 {
        let Some(value) = context.set_up.local[index] else {
            self.poisoned_reads.entry(index).or_insert(at);
            return POISON;
        };
        self.inherited[usize::from(context.entry)].insert(index);
        value
    }

    #[inline(always)]
    fn store_local<S>(
        &mut self,
        at: usize,
        address: u32,
        value: u32,
        context: &Context<'_, S>,
    ) -> Result<(), Box<Fault>> {
        let index = LocalStore::index(address).map_err(|misplaced| {
            Fault::new(context.around.program, at, self.item, Mistake::Local(address, misplaced))
        })?;
        self.local.store(index, value);
        Ok(())
    }
}

/// What stays the same while an item is executed.
struct Context<'a, S> {
    around: Surroundings<'a, S>,
    /// Where the item began.
    entry: EntryId,
    /// The state there.
    set_up: &'a SetUp,
}

/// Minimum and maximum in six words.
#[inline(always)]
fn aabb(words: [f32; 6]) -> Aabb {
    let [x0, y0, z0, x1, y1, z1] = words;
    Aabb { min: [x0, y0, z0], max: [x1, y1, z1] }
}

/// A float that is an integer as one; what is out of range gives 2^31 - 1, as MIPS32 has it.
#[inline(always)]
fn to_integer(x: f32) -> u32 {
    if (-2_147_483_648.0..2_147_483_648.0).contains(&x) { x as i32 as u32 } else { i32::MAX as u32 }
}

const _: () = assert!(FIRST_FLOAT == 32);
