//! The numbers of a glTF accessor, checked against its buffers.

use std::ops::Range;
use std::rc::Rc;

use gltf::accessor::sparse::IndexType;
use gltf::accessor::{DataType, Dimensions};
use gltf::{Accessor, buffer::View};

use super::buffers::Buffers;
use super::{Fault, fault};
use crate::formats::error::FormatErrorKind;

/// Most numbers of an element that is read.
const MOST: usize = 3;

/// Elements of equal size and distance in a buffer.
struct Elements {
    buffer: Rc<[u8]>,
    range: Range<usize>,
    stride: usize,
    kind: DataType,
    normalized: bool,
}

impl Elements {
    /// The numbers of element `index`, the first `length` of the result.
    fn get(&self, index: usize, length: usize) -> [f64; MOST] {
        let bytes = &self.buffer[self.range.clone()][index * self.stride..];
        let mut numbers = [0.0; MOST];
        for (position, number) in numbers[..length].iter_mut().enumerate() {
            let bytes = &bytes[position * self.kind.size()..][..self.kind.size()];
            *number = self.number(bytes);
        }
        numbers
    }

    fn number(&self, bytes: &[u8]) -> f64 {
        let scaled = |x: f64, largest: f64| if self.normalized { (x / largest).max(-1.0) } else { x };
        match (self.kind, bytes) {
            (DataType::I8, &[a]) => scaled(f64::from(a as i8), f64::from(i8::MAX)),
            (DataType::U8, &[a]) => scaled(f64::from(a), f64::from(u8::MAX)),
            (DataType::I16, &[a, b]) => scaled(f64::from(i16::from_le_bytes([a, b])), f64::from(i16::MAX)),
            (DataType::U16, &[a, b]) => scaled(f64::from(u16::from_le_bytes([a, b])), f64::from(u16::MAX)),
            (DataType::U32, &[a, b, c, d]) => f64::from(u32::from_le_bytes([a, b, c, d])),
            (DataType::F32, &[a, b, c, d]) => f64::from(f32::from_le_bytes([a, b, c, d])),
            _ => unreachable!("as many bytes as the type has"),
        }
    }
}

impl Buffers<'_> {
    /// Gives each element of `accessor`, which has `length` numbers, to `take`.
    ///
    /// # Errors
    /// The accessor has another type or reaches beyond its buffers, or `take` refuses an element.
    pub(super) fn read(
        &mut self,
        accessor: &Accessor<'_>,
        length: usize,
        mut take: impl FnMut([f64; MOST]) -> Result<(), FormatErrorKind>,
    ) -> Result<(), Fault> {
        let part = format!("accessor {}", accessor.index());
        let invalid = |what: &str| fault(&*part, FormatErrorKind::Invalid(what.to_owned()));
        let (dimensions, what) = match length {
            1 => (Dimensions::Scalar, "indices are not single integers"),
            _ => (Dimensions::Vec3, "positions do not have three numbers"),
        };
        let kind = accessor.data_type();
        if accessor.dimensions() != dimensions
            || (length == 1 && matches!(kind, DataType::F32 | DataType::I8 | DataType::I16))
        {
            return Err(invalid(what));
        }
        let Some(view) = accessor.view() else {
            return Err(fault(
                part,
                FormatErrorKind::Unsupported("the accessor has no buffer view".to_owned()),
            ));
        };
        let normalized = accessor.normalized() && length > 1;
        let base =
            self.elements(&part, &view, accessor.offset(), accessor.count(), (kind, length), normalized)?;
        // Elements that a sparse accessor replaces, in ascending order of their indices.
        let mut replaced = Vec::new();
        if let Some(sparse) = accessor.sparse() {
            let index = match sparse.indices().index_type() {
                IndexType::U8 => DataType::U8,
                IndexType::U16 => DataType::U16,
                IndexType::U32 => DataType::U32,
            };
            let count = sparse.count();
            let (at, values) = (sparse.indices(), sparse.values());
            let indices = self.elements(&part, &at.view(), at.offset(), count, (index, 1), false)?;
            let values =
                self.elements(&part, &values.view(), values.offset(), count, (kind, length), normalized)?;
            replaced.extend((0..count).map(|i| (indices.get(i, 1)[0] as usize, values.get(i, length))));
            if !replaced.is_sorted_by(|a, b| a.0 < b.0)
                || replaced.last().is_some_and(|last| last.0 >= accessor.count())
            {
                return Err(invalid("its sparse indices do not ascend, or are out of range"));
            }
        }
        let mut replaced = replaced.into_iter().peekable();
        for index in 0..accessor.count() {
            let numbers = match replaced.next_if(|(at, _)| *at == index) {
                Some((_, numbers)) => numbers,
                None => base.get(index, length),
            };
            take(numbers).map_err(|kind| fault(format!("{part}, element {index}"), kind))?;
        }
        Ok(())
    }

    /// `count` elements of `length` numbers of `kind` in `view` from `offset`, all of them within the view.
    fn elements(
        &mut self,
        part: &str,
        view: &View<'_>,
        offset: usize,
        count: usize,
        (kind, length): (DataType, usize),
        normalized: bool,
    ) -> Result<Elements, Fault> {
        let (buffer, range) = self.view(view)?;
        let size = kind.size() * length;
        let stride = view.stride().unwrap_or(size);
        let needed = count.checked_sub(1).map_or(Some(0), |last| last.checked_mul(stride)?.checked_add(size));
        let end = needed.and_then(|needed| needed.checked_add(offset));
        if stride < size || end.is_none_or(|end| end > range.len()) {
            let what = format!("its {count} elements reach beyond buffer view {}, or overlap", view.index());
            return Err(fault(part, FormatErrorKind::Invalid(what)));
        }
        Ok(Elements { buffer, range: range.start + offset..range.end, stride, kind, normalized })
    }
}
