//! The command line.

use clap::builder::{PossibleValuesParser, TypedValueParser};
use clap::{Args, Parser, Subcommand};
use golden::Mode;
use golden::build::Quality;
use golden::precision::Variant;
use golden::render::Test;
use golden::structure::StructureKind;
use hdl::catalogue::{StandardFormat, Top};
use sim::machine::frame::MachineStructure;
use sim::picture::heatmap::Quantity;
use sim::stress::Method;
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
    /// Build all structures over a scene and print their sizes, costs and histograms; save one to a file.
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
    /// Chart a cost against an error, over formats of the hardware.
    Chart(ChartArgs),
    /// Run every structure and arithmetic against exact answers on inputs made to break them; exit code 1 if a method
    /// that must lose no hit loses one.
    Stress(StressArgs),
    /// Find the least hardware that a scene needs at an error budget, and write it as TOML with a chart of each knee.
    Needs(NeedsArgs),
    /// Estimate area, energy and clock of the pipelines, beside the published figures.
    Estimate(EstimateArgs),
    /// Time a frame on a many-core machine, or the public simulator's reference runs.
    Simulate(SimulateArgs),
    /// The paper's study: all built-in scenes, eight structures, both tests, on the many-core machine.
    Study(StudyArgs),
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
    /// Save a structure to this file, for --tree of other commands.
    #[arg(long, value_name = "FILE")]
    pub save: Option<PathBuf>,
    /// The structure to save; dst_scratch is the dual-split tree with a partition of its own.
    #[arg(long, default_value = "dst", requires = "save", value_parser = row())]
    pub structure: TreeRow,
}

/// A line of the table of trees.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TreeRow {
    /// Converted from the one binary hierarchy.
    Converted(StructureKind),
    /// The dual-split tree of a partition that is made for it.
    DstScratch,
}

impl TreeRow {
    /// All of them, in the order of the table.
    pub const ALL: [Self; StructureKind::ALL.len() + 1] = {
        let mut all = [Self::DstScratch; StructureKind::ALL.len() + 1];
        let mut i = 0;
        while i < StructureKind::ALL.len() {
            all[i] = Self::Converted(StructureKind::ALL[i]);
            i += 1;
        }
        all
    };

    /// The name on the command line and in result files.
    pub fn name(self) -> &'static str {
        match self {
            Self::Converted(kind) => kind.name(),
            Self::DstScratch => "dst_scratch",
        }
    }
}

/// The structure that rays are traced through: built, or loaded from a file.
#[derive(Args, Clone, Debug)]
pub struct StructureArgs {
    /// The structure that rays are traced through; all give the same hits.
    #[arg(long, default_value = "dst", value_parser = structure())]
    pub structure: StructureKind,
    #[command(flatten)]
    pub quality: QualityArgs,
    /// Load the structure from this file, which `dualsplit tree SCENE --save FILE` has written, instead of building it.
    #[arg(long, value_name = "FILE", conflicts_with_all = ["structure", "quality"])]
    pub tree: Option<PathBuf>,
}

#[derive(Args, Debug)]
pub struct TraceArgs {
    #[command(flatten)]
    pub scene: SceneArgs,
    /// The rays to trace, a DSTRAYS1 file.
    #[arg(long, value_name = "FILE")]
    pub rays: PathBuf,
    #[command(flatten)]
    pub structure: StructureArgs,
    #[command(flatten)]
    pub mode: ModeArgs,
    /// Where to write the hits, a DSTHITS1 file.
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
    /// Operations to compare for each, besides stalls and bubbles.
    #[arg(long, default_value_t = 10_000, value_name = "N")]
    pub vectors: u64,
    /// Put the Nth of the unit's faults into its netlist first, counted from 0, to see the check fail.
    #[arg(long, value_name = "N", requires = "unit", conflicts_with_all = ["exhaustive", "prove"])]
    pub mutate: Option<usize>,
    /// Compare all pairs of operands of a format of at most 16 bits instead, in every mode of the unit: add, sub, mul, min,
    /// max, lt, le or eq.
    #[arg(long, num_args = 2, value_names = ["FORMAT", "OP"], conflicts_with_all = ["unit", "vectors", "prove"])]
    pub exhaustive: Option<Vec<String>>,
    /// Where an interrupted exhaustive check continues from [default: check-FORMAT-OP.json]; removed when all is done.
    #[arg(long, value_name = "FILE", requires = "exhaustive")]
    pub state: Option<PathBuf>,
    /// Prove instead, for all inputs and states: units and control against independent references, and the exported
    /// Verilog, read back by yosys if that is installed, against the simulated graph.
    #[arg(long)]
    pub prove: bool,
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
pub struct ChartArgs {
    #[command(subcommand)]
    pub chart: ChartKind,
}

#[derive(Debug, Subcommand)]
pub enum ChartKind {
    /// Visits, lost hits and image error in every format, rounded naively and conservatively: CSV and SVG.
    Precision(PrecisionArgs),
}

#[derive(Args, Debug)]
pub struct PrecisionArgs {
    #[command(flatten)]
    pub scene: SceneArgs,
    /// The structure that rays are traced through.
    #[arg(long, default_value = "dst", value_parser = structure())]
    pub structure: StructureKind,
    /// raycast: primary and shadow rays; path: path tracing with 5 diffuse bounces.
    #[arg(long, default_value = "path", value_parser = test())]
    pub test: Test,
    #[command(flatten)]
    pub quality: QualityArgs,
    /// Width and height of the image in pixels.
    #[arg(long, default_value = "64x64", value_name = "WxH", value_parser = size)]
    pub size: [u32; 2],
    /// Simulate the frame of the dual-split tree in each format on the machine.
    #[arg(long, default_value_t = true, action = clap::ArgAction::Set, value_name = "BOOL")]
    pub simulate: bool,
    #[command(flatten)]
    pub machine: MachineArgs,
    /// The folder to write; one that this command made before is written anew [default: precision-SCENE].
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
}

#[derive(Args, Debug)]
pub struct StressArgs {
    /// Rays of each of the known cases, at most; interpreted netlists get a fiftieth.
    #[arg(long, default_value_t = 200, value_name = "N", value_parser = clap::value_parser!(u64).range(1..))]
    pub rays: u64,
    /// Rays that are aimed at corners, edges and faces of four meshes; interpreted netlists get 16 of each 16,384.
    #[arg(long, default_value_t = 20_000, value_name = "N")]
    pub aimed: u64,
    /// Rays per method and mesh that a search walks towards the worst.
    #[arg(long, default_value_t = 8, value_name = "N")]
    pub searches: u64,
    /// Only this method, such as dst/binary32-robust, bvh2/bfloat16-naive, rtl/binary32-fast; may be repeated.
    #[arg(long, value_name = "METHOD")]
    pub method: Vec<Method>,
    /// Draw the rays around a failure of each kind.
    #[arg(long, default_value_t = true, action = clap::ArgAction::Set, value_name = "BOOL")]
    pub pictures: bool,
    /// The folder to write; one that this command made before is written anew.
    #[arg(long, default_value = "stress", value_name = "DIR")]
    pub out: PathBuf,
}

#[derive(Args, Debug)]
pub struct NeedsArgs {
    #[command(flatten)]
    pub scene: SceneArgs,
    /// raycast: primary and shadow rays; path: path tracing with 5 diffuse bounces.
    #[arg(long, default_value = "path", value_parser = test())]
    pub test: Test,
    /// conservative: never loses a hit, may visit more; naive: everything rounded to nearest.
    #[arg(long, default_value = "conservative", value_parser = one_of(Variant::ALL, Variant::name))]
    pub variant: Variant,
    /// Greatest root mean square error of linear radiance against binary32.
    #[arg(long, default_value_t = 0.0, value_name = "RMSE", value_parser = not_negative)]
    pub max_image_error: f64,
    /// Greatest number of rays that hit nothing and should.
    #[arg(long, default_value_t = 0, value_name = "N")]
    pub max_false_miss: u64,
    /// Node visits beyond those of binary32, as a fraction of them.
    #[arg(long, default_value_t = 0.05, value_name = "FRACTION", value_parser = not_negative)]
    pub max_extra_visits: f64,
    #[command(flatten)]
    pub quality: QualityArgs,
    /// Width and height of the image in pixels.
    #[arg(long, default_value = "48x48", value_name = "WxH", value_parser = size)]
    pub size: [u32; 2],
    /// The folder to write; one that this command made before is written anew [default: needs-SCENE].
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
}

#[derive(Args, Debug)]
pub struct EstimateArgs {
    /// Standard cells to map to: a liberty file, which may be gzip-compressed; several if a library has several
    /// [default: an embedded table].
    #[arg(long, value_name = "FILE")]
    pub liberty: Vec<PathBuf>,
    /// Synthesise the exported Verilog with yosys and ABC too, for minutes, and print both.
    #[arg(long)]
    pub synth: bool,
    /// The scene whose rays make the nets change: a built-in one or an OBJ file, which may be xz-compressed.
    #[arg(long, default_value = "courtyard")]
    pub scene: String,
    #[command(flatten)]
    pub detail: DetailArgs,
    #[command(flatten)]
    pub quality: QualityArgs,
    /// A folder for the report as text, CSV, JSON and HTML; one that this command made before is written anew.
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
}

#[derive(Args, Debug)]
pub struct MachineArgs {
    /// The machine: a preset (trax or simtrax-reference) or a TOML file.
    #[arg(long, default_value = "trax", value_name = "MACHINE")]
    pub machine: String,
    /// Change a key of the machine, such as l1.size=64KiB; may be repeated.
    #[arg(long = "set", value_name = "KEY=VALUE")]
    pub settings: Vec<String>,
}

#[derive(Args, Debug)]
#[command(group(clap::ArgGroup::new("job").required(true).args(["scene", "validate", "dump_config"])))]
pub struct SimulateArgs {
    /// A built-in scene (see `dualsplit scenes`) or an OBJ file, which may be xz-compressed.
    pub scene: Option<String>,
    #[command(flatten)]
    pub detail: DetailArgs,
    /// The structure, with its program and its pipeline: dst-sw decodes in software, + is parallel pipelines.
    #[arg(long, default_value = "dst", value_parser = machine_structure())]
    pub structure: MachineStructure,
    /// raycast: primary and shadow rays; path: path tracing with 5 diffuse bounces.
    #[arg(long, default_value = "path", value_parser = test())]
    pub test: Test,
    #[command(flatten)]
    pub mode: ModeArgs,
    #[command(flatten)]
    pub quality: QualityArgs,
    /// Width and height of the image in pixels.
    #[arg(long, default_value = "128x128", value_name = "WxH", value_parser = size)]
    pub size: [u32; 2],
    #[command(flatten)]
    pub machine: MachineArgs,
    /// Also write the results as CSV: quantity, value, unit, meaning.
    #[arg(long, value_name = "FILE", requires = "scene")]
    pub csv: Option<PathBuf>,
    /// Make the reference runs of a folder, with the preset simtrax-reference, and compare; exit code 1 if a quantity is
    /// not within its tolerance.
    #[arg(long, value_name = "DIR", conflicts_with_all = ["machine", "settings"])]
    pub validate: Option<PathBuf>,
    /// Print the machine as a TOML file.
    #[arg(long)]
    pub dump_config: bool,
}

#[derive(Args, Debug)]
pub struct StudyArgs {
    /// quick: small scenes and images; paper: full-size scenes, 256x256 pixels, 32 multiprocessors, hours.
    #[arg(long, default_value = "quick", value_parser = ["quick", "paper"])]
    pub preset: String,
    /// Only this scene: the runs of a study can be shared out and go on where they were interrupted.
    #[arg(long, value_name = "SCENE")]
    pub scene: Option<String>,
    /// The folder to write; runs that it already holds are not repeated.
    #[arg(long, default_value = "study", value_name = "DIR")]
    pub out: PathBuf,
    #[command(flatten)]
    pub quality: QualityArgs,
    #[command(flatten)]
    pub machine: MachineArgs,
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

fn row() -> impl TypedValueParser<Value = TreeRow> {
    one_of(TreeRow::ALL, TreeRow::name)
}

fn machine_structure() -> impl TypedValueParser<Value = MachineStructure> {
    one_of(MachineStructure::ALL, MachineStructure::name)
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

fn not_negative(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(x) if x >= 0.0 && x.is_finite() => Ok(x),
        _ => Err("write a number that is not negative, such as 0.05".to_owned()),
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
