//! The operations of the pipelines, and the exact triangle test.

use super::fault::{Fault, Mistake};
use super::special::Special;
use super::thread::{Context, Surroundings, Thread};
use crate::program::Register;
use golden::Aabb;
use golden::bvh::BoxStep;
use golden::dst::Step;
use golden::ray::PlaneRay;

impl Thread {
    /// Origin and reciprocals in nine registers.
    #[inline(always)]
    pub(super) fn plane_ray(&self, registers: &[Register]) -> PlaneRay {
        PlaneRay {
            origin: self.floats(registers),
            inv_entry: self.floats(&registers[3..]),
            inv_exit: self.floats(&registers[6..]),
        }
    }

    #[inline(always)]
    pub(super) fn dual_split_step<S: Special>(&mut self, list: &[Register], special: &S) {
        let ray = self.plane_ray(&list[10..]);
        let words = [7, 8, 9].map(|at| self.get(list[at]));
        let Step { code, near, far } = special.step(words, &ray, self.floats(&list[3..]));
        self.set(list[0], code as u32);
        self.set(list[1], near.offset);
        self.set(list[2], far.offset);
        for (register, t) in list[3..7].iter().zip([near.t_min, near.t_max, far.t_min, far.t_max]) {
            self.set_float(*register, t);
        }
    }

    #[cold]
    pub(super) fn exact_test<S: Special>(
        &mut self,
        at: usize,
        list: usize,
        context: &Context<'_, '_, S>,
    ) -> Result<(), Box<Fault>> {
        let Surroundings { program, memory, special } = context.around;
        let list = &program.lists[list];
        let triangle = self.get(list[4]);
        let mut words = [0.0; 9];
        for (address, word) in (0..).map(|word| triangle.wrapping_add(word)).zip(&mut words) {
            let bits = memory.load(address, self.item);
            *word = f32::from_bits(
                bits.map_err(|denied| self.fault(at, Mistake::Load(address, denied), context))?,
            );
        }
        // A triangle lies in memory axis by axis.
        let corners = std::array::from_fn(|corner| std::array::from_fn(|axis| words[3 * axis + corner]));
        let ray: [f32; 6] = self.floats(&list[5..]);
        if !words.iter().chain(&ray).all(|number| number.is_finite()) {
            return Err(self.fault(at, Mistake::NotFinite, context));
        }
        let hit = special.exact(self.floats(&list[5..]), self.floats(&list[8..]), &corners);
        self.exact_tests += 1;
        self.set(list[0], hit.is_some().into());
        let values = hit.map_or([0.0; 3], |hit| [hit.t, hit.u, hit.v]);
        list[1..4].iter().zip(values).for_each(|(register, value)| self.set_float(*register, value));
        Ok(())
    }

    /// The index of lane `number`.
    pub(super) fn lane<S>(
        &self,
        at: usize,
        number: u32,
        context: &Context<'_, '_, S>,
    ) -> Result<usize, Box<Fault>> {
        let lanes = context.around.program.lanes;
        if (1..=lanes).contains(&number) {
            Ok(number as usize - 1)
        } else {
            Err(self.fault(at, Mistake::Lane(number, lanes), context))
        }
    }

    #[inline(always)]
    pub(super) fn box_test<S: Special>(&mut self, list: &[Register], special: &S) {
        let ray = self.plane_ray(&list[8..]);
        let BoxStep { hit, t_entry, .. } =
            special.box_test(&aabb(self.floats(&list[2..])), &ray, self.float(list[17]));
        self.set(list[0], hit.into());
        self.set_float(list[1], t_entry);
    }

    #[inline(always)]
    pub(super) fn box_test_pair<S: Special>(&mut self, list: &[Register], special: &S) {
        let (ray, t_max) = (self.plane_ray(&list[15..]), self.float(list[24]));
        let steps = [3, 9].map(|at| special.box_test(&aabb(self.floats(&list[at..])), &ray, t_max));
        self.set(list[0], u32::from(steps[0].hit) | u32::from(steps[1].hit) << 1);
        self.set_float(list[1], steps[0].t_entry);
        self.set_float(list[2], steps[1].t_entry);
    }

    pub(super) fn box_test_lanes<S: Special>(
        &mut self,
        at: usize,
        list: usize,
        context: &Context<'_, '_, S>,
    ) -> Result<(), Box<Fault>> {
        let list = &context.around.program.lists[list];
        let (ray, t_max) = (self.plane_ray(&list[2..]), self.float(list[11]));
        let first = self.lane(at, self.get(list[1]), context)?;
        let mut hits = 0;
        for lane in 0..=first {
            let BoxStep { hit, t_entry, .. } =
                context.around.special.box_test(&aabb(self.lanes[lane]), &ray, t_max);
            self.entries[lane] = t_entry;
            hits |= u32::from(hit) << (first - lane);
        }
        self.set(list[0], hits);
        Ok(())
    }
}

/// Minimum and maximum in six words.
#[inline(always)]
fn aabb(words: [f32; 6]) -> Aabb {
    let [x0, y0, z0, x1, y1, z1] = words;
    Aabb { min: [x0, y0, z0], max: [x1, y1, z1] }
}
