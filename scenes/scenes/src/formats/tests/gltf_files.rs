use base64::Engine;
use base64::engine::general_purpose::STANDARD;

use super::*;
use crate::formats::report::Skip;

/// Positions and 16-bit indices of the square.
fn buffer() -> Vec<u8> {
    let square = square();
    let positions = square.positions.iter().flatten().flat_map(|x| x.to_le_bytes());
    positions.chain(square.triangles.iter().flatten().flat_map(|&i| (i as u16).to_le_bytes())).collect()
}

/// The square as a document with a buffer at `uri`.
fn document(uri: &str) -> String {
    format!(
        r#"{{"asset":{{"version":"2.0"}},"scene":0,"scenes":[{{"nodes":[0]}}],"nodes":[{{"mesh":0}}],
"meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}},"indices":1}}]}}],
"accessors":[{{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","min":[0,0,0.1],"max":[1,1,0.5]}},
{{"bufferView":1,"componentType":5123,"count":6,"type":"SCALAR"}}],
"bufferViews":[{{"buffer":0,"byteLength":48}},{{"buffer":0,"byteOffset":48,"byteLength":12}}],
"buffers":[{{"byteLength":60{uri}}}]}}"#
    )
}

pub fn json() -> String {
    document(&format!(r#","uri":"data:application/octet-stream;base64,{}""#, STANDARD.encode(buffer())))
}

pub fn glb() -> Vec<u8> {
    let mut text = document("").into_bytes();
    text.resize(text.len().next_multiple_of(4), b' ');
    let binary = buffer();
    let length = (12 + 8 + text.len() + 8 + binary.len()) as u32;
    let chunk = |kind: &[u8], bytes: &[u8]| [&(bytes.len() as u32).to_le_bytes(), kind, bytes].concat();
    [
        b"glTF",
        &2u32.to_le_bytes()[..],
        &length.to_le_bytes(),
        &chunk(b"JSON", &text),
        &chunk(b"BIN\0", &binary),
    ]
    .concat()
}

fn with(from: &str, to: &str) -> String {
    let text = json();
    assert!(text.contains(from), "{from}");
    text.replace(from, to)
}

fn mesh(text: &str) -> Mesh {
    named(text.as_bytes(), "a.gltf").unwrap_or_else(|e| panic!("{e}")).mesh
}

#[test]
fn buffers_in_the_document_in_the_container_and_in_files() {
    assert_eq!(mesh(&json()), square());
    for name in ["a.glb", "standard input"] {
        assert_eq!(named(&glb(), name).unwrap().mesh, square());
        assert_eq!(named(&gzipped(&glb()), name).unwrap().mesh, square());
        assert_eq!(named(json().as_bytes(), name).unwrap().report.format, Format::Gltf);
    }
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.gltf");
    std::fs::write(&path, document(r#","uri":"my%20data.bin""#)).unwrap();
    let missing = load(&path, None).unwrap_err().to_string();
    assert!(missing.contains("buffer 0") && missing.contains("my%20data.bin"), "{missing}");
    std::fs::write(folder.path().join("my data.bin"), buffer()).unwrap();
    assert_eq!(load(&path, None).unwrap().mesh, square());
    std::fs::write(folder.path().join("my data.bin"), [0; 59]).unwrap();
    let short = load(&path, None).unwrap_err().to_string();
    assert!(short.contains("59 bytes instead of 60"), "{short}");
    assert_refused(
        document(r#","uri":"x.bin""#).as_bytes(),
        "a.gltf",
        "a.gltf: buffer 0: ",
        &["x.bin", "folder"],
    );
    assert_refused(
        document(r#","uri":"http://x/y""#).as_bytes(),
        "a.gltf",
        "a.gltf: buffer 0: ",
        &["http://x/y"],
    );
}

#[test]
fn nodes_move_their_meshes() {
    let moved = |x: [f32; 3]| [x[2] + 1.0, 2.0 * x[1], -2.0 * x[0]];
    let turned = Mesh {
        positions: square().positions.into_iter().map(|[x, y, z]| moved([x * 2.0, y, z * 2.0])).collect(),
        ..square()
    };
    // A quarter turn about y takes z to x and x to -z; then everything is twice as large and one further along x.
    let matrix = r#""nodes":[{"matrix":[0,0,-4,0, 0,2,0,0, 2,0,0,0, 1,0,0,1],"mesh":0}]"#;
    assert_eq!(mesh(&with(r#""nodes":[{"mesh":0}]"#, matrix)), turned);
    let parts = r#""nodes":[{"translation":[1,0,0],"children":[1]},{"scale":[2,2,4],"children":[2]},
        {"rotation":[0,0.70710678,0,0.70710678],"mesh":0}]"#;
    let found = mesh(&with(r#""nodes":[{"mesh":0}]"#, parts));
    let near = |a: &[f32; 3], b: &[f32; 3]| a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-6);
    let expected: Vec<[f32; 3]> =
        square().positions.iter().map(|&[x, y, z]| [2.0 * z + 1.0, 2.0 * y, -4.0 * x]).collect();
    assert!(found.positions.iter().zip(&expected).all(|(a, b)| near(a, b)), "{:?}", found.positions);
    assert_eq!(found.triangles, square().triangles);
    // A mirrored mesh keeps its outside.
    let mirrored = mesh(&with(r#""nodes":[{"mesh":0}]"#, r#""nodes":[{"mesh":0,"scale":[-1,1,1]}]"#));
    assert_eq!(mirrored.triangles, [[0, 2, 1], [0, 3, 2]]);
    assert_eq!(mirrored.positions[1], [-1.0, 0.0, 0.5]);
    // Meshes have the order of their nodes, and only the scene's count.
    let two = r#""nodes":[{"children":[2,1]},{"mesh":0},{"mesh":0,"translation":[5,0,0]},{"mesh":0}]"#;
    let found = mesh(&with(r#""nodes":[{"mesh":0}]"#, two));
    assert_eq!((found.triangles.len(), found.positions[0][0], found.positions[4][0]), (4, 5.0, 0.0));
    let without_scene =
        with(r#""scene":0,"scenes":[{"nodes":[0]}],"#, "").replace(r#""nodes":[{"mesh":0}]"#, two);
    assert_eq!(mesh(&without_scene).triangles.len(), 6);
}

#[test]
fn strips_fans_and_lists() {
    let primitive = r#""indices":1}"#;
    for (change, expected) in [
        (r#""mode":4}"#, vec![[0, 1, 2]]),
        (r#""mode":5}"#, vec![[0, 1, 2], [2, 1, 3]]),
        (r#""mode":6}"#, vec![[0, 1, 2], [0, 2, 3]]),
    ] {
        assert_eq!(mesh(&with(primitive, change)).triangles, expected, "{change}");
    }
    let lines =
        named(with(primitive, r#""indices":1},{"attributes":{"POSITION":0},"mode":1}"#).as_bytes(), "a.gltf")
            .unwrap();
    assert_eq!(lines.mesh, square());
    assert_eq!(lines.report.count(Skip::NoTriangle), 1);
}

#[test]
fn packed_and_sparse_positions() {
    // Normalized bytes, four apart: 0 and 255 are 0 and 1.
    let bytes: Vec<u8> = [[0u8, 0, 255, 9], [255, 0, 255, 9], [255, 255, 255, 9], [0, 255, 0, 9]].concat();
    let uri = |bytes: &[u8]| format!("data:;base64,{}", STANDARD.encode(bytes));
    let text = json();
    let (head, _) = text.split_once("\"buffers\"").unwrap();
    let packed = head
        .replace("5126", "5121,\"normalized\":true")
        .replace(r#""byteLength":48}"#, r#""byteLength":16,"byteStride":4}"#)
        .replace(r#""byteOffset":48"#, r#""byteOffset":16"#)
        .replace(r#""asset""#, r#""extensionsRequired":["KHR_mesh_quantization"],"asset""#);
    let indices = &buffer()[48..];
    let packed =
        format!(r#"{packed}"buffers":[{{"byteLength":28,"uri":"{}"}}]}}"#, uri(&[&bytes, indices].concat()));
    let expected = [[0.0, 0.0, 1.0], [1.0, 0.0, 1.0], [1.0, 1.0, 1.0], [0.0, 1.0, 0.0]];
    assert_eq!(mesh(&packed).positions, expected);
    // Vertex 3 is replaced by the position of vertex 1, and its index by that of the file.
    let sparse = with(
        r#""type":"VEC3""#,
        r#""type":"VEC3","sparse":{"count":1,"indices":{"bufferView":2,"componentType":5121},
            "values":{"bufferView":0,"byteOffset":12}}"#,
    );
    let view = |at: usize| {
        sparse.replace(
            r#""byteLength":12}]"#,
            &format!(r#""byteLength":12}},{{"buffer":0,"byteOffset":{at},"byteLength":1}}]"#),
        )
    };
    // The low byte of the last index, 3, lies at 58.
    assert_eq!(mesh(&view(58)).positions[3], [1.0, 0.0, 0.5]);
    assert_refused(view(47).as_bytes(), "a.gltf", "a.gltf: accessor 0: ", &["sparse"]);
}

#[test]
fn faults_name_the_part() {
    for (from, to, start, words) in [
        ("\"2.0\"", "\"1.0\"", "a.gltf: ", &["glTF 1.0"][..]),
        (
            "\"asset\"",
            r#""extensionsRequired":["KHR_draco_mesh_compression"],"asset""#,
            "a.gltf: ",
            &["KHR_draco"],
        ),
        (r#""count":4"#, r#""count":5"#, "a.gltf: accessor 0: ", &["5 elements"]),
        (r#""count":4"#, r#""count":9007199254740991"#, "a.gltf", &[]),
        (r#""count":6"#, r#""count":7"#, "a.gltf: accessor 1: ", &[]),
        (
            r#""count":4"#,
            r#""count":3"#,
            "a.gltf: accessor 1, element 5: ",
            &["vertex index 3", "3 vertices"],
        ),
        (r#""bufferView":0,"#, "", "a.gltf: accessor 0: ", &["buffer view"]),
        (r#""bufferView":0,"#, r#""bufferView":7,"#, "a.gltf: accessors[0].bufferView: ", &["nothing"]),
        (r#""POSITION":0"#, r#""POSITION":2"#, "a.gltf: ", &["no accessor"]),
        (r#""indices":1"#, r#""indices":2"#, "a.gltf: meshes[0].primitives[0].indices: ", &["nothing"]),
        (r#""VEC3""#, r#""VEC2""#, "a.gltf: accessor 0: ", &["three numbers"]),
        ("5123", "5126", "a.gltf: accessor 1: ", &["integers"]),
        (r#""byteLength":48}"#, r#""byteLength":480}"#, "a.gltf: buffer view 0: ", &["60 bytes"]),
        (r#""byteOffset":48"#, r#""byteOffset":18446744073709551615"#, "a.gltf", &[]),
        (r#""byteLength":60"#, r#""byteLength":61"#, "a.gltf: buffer 0: ", &["61"]),
        ("base64,", "base64,!", "a.gltf: buffer 0: ", &["base 64"]),
        ("base64,", ",", "a.gltf: buffer 0: ", &["base 64"]),
        (r#"[{"mesh":0}]"#, r#"[{"mesh":0,"children":[0]}]"#, "a.gltf: node 0: ", &["ancestor"]),
        (r#"[{"mesh":0}]"#, r#"[{"children":[1]},{"children":[0]}]"#, "a.gltf: node 0: ", &["ancestor"]),
        (r#"[{"mesh":0}]"#, r#"[{"mesh":3}]"#, "a.gltf: nodes[0].mesh: ", &["nothing"]),
        (
            r#"[{"mesh":0}]"#,
            r#"[{"mesh":0,"scale":[1e38,1e38,1e38]}]"#,
            "a.gltf: accessor 0, element",
            &["range"],
        ),
        (r#"[{"mesh":0}]"#, "[{}]", "a.gltf: ", &["no triangle"]),
        ("\"nodes\":[{", "\"nodes\":[[", "a.gltf: ", &["line 1"]),
    ] {
        assert_refused(with(from, to).as_bytes(), "a.gltf", start, words);
    }
    for (at, value, word) in
        [(4, 1, "glTF 1"), (8, 0, "header"), (8, 11, "header"), (11, 9, "declares"), (12, 255, "container")]
    {
        let mut bytes = glb();
        bytes[at] = value;
        if at == 8 {
            bytes[9..12].fill(0);
        }
        assert_refused(&bytes, "a.glb", "a.glb: ", &[word]);
    }
    let whole = glb();
    for length in 4..whole.len() {
        assert!(named(&whole[..length], "a.glb").is_err(), "{length}");
    }
}

/// A document of some kilobytes that uses a mesh very often, and its mesh one buffer.
#[test]
fn a_small_file_cannot_ask_for_gigabytes() {
    let primitives = vec![r#"{"attributes":{"POSITION":0},"indices":1}"#; 400].join(",");
    let nodes = vec![r#"{"mesh":0}"#; 10_000].join(",");
    let roots: Vec<String> = (0..10_000).map(|node| node.to_string()).collect();
    let text = with(r#"{"attributes":{"POSITION":0},"indices":1}"#, &primitives)
        .replace(r#"[{"mesh":0}]"#, &format!("[{nodes}]"))
        .replace(r#"{"nodes":[0]}"#, &format!(r#"{{"nodes":[{}]}}"#, roots.join(",")));
    assert!(text.len() < 200_000);
    assert_refused(text.as_bytes(), "a.gltf", "a.gltf: mesh 0, primitive ", &["times the file"]);
}
