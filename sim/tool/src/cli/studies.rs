//! Arguments of the commands that simulate, chart, stress and study.

use super::examples::{FIDELITY, PRECISION};
use super::shared::{CostArgs, LoadArgs, MachineArgs, ModeArgs, QualityArgs, SceneArgs};
use super::values::{factor, fraction, machine_structure, not_negative, one_of, size, structure, test};
use clap::{Args, Subcommand};
use golden::Mode;
use golden::precision::Variant;
use golden::structure::StructureKind;
use machine::frame::MachineStructure;
use render::Test;
use std::ffi::OsString;
use std::path::PathBuf;
use studies::simulate::Fidelity;
use studies::stress::Method;

#[derive(Args, Debug)]
pub struct ChartArgs {
    #[command(subcommand)]
    pub chart: ChartKind,
}

#[derive(Debug, Subcommand)]
pub enum ChartKind {
    /// Visits, lost hits and image error in every format, rounded naively and conservatively: CSV and SVG.
    #[command(after_help = PRECISION)]
    Precision(PrecisionArgs),
    /// The host's time against the error in frame time and energy, over levels and samples of the simulation: CSV and SVG.
    #[command(after_help = FIDELITY)]
    Fidelity(FidelityArgs),
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
    /// Leave out formats with more than this many times the node visits of binary32: with too few bits, every ray visits all nodes.
    #[arg(long, default_value_t = 64.0, value_name = "FACTOR", value_parser = factor)]
    pub most_visits: f64,
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
pub struct FidelityArgs {
    #[command(flatten)]
    pub scene: SceneArgs,
    /// The structure, with its program and its pipeline: dst-sw decodes in software, + is parallel pipelines.
    #[arg(long, default_value = "dst", value_parser = machine_structure())]
    pub structure: MachineStructure,
    /// raycast: primary and shadow rays; path: path tracing with 5 diffuse bounces.
    #[arg(long, default_value = "path", value_parser = test())]
    pub test: Test,
    #[command(flatten)]
    pub quality: QualityArgs,
    /// Width and height of the image in pixels.
    #[arg(long, default_value = "96x96", value_name = "WxH", value_parser = size)]
    pub size: [u32; 2],
    /// Number of samples of each size; the chart shows their mean error and its spread.
    #[arg(long, default_value_t = 3, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1000))]
    pub repeats: u32,
    /// Also simulate with every pipeline operation executed by its netlist, which takes several times as long.
    #[arg(long, default_value_t = true, action = clap::ArgAction::Set, value_name = "BOOL")]
    pub rtl: bool,
    #[command(flatten)]
    pub machine: MachineArgs,
    /// The folder to write; one that this command made before is written anew [default: fidelity-SCENE].
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
}

/// The most rays that a case or a search keeps in memory.
const MOST_RAYS: u64 = 1_000_000;

#[derive(Args, Debug)]
pub struct StressArgs {
    /// The most rays of each known case; interpreted netlists get a fiftieth.
    #[arg(long, default_value_t = 200, value_name = "N", value_parser = clap::value_parser!(u64).range(1..=MOST_RAYS))]
    pub rays: u64,
    /// Number of rays aimed at corners, edges and faces of four meshes; interpreted netlists get 16 of each 16,384.
    #[arg(long, default_value_t = 20_000, value_name = "N", value_parser = clap::value_parser!(u64).range(4..))]
    pub aimed: u64,
    /// Number of rays per method and mesh that a search walks towards the worst case; 0 for no search.
    #[arg(long, default_value_t = 8, value_name = "N", value_parser = clap::value_parser!(u64).range(..=MOST_RAYS))]
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
    /// Rounding of traversal. conservative: to bounds, never loses a hit, visits more nodes; naive: to nearest.
    #[arg(long, default_value = "conservative", value_parser = one_of(Variant::ALL, Variant::name))]
    pub variant: Variant,
    /// The greatest root mean square error of linear radiance against binary32.
    #[arg(long, default_value_t = 0.0, value_name = "RMSE", value_parser = not_negative)]
    pub max_image_error: f64,
    /// The greatest number of rays that lose their hit.
    #[arg(long, default_value_t = 0, value_name = "N")]
    pub max_false_miss: u64,
    /// The greatest number of node visits beyond those of binary32, as a fraction of the latter.
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

/// The options of `simulate` that say which frame is simulated, and how. Other jobs of the command have no use for them.
const FRAME: [&str; 14] = [
    "detail",
    "format",
    "structure",
    "kernel",
    "allow_difference",
    "test",
    "mode",
    "quality",
    "size",
    "pipeline_cost",
    "fidelity",
    "sample",
    "tolerance",
    "csv",
];

#[derive(Args, Debug)]
#[command(group(clap::ArgGroup::new("job").required(true).args(["scene", "validate", "dump_config", "dump_kernels"])))]
pub struct SimulateArgs {
    /// A built-in scene (see `dualsplit scenes`), a file (OBJ, PLY, STL or glTF, which xz or gzip may compress), or - for
    /// standard input.
    pub scene: Option<OsString>,
    #[command(flatten)]
    pub load: LoadArgs,
    /// The structure, with its program and its pipeline: dst-sw decodes in software, + is parallel pipelines.
    #[arg(long, default_value = "dst", value_parser = machine_structure())]
    pub structure: MachineStructure,
    /// A program in the place of the structure's: a listing (.s), or a program in C (.c), which clang-14 (the variable CLANG
    /// names another) compiles. --dump-kernels writes the header, the sources and an example.
    #[arg(long, value_name = "FILE")]
    pub kernel: Option<PathBuf>,
    /// Time such a program although its picture is not golden's, and count the pixels that differ.
    #[arg(long, requires = "kernel")]
    pub allow_difference: bool,
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
    #[command(flatten)]
    pub cost: CostArgs,
    /// analytic: a lower bound from the work; queueing: an estimate by caches and queueing theory; transaction: the machine is
    /// simulated; rtl: in addition, netlists execute every pipeline operation; auto: the cheapest level and sample within
    /// --tolerance.
    #[arg(long, default_value = "transaction", value_name = "LEVEL", hide_possible_values = true,
        value_parser = one_of(Fidelity::ALL, Fidelity::name))]
    pub fidelity: Fidelity,
    /// Time only this share of the frame, drawn at random by --seed, and estimate the rest [default: all of it].
    #[arg(long, value_name = "FRACTION", value_parser = fraction)]
    pub sample: Option<f64>,
    /// For auto: how far the 95 % intervals of frame time and energy may reach to either side of the value [default: 2%].
    #[arg(long, value_name = "PERCENT", value_parser = fraction)]
    pub tolerance: Option<f64>,
    /// Also write the results as CSV: quantity, value, unit, meaning.
    #[arg(long, value_name = "FILE")]
    pub csv: Option<PathBuf>,
    /// Repeat the reference runs of a folder with the preset simtrax-reference, and compare the results; exit code 1 if a
    /// quantity is not within its tolerance.
    #[arg(long, value_name = "DIR", conflicts_with_all = FRAME, conflicts_with_all = ["machine", "settings"])]
    pub validate: Option<PathBuf>,
    /// Only the runs of a set of rays, of one of its variants, or with so many multiprocessors; may be repeated.
    #[arg(long, value_name = "SET[/VARIANT[/TMS]]", conflicts_with_all = ["scene", "dump_config", "dump_kernels"])]
    pub row: Vec<String>,
    /// Print the machine as a TOML file.
    #[arg(long, conflicts_with_all = FRAME)]
    pub dump_config: bool,
    /// Write the header, sources and listings of the programs and an example to a folder, for programs of your own.
    #[arg(long, value_name = "DIR", conflicts_with_all = FRAME, conflicts_with_all = ["machine", "settings"])]
    pub dump_kernels: Option<PathBuf>,
}

#[derive(Args, Debug)]
pub struct StudyArgs {
    /// small: a fiftieth of the triangles, 24x24 pixels, 4 multiprocessors; quick: the same with 64x64 pixels, takes minutes;
    /// medium: a quarter of the triangles, 128x128 pixels, 32 multiprocessors, takes half an hour; paper: all triangles,
    /// 256x256 pixels, takes hours.
    #[arg(long, default_value = "quick", value_parser = ["small", "quick", "medium", "paper"])]
    pub preset: String,
    /// Simulate only this scene. Runs accumulate in the folder, so a study can be done in parts.
    #[arg(long, value_name = "SCENE")]
    pub scene: Option<String>,
    /// The folder to write; runs that it already holds are not repeated.
    #[arg(long, default_value = "study", value_name = "DIR")]
    pub out: PathBuf,
    /// Judge the paper's claims on many machines instead, by estimates: each key of the machine is varied over a range, on 8
    /// multiprocessors. Writes the folder `sensitivity` in the folder.
    #[arg(long)]
    pub sensitivity: bool,
    /// Machines of --sensitivity, from 8 to 1024.
    #[arg(long, default_value_t = 48, value_name = "N", requires = "sensitivity", value_parser = clap::value_parser!(u32).range(8..=1024))]
    pub machines: u32,
    /// Machines of --sensitivity that are simulated as well, from the fastest to the slowest.
    #[arg(long, default_value_t = 2, value_name = "N", requires = "sensitivity", value_parser = clap::value_parser!(u32).range(0..=1024))]
    pub confirm: u32,
    #[command(flatten)]
    pub quality: QualityArgs,
    #[command(flatten)]
    pub machine: MachineArgs,
    #[command(flatten)]
    pub cost: CostArgs,
}

#[derive(Args, Debug)]
pub struct ReproduceArgs {
    /// smoke: tiny scenes and pictures, takes seconds; quick: small ones, takes less than five minutes on two cores; paper:
    /// everything at full size, takes many hours. An interrupted job continues where it stopped.
    #[arg(long, default_value = "quick", value_parser = ["smoke", "quick", "paper"])]
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
