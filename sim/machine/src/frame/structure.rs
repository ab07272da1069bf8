//! The eight structures: what each is traced through, its program, its pipeline.

use crate::description::{DescriptionError, MachineDescription};
use crate::pipelines::{add_units_beyond, take_units};
use crate::program::{ListingError, Program};
use costs::Pipeline;
use golden::structure::StructureKind;
use std::fmt;

/// The pipeline of which parallel forms have several.
const RAY_BOX: &str = "ray_box";

/// A structure with the way in which the machine traverses it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum MachineStructure {
    /// Dual-split tree, stepped by the dual-split pipeline.
    Dst,
    /// Dual-split tree, decoded in software.
    DstSoftware,
    /// BVH2 with one ray-box pipeline.
    Bvh2,
    /// BVH4 with one ray-box pipeline, boxes tested one after another.
    Bvh4,
    /// BVH8 with one ray-box pipeline, boxes tested one after another.
    Bvh8,
    /// BVH2 with two ray-box pipelines side by side.
    Bvh2Plus,
    /// BVH4 with four ray-box pipelines side by side.
    Bvh4Plus,
    /// BVH8 with eight ray-box pipelines side by side.
    Bvh8Plus,
}

impl MachineStructure {
    /// All of them, in the order of tables.
    pub const ALL: [Self; 8] = [
        Self::Dst,
        Self::DstSoftware,
        Self::Bvh2,
        Self::Bvh4,
        Self::Bvh8,
        Self::Bvh2Plus,
        Self::Bvh4Plus,
        Self::Bvh8Plus,
    ];

    /// The name on the command line and in result files.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Dst => "dst",
            Self::DstSoftware => "dst-sw",
            Self::Bvh2 => "bvh2",
            Self::Bvh4 => "bvh4",
            Self::Bvh8 => "bvh8",
            Self::Bvh2Plus => "bvh2+",
            Self::Bvh4Plus => "bvh4+",
            Self::Bvh8Plus => "bvh8+",
        }
    }

    /// What rays are traced through.
    #[must_use]
    pub fn kind(self) -> StructureKind {
        match self {
            Self::Dst | Self::DstSoftware => StructureKind::Dst,
            Self::Bvh2 | Self::Bvh2Plus => StructureKind::Bvh2,
            Self::Bvh4 | Self::Bvh4Plus => StructureKind::Bvh4,
            Self::Bvh8 | Self::Bvh8Plus => StructureKind::Bvh8,
        }
    }

    /// Name of the pipeline of a multiprocessor.
    fn pipeline(self) -> Option<&'static str> {
        match self {
            Self::Dst => Some("dual_split"),
            Self::DstSoftware => None,
            Self::Bvh2 | Self::Bvh4 | Self::Bvh8 => Some(RAY_BOX),
            Self::Bvh2Plus => Some("ray_box_x2"),
            Self::Bvh4Plus => Some("ray_box_x4"),
            Self::Bvh8Plus => Some("ray_box_x8"),
        }
    }

    /// Whether the pipelines beyond the first are units added to the multiprocessor.
    fn adds_units(self) -> bool {
        matches!(self, Self::Bvh2Plus | Self::Bvh4Plus | Self::Bvh8Plus)
    }

    /// Its program as compiled.
    #[must_use]
    pub fn listing(self) -> &'static str {
        match self {
            Self::Dst => include_str!("../../kernels/dst.s"),
            Self::DstSoftware => include_str!("../../kernels/dst-sw.s"),
            Self::Bvh2 => include_str!("../../kernels/bvh2.s"),
            Self::Bvh2Plus => include_str!("../../kernels/bvh2-parallel.s"),
            Self::Bvh4 | Self::Bvh8 => include_str!("../../kernels/bvh-wide.s"),
            Self::Bvh4Plus | Self::Bvh8Plus => include_str!("../../kernels/bvh-wide-parallel.s"),
        }
    }
}

impl fmt::Display for MachineStructure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// A machine, set up for a structure.
#[derive(Clone, Debug)]
pub struct FrameMachine {
    /// The structure.
    pub structure: MachineStructure,
    /// The machine with the units that the pipeline leaves.
    pub description: MachineDescription,
    /// The pipeline.
    pub pipeline: Option<Pipeline>,
}

impl FrameMachine {
    /// Sets `machine` up for `structure`: its pipeline takes its units out of the multiprocessor's, after those that
    /// parallel pipelines add. `pipeline` gives a pipeline by the name of its module.
    ///
    /// # Errors
    /// If the units do not suffice.
    pub fn new(
        machine: &MachineDescription,
        structure: MachineStructure,
        pipeline: impl Fn(&str) -> Pipeline,
    ) -> Result<Self, DescriptionError> {
        let mut description = machine.clone();
        let own = structure.pipeline().map(&pipeline);
        if let Some(own) = &own {
            if structure.adds_units() {
                add_units_beyond(own, &pipeline(RAY_BOX), &mut description);
            }
            take_units(own, &mut description)?;
        }
        Ok(Self { structure, description, pipeline: own })
    }

    /// The structure's program for this machine.
    ///
    /// # Errors
    /// If there is a mistake in its listing.
    pub fn program(&self) -> Result<Program, ListingError> {
        let latency = self.pipeline.as_ref().map_or(1, |pipeline| pipeline.latency_cycles);
        Program::new(self.structure.name(), self.structure.listing(), &self.description, latency)
    }
}
