//! What the ports of the catalogue's tops mean, for the document beside the Verilog.
//!
//! A port is known by its name in the source without axis and array position, which are put back behind the meaning. The
//! same name means the same in every top.

/// Name and meaning.
const MEANINGS: &[(&str, &str)] = &[
    ("en_i", "clock enable; low holds every register"),
    ("valid_i", "the operands are valid"),
    ("tag_i", "travels with the operation"),
    ("rounding_i", "0 to nearest even, 1 toward zero, 2 down, 3 up, 4 to nearest, ties away from zero"),
    ("a_i", "first operand"),
    ("b_i", "second operand"),
    ("subtract_i", "1: `a - b`"),
    ("maximum_i", "0 minimum, 1 maximum"),
    ("propagate_nan_i", "0 `minimumNumber`, `maximumNumber`; 1 `minimum`, `maximum` (IEEE 754-2019)"),
    ("header_i", "first word of the node: type, axes, sides, offset"),
    ("plane_i", "plane of the node"),
    ("box_min_i", "lower bound of the box"),
    ("box_max_i", "upper bound of the box"),
    ("origin_i", "ray origin"),
    ("inv_entry_i", "reciprocal of the direction for planes where the ray enters"),
    ("inv_exit_i", "reciprocal of the direction for planes where the ray leaves"),
    ("t_min_i", "start of the ray's interval, not negative"),
    ("t_max_i", "end of the ray's interval"),
    ("mode_i", "0 no pipeline, 1 ray-box, 2 dual-split; changes only while nothing is in flight"),
    ("add_valid_i", "the addition's operands are valid"),
    ("add_tag_i", "travels with the addition"),
    ("add_a_i", "first operand of the addition"),
    ("add_b_i", "second operand of the addition"),
    ("add_subtract_i", "1: subtract"),
    ("mul_valid_i", "the factors are valid"),
    ("mul_tag_i", "travels with the multiplication"),
    ("mul_a_i", "first factor"),
    ("mul_b_i", "second factor"),
    ("valid_o", "the result is valid"),
    ("tag_o", "tag of the result"),
    ("result_o", "the result, rounded once"),
    ("sum_o", "the sum modulo 2^32"),
    ("lt_o", "`a < b`; 0 if either is NaN"),
    ("le_o", "`a <= b`; 0 if either is NaN"),
    ("eq_o", "`a == b`; 0 if either is NaN"),
    ("code_o", "0 miss, 1 one child, 2 two children, 3 leaf"),
    ("near_offset_o", "near child: offset in words; at a leaf its first triangle"),
    ("near_t_min_o", "near child: start of its interval"),
    ("near_t_max_o", "near child: end of its interval"),
    ("far_offset_o", "far child: offset in words"),
    ("far_t_min_o", "far child: start of its interval"),
    ("far_t_max_o", "far child: end of its interval"),
    ("hit_o", "the ray meets the box within its interval"),
    ("t_entry_o", "where the ray enters the box"),
    ("add_valid_o", "the sum is valid"),
    ("add_tag_o", "tag of the sum"),
    ("add_result_o", "the sum, rounded once"),
    ("mul_valid_o", "the product is valid"),
    ("mul_tag_o", "tag of the product"),
    ("mul_result_o", "the product, rounded once"),
    ("node_valid_o", "the dual-split result is valid"),
    ("box_valid_o", "the ray-box result is valid"),
];

/// The meaning of a port, by its Verilog name; `None` if it is not in the table.
pub fn meaning(port: &str) -> Option<String> {
    let find = |name: &str| MEANINGS.iter().find(|(known, _)| *known == name).map(|&(_, meaning)| meaning);
    let (mut stem, suffix) = port.rsplit_once('_')?;
    let mut details = String::new();
    loop {
        if let Some(meaning) = find(&format!("{stem}_{suffix}")) {
            return Some(format!("{meaning}{details}"));
        }
        let (rest, last) = stem.rsplit_once('_')?;
        match last {
            "x" | "y" | "z" => details = format!(", {last}{details}"),
            _ if last.parse::<u32>().is_ok() => details = format!(", number {last}{details}"),
            _ => return None,
        }
        stem = rest;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn axes_and_positions_follow_the_meaning() {
        assert_eq!(meaning("t_min_i").unwrap(), "start of the ray's interval, not negative");
        assert_eq!(meaning("origin_y_i").unwrap(), "ray origin, y");
        assert_eq!(meaning("plane_1_i").unwrap(), "plane of the node, number 1");
        assert_eq!(meaning("box_max_z_3_i").unwrap(), "upper bound of the box, z, number 3");
        assert_eq!(meaning("box_max_w_3_i"), None);
        assert_eq!(meaning("origin"), None);
    }
}
