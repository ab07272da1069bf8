//! Tests of the commands that search the least precision: chart, stress and needs.

mod support;

use support::{Workplace, has_keys};

#[test]
fn chart_precision() {
    let work = Workplace::new();
    let document = work.json("chart precision scene.obj --size 24x24 --out charts");
    has_keys(&document, &["scene", "rays", "points", "artifacts"]);
    let points = document["points"].as_array().unwrap();
    // 17 significands with 8 exponent bits and three formats with fewer, in both variants.
    assert_eq!(points.len(), 2 * (17 + 3));
    for point in points {
        has_keys(
            point,
            &[
                "format",
                "variant",
                "node_visits",
                "false_misses",
                "rmse",
                "differing_pixels",
                "pareto",
                "area_um2",
                "energy_pj_per_ray",
            ],
        );
        if point["variant"] == "conservative" {
            for error in ["false_misses", "false_hits", "wrong_nearest", "other_distance", "differing_pixels"]
            {
                assert_eq!(point[error], 0, "{error} in {point}");
            }
            let visits = point["node_visits"].as_u64().unwrap();
            assert!(visits >= document["reference_node_visits"].as_u64().unwrap());
        }
    }
    let naive = points.iter().filter(|p| p["variant"] == "naive");
    assert_eq!(naive.map(|p| p["false_misses"].as_u64().unwrap()).sum::<u64>(), 5);
    let area = |format: &str| points.iter().find(|p| p["format"] == format).unwrap()["area_um2"].as_f64();
    assert!(
        area("binary32") > area("tf32") && area("tf32") > area("bfloat16") && area("bfloat16") > area("e4m3")
    );
    let csv = String::from_utf8(work.read("charts/precision.csv")).unwrap();
    assert_eq!(csv.lines().count(), 1 + points.len());
    for chart in ["visits", "wrong-rays", "image-error", "frame-time", "energy", "front"] {
        let svg = String::from_utf8(work.read(&format!("charts/{chart}.svg"))).unwrap();
        assert!(svg.contains("conservative, 8 exponent bits"), "{svg}");
    }
    // The result does not depend on the number of threads, and the command replaces its own files.
    let again = work.json("chart precision scene.obj --size 24x24 --out charts --threads 1");
    assert_eq!(document, again);
    // Formats with too many visits have no point, and the document names them.
    let few =
        work.json("chart precision scene.obj --size 24x24 --most-visits 1.01 --simulate false --out few");
    let most = 1.01 * document["reference_node_visits"].as_f64().unwrap();
    let (kept, beyond): (Vec<_>, Vec<_>) =
        points.iter().partition(|point| point["node_visits"].as_f64().unwrap() <= most);
    let names = |points: &[&serde_json::Value]| -> Vec<String> {
        let name =
            |point: &&serde_json::Value| format!("{}-{}", point["format"], point["variant"]).replace('"', "");
        points.iter().map(name).collect()
    };
    assert_eq!(few["left_out"], serde_json::json!(names(&beyond)));
    assert_eq!(names(&few["points"].as_array().unwrap().iter().collect::<Vec<_>>()), names(&kept));
    assert!(!beyond.is_empty() && document["left_out"] == serde_json::json!([]));
    work.refused("chart precision scene.obj --most-visits 0.5", &["--most-visits", "at least 1"]);
    work.refused("chart precision teapot", &["teapot", "hairball"]);
    work.refused("chart", &["precision"]);
}

#[test]
fn chart_fidelity() {
    let work = Workplace::new();
    let machine = "--set chip.l2_partitions=1 --set chip.tms_per_partition=1";
    let line = format!("chart fidelity scene.obj --size 40x40 --repeats 2 {machine} --out charts");
    let document = work.json(&line);
    let points = document["points"].as_array().unwrap();
    for key in ["level", "seconds", "time_error_pct", "time_interval_pct", "energy_error_pct"] {
        assert!(points.iter().all(|point| !point[key].is_null()), "{key}");
    }
    for level in ["analytic", "transaction", "rtl"] {
        assert!(points.iter().any(|point| point["level"] == level), "{level}");
    }
    let last = points.last().unwrap();
    assert_eq!((last["level"].as_str(), last["time_error_pct"].as_f64()), (Some("rtl"), Some(0.0)));
    let whole =
        points.iter().find(|p| p["level"] == "transaction" && p["pixels_timed_share"] == 1.0).unwrap();
    assert_eq!(whole["time_error_pct"], 0.0, "the netlists change nothing");
    for file in ["fidelity.csv", "time-error.svg", "energy-error.svg"] {
        assert!(work.path(&format!("charts/{file}")).is_file(), "{file}");
    }

    let simulate = format!("simulate scene.obj --size 40x40 {machine}");
    let all = work.json(&simulate);
    assert_eq!(all["fidelity"]["frame_ms"]["low"], all["frame_ms"]);
    let sample = work.json(&format!("{simulate} --sample 20%"));
    let interval = &sample["fidelity"]["frame_ms"];
    assert!(interval["low"].as_f64() < interval["high"].as_f64(), "{interval}");
    assert!(sample["fidelity"]["pixels_timed_share"].as_f64().unwrap() < 0.8);
    assert_eq!(sample["rays"], all["rays"]);
    let auto = work.json(&format!("{simulate} --fidelity auto --tolerance 20%"));
    let steps = auto["fidelity"]["steps"].as_array().unwrap();
    assert!(steps.len() >= 2 && steps[0]["level"] == "analytic", "{steps:?}");
    // With six triangles, a batch's energy depends on few lines, so the interval is wide.
    let text =
        String::from_utf8(work.run(&format!("{simulate} --fidelity auto --tolerance 80%")).stdout).unwrap();
    assert!(text.contains("is within 80.00 %"), "{text}");
    let rtl = work.json(&format!("{simulate} --fidelity rtl"));
    assert_eq!(rtl["fidelity"]["rtl_operations"], rtl["instructions"]["pipeline"]);
    assert_eq!(rtl["cycles"], all["cycles"]);
    let bound = work.json(&format!("{simulate} --fidelity analytic"));
    assert!(bound["frame_ms"].as_f64() < all["frame_ms"].as_f64());
    work.refused(&format!("{simulate} --tolerance 2%"), &["--tolerance", "auto"]);
    work.refused(&format!("{simulate} --fidelity auto --sample 0.1"), &["--sample", "auto"]);
    work.refused(&format!("{simulate} --sample 2"), &["--sample", "10%"]);
    work.refused(&format!("{simulate} --fidelity rtl --structure dst-sw"), &["dst-sw", "transaction"]);
}

#[test]
fn stress() {
    let work = Workplace::new();
    let methods = "--method dst/binary32-robust --method bvh4/e4m3-conservative --method dst/bfloat16-naive \
                   --method rtl/binary32-robust";
    let line = format!("stress --rays 3 --aimed 2000 --searches 1 {methods} --out stress");
    let document = work.json(&line);
    let cells = document["cells"].as_array().unwrap();
    let sum = |method: &str, key: &str| -> u64 {
        let mine = cells.iter().filter(|cell| cell["method"] == method);
        mine.map(|cell| cell[key].as_u64().unwrap()).sum()
    };
    for cell in cells {
        has_keys(
            cell,
            &["method", "case", "rays", "false_misses", "false_hits", "wrong_nearest", "nan", "lost"],
        );
    }
    for (safe, rays) in
        [("dst/binary32-robust", 3077), ("bvh4/e4m3-conservative", 3453), ("rtl/binary32-robust", 3077)]
    {
        assert_eq!(sum(safe, "rays"), rays, "{safe}");
        for count in ["false_misses", "false_hits", "wrong_nearest", "nan", "lost", "excess_visits"] {
            assert_eq!(sum(safe, count), 0, "{safe}: {count}");
        }
    }
    assert_eq!(sum("dst/bfloat16-naive", "false_misses"), 657);
    assert!(document["artifacts"].to_string().contains("dst-bfloat16-naive-false_miss.png"));
    assert!(work.path("stress/stress.csv").exists());
    assert_eq!(work.json(&format!("{line} --threads 1")), document);
    work.refused("stress --method dst/binary32", &["dst/binary32", "STRUCTURE/FORMAT-conservative"]);
    work.refused("stress --rays 0", &["--rays"]);
}

#[test]
fn needs() {
    let work = Workplace::new();
    let document = work.json("needs scene.obj --size 24x24 --out needs");
    has_keys(
        &document,
        &[
            "significand_bits",
            "exponent_bits",
            "stack_entries",
            "address_bits",
            "carve_levels",
            "cache_bytes",
            "tms",
        ],
    );
    assert_eq!((&document["significand_bits"], &document["exponent_bits"]), (&13.into(), &4.into()));
    let toml = String::from_utf8(work.read("needs/needs.toml")).unwrap();
    assert!(toml.contains(&format!("significand_bits = {}", document["significand_bits"])), "{toml}");
    // The machine file and the export format that the command proposes are valid.
    let machine = work.json("simulate --dump-config --machine needs/needs.toml");
    assert_eq!(machine["name"], "scene-needs");
    assert_eq!(machine["needs"]["significand_bits"], document["significand_bits"]);
    let format = document["export_format"].as_str().unwrap();
    work.json(&format!("export --unit fp_add --format {format} --out rtl"));
    let naive = work.json("needs scene.obj --size 24x24 --variant naive --max-extra-visits 10 --out naive");
    let sweep = naive["significand_sweep"].as_array().unwrap();
    let chosen = sweep.iter().find(|p| p["significand_bits"] == naive["significand_bits"]).unwrap();
    assert_eq!((&chosen["false_misses"], &chosen["rmse"]), (&0.into(), &0.0.into()));
    work.refused("needs scene.obj --max-image-error=-1", &["--max-image-error", "not negative"]);
}

/// Whatever a scene needs, the machine that `needs` writes can be simulated.
#[test]
fn needs_write_a_machine_that_simulate_takes() {
    let work = Workplace::new();
    for entry in scenes::procedural::CATALOGUE {
        let scene = format!("{} --detail 0.0005 --size 8x8 --quality fast", entry.name);
        let out = format!("needs-{}", entry.name);
        let needs = work.json(&format!("needs {scene} --out {out}"));
        let run = work.json(&format!("simulate {scene} --machine {out}/needs.toml"));
        assert_eq!(run["machine"], format!("{}-needs", entry.name));
        let l1 = work.json(&format!("simulate --dump-config --machine {out}/needs.toml"))["l1"].clone();
        assert_eq!(l1["size"], bytes(needs["cache_bytes"].as_u64().unwrap().max(1024)), "{}", entry.name);
        let source = run["cache_costs"]["l1"]["energy_source"].as_str().unwrap();
        assert!(source.starts_with("published") || source.starts_with("modelled"), "{source}");
    }
}

/// A power of two of bytes, at least 1 KiB, as a machine file has it.
fn bytes(bytes: u64) -> String {
    if bytes < 1 << 20 { format!("{}KiB", bytes >> 10) } else { format!("{}MiB", bytes >> 20) }
}
