//! Rays in the order in which a wavefront renderer traces them.

use super::DIFFUSE_BOUNCES;
use golden::Ray;
use std::fmt;

/// What a ray is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum RayClass {
    /// From the camera.
    Primary,
    /// From vertex `vertex` of a path (0: where the primary ray hits) to the light.
    Shadow {
        /// Number of the vertex from 0.
        vertex: u8,
    },
    /// Along bounce `bounce` of a path, from 1.
    Diffuse {
        /// Number of the bounce from 1.
        bounce: u8,
    },
    /// Not primary. Nothing more is known, as for rays from a file without classes.
    Secondary,
}

impl RayClass {
    /// Number of classes that rendering makes, the waves of [`RayClass::of_wave`].
    pub const WAVES: usize = 2 * (DIFFUSE_BOUNCES + 1);

    /// The class of wave `wave`: primary, shadow 0, diffuse 1, shadow 1, ..., as they depend on each other.
    ///
    /// # Panics
    /// If `wave` is not below [`RayClass::WAVES`].
    #[must_use]
    pub fn of_wave(wave: usize) -> Self {
        assert!(wave < Self::WAVES, "there is no wave {wave}");
        let bounce = (wave / 2) as u8;
        match wave {
            0 => Self::Primary,
            _ if wave % 2 == 1 => Self::Shadow { vertex: bounce },
            _ => Self::Diffuse { bounce },
        }
    }
}

/// `primary`, `shadow_0`, `diffuse_1`, `secondary`.
impl fmt::Display for RayClass {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Primary => f.write_str("primary"),
            Self::Shadow { vertex } => write!(f, "shadow_{vertex}"),
            Self::Diffuse { bounce } => write!(f, "diffuse_{bounce}"),
            Self::Secondary => f.write_str("secondary"),
        }
    }
}

/// Consecutive rays of one class.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Wave {
    /// Their class.
    pub class: RayClass,
    /// How many there are.
    pub rays: u32,
}

/// Rays, wave by wave; in a wave by pixel (row by row from the top), then by sample.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RayStream {
    /// All rays.
    pub rays: Vec<Ray>,
    /// Their classes; the counts sum to the number of rays, and primary rays come first.
    pub waves: Vec<Wave>,
}

impl RayStream {
    /// Number of primary rays.
    #[must_use]
    pub fn primary_rays(&self) -> u32 {
        self.waves.iter().filter(|wave| wave.class == RayClass::Primary).map(|wave| wave.rays).sum()
    }

    /// The rays of each wave.
    ///
    /// # Panics
    /// If the counts exceed the number of rays.
    pub fn by_wave(&self) -> impl Iterator<Item = (RayClass, &[Ray])> {
        let mut rest = self.rays.as_slice();
        self.waves.iter().map(move |wave| {
            let (rays, others) = rest.split_at(wave.rays as usize);
            rest = others;
            (wave.class, rays)
        })
    }
}
