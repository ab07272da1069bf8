//! Each thing that elaboration rejects, with the place it names.

use crate::modules::{Flop, kind};
use netlist::{ErrorKind, elaborate};
use rust_hdl_core::prelude::*;

/// A module with inputs `a` (8), `b` (9), `c` (1), an output and a local.
macro_rules! faulty {
    ($($module:ident: $kernel:item;)*) => { $(
        #[derive(LogicBlock, Default)]
        pub struct $module {
            pub clk: Signal<In, Clock>,
            pub a: Signal<In, Bits<8>>,
            pub b: Signal<In, Bits<9>>,
            pub c: Signal<In, Bit>,
            pub r: Signal<Out, Bits<8>>,
            t: Signal<Local, Bits<8>>,
            reg_t: Flop<Bits<8>>,
        }
        impl Logic for $module {
            $kernel
        }
    )* };
}

const K: u64 = 3;

faulty! {
    Latch: #[hdl_gen] fn update(&mut self) {
        self.reg_t.clock.next = self.clk.val(); self.reg_t.d.next = self.a.val(); self.t.next = 0.into();
        if self.c.val() { self.r.next = self.a.val(); }
    };
    IncompleteMatch: #[hdl_gen] fn update(&mut self) {
        self.reg_t.clock.next = self.clk.val(); self.reg_t.d.next = self.a.val(); self.t.next = 0.into();
        if self.c.val() { self.r.next = self.a.val(); } else if self.a.val() == 3 { self.r.next = 0.into(); }
    };
    ReadsLatch: #[hdl_gen] fn update(&mut self) {
        self.reg_t.clock.next = self.clk.val(); self.reg_t.d.next = self.a.val();
        if self.c.val() { self.t.next = self.a.val(); }
        self.r.next = self.t.val();
    };
    ReadBeforeWrite: #[hdl_gen] fn update(&mut self) {
        self.reg_t.clock.next = self.clk.val(); self.reg_t.d.next = self.a.val();
        self.r.next = self.t.val();
        self.t.next = self.a.val();
    };
    Undriven: #[hdl_gen] fn update(&mut self) {
        self.reg_t.clock.next = self.clk.val(); self.reg_t.d.next = self.a.val();
        self.r.next = self.a.val();
    };
    NoRegisterData: #[hdl_gen] fn update(&mut self) {
        self.reg_t.clock.next = self.clk.val(); self.t.next = 0.into();
        self.r.next = self.a.val();
    };
    NoClock: #[hdl_gen] fn update(&mut self) {
        self.reg_t.d.next = self.a.val(); self.t.next = 0.into();
        self.r.next = self.a.val();
    };
    GatedClock: #[hdl_gen] fn update(&mut self) {
        self.reg_t.clock.next = !self.clk.val(); self.reg_t.d.next = self.a.val(); self.t.next = 0.into();
        self.r.next = self.a.val();
    };
    DrivesInput: #[hdl_gen] fn update(&mut self) {
        self.reg_t.clock.next = self.clk.val(); self.reg_t.d.next = self.a.val(); self.t.next = 0.into();
        self.r.next = self.a.val();
        self.a.next = self.r.val();
    };
    DrivesInstanceOutput: #[hdl_gen] fn update(&mut self) {
        self.reg_t.clock.next = self.clk.val(); self.reg_t.d.next = self.a.val(); self.t.next = 0.into();
        self.r.next = self.a.val();
        self.reg_t.q.next = self.r.val();
    };
    ReadsInstanceInput: #[hdl_gen] fn update(&mut self) {
        self.reg_t.clock.next = self.clk.val(); self.reg_t.d.next = self.a.val(); self.t.next = 0.into();
        self.r.next = self.reg_t.d.val();
    };
    ConstItem: #[hdl_gen] fn update(&mut self) {
        self.reg_t.clock.next = self.clk.val(); self.reg_t.d.next = self.a.val(); self.t.next = 0.into();
        self.r.next = self.a.val() + K;
    };
    SliceOfExpression: #[hdl_gen] fn update(&mut self) {
        self.reg_t.clock.next = self.clk.val(); self.reg_t.d.next = self.a.val();
        self.t.next = bit_cast::<8, 4>((self.a.val() + 1).get_bits::<4>(2));
        self.r.next = self.t.val();
    };
    IndexArithmetic: #[hdl_gen] fn update(&mut self) {
        self.reg_t.clock.next = self.clk.val(); self.reg_t.d.next = self.a.val(); self.t.next = 0.into();
        self.r.next = self.b.val().get_bits::<8>(self.a.val().index() - 1);
    };
}

fn reject<M: Block + Default>(path: &str, statement: &str, kind: impl Fn(&ErrorKind) -> bool) {
    let error = elaborate(&M::default(), "top").expect_err("elaborates");
    assert!(kind(&error.kind), "{error}");
    assert_eq!((error.at.path.as_str(), error.at.statement.as_str()), (path, statement), "{error}");
    println!("{error}");
}

#[test]
fn faults_are_errors_with_their_place() {
    let named = |name: &str, kind: fn(String) -> ErrorKind| {
        let expected = kind(name.to_owned());
        move |found: &ErrorKind| *found == expected
    };
    let not_understood = |found: &ErrorKind| matches!(found, ErrorKind::NotUnderstood(_));
    reject::<Latch>("top", "if c", named("r", ErrorKind::Latch));
    reject::<IncompleteMatch>("top", "if a == 3", named("r", ErrorKind::Latch));
    reject::<ReadsLatch>("top", "r.next = t", named("t", ErrorKind::Latch));
    reject::<ReadBeforeWrite>("top", "r.next = t", named("t", ErrorKind::ReadBeforeWrite));
    reject::<Undriven>("top", "", named("t", ErrorKind::Undriven));
    reject::<NoRegisterData>("top", "", named("reg_t.d", ErrorKind::Undriven));
    reject::<NoClock>("top", "", named("reg_t.clock", ErrorKind::Undriven));
    reject::<GatedClock>("top", "reg_t.clock.next = !clk", named("reg_t.clock", ErrorKind::Clock));
    reject::<DrivesInput>("top", "a.next = r", named("a", ErrorKind::MultipleDrivers));
    reject::<DrivesInstanceOutput>("top", "reg_t.q.next = r", named("reg_t.q", ErrorKind::MultipleDrivers));
    reject::<ReadsInstanceInput>("top", "r.next = reg_t.d", not_understood);
    reject::<ConstItem>("top", "r.next = a + K", named("K", ErrorKind::Unresolved));
    reject::<SliceOfExpression>("top", "t.next = bit_cast::<8, _>((a + 1).get_bits::<4>(2))", not_understood);
    reject::<IndexArithmetic>("top", "r.next = b.get_bits::<8>(a - 1)", not_understood);
}

/// A wire that calls itself by a SystemVerilog word.
#[derive(LogicBlock, Default)]
pub struct KeywordName {
    pub a: Signal<In, Bits<8>>,
    pub r: Signal<Out, Bits<8>>,
    packed: Signal<Local, Bits<8>>,
}
impl Logic for KeywordName {
    #[hdl_gen]
    fn update(&mut self) {
        self.packed.next = self.a.val();
        self.r.next = self.packed.val();
    }
}

/// Passes its input through.
#[derive(LogicBlock, Default)]
pub struct Pass {
    pub a: Signal<In, Bits<8>>,
    pub r: Signal<Out, Bits<8>>,
}
impl Logic for Pass {
    #[hdl_gen]
    fn update(&mut self) {
        self.r.next = self.a.val() + 1;
    }
    fn timing(&self) -> Vec<TimingInfo> {
        kind("pass")
    }
}

/// Two combinational instances in a ring.
#[derive(LogicBlock, Default)]
pub struct Ring {
    pub r: Signal<Out, Bits<8>>,
    first: Pass,
    second: Pass,
}
impl Logic for Ring {
    #[hdl_gen]
    fn update(&mut self) {
        self.first.a.next = self.second.r.val();
        self.second.a.next = self.first.r.val();
        self.r.next = self.second.r.val();
    }
}

/// Words beyond what the graph holds.
#[derive(LogicBlock, Default)]
pub struct TooWide {
    pub a: Signal<In, Bits<129>>,
    pub r: Signal<Out, Bits<129>>,
}
impl Logic for TooWide {
    #[hdl_gen]
    fn update(&mut self) {
        self.r.next = self.a.val();
    }
}

/// Holds a faulty module, to show the instance path.
#[derive(LogicBlock, Default)]
pub struct Outer {
    pub a: Signal<In, Bits<8>>,
    pub r: Signal<Out, Bits<8>>,
    inner: [KeywordName; 2],
}
impl Logic for Outer {
    #[hdl_gen]
    fn update(&mut self) {
        self.inner[0].a.next = self.a.val();
        self.inner[1].a.next = self.inner[0].r.val();
        self.r.next = self.inner[1].r.val();
    }
}

#[test]
fn faults_of_the_module_as_a_whole() {
    let packed = |found: &ErrorKind| *found == ErrorKind::Keyword("packed".into());
    reject::<KeywordName>("top", "", packed);
    reject::<Outer>("top.inner.0", "", packed);
    reject::<TooWide>("top", "", |found| *found == ErrorKind::UnsupportedWidth(129));
    reject::<Ring>("top", "", |found| match found {
        ErrorKind::CombinationalLoop(path) => {
            path.contains(&"first.r".to_owned()) && path.contains(&"second.r".to_owned())
        }
        _ => false,
    });
    assert_eq!(elaborate(&Pass::default(), "module").unwrap_err().kind, ErrorKind::Keyword("module".into()));
}
