//! `dualsplit simulate --validate` on a folder of its own: rows that name their settings, sets that are not there.

mod support;

use serde_json::Value;
use std::fs;
use support::Workplace;

/// Word addresses of the only node, which is a leaf, and of its triangle.
const NODES_AT: u32 = 1024;
const TRIANGLES_AT: u32 = NODES_AT + 8;
const RAYS: u32 = 300;

const HEADER: &str = "set,variant,settings,kernel,TMs,cycles,instr,L1_acc,L1_hits,L2_acc,L2_hits,dram_reads,\
                      E_fu,E_l1,E_l2,E_ic,E_ls,E_rf,E_dram,wall_s";

fn bytes(words: impl IntoIterator<Item = u32>) -> Vec<u8> {
    words.into_iter().flat_map(u32::to_le_bytes).collect()
}

/// A folder `runs` with the table `rows`, and a scene of one triangle with a set of rays that hit it.
fn with(rows: &[&str]) -> Workplace {
    let work = Workplace::new();
    fs::create_dir(work.path("runs")).unwrap();
    let write = |name: &str, content: &[u8]| work.write(&format!("runs/{name}"), content);
    let table: Vec<String> =
        rows.iter().map(|row| format!("{row},1,1,1,1,1,1,1,1,1,1,1,1,1,1,1\n")).collect();
    write("reference_runs.csv", format!("{HEADER}\n{}", table.concat()).as_bytes());
    write("counts.csv", b"set,ray_addr,out_addr\nplane_down,2048,8192\nplane_up,2048,8192\n");
    let header = format!(
        "{{\"num_nodes\":1,\"num_tris\":1,\"start_nodes_word\":{NODES_AT},\"start_tris_word\":{TRIANGLES_AT}}}"
    );
    write("plane.bvh.json", header.as_bytes());
    let float = |value: f32| value.to_bits();
    let node = [0.0, 0.0, 1.0, 1.0, 1.0, 1.0].map(float).into_iter().chain([1, TRIANGLES_AT]);
    let corners = [[0.0, 0.0, 1.0], [1.0, 0.0, 1.0], [0.0, 1.0, 1.0]].concat().into_iter().map(float);
    write("plane.bvh", &bytes(node.chain(corners).chain([0, 0])));
    let ray = [0.25, 0.25, 0.0, 0.0, 0.0, 0.0, 1.0, 100.0].map(float);
    write("plane_down.rays", &bytes([ray; RAYS as usize].concat()));
    write("plane_down.hits", &bytes([[float(1.0), 0]; RAYS as usize].concat()));
    work
}

/// The result of a validation, whose rows differ from their made-up reference.
fn validated(work: &Workplace, line: &str) -> Value {
    let output = work.run(&format!("simulate --validate runs {line} --json"));
    assert_eq!(output.status.code(), Some(1), "{line}: {}", String::from_utf8_lossy(&output.stderr));
    serde_json::from_slice(&output.stdout).unwrap()
}

#[test]
fn rows_say_what_differs() {
    let work = with(&[
        "plane_down,,,closest,1",
        "plane_down,slow,tm.threads=2 l1.latency_cycles=9,anyhit,1",
        "plane_down,1TP,,closest,1",
        "plane_down,,,closest,2",
        "plane_up,,,closest,1",
        "hall_up,,,closest,1",
    ]);
    let all = validated(&work, "");
    let runs = all["runs"].as_array().unwrap();
    let cycles: Vec<u64> = runs.iter().map(|run| run["cycles"].as_u64().unwrap()).collect();
    let [main, slow, one, two] = cycles[..] else { panic!("four rows can be run: {cycles:?}") };
    assert!(main * 4 < slow && slow < one && two < main, "{cycles:?}");
    assert!(runs.iter().all(|run| run["result_mismatches"] == 0 && run["within"] == false), "{runs:?}");
    assert_eq!(runs[1]["settings"], serde_json::json!(["tm.threads=2", "l1.latency_cycles=9"]));
    assert_eq!(runs[2]["settings"], serde_json::json!(["tm.threads=1"]));
    assert_eq!(runs[3]["settings"], serde_json::json!([]));
    let absent = all["absent"].as_array().unwrap();
    let reasons: Vec<&str> = absent.iter().map(|run| run["reason"].as_str().unwrap()).collect();
    assert!(reasons[0].contains("plane_up.rays is missing"), "{reasons:?}");
    assert!(reasons[1].contains("counts.csv does not have the set"), "{reasons:?}");
    assert_eq!(reasons.len(), 2);

    // Some of the rows.
    for (line, rows) in [
        ("--row plane_down/slow", &[slow][..]),
        ("--row plane_down//2", &[two]),
        ("--row plane_down/ --row plane_down/1TP/1", &[main, one, two]),
    ] {
        let some = validated(&work, line);
        let found: Vec<u64> =
            some["runs"].as_array().unwrap().iter().map(|run| run["cycles"].as_u64().unwrap()).collect();
        assert_eq!(found, rows, "{line}");
    }
    let text = work.run("simulate --validate runs");
    let text = String::from_utf8(text.stdout).unwrap();
    assert!(
        text.contains("tm.threads=2 l1.latency_cycles=9") && text.contains("absent: plane_up//1: "),
        "{text}"
    );
}

#[test]
fn refused() {
    let work =
        with(&["plane_down,warm,,closest,1", "plane_down,,l1.sizes=1KiB,closest,1", "plane_up,,,closest,1"]);
    for (row, words) in [
        ("plane_down/warm", &["reference_runs.csv", "plane_down warm", "`settings`", "l1off"][..]),
        ("plane_down/", &["reference_runs.csv", "l1.sizes=1KiB", "sizes"]),
        ("plane_down/cold", &["--row plane_down/cold", "reference_runs.csv", "SET/VARIANT"]),
        ("plane_up", &["nothing to validate", "plane_up.rays is missing"]),
    ] {
        work.refused(&format!("simulate --validate runs --row {row}"), words);
    }
    work.refused("simulate scene.obj --row plane_up", &["--row", "SCENE"]);
    work.refused("simulate --validate none", &["none"]);
}
