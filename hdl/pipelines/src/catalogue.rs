//! Every top by name: what can be exported, simulated or checked from a command line.

use std::fmt;
use std::str::FromStr;

use fp::Format;
use rust_hdl_core::prelude::Block;

use crate::formats;
use netlist::{Design, ElaborateError, elaborate, elaborate_with_tag};
use units;

/// Width of the integer adder in bits: a node's offset, zero-extended.
const OFFSET_BITS: usize = 32;

/// A top module.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Top {
    /// [`units::IntAdd`]; the same in every format.
    IntAdd,
    /// [`units::FpAdd`].
    FpAdd,
    /// [`units::FpMul`].
    FpMul,
    /// [`units::FpMinMax`].
    FpMinMax,
    /// [`units::FpCmp`].
    FpCmp,
    /// [`crate::DualSplitPipeline`] with the published inventory.
    DualSplit,
    /// The same without redundant comparators.
    DualSplitLean,
    /// [`crate::RayBoxPipeline`] with the published inventory.
    RayBox,
    /// The same without the redundant comparator.
    RayBoxLean,
    /// Two ray-box pipelines.
    RayBoxX2,
    /// Four ray-box pipelines.
    RayBoxX4,
    /// Eight ray-box pipelines.
    RayBoxX8,
    /// [`crate::SharedUnits`].
    SharedUnits,
}

/// A floating-point format that modules exist for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum StandardFormat {
    /// [`formats::binary32`].
    Binary32,
    /// [`formats::tf32`].
    Tf32,
    /// [`formats::bfloat16`].
    Bfloat16,
    /// [`formats::binary16`].
    Binary16,
    /// [`formats::e5m2`].
    E5m2,
    /// [`formats::e4m3`].
    E4m3,
}

/// A name that is not in the catalogue.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("no {what} is called `{name}`; there are {}", .known.join(", "))]
pub struct UnknownName {
    /// What was looked for.
    pub what: &'static str,
    /// The name given.
    pub name: String,
    /// The names that exist.
    pub known: Vec<&'static str>,
}

macro_rules! names {
    ($type:ident, $what:literal, $($variant:ident = $name:literal),* $(,)?) => {
        impl $type {
            /// All of them.
            pub const ALL: &'static [Self] = &[$(Self::$variant),*];

            /// The name on the command line and in files.
            #[must_use]
            pub fn name(self) -> &'static str {
                match self {
                    $(Self::$variant => $name,)*
                }
            }
        }

        impl fmt::Display for $type {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str(self.name())
            }
        }

        impl FromStr for $type {
            type Err = UnknownName;

            fn from_str(name: &str) -> Result<Self, UnknownName> {
                let known = || Self::ALL.iter().map(|each| each.name()).collect();
                let found = Self::ALL.iter().copied().find(|each| each.name() == name);
                found.ok_or_else(|| UnknownName { what: $what, name: name.to_owned(), known: known() })
            }
        }
    };
}

names! { Top, "unit",
    IntAdd = "int_add",
    FpAdd = "fp_add",
    FpMul = "fp_mul",
    FpMinMax = "fp_min_max",
    FpCmp = "fp_cmp",
    DualSplit = "dual_split",
    DualSplitLean = "dual_split_lean",
    RayBox = "ray_box",
    RayBoxLean = "ray_box_lean",
    RayBoxX2 = "ray_box_x2",
    RayBoxX4 = "ray_box_x4",
    RayBoxX8 = "ray_box_x8",
    SharedUnits = "shared_units",
}

names! { StandardFormat, "format",
    Binary32 = "binary32",
    Tf32 = "tf32",
    Bfloat16 = "bfloat16",
    Binary16 = "binary16",
    E5m2 = "e5m2",
    E4m3 = "e4m3",
}

impl StandardFormat {
    /// The widths.
    #[must_use]
    pub fn format(self) -> Format {
        match self {
            Self::Binary32 => Format::BINARY32,
            Self::Tf32 => Format::TF32,
            Self::Bfloat16 => Format::BFLOAT16,
            Self::Binary16 => Format::BINARY16,
            Self::E5m2 => Format::E5M2,
            Self::E4m3 => Format::E4M3,
        }
    }
}

/// Why there is no module or design.
#[derive(Debug, thiserror::Error)]
pub enum CatalogueError {
    /// The module exists in other formats only.
    #[error("{top} does not exist in {format}; it exists in {}", names(.top.formats()))]
    NoSuchFormat {
        /// The module.
        top: Top,
        /// The format asked for.
        format: StandardFormat,
    },
    /// The module does not elaborate; a test elaborates each.
    #[error(transparent)]
    Elaborate(#[from] ElaborateError),
}

fn names(formats: &[StandardFormat]) -> String {
    formats.iter().map(|format| format.name()).collect::<Vec<_>>().join(", ")
}

/// One of the modules that exist in every format.
macro_rules! in_format {
    ($top:expr, $format:ident) => {
        match $top {
            Top::IntAdd => Some(boxed::<units::IntAdd<OFFSET_BITS, 1>>()),
            Top::FpAdd => Some(boxed::<formats::$format::FpAdd>()),
            Top::FpMul => Some(boxed::<formats::$format::FpMul>()),
            Top::FpMinMax => Some(boxed::<formats::$format::FpMinMax>()),
            Top::FpCmp => Some(boxed::<formats::$format::FpCmp>()),
            Top::DualSplit => Some(boxed::<formats::$format::DualSplitPipeline>()),
            Top::RayBox => Some(boxed::<formats::$format::RayBoxPipeline>()),
            _ => None,
        }
    };
}

/// One of the modules that exist in binary32 alone.
fn in_binary32(top: Top) -> Option<Box<dyn Block>> {
    match top {
        Top::DualSplitLean => Some(boxed::<formats::DualSplitPipelineLean>()),
        Top::RayBoxLean => Some(boxed::<formats::RayBoxPipelineLean>()),
        Top::RayBoxX2 => Some(boxed::<formats::RayBoxX2>()),
        Top::RayBoxX4 => Some(boxed::<formats::RayBoxX4>()),
        Top::RayBoxX8 => Some(boxed::<formats::RayBoxX8>()),
        Top::SharedUnits => Some(boxed::<formats::SharedUnits>()),
        _ => None,
    }
}

impl Top {
    /// The formats that the module exists in: all of them for the units and both pipelines, binary32 for their lean and parallel
    /// forms and the shared block.
    #[must_use]
    pub fn formats(self) -> &'static [StandardFormat] {
        match self {
            Self::IntAdd
            | Self::FpAdd
            | Self::FpMul
            | Self::FpMinMax
            | Self::FpCmp
            | Self::DualSplit
            | Self::RayBox => StandardFormat::ALL,
            Self::DualSplitLean
            | Self::RayBoxLean
            | Self::RayBoxX2
            | Self::RayBoxX4
            | Self::RayBoxX8
            | Self::SharedUnits => &[StandardFormat::Binary32],
        }
    }

    /// Whether it is one of the traversal pipelines, in any form but the shared block's.
    #[must_use]
    pub fn is_pipeline(self) -> bool {
        use Top::{DualSplit, DualSplitLean, RayBox, RayBoxLean, RayBoxX2, RayBoxX4, RayBoxX8};
        matches!(self, DualSplit | DualSplitLean | RayBox | RayBoxLean | RayBoxX2 | RayBoxX4 | RayBoxX8)
    }

    /// The module in a format, connected.
    ///
    /// # Errors
    /// [`CatalogueError::NoSuchFormat`] if it does not exist in that format.
    pub fn module(self, format: StandardFormat) -> Result<Box<dyn Block>, CatalogueError> {
        let module = match format {
            StandardFormat::Binary32 => in_format!(self, binary32).or_else(|| in_binary32(self)),
            StandardFormat::Tf32 => in_format!(self, tf32),
            StandardFormat::Bfloat16 => in_format!(self, bfloat16),
            StandardFormat::Binary16 => in_format!(self, binary16),
            StandardFormat::E5m2 => in_format!(self, e5m2),
            StandardFormat::E4m3 => in_format!(self, e4m3),
        };
        let mut module = module.ok_or(CatalogueError::NoSuchFormat { top: self, format })?;
        module.connect_all();
        Ok(module)
    }

    /// The elaborated design, called by the top's name, with the format's name behind it unless it is binary32.
    ///
    /// # Errors
    /// As [`Top::module`].
    pub fn design(self, format: StandardFormat) -> Result<Design, CatalogueError> {
        Ok(elaborate(self.module(format)?.as_ref(), &self.design_name(format))?)
    }

    /// The design with tags of `tag_bits` bits.
    ///
    /// # Errors
    /// As [`Top::module`].
    pub fn design_with_tag(self, format: StandardFormat, tag_bits: u32) -> Result<Design, CatalogueError> {
        let name = self.design_name(format);
        Ok(elaborate_with_tag(self.module(format)?.as_ref(), &name, tag_bits as usize)?)
    }

    /// Name of the design and of its files.
    #[must_use]
    pub fn design_name(self, format: StandardFormat) -> String {
        match format {
            StandardFormat::Binary32 => self.name().to_owned(),
            _ => format!("{self}_{format}"),
        }
    }
}

/// The source file of every kind of module in the catalogue's designs, whose comments the exported Verilog keeps.
#[must_use]
pub fn sources() -> Vec<(&'static str, &'static str)> {
    [units::SOURCES, crate::SOURCES].concat()
}

fn boxed<M: Block + Default + 'static>() -> Box<dyn Block> {
    Box::<M>::default()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_read_back() {
        for &top in Top::ALL {
            assert_eq!(top.name().parse(), Ok(top));
        }
        for &format in StandardFormat::ALL {
            assert_eq!(format.name().parse(), Ok(format));
        }
        for (&top, &format) in
            Top::ALL.iter().flat_map(|top| StandardFormat::ALL.iter().map(move |f| (top, f)))
        {
            assert_eq!(top.module(format).is_ok(), top.formats().contains(&format), "{top} {format}");
        }
        let error = Top::SharedUnits.module(StandardFormat::E5m2).err().unwrap().to_string();
        assert_eq!(error, "shared_units does not exist in e5m2; it exists in binary32");
        let error = "fp_div".parse::<Top>().unwrap_err().to_string();
        assert!(error.starts_with("no unit is called `fp_div`; there are int_add, fp_add"), "{error}");
    }
}
