//! The syntax tree of a kernel as text, for messages.

use rust_hdl_core::ast::{
    VerilogExpression as Expr, VerilogLink, VerilogOp, VerilogOpUnary, VerilogStatement as Statement,
};

/// Longest text of a statement in a message, in characters.
const LIMIT: usize = 120;

/// One line for a statement; blocks are shown by their head.
pub fn statement_text(statement: &Statement) -> String {
    let mut text = match statement {
        Statement::Assignment(target, value) => {
            format!("{}.next = {}", expression_text(target), expression_text(value))
        }
        Statement::SliceAssignment { base, width, offset, replacement } => format!(
            "{}.next[{} +: {width}] = {}",
            expression_text(base),
            expression_text(offset),
            expression_text(replacement)
        ),
        Statement::If(conditional) => format!("if {}", expression_text(&conditional.test)),
        Statement::Match(matched) => format!("match {}", expression_text(&matched.test)),
        Statement::Loop(looped) => format!("for {} in ..", looped.index),
        Statement::Comment(comment) => format!("// {comment}"),
        Statement::Link(links) => links.iter().map(link_text).collect::<Vec<_>>().join("; "),
        Statement::Macro(block) => block.iter().map(statement_text).collect::<Vec<_>>().join("; "),
    };
    if text.chars().count() > LIMIT {
        text = text.chars().take(LIMIT).chain("...".chars()).collect();
    }
    text
}

fn link_text(link: &VerilogLink) -> String {
    let (arrow, details) = match link {
        VerilogLink::Forward(d) => ("->", d),
        VerilogLink::Backward(d) => ("<-", d),
        VerilogLink::Bidirectional(d) => ("<->", d),
    };
    format!("{} {arrow} {} ({})", details.owner_name, details.other_name, details.my_name)
}

/// An expression in the notation of the kernel, as far as the tree remembers it.
pub fn expression_text(expression: &Expr) -> String {
    match expression {
        Expr::Signal(name) => name.trim_end_matches("$next").replace('$', "."),
        Expr::Literal(literal) => {
            let text = literal.to_string();
            match text.split_once('\'') {
                Some((_, digits)) if digits.starts_with('b') => format!("0b{}", &digits[1..]),
                Some((_, digits)) => match u128::from_str_radix(&digits[1..], 16) {
                    Ok(value) if value < 256 => value.to_string(),
                    _ => format!("0x{}", &digits[1..]),
                },
                None => text,
            }
        }
        Expr::Cast(inner, width) => format!("bit_cast::<{width}, _>({})", expression_text(inner)),
        Expr::Signed(inner) => format!("signed_cast({})", expression_text(inner)),
        Expr::Unsigned(inner) => format!("unsigned_cast({})", expression_text(inner)),
        Expr::Paren(inner) => format!("({})", expression_text(inner)),
        Expr::Binary(left, op, right) => {
            format!("{} {} {}", expression_text(left), operator_text(op), expression_text(right))
        }
        Expr::Unary(op, inner) => match op {
            VerilogOpUnary::Not => format!("!{}", expression_text(inner)),
            VerilogOpUnary::Neg => format!("-{}", expression_text(inner)),
            VerilogOpUnary::All => format!("{}.all()", expression_text(inner)),
            VerilogOpUnary::Any => format!("{}.any()", expression_text(inner)),
            VerilogOpUnary::Xor => format!("{}.xor()", expression_text(inner)),
        },
        Expr::Index(base, index) => format!("{}.get_bit({})", expression_text(base), expression_text(index)),
        Expr::Slice(base, width, offset) => {
            format!("{}.get_bits::<{width}>({})", expression_text(base), expression_text(offset))
        }
        Expr::IndexReplace(base, index, value) => format!(
            "{}.replace_bit({}, {})",
            expression_text(base),
            expression_text(index),
            expression_text(value)
        ),
    }
}

fn operator_text(op: &VerilogOp) -> &'static str {
    match op {
        VerilogOp::Add => "+",
        VerilogOp::Sub => "-",
        VerilogOp::Mul => "*",
        VerilogOp::LogicalAnd => "&&",
        VerilogOp::LogicalOr => "||",
        VerilogOp::BitXor => "^",
        VerilogOp::BitAnd => "&",
        VerilogOp::BitOr => "|",
        VerilogOp::Shl => "<<",
        VerilogOp::Shr => ">>",
        VerilogOp::Eq => "==",
        VerilogOp::Lt => "<",
        VerilogOp::Le => "<=",
        VerilogOp::Ne => "!=",
        VerilogOp::Ge => ">=",
        VerilogOp::Gt => ">",
    }
}
