//! The control of both pipelines: everything but adders and multipliers, whose results are free.
//!
//! The reference follows `golden::dst::step` and `golden::bvh::box_step`. It computes a result for each node type,
//! and the type chooses last; the hardware lets all types flow through the same units. Minimum, maximum and
//! comparison are the gates of those units, which have proofs of their own; folds are associated as in the hardware,
//! as golden's are associative bit for bit.

use super::ADDER;
use gates::aig::{Aig, Lit, Node};
use gates::prove::copy;
use gates::words;
use golden::dst::header::{self, Field};

/// Builds claims from the inputs and units of a pipeline.
pub struct Control<'a> {
    /// The graph that the reference is built in.
    pub aig: &'a mut Aig,
    /// Bits of an input, by name.
    pub input: &'a dyn Fn(&str) -> Vec<Lit>,
    /// The function of the minimum and maximum unit.
    pub min_max: &'a Aig,
    /// The function of the comparator.
    pub compare: &'a Aig,
}

/// A claim: wherever `when` holds, the word called `name` has the value `value`.
pub struct Claim {
    /// Name of an output.
    pub name: String,
    /// The condition.
    pub when: Lit,
    /// The value.
    pub value: Vec<Lit>,
}

/// The part of an interval that lies in a child.
#[derive(Clone)]
struct Interval {
    start: Vec<Lit>,
    end: Vec<Lit>,
}

impl Control<'_> {
    fn word(&self, name: &str) -> Vec<Lit> {
        (self.input)(name)
    }

    /// The word of one of three axes; code 3 is z.
    fn of_axis(&mut self, axis: &[Lit], what: &str) -> Vec<Lit> {
        let [x, y, z] = ["x", "y", "z"].map(|axis| self.word(&format!("{what}_{axis}_i")));
        let upper = words::mux(self.aig, axis[1], &z, &y);
        let lower = words::mux(self.aig, axis[1], &z, &x);
        words::mux(self.aig, axis[0], &upper, &lower)
    }

    /// Output `name` of a unit with these inputs.
    fn unit(&mut self, unit: &Aig, name: &str, inputs: &[(&str, &[Lit])]) -> Vec<Lit> {
        let map = copy(unit, self.aig, |node| {
            let Node::Input(input) = node else { return Lit::FALSE };
            let full = unit.inputs()[input as usize].name.as_str();
            let (word, bit) = split_name(full);
            let given = inputs.iter().find(|(input, _)| *input == word);
            given.and_then(|(_, bits)| bits.get(bit)).copied().unwrap_or(Lit::FALSE)
        });
        let outputs = unit.outputs.iter().filter(|output| split_name(&output.name).0 == name);
        outputs.map(|output| map[output.lit.node()].complement_if(output.lit.is_complemented())).collect()
    }

    fn fold(&mut self, a: &[Lit], b: &[Lit], maximum: bool, propagate: bool) -> Vec<Lit> {
        let (maximum, propagate) = ([Lit::constant(maximum)], [Lit::constant(propagate)]);
        let inputs: [(&str, &[Lit]); 4] =
            [("a_i", a), ("b_i", b), ("maximum_i", &maximum), ("propagate_nan_i", &propagate)];
        self.unit(self.min_max, "result_o", &inputs)
    }

    fn min(&mut self, a: &[Lit], b: &[Lit]) -> Vec<Lit> {
        self.fold(a, b, false, false)
    }

    fn max(&mut self, a: &[Lit], b: &[Lit]) -> Vec<Lit> {
        self.fold(a, b, true, false)
    }

    fn is_not_empty(&mut self, interval: &Interval) -> Lit {
        self.unit(self.compare, "le_o", &[("a_i", &interval.start), ("b_i", &interval.end)])[0]
    }

    fn mux(&mut self, select: Lit, when_true: &[Lit], when_false: &[Lit]) -> Vec<Lit> {
        words::mux(self.aig, select, when_true, when_false)
    }

    fn mux_interval(&mut self, select: Lit, when_true: &Interval, when_false: &Interval) -> Interval {
        Interval {
            start: self.mux(select, &when_true.start, &when_false.start),
            end: self.mux(select, &when_true.end, &when_false.end),
        }
    }

    /// The claims about the dual-split pipeline: operands of adders and multipliers, code and slots.
    pub fn dual_split(&mut self) -> Vec<Claim> {
        let header = self.word("header_i");
        let field = |field: Field| header[field.low..field.low + field.width].to_vec();
        let (carve, leaf) = (field(header::CARVE)[0], field(header::LEAF)[0]);
        let (kind, size) = (field(header::AXIS), field(header::SIZE));
        let mut offset = field(header::OFFSET);
        offset.resize(32, Lit::FALSE);
        let here = Interval { start: self.word("t_min_i"), end: self.word("t_max_i") };
        let single = words::equal(self.aig, &kind, &words::constant(u128::from(header::SINGLE), 2));
        // The axes of a dual carve, by its kind.
        let mut dual_axes = [words::constant(0, 2), words::constant(0, 2)];
        for code in 0..4 {
            let is_code = words::equal(self.aig, &kind, &words::constant(u128::from(code), 2));
            let axes = header::dual_axes(code);
            for (chosen, axis) in dual_axes.iter_mut().zip(axes) {
                *chosen = words::mux(self.aig, is_code, &words::constant(u128::from(axis), 2), chosen);
            }
        }
        let mut claims = Vec::new();
        let bare_leaf = self.aig.and(!carve, leaf);
        let mut planes = Vec::new();
        for (i, dual_axis) in dual_axes.iter().enumerate() {
            let carve_axis = self.mux(single, &size, dual_axis);
            let axis = self.mux(carve, &carve_axis, &kind);
            let entry = self.of_axis(&axis, "inv_entry");
            let negative = entry[entry.len() - 1];
            // The min side of a split's planes, in the words of a single carve: the first is a max.
            let dual_side = size[1 - i];
            let plain_side = Lit::constant(i == 1);
            let dual = self.aig.and(carve, !single);
            let min_side = self.aig.mux(dual, dual_side, plain_side);
            let is_exit = !self.aig.xor(negative, min_side);
            let exit = self.of_axis(&axis, "inv_exit");
            let reciprocal = self.mux(is_exit, &exit, &entry);
            let origin = self.of_axis(&axis, "origin");
            let difference = self.word(&format!("subtract${i}.result_o"));
            let plane = self.word(&format!("plane_{i}_i"));
            for (name, value) in [
                (format!("subtract${i}.a_i"), plane),
                (format!("subtract${i}.b_i"), origin),
                (format!("multiply${i}.a_i"), difference),
                (format!("multiply${i}.b_i"), reciprocal),
            ] {
                // The operands for a bare leaf's planes are free.
                claims.push(Claim { name, when: !bare_leaf, value });
            }
            planes.push((is_exit, negative, self.word(&format!("multiply${i}.result_o"))));
        }

        // A carve folds its planes into the interval, two of one role with each other first: folds are associative.
        let [(exit_0, _, t_0), (exit_1, _, t_1)] = [&planes[0], &planes[1]];
        let (both_exit, both_enter) = (self.aig.and(*exit_0, *exit_1), self.aig.and(!*exit_0, !*exit_1));
        let earliest = self.min(t_0, t_1);
        let latest = self.max(t_0, t_1);
        let one_exit = self.mux(*exit_0, t_0, t_1);
        let one_entry = self.mux(*exit_0, t_1, t_0);
        let exit = self.mux(both_exit, &earliest, &one_exit);
        let entry = self.mux(both_enter, &latest, &one_entry);
        // A bound that no plane moves is folded with itself.
        let exit = self.mux(both_enter, &here.end, &exit);
        let entry = self.mux(both_exit, &here.start, &entry);
        let carved = Interval { start: self.max(&here.start, &entry), end: self.min(&here.end, &exit) };
        let carve_hit = self.is_not_empty(&carved);

        // A split's planes are of one axis.
        let negative = planes[0].1;
        let (exit_t, entry_t) =
            (self.mux(negative, &planes[1].2, &planes[0].2), self.mux(negative, &planes[0].2, &planes[1].2));
        let near = Interval { start: here.start.clone(), end: self.min(&here.end, &exit_t) };
        let far = Interval { start: self.max(&here.start, &entry_t), end: here.end.clone() };
        let (near_hit, far_hit) = (self.is_not_empty(&near), self.is_not_empty(&far));
        let mut distance = size.clone();
        distance.resize(32, Lit::FALSE);
        let (right, _) = words::add(self.aig, ADDER, &offset, &distance, Lit::FALSE);
        let near_offset = self.mux(negative, &right, &offset);
        let far_offset = self.mux(negative, &offset, &right);
        let both = self.aig.and(near_hit, far_hit);
        let either = self.aig.or(near_hit, far_hit);

        // The type chooses.
        let is_split = self.aig.and(!carve, !leaf);
        let one_if = |hit: Lit| vec![hit, Lit::FALSE];
        let split_code = {
            let two = words::constant(2, 2);
            self.mux(both, &two, &one_if(either))
        };
        let leaf_carve_code = vec![carve_hit; 2];
        let carve_code = self.mux(leaf, &leaf_carve_code, &one_if(carve_hit));
        let leaf_code = words::constant(3, 2);
        let rest_code = self.mux(carve, &carve_code, &leaf_code);
        let code = self.mux(is_split, &split_code, &rest_code);
        let survivor = self.mux_interval(near_hit, &near, &far);
        let survivor_offset = self.mux(near_hit, &near_offset, &far_offset);
        let rest = self.mux_interval(carve, &carved, &here);
        let slot = self.mux_interval(is_split, &survivor, &rest);
        let slot_offset = self.mux(is_split, &survivor_offset, &offset);
        let any = words::any(self.aig, &code);
        let two = self.aig.and(is_split, both);
        let claim = |name: &str, when: Lit, value: Vec<Lit>| Claim { name: name.into(), when, value };
        claims.extend([
            claim("code_o", Lit::TRUE, code),
            claim("near_offset_o", any, slot_offset),
            claim("near_t_min_o", any, slot.start),
            claim("near_t_max_o", any, slot.end),
            claim("far_offset_o", two, far_offset),
            claim("far_t_min_o", two, far.start),
            claim("far_t_max_o", two, far.end),
        ]);
        claims.extend(self.passed_on());
        claims
    }

    /// The claims about the ray-box pipeline.
    pub fn ray_box(&mut self) -> Vec<Claim> {
        let mut claims = Vec::new();
        let (t_min, t_max) = (self.word("t_min_i"), self.word("t_max_i"));
        let mut slabs = Vec::new();
        for (i, axis) in ["x", "y", "z"].into_iter().enumerate() {
            let entry = self.word(&format!("inv_entry_{axis}_i"));
            let exit = self.word(&format!("inv_exit_{axis}_i"));
            let negative = entry[entry.len() - 1];
            let mut distances = Vec::new();
            for (lane, side, swap) in [(i, "min", negative), (i + 3, "max", !negative)] {
                let reciprocal = self.mux(swap, &exit, &entry);
                for (name, value) in [
                    (format!("subtract${lane}.a_i"), self.word(&format!("box_{side}_{axis}_i"))),
                    (format!("subtract${lane}.b_i"), self.word(&format!("origin_{axis}_i"))),
                    (format!("multiply${lane}.a_i"), self.word(&format!("subtract${lane}.result_o"))),
                    (format!("multiply${lane}.b_i"), reciprocal),
                ] {
                    claims.push(Claim { name, when: Lit::TRUE, value });
                }
                distances.push(self.word(&format!("multiply${lane}.result_o")));
            }
            let near = self.fold(&distances[0], &distances[1], false, true);
            let far = self.fold(&distances[0], &distances[1], true, true);
            slabs.push((near, far));
        }
        // In pairs: folds are associative and commutative.
        let [(near_x, far_x), (near_y, far_y), (near_z, far_z)] = slabs.as_slice() else {
            unreachable!("three axes")
        };
        let (first, second) = (self.max(near_x, near_y), self.max(near_z, &t_min));
        let start = self.max(&first, &second);
        let (first, second) = (self.min(far_x, far_y), self.min(far_z, &t_max));
        let end = self.min(&first, &second);
        let hit = self.is_not_empty(&Interval { start: start.clone(), end });
        claims.push(Claim { name: "hit_o".into(), when: Lit::TRUE, value: vec![hit] });
        claims.push(Claim { name: "t_entry_o".into(), when: hit, value: start });
        claims.extend(self.passed_on());
        claims
    }

    /// The claims about valid and tag, which come out as they went in.
    fn passed_on(&self) -> impl Iterator<Item = Claim> {
        let claim = |what: &str| Claim {
            name: format!("{what}_o"),
            when: Lit::TRUE,
            value: self.word(&format!("{what}_i")),
        };
        [claim("valid"), claim("tag")].into_iter()
    }
}

/// The word and the position of a bit's name.
fn split_name(name: &str) -> (&str, usize) {
    let bit = name.strip_suffix(']').and_then(|name| name.rsplit_once('['));
    bit.and_then(|(word, bit)| Some((word, bit.parse().ok()?))).unwrap_or((name, 0))
}
