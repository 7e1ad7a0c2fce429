//! Numbers in sentences: counts and lengths.

/// "1 obstacle", "3 obstacles"; `thing` in the singular.
///
/// # Example
/// ```
/// use cdpr_core::words::count;
/// assert_eq!((count(1, "waypoint"), count(3, "body")), ("1 waypoint".to_string(), "3 bodies".to_string()));
/// ```
pub fn count(number: usize, thing: &str) -> String {
    match (number, thing.strip_suffix('y')) {
        (1, _) => format!("1 {thing}"),
        (_, Some(stem)) => format!("{number} {stem}ies"),
        (_, None) if thing.ends_with('x') => format!("{number} {thing}es"),
        (_, None) => format!("{number} {thing}s"),
    }
}

/// A number with three decimals, never minus zero.
///
/// # Example
/// ```
/// use cdpr_core::words::thousandths;
/// assert_eq!([thousandths(-1.25), thousandths(-0.0004)], ["-1.250", "0.000"]);
/// ```
pub fn thousandths(number: f64) -> String {
    let text = format!("{number:.3}");
    if text == "-0.000" { "0.000".to_string() } else { text }
}

/// A length with three decimals, in metres from 1 m on, else in millimetres.
///
/// # Example
/// ```
/// use cdpr_core::words::length;
/// assert_eq!([length(12.0), length(-0.0125), length(-1e-9)], ["12.000 m", "-12.500 mm", "0.000 mm"]);
/// ```
pub fn length(metres: f64) -> String {
    if metres.abs() >= 1.0 { format!("{} m", thousandths(metres)) } else { format!("{} mm", thousandths(metres * 1e3)) }
}

/// A length with three decimals, in metres from 1 m on, else in millimetres, and in micrometres below 1 µm, so that a
/// length other than zero does not read as zero.
///
/// # Example
/// ```
/// use cdpr_core::words::small_length;
/// assert_eq!([small_length(4e-9), small_length(0.0125)], ["0.004 µm", "12.500 mm"]);
/// ```
pub fn small_length(metres: f64) -> String {
    if metres.abs() < 1e-6 { format!("{} µm", thousandths(metres * 1e6)) } else { length(metres) }
}
