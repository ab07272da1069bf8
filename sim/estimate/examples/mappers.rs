//! Maps a unit by our mapper and by ABC for five clocks, and prints both areas of logic as a Markdown table.
//!
//! `cargo run --release -p dualsplit-estimate --example mappers -- fp_add LIBERTY...`

use estimate::Mappings;
use gates::liberty::load;
use pipelines::catalogue::Top;
use std::error::Error;
use std::path::PathBuf;

/// The clocks, in multiples of the shortest one that our mapper reaches.
const CLOCKS: [f64; 5] = [1.0, 1.1, 1.25, 1.5, 2.0];

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args_os().skip(1);
    let top: Top = arguments.next().ok_or("name a unit, such as fp_add")?.to_string_lossy().parse()?;
    let liberty: Vec<PathBuf> = arguments.map(PathBuf::from).collect();
    if liberty.is_empty() {
        return Err("name the liberty files of a library".into());
    }
    let library = load(&liberty)?;
    let mappings = Mappings::new(top, &library)?;
    let shortest_ns = mappings.within(0.0)?.timing.critical_path_ns;
    let clocks_ns = CLOCKS.map(|multiple| multiple * shortest_ns);
    let folder = tempfile::tempdir()?;
    let fastest_first: Vec<f64> = [0.0].into_iter().chain(clocks_ns).collect();
    let by_abc = mappings.by_abc(&fastest_first, &liberty, folder.path())?;
    println!("| clock, ns | um2 logic, ours | our recipe | um2 logic, ABC | its script | ours over ABC's |");
    println!("|--:|--:|---|--:|---|--:|");
    for (clock_ns, abc) in clocks_ns.into_iter().zip(&by_abc[1..]) {
        let own = mappings.within(clock_ns)?;
        let (ours, theirs) = (own.logic_um2(), abc.logic_um2());
        println!(
            "| {clock_ns:.3} | {ours:.0} | {} | {theirs:.0} | {} | {:.3} |",
            own.recipe,
            abc.recipe,
            ours / theirs
        );
    }
    let fastest = &by_abc[0];
    println!("\nABC's fastest: {:.3} ns, {:.0} um2", fastest.timing.critical_path_ns, fastest.logic_um2());
    Ok(())
}
