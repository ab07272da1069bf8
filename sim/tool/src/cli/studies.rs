//! The machine, and what is charted, stressed and studied.

use super::shared::{LoadArgs, MachineArgs, ModeArgs, QualityArgs, SceneArgs};
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
    Precision(PrecisionArgs),
    /// The host's time against the error in frame time and energy, over levels and samples of the simulation: CSV and SVG.
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
    /// Leave out formats that visit more than this many times the nodes of binary32: with too few bits all rays visit everything.
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
    /// Samples of each size, of which the mean error and its spread are shown.
    #[arg(long, default_value_t = 3, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1000))]
    pub repeats: u32,
    /// The whole frame with every pipeline operation executed by its netlist, too: several times as long as the machine.
    #[arg(long, default_value_t = true, action = clap::ArgAction::Set, value_name = "BOOL")]
    pub rtl: bool,
    #[command(flatten)]
    pub machine: MachineArgs,
    /// The folder to write; one that this command made before is written anew [default: fidelity-SCENE].
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
    #[arg(long, value_name = "FILE", requires = "scene", conflicts_with_all = ["validate", "dump_config", "dump_kernels"])]
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
    /// analytic: a bound from the work; transaction: the machine; rtl: the same with every pipeline operation executed by
    /// its netlist; auto: no more than --tolerance asks for.
    #[arg(long, default_value = "transaction", value_name = "LEVEL", hide_possible_values = true,
        value_parser = one_of(Fidelity::ALL, Fidelity::name))]
    pub fidelity: Fidelity,
    /// Time only this share of the frame, drawn at random by --seed, and estimate the rest [default: all of it].
    #[arg(long, value_name = "FRACTION", value_parser = fraction)]
    pub sample: Option<f64>,
    /// For auto: greatest distance of the ends of the 95 % intervals of frame time and energy from their values [default: 2%].
    #[arg(long, value_name = "PERCENT", value_parser = fraction)]
    pub tolerance: Option<f64>,
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
    /// Write the header, sources and listings of the programs and an example to a folder, for programs of your own.
    #[arg(long, value_name = "DIR")]
    pub dump_kernels: Option<PathBuf>,
}

#[derive(Args, Debug)]
pub struct StudyArgs {
    /// small: scenes of a fiftieth, 32x32 pixels, 4 multiprocessors; quick: the same with 64x64 pixels, minutes; medium: scenes
    /// of a quarter, 128x128 pixels, 32 multiprocessors, half an hour; paper: full-size scenes, 256x256 pixels, hours.
    #[arg(long, default_value = "quick", value_parser = ["small", "quick", "medium", "paper"])]
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
    /// smoke: minute scenes and pictures, seconds; quick: small ones, under five minutes on two cores; paper: everything at
    /// full size, many hours. An interrupted job goes on where it was.
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
