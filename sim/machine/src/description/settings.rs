//! Reading a description, with single keys replaced by `--set`.

use super::{DescriptionError, MachineDescription};
use toml::{Table, Value};

/// The description in `text` from `source` with `settings` applied.
pub(super) fn parse(
    source: &str,
    text: &str,
    settings: &[String],
) -> Result<MachineDescription, DescriptionError> {
    let invalid = |error: toml::de::Error| DescriptionError::Parse {
        file: source.to_owned(),
        message: shortened(&error.to_string()),
    };
    // Before the settings, for messages that quote the line of the file.
    let machine: MachineDescription = base::toml_text::parse(text).map_err(invalid)?;
    if settings.is_empty() {
        return Ok(machine);
    }
    // Of what was read, so that keys that the file leaves out have their section.
    let mut table = Table::try_from(&machine).expect("every field has a TOML form");
    for setting in settings {
        apply(&mut table, setting)?;
        let refused = |error: toml::de::Error| DescriptionError::Setting {
            setting: setting.clone(),
            message: error.message().to_owned(),
        };
        table.clone().try_into::<MachineDescription>().map_err(refused)?;
    }
    table.try_into().map_err(invalid)
}

/// `message` without the end of long lines: it quotes the line of the file.
fn shortened(message: &str) -> String {
    const MOST_CHARS: usize = 200;
    let short = |line: &str| line.chars().take(MOST_CHARS).collect::<String>();
    message.trim_end().lines().map(short).collect::<Vec<_>>().join("\n")
}

fn apply(table: &mut Table, setting: &str) -> Result<(), DescriptionError> {
    let refused = |message: String| DescriptionError::Setting { setting: setting.to_owned(), message };
    let (path, value) = setting
        .split_once('=')
        .ok_or_else(|| refused("write KEY=VALUE, such as l1.size=64KiB".to_owned()))?;
    let (path, value) = (path.trim(), value.trim());
    let mut keys: Vec<&str> = path.split('.').collect();
    let last = keys.pop().unwrap_or_default();
    let mut at = table;
    for key in keys {
        at = match at.get_mut(key) {
            Some(Value::Table(table)) => table,
            _ => return Err(refused(format!("there is no section `{key}`"))),
        };
    }
    // A bare word is a string.
    let parsed =
        base::toml_text::parse::<Table>(&format!("x = {value}")).ok().and_then(|mut table| table.remove("x"));
    at.insert(last.to_owned(), parsed.unwrap_or_else(|| Value::String(value.to_owned())));
    Ok(())
}
