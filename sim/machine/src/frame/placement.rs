//! Where a structure's nodes lie: one after another as golden stores them, or with gaps.
//!
//! A program finds the children of a node by one offset, and each by the size of those before it. So all children of a node move
//! together, in the order of golden's memory, and a gap lies before them where they would reach into one more block of memory than
//! they have to. An offset counts words then, also in a hierarchy of boxes, whose nodes count nodes where they are packed.

use crate::description::{Bytes, DescriptionError, NodeLayout, check::out_of_range};
use golden::bvh::{self, Bvh8, BvhNode};
use golden::dst::header;
use golden::structure::{Memory, Structure, StructureKind};

/// Nodes with gaps between them.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Placed {
    /// The nodes and the gaps, which hold zeros.
    pub words: Vec<u32>,
    /// [`Memory::root`] with an offset that leads to where the root's children are.
    pub root: u32,
}

/// What has to be known of a format.
struct Format {
    /// Words that an offset counts where nodes are packed.
    offset_words: u32,
    offset: header::Field,
    /// Words of the node with this word 0.
    node_words: fn(u32) -> u32,
    is_inner: fn(u32) -> bool,
}

const BVH: Format = Format {
    offset_words: BvhNode::WORDS,
    offset: Bvh8::INDEX,
    node_words: |_| BvhNode::WORDS,
    is_inner: |word| bvh::LEAF.get(word) == 0,
};

const DST: Format = Format {
    offset_words: 1,
    offset: header::OFFSET,
    node_words: |word| {
        let bare_leaf = header::CARVE.get(word) == 0 && header::LEAF.get(word) == 1;
        if bare_leaf { header::LEAF_WORDS } else { header::NODE_WORDS }
    },
    is_inner: |word| header::LEAF.get(word) == 0,
};

impl Format {
    /// Calls `visit` with the word address of each node, in the order of memory.
    fn nodes(&self, words: &[u32], mut visit: impl FnMut(usize)) {
        let mut at = 0;
        while at < words.len() {
            visit(at);
            at += (self.node_words)(words[at]) as usize;
        }
    }

    /// The word address of the first child of the node with this word 0, where nodes are packed.
    fn first_child(&self, word: u32) -> Option<u32> {
        (self.is_inner)(word).then(|| self.offset.get(word) * self.offset_words)
    }
}

/// The nodes of a structure of `kind` as `layout` has them; none if that is how golden stores them.
///
/// # Errors
/// If an offset cannot reach all of them.
pub fn place(
    kind: StructureKind,
    memory: &Memory<'_>,
    layout: NodeLayout,
) -> Result<Option<Placed>, DescriptionError> {
    if layout.is_packed() {
        return Ok(None);
    }
    let format = if kind == StructureKind::Dst { DST } else { BVH };
    // Children of one node lie together, so their first ones divide the memory.
    let root_at = if kind == StructureKind::Dst { Some(0) } else { format.first_child(memory.root) };
    let mut starts: Vec<u32> = root_at.into_iter().collect();
    format.nodes(memory.words, |at| starts.extend(format.first_child(memory.words[at])));
    starts.sort_unstable();
    let ends = starts.iter().skip(1).copied().chain([memory.words.len() as u32]);

    let block = layout.alignment.0 / 4;
    let mut end = 0;
    let places: Vec<u64> = starts
        .iter()
        .zip(ends)
        .map(|(start, behind)| {
            let words = u64::from(behind - start);
            let at = within_blocks(end, words, block);
            end = at + words;
            at
        })
        .collect();
    let limit = 1 << format.offset.width;
    if end > limit {
        let rule = format!(
            "the nodes of the {kind} would take {end} words, and offsets reach {limit}: take a smaller alignment, or 0 for packed nodes"
        );
        return Err(out_of_range("layout.alignment", layout.alignment, rule));
    }

    let moved = |word: u32| match format.first_child(word) {
        Some(start) => {
            let number = starts.binary_search(&start).expect("it is among the first children");
            word & !format.offset.mask() | places[number] as u32
        }
        None => word,
    };
    let mut words = vec![0; end as usize];
    let mut number = 0;
    format.nodes(memory.words, |at| {
        while starts.get(number + 1).is_some_and(|next| *next as usize <= at) {
            number += 1;
        }
        let to = places[number] as usize + at - starts[number] as usize;
        let size = (format.node_words)(memory.words[at]) as usize;
        words[to..to + size].copy_from_slice(&memory.words[at..at + size]);
        words[to] = moved(memory.words[at]);
    });
    let root = if kind == StructureKind::Dst { memory.root } else { moved(memory.root) };
    Ok(Some(Placed { words, root }))
}

/// The first address from `at` on from which `words` words lie in as few blocks of `block` words as they can.
fn within_blocks(at: u64, words: u64, block: u64) -> u64 {
    let blocks = (at % block + words).div_ceil(block);
    if blocks > words.div_ceil(block) { at.next_multiple_of(block) } else { at }
}

/// Bytes of the nodes of `structure` as `layout` has them, gaps included.
///
/// # Errors
/// If an offset cannot reach all of them.
pub fn node_bytes(structure: &Structure, layout: NodeLayout) -> Result<Bytes, DescriptionError> {
    let memory = structure.memory();
    let placed = place(structure.kind(), &memory, layout)?;
    let words = placed.map_or(memory.words.len(), |placed| placed.words.len());
    Ok(Bytes(words as u64 * 4))
}

#[cfg(test)]
mod tests {
    use super::*;
    use golden::build::{BuildOptions, Quality, build};
    use golden::structure::pack_triangles;

    const KINDS: [StructureKind; 4] =
        [StructureKind::Bvh2, StructureKind::Bvh4, StructureKind::Bvh8, StructureKind::Dst];

    fn structure(kind: StructureKind) -> Structure {
        let scene = scenes::procedural::build("courtyard", 0.001, 0).unwrap();
        let tree = build(&scene.mesh, &BuildOptions::new(Quality::Fast)).unwrap();
        Structure::convert(kind, &tree, &pack_triangles(&scene.mesh, &tree)).unwrap()
    }

    /// The nodes below the one with word 0 `word`, depth first, each without its offset; and where the children of each lie, as word
    /// addresses of the first one and behind the last one. An offset counts `unit` words.
    fn walk(kind: StructureKind, words: &[u32], root: u32, unit: u32) -> (Vec<Vec<u32>>, Vec<[u32; 2]>) {
        let format = if kind == StructureKind::Dst { DST } else { BVH };
        let (mut nodes, mut families) = (vec![], vec![]);
        let mut open = vec![root];
        if kind == StructureKind::Dst {
            open = vec![words[0]];
            families.push([0, (format.node_words)(words[0])]);
        }
        while let Some(word) = open.pop() {
            if !(format.is_inner)(word) {
                continue;
            }
            let first = format.offset.get(word) * unit;
            let children = match kind {
                StructureKind::Dst => 2 - header::CARVE.get(word),
                _ => Bvh8::SIBLINGS.get(words[first as usize]) + 1,
            };
            let mut at = first;
            for _ in 0..children {
                let size = (format.node_words)(words[at as usize]);
                let mut node = words[at as usize..(at + size) as usize].to_vec();
                open.push(node[0]);
                if (format.is_inner)(node[0]) {
                    node[0] &= !format.offset.mask();
                }
                nodes.push(node);
                at += size;
            }
            families.push([first, at]);
        }
        (nodes, families)
    }

    #[test]
    fn children_lie_in_as_few_blocks_as_they_can_and_are_the_same() {
        for kind in KINDS {
            let structure = structure(kind);
            let memory = structure.memory();
            let unit = if kind == StructureKind::Dst { 1 } else { BvhNode::WORDS };
            let (nodes, packed) = walk(kind, memory.words, memory.root, unit);
            assert!(nodes.len() > 50, "{kind} has {} nodes", nodes.len());
            let mut sizes = vec![];
            for bytes in [4, 16, 32, 64, 128, 256] {
                let layout = NodeLayout { alignment: Bytes(bytes) };
                let placed = place(kind, &memory, layout).unwrap().unwrap();
                let (moved, families) = walk(kind, &placed.words, placed.root, 1);
                assert_eq!(moved, nodes, "{kind}, {bytes} bytes");
                let block = bytes as u32 / 4;
                let crossings = |&[first, behind]: &[u32; 2]| (behind - 1) / block - first / block;
                assert!(
                    families.iter().all(|family| crossings(family) == (family[1] - family[0] - 1) / block),
                    "{kind}, {bytes} bytes"
                );
                assert_eq!(families.len(), packed.len());
                assert_eq!(node_bytes(&structure, layout).unwrap().0, placed.words.len() as u64 * 4);
                sizes.push(placed.words.len());
                if bytes == 4 {
                    assert_eq!(families, packed, "{kind} without gaps");
                }
            }
            // A pair of boxes takes 56 bytes: two blocks of 32, or one of 64.
            if kind == StructureKind::Bvh2 {
                assert_eq!(sizes[3], 16 * packed.len() - 2, "the last one has no gap behind it");
                assert_eq!(sizes[2], sizes[3]);
            }
        }
    }

    #[test]
    fn an_alignment_that_offsets_cannot_reach_is_refused_by_its_key() {
        let structure = structure(StructureKind::Dst);
        let words = vec![header::Header::Leaf { first_triangle: 0 }.encode(); (1 << 26) + 1];
        let memory = Memory { words: &words, ..structure.memory() };
        let layout = NodeLayout { alignment: Bytes(4) };
        let error = place(StructureKind::Dst, &memory, layout).unwrap_err().to_string();
        assert!(error.contains("layout.alignment = 4B") && error.contains("67108864"), "{error}");
    }
}
