//! The examples in the help of every command.

/// Words around the commands in the tool's own help.
pub const MANUAL: &str = "\
Scenes:
  A scene is a built-in one (`dualsplit scenes` lists them), a file of triangles (OBJ, PLY, STL or glTF, plain or compressed with xz
  or gzip), or - for standard input. A file NAME.view.toml beside the file NAME.obj is its camera.

Results:
  Commands print tables, or one document with --json, and write files only where an option names them. A command replaces no file
  that it did not make, but with --force, and none that it reads. Folders of results hold rerun.json, from which
  `dualsplit rerun DIR` makes them again. The results depend on options and --seed alone, not on threads or host.

Exit codes:
  0 done, 1 a check found a difference, 2 bad input or usage, 130 ended by a signal.

Examples:
  dualsplit tree atrium                              structures over a built-in scene: sizes and costs
  dualsplit render my.obj --out my.png               a picture of your own scene
  dualsplit simulate my.obj --structure bvh2         how long the machine takes for it, with what energy
  dualsplit explain my.obj --pixel 200,120           what one ray does, step by step
  dualsplit                                          all results on one page, out/report/index.html";

pub const SCENES: &str = "\
Examples:
  dualsplit scenes
  dualsplit scenes hairball --detail 0.01 --export hair.ply.gz";

pub const TREE: &str = "\
Examples:
  dualsplit tree courtyard --detail 0.01 --scratch
  dualsplit tree bunny.obj.xz --structure dst_scratch --save bunny.tree";

pub const TRACE: &str = "\
Examples:
  dualsplit render atrium --out atrium.png --rays atrium.rays.xz
  dualsplit trace atrium --rays atrium.rays.xz --out atrium.hits";

pub const RENDER: &str = "\
Examples:
  dualsplit render atrium --test path --size 512x512 --spp 64 --out atrium.png
  dualsplit render bunny.obj --eye 0,0.1,0.3 --target 0,0.1,0 --out bunny.exr
  dualsplit render statue --heatmap plane-tests --out planes.png";

pub const COMPARE: &str = "\
Examples:
  dualsplit compare dst.png bvh2.png --out difference.png";

pub const EXPLAIN: &str = "\
Examples:
  dualsplit explain statue --pixel 256,256
  dualsplit explain my.obj --pixel 0,0 --structure bvh4 --structure dst";

pub const CHECK: &str = "\
Examples:
  dualsplit check
  dualsplit check --unit fp_add --mutate 7
  dualsplit check --exhaustive binary16 mul
  dualsplit check --prove --unit dual_split";

pub const EXPORT: &str = "\
Examples:
  dualsplit export --out rtl --unit dual_split
  dualsplit export --out rtl16 --format binary16";

pub const WAVE: &str = "\
Examples:
  dualsplit wave --unit dual_split --scene hairball --rays 4 --out rays.vcd";

pub const CHART: &str = "\
Examples:
  dualsplit chart precision courtyard --detail 0.01 --size 64x64
  dualsplit chart fidelity courtyard --set chip.l2_partitions=1 --set chip.tms_per_partition=4";

pub const PRECISION: &str = "\
Examples:
  dualsplit chart precision my.obj --size 32x32 --simulate false --out precision";

pub const FIDELITY: &str = "\
Examples:
  dualsplit chart fidelity atrium --structure bvh4 --repeats 5 --rtl false";

pub const STRESS: &str = "\
Examples:
  dualsplit stress --method dst/bfloat16-naive --method dst/bfloat16-conservative";

pub const NEEDS: &str = "\
Examples:
  dualsplit needs courtyard --detail 0.01
  dualsplit simulate courtyard --detail 0.01 --machine needs-courtyard/needs.toml";

pub const ESTIMATE: &str = "\
Examples:
  dualsplit estimate --detail 0.01
  dualsplit estimate --liberty sg13g2_stdcell_typ_1p20V_25C.lib.gz --out estimate";

pub const SIMULATE: &str = "\
Examples:
  dualsplit simulate atrium --detail 0.05 --size 64x64 --structure bvh2 --set l1.size=64KiB
  dualsplit simulate hairball --fidelity auto --tolerance 2%
  dualsplit simulate --dump-config
  dualsplit simulate atrium --kernel own.c";

pub const STUDY: &str = "\
Examples:
  dualsplit study --preset quick --out study
  dualsplit study --sensitivity --machines 96";

pub const SWEEP: &str = "\
The file has lists, and the runs are their product:

  scenes = [\"atrium\", \"my.obj\"]
  structures = [\"dst\", \"bvh2\"]
  machines = [\"trax\"]                 # default; presets or files beside this one
  seeds = [0, 1]                      # default 0; also: detail, tests, sizes, and quality, level, pipeline_cost
  [set]
  l1.size = [\"16KiB\", \"32KiB\"]        # any key of --set

Examples:
  dualsplit sweep caches.toml --dry-run
  dualsplit sweep caches.toml --shard 1/4
  dualsplit sweep caches.toml --merge other-host/sweep-caches
  dualsplit sweep caches.toml --workflow snakemake";

pub const RERUN: &str = "\
Examples:
  dualsplit rerun needs-atrium";

pub const REPRODUCE: &str = "\
Examples:
  dualsplit reproduce --preset smoke --out smoke";

pub const MANUAL_FILES: &str = "\
Examples:
  dualsplit manual manual";
