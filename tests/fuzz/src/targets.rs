//! All readers of files.

use super::Target;
use golden::build::{BuildOptions, Quality, build};
use golden::structure::{Structure, StructureKind, pack_triangles};
use golden::tree_file;
use machine::description::{MachineDescription, NodeLayout, PRESETS};
use machine::frame::MachineStructure;
use machine::program::Program;
use render::ray_file::{read_hits, read_rays, write_hits, write_rays};
use render::{RenderOptions, Test, render};
use scenes::{Format, Mesh, Scene, formats};
use std::path::{Path, PathBuf};
use studies::sweep::file::SweepFile;
use tempfile::TempDir;
use view::picture::{exr, png};

const MIB: usize = 1 << 20;

/// All targets. Compressed files may hold 64 MiB, and pictures 2^26 pixels; those readers may take what that needs.
pub const ALL: [Target; 15] = [
    Target { name: "obj", seeds: obj, read: |bytes| mesh(bytes, Format::Obj), most_bytes: 512 * MIB },
    Target {
        name: "ply",
        seeds: || mesh_files("a.ply"),
        read: |bytes| mesh(bytes, Format::Ply),
        most_bytes: 512 * MIB,
    },
    Target {
        name: "stl",
        seeds: || mesh_files("a.stl"),
        read: |bytes| mesh(bytes, Format::Stl),
        most_bytes: 512 * MIB,
    },
    Target { name: "gltf", seeds: gltf, read: |bytes| mesh(bytes, Format::Gltf), most_bytes: 512 * MIB },
    Target { name: "compressed", seeds: compressed, read: any_mesh, most_bytes: 1024 * MIB },
    Target { name: "view", seeds: views, read: view, most_bytes: 64 * MIB },
    Target { name: "tree", seeds: trees, read: tree, most_bytes: 64 * MIB },
    Target {
        name: "rays",
        seeds: rays,
        read: |bytes| from_file("a.rays", bytes, |path| _ = read_rays(path)),
        most_bytes: 512 * MIB,
    },
    Target {
        name: "hits",
        seeds: hits,
        read: |bytes| from_file("a.hits", bytes, |path| _ = read_hits(path)),
        most_bytes: 512 * MIB,
    },
    Target { name: "machine", seeds: machines, read: machine, most_bytes: 64 * MIB },
    Target { name: "liberty", seeds: liberty, read: cells, most_bytes: 128 * MIB },
    Target { name: "exr", seeds: exrs, read: |bytes| picture("a.exr", bytes), most_bytes: 1536 * MIB },
    Target { name: "png", seeds: pngs, read: png_picture, most_bytes: 1536 * MIB },
    Target { name: "listing", seeds: listings, read: listing, most_bytes: 256 * MIB },
    Target {
        name: "sweep",
        seeds: sweeps,
        read: |bytes| _ = SweepFile::parse(&String::from_utf8_lossy(bytes)),
        most_bytes: 64 * MIB,
    },
];

/// A folder of its own, in memory where the system has such a place: a disk takes longer than most readers.
fn folder() -> TempDir {
    let memory = Path::new("/dev/shm");
    let folder = if memory.is_dir() { tempfile::tempdir_in(memory) } else { tempfile::tempdir() };
    folder.expect("a temporary folder")
}

/// Calls `read` with a file `name` of these bytes.
fn from_file(name: &str, bytes: &[u8], read: impl FnOnce(&Path)) {
    let folder = folder();
    let path = folder.path().join(name);
    std::fs::write(&path, bytes).expect("a temporary file");
    read(&path);
}

/// The bytes of the file `name` that `write` makes.
fn written(name: &str, write: impl FnOnce(&Path)) -> Vec<u8> {
    let folder = folder();
    let path = folder.path().join(name);
    write(&path);
    std::fs::read(path).expect("it was written")
}

fn small_scene() -> Scene {
    let mut scene = scenes::procedural::build("statue", 0.0005, 0).expect("a built-in scene");
    // A part of it: files stay below the length that is tried.
    scene.mesh.triangles.truncate(60);
    scene
        .mesh
        .positions
        .truncate(1 + *scene.mesh.triangles.as_flattened().iter().max().expect("triangles") as usize);
    scene
}

fn mesh_files(name: &str) -> Vec<Vec<u8>> {
    let square = Mesh {
        positions: vec![[0.0, 0.0, 0.5], [1.0, 0.0, 0.5], [1.0, 1.0, 0.5], [0.0, 1.0, 0.1]],
        triangles: vec![[0, 1, 2], [0, 2, 3]],
    };
    let meshes = [square, small_scene().mesh];
    let save =
        |mesh: &Mesh| written(name, |path| formats::save(path, "a", mesh, false).expect("a good mesh"));
    let mut files: Vec<Vec<u8>> = meshes.iter().map(save).collect();
    files.extend(match name {
        "a.ply" => vec![
            b"ply\nformat ascii 1.0\ncomment x\nelement vertex 3\nproperty float x\nproperty double y\nproperty short z\n\
              element face 1\nproperty list uchar int vertex_indices\nproperty int flag\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 7\n"
                .to_vec(),
            b"ply\nformat binary_big_endian 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\n\
              element face 1\nproperty list uint uint vertex_index\nend_header\n"
                .to_vec(),
        ],
        "a.stl" => vec![
            b"solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1e0 0\nendloop\nendfacet\nendsolid a\n".to_vec(),
        ],
        _ => vec![],
    });
    files
}

/// Forms of the format and known faults, and those in the folder that `DUALSPLIT_DATA` names: names that are no UTF-8, continued and cut lines, polygons of all kinds.
fn obj() -> Vec<Vec<u8>> {
    let mut files = mesh_files("a.obj");
    for text in [
        &b"o Caf\xe9\\\nv 0 0 0\nv 2 -1 0\nv 0.5 0 0\nv 2 1 0\nl 1 2\nf 2 3 4 1\nf 2 3 4\nf 3 4\n"[..],
        b"v -1e20 -1e20 0\nv 1e20 -1e20 0\nv 1e20 1e20 0\nv -1e20 1e20 0\nf 1 2 3\nf 1 3 4\n",
        b"v 0 0 0\nv 1 0 0\nv 1.#IND00 1 0\nf 1 2 3\n",
        b"v 0 0 0\r# a comment\rv 1 0 0\r\nv 0 1 \\\n0\nusemtl a\\\nf -3/1 -2//2 -1/3/4\n",
        b"v 0 0 0\nv 3 0 0\nv 3 3 0\nv 2 3 0\nv 2 1 0\nv 1 1 0\nv 1 3 0\nv 0 3 0\nf 1 2 3 4 5 6 7 8\nvt 0 0\nvn 0 0 1\ncurv 0 1 1 2\n",
    ] {
        files.push(text.to_vec());
    }
    let others = testing::data("faults").map(|folder| folder.read_dir().expect("a folder").flatten());
    let mut others: Vec<PathBuf> = others.into_iter().flatten().map(|entry| entry.path()).collect();
    others.retain(|path| path.extension().is_some_and(|extension| extension == "obj"));
    others.sort();
    files.extend(others.iter().map(|path| std::fs::read(path).expect("a file")));
    files
}

fn gltf() -> Vec<Vec<u8>> {
    let json = r#"{"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0, "children": [1], "scale": [1, 2, 3]}, {"mesh": 0, "matrix": [1,0,0,0,0,1,0,0,0,0,1,0,5,0,0,1]}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "mode": 4}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"},
            {"bufferView": 1, "componentType": 5123, "count": 3, "type": "SCALAR",
             "sparse": {"count": 1, "indices": {"bufferView": 1, "componentType": 5123}, "values": {"bufferView": 1}}}],
        "bufferViews": [{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 6}],
        "buffers": [{"byteLength": 42, "uri": "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAABAAIA"}]}"#;
    let without_uri = json.split(", \"uri\"").next().expect("a part").to_owned() + "}]}";
    let without_uri = without_uri.replace(",\n             \"sparse\": {\"count\": 1, \"indices\": {\"bufferView\": 1, \"componentType\": 5123}, \"values\": {\"bufferView\": 1}}", "");
    let mut chunk = without_uri.into_bytes();
    chunk.resize(chunk.len().next_multiple_of(4), b' ');
    let mut buffer: Vec<u8> = [[0f32, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]
        .as_flattened()
        .iter()
        .flat_map(|x| x.to_le_bytes())
        .collect();
    buffer.extend([0, 0, 1, 0, 2, 0, 0, 0]);
    let word = |x: usize| (x as u32).to_le_bytes();
    let glb = [
        b"glTF".as_slice(),
        &word(2),
        &word(28 + chunk.len() + buffer.len()),
        &word(chunk.len()),
        b"JSON",
        &chunk,
        &word(buffer.len()),
        b"BIN\0",
        &buffer,
    ]
    .concat();
    vec![json.as_bytes().to_vec(), glb]
}

fn compressed() -> Vec<Vec<u8>> {
    ["a.obj.gz", "a.ply.xz", "a.stl.gz", "a.obj.xz"].iter().flat_map(|name| mesh_files(name)).collect()
}

/// Reads a mesh and builds a tree of it: what is accepted can be traced.
fn mesh(bytes: &[u8], format: Format) {
    let Ok(file) = formats::read(bytes, Path::new("a"), None, Some(format)) else { return };
    if let Ok(tree) = build(&file.mesh, &BuildOptions::new(Quality::Fast)) {
        let triangles = pack_triangles(&file.mesh, &tree);
        if let Ok(structure) = Structure::convert(StructureKind::Dst, &tree, &triangles) {
            trace(&structure);
        }
    }
}

fn any_mesh(bytes: &[u8]) {
    _ = formats::read(bytes, Path::new("a.obj"), None, None);
}

/// Traces rays along the axes and across them.
fn trace(structure: &Structure) {
    for direction in [[0.01, 0.02, 1.0], [0.0, -1.0, 0.0], [1.0, 0.0, 1e-30]] {
        let ray = golden::Ray::new(direction.map(|x: f32| -9.0 * x), direction);
        for mode in [golden::Mode::Robust, golden::Mode::Fast] {
            _ = golden::traverse::Trace::closest(structure, &ray, mode);
        }
    }
}

fn views() -> Vec<Vec<u8>> {
    [
        "eye = [1, 2.5, 3]\ntarget = [4, 5, 6]\nup = [0, 0, 1]\nfov = 60\n",
        "direction = [0, 0, -1]\nfov = 179.9\n",
    ]
    .map(|text| text.as_bytes().to_vec())
    .to_vec()
}

fn view(bytes: &[u8]) {
    from_file("a.view.toml", bytes, |path| {
        let scene = path.with_file_name("a.obj");
        std::fs::write(&scene, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").expect("a temporary file");
        if let Ok(scene) = Scene::load(&scene, 1.0, 0) {
            _ = render::CameraRays::new(&scene.camera, 4, 4);
        }
    });
}

fn structures() -> Vec<(Scene, Structure)> {
    let scene = small_scene();
    let tree = build(&scene.mesh, &BuildOptions::new(Quality::Fast)).expect("a good mesh");
    let triangles = pack_triangles(&scene.mesh, &tree);
    let convert = |kind| (scene.clone(), Structure::convert(kind, &tree, &triangles).expect("a small tree"));
    StructureKind::ALL.into_iter().map(convert).collect()
}

fn trees() -> Vec<Vec<u8>> {
    structures().iter().map(|(_, structure)| tree_file::to_bytes(structure)).collect()
}

/// Reads a tree whose checksum is right whatever is damaged, and traces it: what is accepted can be traced.
fn tree(bytes: &[u8]) {
    let mut bytes = bytes.to_vec();
    if let Some((contents, checksum)) = bytes.split_last_chunk_mut() {
        *checksum = crc32fast::hash(contents).to_le_bytes();
    }
    if let Ok(structure) = tree_file::from_bytes(&bytes) {
        trace(&structure);
    }
}

fn rendering() -> render::Rendering {
    let (scene, structure) = structures().swap_remove(0);
    let options = RenderOptions { keep_rays: true, count_work: true, ..RenderOptions::new(Test::Path, 6, 4) };
    render(&structure, &scene, &options, |_| {}).expect("a good scene")
}

fn rays() -> Vec<Vec<u8>> {
    let stream = rendering().rays.expect("they are kept");
    ["a.rays", "a.rays.xz"]
        .map(|name| written(name, |path| write_rays(path, &stream, false).expect("a file")))
        .to_vec()
}

fn hits() -> Vec<Vec<u8>> {
    let hits = [None, Some(render::ray_file::FileHit { triangle: 3, t: 0.5 }), None];
    ["a.hits", "a.hits.xz"]
        .map(|name| written(name, |path| write_hits(path, &hits, false).expect("a file")))
        .to_vec()
}

fn machines() -> Vec<Vec<u8>> {
    PRESETS.map(|(_, text)| text.as_bytes().to_vec()).to_vec()
}

/// Reads a machine, and what it would cost.
fn machine(bytes: &[u8]) {
    from_file("a.toml", bytes, |path| {
        if let Ok(machine) = MachineDescription::load(path, &["l1.banks=4".to_owned()]) {
            _ = machine::costs::CacheCosts::new(&machine);
        }
    });
}

/// A library of an inverter, a NAND gate, a buffer and a flip-flop.
fn liberty() -> Vec<Vec<u8>> {
    let tables = "cell_rise (t) { values (\"1, 2\", \"3, 4\"); } cell_fall (t) { values (\"1, 2\", \"3, 4\"); } \
                  rise_transition (t) { values (\"1, 2\", \"3, 4\"); } fall_transition (t) { values (\"1, 2\", \"3, 4\"); }";
    let cell = |name: &str, inputs: &str, function: &str| {
        let pins: String = inputs
            .chars()
            .map(|pin| format!("pin ({pin}) {{ direction : input; capacitance : 0.002; }}\n"))
            .collect();
        let arcs: String = inputs
            .chars()
            .map(|pin| {
                format!("timing () {{ related_pin : \"{pin}\"; timing_sense : negative_unate; {tables} }}\n")
            })
            .collect();
        format!(
            "cell ({name}) {{ area : 2.5;\n{pins}pin (Y) {{ direction : output; function : \"{function}\"; max_capacitance : 0.2;\n{arcs}}} }}\n"
        )
    };
    let flip_flop = format!(
        "cell (dff) {{ area : 9; ff (IQ, IQN) {{ clocked_on : \"CLK\"; next_state : \"D\"; }}\n\
         pin (D) {{ direction : input; capacitance : 0.002; timing () {{ timing_type : setup_rising; related_pin : \"CLK\";\n\
         rise_constraint (t) {{ values (\"1, 2\", \"3, 4\"); }} }} }}\npin (CLK) {{ direction : input; capacitance : 0.003; }}\n\
         pin (Q) {{ direction : output; function : \"IQ\"; timing () {{ timing_type : rising_edge; related_pin : \"CLK\"; {tables} }} }} }}\n"
    );
    let text = format!(
        "/* a library */ library (x) {{ time_unit : \"1ns\"; capacitive_load_unit (1, pf); nom_voltage : 1.2; // volts\n\
         lu_table_template (t) {{ variable_1 : input_net_transition; variable_2 : total_output_net_capacitance;\n\
         index_1 (\"0.01, 0.1\"); index_2 (\"0.001, 0.01\"); }}\n{}{}{}{flip_flop}}}\n",
        cell("inv", "A", "!A"),
        cell("buf", "A", "A"),
        cell("nand", "AB", "!(A*B)")
    );
    vec![text.into_bytes()]
}

fn cells(bytes: &[u8]) {
    let text = String::from_utf8_lossy(bytes).into_owned();
    if let Ok(library) = gates::liberty::read(&[(Path::new("a.lib"), text)]) {
        for cell in &library.cells {
            cell.arcs.iter().for_each(|arc| _ = arc.delay_ns[0].at(0.1, 1.0));
        }
    }
}

/// Pictures in every compression that the library reads.
fn exrs() -> Vec<Vec<u8>> {
    use ::exr::prelude::{Compression, Encoding, Image, SpecificChannels, WritableImage};
    let compressions = [
        Compression::Uncompressed,
        Compression::RLE,
        Compression::ZIP1,
        Compression::PIZ,
        Compression::PXR24,
        Compression::B44,
    ];
    let with = |compression| {
        let pixel = |at: ::exr::math::Vec2<usize>| (at.x() as f32, at.y() as f32, 0.5f32);
        let mut image = Image::from_channels((9, 7), SpecificChannels::rgb(pixel));
        image.layer_data.encoding = Encoding { compression, ..Encoding::FAST_LOSSLESS };
        let mut bytes = std::io::Cursor::new(vec![]);
        image.write().non_parallel().to_buffered(&mut bytes).expect("a complete picture");
        bytes.into_inner()
    };
    compressions.map(with).into_iter().chain([exr::encode(&rendering())]).collect()
}

fn pngs() -> Vec<Vec<u8>> {
    vec![png::encode(&png::develop(&rendering(), 0.0))]
}

/// Reads a picture the checksums of whose chunks are right as far as their lengths are.
fn png_picture(bytes: &[u8]) {
    let mut bytes = bytes.to_vec();
    let mut at = 8; // behind the signature
    while let Some(length) = bytes.get(at..at + 4) {
        let length = u32::from_be_bytes(length.try_into().expect("four bytes")) as usize;
        let end = at + 8 + length;
        if bytes.len() < end + 4 {
            break;
        }
        let checksum = crc32fast::hash(&bytes[at + 4..end]).to_be_bytes();
        bytes[end..end + 4].copy_from_slice(&checksum);
        at = end + 4;
    }
    picture("a.png", &bytes);
}

fn picture(name: &str, bytes: &[u8]) {
    from_file(name, bytes, |path| _ = view::picture::read(path));
}

fn listings() -> Vec<Vec<u8>> {
    [MachineStructure::Dst, MachineStructure::Bvh2]
        .map(|structure| structure.listing(NodeLayout::default()).as_bytes().to_vec())
        .to_vec()
}

fn listing(bytes: &[u8]) {
    let machine = MachineDescription::load(PathBuf::from("trax"), &[]).expect("a preset");
    _ = Program::new("a.s", &String::from_utf8_lossy(bytes), &machine, 8);
}

fn sweeps() -> Vec<Vec<u8>> {
    let text = "scenes = [\"atrium\", \"a.obj\"]\nstructures = \"dst\"\nseeds = [0, 7]\nsizes = \"8x4\"\ndetail = 0.5\n\
                [set]\nl1.size = [\"16KiB\", \"32KiB\"]\n\"tm.threads\" = 16\nclock_ghz = [1.5]\n";
    vec![text.as_bytes().to_vec()]
}
