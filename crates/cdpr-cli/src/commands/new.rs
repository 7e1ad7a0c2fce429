//! `cdpr new`

use cdpr_core::io::text::Notation;
use cdpr_core::{Error, io};

use crate::Answer;
use crate::args::{Format, NewArgs};
use crate::output::{result, say};

const STARTER: &str = include_str!("../../assets/starter.toml");

pub fn run(args: &NewArgs) -> Result<Answer, Error> {
    let json = || {
        io::scene_from_text(STARTER, Notation::Toml, None)
            .map(|scene| format!("{:#}\n", serde_json::json!(scene.spec())))
    };
    let Some(path) = &args.output else {
        result(
            match args.format {
                Format::Text => STARTER.to_string(),
                Format::Json => json()?,
            }
            .trim_end(),
        );
        return Ok(Answer::Yes);
    };
    let text = match Notation::of(path)? {
        Notation::Toml => STARTER.to_string(),
        Notation::Json => json()?,
    };
    if path.exists() && !args.force {
        return Err(Error::file(path, "exists already; choose another name, or overwrite it with --force"));
    }
    io::write_atomically(path, text.as_bytes())?;
    say(&format!("wrote {}", path.display()));
    say(&format!("next: cdpr plan {} -o path.json --html view.html", path.display()));
    Ok(Answer::Yes)
}
