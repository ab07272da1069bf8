//! The text that the build script writes. It is regular, not idiomatic: a function takes the rows, bits and chunk that its
//! like may need.

/// Functions of one catalogue of programs for each set of lanes, and its table.
macro_rules! include_programs {
    ($avx512:literal, $avx2:literal, $scalar:literal, $table:literal) => {
        #[cfg(target_arch = "x86_64")]
        #[allow(unused_variables, clippy::all, clippy::pedantic)]
        mod avx512 {
            use super::super::super::lanes::{Bits, Row, avx512::*};
            use super::super::super::{part, whole};
            include!(concat!(env!("OUT_DIR"), $avx512));
        }
        #[cfg(target_arch = "x86_64")]
        #[allow(unused_variables, clippy::all, clippy::pedantic)]
        mod avx2 {
            use super::super::super::lanes::{Bits, Row, avx2::*};
            use super::super::super::{part, whole};
            include!(concat!(env!("OUT_DIR"), $avx2));
        }
        #[allow(unused_variables, clippy::all, clippy::pedantic)]
        mod scalar {
            use super::super::super::lanes::{Bits, Row, scalar::*};
            use super::super::super::{part, whole};
            include!(concat!(env!("OUT_DIR"), $scalar));
        }

        #[cfg(target_arch = "x86_64")]
        macro_rules! sets {
            ($settle:ident, $clock:ident) => {
                Sets {
                    avx512: Functions { settle: avx512::$settle, clock: avx512::$clock },
                    avx2: Functions { settle: avx2::$settle, clock: avx2::$clock },
                    scalar: Functions { settle: scalar::$settle, clock: scalar::$clock },
                }
            };
        }
        #[cfg(not(target_arch = "x86_64"))]
        macro_rules! sets {
            ($settle:ident, $clock:ident) => {
                Sets { scalar: Functions { settle: scalar::$settle, clock: scalar::$clock } }
            };
        }
        include!(concat!(env!("OUT_DIR"), $table));
    };
}

/// The tops of the hardware's catalogue.
pub mod catalogue {
    use super::super::{Functions, Program, ProgramPort, Sets, Slot};
    use hdl::catalogue::{StandardFormat, Top};
    include_programs!("/avx512_catalogue.rs", "/avx2_catalogue.rs", "/scalar_catalogue.rs", "/catalogue.rs");
}

/// Designs of [`crate::logic::random`], by seed.
#[cfg(test)]
pub mod random {
    use super::super::{Functions, Program, ProgramPort, Sets, Slot};
    include_programs!("/avx512_random.rs", "/avx2_random.rs", "/scalar_random.rs", "/random.rs");
}

/// The units of [`crate::logic::faults`], by position.
#[cfg(test)]
pub mod faults {
    use super::super::{Functions, Program, ProgramPort, Sets, Slot};
    include_programs!("/avx512_faults.rs", "/avx2_faults.rs", "/scalar_faults.rs", "/faults.rs");
}
