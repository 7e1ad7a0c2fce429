//! Parsing of option values.

use std::time::Duration;

use cdpr_core::geometry::{Point, Rotation};
use cdpr_core::model::{OrientationSource, PositionSource, body};
use cdpr_core::plan::Post;
use cdpr_core::watch::{TimeUnit, thread_count, time_budget};
use cdpr_core::{Choice, Error};
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};

/// Four numbers are a quaternion, anything else is a name.
pub fn orientation(text: &str) -> Result<OrientationSource, String> {
    let numbers: Result<Vec<f64>, _> = text.split(',').map(|number| number.trim().parse()).collect();
    Ok(match numbers.ok().and_then(|numbers| <[f64; 4]>::try_from(numbers).ok()) {
        Some(quaternion) => OrientationSource::Quaternion(quaternion),
        None => OrientationSource::Named(text.to_string()),
    })
}

/// Four numbers, a unit quaternion.
pub fn quaternion(text: &str) -> Result<Rotation, String> {
    match orientation(text)? {
        OrientationSource::Quaternion(numbers) => body::unit_quaternion("", numbers).map_err(|e| e.to_string()),
        OrientationSource::Named(_) => Err("expected four numbers, W,X,Y,Z".to_string()),
    }
}

/// What to write where an option takes a position of the scene.
pub const POSITION: &str = "STATION|X Y Z";

/// Three numbers are a position, one word is the name of a station.
///
/// # Errors
/// Another number of words, or numbers that are not finite; the option is named.
pub fn position(option: &str, words: &[String]) -> Result<PositionSource, Error> {
    let numbers: Vec<f64> = words.iter().map_while(|word| word.parse().ok()).collect();
    match (words, &numbers[..]) {
        ([_, _, _], [x, y, z]) => body::point(option, [*x, *y, *z]).map(PositionSource::from),
        ([name], []) => Ok(PositionSource::Named(name.clone())),
        _ => {
            let expected = format!("expected X Y Z, or the name of a station, as in {option}=rack");
            Err(Error::invalid(option, format!("found {}, {expected}", words.join(" "))))
        }
    }
}

/// The position that an option gives, if it is given, m.
///
/// # Errors
/// Numbers that are not finite or too large; the option is named.
pub fn place(option: &str, given: Option<&[f64]>) -> Result<Option<Point>, Error> {
    given.map(|numbers| body::point(option, Point::from_slice(numbers).into())).transpose()
}

pub fn ratio(text: &str) -> Result<f64, String> {
    let number: f64 = text.parse().map_err(|_| "expected a number of at least 1")?;
    if number >= 1.0 && number.is_finite() { Ok(number) } else { Err("expected a number of at least 1".to_string()) }
}

pub fn threads(text: &str) -> Result<usize, String> {
    let number = text.parse().map_err(|_| "expected a whole number")?;
    thread_count(number).map_err(|e| e.to_string())
}

/// A range of trials; a type of its own, since clap takes ranges for lists.
#[derive(Debug, Clone)]
pub struct Trials(pub std::ops::Range<usize>);

pub fn trials(text: &str) -> Result<Trials, String> {
    let number =
        |text: &str| text.parse::<usize>().map_err(|_| "expected a whole number N, or a range A..B".to_string());
    let range = match text.split_once("..") {
        Some((first, end)) => number(first)?..number(end)?,
        None => 0..number(text)?,
    };
    if range.is_empty() { Err("found no trials, expected at least one".to_string()) } else { Ok(Trials(range)) }
}

/// Accepts the names of a choice and shows them with their help.
pub fn choice<T: Choice>() -> impl TypedValueParser<Value = T> {
    PossibleValuesParser::new(possible::<T>()).map(|name| T::named(&name).expect("one of the possible names"))
}

fn possible<T: Choice>() -> Vec<PossibleValue> {
    T::ALL.iter().map(|(_, name, help)| PossibleValue::new(*name).help(*help)).collect()
}

/// Accepts the names of [`Post`] except `none`.
pub fn something() -> impl TypedValueParser<Value = Post> {
    let names = possible::<Post>().into_iter().filter(|name| !name.matches(Post::None.name(), false));
    PossibleValuesParser::new(names.collect::<Vec<_>>())
        .map(|name| Post::named(&name).expect("one of the possible names"))
}

/// A time in milliseconds.
pub fn budget(text: &str) -> Result<Duration, String> {
    let ms: f64 = text.parse().map_err(|_| "expected a number")?;
    time_budget("", ms, TimeUnit::Millisecond).map_err(|e| e.to_string())
}

/// A positive number, such as a step.
pub fn positive(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(number) if number > 0.0 && number <= 1e9 => Ok(number),
        Ok(number) => Err(format!("found {number}, expected a positive number of at most 1e9")),
        Err(_) => Err("expected a number".to_string()),
    }
}

/// A number that is not negative, such as a margin.
pub fn not_negative(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(number) if (0.0..=1e9).contains(&number) => Ok(number),
        Ok(number) => Err(format!("found {number}, expected a number from 0 to 1e9")),
        Err(_) => Err("expected a number".to_string()),
    }
}
