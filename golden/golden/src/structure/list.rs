//! What the list of structures stands for: the enumerations over them, and the only matches over these.

/// Defines [`StructureKind`](super::StructureKind), [`Structure`](super::Structure) and
/// [`NarrowStructure`](super::NarrowStructure) from lines of `Variant: "name", code, type;`, and the macros that do
/// something to whichever there is. The first token is a `$` for these.
macro_rules! structures {
    ($d:tt $($(#[$doc:meta])* $kind:ident: $name:literal, $code:literal, $format:ty;)+) => {
        /// Which structure rays are traced through.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        pub enum StructureKind {
            $($(#[$doc])* $kind,)+
        }

        impl StructureKind {
            /// All of them, in the order in which tables list them.
            pub const ALL: [Self; [$($code),+].len()] = [$(Self::$kind),+];

            /// The structure's name on the command line and in result files.
            #[must_use]
            pub const fn name(self) -> &'static str {
                match self {
                    $(Self::$kind => $name,)+
                }
            }

            /// The structure's number in files.
            #[must_use]
            pub const fn code(self) -> u32 {
                match self {
                    $(Self::$kind => $code,)+
                }
            }
        }

        /// A structure of any kind.
        #[derive(Clone, Debug)]
        pub enum Structure {
            $($(#[$doc])* $kind($format),)+
        }

        impl Structure {
            /// Which structure this is.
            #[must_use]
            pub const fn kind(&self) -> StructureKind {
                match self {
                    $(Self::$kind(_) => StructureKind::$kind,)+
                }
            }
        }

        /// A structure of any kind in a narrow format.
        #[derive(Clone, Debug)]
        pub enum NarrowStructure {
            $($(#[$doc])* $kind(Narrow<$format>),)+
        }

        $(
            impl From<$format> for Structure {
                fn from(structure: $format) -> Self {
                    Self::$kind(structure)
                }
            }

            impl From<Narrow<$format>> for NarrowStructure {
                fn from(structure: Narrow<$format>) -> Self {
                    Self::$kind(structure)
                }
            }
        )+

        /// `with_structure!(structure, s => body)`: the body with `s` bound to what a [`Structure`](crate::structure::Structure)
        /// holds, compiled once for each type.
        #[macro_export]
        macro_rules! with_structure {
            ($d structure:expr, $d inner:ident => $d body:expr) => {
                match $d structure {
                    $($d crate::structure::Structure::$kind($d inner) => $d body,)+
                }
            };
        }

        /// The same for a [`NarrowStructure`].
        macro_rules! with_narrow {
            ($d structure:expr, $d inner:ident => $d body:expr) => {
                match $d structure {
                    $(NarrowStructure::$kind($d inner) => $d body,)+
                }
            };
        }

        /// The body with `Format` bound to the type of a [`StructureKind`].
        macro_rules! with_format {
            ($d kind:expr, $d Format:ident => $d body:expr) => {
                match $d kind {
                    $(StructureKind::$kind => {
                        type $d Format = $format;
                        $d body
                    })+
                }
            };
        }
    };
}
