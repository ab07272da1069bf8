//! Checks that what a liberty file says can be meant, before it is used: a number that is none, a unit of another world or a
//! function of pins that do not exist would otherwise turn into cells that seem to be missing.

use std::ops::RangeInclusive;

use super::LibertyError;
use super::syntax::Group;

/// Attributes of one number that the reader uses. The flag says whether it may be negative.
const NUMBERS: [(&str, bool); 7] = [
    ("area", false),
    ("capacitance", false),
    ("rise_capacitance", false),
    ("fall_capacitance", false),
    ("max_capacitance", false),
    ("cell_leakage_power", true),
    ("nom_voltage", false),
];

/// Attributes of tables.
const TABLES: [&str; 3] = ["values", "index_1", "index_2"];

/// Supply voltages of semiconductors.
const VOLTS: RangeInclusive<f64> = 0.01..=100.0;

/// Kinds of groups that give a cell a state, which its functions speak of.
pub(super) const STATES: [&str; 5] = ["ff", "latch", "statetable", "ff_bank", "latch_bank"];

/// Checks the numbers of the library `group`, and the functions of its cells.
///
/// # Errors
/// [`LibertyError::Syntax`] with the line of the group that holds what is wrong.
pub(super) fn check(group: &Group) -> Result<(), LibertyError> {
    let volts = group.value("nom_voltage").and_then(|text| text.trim().parse::<f64>().ok());
    if !volts.is_some_and(|volts| VOLTS.contains(&volts)) {
        let what = format!("nom_voltage has to be from {} to {} V", VOLTS.start(), VOLTS.end());
        return Err(LibertyError::Syntax { line: group.line, what });
    }
    numbers(group)?;
    let used = |cell: &&Group| cell.value("dont_use") != Some("true");
    group.of_kind("cell").filter(used).try_for_each(functions)
}

/// Whether `text` is a number that can be meant.
fn is_number(text: &str, negative: bool) -> bool {
    text.trim().parse::<f64>().is_ok_and(|x| x.is_finite() && (negative || x >= 0.0))
}

fn numbers(group: &Group) -> Result<(), LibertyError> {
    let wrong = |name: &str, text: &str| {
        let short: String = text.trim().chars().take(40).collect();
        let what = format!(
            "`{short}` in `{name}` of {} `{}` is no number that can be meant",
            group.kind,
            group.name()
        );
        Err(LibertyError::Syntax { line: group.line, what })
    };
    for (name, values) in &group.attributes {
        let single = NUMBERS.iter().find(|(known, _)| known == name);
        if let Some((_, negative)) = single
            && let Some(text) = values.iter().find(|text| !is_number(text, *negative))
        {
            return wrong(name, text);
        }
        if TABLES.contains(name) {
            let separator = |c: char| c == ',' || c.is_whitespace() || c == '\\';
            let mut entries =
                values.iter().flat_map(|text| text.split(separator)).filter(|text| !text.is_empty());
            if let Some(text) = entries.find(|text| !is_number(text, true)) {
                return wrong(name, text);
            }
        }
    }
    group.groups.iter().try_for_each(numbers)
}

/// Checks that the functions of a cell without state speak of its pins.
fn functions(cell: &Group) -> Result<(), LibertyError> {
    if cell.groups.iter().any(|group| STATES.contains(&group.kind)) {
        return Ok(());
    }
    let is_pin = |name: &str| {
        let mut pins = cell.groups.iter().filter(|group| matches!(group.kind, "pin" | "bus" | "bundle"));
        pins.any(|pin| pin.names.contains(&name))
    };
    for pin in cell.of_kind("pin") {
        let Some(function) = pin.value("function") else { continue };
        let is_part = |c: char| c.is_alphanumeric() || "_[].".contains(c);
        let mut names = function.split(|c| !is_part(c)).filter(|name| !matches!(*name, "" | "0" | "1"));
        if let Some(name) = names.find(|name| !is_pin(name)) {
            let what = format!(
                "the function of pin `{}` of cell `{}` names `{name}`, which is no pin of it",
                pin.name(),
                cell.name()
            );
            return Err(LibertyError::Syntax { line: pin.line, what });
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::super::syntax::parse;
    use super::*;

    fn error(from: &str, to: &str) -> String {
        let text = "library (x) {\nnom_voltage : 1.2;\ncell (nand) {\narea : 2;\npin (A) {\ncapacitance : 0.1;\n}\npin (B) { }\n\
                    pin (Y) {\nfunction : \"!(A * B)\";\ntiming () {\ncell_rise (t) {\nvalues (\"1, 2\", \"3, -4\");\n}\n}\n}\n}\n}\n";
        assert!(check(&parse(text).unwrap()).is_ok() && text.contains(from));
        check(&parse(&text.replace(from, to)).unwrap()).unwrap_err().to_string()
    }

    #[test]
    fn what_cannot_be_meant_is_named_with_its_line() {
        for (from, to, words) in [
            ("3, -4", "3, nan", ["line 12", "`nan`", "`values`"]),
            ("1, 2", "1, two", ["line 12", "`two`", "cell_rise"]),
            ("area : 2", "area : inf", ["line 3", "`area`", "cell `nand`"]),
            ("area : 2", "area : -2", ["line 3", "`-2`", "`area`"]),
            ("capacitance : 0.1", "capacitance : NaN", ["line 5", "`capacitance`", "pin `A`"]),
            ("nom_voltage : 1.2", "nom_voltage : 0", ["line 1", "nom_voltage", "from 0.01"]),
            ("nom_voltage : 1.2", "nom_voltage : nan", ["line 1", "nom_voltage", "100 V"]),
            ("nom_voltage : 1.2", "voltage : 1.2", ["line 1", "nom_voltage", "100 V"]),
            ("A * B", "A * C", ["line 9", "`C`", "cell `nand`"]),
        ] {
            let message = error(from, to);
            assert!(words.iter().all(|word| message.contains(word)), "{from} -> {to}: {message}");
        }
    }

    #[test]
    fn cells_with_a_state_and_constants_speak_of_more_than_pins() {
        let text = "library (x) { nom_voltage : 5; cell (dff) { ff (IQ, IQN) { } pin (Q) { function : \"IQ\"; } }\n\
                    cell (tie) { pin (Y) { function : \"1\"; } } cell (odd) { dont_use : true; pin (Y) { function : \"Z\"; } } }";
        check(&parse(text).unwrap()).unwrap();
    }
}
