//! Small modules that use every feature of the language once.

use crate::support::driven;
use rust_hdl_core::prelude::*;

/// A register as the elaboration recognises it.
#[derive(LogicBlock, Default)]
pub struct Flop<T: Synth> {
    pub d: Signal<In, T>,
    pub q: Signal<Out, T>,
    pub clock: Signal<In, Clock>,
}

impl<T: Synth> Logic for Flop<T> {
    fn update(&mut self) {
        if self.clock.pos_edge() {
            self.q.next = self.d.val();
        }
    }
    fn connect(&mut self) {
        self.q.connect();
    }
    fn hdl(&self) -> Verilog {
        Verilog::Custom(format!(
            "initial begin\n q = {:x};\nend\nalways @(posedge clock) q <= d;\n",
            T::default().verilog()
        ))
    }
    fn timing(&self) -> Vec<TimingInfo> {
        vec![TimingInfo {
            name: "dff".into(),
            clock: "clock".into(),
            inputs: vec!["d".into()],
            outputs: vec!["q".into()],
        }]
    }
}

/// What a module answers to `timing()` to be called `kind`.
pub fn kind(name: &str) -> Vec<TimingInfo> {
    vec![TimingInfo { name: format!("{name} "), clock: String::new(), inputs: vec![], outputs: vec![] }]
}

/// Operators, casts, slices, reductions, reassignment.
#[derive(LogicBlock, Default)]
pub struct Operators {
    pub a: Signal<In, Bits<8>>,
    pub b: Signal<In, Bits<8>>,
    pub s: Signal<In, Bits<4>>,
    pub c: Signal<In, Bit>,
    pub sum: Signal<Out, Bits<9>>,
    pub difference: Signal<Out, Bits<8>>,
    pub bitwise: Signal<Out, Bits<8>>,
    pub shifted: Signal<Out, Bits<16>>,
    pub compared: Signal<Out, Bits<8>>,
    pub sliced: Signal<Out, Bits<3>>,
    pub replaced: Signal<Out, Bits<8>>,
    wide_a: Signal<Local, Bits<9>>,
    wide_b: Signal<Local, Bits<9>>,
    t: Signal<Local, Bits<16>>,
    with_bit: Signal<Local, Bits<8>>,
}

impl Logic for Operators {
    #[hdl_gen]
    fn update(&mut self) {
        self.wide_a.next = bit_cast::<9, 8>(self.a.val());
        self.wide_b.next = bit_cast::<9, 8>(self.b.val());
        self.sum.next = self.wide_a.val() + self.wide_b.val();
        self.difference.next = self.a.val() - self.b.val();
        self.bitwise.next = (self.a.val() & self.b.val()) ^ !(self.a.val() | 0x0f);
        self.t.next = bit_cast::<16, 8>(self.a.val());
        self.t.next = self.t.val() << 5;
        if self.c.val() {
            self.t.next = self.t.val() << self.s.val();
        } else if self.s.val() > 3 {
            self.t.next = self.t.val() >> self.s.val();
        }
        self.shifted.next = self.t.val();
        self.compared.next = 0.into();
        if self.a.val() == self.b.val() {
            self.compared.next = 1.into();
        }
        if (self.a.val() < self.b.val()) || (self.a.val() >= 200) {
            self.compared.next = self.compared.val() | 2;
        }
        if (self.a.val() != self.b.val()) && self.a.val().any() {
            self.compared.next = self.compared.val() | 4;
        }
        if self.a.val().all() | self.b.val().xor() | self.b.val().get_bit(7) {
            self.compared.next = self.compared.val() | 8;
        }
        if self.a.val() <= self.b.val() {
            self.compared.next = self.compared.val() | 16;
        }
        self.sliced.next = self.a.val().get_bits::<3>(2);
        self.with_bit.next = self.a.val().replace_bit(3, self.c.val());
        self.replaced.next = self.with_bit.val();
    }
}
driven!(Operators, (), [a, b, s, c], [sum, difference, bitwise, shifted, compared, sliced, replaced]);

/// States of [`Machine`].
#[derive(Clone, Copy, Debug, PartialEq, LogicState)]
pub enum Phase {
    Idle,
    Run,
    Drain,
    Done,
}

/// An enum state machine with `match`, a register array, a loop, a constant.
#[derive(LogicBlock)]
pub struct Machine {
    pub clk: Signal<In, Clock>,
    pub start: Signal<In, Bit>,
    pub data: Signal<In, Bits<12>>,
    pub busy: Signal<Out, Bit>,
    pub last: Signal<Out, Bits<12>>,
    pub total: Signal<Out, Bits<12>>,
    limit: Constant<Bits<12>>,
    phase: Flop<Phase>,
    count: Flop<Bits<2>>,
    line: [Flop<Bits<12>>; 3],
    sum: Signal<Local, Bits<12>>,
}

impl Default for Machine {
    fn default() -> Self {
        Self {
            clk: Default::default(),
            start: Default::default(),
            data: Default::default(),
            busy: Default::default(),
            last: Default::default(),
            total: Default::default(),
            limit: Constant::new(0x123_u64.into()),
            phase: Default::default(),
            count: Default::default(),
            line: Default::default(),
            sum: Default::default(),
        }
    }
}

impl Logic for Machine {
    #[hdl_gen]
    fn update(&mut self) {
        self.phase.clock.next = self.clk.val();
        self.count.clock.next = self.clk.val();
        self.phase.d.next = self.phase.q.val();
        self.count.d.next = self.count.q.val() + 1;
        self.busy.next = true;
        match self.phase.q.val() {
            Phase::Idle => {
                self.busy.next = false;
                if self.start.val() {
                    self.phase.d.next = Phase::Run;
                }
            }
            Phase::Run => {
                if self.count.q.val() == 3 {
                    self.phase.d.next = Phase::Drain;
                }
            }
            Phase::Drain => {
                if self.data.val() < self.limit.val() {
                    self.phase.d.next = Phase::Done;
                }
            }
            _ => {
                self.phase.d.next = Phase::Idle;
            }
        }
        for i in 0..3 {
            self.line[i].clock.next = self.clk.val();
        }
        self.line[0].d.next = self.data.val();
        for i in 0..2 {
            self.line[i + 1].d.next = self.line[i].q.val();
        }
        self.sum.next = 0.into();
        for i in 0..3 {
            self.sum.next = self.sum.val() + self.line[i].q.val();
        }
        self.total.next = self.sum.val();
        self.last.next = self.line[2].q.val();
    }
    fn timing(&self) -> Vec<TimingInfo> {
        kind("machine")
    }
}
driven!(Machine, (clk), [start, data], [busy, last, total]);

/// A registered adder that adds or subtracts; holds while `en` is low.
#[derive(LogicBlock, Default)]
pub struct AddSub {
    pub clk: Signal<In, Clock>,
    pub en: Signal<In, Bit>,
    pub a: Signal<In, Bits<10>>,
    pub b: Signal<In, Bits<10>>,
    pub subtract: Signal<In, Bit>,
    pub tag_in: Signal<In, Bits<5>>,
    pub result: Signal<Out, Bits<10>>,
    pub zero: Signal<Out, Bit>,
    pub tag_out: Signal<Out, Bits<5>>,
    operand: Signal<Local, Bits<10>>,
    sum: Signal<Local, Bits<10>>,
    r_sum: Flop<Bits<10>>,
    r_tag: Flop<Bits<5>>,
}

impl Logic for AddSub {
    #[hdl_gen]
    fn update(&mut self) {
        self.r_sum.clock.next = self.clk.val();
        self.r_tag.clock.next = self.clk.val();
        self.r_sum.d.next = self.r_sum.q.val();
        self.r_tag.d.next = self.r_tag.q.val();
        self.sum.next = self.a.val() + self.b.val();
        self.operand.next = self.a.val() - self.b.val();
        if self.subtract.val() {
            self.sum.next = self.operand.val();
        }
        if self.en.val() {
            self.r_sum.d.next = self.sum.val();
            self.r_tag.d.next = self.tag_in.val();
        }
        self.result.next = self.r_sum.q.val();
        self.zero.next = self.r_sum.q.val() == 0;
        self.tag_out.next = self.r_tag.q.val();
    }
    fn timing(&self) -> Vec<TimingInfo> {
        kind("add_sub")
    }
}
driven!(AddSub, (clk), [en, a, b, subtract, tag_in], [result, zero, tag_out]);

/// Two levels of [`AddSub`]: ports tied to constants, outputs left unread, an instance array.
#[derive(LogicBlock, Default)]
pub struct Tree {
    pub clk: Signal<In, Clock>,
    pub en: Signal<In, Bit>,
    pub x: [Signal<In, Bits<10>>; 4],
    pub tag: Signal<In, Bits<5>>,
    pub y: Signal<Out, Bits<10>>,
    pub tag_out: Signal<Out, Bits<5>>,
    leaf: [AddSub; 2],
    root: AddSub,
}

impl Logic for Tree {
    #[hdl_gen]
    fn update(&mut self) {
        for i in 0..2 {
            self.leaf[i].clk.next = self.clk.val();
            self.leaf[i].en.next = self.en.val();
            self.leaf[i].a.next = self.x[2 * i].val();
            self.leaf[i].b.next = self.x[2 * i + 1].val();
            self.leaf[i].subtract.next = true;
            self.leaf[i].tag_in.next = self.tag.val();
        }
        self.root.clk.next = self.clk.val();
        self.root.en.next = self.en.val();
        self.root.a.next = self.leaf[0].result.val();
        self.root.b.next = self.leaf[1].result.val();
        self.root.subtract.next = false;
        self.root.tag_in.next = self.leaf[0].tag_out.val();
        self.y.next = self.root.result.val();
        self.tag_out.next = self.root.tag_out.val();
    }
    fn timing(&self) -> Vec<TimingInfo> {
        kind("tree")
    }
}

impl crate::support::Driven for Tree {
    fn drive(&mut self, inputs: &[u128]) {
        use crate::support::Value;
        self.en.next = Value::from_integer(inputs[0]);
        for (signal, &value) in self.x.iter_mut().zip(&inputs[1..5]) {
            signal.next = Value::from_integer(value);
        }
        self.tag.next = Value::from_integer(inputs[5]);
    }
    fn sample(&self) -> Vec<u128> {
        use crate::support::Value;
        vec![self.y.val().to_integer(), self.tag_out.val().to_integer()]
    }
    fn set_clock(&mut self, level: bool) {
        self.clk.next = Clock { clk: level };
    }
}

/// Two's complement arithmetic and comparison.
#[derive(LogicBlock, Default)]
pub struct SignedOps {
    pub a: Signal<In, Signed<8>>,
    pub b: Signal<In, Signed<8>>,
    pub raw: Signal<In, Bits<8>>,
    pub sum: Signal<Out, Signed<9>>,
    pub less: Signal<Out, Bit>,
    pub negated: Signal<Out, Signed<8>>,
    pub bits: Signal<Out, Bits<8>>,
    pub product: Signal<Out, Signed<32>>,
    a9: Signal<Local, Signed<9>>,
    b9: Signal<Local, Signed<9>>,
    a16: Signal<Local, Signed<16>>,
    b16: Signal<Local, Signed<16>>,
    s: Signal<Local, Signed<8>>,
}

impl Logic for SignedOps {
    #[hdl_gen]
    fn update(&mut self) {
        self.a9.next = signed_bit_cast(self.a.val());
        self.b9.next = signed_bit_cast(self.b.val());
        self.sum.next = self.a9.val() + self.b9.val();
        self.s.next = signed_cast(self.raw.val());
        self.less.next = (self.a.val() < self.b.val()) ^ (self.s.val() >= self.a.val());
        self.negated.next = -self.a.val();
        self.bits.next = unsigned_cast(self.b.val());
        self.a16.next = signed_bit_cast(self.a.val());
        self.b16.next = signed_bit_cast(self.b.val());
        self.product.next = self.a16.val() * self.b16.val();
    }
}
driven!(SignedOps, (), [a, b, raw], [sum, less, negated, bits, product]);

/// A structure of fields.
#[derive(Clone, Copy, Debug, Default, PartialEq, LogicStruct)]
pub struct Packet {
    pub head: Bits<4>,
    pub body: Bits<9>,
    pub end: Bit,
}

/// Struct fields read and written, a 96-bit word, a 16 x 16 product, a variable bit index.
#[derive(LogicBlock, Default)]
pub struct Fields {
    pub clk: Signal<In, Clock>,
    pub head: Signal<In, Bits<4>>,
    pub body: Signal<In, Bits<9>>,
    pub word: Signal<In, Bits<96>>,
    pub index: Signal<In, Bits<4>>,
    pub head_out: Signal<Out, Bits<4>>,
    pub body_out: Signal<Out, Bits<9>>,
    pub product: Signal<Out, Bits<32>>,
    pub rotated: Signal<Out, Bits<96>>,
    pub picked: Signal<Out, Bit>,
    pub nibble: Signal<Out, Bits<4>>,
    low: Signal<Local, Bits<16>>,
    high: Signal<Local, Bits<16>>,
    lower: Signal<Local, Bits<96>>,
    upper: Signal<Local, Bits<96>>,
    packet: Flop<Packet>,
}

impl Logic for Fields {
    #[hdl_gen]
    fn update(&mut self) {
        self.packet.clock.next = self.clk.val();
        self.packet.d.next = self.packet.q.val();
        self.packet.d.next.head = self.head.val();
        if self.head.val().any() {
            self.packet.d.next.body = self.body.val();
        }
        self.low.next = self.word.val().get_bits::<16>(0);
        self.high.next = self.word.val().get_bits::<16>(80);
        self.product.next = self.low.val() * self.high.val();
        self.lower.next = self.word.val() >> 32;
        self.upper.next = self.word.val() << 64;
        self.rotated.next = self.lower.val() | self.upper.val();
        self.picked.next = self.low.val().get_bit(self.index.val().index());
        self.nibble.next = self.head.val();
        if self.head.val().get_bit(0) {
            self.nibble.next = self.packet.q.val().head;
        }
        self.head_out.next = self.packet.q.val().head;
        self.body_out.next = self.packet.q.val().body;
    }
}
driven!(Fields, (clk), [head, body, word, index], [head_out, body_out, product, rotated, picked, nibble]);
