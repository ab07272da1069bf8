//! A set of rays as work for the machine, by the program that was written after the reference's.

use super::scene::{RESULT_WORDS, RaySet, ReferenceScene};
use crate::core::{Tape, Work};
use crate::execute::{Executor, Fault, Memory, Special};
use crate::kernels::parameter;
use crate::program::{EntryId, Program};
use std::sync::Arc;

/// A set of rays as work for the machine.
pub struct ReferenceWork<'a> {
    executor: Executor<NoSamples>,
    scene: &'a ReferenceScene,
    rays: &'a RaySet,
}

/// Golden's operations; the program asks for no sample.
struct NoSamples;

impl Special for NoSamples {
    fn random(&self, _item: u32, _dimension: u32) -> f32 {
        0.0
    }
}

impl<'a> ReferenceWork<'a> {
    /// `rays` through `scene`.
    ///
    /// # Errors
    /// What the program does wrong.
    pub fn new(
        program: Arc<Program>,
        scene: &'a ReferenceScene,
        rays: &'a RaySet,
    ) -> Result<Self, Box<Fault>> {
        let count = rays.rays.len() as u32;
        let results = rays.results_at..rays.results_at + count * RESULT_WORDS;
        let mut words = vec![];
        let mut put = |at: u32, part: &[u32]| {
            let end = at as usize + part.len();
            words.resize(words.len().max(end), 0);
            words[at as usize..end].copy_from_slice(part);
        };
        let ray_words: Vec<u32> = rays.rays.as_flattened().iter().map(|word| word.to_bits()).collect();
        put(results.start, &vec![0; results.len()]);
        put(rays.rays_at, &ray_words);
        let (nodes, triangles) = scene.parts();
        put(scene.nodes_at, nodes);
        put(scene.triangles_at, triangles);
        for (number, value) in [
            (parameter::RAYS, count),
            (parameter::OUT, rays.results_at),
            (parameter::NODES, scene.nodes_at),
            (parameter::TRIANGLES, scene.triangles_at),
            (parameter::RAY_BASE, rays.rays_at),
        ] {
            words[number] = value;
        }
        let executor = Executor::new(program, Memory::new(words, results), NoSamples, count)?;
        Ok(Self { executor, scene, rays })
    }

    /// Rays whose result is not the reference's, bit for bit, after all have been executed.
    #[must_use]
    pub fn mismatches(&self) -> u64 {
        let differs = |(at, (t, triangle)): &(u32, (u32, i32))| {
            let [found_t, found] = [0, 1].map(|word| self.executor.memory().written(at + word));
            let found = found.map(|word| match word {
                u32::MAX => -1,
                address => self.scene.triangle_at(address).map_or(-2, |number| number as i32),
            });
            found != Some(*triangle) || *triangle >= 0 && found_t != Some(*t)
        };
        let places = (self.rays.results_at..).step_by(RESULT_WORDS as usize);
        places.zip(self.rays.hits.iter().copied()).filter(differs).count() as u64
    }
}

impl Work for ReferenceWork<'_> {
    fn items(&self) -> u32 {
        self.executor.items()
    }

    fn entries(&self) -> Option<(EntryId, EntryId)> {
        self.executor.entries()
    }

    fn start(&self, tape: &mut Tape<'_>) -> Result<(), Box<Fault>> {
        self.executor.start(tape)
    }

    fn record(&self, item: u32, entry: EntryId, tape: &mut Tape<'_>) -> Result<(), Box<Fault>> {
        self.executor.record(item, entry, tape).map(|_exact_tests| ())
    }
}
