//! The command line.

use clap::builder::{PossibleValuesParser, TypedValueParser};
use clap::{Args, Parser, Subcommand};
use golden::Mode;
use golden::build::Quality;
use golden::render::Test;
use golden::structure::StructureKind;
use hdl::catalogue::{StandardFormat, Top};
use sim::picture::heatmap::Quantity;
use std::path::PathBuf;

/// Dual-split trees against bounding volume hierarchies: build, trace, render, compare.
///
/// Without a command, runs `reproduce --preset quick`. Results go to stdout, progress to stderr. Exit codes: 0 done, 1 a
/// check found a difference, 2 bad input or usage.
#[derive(Debug, Parser)]
#[command(name = "dualsplit", version, max_term_width = 100)]
pub struct Cli {
    #[command(flatten)]
    pub global: Global,
    #[command(subcommand)]
    pub command: Option<Command>,
}

#[derive(Args, Clone, Copy, Debug)]
pub struct Global {
    /// Print one JSON document instead of tables.
    #[arg(long, global = true)]
    pub json: bool,
    /// Seed of the built-in scenes, of the renderer's samples and of the checks' stimulus.
    #[arg(long, global = true, default_value_t = 0, value_name = "N")]
    pub seed: u64,
    /// Number of threads; results do not depend on it [default: all processors].
    #[arg(long, global = true, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    pub threads: Option<u16>,
    /// Replace files that exist.
    #[arg(long, global = true)]
    pub force: bool,
}

#[derive(Debug, Subcommand)]
pub enum Command {
    /// List the built-in scenes, or write one to an OBJ file.
    Scenes(ScenesArgs),
    /// Build all structures over a scene and print their sizes, costs and histograms.
    Tree(TreeArgs),
    /// Trace a file of rays for their closest hits and write the hits.
    Trace(TraceArgs),
    /// Render a scene, or a heat map of the work that it takes.
    Render(RenderArgs),
    /// Compare two pictures; exit code 1 if any pixel differs.
    Compare(CompareArgs),
    /// Print the traversal of one pixel's primary ray step by step, in the dual-split tree and in the BVH2.
    Explain(ExplainArgs),
    /// Compare the hardware's netlist with the specification, cycle by cycle; exit code 1 if anything differs.
    Check(CheckArgs),
    /// Write Verilog with testbenches, vectors and scripts.
    Export(ExportArgs),
    /// Write a waveform of rays in the hardware.
    Wave(WaveArgs),
    /// Build, render and measure all built-in scenes, and write a folder of pictures, CSV and JSON.
    Reproduce(ReproduceArgs),
}

/// Which geometry.
#[derive(Args, Clone, Debug)]
pub struct SceneArgs {
    /// A built-in scene (see `dualsplit scenes`) or an OBJ file, which may be xz-compressed.
    pub scene: String,
    #[command(flatten)]
    pub detail: DetailArgs,
}

#[derive(Args, Clone, Copy, Debug)]
pub struct DetailArgs {
    /// Fraction of a built-in scene's full number of triangles, above 0 and at most 1.
    #[arg(long, default_value_t = 0.1, value_name = "FRACTION")]
    pub detail: f64,
}

#[derive(Args, Clone, Copy, Debug)]
pub struct QualityArgs {
    /// Build time against tree quality: fast, medium or high.
    #[arg(long, default_value = "high", value_name = "PRESET", value_parser = quality(), hide_possible_values = true)]
    pub quality: Quality,
}

#[derive(Args, Clone, Copy, Debug)]
pub struct ModeArgs {
    /// Rounding of plane distances: robust never loses a hit of the triangle test, fast may at the edges of boxes.
    #[arg(long, default_value = "robust", value_parser = mode())]
    pub mode: Mode,
}

/// Where from and under which light; by default the scene's own, for a file a view of all of it.
#[derive(Args, Clone, Debug)]
pub struct ViewArgs {
    /// Position of the camera.
    #[arg(long, value_name = "X,Y,Z", value_parser = vector, allow_hyphen_values = true)]
    pub eye: Option<[f32; 3]>,
    /// Point in the centre of the image.
    #[arg(long, value_name = "X,Y,Z", value_parser = vector, allow_hyphen_values = true)]
    pub target: Option<[f32; 3]>,
    /// Direction that appears upwards.
    #[arg(long, value_name = "X,Y,Z", value_parser = vector, allow_hyphen_values = true)]
    pub up: Option<[f32; 3]>,
    /// Vertical field of view in degrees.
    #[arg(long, value_name = "DEGREES", allow_hyphen_values = true)]
    pub fov: Option<f32>,
    /// Position of the point light, whose brightness is then adapted to its distance from the target.
    #[arg(long, value_name = "X,Y,Z", value_parser = vector, allow_hyphen_values = true)]
    pub light: Option<[f32; 3]>,
    /// Width and height of the image in pixels.
    #[arg(long, default_value = "512x512", value_name = "WxH", value_parser = size)]
    pub size: [u32; 2],
}

#[derive(Args, Debug)]
pub struct ScenesArgs {
    /// The scene to write.
    #[arg(requires = "export")]
    pub name: Option<String>,
    /// The OBJ file to write, xz-compressed if it ends in .xz.
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
}

#[derive(Args, Debug)]
pub struct TraceArgs {
    #[command(flatten)]
    pub scene: SceneArgs,
    /// The rays to trace, a DSTRAYS1 file.
    #[arg(long, value_name = "FILE")]
    pub rays: PathBuf,
    /// The structure to trace them through.
    #[arg(long, default_value = "dst", value_parser = structure())]
    pub structure: StructureKind,
    #[command(flatten)]
    pub mode: ModeArgs,
    #[command(flatten)]
    pub quality: QualityArgs,
    /// Where to write the hits, a DSTHITS1 file.
    #[arg(long, value_name = "FILE")]
    pub out: Option<PathBuf>,
}

#[derive(Args, Debug)]
pub struct RenderArgs {
    #[command(flatten)]
    pub scene: SceneArgs,
    /// The structure that rays are traced through; all give the same picture.
    #[arg(long, default_value = "dst", value_parser = structure())]
    pub structure: StructureKind,
    /// raycast: primary and shadow rays; path: path tracing with 5 diffuse bounces.
    #[arg(long, default_value = "path", value_parser = test())]
    pub test: Test,
    #[command(flatten)]
    pub mode: ModeArgs,
    #[command(flatten)]
    pub quality: QualityArgs,
    #[command(flatten)]
    pub view: ViewArgs,
    /// Samples per pixel.
    #[arg(long, default_value_t = 1, value_name = "N")]
    pub spp: u32,
    /// Brightness of the PNG in factors of two; EXR files stay as they are.
    #[arg(long, default_value_t = 0.0, value_name = "STOPS", allow_hyphen_values = true)]
    pub exposure: f32,
    /// Draw the work per pixel instead of the picture.
    #[arg(long, value_name = "QUANTITY", value_parser = quantity())]
    pub heatmap: Option<Quantity>,
    /// Value at the end of the heat map's scale, to compare several [default: the largest of the picture].
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
    /// Another of the same format and size.
    pub b: PathBuf,
    /// Where to write the difference: .png as a heat map, .exr in numbers.
    #[arg(long, value_name = "FILE")]
    pub out: Option<PathBuf>,
}

#[derive(Args, Debug)]
pub struct ExplainArgs {
    #[command(flatten)]
    pub scene: SceneArgs,
    /// Column and row of the pixel, counted from the upper left corner, from 0.
    #[arg(long, value_name = "X,Y", value_parser = pixel)]
    pub pixel: [u32; 2],
    #[command(flatten)]
    pub mode: ModeArgs,
    #[command(flatten)]
    pub quality: QualityArgs,
    #[command(flatten)]
    pub view: ViewArgs,
}

#[derive(Args, Debug)]
pub struct CheckArgs {
    /// The unit or pipeline [default: all].
    #[arg(long, value_name = "UNIT", value_parser = unit())]
    pub unit: Option<Top>,
    /// Cycles to run through each, stalls and bubbles included.
    #[arg(long, default_value_t = 10_000, value_name = "N")]
    pub vectors: u64,
    /// Put the Nth of the unit's faults into its netlist first, counted from 0, to see the check fail.
    #[arg(long, value_name = "N", requires = "unit")]
    pub mutate: Option<usize>,
}

#[derive(Args, Debug)]
pub struct ExportArgs {
    /// The folder to write; one that this command made before is written anew.
    #[arg(long, value_name = "DIR")]
    pub out: PathBuf,
    /// The number format of the modules.
    #[arg(long, default_value = "binary32", value_name = "FORMAT", value_parser = format())]
    pub format: StandardFormat,
    /// The unit or pipeline [default: all].
    #[arg(long, value_name = "UNIT", value_parser = unit())]
    pub unit: Option<Top>,
    /// Cycles in each testbench.
    #[arg(long, default_value_t = 1_000, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    pub vectors: u32,
    /// Clock period of the timing constraint in nanoseconds.
    #[arg(long, default_value_t = 1.0, value_name = "NS")]
    pub period_ns: f64,
}

#[derive(Args, Debug)]
pub struct WaveArgs {
    /// The unit or pipeline; single units show what they are given inside the dual-split pipeline.
    #[arg(long, value_name = "UNIT", value_parser = unit())]
    pub unit: Top,
    /// A built-in scene (see `dualsplit scenes`) or an OBJ file, which may be xz-compressed.
    #[arg(long)]
    pub scene: String,
    #[command(flatten)]
    pub detail: DetailArgs,
    /// Number of rays, from the camera towards vertices spread over the mesh.
    #[arg(long, default_value_t = 4, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1024))]
    pub rays: u32,
    #[command(flatten)]
    pub mode: ModeArgs,
    #[command(flatten)]
    pub quality: QualityArgs,
    /// The waveform, a VCD file.
    #[arg(long, value_name = "FILE")]
    pub out: PathBuf,
}

#[derive(Args, Debug)]
pub struct ReproduceArgs {
    /// smoke: minute scenes and pictures, seconds; quick: small ones, under two minutes on two cores.
    #[arg(long, default_value = "quick", value_parser = ["smoke", "quick"])]
    pub preset: String,
    /// The folder to write; one that this command made before is written anew.
    #[arg(long, default_value = "out", value_name = "DIR")]
    pub out: PathBuf,
    #[command(flatten)]
    pub mode: ModeArgs,
}

impl Default for ReproduceArgs {
    fn default() -> Self {
        Self { preset: "quick".to_owned(), out: "out".into(), mode: ModeArgs { mode: Mode::default() } }
    }
}

/// Accepts the names of `all`.
fn one_of<T: Copy + Send + Sync + 'static, const N: usize>(
    all: [T; N],
    name: fn(T) -> &'static str,
) -> impl TypedValueParser<Value = T> {
    PossibleValuesParser::new(all.map(name))
        .map(move |chosen| all.into_iter().find(|x| name(*x) == chosen).expect("a possible value"))
}

fn unit() -> impl TypedValueParser<Value = Top> {
    PossibleValuesParser::new(Top::ALL.iter().map(|top| top.name()))
        .map(|chosen| chosen.parse().expect("a possible value"))
}

fn format() -> impl TypedValueParser<Value = StandardFormat> {
    PossibleValuesParser::new(StandardFormat::ALL.iter().map(|format| format.name()))
        .map(|chosen| chosen.parse().expect("a possible value"))
}

fn structure() -> impl TypedValueParser<Value = StructureKind> {
    one_of(StructureKind::ALL, StructureKind::name)
}

fn test() -> impl TypedValueParser<Value = Test> {
    one_of(Test::ALL, Test::name)
}

fn mode() -> impl TypedValueParser<Value = Mode> {
    one_of([Mode::Fast, Mode::Robust], Mode::name)
}

fn quantity() -> impl TypedValueParser<Value = Quantity> {
    one_of(Quantity::ALL, Quantity::name)
}

fn quality() -> impl TypedValueParser<Value = Quality> {
    one_of([Quality::Fast, Quality::Medium, Quality::High], quality_name)
}

/// The preset's name on the command line and in result files.
pub fn quality_name(quality: Quality) -> &'static str {
    match quality {
        Quality::Fast => "fast",
        Quality::Medium => "medium",
        Quality::High => "high",
    }
}

fn vector(text: &str) -> Result<[f32; 3], String> {
    let parsed: Result<Vec<f32>, _> = text.split(',').map(|part| part.trim().parse()).collect();
    match parsed.map(<[f32; 3]>::try_from) {
        Ok(Ok(vector)) if vector.iter().all(|x| x.is_finite()) => Ok(vector),
        _ => Err("write three finite numbers separated by commas, such as 1,2.5,-3".to_owned()),
    }
}

fn size(text: &str) -> Result<[u32; 2], String> {
    integers(text, 'x').ok_or_else(|| "write WIDTHxHEIGHT in pixels, such as 512x384".to_owned())
}

fn pixel(text: &str) -> Result<[u32; 2], String> {
    integers(text, ',').ok_or_else(|| "write COLUMN,ROW counted from 0, such as 200,120".to_owned())
}

fn integers(text: &str, separator: char) -> Option<[u32; 2]> {
    let (first, second) = text.split_once(separator)?;
    Some([first.trim().parse().ok()?, second.trim().parse().ok()?])
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::CommandFactory;

    #[test]
    fn the_command_line_is_consistent() {
        Cli::command().debug_assert();
    }

    #[test]
    fn vectors_and_pairs() {
        assert_eq!(vector("1, -2.5,3e2"), Ok([1.0, -2.5, 300.0]));
        for bad in ["", "1,2", "1,2,3,4", "1,2,x", "1,2,nan", "1,2,inf"] {
            assert!(vector(bad).is_err(), "{bad}");
        }
        assert_eq!(size("64x32"), Ok([64, 32]));
        assert_eq!(pixel("0,7"), Ok([0, 7]));
        for bad in ["64", "64x", "-1x2", "64,32"] {
            assert!(size(bad).is_err(), "{bad}");
        }
    }
}
