//! Columns of cables in CSV files: a quantity and the name of a cable, such as `length:winch 1`. Lengths and commanded lengths are in
//! m, speeds in m/s, accelerations in m/s², tensions in N, angles of motors in rad, their torques in N·m.

/// Columns of a quantity, one for each cable.
pub fn columns<'a>(quantity: &'a str, cables: &'a [impl AsRef<str>]) -> impl Iterator<Item = String> + 'a {
    cables.iter().map(move |cable| format!("{quantity}:{}", cable.as_ref()))
}

/// The cable of a column of one of these quantities.
pub fn cable_of<'a>(column: &'a str, quantities: &[&str]) -> Option<&'a str> {
    let (quantity, cable) = column.split_once(':')?;
    (quantities.contains(&quantity) && !cable.is_empty()).then_some(cable)
}

/// Rows as CSV text.
pub fn csv_text(header: Vec<String>, rows: impl Iterator<Item = Vec<String>>) -> String {
    let mut writer = csv::Writer::from_writer(Vec::new());
    for record in std::iter::once(header).chain(rows) {
        writer.write_record(record).expect("memory takes rows of one length");
    }
    String::from_utf8(writer.into_inner().expect("memory takes it")).expect("numbers and names are text")
}
