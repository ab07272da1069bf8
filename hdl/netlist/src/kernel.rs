//! Symbolic execution of a kernel: assignments become graph nodes, branches become multiplexers.
//!
//! A kernel runs top to bottom with blocking assignments, so a reassigned signal is a new value (static single
//! assignment) and every read sees the latest one. Both branches of an `if` run on copies of the state, and each
//! target that they leave different becomes a multiplexer. Loops unroll. [`Semantics`] says what the expressions
//! mean: by the kernel's own rules, or by those of the Verilog that rust-hdl prints for it.

use rust_hdl_core::ast::{VerilogBlock, VerilogExpression as Expr, VerilogStatement as Statement};

use super::error::{ElaborateError, ErrorKind, Location};
use super::graph::{BinaryOp, Graph, Node, NodeId};
use super::index::{self, LoopVariables};
use super::signals::{Destination, Role, Signal, Signals, parse_literal};
use super::source::statement_text;

/// Whose rules an expression is read by.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Semantics {
    /// Rust: every operation has its own width, a literal that of the other operand.
    Rust,
    /// IEEE 1364: the exported text, with its precedence, 32-bit literals and context-determined widths.
    Verilog,
}

/// The value of a target at one point of the kernel.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Slot {
    /// Nothing assigned it yet.
    Unset,
    /// Assigned on some paths only, since the statement given.
    Partial(String),
    /// This value.
    Value(NodeId),
}

/// A value that a target takes outside any branch: what a name can be given to.
#[derive(Clone, Debug)]
pub struct Version {
    /// Position in [`Signals::targets`].
    pub target: usize,
    /// The value.
    pub node: NodeId,
}

/// A value computed by both semantics in the same state; recorded for the guard.
#[derive(Clone, Debug)]
pub struct Comparison {
    /// The statement that computes it.
    pub statement: String,
    /// One bit: whether the statement executes.
    pub path: NodeId,
    /// The value by Rust's rules.
    pub rust: NodeId,
    /// The value by Verilog's rules.
    pub verilog: NodeId,
}

/// The state of the execution.
pub struct Kernel<'a> {
    pub(super) signals: &'a Signals,
    pub(super) graph: &'a mut Graph,
    pub(super) loops: LoopVariables,
    /// Number of values that Verilog leaves unknown; each is an input of the graph of its own.
    pub(super) unknowns: u32,
    semantics: Semantics,
    pub(super) path: &'a str,
    pub(super) slots: Vec<Slot>,
    versions: Vec<Version>,
    condition: Option<NodeId>,
    comparisons: Option<Vec<Comparison>>,
}

/// What a kernel computes.
pub struct Outcome {
    /// The final value of each target; for clocks the slot is meaningless.
    pub values: Vec<NodeId>,
    /// The values that targets take outside branches, in order.
    pub versions: Vec<Version>,
    /// What was compared, if asked for.
    pub comparisons: Vec<Comparison>,
}

/// Executes a kernel. `path` is the instance path for messages.
///
/// # Errors
/// [`ElaborateError`] with the statement at fault.
pub fn execute(
    block: &VerilogBlock,
    signals: &Signals,
    graph: &mut Graph,
    semantics: Semantics,
    path: &str,
) -> Result<Outcome, ElaborateError> {
    Kernel::new(signals, graph, semantics, path).run(block)
}

/// Executes a kernel by Rust's rules and evaluates each expression by Verilog's rules too, in the same state.
///
/// # Errors
/// [`ElaborateError`] with the statement at fault.
pub fn execute_comparing(
    block: &VerilogBlock,
    signals: &Signals,
    graph: &mut Graph,
    path: &str,
) -> Result<Outcome, ElaborateError> {
    let mut kernel = Kernel::new(signals, graph, Semantics::Rust, path);
    kernel.comparisons = Some(Vec::new());
    kernel.run(block)
}

impl<'a> Kernel<'a> {
    fn new(signals: &'a Signals, graph: &'a mut Graph, semantics: Semantics, path: &'a str) -> Self {
        let slots = vec![Slot::Unset; signals.targets.len()];
        Self {
            signals,
            graph,
            loops: LoopVariables::new(),
            unknowns: 0,
            semantics,
            path,
            slots,
            versions: Vec::new(),
            condition: None,
            comparisons: None,
        }
    }

    fn run(mut self, block: &VerilogBlock) -> Result<Outcome, ElaborateError> {
        self.block(block)?;
        let mut values = Vec::with_capacity(self.slots.len());
        for (slot, target) in self.slots.iter().zip(&self.signals.targets) {
            let (statement, kind) = match slot {
                Slot::Value(node) => {
                    values.push(*node);
                    continue;
                }
                Slot::Unset => (String::new(), ErrorKind::Undriven(display_name(&target.name))),
                Slot::Partial(statement) => (statement.clone(), ErrorKind::Latch(display_name(&target.name))),
            };
            return Err(ElaborateError { at: Location { path: self.path.to_owned(), statement }, kind });
        }
        Ok(Outcome { values, versions: self.versions, comparisons: self.comparisons.unwrap_or_default() })
    }

    pub(super) fn branch(
        &mut self,
        select: NodeId,
        run: impl FnOnce(&mut Self) -> Result<(), ElaborateError>,
    ) -> Result<(), ElaborateError> {
        let outer = self.condition;
        self.condition = Some(match outer {
            Some(outer) => self.graph.binary(BinaryOp::And, outer, select),
            None => select,
        });
        let result = run(self);
        self.condition = outer;
        result
    }

    pub(super) fn branch_in_arm(
        &mut self,
        run: impl FnOnce(&mut Self) -> Result<(), ElaborateError>,
    ) -> Result<(), ElaborateError> {
        let always = self.graph.constant(1, 1);
        self.branch(always, run)
    }

    /// Makes `self.slots` what they are when `select` chooses between `when_true` and them.
    pub(super) fn merge(&mut self, select: NodeId, when_true: Vec<Slot>, statement: &str) {
        if let Some(value) = self.graph.constant_value(select) {
            if value == 1 {
                self.slots = when_true;
            }
            return;
        }
        for (slot, taken) in self.slots.iter_mut().zip(when_true) {
            *slot = match (&taken, &*slot) {
                (a, b) if a == b => continue,
                (Slot::Value(a), Slot::Value(b)) => Slot::Value(self.graph.mux(select, *a, *b)),
                (Slot::Partial(origin), _) | (_, Slot::Partial(origin)) => Slot::Partial(origin.clone()),
                _ => Slot::Partial(statement.to_owned()),
            };
        }
    }

    pub(super) fn assign(&mut self, target: usize, node: NodeId) {
        self.slots[target] = Slot::Value(node);
        if self.condition.is_none() {
            self.versions.push(Version { target, node });
        }
    }

    pub(super) fn name_changes(&mut self, before: &[Slot]) {
        if self.condition.is_some() {
            return;
        }
        for (target, (slot, old)) in self.slots.iter().zip(before).enumerate() {
            if let Slot::Value(node) = *slot
                && slot != old
            {
                self.versions.push(Version { target, node });
            }
        }
    }

    pub(super) fn value(&mut self, expr: &Expr, width: u32, at: &Statement) -> Result<NodeId, ErrorKind> {
        self.both(
            at,
            |kernel| kernel.rust_value_of_width(expr, width),
            |kernel| kernel.verilog_assigned(expr, width),
        )
    }

    pub(super) fn condition(&mut self, expr: &Expr, at: &Statement) -> Result<NodeId, ErrorKind> {
        self.both(at, |kernel| kernel.rust_value_of_width(expr, 1), |kernel| kernel.verilog_condition(expr))
    }

    pub(super) fn scrutinee(&mut self, expr: &Expr, at: &Statement) -> Result<NodeId, ErrorKind> {
        self.both(
            at,
            |kernel| Ok(kernel.rust_value(expr, None)?.node),
            |kernel| kernel.verilog_scrutinee(expr),
        )
    }

    fn both(
        &mut self,
        at: &Statement,
        rust: impl FnOnce(&mut Self) -> Result<NodeId, ErrorKind>,
        verilog: impl FnOnce(&mut Self) -> Result<NodeId, ErrorKind>,
    ) -> Result<NodeId, ErrorKind> {
        if self.semantics == Semantics::Verilog {
            return verilog(self);
        }
        let rust = rust(self)?;
        if self.comparisons.is_some() {
            let verilog = verilog(self)?;
            let verilog = self.graph.resize(verilog, self.graph.width(rust), false);
            let path = self.condition.unwrap_or_else(|| self.graph.constant(1, 1));
            let statement = statement_text(at);
            self.comparisons.iter_mut().for_each(|list| {
                list.push(Comparison { statement: statement.clone(), path, rust, verilog });
            });
        }
        Ok(rust)
    }

    /// The signal with this raw name.
    pub(super) fn lookup(&self, raw: &str) -> Result<&'a Signal, ErrorKind> {
        let name = index::resolve(raw, &self.loops)?;
        self.signals.by_name.get(&name).ok_or_else(|| ErrorKind::Unresolved(display_name(&name)))
    }

    /// The present value of a signal.
    pub(super) fn read(&mut self, name: &str, signal: &Signal) -> Result<NodeId, ErrorKind> {
        match signal.role {
            Role::Source(op) => Ok(self.graph.intern(Node { op, width: signal.width })),
            Role::Constant(value) => Ok(self.graph.constant(value, signal.width)),
            Role::Clock => Err(ErrorKind::Clock(display_name(name))),
            Role::Target(target) => {
                let destination = self.signals.targets[target].destination;
                if !matches!(destination, Destination::Local | Destination::Output(_)) {
                    return Err(ErrorKind::NotUnderstood(format!(
                        "`{}` is an input of an instance; read the signal that drives it",
                        display_name(name)
                    )));
                }
                match &self.slots[target] {
                    Slot::Value(node) => Ok(*node),
                    Slot::Unset => Err(ErrorKind::ReadBeforeWrite(display_name(name))),
                    Slot::Partial(_) => Err(ErrorKind::Latch(display_name(name))),
                }
            }
        }
    }

    /// The value of an expression of literals and loop variables.
    pub(super) fn constant_integer(&self, expr: &Expr) -> Option<u128> {
        use rust_hdl_core::ast::VerilogOp as O;
        match expr {
            Expr::Literal(literal) => parse_literal(&literal.to_string()).ok().map(|(value, _)| value),
            Expr::Signal(name) => self.loops.get(name).map(|&value| u128::from(value)),
            Expr::Paren(inner) => self.constant_integer(inner),
            Expr::Binary(left, op, right) => {
                let (left, right) = (self.constant_integer(left)?, self.constant_integer(right)?);
                match op {
                    O::Add => left.checked_add(right),
                    O::Sub => left.checked_sub(right),
                    O::Mul => left.checked_mul(right),
                    O::Shl => left.checked_shl(u32::try_from(right).ok()?),
                    O::Shr => left.checked_shr(u32::try_from(right).ok()?),
                    _ => None,
                }
            }
            _ => None,
        }
    }
}

/// A kernel name as the author wrote it.
pub fn display_name(name: &str) -> String {
    name.replace('$', ".")
}
