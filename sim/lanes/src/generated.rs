//! Where generated text becomes functions.

/// Includes the functions and the table `PROGRAMS` that the build script has written under the name `$stem`.
///
/// The text is regular, not idiomatic: every function takes rows, bits and a chunk, whether it needs them or not.
#[macro_export]
macro_rules! include_programs {
    ($stem:literal) => {
        #[cfg(target_arch = "x86_64")]
        #[allow(unused_variables, clippy::all, clippy::pedantic)]
        mod avx512 {
            use $crate::sets::{Bits, Row, avx512::*};
            use $crate::{part, whole};
            include!(concat!(env!("OUT_DIR"), "/avx512_", $stem, ".rs"));
        }
        #[cfg(target_arch = "x86_64")]
        #[allow(unused_variables, clippy::all, clippy::pedantic)]
        mod avx2 {
            use $crate::sets::{Bits, Row, avx2::*};
            use $crate::{part, whole};
            include!(concat!(env!("OUT_DIR"), "/avx2_", $stem, ".rs"));
        }
        #[allow(unused_variables, clippy::all, clippy::pedantic)]
        mod scalar {
            use $crate::sets::{Bits, Row, scalar::*};
            use $crate::{part, whole};
            include!(concat!(env!("OUT_DIR"), "/scalar_", $stem, ".rs"));
        }

        #[cfg(target_arch = "x86_64")]
        macro_rules! sets {
            ($settle:ident, $clock:ident) => {
                $crate::Sets {
                    avx512: $crate::Functions { settle: avx512::$settle, clock: avx512::$clock },
                    avx2: $crate::Functions { settle: avx2::$settle, clock: avx2::$clock },
                    scalar: $crate::Functions { settle: scalar::$settle, clock: scalar::$clock },
                }
            };
        }
        #[cfg(not(target_arch = "x86_64"))]
        macro_rules! sets {
            ($settle:ident, $clock:ident) => {
                $crate::Sets { scalar: $crate::Functions { settle: scalar::$settle, clock: scalar::$clock } }
            };
        }
        use $crate::{Program, ProgramPort, Slot};
        include!(concat!(env!("OUT_DIR"), "/", $stem, ".rs"));
    };
}
