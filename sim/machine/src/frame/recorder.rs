//! Records the rays of one pixel.

use super::checker::Checker;
use super::layout::Layout;
use super::names::Names;
use super::recording::{Query, State, Totals};
use super::walk;
use crate::core::Tape;
use golden::precision::NarrowDst;
use golden::structure::Structure;
use golden::traverse::{Observer, Trace};
use golden::{Hit, TraversalRay};
use std::sync::Mutex;

/// What rays are traced through.
#[derive(Clone, Copy)]
pub enum Traced<'a> {
    /// In binary32.
    Wide(&'a Structure),
    /// A dual-split tree in a narrower format.
    Narrow(&'a NarrowDst),
}

/// Traces through a golden structure by golden steps, and records what the program does.
pub struct Recorder<'a, 'tape, 'words> {
    traced: Traced<'a>,
    state: Mutex<State<'a, 'tape, 'words>>,
}

impl<'a, 'tape, 'words> Recorder<'a, 'tape, 'words> {
    pub fn new(
        traced: Traced<'a>,
        names: &'a Names,
        layout: &'a Layout,
        checker: Option<&'a dyn Checker>,
        tape: &'tape mut Tape<'words>,
    ) -> Self {
        Self { traced, state: Mutex::new(State::new(names, layout, checker, tape)) }
    }

    /// The pixel's address.
    pub fn pixel(&self, word: u32) {
        let mut state = self.state.lock().expect("no panic while it was held");
        let base = state.names.pixel;
        state.tape.address(base, word);
    }

    /// Ends the pixel.
    pub fn finish(self) -> Totals {
        let mut state = self.state.into_inner().expect("no panic while it was held");
        let last_bounce = state.names.last_bounce;
        state.go_on(last_bounce);
        state.totals
    }

    fn trace(&self, ray: &TraversalRay, any: bool) -> Option<Hit> {
        let mut state = self.state.lock().expect("no panic while it was held");
        // A shadow ray is cast if the light is above the surface; another ray if not, or after a shadow ray.
        let how = if any { state.names.lit } else { 0 };
        state.go_on(how);
        state.totals.rays += 1;
        match self.traced {
            Traced::Narrow(dst) => {
                let mut query = Query::new(ray, any, &dst.structure.triangles);
                walk::narrow_dst(dst, &mut query, &mut state);
                query.hit()
            }
            Traced::Wide(Structure::Dst(dst)) => {
                let mut query = Query::new(ray, any, &dst.triangles);
                walk::dst(dst, &mut query, &mut state);
                query.hit()
            }
            Traced::Wide(Structure::Bvh2(bvh)) => {
                let mut query = Query::new(ray, any, &bvh.triangles);
                walk::bvh2(bvh, &mut query, &mut state);
                query.hit()
            }
            Traced::Wide(Structure::Bvh4(bvh)) => {
                let mut query = Query::new(ray, any, &bvh.triangles);
                walk::wide(bvh, &mut query, &mut state);
                query.hit()
            }
            Traced::Wide(Structure::Bvh8(bvh)) => {
                let mut query = Query::new(ray, any, &bvh.triangles);
                walk::wide(bvh, &mut query, &mut state);
                query.hit()
            }
            Traced::Wide(other) => panic!("the machine has no program for {}", other.kind()),
        }
    }
}

impl Trace for Recorder<'_, '_, '_> {
    fn closest_prepared<O: Observer>(&self, ray: &TraversalRay, _observer: &mut O) -> Option<Hit> {
        self.trace(ray, false)
    }

    fn occluded_prepared<O: Observer>(&self, ray: &TraversalRay, _observer: &mut O) -> bool {
        self.trace(ray, true).is_some()
    }
}
