//! The same picture from every structure and on any number of threads.

use super::*;
use golden::build::{BinaryTree, BuildOptions, Quality, build};
use golden::structure::{Structure, StructureKind, pack_triangles};
use scenes::{Mesh, PointLight};

/// An octahedron over a floor of large triangles.
fn scene() -> Scene {
    let mut mesh = Mesh::default();
    let mut add = |corners: [[f32; 3]; 3]| {
        let first = mesh.positions.len() as u32;
        mesh.positions.extend(corners);
        mesh.triangles.push([first, first + 1, first + 2]);
    };
    for octant in 0..8 {
        let [x, y, z] = [0, 1, 2].map(|axis| if octant >> axis & 1 == 0 { 1.0 } else { -1.0 });
        add([[0.7 * x, 0.0, 0.0], [0.0, y, 0.0], [0.0, 0.0, 0.9 * z]]);
    }
    add([[-9.0, -1.0, -9.0], [-9.0, -1.0, 9.0], [9.0, -1.0, -9.0]]);
    add([[9.0, -1.0, 9.0], [9.0, -1.0, -9.0], [-9.0, -1.0, 9.0]]);
    Scene {
        name: "octahedron".to_owned(),
        mesh,
        camera: scenes::Camera {
            eye: [1.0, 1.5, 4.0],
            target: [0.0, -0.2, 0.0],
            up: [0.0, 1.0, 0.0],
            fov_y_degrees: 50.0,
        },
        light: PointLight { position: [2.0, 4.0, 2.0], intensity: [40.0, 36.0, 30.0] },
    }
}

fn tree(scene: &Scene) -> BinaryTree {
    build(&scene.mesh, &BuildOptions::new(Quality::Fast)).unwrap()
}

fn structure(scene: &Scene, kind: StructureKind) -> Structure {
    let tree = tree(scene);
    Structure::convert(kind, &tree, &pack_triangles(&scene.mesh, &tree)).unwrap()
}

fn options(test: Test) -> RenderOptions {
    RenderOptions { samples: 3, count_work: true, keep_rays: true, ..RenderOptions::new(test, 48, 32) }
}

fn rendering(scene: &Scene, kind: StructureKind, options: &RenderOptions) -> Rendering {
    render(&structure(scene, kind), scene, options, |_| {}).unwrap()
}

/// Everything but the work, which differs between structures.
fn bits(rendering: &Rendering) -> Vec<u32> {
    let pixel = |p: &Pixel| {
        let [nx, ny, nz] = p.normal;
        let [r, g, b] = p.rgb;
        [r, g, b, p.depth, nx, ny, nz].map(f32::to_bits).into_iter().chain([p.triangle]).collect::<Vec<_>>()
    };
    rendering.pixels.iter().flat_map(pixel).collect()
}

#[test]
fn all_structures_give_the_same_picture() {
    let scene = scene();
    for test in Test::ALL {
        for mode in [Mode::Fast, Mode::Robust] {
            let options = RenderOptions { mode, ..options(test) };
            let first = rendering(&scene, StructureKind::ALL[0], &options);
            for kind in &StructureKind::ALL[1..] {
                let other = rendering(&scene, *kind, &options);
                assert!(bits(&first) == bits(&other), "{kind} {test}");
                assert_eq!(first.rays, other.rays);
                assert_ne!(first.total().counters, other.total().counters);
                // The kernels that do not count find the same.
                let fast = rendering(&scene, *kind, &RenderOptions { count_work: false, ..options });
                assert!(bits(&first) == bits(&fast), "{kind} {test}");
                assert!(fast.pixels.iter().all(|p| p.work == Work::default()));
            }
        }
    }
}

#[test]
fn any_number_of_threads_gives_the_same_result() {
    let scene = scene();
    let options = options(Test::Path);
    let on = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| rendering(&scene, StructureKind::Dst, &options))
    };
    let one = on(1);
    for threads in [2, 3, 7] {
        assert!(one == on(threads), "{threads} threads");
    }
}

#[test]
fn the_stream_is_the_rays_that_were_traced() {
    let scene = scene();
    let structure = structure(&scene, StructureKind::Dst);
    let options = options(Test::Path);
    let rendering = render(&structure, &scene, &options, |_| {}).unwrap();
    let stream = rendering.rays.as_ref().unwrap();
    assert_eq!(stream.rays.len() as u64, rendering.total().rays);
    assert_eq!(stream.primary_rays(), 48 * 32 * 3);
    let classes: Vec<_> = rendering.classes().collect();
    assert_eq!(classes.len(), stream.waves.len());
    for ((class, rays), (expected, totals)) in stream.by_wave().zip(classes) {
        assert_eq!(class, expected);
        assert_eq!(rays.len() as u64, totals.rays);
        let shadow = matches!(class, RayClass::Shadow { .. });
        let is_hit = |ray: &&golden::Ray| match shadow {
            true => structure.occluded(ray, options.mode),
            false => structure.closest(ray, options.mode).is_some(),
        };
        assert_eq!(rays.iter().filter(is_hit).count() as u64, totals.hits, "{class}");
    }
    let hits = |class| rendering.classes().find(|(c, _)| *c == class).unwrap().1.hits;
    let rays = |class| rendering.classes().find(|(c, _)| *c == class).unwrap().1.rays;
    assert_eq!(hits(RayClass::Primary), rays(RayClass::Diffuse { bounce: 1 }));
    assert_eq!(
        hits(RayClass::Diffuse { bounce: 1 }),
        rays(RayClass::Diffuse { bounce: 2 }),
        "a bounce leaves every hit"
    );
}

#[test]
fn pixels_one_by_one_are_those_of_the_picture() {
    let scene = scene();
    let structure = structure(&scene, StructureKind::Bvh2);
    let options = RenderOptions { keep_rays: false, ..options(Test::Path) };
    let picture = render(&structure, &scene, &options, |_| {}).unwrap();
    let renderer = PixelRenderer::new(&scene, &options).unwrap();
    assert_eq!(renderer.frame().bounces, DIFFUSE_BOUNCES);
    let mut total = 0;
    for (i, expected) in (0..).zip(&picture.pixels) {
        let place = [i % options.width, i / options.width];
        let (pixel, rays) = renderer.pixel(&structure, place);
        assert_eq!(&pixel, expected);
        assert!(rays >= u64::from(options.samples));
        total += rays;
    }
    assert_eq!(total, picture.total().rays);
}

/// Every length of the scene times a power of two, up to where squares and cubes of lengths leave binary32.
#[test]
fn a_picture_does_not_depend_on_the_unit_of_length() {
    let scene = scenes::procedural::build("atrium", 0.002, 0).unwrap();
    let options = RenderOptions { samples: 2, ..RenderOptions::new(Test::Path, 32, 32) };
    let first = rendering(&scene, StructureKind::Bvh2, &options);
    let scales = [20, -20, 66, -70, 100, -90];
    for (exponent, kind) in scales.into_iter().zip(StructureKind::ALL.into_iter().cycle()) {
        let scale = 2f32.powi(exponent);
        let mut scaled = scene.clone();
        scaled.mesh.positions.iter_mut().flatten().for_each(|x| *x *= scale);
        let (camera, light) = (&mut scaled.camera, &mut scaled.light);
        let lengths = camera.eye.iter_mut().chain(&mut camera.target).chain(&mut light.position);
        lengths.for_each(|x| *x *= scale);
        light.intensity.iter_mut().for_each(|channel| *channel *= f64::from(scale).powi(2));
        let other = rendering(&scaled, kind, &options);
        for (a, b) in first.pixels.iter().zip(&other.pixels) {
            assert_eq!((a.rgb, a.normal, a.triangle), (b.rgb, b.normal, b.triangle), "2^{exponent}");
            assert_eq!(a.depth * scale, b.depth, "2^{exponent}");
        }
    }
    assert!(first.pixels.iter().any(|pixel| pixel.rgb != first.pixels[0].rgb));
}

/// A floor lit from straight above has a radiance that can be written down.
#[test]
fn direct_light_is_lambert() {
    let mut scene = scene();
    scene.light = PointLight { position: [0.0, 3.0, 0.0], intensity: [8.0, 4.0, 2.0] };
    scene.camera.eye = [0.0, 5.0, 0.0];
    scene.camera.target = [5.0, -1.0, 0.0];
    let options = RenderOptions::new(Test::Raycast, 1, 1);
    let rendering = rendering(&scene, StructureKind::Bvh2, &options);
    let pixel = rendering.pixels[0];
    assert_eq!(pixel.normal, [0.0, 1.0, 0.0]);
    assert!((pixel.depth - 61f32.sqrt()).abs() < 1e-5);
    // 4 below and 5 beside the light.
    let irradiance = 8.0 * 4.0 / 41f64.powf(1.5);
    let expected = f64::from(ALBEDO) / std::f64::consts::PI * irradiance;
    assert!((f64::from(pixel.rgb[0]) / expected - 1.0).abs() < 1e-4, "{pixel:?} {expected}");
    assert_eq!(pixel.rgb[0], 2.0 * pixel.rgb[1]);
}

#[test]
fn a_miss_shows_the_background() {
    let mut scene = scene();
    scene.camera.target = [1.0, 9.0, 4.5];
    let options = RenderOptions { background: [0.5, 0.25, 1.0], ..RenderOptions::new(Test::Path, 3, 3) };
    for pixel in rendering(&scene, StructureKind::Dst, &options).pixels {
        assert_eq!((pixel.rgb, pixel.triangle), ([0.5, 0.25, 1.0], Pixel::NO_TRIANGLE));
        assert_eq!((pixel.depth, pixel.normal), (f32::INFINITY, [0.0; 3]));
    }
}

#[test]
fn the_seed_matters_and_the_first_sample_does_not_jitter() {
    let scene = scene();
    let with = |seed, samples| {
        let options = RenderOptions { seed, samples, ..options(Test::Path) };
        rendering(&scene, StructureKind::Dst, &options)
    };
    assert!(bits(&with(0, 2)) != bits(&with(1, 2)));
    let triangles = |r: Rendering| r.pixels.iter().map(|p| p.triangle).collect::<Vec<_>>();
    assert_eq!(triangles(with(0, 1)), triangles(with(9, 4)));
}

#[test]
fn options_out_of_range() {
    let scene = scene();
    let structure = structure(&scene, StructureKind::Bvh2);
    let good = RenderOptions::new(Test::Path, 8, 8);
    let error = |scene: &Scene, options| render(&structure, scene, &options, |_| {}).unwrap_err();
    for (width, height) in [(0, 8), (8, 0), (MAX_SIDE + 1, 8), (8192, 8193)] {
        let bad = RenderOptions { width, height, ..good };
        assert_eq!(error(&scene, bad), RenderError::Size { width, height });
    }
    assert_eq!(error(&scene, RenderOptions { samples: 0, ..good }), RenderError::Samples(0));
    let many = RenderOptions { width: 8192, height: 8192, samples: 8, keep_rays: true, ..good };
    assert!(matches!(error(&scene, many), RenderError::TooManyRays(_)));
    let mut far = scene.clone();
    far.light.position[1] = -MAX_LIGHT_COORDINATE;
    assert!(render(&structure, &far, &good, |_| {}).is_ok());
    far.light.position[1] = (-MAX_LIGHT_COORDINATE).next_down();
    assert_eq!(error(&far, good), RenderError::LightTooFar(far.light.position));
    let background = [f32::NAN; 3];
    assert!(matches!(error(&scene, RenderOptions { background, ..good }), RenderError::NotFinite { .. }));
    let mut dark = scene.clone();
    dark.camera.fov_y_degrees = 0.0;
    assert_eq!(error(&dark, good), RenderError::Camera(CameraError::Fov(0.0)));
}
