//! `cdpr man`

use cdpr_core::Error;
use clap::{Command, CommandFactory};
use clap_mangen::Man;

use crate::Answer;
use crate::args::{Cli, ManArgs};
use crate::output::{Console, count};

pub fn run(args: &ManArgs, out: &Console) -> Result<Answer, Error> {
    let mut program = Cli::command();
    program.build(); // adds full names and global options to the subcommands
    let Some(folder) = &args.output else {
        out.result(String::from_utf8_lossy(&page(&program)).trim_end());
        return Ok(Answer::Yes);
    };
    let _writing = crate::interruption::writing();
    std::fs::create_dir_all(folder).map_err(|e| Error::system(folder, "cannot be created", e))?;
    let shown = |command: &&Command| !command.is_hide_set() && command.get_name() != "help";
    let commands: Vec<&Command> = std::iter::once(&program).chain(program.get_subcommands().filter(shown)).collect();
    for command in &commands {
        let man = Man::new((*command).clone());
        cdpr_files::write_atomically(folder.join(man.get_filename()), &page(command))?;
    }
    out.say(&format!("wrote {} to {}", count(commands.len(), "page"), folder.display()));
    Ok(Answer::Yes)
}

fn page(command: &Command) -> Vec<u8> {
    let mut page = Vec::new();
    Man::new(command.clone()).render(&mut page).expect("memory can be written");
    page
}
