//! Names for what is special about an operation, to say what a stream has covered.

use super::cases::{BoxCase, NodeCase, RayWords};
use fp::Format;
use golden::dst::header::{AXIS, CARVE, LEAF, SINGLE};

/// Classes of a unit's two operands.
pub fn operands(format: Format, [a, b]: [u32; 2], class: &mut impl FnMut(&'static str)) {
    for name in value_classes(format, &[a, b]) {
        class(name);
    }
    let [x, y] = [a, b].map(|bits| format.magnitude(bits));
    if x == y {
        class("equal magnitudes");
    }
    let infinity = format.infinity();
    if [x, y] == [0, infinity] || [x, y] == [infinity, 0] {
        class("infinity and zero");
    }
    if x == infinity && y == infinity {
        class("two infinities");
    }
}

/// The class of a rounded result.
pub fn result(format: Format, bits: u32) -> &'static str {
    match format.magnitude(bits) {
        0 => "zero result",
        x if x < format.min_normal() => "subnormal result",
        x if x < format.infinity() => "normal result",
        x if x == format.infinity() => "infinite result",
        _ => "NaN result",
    }
}

/// Which special values are among `words`.
fn value_classes(format: Format, words: &[u32]) -> Vec<&'static str> {
    let any = |test: &dyn Fn(u32) -> bool| words.iter().any(|&word| test(word));
    let magnitude = |word| format.magnitude(word);
    let mut found = Vec::new();
    let tests: [(&'static str, &dyn Fn(u32) -> bool); 6] = [
        ("NaN operand", &|w| format.is_nan(w)),
        ("infinite operand", &|w| magnitude(w) == format.infinity()),
        ("subnormal operand", &|w| (1..format.min_normal()).contains(&magnitude(w))),
        ("+0 operand", &|w| w == 0),
        ("-0 operand", &|w| w == format.sign_bit()),
        ("normal operand", &|w| (format.min_normal()..format.infinity()).contains(&magnitude(w))),
    ];
    for (name, test) in tests {
        if any(test) {
            found.push(name);
        }
    }
    found
}

/// Classes of a dual-split step: the node's type with its outcome, and the ray's peculiarities.
pub fn node(case: &NodeCase, code: u8, class: &mut impl FnMut(&'static str)) {
    let header = case.words[0];
    let outcome = usize::from(code);
    class(match (CARVE.get(header) == 1, LEAF.get(header) == 1, AXIS.get(header) == SINGLE) {
        (false, false, _) => {
            ["split: miss", "split: one child", "split: two children", "split: leaf"][outcome]
        }
        (false, true, _) => "bare leaf",
        (true, false, true) => ["single carve: miss", "single carve: child", "", ""][outcome],
        (true, false, false) => ["dual carve: miss", "dual carve: child", "", ""][outcome],
        (true, true, true) => ["single carve: miss", "", "", "single carve: leaf"][outcome],
        (true, true, false) => ["dual carve: miss", "", "", "dual carve: leaf"][outcome],
    });
    ray(&case.ray, &case.words[1..], class);
}

/// Classes of a slab test: hit or miss, and the ray's peculiarities.
pub fn bounds(case: &BoxCase, hit: bool, class: &mut impl FnMut(&'static str)) {
    class(if hit { "box hit" } else { "box missed" });
    ray(&case.ray, &case.planes, class);
}

fn ray(ray: &RayWords, planes: &[u32], class: &mut impl FnMut(&'static str)) {
    let format = Format::BINARY32;
    let words: Vec<u32> = planes.iter().copied().chain([ray.t_min, ray.t_max]).chain(ray.origin).collect();
    value_classes(format, &words).into_iter().for_each(&mut *class);
    if ray.inv_entry.iter().any(|&inv| format.magnitude(inv) == format.infinity()) {
        class("parallel axis");
    }
    if planes.iter().any(|plane| ray.origin.contains(plane)) {
        class("plane at the origin");
    }
    let (t_min, t_max) = (f32::from_bits(ray.t_min), f32::from_bits(ray.t_max));
    if t_min > t_max {
        class("empty interval");
    } else if t_min == t_max {
        class("interval of one point");
    }
}
