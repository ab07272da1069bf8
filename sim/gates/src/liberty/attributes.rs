//! What groups say, in our units.

use std::collections::BTreeMap;
use std::ops::RangeInclusive;

use super::syntax::Group;
use super::{Arc, LibertyError, Sense, Table};

/// The units of a file, in ours, and its table templates.
pub(super) struct Context<'t> {
    pub time_ns: f64,
    pub capacitance_ff: f64,
    pub energy_fj: f64,
    pub power_nw: f64,
    templates: BTreeMap<&'t str, &'t Group<'t>>,
}

impl<'t> Context<'t> {
    pub fn new(group: &'t Group<'t>) -> Result<Self, LibertyError> {
        let unit = |attribute: &str, base: &str| {
            let text = group.value(attribute)?;
            scaled(text.strip_suffix(base)?)
        };
        let of = |name: &str, value: Option<f64>, range: RangeInclusive<f64>| match value {
            Some(value) if range.contains(&value) => Ok(value),
            _ => {
                let what = format!(
                    "{name} is missing, or not from {:e} to {:e} of the SI unit",
                    range.start(),
                    range.end()
                );
                Err(LibertyError::Syntax { line: group.line, what })
            }
        };
        let time_ns = of("time_unit", unit("time_unit", "s"), 1e-15..=1e-3)? / 1e-9;
        let load = group.values("capacitive_load_unit").filter(|values| values.len() == 2);
        let load = load.and_then(|values| {
            let prefix = values[1].to_ascii_lowercase();
            Some(number(Some(values[0]))? * scaled(&format!("1{}", prefix.strip_suffix('f')?))?)
        });
        let farads = of("capacitive_load_unit", load, 1e-18..=1e-6)?;
        // Where a library gives no unit, it means nanowatts.
        let watts = group.value("leakage_power_unit").map_or(Some(1e-9), |_| unit("leakage_power_unit", "W"));
        let power_nw = of("leakage_power_unit", watts, 1e-18..=1.0)? / 1e-9;
        let templates = group
            .groups
            .iter()
            .filter(|group| matches!(group.kind, "lu_table_template" | "power_lut_template"))
            .map(|group| (group.name(), group))
            .collect();
        // The unit of energy is that of capacitance times the square of that of voltage, which is the volt.
        Ok(Self { time_ns, capacitance_ff: farads / 1e-15, energy_fj: farads / 1e-15, power_nw, templates })
    }

    /// The middle value of a table of times, as for setup times over two transition times.
    pub fn constraint(&self, parent: &Group, kind: &str) -> Option<f64> {
        let group = parent.of_kind(kind).next()?;
        let mut values = numbers(group.values("values")?);
        values.sort_by(f64::total_cmp);
        values.get(values.len() / 2).map(|value| value * self.time_ns)
    }

    /// A table of `parent`, with values in `unit`.
    pub fn table(&self, parent: &Group, kind: &str, unit: f64) -> Option<Table> {
        let group = parent.of_kind(kind).next()?;
        let template = self.templates.get(group.name());
        let attribute = |name: &str| {
            group.values(name).or_else(|| template.and_then(|template| template.values(name))).map(numbers)
        };
        let values: Vec<f64> = numbers(group.values("values")?).into_iter().map(|x| x * unit).collect();
        let (first, second) = (attribute("index_1"), attribute("index_2"));
        let variable = template.and_then(|template| template.value("variable_1")).unwrap_or_default();
        let load_first = variable.contains("capacitance");
        let in_ns = |axis: Vec<f64>| axis.into_iter().map(|x| x * self.time_ns).collect::<Vec<f64>>();
        let in_ff = |axis: Vec<f64>| axis.into_iter().map(|x| x * self.capacitance_ff).collect::<Vec<f64>>();
        if values.len() == 1 {
            return Some(Table::constant(values[0]));
        }
        match (first, second, load_first) {
            (Some(slews), Some(loads), false) if values.len() == slews.len() * loads.len() => {
                Table::new(in_ns(slews), in_ff(loads), values)
            }
            (Some(loads), Some(slews), true) if values.len() == slews.len() * loads.len() => {
                let (rows, columns) = (loads.len(), slews.len());
                let turned = (0..values.len()).map(|i| values[(i % rows) * columns + i / rows]).collect();
                Table::new(in_ns(slews), in_ff(loads), turned)
            }
            (Some(slews), _, false) if values.len() == slews.len() => {
                Table::new(in_ns(slews), vec![], values)
            }
            (Some(loads), _, true) if values.len() == loads.len() => Table::new(vec![], in_ff(loads), values),
            _ => None,
        }
    }
}

/// A number with a prefix of the metric system.
fn scaled(text: &str) -> Option<f64> {
    let text = text.trim();
    let prefixes = [("f", 1e-15), ("p", 1e-12), ("n", 1e-9), ("u", 1e-6), ("m", 1e-3)];
    let (digits, scale) = prefixes
        .into_iter()
        .find_map(|(prefix, scale)| text.strip_suffix(prefix).map(|digits| (digits, scale)))
        .unwrap_or((text, 1.0));
    Some(digits.trim().parse::<f64>().ok()? * scale)
}

pub(super) fn number(text: Option<&str>) -> Option<f64> {
    text?.trim().parse().ok()
}

fn numbers(values: &[&str]) -> Vec<f64> {
    let separator = |c: char| c == ',' || c.is_whitespace() || c == '\\';
    values.iter().flat_map(|value| value.split(separator)).filter_map(|text| text.parse().ok()).collect()
}

pub(super) fn capacitance(context: &Context, pin: &Group) -> f64 {
    let given = |name: &str| number(pin.value(name)).map(|value| value * context.capacitance_ff);
    let mean = given("rise_capacitance")
        .zip(given("fall_capacitance"))
        .map(|(rise, fall)| f64::midpoint(rise, fall));
    given("capacitance").or(mean).unwrap_or(0.0)
}

pub(super) fn leakage(context: &Context, cell: &Group) -> f64 {
    let states: Vec<f64> = (cell.of_kind("leakage_power"))
        .filter(|group| {
            !group.value("related_pg_pin").is_some_and(|pin| pin.to_ascii_uppercase().contains("VSS"))
        })
        .filter_map(|group| number(group.value("value")))
        .collect();
    let mean = (!states.is_empty()).then(|| states.iter().sum::<f64>() / states.len() as f64);
    number(cell.value("cell_leakage_power")).or(mean).unwrap_or(0.0) * context.power_nw
}

/// Whether the pin drives something outside, with a third state or not.
pub(super) fn is_output(pin: &Group) -> bool {
    pin.value("direction") == Some("output")
}

pub(super) fn is_input(pin: &Group) -> bool {
    pin.value("direction") == Some("input")
}

/// The arc from a pin to an output, the mean over all conditions.
pub(super) fn arc(
    context: &Context,
    output: &Group,
    from: &str,
    wanted: impl Fn(&Group) -> bool,
) -> Option<Arc> {
    let relates = |group: &&Group| {
        group.value("related_pin").is_some_and(|pins| pins.split_whitespace().any(|pin| pin == from))
    };
    let timings: Vec<&Group> =
        output.of_kind("timing").filter(relates).filter(|timing| wanted(timing)).collect();
    // The slowest condition stands for all in timing. That is the first condition with each table, which libraries
    // list as default, or else any.
    let default = timings.iter().find(|timing| timing.value("when").is_none()).or_else(|| timings.first())?;
    let table = |kind: &str| context.table(default, kind, context.time_ns);
    let sense = if timings.iter().all(|timing| timing.value("timing_sense") == Some("positive_unate")) {
        Sense::Positive
    } else if timings.iter().all(|timing| timing.value("timing_sense") == Some("negative_unate")) {
        Sense::Negative
    } else {
        Sense::Both
    };
    let power = output.of_kind("internal_power").filter(relates).filter(|group| {
        // If a cell has several supply pins, the energy is listed at the one that feeds the cell.
        !group.value("related_pg_pin").is_some_and(|pin| pin.to_ascii_uppercase().contains("VSS"))
    });
    let power: Vec<&Group> = power.collect();
    let chosen = power.iter().find(|group| group.value("when").is_none()).or_else(|| power.first());
    let energy = |kind: &str| {
        chosen
            .and_then(|group| {
                context
                    .table(group, kind, context.energy_fj)
                    .or_else(|| context.table(group, "power", context.energy_fj))
            })
            .unwrap_or_else(|| Table::constant(0.0))
    };
    Some(Arc {
        delay_ns: [table("cell_rise")?, table("cell_fall")?],
        transition_ns: [table("rise_transition")?, table("fall_transition")?],
        energy_fj: [energy("rise_power"), energy("fall_power")],
        sense,
    })
}
