//! A scene rendered to a file: a picture, a heat map of the work that rendering takes, or all counters as layers.

use crate::input::{SceneSource, StructureSource, View, check_outputs, display};
use crate::progress::{Part, Progress};
use crate::work::ClassRow;
use anyhow::ensure;
use base::output::write_file;
use golden::Mode;
use render::ray_file::write_rays;
use render::{RenderOptions, Test, render};
use serde::Serialize;
use std::path::PathBuf;
use std::time::Instant;
use view::picture::heatmap::{self, Quantity};
use view::picture::{Format, exr, max_radiance, png};

/// The picture to render, and the files for picture and rays.
#[derive(Clone, Debug)]
pub struct Options {
    /// The scene.
    pub scene: SceneSource,
    /// The structure that rays are traced through.
    pub structure: StructureSource,
    /// The test: primary and shadow rays, or paths.
    pub test: Test,
    /// How plane distances are rounded.
    pub mode: Mode,
    /// Camera and light.
    pub view: View,
    /// Width and height in pixels.
    pub size: [u32; 2],
    /// Samples per pixel.
    pub samples: u32,
    /// Seed of the samples.
    pub seed: u64,
    /// Brightness of a PNG in factors of two.
    pub exposure: f32,
    /// The quantity of a heat map, which is drawn instead of the picture.
    pub heatmap: Option<Quantity>,
    /// Value at the end of the heat map's scale; if absent, the largest value of the heat map.
    pub heatmap_max: Option<u32>,
    /// The file of the picture: `.png` (sRGB) or `.exr` (linear, with depth, normal, triangle and the counters as layers).
    pub out: PathBuf,
    /// The file that the traced rays are written to.
    pub rays: Option<PathBuf>,
    /// Replaces files that exist.
    pub force: bool,
}

/// Facts about a rendered picture.
#[derive(Debug, Serialize)]
#[allow(missing_docs, reason = "keys of result files")]
pub struct Picture {
    pub scene: String,
    pub triangles: usize,
    pub structure: &'static str,
    pub test: &'static str,
    pub mode: &'static str,
    /// How the structure was built; absent for a structure from a file.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub quality: Option<&'static str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tree: Option<String>,
    pub width: u32,
    pub height: u32,
    pub spp: u32,
    pub seed: u64,
    pub rays: u64,
    pub hits: u64,
    pub seconds: f64,
    /// The largest value of the quantity that `max_of` names: that of the heat map, or the radiance of a channel.
    pub max: f64,
    pub max_of: &'static str,
    /// The largest counters of any pixel, if work was counted.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub maxima: Option<Maxima>,
    pub classes: Vec<ClassRow>,
}

/// The largest counters of any pixel.
#[derive(Debug, Serialize)]
#[allow(missing_docs, reason = "keys of result files")]
pub struct Maxima {
    pub node_visits: u32,
    pub plane_tests: u32,
    pub triangle_tests: u32,
    pub stack_depth: u32,
}

/// Renders the picture and writes it.
///
/// # Errors
/// The options contradict each other, the scene or the structure cannot be loaded, or a file cannot be written.
pub fn run(o: &Options, progress: &dyn Progress) -> anyhow::Result<Picture> {
    let format = Format::of(&o.out)?;
    ensure!(
        o.heatmap.is_none() || format == Format::Png,
        "--out {}: a heat map is a .png; an .exr holds all counters as layers without --heatmap",
        o.out.display()
    );
    ensure!(o.exposure.is_finite(), "--exposure {}: give a finite number of stops", o.exposure);
    ensure!(
        o.exposure == 0.0 || (format == Format::Png && o.heatmap.is_none()),
        "--exposure {}: it changes neither an .exr nor a heat map; leave it away",
        o.exposure
    );
    let outputs = [("--out", Some(o.out.as_path())), ("--rays", o.rays.as_deref())];
    check_outputs(&outputs, o.force)?;
    let [width, height] = o.size;
    let options = RenderOptions {
        samples: o.samples,
        seed: o.seed,
        mode: o.mode,
        count_work: o.heatmap.is_some() || format == Format::Exr,
        keep_rays: o.rays.is_some(),
        ..RenderOptions::new(o.test, width, height)
    };
    let mut scene = o.scene.load(progress)?;
    o.view.apply(&mut scene)?;
    let structure = o.structure.load(&scene, progress)?;

    let part = Part::begin(progress, u64::from(height), &format!("rendering {}", scene.name));
    let start = Instant::now();
    let rendering = render(&structure, &scene, &options, |rows| part.advance(rows))?;
    let seconds = start.elapsed().as_secs_f64();
    drop(part);

    let bytes = match (format, o.heatmap) {
        (Format::Png, None) => png::encode(&png::develop(&rendering, o.exposure)),
        (Format::Png, Some(quantity)) => {
            png::encode(&heatmap::of_rendering(&rendering, quantity, o.heatmap_max))
        }
        (Format::Exr, _) => exr::encode(&rendering),
    };
    write_file(&o.out, o.force, |out| out.write_all(&bytes))?;
    if let (Some(path), Some(stream)) = (&o.rays, &rendering.rays) {
        write_rays(path, stream, o.force)?;
    }

    let (max, max_of) = match o.heatmap {
        Some(quantity) => (f64::from(quantity.max(&rendering)), quantity.name()),
        None => (f64::from(max_radiance(&rendering)), "radiance"),
    };
    let total = rendering.total();
    Ok(Picture {
        scene: scene.name,
        triangles: scene.mesh.triangles.len(),
        structure: structure.kind().name(),
        test: o.test.name(),
        mode: o.mode.name(),
        quality: o.structure.quality_name(),
        tree: o.structure.file.as_deref().map(display),
        width,
        height,
        spp: o.samples,
        seed: o.seed,
        rays: total.rays,
        hits: total.hits,
        seconds,
        max,
        max_of,
        maxima: options.count_work.then(|| Maxima {
            node_visits: Quantity::NodeVisits.max(&rendering),
            plane_tests: Quantity::PlaneTests.max(&rendering),
            triangle_tests: Quantity::TriangleTests.max(&rendering),
            stack_depth: Quantity::StackDepth.max(&rendering),
        }),
        classes: rendering
            .classes()
            .map(|(class, totals)| ClassRow::new(class, totals, options.count_work))
            .collect(),
    })
}
