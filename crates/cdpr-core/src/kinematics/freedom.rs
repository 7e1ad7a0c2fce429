//! How the cables constrain a platform, as plain data and in words; [`Hold::of`](crate::wrench::Hold::of) computes it.

use serde::{Serialize, Serializer};

/// How the cables constrain the platform.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Hold {
    /// Rank of the wrench matrix: the number of independent motions of the platform that the cables resist.
    pub rank: usize,
    /// The maximum possible rank: 6, or 3 for a point mass.
    pub full_rank: usize,
    /// How the platform is held, by rank and directions of the cables.
    pub holding: Holding,
    /// A basis of the motions that no tensions resist; empty at full rank.
    pub free_motions: Vec<FreeMotion>,
}

/// The class of a platform by the rank and the directions of its cables.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Holding {
    /// The cables pull against each other: with large enough tensions they resist any wrench.
    FullyConstrained,
    /// The cables need the weight, or another load, to pull against.
    Suspended,
    /// Some motion of the platform is resisted by no tensions.
    Underconstrained,
}

/// A motion of the platform that, to first order, leaves the length of every cable unchanged.
#[derive(Debug, Clone, PartialEq)]
pub struct FreeMotion {
    /// Linear velocity of the platform's origin and angular velocity, world axes; the largest component is 1 (m/s or
    /// rad/s).
    pub twist: [f64; 6],
}

impl FreeMotion {
    /// The motion in words: "turning about x while moving along y and z".
    pub fn words(&self) -> String {
        let part = |what: &str, parts: &[f64]| {
            let axes = ["x", "y", "z"].into_iter().zip(parts).filter(|(_, part)| **part != 0.0).map(|(axis, _)| axis);
            let axes: Vec<&str> = axes.collect();
            (!axes.is_empty()).then(|| format!("{what} {}", axes.join(" and ")))
        };
        let parts = [part("turning about", &self.twist[3..]), part("moving along", &self.twist[..3])];
        parts.into_iter().flatten().collect::<Vec<_>>().join(" while ")
    }
}

impl Serialize for FreeMotion {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        #[derive(Serialize)]
        struct Told {
            words: String,
            twist: [f64; 6],
        }
        Told { words: self.words(), twist: self.twist }.serialize(serializer)
    }
}

impl Hold {
    /// Whether the cables resist every motion.
    pub fn is_full(&self) -> bool {
        self.rank == self.full_rank
    }

    /// Rank, class and free motions in words: "rank 5 of 6, underconstrained: no tensions resist turning about z".
    pub fn sentence(&self) -> String {
        let means = match self.holding {
            Holding::FullyConstrained => "fully constrained: the cables pull against each other".to_string(),
            Holding::Suspended => "suspended: the cables need a load, such as the weight, to pull against".to_string(),
            Holding::Underconstrained => {
                let motions: Vec<String> = self.free_motions.iter().map(FreeMotion::words).collect();
                format!("underconstrained: no tensions resist {}", motions.join(", nor "))
            }
        };
        format!("rank {} of {}, {means}", self.rank, self.full_rank)
    }
}
