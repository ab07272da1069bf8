//! Reads the instance tree of a rust-hdl module: scopes, atoms and kernels, nothing interpreted.

use rust_hdl_core::prelude::{Atom, AtomKind, Block, Probe, TimingInfo, TypeKind, Verilog};

use super::design::SignalType;

/// One atom of a block: a port, a local signal or a constant.
#[derive(Clone, Debug, PartialEq)]
pub struct AtomDecl {
    /// Field name, `$`-joined with array positions and interface names.
    pub name: String,
    /// Direction or role.
    pub kind: AtomKind,
    /// Width in bits; may be out of range, checked by elaboration.
    pub width: usize,
    /// How the bits are meant.
    pub signal_type: SignalType,
    /// Whether the type is rust-hdl's `Clock`.
    pub is_clock: bool,
    /// The present value as rust-hdl prints it, `8'hff`: the value of a constant, the power-up value of others.
    pub literal: String,
}

/// One block of the instance tree.
#[derive(Clone, Debug)]
pub struct Scope {
    /// Field name in the parent, `$`-joined with array positions.
    pub name: String,
    /// What the block is called, if it says so by its first [`TimingInfo`].
    pub timing: Option<TimingInfo>,
    /// The kernel.
    pub code: Verilog,
    /// Atoms in order of declaration.
    pub atoms: Vec<AtomDecl>,
    /// Sub-blocks in order of declaration.
    pub children: Vec<Scope>,
}

/// The instance tree under `block`.
pub fn read(block: &dyn Block, name: &str) -> Option<Scope> {
    let mut reader = Reader::default();
    block.accept(name, &mut reader);
    reader.finished
}

#[derive(Default)]
struct Reader {
    open: Vec<Scope>,
    namespace: Vec<String>,
    finished: Option<Scope>,
}

impl Probe for Reader {
    fn visit_start_scope(&mut self, name: &str, node: &dyn Block) {
        self.open.push(Scope {
            name: name.to_owned(),
            timing: node.timing().into_iter().next(),
            code: node.hdl(),
            atoms: Vec::new(),
            children: Vec::new(),
        });
    }

    fn visit_start_namespace(&mut self, name: &str, _node: &dyn Block) {
        self.namespace.push(name.to_owned());
    }

    fn visit_end_namespace(&mut self, _name: &str, _node: &dyn Block) {
        self.namespace.pop();
    }

    fn visit_atom(&mut self, name: &str, signal: &dyn Atom) {
        let Some(scope) = self.open.last_mut() else { return };
        let mut full = self.namespace.join("$");
        if !full.is_empty() {
            full.push('$');
        }
        full.push_str(name);
        let descriptor = signal.descriptor();
        let signal_type = match &descriptor.kind {
            TypeKind::Signed(_) => SignalType::Signed,
            TypeKind::Enum(labels) => SignalType::Enum(labels.clone()),
            TypeKind::Bits(_) | TypeKind::Composite(_) => SignalType::Bits,
        };
        scope.atoms.push(AtomDecl {
            name: full,
            kind: signal.kind(),
            width: signal.bits(),
            signal_type,
            is_clock: descriptor.name == "clock",
            literal: signal.verilog().to_string(),
        });
    }

    fn visit_end_scope(&mut self, _name: &str, _node: &dyn Block) {
        let Some(scope) = self.open.pop() else { return };
        match self.open.last_mut() {
            Some(parent) => parent.children.push(scope),
            None => self.finished = Some(scope),
        }
    }
}
