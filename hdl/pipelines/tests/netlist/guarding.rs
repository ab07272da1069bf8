//! The guard flags each known difference between rust-hdl's simulation and its Verilog, and nothing else.

use crate::modules::*;
use netlist::verilog::cross_check::reference_verilog;
use netlist::{GuardError, elaborate, guard};
use rust_hdl_core::prelude::*;
use testing::tools::{available, run};

/// A combinational module of 8-bit inputs with one kernel statement, or several.
macro_rules! probe {
    ($module:ident, $width:literal, $kernel:item) => {
        #[derive(LogicBlock, Default)]
        pub struct $module {
            pub a: Signal<In, Bits<8>>,
            pub b: Signal<In, Bits<8>>,
            pub s: Signal<In, Bits<3>>,
            pub x: Signal<In, Bit>,
            pub y: Signal<In, Bit>,
            pub z: Signal<In, Bit>,
            pub r: Signal<Out, Bits<$width>>,
            t: Signal<Local, Bits<8>>,
            c: Signal<Local, Bit>,
        }
        impl Logic for $module {
            $kernel
        }
    };
}

/// Each module with whether Verilog reads it differently, as measured with a Verilog simulator.
macro_rules! probes {
    ($($module:ident, $width:literal, $differs:literal, $kernel:item;)*) => {
        $(probe!($module, $width, $kernel);)*

        #[test]
        fn known_differences_are_flagged_and_nothing_else() {
            $( judge::<$module>(stringify!($module), $differs); )*
        }

        /// The table itself, measured: rust-hdl's own export in a Verilog simulator against the netlist.
        #[test]
        fn the_table_is_what_a_simulator_finds() {
            $( measure::<$module>(stringify!($module), $differs); )*
        }
    };
}

fn judge<M: Block + Default>(name: &str, differs: bool) {
    let mut module = M::default();
    module.connect_all();
    match guard(&module) {
        Ok(report) => assert!(!differs, "{name} passes: {report:?}"),
        Err(GuardError::Disagreement(found)) => {
            println!("{name}: {found}");
            assert!(differs, "{name}: {found}");
            assert_eq!(found.target, "r");
            assert_ne!(found.rust, found.verilog);
            assert!(!found.at.statement.is_empty(), "{name}: no statement");
        }
        Err(error) => panic!("{name}: {error}"),
    }
}

fn measure<M: Block + Default>(name: &str, differs: bool) {
    if !available("iverilog") {
        return;
    }
    let mut module = M::default();
    module.connect_all();
    let design = elaborate(&module, name).unwrap();
    let folder = tempfile::tempdir().unwrap();
    crate::verilog::write_package(&design, 1000, folder.path());
    // The export's ports are called as in the source; the testbench wants ours.
    let ports = ["a", "b", "s", "x", "y", "z"].map(|port| {
        let used = design.top().inputs.iter().find(|found| found.name == port).unwrap();
        format!("input wire [{}:0] {port}_i", used.width - 1)
    });
    let connections = ["a", "b", "s", "x", "y", "z"].map(|port| format!(".{port}({port}_i)"));
    let text = format!(
        "{}\nmodule {name} ({}, output wire [{}:0] r_o);\n  source inner ({}, .r(r_o));\nendmodule\n",
        reference_verilog(&module, "source"),
        ports.join(", "),
        design.top().outputs[0].0.width - 1,
        connections.join(", "),
    );
    std::fs::write(folder.path().join("reference.v"), text).unwrap();
    let bench = format!("{name}_tb.v");
    run(folder.path(), "iverilog", &["-g2012", "-o", "simulation", &bench, "reference.v"])
        .unwrap_or_else(|error| panic!("{name}: {error}"));
    let ended = run(folder.path(), "vvp", &["-n", "simulation"]);
    assert_eq!(ended.is_err(), differs, "{name}: {ended:?}");
    let printed = ended.unwrap_or_else(|printed| printed);
    assert!(printed.contains(if differs { "FAIL: " } else { "PASS: " }), "{name}: {printed}");
}

probes! {
    WidenedSum, 9, true, #[hdl_gen] fn update(&mut self) {
        self.t.next = 0.into(); self.c.next = false;
        self.r.next = bit_cast::<9, 8>(self.a.val() + self.b.val());
    };
    WidenedDifference, 9, true, #[hdl_gen] fn update(&mut self) {
        self.t.next = 0.into(); self.c.next = false;
        self.r.next = bit_cast::<9, 8>(self.a.val() - self.b.val());
    };
    WidenedShift, 16, true, #[hdl_gen] fn update(&mut self) {
        self.t.next = 0.into(); self.c.next = false;
        self.r.next = bit_cast::<16, 8>(self.a.val() << self.s.val());
    };
    WidenedNot, 9, true, #[hdl_gen] fn update(&mut self) {
        self.t.next = 0.into(); self.c.next = false;
        self.r.next = bit_cast::<9, 8>(!self.a.val());
    };
    LiteralInComparison, 1, true, #[hdl_gen] fn update(&mut self) {
        self.t.next = 0.into(); self.c.next = self.a.val() + 1 == self.b.val();
        self.r.next = bit_cast::<1, 1>(self.c.val().into());
    };
    LiteralThenShift, 8, true, #[hdl_gen] fn update(&mut self) {
        self.t.next = 0.into(); self.c.next = false;
        self.r.next = (self.a.val() + 1) >> 1;
    };
    NotInComparison, 1, true, #[hdl_gen] fn update(&mut self) {
        self.t.next = 0.into(); self.c.next = (!self.a.val() | 1) > self.b.val();
        self.r.next = self.c.val().into();
    };
    OrBindsLooser, 1, true, #[hdl_gen] fn update(&mut self) {
        self.t.next = 0.into(); self.c.next = self.x.val() | self.y.val() == self.z.val();
        self.r.next = self.c.val().into();
    };
    AndBindsLooser, 1, true, #[hdl_gen] fn update(&mut self) {
        self.t.next = 0.into(); self.c.next = self.x.val() & self.y.val() != self.z.val();
        self.r.next = self.c.val().into();
    };
    SliceBeyondTheEnd, 4, true, #[hdl_gen] fn update(&mut self) {
        self.t.next = 0.into(); self.c.next = false;
        self.r.next = self.a.val().get_bits::<4>(self.s.val().index());
    };

    SumThenWiden, 9, false, #[hdl_gen] fn update(&mut self) {
        self.t.next = self.a.val() + self.b.val(); self.c.next = false;
        self.r.next = bit_cast::<9, 8>(self.t.val());
    };
    WidenThenAdd, 9, false, #[hdl_gen] fn update(&mut self) {
        self.t.next = 0.into(); self.c.next = false;
        self.r.next = bit_cast::<9, 8>(self.a.val()) + bit_cast::<9, 8>(self.b.val());
    };
    LiteralAssigned, 8, false, #[hdl_gen] fn update(&mut self) {
        self.t.next = self.a.val() + 1; self.c.next = self.t.val() == self.b.val();
        self.r.next = self.t.val() >> 1;
    };
    NotAssigned, 8, false, #[hdl_gen] fn update(&mut self) {
        self.t.next = !self.a.val() | 1; self.c.next = self.t.val() > self.b.val();
        self.r.next = self.t.val();
    };
    ParenthesisedOr, 1, false, #[hdl_gen] fn update(&mut self) {
        self.t.next = 0.into(); self.c.next = self.x.val() | (self.y.val() == self.z.val());
        self.r.next = self.c.val().into();
    };
    ShiftInPlace, 8, false, #[hdl_gen] fn update(&mut self) {
        self.t.next = self.a.val() << self.s.val(); self.c.next = false;
        self.r.next = self.t.val() >> 1;
    };
    SliceInside, 1, false, #[hdl_gen] fn update(&mut self) {
        self.t.next = 0.into(); self.c.next = false;
        self.r.next = self.a.val().get_bits::<1>(self.s.val().index());
    };
    SliceDiscarded, 4, false, #[hdl_gen] fn update(&mut self) {
        self.t.next = bit_cast::<8, 4>(self.a.val().get_bits::<4>(self.s.val().index())); self.c.next = false;
        self.r.next = 0.into();
        if self.s.val() < 5 {
            self.r.next = bit_cast::<4, 8>(self.t.val());
        }
    };
    MaskedLiteral, 8, false, #[hdl_gen] fn update(&mut self) {
        self.t.next = 0.into(); self.c.next = (self.a.val() & 0x0f) == 3;
        self.r.next = (self.a.val() ^ 0xa5) & !self.b.val();
    };
}

#[test]
fn the_language_modules_pass() {
    for result in [
        guard(&Operators::default()),
        guard(&Machine::default()),
        guard(&AddSub::default()),
        guard(&Tree::default()),
        guard(&SignedOps::default()),
    ] {
        result.unwrap_or_else(|error| panic!("{error}"));
    }
    // `packet.picked` takes bit `index` of 16: always inside.
    guard(&Fields::default()).unwrap_or_else(|error| panic!("{error}"));
}

#[test]
fn the_message_says_where_and_why() {
    let error = guard(&WidenedSum::default()).unwrap_err().to_string();
    assert!(error.starts_with("top: `r.next = bit_cast::<9, _>(a + b)`: `r` is 0x"), "{error}");
    assert!(error.contains("in the exported Verilog, for a = 0x"), "{error}");
}
