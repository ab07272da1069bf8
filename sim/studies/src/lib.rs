//! What is found out with the crates of dualsplit. Each study computes a result and prints nothing; the tool prints it.
//!
//! | module | question |
//! |---|---|
//! | [`charts`] | What does a cost buy, over formats and over levels of simulation? |
//! | [`fidelity`] | How long does a frame take, as closely as needed? |
//! | [`stress`](mod@stress) | Which methods lose hits, and where? |
//! | [`needs`] | What is the least hardware for a scene? |
//! | [`walk`] | What does the traversal of one ray do, step by step? |
//! | [`drive`] | Which inputs do a scene's rays give to each unit? |
//!
//! ```
//! use golden::build::{BuildOptions, Quality, build};
//! use golden::dst::Dst;
//! use golden::structure::pack_triangles;
//! use golden::{Mode, Ray, TraversalRay};
//! use studies::walk::walk_dst;
//!
//! let scene = scenes::procedural::build("statue", 0.0005, 0)?;
//! let tree = build(&scene.mesh, &BuildOptions::new(Quality::Fast))?;
//! let dst = Dst::convert(&tree, pack_triangles(&scene.mesh, &tree))?;
//! let (eye, target) = (scene.camera.eye, scene.camera.target);
//! let ray = Ray::new(eye, std::array::from_fn(|axis| target[axis] - eye[axis]));
//! let walk = walk_dst(&dst, &TraversalRay::new(&ray, Mode::Robust).expect("the camera looks somewhere"));
//! println!("{} steps to {:?}", walk.steps.len(), walk.hit);
//! assert!(walk.steps.len() > 1);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod charts;
pub mod drive;
pub mod fidelity;
pub mod needs;
pub mod stress;
pub mod walk;
