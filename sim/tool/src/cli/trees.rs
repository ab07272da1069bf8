//! Arguments of the commands about scenes, trees and pictures.

use super::shared::{DetailArgs, ModeArgs, QualityArgs, SceneArgs, StructureArgs, ViewArgs};
use super::values::{pixel, quantity, row, structure, test};
use clap::Args;
use golden::structure::StructureKind;
use render::Test;
use std::path::PathBuf;
use studies::trees::TreeKind;
use view::picture::heatmap::Quantity;

#[derive(Args, Debug)]
pub struct ScenesArgs {
    /// The scene to write.
    #[arg(requires = "export")]
    pub name: Option<String>,
    /// The file to write: its name ends in .obj, .ply or .stl, and then in .xz or .gz if it is to be compressed.
    #[arg(long, value_name = "FILE", requires = "name")]
    pub export: Option<PathBuf>,
    #[command(flatten)]
    pub detail: DetailArgs,
}

#[derive(Args, Debug)]
pub struct TreeArgs {
    #[command(flatten)]
    pub scene: SceneArgs,
    #[command(flatten)]
    pub quality: QualityArgs,
    /// Save a structure to this file, which other commands load with --tree.
    #[arg(long, value_name = "FILE")]
    pub save: Option<PathBuf>,
    /// The structure to save; dst_scratch is the dual-split tree of a partition optimized for dual-split trees.
    #[arg(long, default_value = "dst", requires = "save", value_parser = row())]
    pub structure: TreeKind,
    /// Also build dst_scratch, which takes several times as long as all other structures.
    #[arg(long)]
    pub scratch: bool,
}

#[derive(Args, Debug)]
pub struct TraceArgs {
    #[command(flatten)]
    pub scene: SceneArgs,
    /// The DSTRAYS1 file of the rays to trace.
    #[arg(long, value_name = "FILE")]
    pub rays: PathBuf,
    #[command(flatten)]
    pub structure: StructureArgs,
    #[command(flatten)]
    pub mode: ModeArgs,
    /// The DSTHITS1 file to write the hits to.
    #[arg(long, value_name = "FILE")]
    pub out: Option<PathBuf>,
}

#[derive(Args, Debug)]
pub struct RenderArgs {
    #[command(flatten)]
    pub scene: SceneArgs,
    #[command(flatten)]
    pub structure: StructureArgs,
    /// raycast: primary and shadow rays; path: path tracing with 5 diffuse bounces.
    #[arg(long, default_value = "path", value_parser = test())]
    pub test: Test,
    #[command(flatten)]
    pub mode: ModeArgs,
    #[command(flatten)]
    pub view: ViewArgs,
    /// Samples per pixel.
    #[arg(long, default_value_t = 1, value_name = "N")]
    pub spp: u32,
    /// Brightness of a PNG in factors of two; it does not change EXR files.
    #[arg(long, default_value_t = 0.0, value_name = "STOPS", allow_hyphen_values = true)]
    pub exposure: f32,
    /// Draw the work per pixel instead of the picture.
    #[arg(long, value_name = "QUANTITY", value_parser = quantity())]
    pub heatmap: Option<Quantity>,
    /// Value at the end of the heat map's scale, to compare several maps [default: the largest of the map].
    #[arg(long, value_name = "N", requires = "heatmap", value_parser = clap::value_parser!(u32).range(1..))]
    pub heatmap_max: Option<u32>,
    /// The picture: .png (sRGB) or .exr (linear, with depth, normal, triangle and the counters as layers).
    #[arg(long, value_name = "FILE")]
    pub out: PathBuf,
    /// Also write the traced rays to a DSTRAYS1 file.
    #[arg(long, value_name = "FILE")]
    pub rays: Option<PathBuf>,
}

#[derive(Args, Debug)]
pub struct CompareArgs {
    /// A .png or .exr file.
    pub a: PathBuf,
    /// Another file of the same format and size.
    pub b: PathBuf,
    /// The file to write the difference to: .png as a heat map, .exr in numbers.
    #[arg(long, value_name = "FILE")]
    pub out: Option<PathBuf>,
}

#[derive(Args, Debug)]
pub struct ExplainArgs {
    #[command(flatten)]
    pub scene: SceneArgs,
    /// Column and row of the pixel, counted from 0 at the upper left corner.
    #[arg(long, value_name = "X,Y", value_parser = pixel)]
    pub pixel: [u32; 2],
    /// A structure to trace the ray through; may be repeated.
    #[arg(long, default_values = ["dst", "bvh2"], value_parser = structure())]
    pub structure: Vec<StructureKind>,
    #[command(flatten)]
    pub mode: ModeArgs,
    #[command(flatten)]
    pub quality: QualityArgs,
    #[command(flatten)]
    pub view: ViewArgs,
}
