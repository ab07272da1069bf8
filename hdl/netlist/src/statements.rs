//! The statements of a kernel: assignments, links, branches, loops.

use std::collections::BTreeSet;

use rust_hdl_core::ast::{
    VerilogBlock, VerilogBlockOrConditional, VerilogConditional, VerilogExpression as Expr, VerilogLink,
    VerilogLinkDetails, VerilogLoop, VerilogMatch, VerilogStatement as Statement,
};

use super::error::{ElaborateError, ErrorKind, Location};
use super::graph::{BinaryOp, UnaryOp, mask};
use super::index;
use super::kernel::{Kernel, Slot, display_name};
use super::signals::{Destination, Role, Signal, parse_literal};
use super::source::statement_text;

impl Kernel<'_> {
    pub(super) fn block(&mut self, block: &VerilogBlock) -> Result<(), ElaborateError> {
        block.iter().try_for_each(|statement| self.statement(statement))
    }

    fn statement(&mut self, statement: &Statement) -> Result<(), ElaborateError> {
        let at = |kind| ElaborateError {
            at: Location { path: self.path.to_owned(), statement: statement_text(statement) },
            kind,
        };
        match statement {
            Statement::Assignment(target, value) => self.assignment(target, value, statement).map_err(at),
            Statement::SliceAssignment { base, width, offset, replacement } => {
                self.slice_assignment(base, *width, offset, replacement, statement).map_err(at)
            }
            Statement::Link(links) => links.iter().try_for_each(|link| self.link(link)).map_err(at),
            Statement::If(conditional) => self.conditional(conditional, statement),
            Statement::Match(matched) => self.matched(matched, statement),
            Statement::Loop(looped) => self.unroll(looped, statement),
            Statement::Macro(block) => self.block(block),
            Statement::Comment(_) => Ok(()),
        }
    }

    fn assignment(&mut self, target: &Expr, value: &Expr, at: &Statement) -> Result<(), ErrorKind> {
        let target = self.target(target)?;
        let declared = &self.signals.targets[target];
        if declared.destination == Destination::Clock {
            let name = display_name(&declared.name);
            return match self.as_clock(value) {
                true => {
                    let any = self.graph.constant(0, 1);
                    self.assign(target, any);
                    Ok(())
                }
                false => Err(ErrorKind::Clock(name)),
            };
        }
        let width = declared.width;
        let node = self.value(value, width, at)?;
        self.assign(target, node);
        Ok(())
    }

    fn slice_assignment(
        &mut self,
        base: &Expr,
        width: usize,
        offset: &Expr,
        value: &Expr,
        at: &Statement,
    ) -> Result<(), ErrorKind> {
        let target = self.target(base)?;
        let declared = &self.signals.targets[target];
        let total = declared.width;
        let Slot::Value(whole) = self.slots[target] else {
            return Err(ErrorKind::ReadBeforeWrite(display_name(&declared.name)));
        };
        let low = self
            .constant_integer(offset)
            .and_then(|low| u32::try_from(low).ok())
            .ok_or_else(|| ErrorKind::NotUnderstood("a field at a variable offset".into()))?;
        let width = u32::try_from(width).map_err(|_| ErrorKind::UnsupportedWidth(width))?;
        if width == 0 || low.checked_add(width).is_none_or(|end| end > total) {
            return Err(ErrorKind::WidthMismatch { left: total, right: low.saturating_add(width) });
        }
        let mut joined = self.value(value, width, at)?;
        if low > 0 {
            let below = self.graph.slice(whole, 0, low);
            joined = self.graph.concat(joined, below);
        }
        if low + width < total {
            let above = self.graph.slice(whole, low + width, total - low - width);
            joined = self.graph.concat(above, joined);
        }
        self.assign(target, joined);
        Ok(())
    }

    fn link(&mut self, link: &VerilogLink) -> Result<(), ErrorKind> {
        let (from, to, details) = match link {
            VerilogLink::Forward(d) => (&d.owner_name, &d.other_name, d),
            VerilogLink::Backward(d) => (&d.other_name, &d.owner_name, d),
            VerilogLink::Bidirectional(_) => {
                return Err(ErrorKind::NotUnderstood("a bidirectional link".into()));
            }
        };
        let (from, to) = (self.linked(from, details)?, self.linked(to, details)?);
        let target = self.target_of_name(&to)?;
        let source = self.lookup(&from)?.clone();
        let declared = &self.signals.targets[target];
        if declared.destination == Destination::Clock {
            if source.role != Role::Clock {
                return Err(ErrorKind::Clock(display_name(&to)));
            }
            let any = self.graph.constant(0, 1);
            self.assign(target, any);
            return Ok(());
        }
        if declared.width != source.width {
            return Err(ErrorKind::WidthMismatch { left: declared.width, right: source.width });
        }
        let node = self.read(&from, &source)?;
        self.assign(target, node);
        Ok(())
    }

    fn linked(&self, base: &str, details: &VerilogLinkDetails) -> Result<String, ErrorKind> {
        let field = details.my_name.trim_start_matches('.').replace('.', "$");
        let base = index::resolve(base, &self.loops)?;
        Ok(if field.is_empty() { base } else { format!("{base}${field}") })
    }

    fn conditional(&mut self, c: &VerilogConditional, at: &Statement) -> Result<(), ElaborateError> {
        let select = self.condition(&c.test, at).map_err(|kind| ElaborateError {
            at: Location { path: self.path.to_owned(), statement: statement_text(at) },
            kind,
        })?;
        let before = self.slots.clone();
        self.branch(select, |kernel| kernel.block(&c.then))?;
        let after_then = std::mem::replace(&mut self.slots, before.clone());
        let inverse = self.graph.unary(UnaryOp::Not, select);
        self.branch(inverse, |kernel| match &c.otherwise {
            VerilogBlockOrConditional::Block(block) => kernel.block(block),
            VerilogBlockOrConditional::Conditional(statement) => kernel.statement(statement),
            VerilogBlockOrConditional::None => Ok(()),
        })?;
        self.merge(select, after_then, &statement_text(at));
        self.name_changes(&before);
        Ok(())
    }

    fn matched(&mut self, m: &VerilogMatch, at: &Statement) -> Result<(), ElaborateError> {
        let wrap = |kind, path: &str| ElaborateError {
            at: Location { path: path.to_owned(), statement: statement_text(at) },
            kind,
        };
        let tested = self.scrutinee(&m.test, at).map_err(|kind| wrap(kind, self.path))?;
        let width = self.graph.width(tested);
        let before = self.slots.clone();
        let mut covered = BTreeSet::new();
        let mut arms = Vec::new();
        let mut otherwise = before.clone();
        for case in &m.cases {
            if case.condition == "default" {
                self.slots = before.clone();
                self.branch_in_arm(|kernel| kernel.block(&case.block))?;
                otherwise = std::mem::take(&mut self.slots);
                break;
            }
            let value = self.pattern(&case.condition, width).map_err(|kind| wrap(kind, self.path))?;
            covered.insert(value);
            let constant = self.graph.constant(value, width);
            let select = self.graph.binary(BinaryOp::Eq, tested, constant);
            self.slots = before.clone();
            self.branch(select, |kernel| kernel.block(&case.block))?;
            arms.push((select, std::mem::take(&mut self.slots)));
            // When every encoding has its arm the last one needs no test.
            if covered.len() as u128 - 1 == mask(width) {
                otherwise = arms.pop().map_or(otherwise, |(_, slots)| slots);
                break;
            }
        }
        self.slots = otherwise;
        for (select, slots) in arms.into_iter().rev() {
            self.merge(select, slots, &statement_text(at));
        }
        self.name_changes(&before);
        Ok(())
    }

    fn unroll(&mut self, looped: &VerilogLoop, at: &Statement) -> Result<(), ElaborateError> {
        let wrap = |kind, path: &str| ElaborateError {
            at: Location { path: path.to_owned(), statement: statement_text(at) },
            kind,
        };
        let bound = |text: String| -> Result<u64, ErrorKind> {
            u64::try_from(parse_literal(&text)?.0)
                .map_err(|_| ErrorKind::NotUnderstood(format!("bound {text}")))
        };
        let from = bound(looped.from.to_string()).map_err(|kind| wrap(kind, self.path))?;
        let to = bound(looped.to.to_string()).map_err(|kind| wrap(kind, self.path))?;
        let outer = self.loops.get(&looped.index).copied();
        for value in from..to {
            self.loops.insert(looped.index.clone(), value);
            self.block(&looped.block)?;
        }
        match outer {
            Some(value) => self.loops.insert(looped.index.clone(), value),
            None => self.loops.remove(&looped.index),
        };
        Ok(())
    }

    fn pattern(&self, text: &str, width: u32) -> Result<u128, ErrorKind> {
        let name = text.replace("::", "$");
        if let Some(&(value, label_width)) = self.signals.labels.get(&name) {
            return if label_width == width {
                Ok(value)
            } else {
                Err(ErrorKind::WidthMismatch { left: width, right: label_width })
            };
        }
        let digits = text.split_once('u').map_or(text, |(digits, _)| digits).replace('_', "");
        let value = match digits.split_at_checked(2) {
            _ if text == "true" || text == "false" => {
                // rust-hdl prints the word as it is, an undeclared name in Verilog.
                return Err(ErrorKind::NotUnderstood(format!("the pattern `{text}`; use `if`")));
            }
            Some(("0x", hex)) => u128::from_str_radix(hex, 16).ok(),
            Some(("0b", binary)) => u128::from_str_radix(binary, 2).ok(),
            _ => digits.parse().ok(),
        };
        match value {
            Some(value) if value <= mask(width) => Ok(value),
            Some(value) => Err(ErrorKind::WidthMismatch { left: width, right: 128 - value.leading_zeros() }),
            None => Err(ErrorKind::Unresolved(text.to_owned())),
        }
    }

    fn as_clock(&self, value: &Expr) -> bool {
        match value {
            Expr::Signal(name) => self.lookup(name).is_ok_and(|signal| signal.role == Role::Clock),
            Expr::Paren(inner) => self.as_clock(inner),
            _ => false,
        }
    }

    fn target(&self, expr: &Expr) -> Result<usize, ErrorKind> {
        match expr {
            Expr::Signal(name) => self.target_of_name(&index::resolve(name, &self.loops)?),
            _ => Err(ErrorKind::NotUnderstood("an assignment to something that is no signal".into())),
        }
    }

    fn target_of_name(&self, name: &str) -> Result<usize, ErrorKind> {
        match self.signals.by_name.get(name) {
            Some(Signal { role: Role::Target(target), .. }) => Ok(*target),
            Some(_) => Err(ErrorKind::MultipleDrivers(display_name(name))),
            None => Err(ErrorKind::Unresolved(display_name(name))),
        }
    }
}
