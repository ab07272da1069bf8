//! The costs in `published.json` are those of the netlists. `DUALSPLIT_BLESS=1` writes them anew.

use costs::PipelineCost;
use estimate::{Method, compute, pipeline_cost};
use pipelines::catalogue::Top;
use std::collections::BTreeMap;

#[test]
fn known_costs_are_those_of_the_netlists() {
    let tops = [Top::DualSplit, Top::DualSplitLean, Top::RayBox, Top::RayBoxLean];
    let costs: BTreeMap<&str, PipelineCost> =
        tops.iter().map(|top| (top.name(), compute(*top, Method::Published).unwrap())).collect();
    if std::env::var_os("DUALSPLIT_BLESS").is_some() {
        let file = concat!(env!("CARGO_MANIFEST_DIR"), "/published.json");
        std::fs::write(file, serde_json::to_string_pretty(&costs).unwrap() + "\n").unwrap();
        return;
    }
    for top in tops {
        assert_eq!(
            pipeline_cost(top, Method::Published).unwrap(),
            costs[top.name()],
            "{top}: run with DUALSPLIT_BLESS=1"
        );
    }
}
