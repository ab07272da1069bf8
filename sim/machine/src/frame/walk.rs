//! Traversal by the golden steps, in the golden order, as events.

use super::recording::{Query, State};
use fp::minimum_number;
use golden::build::MAX_DEPTH;
use golden::bvh::{BoxStep, Bvh, Bvh2, BvhNode, LEAF, box_step};
use golden::dst::header::Header;
use golden::dst::{Child, Code, Dst, Step, step};
use golden::precision::NarrowDst;
use golden::ray::PlaneDistances;

/// Tests the root's box: entry and exit distance. If the ray misses it, the ray ends here.
fn enter(
    query: &Query<'_>,
    state: &mut State<'_, '_, '_>,
    root: &golden::Aabb,
    leaf: bool,
) -> Option<[f32; 2]> {
    let test = box_step(root, query.ray, query.ray.t_min, query.ray.t_max);
    entered(test, query, state, leaf)
}

fn entered(test: BoxStep, query: &Query<'_>, state: &mut State<'_, '_, '_>, leaf: bool) -> Option<[f32; 2]> {
    let names = state.names;
    if !test.hit {
        state.end(query, names.ray, names.root_missed);
        return None;
    }
    state.event(names.ray, if leaf { names.leaf } else { 0 });
    Some([test.t_entry, test.t_exit])
}

/// Takes entries from the stack until one begins before the best hit, which is at `nearest`. If there is none, the ray ends
/// here.
fn pop<T: Copy>(
    stack: &mut Vec<T>,
    t_entry: impl Fn(&T) -> f32,
    is_leaf: impl Fn(&T) -> bool,
    nearest: f32,
    query: &Query<'_>,
    state: &mut State<'_, '_, '_>,
) -> Option<T> {
    let names = state.names;
    loop {
        let Some(next) = stack.pop() else {
            state.end(query, names.pop, names.empty);
            return None;
        };
        if t_entry(&next) > nearest {
            state.event(names.pop, names.beyond);
            continue;
        }
        state.event(names.pop, if is_leaf(&next) { names.leaf } else { 0 });
        return Some(next);
    }
}

/// A dual-split tree, node by node.
pub fn dst(dst: &Dst, query: &mut Query<'_>, state: &mut State<'_, '_, '_>) {
    let ray = query.ray;
    let rtl =
        |words, here: &Child, step: &Step, state: &mut State<'_, '_, '_>| state.step(words, ray, here, step);
    dst_of(dst, ray, [ray.t_min, ray.t_max], (|t| t, rtl), query, state);
}

/// A dual-split tree in a narrower format, node by node.
pub fn narrow_dst(dst: &NarrowDst, query: &mut Query<'_>, state: &mut State<'_, '_, '_>) {
    let ray = dst.ray(query.ray);
    dst_of(
        &dst.structure,
        &ray,
        [ray.t_min, ray.t_max],
        (|t| ray.limit(t), |_, _: &_, _: &_, _: &mut _| {}),
        query,
        state,
    );
}

/// Traverses with `ray`, the query's ray in the format of the tree. `limit` converts the distance of a hit to what intervals are
/// compared with. `stepped` is called for every step.
fn dst_of(
    dst: &Dst,
    ray: &impl PlaneDistances,
    [t_min, t_max]: [f32; 2],
    (limit, stepped): (impl Fn(f32) -> f32, impl Fn([u32; 3], &Child, &Step, &mut State<'_, '_, '_>)),
    query: &mut Query<'_>,
    state: &mut State<'_, '_, '_>,
) {
    let root = box_step(&dst.root_box, ray, t_min, t_max);
    let Some([t_min, t_max]) = entered(root, query, state, false) else {
        return;
    };
    let names = state.names;
    let mut stack: Vec<Child> = Vec::with_capacity(MAX_DEPTH as usize);
    let mut here = Child { offset: 0, t_min, t_max };
    loop {
        let words = dst.node(here.offset);
        let outcome = step(words, ray, here.t_min, here.t_max);
        stepped(words, &here, &outcome, state);
        state.tape.address(names.node_address, state.layout.nodes_at + here.offset);
        let conditions = if names.decodes {
            decoding(words, ray, here, outcome.code, state)
        } else {
            match outcome.code {
                Code::Miss => names.missed,
                Code::One => names.one,
                Code::Two => 0,
                Code::Leaf => names.leaf,
            }
        };
        state.event(names.node, conditions);
        match outcome.code {
            Code::Two => {
                stack.push(outcome.far);
                here = outcome.near;
                continue;
            }
            Code::One => {
                here = outcome.near;
                continue;
            }
            Code::Leaf => {
                if state.leaf(query, outcome.near.offset) {
                    return;
                }
            }
            Code::Miss => {}
        }
        let nearest = limit(query.t_max);
        match pop(&mut stack, |entry| entry.t_min, |_| false, nearest, query, state) {
            Some(next) => here = Child { t_max: minimum_number(next.t_max, nearest), ..next },
            None => return,
        }
    }
}

/// The way through the software decoder.
fn decoding(
    words: [u32; 3],
    ray: &impl PlaneDistances,
    here: Child,
    code: Code,
    state: &State<'_, '_, '_>,
) -> u32 {
    let names = state.names;
    let carved = |leaf: bool| match (code, leaf) {
        (Code::Miss, _) => 0,
        (_, true) => names.carve_leaf,
        (_, false) => names.carve_on,
    };
    match Header::decode(words[0]) {
        Some(Header::Leaf { .. }) | None => names.bare_leaf,
        Some(Header::CarveSingle { axis, leaf, .. }) => {
            let swap = if ray.is_negative(axis as usize) { names.swap } else { 0 };
            names.carve | names.single | swap | carved(leaf)
        }
        Some(Header::CarveDual { axes, is_min, leaf, .. }) => {
            let entry = |i: usize| {
                let exits = ray.is_negative(axes[i] as usize) == is_min[i];
                if exits { 0 } else { names.entry[i] }
            };
            names.carve | entry(0) | entry(1) | carved(leaf)
        }
        Some(Header::Split { axis, .. }) => {
            let swap = if ray.is_negative(axis as usize) { names.swap } else { 0 };
            // `One` is the near child unless its interval is empty.
            let plane = if swap == 0 { words[1] } else { words[2] };
            let near_exit = minimum_number(here.t_max, ray.exit(f32::from_bits(plane), axis as usize));
            let near = here.t_min <= near_exit;
            swap | match code {
                Code::Two => names.near | names.far,
                Code::One if near => names.near,
                Code::One => names.far,
                _ => 0,
            }
        }
    }
}

/// A binary hierarchy: both boxes of a node, then the nearer child.
pub fn bvh2(bvh: &Bvh2, query: &mut Query<'_>, state: &mut State<'_, '_, '_>) {
    let mut word = bvh.root;
    if enter(query, state, &bvh.root_box, false).is_none() {
        return;
    }
    let names = state.names;
    let mut stack: Vec<(u32, f32)> = Vec::with_capacity(MAX_DEPTH as usize);
    loop {
        if LEAF.get(word) == 1 {
            state.event(names.node, names.leaf);
            if state.leaf(query, Bvh2::INDEX.get(word)) {
                return;
            }
        } else {
            let at = state.layout.nodes_at + Bvh2::INDEX.get(word) * BvhNode::WORDS;
            state.tape.address(names.node_address, at);
            let [left, right] = bvh.children(word) else {
                unreachable!("inner nodes of a binary hierarchy have two children");
            };
            let [l, r] = [left, right].map(|c| {
                let test = box_step(&c.aabb, query.ray, query.ray.t_min, query.t_max);
                state.box_test(&c.aabb, query.ray, query.t_max, &test);
                test
            });
            let conditions = if l.hit { names.hit_left } else { 0 } | if r.hit { names.hit_right } else { 0 };
            state.event(names.node, conditions);
            match (l.hit, r.hit) {
                (true, true) => {
                    let (near, far) = if l.t_entry <= r.t_entry {
                        (left.word, (right.word, r.t_entry))
                    } else {
                        (right.word, (left.word, l.t_entry))
                    };
                    stack.push(far);
                    word = near;
                    continue;
                }
                (true, false) => {
                    word = left.word;
                    continue;
                }
                (false, true) => {
                    word = right.word;
                    continue;
                }
                (false, false) => {}
            }
        }
        match pop(&mut stack, |entry| entry.1, |_| false, query.t_max, query, state) {
            Some((next, _)) => word = next,
            None => return,
        }
    }
}

/// A wide hierarchy: all children that are hit go on the stack, the farthest first.
pub fn wide<const N: usize>(bvh: &Bvh<N>, query: &mut Query<'_>, state: &mut State<'_, '_, '_>) {
    let mut word = bvh.root;
    if enter(query, state, &bvh.root_box, LEAF.get(word) == 1).is_none() {
        return;
    }
    let mut stack: Vec<(u32, f32)> = Vec::with_capacity(N * MAX_DEPTH as usize);
    loop {
        if LEAF.get(word) == 1 {
            if state.leaf(query, Bvh::<N>::INDEX.get(word)) {
                return;
            }
        } else {
            children(bvh.children(word), Bvh::<N>::INDEX.get(word), &mut stack, query, state);
        }
        match pop(&mut stack, |entry| entry.1, |entry| LEAF.get(entry.0) == 1, query.t_max, query, state) {
            Some((next, _)) => word = next,
            None => return,
        }
    }
}

/// Tests the children from `first` on and inserts those that are hit, the farthest first.
fn children(
    children: &[BvhNode],
    first: u32,
    stack: &mut Vec<(u32, f32)>,
    query: &Query<'_>,
    state: &mut State<'_, '_, '_>,
) {
    let names = state.names;
    let address = |child: usize| (first + child as u32) * BvhNode::WORDS;
    let at = state.layout.nodes_at;
    state.tape.address(names.child_address, at + address(0));
    state.event(names.node, 0);
    let last = children.len() - 1;
    if let Some(lane) = names.lane {
        for child in 0..=last {
            state.tape.address(names.child_address, at + address(child));
            state.event(lane, if child == last { names.last_lane } else { 0 });
        }
    }
    let bottom = stack.len();
    for (child, node) in children.iter().enumerate() {
        state.tape.address(names.child_address, at + address(child));
        let ends = if child == last { names.last_child } else { 0 };
        let test = box_step(&node.aabb, query.ray, query.ray.t_min, query.t_max);
        state.box_test(&node.aabb, query.ray, query.t_max, &test);
        if !test.hit {
            state.event(names.child, ends);
            continue;
        }
        let mut slot = stack.len();
        stack.push((node.word, test.t_entry));
        if slot == bottom {
            state.event(names.child, names.hit | names.first | ends);
            continue;
        }
        state.event(names.child, names.hit);
        loop {
            if stack[slot - 1].1 > test.t_entry {
                state.event(names.shift, ends);
                break;
            }
            stack[slot] = stack[slot - 1];
            slot -= 1;
            if slot == bottom {
                state.event(names.shift, names.shifts | ends);
                break;
            }
            state.event(names.shift, names.shifts | names.more);
        }
        stack[slot] = (node.word, test.t_entry);
    }
}
