//! Cuts a dual-split node's first word into its fields, where [`golden::dst::header`] puts them.

use golden::dst::header;
use netlist::module::named;
use rust_hdl_core::prelude::*;
use units::blocks::module;

/// Fields of a node header.
///
/// ```text
///              +------------+
///              |          1 |---> carve_o, leaf_o
/// header_i --->| 32       2 |---> kind_o, size_o
///              | NodeHeader |
///              |         32 |---> offset_o
///              +------------+
/// ```
/// Combinational: wires.
#[derive(LogicBlock, Clone, Debug)]
pub(super) struct NodeHeader {
    pub header_i: Signal<In, Bits<32>>,
    pub carve_o: Signal<Out, Bit>,
    pub leaf_o: Signal<Out, Bit>,
    /// Split axis, or kind of carve.
    pub kind_o: Signal<Out, Bits<2>>,
    /// Size of the left child in words, corner bits, or axis of a single carve.
    pub size_o: Signal<Out, Bits<2>>,
    /// Offset or triangle index, zero-extended.
    pub offset_o: Signal<Out, Bits<32>>,
    carve_index: Constant<Bits<8>>,
    leaf_index: Constant<Bits<8>>,
    kind_index: Constant<Bits<8>>,
    size_index: Constant<Bits<8>>,
    offset_mask: Constant<Bits<32>>,
}

impl Default for NodeHeader {
    fn default() -> Self {
        const { assert!(header::AXIS.width == 2 && header::SIZE.width == 2 && header::OFFSET.low == 0) };
        let index = |field: header::Field| Constant::new((field.low as u64).into());
        module! {
            carve_index = index(header::CARVE),
            leaf_index = index(header::LEAF),
            kind_index = index(header::AXIS),
            size_index = index(header::SIZE),
            offset_mask = Constant::new(u64::from(header::OFFSET.mask()).into());
            header_i, carve_o, leaf_o, kind_o, size_o, offset_o,
        }
    }
}

impl Logic for NodeHeader {
    #[hdl_gen]
    fn update(&mut self) {
        self.carve_o.next = self.header_i.val().get_bit(self.carve_index.val().index());
        self.leaf_o.next = self.header_i.val().get_bit(self.leaf_index.val().index());
        self.kind_o.next = self.header_i.val().get_bits::<2>(self.kind_index.val().index());
        self.size_o.next = self.header_i.val().get_bits::<2>(self.size_index.val().index());
        self.offset_o.next = self.header_i.val() & self.offset_mask.val();
    }

    fn timing(&self) -> Vec<TimingInfo> {
        named("node_header", "")
    }
}
