//! Frames on the machine that docs/machine.md compares.

use super::super::workplace::Workplace;
use super::{count, number, table as markdown};
use anyhow::bail;
use serde_json::Value;

/// The frame: scene, size and chip.
const FRAME: &str = "dualsplit simulate atrium --detail 0.05 --size 64x64 --set chip.l2_partitions=1 --set chip.tms_per_partition=4";

/// The table that `what` names.
pub fn table(what: &[&str], workplace: &mut Workplace<'_>) -> anyhow::Result<String> {
    match what {
        ["alignment"] => alignment(workplace),
        ["kernel"] => {
            workplace.output("dualsplit simulate --dump-kernels own")?;
            kernel(workplace)
        }
        _ => bail!("the machine's tables are alignment and kernel"),
    }
}

/// The frame, simulated with further options.
fn frame(workplace: &mut Workplace<'_>, options: &str) -> anyhow::Result<Value> {
    Ok(serde_json::from_str(&workplace.output(&format!("{FRAME} {options} --json"))?)?)
}

fn cycles(frame: &Value) -> anyhow::Result<f64> {
    number(frame, "cycles")
}

fn mj(frame: &Value) -> anyhow::Result<String> {
    Ok(format!("{:.3}", number(frame, "energy_mj.total")?))
}

/// Frames with nodes at different multiples of bytes.
fn alignment(workplace: &mut Workplace<'_>) -> anyhow::Result<String> {
    let mut row = |structure: &str| -> anyhow::Result<Vec<String>> {
        let mut at = |setting: &str| frame(workplace, format!("--structure {structure} {setting}").trim());
        let [packed, words, lines] =
            [at("")?, at("--set layout.alignment=4B")?, at("--set layout.alignment=64B")?];
        let bytes = |frame: &Value| Ok::<_, anyhow::Error>(count(number(frame, "node_bytes")? as u64));
        let cycles = |frame: &Value| Ok::<_, anyhow::Error>(count(cycles(frame)? as u64));
        Ok(vec![
            structure.to_owned(),
            bytes(&packed)?,
            bytes(&lines)?,
            cycles(&packed)?,
            cycles(&words)?,
            cycles(&lines)?,
            mj(&packed)?,
            mj(&lines)?,
        ])
    };
    let rows =
        ["dst", "bvh2", "bvh4", "bvh8"].into_iter().map(&mut row).collect::<anyhow::Result<Vec<_>>>()?;
    let header = [
        "structure",
        "bytes of nodes, packed",
        "at 64B",
        "cycles, packed",
        "at 4B",
        "at 64B",
        "mJ, packed",
        "at 64B",
    ];
    Ok(markdown(&header, rows))
}

/// Frames by the program of the structure and by the example of a program of one's own.
fn kernel(workplace: &mut Workplace<'_>) -> anyhow::Result<String> {
    let mut row = |structure: &str| -> anyhow::Result<Vec<String>> {
        let shipped = frame(workplace, &format!("--structure {structure}"))?;
        let own = frame(workplace, &format!("--structure {structure} --kernel own/examples/no-t-min.c"))?;
        let change = 100.0 * (cycles(&own)? / cycles(&shipped)? - 1.0);
        Ok(vec![
            structure.to_owned(),
            count(cycles(&shipped)? as u64),
            mj(&shipped)?,
            count(cycles(&own)? as u64),
            mj(&own)?,
            format!("{change:+.1} %"),
        ])
    };
    let rows = ["dst", "dst-sw", "bvh2", "bvh4", "bvh8"]
        .into_iter()
        .map(&mut row)
        .collect::<anyhow::Result<Vec<_>>>()?;
    Ok(markdown(&["structure", "cycles", "mJ", "cycles, `no-t-min.c`", "mJ, `no-t-min.c`", "cycles"], rows))
}
