//! A many-core machine of the TRaX class, timed cycle by cycle.
//!
//! | module | what it holds |
//! |---|---|
//! | [`description`] | what the machine consists of, as a TOML file |
//! | [`program`] | the programs of the threads: straight runs of instructions with their units, dependences and addresses |
//! | [`execute`] | what the programs compute: registers, local store, global memory, the machine's own operations |
//! | [`core`] | the timing of the runs that were executed |
//! | [`kernels`] | the programs' sources and listings, for those who write their own |
//! | [`mod@frame`] | the pixels of a frame as work for the threads |
//! | [`pipelines`], [`costs`] | what a pipeline takes of a multiprocessor's units; area and energy of the rest |
//! | [`results`] | counts, times, energies and areas, with units |
//! | [`mod@reference`] | the runs of the public simulator, for validation |
//!
//! The programs compute the picture, and golden checks it. The timing core gets the runs that were executed, and computes nothing
//! itself. `docs/machine.md` describes the model.
//!
//! ```
//! use golden::build::{BuildOptions, Quality, build};
//! use golden::structure::{Structure, StructureKind, pack_triangles};
//! use machine::description::MachineDescription;
//! use machine::frame::{FrameMachine, MachineStructure, frame};
//! use render::{RenderOptions, Test};
//!
//! let scene = scenes::procedural::build("statue", 0.0005, 0)?;
//! let tree = build(&scene.mesh, &BuildOptions::new(Quality::Fast))?;
//! let dst = Structure::convert(StructureKind::Dst, &tree, &pack_triangles(&scene.mesh, &tree))?;
//!
//! let settings = ["chip.l2_partitions=1".to_owned(), "chip.tms_per_partition=1".to_owned()];
//! let description = MachineDescription::load("trax", &settings)?;
//! // The program that decodes nodes in software needs no pipeline.
//! let machine = FrameMachine::new(&description, MachineStructure::DstSoftware, |_| unreachable!())?;
//! let frame = frame(&machine, &scene, &dst, &RenderOptions::new(Test::Raycast, 8, 8), |_pixels| ())?;
//! assert_eq!(frame.pixels.len(), 64);
//! println!("{} rays took {} cycles", frame.rays, frame.counts.cycles);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod core;
pub mod costs;
pub mod description;
pub mod execute;
pub mod frame;
pub mod kernels;
pub mod pipelines;
pub mod program;
pub mod queueing;
pub mod reference;
pub mod results;
