//! `dualsplit render`: pictures, heat maps and ray streams.

use super::work::{ClassRow, class_table};
use crate::cli::{Global, RenderArgs};
use crate::console::{Report, progress};
use crate::input::{self, check_writable, display};
use anyhow::ensure;
use base::output::write_file;
use render::ray_file::write_rays;
use render::{RenderOptions, render};
use serde::Serialize;
use std::time::Instant;
use view::picture::heatmap::{self, Quantity};
use view::picture::{Format, exr, max_radiance, png};

#[derive(Serialize)]
struct Document {
    scene: String,
    triangles: usize,
    structure: &'static str,
    test: &'static str,
    mode: &'static str,
    /// Absent for a structure that was loaded.
    #[serde(skip_serializing_if = "Option::is_none")]
    quality: Option<&'static str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    tree: Option<String>,
    width: u32,
    height: u32,
    spp: u32,
    seed: u64,
    rays: u64,
    hits: u64,
    seconds: f64,
    /// The largest value of what is drawn, `max_of`: the heat map's quantity, or the radiance of a channel.
    max: f64,
    max_of: &'static str,
    /// The largest work of any pixel, if work was counted.
    #[serde(skip_serializing_if = "Option::is_none")]
    maxima: Option<Maxima>,
    classes: Vec<ClassRow>,
    out: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    rays_out: Option<String>,
}

#[derive(Serialize)]
struct Maxima {
    node_visits: u32,
    plane_tests: u32,
    triangle_tests: u32,
    stack_depth: u32,
}

pub fn run(args: &RenderArgs, global: &Global) -> anyhow::Result<Report> {
    let format = Format::of(&args.out)?;
    ensure!(
        args.heatmap.is_none() || format == Format::Png,
        "--out {}: a heat map is a .png; an .exr holds all counters as layers without --heatmap",
        args.out.display()
    );
    ensure!(args.exposure.is_finite(), "--exposure {}: give a finite number of stops", args.exposure);
    check_writable("--out", &args.out, global.force)?;
    if let Some(rays) = &args.rays {
        check_writable("--rays", rays, global.force)?;
    }
    let [width, height] = args.view.size;
    let options = RenderOptions {
        samples: args.spp,
        seed: global.seed,
        mode: args.mode.mode,
        count_work: args.heatmap.is_some() || format == Format::Exr,
        keep_rays: args.rays.is_some(),
        ..RenderOptions::new(args.test, width, height)
    };
    let mut scene = input::scene(&args.scene, global)?;
    input::set_view(&mut scene, &args.view)?;
    let (structure, quality) = input::structure(&scene, &args.structure)?;

    let bar = progress(u64::from(height), format!("rendering {}", scene.name));
    let start = Instant::now();
    let rendering = render(&structure, &scene, &options, |rows| bar.inc(rows))?;
    let seconds = start.elapsed().as_secs_f64();
    bar.finish_and_clear();

    let bytes = match (format, args.heatmap) {
        (Format::Png, None) => png::encode(&png::develop(&rendering, args.exposure)),
        (Format::Png, Some(quantity)) => {
            png::encode(&heatmap::of_rendering(&rendering, quantity, args.heatmap_max))
        }
        (Format::Exr, _) => exr::encode(&rendering),
    };
    write_file(&args.out, global.force, |out| out.write_all(&bytes))?;
    if let (Some(path), Some(stream)) = (&args.rays, &rendering.rays) {
        write_rays(path, stream, global.force)?;
    }

    let (max, max_of) = match args.heatmap {
        Some(quantity) => (f64::from(quantity.max(&rendering)), quantity.name()),
        None => (f64::from(max_radiance(&rendering)), "radiance"),
    };
    let total = rendering.total();
    let document = Document {
        scene: scene.name,
        triangles: scene.mesh.triangles.len(),
        structure: structure.kind().name(),
        test: args.test.name(),
        mode: args.mode.mode.name(),
        quality,
        tree: args.structure.tree.as_deref().map(display),
        width,
        height,
        spp: args.spp,
        seed: global.seed,
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
        out: display(&args.out),
        rays_out: args.rays.as_deref().map(display),
    };
    let text = text(&document);
    Ok(Report::new(&document, text))
}

fn text(document: &Document) -> String {
    let d = document;
    let mut text = format!(
        "{}: {} triangles, {} test through {}, {} mode, {}x{} with {} sample(s) per pixel\n\
         {} rays in {:.2} s; max {}: {}\n\n",
        d.scene,
        d.triangles,
        d.test,
        d.structure,
        d.mode,
        d.width,
        d.height,
        d.spp,
        d.rays,
        d.seconds,
        d.max_of,
        d.max
    );
    text += &class_table(&d.classes);
    text
}
