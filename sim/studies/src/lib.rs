//! The studies behind the commands of the tool. Each command is a function here: it takes plain options, reports its
//! [`progress`], and returns a typed result. The tool parses arguments and prints.
//!
//! | module | question |
//! |---|---|
//! | [`charts`] | What does a cost buy, over formats and over levels of simulation? |
//! | [`fidelity`] | How long does a frame take, as closely as needed? |
//! | [`stress`](mod@stress) | Which methods lose hits, and where? |
//! | [`needs`] | What is the least hardware for a scene? |
//! | [`walk`] | What does the traversal of one ray do, step by step? |
//! | [`drive`] | Which inputs do a scene's rays give to each unit? |
//! | [`study`] | Which structure is fastest on the machine, and does it agree with the published results? |
//! | [`sweep`] | The same question for any lists of scenes, structures and machines, on many hosts. |
//! | [`estimation`] | What do the pipelines cost? |
//! | [`reproduce`] | All of it, on one page. |
//!
//! ```
//! use golden::build::{BuildOptions, Quality, build};
//! use golden::structure::{Structure, StructureKind, pack_triangles};
//! use golden::{Mode, Ray, TraversalRay};
//! use studies::walk::walk;
//!
//! let scene = scenes::procedural::build("statue", 0.0005, 0)?;
//! let tree = build(&scene.mesh, &BuildOptions::new(Quality::Fast))?;
//! let triangles = pack_triangles(&scene.mesh, &tree);
//! let dst = Structure::convert(StructureKind::Dst, &tree, &triangles)?;
//! let (eye, target) = (scene.camera.eye, scene.camera.target);
//! let ray = Ray::new(eye, std::array::from_fn(|axis| target[axis] - eye[axis]));
//! let walk = walk(&dst, &TraversalRay::new(&ray, Mode::Robust).expect("the camera looks somewhere"));
//! println!("{} steps to {:?}", walk.steps.len(), walk.hit);
//! assert!(walk.steps.len() > 1);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod artifacts;
pub mod charts;
pub mod check;
pub mod compare;
pub mod drive;
pub mod estimation;
pub mod explain;
pub mod export;
pub mod fidelity;
pub mod input;
pub mod kernel;
pub mod needs;
pub mod picture;
pub mod progress;
pub mod prove;
pub mod reproduce;
pub mod simulate;
pub mod stress;
pub mod study;
pub mod sweep;
pub mod table;
pub mod trace;
pub mod trees;
pub mod walk;
pub mod wave;
pub mod work;
