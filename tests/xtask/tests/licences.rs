//! What the packages of others are that the workspace is built from: their licences and where they come from.

use serde_json::Value;
use std::process::Command;

/// The licences that allow what this workspace's own licences allow, given their text. An exception to one of them adds rights.
const ALLOWED: [&str; 10] = [
    "0BSD",
    "Apache-2.0",
    "BSD-2-Clause",
    "BSD-3-Clause",
    "BSL-1.0",
    "CC0-1.0",
    "MIT",
    "Unicode-3.0",
    "Unlicense",
    "Zlib",
];

/// The only registry.
const REGISTRY: &str = "registry+https://github.com/rust-lang/crates.io-index";

/// Packages that are not to come back, with what stands in their place.
const BANNED: [(&str, &str); 2] =
    [("cmake", "the package c99 in tests"), ("openssl-sys", "nothing: there is no network")];

/// Whether a licence expression leaves a choice of allowed licences only. Slashes are an old form of `OR`.
fn is_allowed(expression: &str) -> bool {
    let words = expression.replace('/', " OR ").replace('(', " ( ").replace(')', " ) ");
    let words: Vec<&str> = words.split_whitespace().collect();
    let (allowed, rest) = either(&words);
    allowed && rest.is_empty()
}

/// Terms joined by `OR`, at the start of `words`; what follows them.
fn either<'w>(words: &'w [&'w str]) -> (bool, &'w [&'w str]) {
    let (mut allowed, mut rest) = both(words);
    while let ["OR", after @ ..] = rest {
        let (other, after) = both(after);
        (allowed, rest) = (allowed || other, after);
    }
    (allowed, rest)
}

/// Terms joined by `AND`.
fn both<'w>(words: &'w [&'w str]) -> (bool, &'w [&'w str]) {
    let (mut allowed, mut rest) = single(words);
    while let ["AND", after @ ..] = rest {
        let (other, after) = single(after);
        (allowed, rest) = (allowed && other, after);
    }
    (allowed, rest)
}

/// A licence, with an exception or without, or terms in parentheses.
fn single<'w>(words: &'w [&'w str]) -> (bool, &'w [&'w str]) {
    match words {
        ["(", inner @ ..] => match either(inner) {
            (allowed, [")", rest @ ..]) => (allowed, rest),
            _ => (false, &[]),
        },
        [licence, "WITH", _, rest @ ..] | [licence, rest @ ..] => (ALLOWED.contains(licence), rest),
        [] => (false, &[]),
    }
}

/// What is wrong with `package`, if anything.
fn fault(package: &Value) -> Option<String> {
    let text = |key: &str| package[key].as_str();
    let name = text("name")?;
    if let Some((_, instead)) = BANNED.iter().find(|(banned, _)| *banned == name) {
        return Some(format!("{name} is banned; take {instead}"));
    }
    match (text("source"), text("license")) {
        (Some(source), _) if source != REGISTRY => Some(format!("{name} comes from {source}")),
        (_, Some(licence)) if is_allowed(licence) => None,
        (_, licence) => {
            Some(format!("{name} has the licence {}", licence.unwrap_or("of a file, which nobody has read")))
        }
    }
}

#[test]
fn packages_have_allowed_licences_and_come_from_the_registry() {
    let cargo = Command::new(env!("CARGO"))
        .args(["metadata", "--format-version", "1", "--locked"])
        .output()
        .expect("cargo runs");
    assert!(cargo.status.success(), "{}", String::from_utf8_lossy(&cargo.stderr));
    let metadata: Value = serde_json::from_slice(&cargo.stdout).expect("cargo writes JSON");
    let packages = metadata["packages"].as_array().expect("packages");
    assert!(packages.len() > 100, "{}", packages.len());
    let faults: Vec<String> = packages.iter().filter_map(fault).collect();
    assert!(faults.is_empty(), "\n{}\n", faults.join("\n"));
}

#[test]
fn expressions_are_read() {
    for allowed in [
        "MIT",
        "MIT/GPL-3.0",
        "GPL-3.0 OR Zlib",
        "(MIT OR GPL-3.0) AND Unicode-3.0",
        "Apache-2.0 WITH LLVM-exception OR GPL-2.0",
    ] {
        assert!(is_allowed(allowed), "{allowed}");
    }
    for refused in
        ["", "GPL-3.0", "MIT AND GPL-3.0", "(MIT OR Zlib) AND GPL-2.0", "(MIT", "MIT GPL-3.0", "OR"]
    {
        assert!(!is_allowed(refused), "{refused}");
    }
}

#[test]
fn planted_packages_are_found() {
    let package = |name: &str, source: &str, licence: Option<&str>| serde_json::json!({ "name": name, "source": source, "license": licence });
    assert_eq!(fault(&package("good", REGISTRY, Some("MIT"))), None);
    for (package, word) in [
        (package("cmake", REGISTRY, Some("MIT")), "banned"),
        (package("near", "git+https://example.org/near", Some("MIT")), "example.org"),
        (package("far", REGISTRY, Some("AGPL-3.0")), "AGPL"),
        (package("odd", REGISTRY, None), "of a file"),
    ] {
        let fault = fault(&package).unwrap();
        assert!(fault.contains(word), "{fault}");
    }
}
