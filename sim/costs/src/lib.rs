//! Area and energy of single execution units at 65 nm and 1 GHz, as published.
//!
//! The paper's figures are sums of this table: ray-box 6 FPADD + 6 FPMUL + 14 FPMIN/CMP + 1 INTADD = 0.1278 mm2 and 0.1377 nJ. Such
//! sums hold no pipeline registers, clock or wires. The table is that of the public TRaX simulator SimTRaX (Utah Hardware Ray Tracing
//! group, `sim/ReadConfig.cc`), on which the paper was measured: Lin, Vasiou, Yuksel, Kopta, Brunvand, "Hardware-Accelerated Dual-Split
//! Trees", HPG 2020, doi:10.1145/3406185.
//!
//! ```
//! use costs::Unit;
//!
//! let units = [(Unit::FpAdd, 6), (Unit::FpMul, 6), (Unit::FpMinMax, 12), (Unit::FpCmp, 2), (Unit::IntAdd, 1)];
//! let area_um2: f64 = units.iter().map(|(unit, count)| f64::from(*count) * unit.published().area_um2).sum();
//! assert_eq!((area_um2 / 100.0).round(), 1278.0);
//! ```

use std::collections::BTreeMap;

/// The source of the numbers of [`UnitCost`].
pub const SOURCE: &str = "published unit table of SimTRaX (65 nm, 1 GHz)";

/// An execution unit of a thread multiprocessor.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, serde::Deserialize, serde::Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Unit {
    /// Floating-point addition and subtraction.
    FpAdd,
    /// Floating-point multiplication.
    FpMul,
    /// Floating-point minimum and maximum.
    FpMinMax,
    /// Floating-point comparison.
    FpCmp,
    /// Integer addition, subtraction and comparison.
    IntAdd,
    /// Integer multiplication.
    IntMul,
    /// Division and inverse square root.
    FpInv,
    /// Conversion between integers and floating point.
    Convert,
    /// Branches and jumps.
    Branch,
    /// Bitwise operations and shifts.
    Bitwise,
}

/// Cost of one unit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct UnitCost {
    /// Area in square micrometres.
    pub area_um2: f64,
    /// Energy of one operation in picojoules.
    pub energy_pj: f64,
    /// Cycles from operands to result.
    pub latency_cycles: u32,
}

impl Unit {
    /// All units.
    pub const ALL: [Self; 10] = [
        Self::FpAdd,
        Self::FpMul,
        Self::FpMinMax,
        Self::FpCmp,
        Self::IntAdd,
        Self::IntMul,
        Self::FpInv,
        Self::Convert,
        Self::Branch,
        Self::Bitwise,
    ];

    /// The name in machine descriptions and result files.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::FpAdd => "fp_add",
            Self::FpMul => "fp_mul",
            Self::FpMinMax => "fp_min_max",
            Self::FpCmp => "fp_cmp",
            Self::IntAdd => "int_add",
            Self::IntMul => "int_mul",
            Self::FpInv => "fp_inv",
            Self::Convert => "convert",
            Self::Branch => "branch",
            Self::Bitwise => "bitwise",
        }
    }

    /// The published cost; see [`SOURCE`].
    #[must_use]
    pub const fn published(self) -> UnitCost {
        let (area_um2, energy_pj, latency_cycles) = match self {
            Self::FpAdd => (3000.0, 7.4, 2),
            Self::FpMul => (16500.0, 14.2, 2),
            Self::FpMinMax | Self::FpCmp => (722.0, 0.536, 1),
            Self::IntAdd | Self::Branch | Self::Bitwise => (660.0, 0.572, 1),
            Self::IntMul => (11700.0, 17.7, 1),
            Self::FpInv => (112_000.0, 156.3, 16),
            Self::Convert => (1814.0, 1.0, 1),
        };
        UnitCost { area_um2, energy_pj, latency_cycles }
    }

    /// The unit of a module whose kind an elaborated inventory calls `kind`; `None` for modules that are no unit.
    #[must_use]
    pub fn of_module(kind: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|unit| unit.name() == kind)
    }
}

/// What a pipeline costs.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize)]
#[serde(deny_unknown_fields)]
pub struct PipelineCost {
    /// Units and glue, without registers, clock and wires, in square micrometres.
    pub area_um2: f64,
    /// Energy of one operation, of units and glue, in picojoules.
    pub energy_pj: f64,
    /// The part of the area that is glue: selection, offset and return logic between the units.
    pub glue_area_um2: f64,
    /// The part of the energy that is glue.
    pub glue_energy_pj: f64,
    /// The source of the numbers.
    pub source: String,
}

/// A pipeline of a multiprocessor, as the data that a model of the machine needs.
#[derive(Clone, Debug, PartialEq)]
pub struct Pipeline {
    /// Name of the module.
    pub name: String,
    /// Execution units of the pipeline.
    pub units: BTreeMap<Unit, u32>,
    /// Cycles from operands to results.
    pub latency_cycles: u32,
    /// Area and energy of an operation.
    pub cost: PipelineCost,
}

impl Pipeline {
    /// Area of its units in square micrometres, as published.
    #[must_use]
    pub fn unit_area_um2(&self) -> f64 {
        self.units.iter().map(|(unit, count)| f64::from(*count) * unit.published().area_um2).sum()
    }
}
