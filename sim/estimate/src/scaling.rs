//! Scaling between technologies: Stillmaker and Baas, "Scaling equations for the accurate prediction of CMOS device
//! performance from 180 nm to 7 nm", Integration 58, 2017, with the coefficients of the published corrigendum.

use serde::Serialize;

use gates::liberty::Library;

/// The technology of the published figures.
pub const TARGET_NODE_NM: u32 = 65;
/// The supply voltage assumed for the published figures; the paper does not state it.
pub const TARGET_VOLTAGE_V: f64 = 1.1;
/// The lowest and the highest supply voltage that the paper may mean: the ends of the energy's error bar.
const TARGET_VOLTAGES_V: [f64; 2] = [1.0, 1.2];
/// The scaled areas of one netlist in three open libraries differ by this fraction either way.
pub const AREA_ERROR: f64 = 0.3;
/// The scaled energies of one netlist in three open libraries differ by this factor from least to most.
pub const ENERGY_ERROR_FACTOR: f64 = 4.0;

/// The paper's clock, 1 GHz at 65 nm, in delays of an inverter that drives four of its kind: such a delay takes 360 ps, in a slow corner
/// 500 ps, for each micrometre of gate length (Ho, Mai, Horowitz, "The Future of Wires", Proceedings of the IEEE, 2001).
pub const PAPER_CLOCK_FO4: std::ops::RangeInclusive<u32> = 31..=43;

/// Factors from a library's technology to 65 nm.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Scaling {
    /// The library's node in nanometres.
    pub node_nm: u32,
    /// The library's supply voltage.
    pub voltage_v: f64,
    /// Factor of area.
    pub area: f64,
    /// Factor of energy at [`TARGET_VOLTAGE_V`].
    pub energy: f64,
    /// The factor of energy at 1.0 V, and at 1.2 V.
    pub energy_range: [f64; 2],
}

/// Energy at a voltage, as coefficients of V^2, V and 1, in arbitrary units common to all nodes.
fn energy(node_nm: u32, voltage_v: f64) -> Option<f64> {
    let [a, b, c] = match node_nm {
        45 => [1.018, -0.3107, 0.1539],
        65 => [3.755, -4.398, 1.975],
        130 => [7.171, -6.709, 2.904],
        _ => return None,
    };
    Some(a * voltage_v * voltage_v + b * voltage_v + c)
}

impl Scaling {
    /// The factors for a library, if its node is known and has coefficients.
    #[must_use]
    pub fn of(library: &Library) -> Option<Self> {
        let node_nm = library.node_nm?;
        let area = match node_nm {
            45 => 1.5,
            130 => 0.23,
            _ => return None,
        };
        let own = energy(node_nm, library.voltage_v)?;
        let to = |voltage_v| energy(TARGET_NODE_NM, voltage_v).map(|target| target / own);
        let [low, high] = TARGET_VOLTAGES_V.map(to);
        Some(Self {
            node_nm,
            voltage_v: library.voltage_v,
            area,
            energy: to(TARGET_VOLTAGE_V)?,
            energy_range: [low?, high?],
        })
    }

    /// The factor of area, with the least and the most that it may be.
    #[must_use]
    pub fn area_bar(&self) -> [f64; 3] {
        [1.0, 1.0 - AREA_ERROR, 1.0 + AREA_ERROR].map(|share| share * self.area)
    }

    /// The factor of energy, with the least and the most that it may be: by supply voltage, and by library.
    #[must_use]
    pub fn energy_bar(&self) -> [f64; 3] {
        let [low, high] = self.energy_range;
        let library = ENERGY_ERROR_FACTOR.sqrt();
        [self.energy, low / library, high * library]
    }

    /// The source of a scaled number, with its error bar.
    #[must_use]
    pub fn source(&self) -> String {
        format!(
            "scaled {} nm {} V -> {TARGET_NODE_NM} nm {TARGET_VOLTAGE_V} V (Stillmaker, Baas 2017: area x{}, energy x{:.3}, {:.3}..{:.3} for \
             1.0..1.2 V); across libraries area +-{:.0} %, energy a factor {ENERGY_ERROR_FACTOR}",
            self.node_nm,
            self.voltage_v,
            self.area,
            self.energy,
            self.energy_range[0],
            self.energy_range[1],
            100.0 * AREA_ERROR
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use gates::liberty::embedded;

    #[test]
    fn factors_are_those_of_the_equations() {
        let scaling = Scaling::of(&embedded()).unwrap();
        assert_eq!(scaling.area, 0.23);
        assert!((scaling.energy - 0.325).abs() < 0.001, "{scaling:?}");
        let mut nangate = embedded();
        (nangate.node_nm, nangate.voltage_v) = (Some(45), 1.1);
        let scaling = Scaling::of(&nangate).unwrap();
        assert!((scaling.energy - 1.610).abs() < 0.001 && (scaling.energy_range[0] - 1.276).abs() < 0.001);
        nangate.node_nm = Some(7);
        assert!(Scaling::of(&nangate).is_none());
    }
}
