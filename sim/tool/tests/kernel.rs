//! Programs of the user's own on the machine.

mod support;

use machine::description::NodeLayout;
use machine::frame::MachineStructure;
use machine::kernels;
use serde_json::Value;
use support::Workplace;
use testing::tools::available;

/// A small frame on a small machine.
const SIMULATE: &str = "simulate scene.obj --size 12x10 --quality fast --set chip.l2_partitions=1 --set chip.tms_per_partition=2";

/// Structures of each kind of program.
const SOME: [MachineStructure; 4] = [
    MachineStructure::Dst,
    MachineStructure::DstSoftware,
    MachineStructure::Bvh2Plus,
    MachineStructure::Bvh8,
];

/// The document without what names the program and the host's time.
fn quantities(document: &Value) -> Value {
    let mut document = document.clone();
    for key in ["command", "kernel", "seconds", "simulated_rays_per_second"] {
        document.as_object_mut().unwrap().remove(key);
    }
    document
}

fn with_dumped() -> Workplace {
    let work = Workplace::new();
    work.json("simulate --dump-kernels own");
    work
}

#[test]
fn a_listing_of_ours_is_timed_as_ours() {
    let work = with_dumped();
    for structure in ["dst", "bvh4+"] {
        let ours = work.json(&format!("{SIMULATE} --structure {structure}"));
        assert!(ours.get("kernel").is_none());
        let name = if structure == "dst" { "dst" } else { "bvh-wide-parallel" };
        let own = work.json(&format!("{SIMULATE} --structure {structure} --kernel own/{name}.s"));
        assert_eq!(quantities(&own), quantities(&ours), "{structure}");
        assert_eq!(own["kernel"]["file"], format!("own/{name}.s"));
        assert_eq!(own["kernel"]["sha256"].as_str().unwrap().len(), 64);
        assert_eq!(own["kernel"]["different_pixels"], 0);
        assert!(own["kernel"]["first_difference"].is_null());
    }
    // The other levels, samples and the table.
    let larger = SIMULATE.replace("12x10", "24x24");
    for rest in ["--fidelity analytic", "--sample 50%", "--fidelity rtl", "--fidelity auto"] {
        let ours = work.json(&format!("{larger} {rest}"));
        let own = work.json(&format!("{larger} {rest} --kernel own/dst.s"));
        assert_eq!(quantities(&own), quantities(&ours), "{rest}");
    }
    let text = String::from_utf8(work.run(&format!("{SIMULATE} --kernel own/dst.s")).stdout).unwrap();
    assert!(text.contains("kernel own/dst.s, sha256") && text.contains("its picture is golden's"), "{text}");
}

#[test]
fn a_program_in_c_of_ours_is_timed_as_ours() {
    if !available("clang-14") {
        return;
    }
    let work = with_dumped();
    work.write("mine.c", b"#include \"frame.c\"\n");
    for structure in SOME {
        let ours = work.json(&format!("{SIMULATE} --structure {structure}"));
        let own = work.json(&format!("{SIMULATE} --structure {structure} --kernel mine.c"));
        assert_eq!(quantities(&own), quantities(&ours), "{structure}");
        // Its listing is the one that comes with the tool.
        let listing = kernels::FILES
            .iter()
            .find(|(_, content)| *content == structure.listing(NodeLayout::default()))
            .unwrap()
            .0;
        let read = work.json(&format!("{SIMULATE} --structure {structure} --kernel own/{listing}"));
        assert_eq!(own["kernel"]["sha256"], read["kernel"]["sha256"], "{structure}");
    }
    // As the compiler writes it, with comments and directives.
    let options = kernels::OPTIONS.split_whitespace().chain(["-DDST", "-o", "raw.s", "own/frame.c"]);
    let folder = work.path("");
    testing::tools::run(&folder, "clang-14", &options.collect::<Vec<_>>()).unwrap();
    let raw = work.json(&format!("{SIMULATE} --kernel raw.s"));
    assert_eq!(quantities(&raw), quantities(&work.json(SIMULATE)));
}

#[test]
fn the_example_computes_goldens_picture_in_another_way() {
    if !available("clang-14") {
        return;
    }
    let work = with_dumped();
    for structure in SOME {
        let ours = work.json(&format!("{SIMULATE} --structure {structure}"));
        let line = format!("{SIMULATE} --structure {structure} --kernel own/examples/no-t-min.c");
        let example = work.json(&line);
        assert_eq!(example["kernel"]["different_pixels"], 0, "{structure}");
        assert_eq!(example["rays"], ours["rays"], "{structure}");
        let pipeline = |document: &Value| document["instructions"]["pipeline"].as_u64().unwrap();
        assert!(pipeline(&example) >= pipeline(&ours), "{structure}: nothing is dropped");
        assert_ne!(example["cycles"], ours["cycles"], "{structure}");
    }
}

#[test]
fn a_wrong_picture_is_an_error_unless_it_is_allowed() {
    let work = with_dumped();
    // What surfaces reflect.
    let wrong = String::from_utf8(work.read("own/dst.s")).unwrap().replace("0x3f333333", "0x3f333334");
    work.write("wrong.s", wrong.as_bytes());
    let line = format!("{SIMULATE} --kernel wrong.s");
    work.refused(&line, &["wrong.s, line ", "pixel ", " is not golden's: ", "golden has "]);
    let right = work.json(SIMULATE);
    let document = work.json(&format!("{line} --allow-difference"));
    let kernel = &document["kernel"];
    let count = kernel["different_pixels"].as_u64().unwrap();
    assert!((1..=120).contains(&count), "{count}");
    let first = &kernel["first_difference"];
    assert_ne!(first["found_bits"], first["golden_bits"]);
    assert_eq!(document["rays"], right["rays"]);
    let text = String::from_utf8(work.run(&format!("{line} --allow-difference")).stdout).unwrap();
    let [x, y] = [0, 1].map(|at| first["pixel"][at].as_u64().unwrap());
    let expected = format!("{count} pixels are not golden's; the first: pixel {x},{y} is");
    assert!(text.contains(&expected), "{text}");
    // A bound and a sample count alike.
    let all = work.json(&format!("{line} --allow-difference --fidelity analytic"));
    assert_eq!(all["kernel"], *kernel);
    // Two threads of the host count as one.
    assert_eq!(work.json(&format!("{line} --allow-difference --threads 1"))["kernel"], *kernel);
}

/// A program around `body`, whose item is in `$5`.
fn program(body: &str) -> String {
    format!(
        "main:\n    LOAD $2, $zero, 1\n    ATOMIC_INC $5, 0\n    slt $1, $5, $2\n    beqz $1, $end\n    nop\n$item:\n{body}\n    \
         ATOMIC_INC $5, 0\n    slt $1, $5, $2\n    bnez $1, $item\n    nop\n$end:\n    jr $ra\n    nop\n"
    )
}

#[test]
fn what_a_program_does_wrong_names_file_and_line() {
    let work = Workplace::new();
    for (body, words) in [
        ("    div $2, $3", &["line 8: cannot decode `div $2, $3`: the machine has no such instruction"][..]),
        ("    jal memset", &["line 8", "there are no calls"]),
        ("    .frobnicate 3", &["line 8: unknown directive `.frobnicate`"]),
        ("    sll $6, $5, 32", &["line 8: cannot decode `sll $6, $5, 32`: 32 is not in 0..32"]),
        ("    addiu $6, $5, 40000", &["line 8", "40000 is not in -32768..32768"]),
        (
            "    addiu $6, $zero, -1\n    LOAD $6, $6, 0",
            &["line 9, in item 0", "outside memory", "`LOAD $6, $6, 0`"],
        ),
        ("    STORE $5, $zero, 8", &["line 8", "only the picture can be written"]),
        ("    lui $6, 1\n    subu $sp, $sp, $6\n    sw $5, 0($sp)", &["line 10", "the stack is too large"]),
        ("$loop:\n    b $loop\n    nop", &["instructions without asking for a new item"]),
        ("    LOAD $6, $zero, 7\n    STORE $5, $6, 0", &["which another item has written"]),
        ("    jr $ra\n    nop", &["line 8", "it ends although there are more items"]),
        ("    BOXTEST2 $1, $2", &["line 8", "2 operands, expected 25"]),
        ("    ENTRY $f1, $5", &["line 8: the pipeline of `dst` has no such operation"]),
        ("    nop", &["pixel ", "is not golden's: red is not written"]),
    ] {
        work.write("a.s", program(body).as_bytes());
        let words: Vec<&str> = words.iter().copied().chain(["a.s, line "]).collect();
        work.refused(&format!("{SIMULATE} --kernel a.s"), &words);
        if !words[0].starts_with("pixel") {
            work.refused(&format!("{SIMULATE} --kernel a.s --allow-difference"), &words);
        }
    }
    // No items at all, and a jump to where nothing follows.
    for (text, word) in [
        ("main:\n    jr $ra\n    nop\n", "it ends without asking for an item"),
        (
            "main:\n    ATOMIC_INC $5, 0\n    j $slot\n$slot:\n    nop\n",
            "goes on behind its last instruction",
        ),
        ("", "no instructions behind `main:`"),
    ] {
        work.write("a.s", text.as_bytes());
        work.refused(&format!("{SIMULATE} --kernel a.s"), &["a.s, line ", word]);
    }
    let unwritten = work.json(&format!("{SIMULATE} --kernel b.s --allow-difference").replace("b.s", {
        work.write("b.s", program("    nop").as_bytes());
        "b.s"
    }));
    assert_eq!(unwritten["kernel"]["different_pixels"], 120);
    assert!(unwritten["kernel"]["first_difference"]["found_bits"].is_null());
}

#[test]
fn a_dependence_between_items_stays_an_error() {
    let work = Workplace::new();
    // Every item writes what the ones before have counted.
    let body = "    addiu $8, $8, 1\n    sll $6, $5, 1\n    addu $6, $6, $5\n    LOAD $7, $zero, 7\n    addu $7, $7, $6\n    \
                STORE $8, $7, 0\n    STORE $8, $7, 1\n    STORE $8, $7, 2";
    work.write("a.s", program(body).as_bytes());
    for option in ["", "--allow-difference"] {
        let words =
            ["a.s, line 8", "it reads $8 as an earlier item has left it; items have to be independent"];
        work.refused(&format!("{SIMULATE} --kernel a.s {option}"), &words);
    }
}

#[test]
fn programs_in_c_that_the_compiler_or_the_machine_refuses() {
    let work = Workplace::new();
    work.write("mine.c", b"#include \"frame.c\"\n");
    let run = std::process::Command::new(env!("CARGO_BIN_EXE_dualsplit"))
        .args(SIMULATE.split_whitespace().chain(["--kernel", "mine.c"]))
        .current_dir(work.path(""))
        .env("CLANG", "/nonexistent")
        .output()
        .unwrap();
    let stderr = String::from_utf8(run.stderr).unwrap();
    assert_eq!((run.status.code(), run.stdout.len()), (Some(2), 0), "{stderr}");
    for word in ["mine.c", "/nonexistent does not start", "install Debian's package clang-14"] {
        assert!(stderr.contains(word), "{stderr}");
    }
    if !available("clang-14") {
        return;
    }
    work.write("bad.c", b"#include \"trax.h\"\nint main(void) { return nothing; }\n");
    work.refused(&format!("{SIMULATE} --kernel bad.c"), &["bad.c:2:", "undeclared identifier 'nothing'"]);
    work.write(
        "call.c",
        b"#include \"trax.h\"\nint other(int);\nint main(void) {\n    next_item();\n    return other(3);\n}\n",
    );
    work.refused(
        &format!("{SIMULATE} --kernel call.c"),
        &["the listing of call.c, line ", "there are no calls", "(`jal other`, call.c, line 5)"],
    );
    work.write(
        "far.c",
        b"#include \"trax.h\"\nint main(void) {\n    for (int i = next_item(); i < PARAMETER_INT(PARAM_RAYS); i = next_item())\n        \
          STORE_INT(i, -5, 0);\n    return 0;\n}\n",
    );
    let words = ["the listing of far.c, line ", "in item 0: it stores to word 4294967291", "far.c, line 4)"];
    work.refused(&format!("{SIMULATE} --kernel far.c"), &words);
}

#[test]
fn refused() {
    let work = with_dumped();
    work.refused("simulate --dump-kernels own", &["own", "--force"]);
    work.write("own/dst.s", b"mine");
    work.json("simulate --dump-kernels own --force");
    assert_eq!(work.read("own/dst.s"), MachineStructure::Dst.listing(NodeLayout::default()).as_bytes());
    for (line, words) in [
        ("simulate --validate own --kernel own/dst.s", &["--kernel", "--validate"][..]),
        ("simulate --dump-config --kernel own/dst.s", &["--kernel", "--dump-config"]),
        ("simulate scene.obj --allow-difference", &["--kernel"]),
        ("simulate scene.obj --kernel none.s", &["none.s: cannot read"]),
        ("simulate scene.obj --kernel own", &["own: this is no file"]),
        ("simulate scene.obj --kernel scene.obj", &["scene.obj", ".s", ".c"]),
        ("study --kernel own/dst.s", &["--kernel"]),
        ("chart fidelity scene.obj --kernel own/dst.s", &["--kernel"]),
    ] {
        work.refused(line, words);
    }
    work.write("binary.s", b"main:\n\xff\xfe\n");
    work.refused("simulate scene.obj --kernel binary.s", &["binary.s", "line 2", "not UTF-8"]);
    // More paths than can be kept: each branch leaves for one end.
    let many = "    beqz $5, $end\n    nop\n".repeat(3000);
    work.write("paths.s", program(&many).as_bytes());
    work.refused("simulate scene.obj --kernel paths.s", &["paths.s, line ", "on all paths"]);
    work.write("long.s", program(&"    nop\n".repeat(9000)).as_bytes());
    work.refused("simulate scene.obj --kernel long.s", &["long.s, line 8195", "more than 8192 instructions"]);
}

/// A compiler that fails says what it was given: the folders of the program come before the shipped sources. One that writes nothing
/// is named.
#[test]
#[cfg(unix)]
fn the_compiler_gets_the_programs_folders_first() {
    use std::os::unix::fs::PermissionsExt;
    let work = with_dumped();
    work.write("failing", b"#!/bin/sh\necho \"$@\" >&2\nexit 1\n");
    std::fs::set_permissions(work.path("failing"), std::fs::Permissions::from_mode(0o755)).unwrap();
    let with_compiler = |compiler: &str| {
        let output = std::process::Command::new(env!("CARGO_BIN_EXE_dualsplit"))
            .args(SIMULATE.split(' '))
            .args(["--kernel", "own/examples/no-t-min.c"])
            .env("CLANG", compiler)
            .current_dir(work.path("."))
            .output()
            .unwrap();
        assert_eq!(output.status.code(), Some(2));
        String::from_utf8(output.stderr).unwrap()
    };
    let said = with_compiler("./failing");
    let places =
        ["-I own/examples", "-I own/examples/..", "include"].map(|word| said.find(word).expect(word));
    assert!(places.is_sorted(), "{said}");
    let said = with_compiler("true");
    assert!(said.contains("CLANG") && said.contains("wrote no listing"), "{said}");
}
