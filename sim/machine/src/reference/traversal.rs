//! The traversal of the reference runs, bit for bit, as events of its program.

use super::scene::{NODE_WORDS, RAY_WORDS, RESULT_WORDS, RaySet, ReferenceScene, TRIANGLE_WORDS};
use crate::core::{Tape, Work};
use crate::program::{Conditions, EntryId, Program};

/// A set of rays as work for the machine.
pub struct ReferenceWork<'a> {
    scene: &'a ReferenceScene,
    rays: &'a RaySet,
    any: bool,
    names: Names,
}

/// Entry points, conditions and addresses of the program.
struct Names {
    ray: EntryId,
    node: EntryId,
    pop: EntryId,
    triangle: EntryId,
    leaf: Conditions,
    hit: [Conditions; 2],
    empty: Conditions,
    beyond: Conditions,
    last: Conditions,
    found: Conditions,
    outside: [Conditions; 4],
    ray_address: u8,
    node_address: u8,
    children: u8,
    triangle_address: u8,
    result: u8,
}

impl Names {
    fn new(program: &Program) -> Self {
        let address = |name| program.base(name).unwrap_or_else(|| panic!("no address `{name}`"));
        Self {
            ray: program.entry("ray"),
            node: program.entry("node"),
            pop: program.entry("pop"),
            triangle: program.entry("triangle"),
            leaf: program.condition("leaf"),
            hit: ["hit_left", "hit_right"].map(|name| program.condition(name)),
            empty: program.condition("empty"),
            beyond: program.condition("beyond"),
            last: program.condition("last"),
            found: program.condition("found"),
            outside: ["u_below", "u_above", "v_below", "v_above"].map(|name| program.condition(name)),
            ray_address: address("ray"),
            node_address: address("node"),
            children: address("children"),
            triangle_address: address("triangle"),
            result: address("result"),
        }
    }
}

/// What a triangle test comes to: outside by one of the four tests, or a distance.
enum Test {
    Outside(usize),
    Inside(f32),
}

/// Entries of the stack; the trees of the reference runs are not deeper.
const STACK: usize = 64;

impl<'a> ReferenceWork<'a> {
    /// `rays` through `scene`; with `any` each ends after the first leaf that is hit.
    ///
    /// # Panics
    /// If `program` is not one of this module's.
    pub fn new(program: &Program, scene: &'a ReferenceScene, rays: &'a RaySet, any: bool) -> Self {
        Self { scene, rays, any, names: Names::new(program) }
    }

    /// Traces ray `item` and reports its events; returns the bits of the distance, and the triangle or -1.
    ///
    /// # Panics
    /// If the tree is deeper than the program's stack.
    pub fn trace(&self, item: u32, event: &mut impl Events) -> (u32, i32) {
        let scene = self.scene;
        let [ox, oy, oz, t_min, dx, dy, dz, t_max] = self.rays.rays[item as usize];
        let (origin, direction) = ([ox, oy, oz], [dx, dy, dz]);
        let inverse = direction.map(|d| 1.0 / d);
        let names = &self.names;
        event.address(names.ray_address, self.rays.rays_at + item * RAY_WORDS);
        event.event(names.ray, 0);
        let (mut t, mut hit) = (t_max, None);
        let mut stack = [(0u32, 0f32); STACK];
        let mut depth = 0;
        let mut node = 0;
        'traversal: loop {
            event.address(names.node_address, scene.nodes_at + node * NODE_WORDS);
            let (count, child) = scene.node(node);
            if count < 0 {
                event.address(names.children, scene.nodes_at + child * NODE_WORDS);
                let left = slab(scene.bounds(child), origin, inverse, t);
                let right = slab(scene.bounds(child + 1), origin, inverse, t);
                let hits = [left.0 <= left.1, right.0 <= right.1];
                let conditions =
                    if hits[0] { names.hit[0] } else { 0 } | if hits[1] { names.hit[1] } else { 0 };
                event.event(names.node, conditions);
                match hits {
                    [true, true] => {
                        let (near, far) = if right.0 < left.0 {
                            (child + 1, (child, left.0))
                        } else {
                            (child, (child + 1, right.0))
                        };
                        stack[depth] = far;
                        depth += 1;
                        node = near;
                        continue;
                    }
                    [true, false] => {
                        node = child;
                        continue;
                    }
                    [false, true] => {
                        node = child + 1;
                        continue;
                    }
                    [false, false] => {}
                }
            } else {
                event.event(names.node, names.leaf);
                for k in 0..count as u32 {
                    let address = child + k * TRIANGLE_WORDS;
                    event.address(names.triangle_address, address);
                    let mut conditions = if k + 1 == count as u32 { names.last } else { 0 };
                    match triangle(&scene.corners(address), origin, direction) {
                        Test::Outside(test) => conditions |= names.outside[test],
                        Test::Inside(distance) => {
                            if distance > t_min && distance < t {
                                (t, hit) = (distance, Some(address));
                            }
                        }
                    }
                    let ends = self.any && hit.is_some() && k + 1 == count as u32;
                    if ends {
                        event.address(names.result, self.rays.results_at + item * RESULT_WORDS);
                        conditions |= names.found;
                    }
                    event.event(names.triangle, conditions);
                    if ends {
                        break 'traversal;
                    }
                }
            }
            loop {
                if depth == 0 {
                    event.address(names.result, self.rays.results_at + item * RESULT_WORDS);
                    event.event(names.pop, names.empty);
                    break 'traversal;
                }
                depth -= 1;
                let (next, entry) = stack[depth];
                if entry < t {
                    event.event(names.pop, 0);
                    node = next;
                    break;
                }
                event.event(names.pop, names.beyond);
            }
        }
        let triangle = hit.map_or(-1, |address| ((address - scene.triangles_at) / TRIANGLE_WORDS) as i32);
        (t.to_bits(), triangle)
    }
}

/// Receives events.
pub trait Events {
    /// An address of the program, in words.
    fn address(&mut self, base: u8, word: u32);
    /// The thread goes on from an entry point under conditions.
    fn event(&mut self, at: EntryId, conditions: Conditions);
}

/// Receives events and forgets them.
pub struct NoEvents;

impl Events for NoEvents {
    fn address(&mut self, _base: u8, _word: u32) {}
    fn event(&mut self, _at: EntryId, _conditions: Conditions) {}
}

impl Events for Tape<'_> {
    #[inline(always)]
    fn address(&mut self, base: u8, word: u32) {
        Tape::address(self, base, word);
    }

    #[inline(always)]
    fn event(&mut self, at: EntryId, conditions: Conditions) {
        Tape::event(self, at, conditions);
    }
}

impl Work for ReferenceWork<'_> {
    fn items(&self) -> u32 {
        self.rays.rays.len() as u32
    }

    fn record(&self, item: u32, tape: &mut Tape<'_>) {
        self.trace(item, tape);
    }
}

fn minimum(a: f32, b: f32) -> f32 {
    if a < b { a } else { b }
}

fn maximum(a: f32, b: f32) -> f32 {
    if a > b { a } else { b }
}

/// Entry and exit of a box within `0..=t`.
#[inline(always)]
fn slab(bounds: [f32; 6], origin: [f32; 3], inverse: [f32; 3], t: f32) -> (f32, f32) {
    let at = |k: usize| (bounds[k] - origin[k % 3]) * inverse[k % 3];
    let (low, high): ([f32; 3], [f32; 3]) = (
        std::array::from_fn(|k| minimum(at(k), at(k + 3))),
        std::array::from_fn(|k| maximum(at(k), at(k + 3))),
    );
    let entry = maximum(maximum(maximum(low[0], low[1]), low[2]), 0.0);
    let exit = minimum(minimum(minimum(high[0], high[1]), high[2]), t);
    (entry, exit)
}

/// Moeller and Trumbore's test relative to the third corner, with one division.
#[inline(always)]
fn triangle([a, b, c]: &[[f32; 3]; 3], origin: [f32; 3], direction: [f32; 3]) -> Test {
    let minus = |p: [f32; 3], q: &[f32; 3]| [p[0] - q[0], p[1] - q[1], p[2] - q[2]];
    let cross = |p: [f32; 3], q: [f32; 3]| {
        [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]]
    };
    let dot = |p: [f32; 3], q: [f32; 3]| p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
    let (edge0, edge1) = (minus(*a, c), minus(*b, c));
    let p = cross(direction, edge1);
    let inverse = 1.0 / dot(edge0, p);
    let s = minus(origin, c);
    let u = dot(s, p) * inverse;
    if u < 0.0 {
        return Test::Outside(0);
    }
    if u > 1.0 {
        return Test::Outside(1);
    }
    let q = cross(s, edge0);
    let v = dot(direction, q) * inverse;
    if v < 0.0 {
        return Test::Outside(2);
    }
    if u + v > 1.0 {
        return Test::Outside(3);
    }
    Test::Inside(dot(edge1, q) * inverse)
}
