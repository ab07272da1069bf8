//! `dualsplit needs`: the least hardware that a scene needs within an error budget.

use crate::cli::{Drawn, Global, NeedsArgs};
use crate::console::{Bars, Report, fixed, table};
use studies::needs::memory::DRAM_BYTES_PER_CYCLE;
use studies::needs::study::{self, Needs, Options};

pub fn run(args: &NeedsArgs, global: &Global) -> anyhow::Result<Report> {
    let options = Options {
        scene: args.scene.source(Drawn::Samples, global)?,
        test: args.test,
        variant: args.variant,
        max_image_error: args.max_image_error,
        max_false_miss: args.max_false_miss,
        max_extra_visits: args.max_extra_visits,
        quality: args.quality.quality,
        size: args.size,
        out: args.out.clone(),
        force: global.force,
    };
    let needs = study::run(&options, &Bars::new(global.quiet))?;
    Ok(Report::new(&needs, text(&needs), needs.artifacts.clone()).in_folder(needs.folder.clone()))
}

fn text(d: &Needs) -> String {
    let mut text = format!(
        "{}: {} triangles, {}, {} rays; image error at most {}, false misses at most {}, visits at most {} % more than in \
         binary32\n\n",
        d.scene,
        d.triangles,
        d.test,
        d.rays,
        d.max_image_error,
        d.max_false_miss,
        fixed(100.0 * d.max_extra_visits, 1)
    );
    let row = |name: &str, value: String, why: String| [name.to_owned(), value, why];
    let budget = format!("{}, within the budget", d.variant);
    let tms = d.tms.map(|tms| tms.to_string()).unwrap_or_else(|| "any".to_owned());
    let miss = d.miss_curve.iter().find(|p| p.bytes == d.cache_bytes).map_or(0.0, |p| p.miss_ratio);
    let export = d.export_format.unwrap_or("none");
    text += &table(
        ["need", "value", "why"],
        [
            row("significand bits", d.significand_bits.to_string(), budget.clone()),
            row("exponent bits", d.exponent_bits.to_string(), budget),
            row(
                "format to export",
                export.to_owned(),
                "the narrowest with modules and these bits".to_owned(),
            ),
            row("stack entries", d.stack_entries.to_string(), "the most that any ray stacks".to_owned()),
            row("address bits", d.address_bits.to_string(), "words of the tree, or triangles".to_owned()),
            row("carve levels", d.carve_levels.to_string(), "the longest chain that a ray passes".to_owned()),
            row(
                "cache bytes",
                d.cache_bytes.to_string(),
                format!("knee, {} of accesses miss", fixed(miss, 3)),
            ),
            row(
                "multiprocessors",
                tms,
                format!("until {DRAM_BYTES_PER_CYCLE} bytes a cycle are asked for; {}", d.tms_method),
            ),
        ],
    );
    if !d.beyond_most_visits.is_empty() {
        text += &format!(
            "\nNot in the charts, as they visit more than {} times the nodes of binary32: {}, and narrower ones.\n",
            fixed(d.most_visits, 0),
            d.beyond_most_visits.join(", ")
        );
    }
    text += &format!("\n{}\n", d.artifacts.join(", "));
    text
}
