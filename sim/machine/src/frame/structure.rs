//! The eight structures: what each is traced through, its program, its pipeline; and programs in their place.

use crate::core::Counts;
use crate::description::{DescriptionError, MachineDescription, NodeLayout};
use crate::kernels;
use crate::pipelines::take_units;
use crate::program::{ListingError, Opcode, Program};
use crate::results::{Results, Tally};
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

    /// Boxes that its pipeline tests at once.
    fn boxes(self) -> u32 {
        match self {
            Self::Dst | Self::DstSoftware => 0,
            Self::Bvh2 | Self::Bvh4 | Self::Bvh8 => 1,
            Self::Bvh2Plus => 2,
            Self::Bvh4Plus => 4,
            Self::Bvh8Plus => 8,
        }
    }

    /// Whether its pipeline, if the operation needs one, can do it.
    fn executes(self, opcode: Opcode) -> bool {
        match opcode {
            Opcode::DualSplitStep => self == Self::Dst,
            Opcode::BoxTest => self.boxes() >= 1,
            Opcode::BoxTestPair | Opcode::BoxTestLanes | Opcode::LoadLane | Opcode::LaneEntry => {
                self.boxes() >= 2
            }
            _ => true,
        }
    }

    /// Name of its listing in [`kernels::FILES`], without the extension.
    fn listing_name(self, layout: NodeLayout) -> &'static str {
        match (self, layout.is_packed()) {
            (Self::Dst, _) => "dst",
            (Self::DstSoftware, _) => "dst-sw",
            (Self::Bvh2, true) => "bvh2",
            (Self::Bvh2, false) => "bvh2-words",
            (Self::Bvh2Plus, true) => "bvh2-parallel",
            (Self::Bvh2Plus, false) => "bvh2-parallel-words",
            (Self::Bvh4 | Self::Bvh8, true) => "bvh-wide",
            (Self::Bvh4 | Self::Bvh8, false) => "bvh-wide-words",
            (Self::Bvh4Plus | Self::Bvh8Plus, true) => "bvh-wide-parallel",
            (Self::Bvh4Plus | Self::Bvh8Plus, false) => "bvh-wide-parallel-words",
        }
    }

    /// Its program as compiled, for nodes that lie as `layout` has them.
    ///
    /// # Panics
    /// If the file is not in the list, which a test excludes.
    #[must_use]
    pub fn listing(self, layout: NodeLayout) -> &'static str {
        kernels::file(&format!("{}.s", self.listing_name(layout))).expect("every structure has a listing")
    }

    /// What is defined where its program is compiled.
    #[must_use]
    pub fn defines(self, layout: NodeLayout) -> Vec<&'static str> {
        kernels::defines(self.listing_name(layout))
    }
}

impl fmt::Display for MachineStructure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// A program in the place of a structure's own.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Kernel {
    /// What errors call it.
    pub name: String,
    /// Its listing.
    pub listing: String,
    /// Whether its picture may differ from golden's: differences are then counted in [`super::Totals`].
    pub may_differ: bool,
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
    /// The program, if it is not the structure's own.
    pub kernel: Option<Kernel>,
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
            let single = structure.adds_units().then(|| pipeline(RAY_BOX));
            take_units(own, single.as_ref(), &mut description)?;
        }
        Ok(Self { structure, description, pipeline: own, kernel: None })
    }

    /// The same machine with `kernel` in the place of the structure's program.
    #[must_use]
    pub fn with_kernel(self, kernel: Kernel) -> Self {
        Self { kernel: Some(kernel), ..self }
    }

    /// The results of a run of `program` that counted `counts`.
    ///
    /// # Errors
    /// If the cost of a cache is not known.
    pub fn results(&self, program: &Program, counts: &Counts) -> Result<Results, DescriptionError> {
        Results::new(&self.description, self.pipeline.as_ref(), &Tally::new(program, counts))
    }

    /// The program for this machine.
    ///
    /// # Errors
    /// If there is a mistake in its listing, or it needs another pipeline.
    pub fn program(&self) -> Result<Program, ListingError> {
        let latency = self.pipeline.as_ref().map_or(1, |pipeline| pipeline.latency_cycles);
        let (name, listing) = match &self.kernel {
            Some(kernel) => (kernel.name.as_str(), kernel.listing.as_str()),
            None => (self.structure.name(), self.structure.listing(self.description.layout)),
        };
        let program = Program::new(name, listing, &self.description, latency)?;
        let unknown = program.operations.iter().position(|op| !self.structure.executes(op.opcode));
        if let Some(at) = unknown {
            return Err(ListingError {
                program: program.name,
                line: program.lines[at] as usize,
                message: format!("the pipeline of `{}` has no such operation", self.structure),
            });
        }
        Ok(Program { lanes: self.structure.boxes(), ..program })
    }
}
