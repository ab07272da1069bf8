//! How a module tells its type to a visitor of the elaborated hierarchy.
//!
//! `rust-hdl` probes a design through `&dyn Block`, which does not know the type of a module. Its only free-form
//! description is [`Logic::timing`], which registers use to name their ports. A module here answers it with its kind and
//! parameters, so that tools can count units and emit each distinct module once.

use rust_hdl_core::prelude::*;

/// What [`Logic::timing`] calls a register, as rust-hdl's own flip-flop does.
pub(crate) const REGISTER: &str = "dff";
/// What [`Logic::timing`] calls a register that reset clears.
pub(crate) const RESET_REGISTER: &str = "dff_reset";
/// Separates kind and parameters in [`Logic::timing`]'s name; it occurs in neither.
const SEPARATOR: char = ' ';

/// Kinds of module whose logic proofs take as a black box and synthesis may replace.
pub const MULTIPLIER_KINDS: &[&str] = &["significand_product"];

/// The type of a module.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ModuleName {
    /// Name of the source module, such as `fp_add`.
    pub kind: String,
    /// Values of its generics, such as `e8m23_t1`; empty if it has none.
    pub parameters: String,
}

impl ModuleName {
    /// The type of `block`, or `None` for a register or a block from elsewhere.
    #[must_use]
    pub fn of(block: &dyn Block) -> Option<Self> {
        let info = block.timing().into_iter().next()?;
        let (kind, parameters) = info.name.split_once(SEPARATOR)?;
        Some(Self { kind: kind.into(), parameters: parameters.into() })
    }

    /// Kind and parameters as one identifier, such as `fp_add_e8m23_t1`.
    #[must_use]
    pub fn identifier(&self) -> String {
        if self.parameters.is_empty() {
            self.kind.clone()
        } else {
            format!("{}_{}", self.kind, self.parameters)
        }
    }
}

/// Whether `block` is a register: output `q` takes the value of input `d` at a rising edge of `clock`.
#[must_use]
pub fn is_register(block: &dyn Block) -> bool {
    block.timing().iter().any(|info| [REGISTER, RESET_REGISTER].contains(&&*info.name))
}

/// The answer of a module to [`Logic::timing`].
#[must_use]
pub fn named(kind: &str, parameters: &str) -> Vec<TimingInfo> {
    let name = format!("{kind}{SEPARATOR}{parameters}");
    vec![TimingInfo { name, clock: String::new(), inputs: vec![], outputs: vec![] }]
}

/// The answer of a register to [`Logic::timing`].
#[must_use]
pub fn register() -> Vec<TimingInfo> {
    called(REGISTER)
}

/// The answer of a register that reset clears to [`Logic::timing`].
#[must_use]
pub fn reset_register() -> Vec<TimingInfo> {
    called(RESET_REGISTER)
}

fn called(kind: &str) -> Vec<TimingInfo> {
    vec![TimingInfo {
        name: kind.into(),
        clock: "clock".into(),
        inputs: vec!["d".into()],
        outputs: vec!["q".into()],
    }]
}
