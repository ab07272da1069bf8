//! A sweep as a workflow of Snakemake, which spreads its runs over processors or hosts.

use std::path::Path;

/// The text of a `Snakefile` for the sweep in `file` with the folder `out`: a job for each key, and one for the tables.
///
/// # Panics
/// Never: texts have a JSON form, which Python reads as well.
#[must_use]
pub fn snakefile(file: &Path, out: &Path, keys: &[&str]) -> String {
    let text = |value: &str| serde_json::to_string(value).expect("a text has a JSON form");
    let path = |value: &Path| text(&value.to_string_lossy());
    let keys: String = keys.iter().map(|key| format!("    {},\n", text(key))).collect();
    format!(
        r#"# Written by `dualsplit sweep --workflow snakemake`: a job for each run of the sweep, and one for its tables.
#
#     snakemake --snakefile {file_name} --cores 2
#
# A job that is lost is tried again. `--config dualsplit=PATH` names another program, and profiles of Snakemake send the jobs to
# SLURM, Kubernetes and others.
DUALSPLIT = config.get("dualsplit", "dualsplit")
SWEEP = {sweep}
OUT = {folder}
KEYS = [
{keys}]


rule tables:
    input:
        expand(OUT + "/runs/{{key}}.json", key=KEYS),
    output:
        OUT + "/results/sweep.csv",
    retries: 2
    shell:
        "{{DUALSPLIT:q}} sweep {{SWEEP:q}} --out {{OUT:q}}"


rule run:
    output:
        OUT + "/runs/{{key}}.json",
    threads: 1
    retries: 2
    shell:
        "{{DUALSPLIT:q}} sweep {{SWEEP:q}} --out {{OUT:q}} --only {{wildcards.key}} --threads {{threads}}"
"#,
        file_name = out.join(super::SNAKEFILE).display(),
        sweep = path(file),
        folder = path(out),
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_quoted() {
        let text = snakefile(Path::new("my \"own\".toml"), Path::new("a b"), &["0a", "1b"]);
        for line in [
            "SWEEP = \"my \\\"own\\\".toml\"",
            "OUT = \"a b\"",
            "    \"1b\",",
            "{OUT:q} --only {wildcards.key}",
        ] {
            assert!(text.contains(line), "no `{line}` in {text}");
        }
    }
}
