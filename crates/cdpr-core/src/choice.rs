//! Named choices: planners, engines, rules. Each name and its help text are defined once, in the list of its type,
//! which files, the command line and Python share.

#[doc(hidden)]
pub use serde; // for the macro

use crate::error::{Error, nearest_name};

/// A type whose values are chosen by name.
pub trait Choice: Copy + PartialEq + Send + Sync + 'static {
    /// Noun for messages, such as "engine".
    const WHAT: &'static str;
    /// All values with name and help.
    const ALL: &'static [(Self, &'static str, &'static str)];

    /// The name of this value.
    fn name(self) -> &'static str;

    /// The value of a name.
    ///
    /// # Errors
    /// An unknown name; the error lists the known names and suggests the nearest.
    fn named(name: &str) -> Result<Self, Error> {
        let names = || Self::ALL.iter().map(|(_, name, _)| *name);
        Self::ALL.iter().find(|(_, known, _)| *known == name).map(|(value, ..)| *value).ok_or_else(|| {
            let hint = nearest_name(name, names()).map(|n| format!("; did you mean \"{n}\"?")).unwrap_or_default();
            let known: Vec<&str> = names().collect();
            Error::invalid(Self::WHAT, format!("found \"{name}\", expected one of {}{hint}", known.join(", ")))
        })
    }
}

/// Lists the values of a choice; they are serialized by name.
#[macro_export]
macro_rules! choices {
    ($type:ty, $what:literal, [$($variant:ident = $name:literal: $help:literal),+ $(,)?]) => {
        impl $crate::choice::Choice for $type {
            const WHAT: &'static str = $what;
            const ALL: &'static [(Self, &'static str, &'static str)] = &[$((Self::$variant, $name, $help)),+];

            fn name(self) -> &'static str {
                match self {
                    $(Self::$variant => $name,)+
                }
            }
        }

        impl $crate::choice::serde::Serialize for $type {
            fn serialize<S: $crate::choice::serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
                serializer.serialize_str($crate::choice::Choice::name(*self))
            }
        }
    };
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::postprocess::Order;

    #[test]
    fn names_round_trip_and_typos_get_suggestions() {
        for (value, name, _) in Order::ALL {
            assert_eq!((Order::named(name).unwrap(), value.name()), (*value, *name));
        }
        let slip = Order::named("bakward").unwrap_err().to_string();
        assert_eq!(
            slip,
            "order: found \"bakward\", expected one of both, backward, forward, backward-only, forward-only; did you mean \"backward\"?"
        );
    }
}
