//! The commands that look for the least precision: chart, stress and needs.

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
    assert!(naive.map(|p| p["false_misses"].as_u64().unwrap()).sum::<u64>() > 0);
    let area = |format: &str| points.iter().find(|p| p["format"] == format).unwrap()["area_um2"].as_f64();
    assert!(
        area("binary32") > area("tf32") && area("tf32") > area("bfloat16") && area("bfloat16") > area("e4m3")
    );
    let csv = String::from_utf8(work.read("charts/precision.csv")).unwrap();
    assert_eq!(csv.lines().count(), 1 + points.len());
    for chart in ["visits", "wrong-rays", "image-error", "energy", "front"] {
        let svg = String::from_utf8(work.read(&format!("charts/{chart}.svg"))).unwrap();
        assert!(svg.contains("conservative, 8 exponent bits"), "{svg}");
    }
    // Equal on any number of threads, and anew over its own files.
    let again = work.json("chart precision scene.obj --size 24x24 --out charts --threads 1");
    assert_eq!(document, again);
    work.refused("chart precision teapot", &["teapot", "hairball"]);
    work.refused("chart", &["precision"]);
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
    for safe in ["dst/binary32-robust", "bvh4/e4m3-conservative", "rtl/binary32-robust"] {
        assert!(sum(safe, "rays") > 50, "{safe}");
        for count in ["false_misses", "false_hits", "wrong_nearest", "nan", "lost", "excess_visits"] {
            assert_eq!(sum(safe, count), 0, "{safe}: {count}");
        }
    }
    assert!(sum("dst/bfloat16-naive", "false_misses") > 100);
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
    assert!(document["significand_bits"].as_u64().unwrap() < 24);
    let toml = String::from_utf8(work.read("needs/needs.toml")).unwrap();
    assert!(toml.contains(&format!("significand_bits = {}", document["significand_bits"])), "{toml}");
    // The export takes what is proposed.
    let format = document["export_format"].as_str().unwrap();
    work.json(&format!("export --unit fp_add --format {format} --out rtl"));
    let naive = work.json("needs scene.obj --size 24x24 --variant naive --max-extra-visits 10 --out naive");
    let sweep = naive["significand_sweep"].as_array().unwrap();
    let chosen = sweep.iter().find(|p| p["significand_bits"] == naive["significand_bits"]).unwrap();
    assert_eq!((&chosen["false_misses"], &chosen["rmse"]), (&0.into(), &0.0.into()));
    work.refused("needs scene.obj --max-image-error=-1", &["--max-image-error", "not negative"]);
}
