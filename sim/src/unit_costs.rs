//! Area and energy of single execution units at 65 nm and 1 GHz, as published.
//!
//! The paper's figures are sums of this table: ray-box 6 FPADD + 6 FPMUL + 14 FPMIN/CMP + 1 INTADD = 0.1278 mm2 and
//! 0.1377 nJ. Such sums hold no pipeline registers, clock or wires. The table is that of the public TRaX simulator
//! SimTRaX (Utah Hardware Ray Tracing group, `sim/ReadConfig.cc`), on which the paper was measured: Lin, Vasiou,
//! Yuksel, Kopta, Brunvand, "Hardware-Accelerated Dual-Split Trees", HPG 2020, doi:10.1145/3406185.

/// Where the numbers of [`UnitCost`] are from.
pub const SOURCE: &str = "published unit table of SimTRaX (65 nm, 1 GHz)";

/// An execution unit of a thread multiprocessor.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, serde::Serialize)]
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

    /// The unit that the module of this kind is, by the name of the kind in [`hdl::netlist::Inventory::units`].
    #[must_use]
    pub fn of_module(kind: &str) -> Option<Self> {
        Some(match kind {
            "fp_add" => Self::FpAdd,
            "fp_mul" => Self::FpMul,
            "fp_min_max" => Self::FpMinMax,
            "fp_cmp" => Self::FpCmp,
            "int_add" => Self::IntAdd,
            _ => return None,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use hdl::catalogue::{StandardFormat, Top};

    /// Area in mm2 and energy in nJ of a pipeline's units.
    fn sum(top: Top) -> (f64, f64) {
        let design = top.design(StandardFormat::Binary32).unwrap();
        let units = hdl::netlist::inventory(&design).unwrap().units;
        units
            .iter()
            .filter_map(|(kind, &count)| Some((Unit::of_module(kind)?.published(), f64::from(count))))
            .fold((0.0, 0.0), |(area, energy), (cost, count)| {
                (area + count * cost.area_um2 / 1e6, energy + count * cost.energy_pj / 1e3)
            })
    }

    #[test]
    fn sums_are_those_of_the_paper() {
        let (area, energy) = sum(Top::RayBox);
        assert_eq!((format!("{area:.4}"), format!("{energy:.4}")), ("0.1271".into(), "0.1371".into()));
        let (area, energy) = sum(Top::DualSplit);
        assert_eq!((format!("{area:.4}"), format!("{energy:.4}")), ("0.0447".into(), "0.0475".into()));
    }
}
