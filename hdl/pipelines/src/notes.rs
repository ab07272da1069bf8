//! What the exported package of a top says about its words, and what its checker asserts.

use golden::dst::Code;
use golden::dst::header::{AXIS, CARVE, Field, LEAF, OFFSET, SINGLE, SIZE, dual_axes};
use netlist::verilog::{Claim, Form, PackageOptions, ResultCode};

use crate::catalogue::{StandardFormat, Top};

impl Top {
    /// A package of this top in `format` with everything that is known of its words and measured of it: no description, a clock of 1 ns.
    #[must_use]
    pub fn package_options(self, format: StandardFormat, form: Form<'_>) -> PackageOptions<'_> {
        let measured = self.measured(format).map(|measured| measured.to_string());
        let sections = [self.notes(), measured.unwrap_or_default()];
        let is_dual_split = matches!(self, Self::DualSplit | Self::DualSplitLean);
        PackageOptions {
            notes: sections.into_iter().filter(|section| !section.is_empty()).collect::<Vec<_>>().join("\n"),
            form,
            is_pipeline: self.is_pipeline(),
            claims: if is_dual_split { dual_split_claims() } else { vec![] },
            codes: if is_dual_split { dual_split_codes() } else { vec![] },
            ..PackageOptions::default()
        }
    }

    /// Sections of the README: the encodings of the words that the top reads.
    fn notes(self) -> String {
        match self {
            Self::FpAdd | Self::FpMul => {
                "## Rounding\n\n`rounding_i` is 0 to nearest, ties to even; 1 toward zero; 2 down; 3 up; 4 to nearest, ties away from \
                 zero. The codes 5, 6 and 7 are reserved; they round toward zero.\n"
                    .into()
            }
            Self::DualSplit | Self::DualSplitLean | Self::SharedUnits => header_note(),
            _ => String::new(),
        }
    }
}

fn dual_split_claims() -> Vec<Claim> {
    let (leaf, carve) = (LEAF.low, CARVE.low);
    let bare_leaf = format!("header_i_then[{leaf}] & ~header_i_then[{carve}]");
    vec![
        Claim {
            name: "leaf_holds",
            meaning: "Code 3 is returned for leaves alone, and codes 1 and 2 never.",
            holds: format!("(code_o == 2'd0) | ((code_o == 2'd3) == header_i_then[{leaf}])"),
        },
        Claim {
            name: "two_holds",
            meaning: "Two children are those of a split.",
            holds: format!("(code_o != 2'd2) | ~header_i_then[{carve}]"),
        },
        Claim {
            name: "near_interval_holds",
            meaning: "An accepted child has an interval that is not empty. A bare leaf keeps the ray's.",
            holds: format!("(code_o == 2'd0) | ({bare_leaf}) | ordered(near_t_min_o, near_t_max_o)"),
        },
        Claim {
            name: "far_interval_holds",
            meaning: "So has the far child.",
            holds: "(code_o != 2'd2) | ordered(far_t_min_o, far_t_max_o)".into(),
        },
    ]
}

/// The return values of a step.
fn dual_split_codes() -> Vec<ResultCode> {
    let code = |name, code: Code, meaning| ResultCode { name, value: code as u8, meaning };
    vec![
        code("Miss", Code::Miss, "no child"),
        code("One", Code::One, "one child, in the near slot"),
        code("Two", Code::Two, "two children"),
        code("Leaf", Code::Leaf, "a leaf, in the near slot"),
    ]
}

/// The table of a node's header, with the codes that no valid node has.
fn header_note() -> String {
    let bits = |field: Field| match field.width {
        1 => field.low.to_string(),
        width => format!("{}:{}", field.low + width - 1, field.low),
    };
    let axes = |kind: u32| dual_axes(kind).map(|axis| ["x", "y", "z"][axis as usize]).join(" and ");
    let kinds: Vec<String> = (0..4)
        .filter(|&kind| kind != SINGLE)
        .map(|kind| format!("{kind} dual carve of {}", axes(kind)))
        .collect();
    let rows = [
        (CARVE, "0".to_owned(), "1".to_owned(), "0"),
        (AXIS, "axis: 0 x, 1 y, 2 z".to_owned(), format!("{}; {SINGLE} single carve", kinds.join(", ")), "0"),
        (
            SIZE,
            "size of the left child in words: 1 or 3".to_owned(),
            "dual carve: the upper bit for plane 0, the lower for plane 1, 1 where the plane is the box's min side; single carve: axis 0, 1, 2"
                .to_owned(),
            "0",
        ),
        (LEAF, "0".to_owned(), "1 where the child is a leaf".to_owned(), "1"),
        (
            OFFSET,
            "left child, in words of 32 bits from the start of the tree; the right child follows it".to_owned(),
            "child in words, or index of the leaf's first triangle".to_owned(),
            "index of the first triangle",
        ),
    ];
    let mut text =
        String::from("## Node\n\n| bits of `header_i` | split | carve | bare leaf |\n|---|---|---|---|\n");
    for (field, split, carve, leaf) in rows {
        text.push_str(&format!("| {} | {split} | {carve} | {leaf} |\n", bits(field)));
    }
    text.push_str(
        "\n| node | `plane_0_i` | `plane_1_i` |\n|---|---|---|\n| split | max plane of the left child | min plane of the right child |\n\
         | single carve | max plane of the box | min plane of the box |\n| dual carve | plane on the first axis | plane on the second axis |\n\
         | bare leaf | ignored | ignored |\n\n\
         The axis code 3 of a split and of a single carve is reserved, as are the sizes 0 and 2; the hardware takes axis 3 for z, and adds any \
         size. The other bits of a bare leaf are ignored.\n",
    );
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_note_has_the_fields_where_golden_has_them() {
        let note = header_note();
        for row in [
            "| 31 | 0 | 1 | 0 |",
            "| 30:29 | axis",
            "0 dual carve of x and y",
            "| 28:27 |",
            "| 26 |",
            "| 25:0 |",
        ] {
            assert!(note.contains(row), "{row}: {note}");
        }
    }
}
