//! Scenes from files: formats, what is reported of them, and views.

mod support;

use std::io::Write;
use std::process::{Command, Stdio};
use support::Workplace;

const DART: &[u8] =
    b"o Caf\xe9\\\nv 0 0 0\nv 2 -1 0\nv 0.5 0 0\nv 2 1 0\nl 1 2\nf 2 3 4 1\nf 2 3 4\nf 3 4 2\n";

fn stderr(work: &Workplace, line: &str) -> String {
    let output = work.run(line);
    assert_eq!(output.status.code(), Some(0), "{line}: {}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stderr).unwrap()
}

#[test]
fn every_format_is_written_and_read() {
    let work = Workplace::new();
    let mut trees = vec![];
    for name in ["a.obj", "a.obj.gz", "a.obj.xz", "a.ply", "a.ply.gz", "a.stl", "a.stl.xz"] {
        work.json(&format!("scenes hairball --detail 0.001 --export {name}"));
        let mut tree = work.json(&format!("tree {name} --quality fast"));
        assert_eq!(tree["scene"], "a");
        assert_eq!(stderr(&work, &format!("tree {name} --quality fast")), "", "{name}");
        trees.push((tree["triangles"].take(), tree["bounds"].take(), tree["structures"][0]["nodes"].take()));
    }
    assert!(trees.iter().all(|tree| *tree == trees[0]), "{trees:?}");
    assert!(work.read("a.ply").starts_with(b"ply\n"));
    assert!(work.read("a.obj.gz").starts_with(b"\x1f\x8b"));
    for name in ["b.glb", "b.fbx", "b"] {
        work.refused(&format!("scenes hairball --detail 0.001 --export {name}"), &[name, ".ply"]);
    }
    work.write("model.fbx", b"Kaydara FBX Binary  \0");
    work.refused("tree model.fbx", &["model.fbx", "FBX files are not read", "gltf"]);
    work.write("model.data", b"nothing known");
    work.refused("tree model.data", &["model.data", "--format"]);
    work.refused("tree model.data --format ply", &["model.data:1", "ply"]);
    work.refused("tree model.data --format fbx", &["--format", "gltf"]);
}

#[test]
fn what_a_file_holds_is_told_once() {
    let work = Workplace::new();
    work.write("dart.obj", DART);
    for command in ["tree dart.obj", "render dart.obj --size 8x8 --out a.png", "tree dart.obj --json"] {
        let notes = stderr(&work, command);
        let expected = ["statements `l`", "Caf\u{fffd}\\", "1 polygons are concave", "1 triangles repeat"];
        assert_eq!(notes.lines().count(), expected.len(), "{notes}");
        for (line, words) in notes.lines().zip(expected) {
            assert!(line.starts_with("dart.obj: ") && line.contains(words), "no `{words}` in {line}");
        }
    }
    let tree = work.json("tree dart.obj");
    assert_eq!((tree["degenerate"].as_u64(), tree["duplicates"].as_u64()), (Some(0), Some(1)));
    assert_eq!(tree["bounds"], serde_json::json!({ "min": [0.0, -1.0, 0.0], "max": [2.0, 1.0, 0.0] }));
    let text = String::from_utf8(work.run("tree dart.obj").stdout).unwrap();
    assert!(text.contains("from 0.0 -1.0 0.0 to 2.0 1.0 0.0; 0 triangles of no area, 1 repeated"), "{text}");
}

#[test]
fn a_view_beside_the_mesh_is_the_camera_and_options_win() {
    let work = Workplace::new();
    let picture = |options: &str, out: &str| {
        work.json(&format!("render scene.obj --size 24x24 --test raycast {options} --out {out} --force"));
        work.read(out)
    };
    let view = "--eye 2,3,4 --target 0,1,0 --fov 40";
    let (framed, wanted, near) = (
        picture("", "a.png"),
        picture(view, "a.png"),
        picture(&format!("{view} --fov 20").replace("--fov 40 ", ""), "a.png"),
    );
    assert!(framed != wanted && wanted != near);
    work.write("scene.view.toml", b"eye = [2, 3, 4]\ntarget = [0, 1, 0]\nfov = 40\n");
    assert_eq!(picture("", "a.png"), wanted);
    assert_eq!(picture("--fov 20", "a.png"), near);
    work.write("scene.view.toml", b"eye = [2, 3, 4]\ndirection = [-2, -2, -4]\nfov = 40\n");
    assert_eq!(picture("", "a.png"), wanted);
    for command in ["tree scene.obj", "explain scene.obj --pixel 1,1", "render scene.obj --out b.png"] {
        work.write("scene.view.toml", b"fov = 40\nfocus = 3\n");
        work.refused(command, &["scene.view.toml:2", "focus", "fov"]);
    }
}

/// A square is as bright in any unit of length, and a power of two changes no bit.
#[test]
fn brightness_does_not_depend_on_the_unit_of_length() {
    let work = Workplace::new();
    let render = |scale: f32, test: &str| {
        let corner = |x: f32, y: f32| format!("v {:e} {:e} 0\n", x * scale, y * scale);
        let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]].map(|[x, y]| corner(x, y));
        work.write("quad.obj", format!("{}f 1 2 3\nf 1 3 4\n", corners.concat()).as_bytes());
        let line =
            format!("render quad.obj --size 24x24 --test {test} --quality fast --out quad.png --force");
        (work.json(&line)["max"].as_f64().unwrap(), work.read("quad.png"))
    };
    for test in ["raycast", "path"] {
        let (brightest, picture) = render(1.0, test);
        assert!(brightest > 0.5, "{brightest}");
        for exponent in [66, -70] {
            assert!(
                render(2f32.powi(exponent), test) == (brightest, picture.clone()),
                "{test}, 2^{exponent}"
            );
        }
        for scale in [1e20, 1e-21] {
            let (other, _) = render(scale, test);
            assert!(
                (other / brightest - 1.0).abs() < 1e-4,
                "{test}, {scale:e}: {other} instead of {brightest}"
            );
        }
    }
}

#[test]
fn standard_input_is_a_scene() {
    let work = Workplace::new();
    work.json("scenes hairball --detail 0.001 --export a.ply.gz");
    for options in [&["--format", "ply"][..], &[]] {
        let mut child = Command::new(env!("CARGO_BIN_EXE_dualsplit"))
            .args(["tree", "-", "--quality", "fast"])
            .args(options)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .unwrap();
        child.stdin.take().unwrap().write_all(&work.read("a.ply.gz")).unwrap();
        let output = child.wait_with_output().unwrap();
        assert_eq!(output.status.code(), Some(0));
        assert!(
            output.stdout.starts_with(b"stdin: 2880 triangles"),
            "{}",
            String::from_utf8_lossy(&output.stdout)
        );
    }
}

#[test]
#[cfg(target_os = "linux")]
fn a_path_need_not_be_unicode() {
    use std::ffi::OsStr;
    use std::os::unix::ffi::OsStrExt;
    let work = Workplace::new();
    let name = OsStr::from_bytes(b"caf\xe9.obj");
    std::fs::copy(work.path("scene.obj"), work.path("scene.obj").with_file_name(name)).unwrap();
    let output = Command::new(env!("CARGO_BIN_EXE_dualsplit"))
        .arg("tree")
        .arg(work.path("scene.obj").with_file_name(name))
        .output()
        .unwrap();
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    assert!(output.stdout.starts_with("caf\u{fffd}: 6 triangles".as_bytes()));
}
