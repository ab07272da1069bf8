//! Entry points, conditions and addresses of a structure's program.

use crate::program::{Conditions, EntryId, Program};

/// What a recorder needs. A name that the program does not have is zero, and the recorder never uses it.
#[allow(missing_docs, reason = "named as in the listings")]
pub struct Names {
    pub ray: EntryId,
    pub node: EntryId,
    pub triangle: EntryId,
    pub pop: EntryId,
    pub child: EntryId,
    pub shift: EntryId,
    /// Only where boxes are tested side by side.
    pub lane: Option<EntryId>,
    /// Whether the program decodes dual-split nodes in software.
    pub decodes: bool,

    pub root_missed: Conditions,
    pub one: Conditions,
    pub missed: Conditions,
    pub leaf: Conditions,
    pub carve: Conditions,
    pub bare_leaf: Conditions,
    pub swap: Conditions,
    pub near: Conditions,
    pub far: Conditions,
    pub single: Conditions,
    pub entry: [Conditions; 2],
    pub carve_on: Conditions,
    pub carve_leaf: Conditions,
    pub hit_left: Conditions,
    pub hit_right: Conditions,
    pub hit: Conditions,
    pub first: Conditions,
    pub shifts: Conditions,
    pub more: Conditions,
    pub last_child: Conditions,
    pub last_lane: Conditions,

    pub last: Conditions,
    pub negative: Conditions,
    pub outside: Conditions,
    pub positive: Conditions,
    pub exact: Conditions,
    pub behind: Conditions,
    pub farther: Conditions,
    pub any: Conditions,
    pub empty: Conditions,
    pub beyond: Conditions,
    pub nothing: Conditions,
    pub lit: Conditions,
    pub last_bounce: Conditions,

    pub node_address: u8,
    pub child_address: u8,
    pub rows: [u8; 3],
    pub triangle_address: u8,
    pub hit_address: u8,
    pub pixel: u8,
}

impl Names {
    pub fn new(program: &Program) -> Self {
        let entry = |name| program.find_entry(name).unwrap_or_default();
        let condition = |name| program.condition(name);
        let base = |name| program.base(name).unwrap_or_default();
        Self {
            ray: program.entry("ray"),
            node: program.entry("node"),
            triangle: program.entry("triangle"),
            pop: program.entry("pop"),
            child: entry("child"),
            shift: entry("shift"),
            lane: program.find_entry("lane"),
            decodes: condition("carve") != 0,
            root_missed: condition("root_missed"),
            one: condition("one"),
            missed: condition("missed"),
            leaf: condition("leaf"),
            carve: condition("carve"),
            bare_leaf: condition("bare_leaf"),
            swap: condition("swap"),
            near: condition("near"),
            far: condition("far"),
            single: condition("single"),
            entry: ["entry0", "entry1"].map(condition),
            carve_on: condition("carve_on"),
            carve_leaf: condition("carve_leaf"),
            hit_left: condition("hit_left"),
            hit_right: condition("hit_right"),
            hit: condition("hit"),
            first: condition("first"),
            shifts: condition("shift"),
            more: condition("more"),
            last_child: condition("last_child"),
            last_lane: condition("last_lane"),
            last: condition("last"),
            negative: condition("negative"),
            outside: condition("outside"),
            positive: condition("positive"),
            exact: condition("exact"),
            behind: condition("behind"),
            farther: condition("farther"),
            any: condition("any"),
            empty: condition("empty"),
            beyond: condition("beyond"),
            nothing: condition("nothing"),
            lit: condition("lit"),
            last_bounce: condition("last_bounce"),
            node_address: base("node"),
            child_address: base("child"),
            rows: ["row0", "row1", "row2"].map(base),
            triangle_address: base("triangle"),
            hit_address: base("hit"),
            pixel: base("pixel"),
        }
    }
}
