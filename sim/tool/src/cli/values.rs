//! Parsers of argument values.

use clap::builder::{PossibleValuesParser, TypedValueParser};
use estimate::{Method, embedded_library};
use golden::Mode;
use golden::build::Quality;
use golden::structure::StructureKind;
use machine::frame::MachineStructure;
use pipelines::catalogue::{StandardFormat, Top};
use render::Test;
use scenes::Format;
use studies::input::quality_name;
use studies::trees::TreeKind;
use view::picture::heatmap::Quantity;

/// Accepts the names of `all`.
pub fn one_of<T: Copy + Send + Sync + 'static, const N: usize>(
    all: [T; N],
    name: fn(T) -> &'static str,
) -> impl TypedValueParser<Value = T> {
    PossibleValuesParser::new(all.map(name))
        .map(move |chosen| all.into_iter().find(|x| name(*x) == chosen).expect("a possible value"))
}

pub fn unit() -> impl TypedValueParser<Value = Top> {
    PossibleValuesParser::new(Top::ALL.iter().map(|top| top.name()))
        .map(|chosen| chosen.parse().expect("a possible value"))
}

pub fn format() -> impl TypedValueParser<Value = StandardFormat> {
    PossibleValuesParser::new(StandardFormat::ALL.iter().map(|format| format.name()))
        .map(|chosen| chosen.parse().expect("a possible value"))
}

pub fn structure() -> impl TypedValueParser<Value = StructureKind> {
    one_of(StructureKind::ALL, StructureKind::name)
}

pub fn row() -> impl TypedValueParser<Value = TreeKind> {
    one_of(TreeKind::ALL, TreeKind::name)
}

pub fn machine_structure() -> impl TypedValueParser<Value = MachineStructure> {
    one_of(MachineStructure::ALL, MachineStructure::name)
}

/// How the cost of a pipeline is found.
#[derive(Clone, Copy, Debug)]
pub enum PipelineCostMethod {
    Published,
    Netlist,
    Scaled,
}

impl PipelineCostMethod {
    fn name(self) -> &'static str {
        match self {
            Self::Published => "published",
            Self::Netlist => "netlist",
            Self::Scaled => "scaled",
        }
    }

    /// The method with the embedded library.
    pub fn method(self) -> Method<'static> {
        match self {
            Self::Published => Method::Published,
            Self::Netlist => Method::Netlist(embedded_library()),
            Self::Scaled => Method::Scaled(embedded_library()),
        }
    }
}

pub fn pipeline_cost() -> impl TypedValueParser<Value = PipelineCostMethod> {
    use PipelineCostMethod::{Netlist, Published, Scaled};
    one_of([Published, Netlist, Scaled], PipelineCostMethod::name)
}

pub fn scene_format() -> impl TypedValueParser<Value = Format> {
    one_of(Format::ALL, Format::name)
}

pub fn test() -> impl TypedValueParser<Value = Test> {
    one_of(Test::ALL, Test::name)
}

pub fn mode() -> impl TypedValueParser<Value = Mode> {
    one_of([Mode::Fast, Mode::Robust], Mode::name)
}

pub fn quantity() -> impl TypedValueParser<Value = Quantity> {
    one_of(Quantity::ALL, Quantity::name)
}

pub fn quality() -> impl TypedValueParser<Value = Quality> {
    one_of([Quality::Fast, Quality::Medium, Quality::High], quality_name)
}

pub fn not_negative(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(x) if x >= 0.0 && x.is_finite() => Ok(x),
        _ => Err("write a number that is not negative, such as 0.05".to_owned()),
    }
}

/// A factor of 1 or more.
pub fn factor(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(x) if x >= 1.0 && x.is_finite() => Ok(x),
        _ => Err("write a number of at least 1, such as 64".to_owned()),
    }
}

/// A fraction above 0 and at most 1, written as a number or in percent.
pub fn fraction(text: &str) -> Result<f64, String> {
    let (number, scale) = text.strip_suffix('%').map_or((text, 1.0), |number| (number, 100.0));
    match number.trim().parse::<f64>() {
        Ok(x) if x > 0.0 && x <= scale => Ok(x / scale),
        _ => Err("write a fraction above 0 and at most 1, such as 0.1 or 10%".to_owned()),
    }
}

pub fn vector(text: &str) -> Result<[f32; 3], String> {
    let parsed: Result<Vec<f32>, _> = text.split(',').map(|part| part.trim().parse()).collect();
    match parsed.map(<[f32; 3]>::try_from) {
        Ok(Ok(vector)) if vector.iter().all(|x| x.is_finite()) => Ok(vector),
        _ => Err("write three finite numbers separated by commas, such as 1,2.5,-3".to_owned()),
    }
}

pub fn size(text: &str) -> Result<[u32; 2], String> {
    integers(text, 'x').ok_or_else(|| "write WIDTHxHEIGHT in pixels, such as 512x384".to_owned())
}

pub fn pixel(text: &str) -> Result<[u32; 2], String> {
    integers(text, ',').ok_or_else(|| "write COLUMN,ROW counted from 0, such as 200,120".to_owned())
}

pub fn integers(text: &str, separator: char) -> Option<[u32; 2]> {
    let (first, second) = text.split_once(separator)?;
    Some([first.trim().parse().ok()?, second.trim().parse().ok()?])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fractions() {
        assert_eq!(fraction("2%"), Ok(0.02));
        assert_eq!(fraction("0.25"), Ok(0.25));
        for bad in ["", "0", "-1%", "101%", "1.5", "nan", "%"] {
            assert!(fraction(bad).is_err(), "{bad}");
        }
    }

    #[test]
    fn vectors_and_pairs() {
        assert_eq!(vector("1, -2.5,3e2"), Ok([1.0, -2.5, 300.0]));
        for bad in ["", "1,2", "1,2,3,4", "1,2,x", "1,2,nan", "1,2,inf"] {
            assert!(vector(bad).is_err(), "{bad}");
        }
        assert_eq!(size("64x32"), Ok([64, 32]));
        assert_eq!(pixel("0,7"), Ok([0, 7]));
        for bad in ["64", "64x", "-1x2", "64,32"] {
            assert!(size(bad).is_err(), "{bad}");
        }
    }
}
