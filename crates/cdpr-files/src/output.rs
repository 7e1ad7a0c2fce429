//! Writing files atomically where possible.
//!
//! A regular file is written to a temporary file beside it, which then replaces it, so that no reader ever sees half of
//! it. Links are followed first. Some files cannot be replaced and are written in place: files in a folder that cannot
//! be written, files with several names or another owner, which renaming would change, and pipes and devices, such as
//! those of the shell's `>(command)`.

use std::ffi::OsStr;
use std::fs::{self, Metadata, OpenOptions};
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};

use tempfile::NamedTempFile;

use cdpr_core::error::{Error, printable};

/// Prefix of the names of temporary files.
const TEMPORARY: &str = ".cdpr-";

/// Maximum number of links followed.
const MOST_LINKS: usize = 40;

/// Writes a file atomically if it can be replaced; see the module.
///
/// # Errors
/// The errors of [`check_target`], and failures while writing.
pub fn write_atomically(path: impl AsRef<Path>, contents: &[u8]) -> Result<(), Error> {
    let path = path.as_ref();
    let mut file = Output::begin(path)?;
    file.write_all(contents).map_err(|e| unwritable(path, e.kind()))?;
    file.finish()
}

/// Checks that a file can be written, without touching it; call this before doing any work.
///
/// # Errors
/// The path is a folder, its folder is missing or cannot be written, or the file is read-only.
///
/// # Example
/// ```
/// use cdpr_files::check_target;
/// # let folder = tempfile::tempdir().unwrap();
/// assert!(check_target(&folder.path().join("path.json")).is_ok());
/// assert!(check_target(&folder.path().join("nowhere/path.json")).is_err());
/// ```
pub fn check_target(path: impl AsRef<Path>) -> Result<(), Error> {
    let path = path.as_ref();
    target(path).map(drop)
}

/// Checks that a folder can be created or written.
///
/// # Errors
/// The path or one of its parents is not a folder or cannot be written.
pub fn check_folder(path: impl AsRef<Path>) -> Result<(), Error> {
    let path = path.as_ref();
    match path.ancestors().find(|above| above.as_os_str().is_empty() || above.exists()) {
        Some(above) => check_parent(path, &named_or_here(above)),
        None => Ok(()),
    }
}

/// Whether this is neither a file nor a folder but a pipe, a terminal or another device.
pub fn is_stream(path: impl AsRef<Path>) -> bool {
    let path = path.as_ref();
    fs::metadata(path).is_ok_and(|found| !found.is_file() && !found.is_dir())
}

/// Where contents are written.
enum Target {
    /// A file that does not exist yet.
    New(PathBuf),
    /// A file to replace or, if that is not possible, to write in place.
    Old(PathBuf, Metadata),
    /// A pipe or a device, or a file in a folder that cannot be written.
    InPlace(PathBuf),
}

fn target(path: &Path) -> Result<Target, Error> {
    let problem = |problem: &str| Err(Error::file(path, format!("cannot be written: {problem}")));
    let Ok(found) = fs::metadata(path) else {
        let file = end_of_links(path)?;
        check_parent(path, &named_or_here(file.parent().unwrap_or(Path::new(""))))?;
        return Ok(Target::New(file));
    };
    if found.is_dir() {
        return problem("it is a folder, expected a file");
    }
    if !found.is_file() {
        return Ok(Target::InPlace(path.to_path_buf()));
    }
    if found.permissions().readonly() {
        return problem("it is read-only");
    }
    OpenOptions::new().write(true).open(path).map_err(|e| unwritable(path, e.kind()))?;
    let file = path.canonicalize().map_err(|e| unwritable(path, e.kind()))?;
    match file.parent().is_none_or(|folder| writable(folder).is_err()) || several_names(&found) {
        true => Ok(Target::InPlace(file)),
        false => Ok(Target::Old(file, found)),
    }
}

/// The target of a link whose target does not exist yet, or the path itself.
fn end_of_links(path: &Path) -> Result<PathBuf, Error> {
    let mut end = path.to_path_buf();
    for _ in 0..MOST_LINKS {
        match fs::read_link(&end) {
            Ok(next) => end = end.with_file_name("").join(next),
            Err(_) => return Ok(end),
        }
    }
    Err(Error::file(path, "cannot be written: its symbolic links form a loop"))
}

fn named_or_here(folder: &Path) -> PathBuf {
    if folder.as_os_str().is_empty() { PathBuf::from(".") } else { folder.to_path_buf() }
}

/// Checks the folder of a file to be created.
fn check_parent(path: &Path, folder: &Path) -> Result<(), Error> {
    let name = printable(&folder.to_string_lossy()).into_owned();
    let problem = match fs::metadata(folder) {
        Err(e) if e.kind() == ErrorKind::NotFound => format!("there is no folder {name}"),
        Err(e) => e.kind().to_string(),
        Ok(found) if !found.is_dir() => format!("{name} is not a folder"),
        Ok(_) => match writable(folder) {
            Ok(()) => return Ok(()),
            Err(problem) => format!("the folder {name} cannot be written ({problem})"),
        },
    };
    Err(Error::file(path, format!("cannot be written: {problem}")))
}

/// Whether files can be created in a folder. Permissions are checked too, since root can write anywhere.
fn writable(folder: &Path) -> Result<(), ErrorKind> {
    if fs::metadata(folder).is_ok_and(|found| found.permissions().readonly()) {
        return Err(ErrorKind::PermissionDenied);
    }
    #[cfg(unix)]
    rustix::fs::access(folder, rustix::fs::Access::WRITE_OK | rustix::fs::Access::EXEC_OK)
        .map_err(|e| io::Error::from(e).kind())?;
    Ok(())
}

/// A file that is being written.
pub struct Output {
    path: PathBuf,
    to: To,
}

enum To {
    /// A temporary file that replaces this one at the end.
    Beside(NamedTempFile, PathBuf),
    /// The contents, which are written over this file at the end.
    InPlace(Vec<u8>, PathBuf),
}

impl Output {
    /// Begins a file; nothing is visible before [`Output::finish`].
    ///
    /// # Errors
    /// No file can be written at this path.
    pub fn begin(path: impl AsRef<Path>) -> Result<Self, Error> {
        let path = path.as_ref();
        let new = |file: &Path| temporary_beside(file).map_err(|e| unwritable(path, e.kind()));
        let to = match target(path)? {
            Target::New(file) => To::Beside(new(&file)?, file),
            Target::InPlace(file) => To::InPlace(Vec::new(), file),
            Target::Old(file, old) => {
                let temporary = new(&file)?;
                match keep_mode(&temporary, &old) {
                    Ok(true) => To::Beside(temporary, file),
                    _ => To::InPlace(Vec::new(), file),
                }
            }
        };
        Ok(Output { path: path.to_path_buf(), to })
    }

    /// Puts the file in its place.
    ///
    /// # Errors
    /// A full disk, or any other failure to write.
    pub fn finish(self) -> Result<(), Error> {
        let written = match self.to {
            To::Beside(temporary, file) => {
                let synced = temporary.as_file().sync_all();
                synced.and_then(|()| temporary.persist(file).map(drop).map_err(|e| e.error))
            }
            To::InPlace(contents, file) => write_in_place(&file, &contents),
        };
        written.map_err(|e| unwritable(&self.path, e.kind()))
    }
}

impl Write for Output {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match &mut self.to {
            To::Beside(temporary, _) => temporary.write(bytes),
            To::InPlace(contents, _) => contents.write(bytes),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        match &mut self.to {
            To::Beside(temporary, _) => temporary.flush(),
            To::InPlace(..) => Ok(()),
        }
    }
}

fn write_in_place(path: &Path, contents: &[u8]) -> io::Result<()> {
    let mut file = OpenOptions::new().write(true).open(path)?;
    let ordinary = file.metadata()?.is_file();
    if ordinary {
        file.set_len(0)?;
    }
    match file.write_all(contents).and_then(|()| file.flush()) {
        Err(e) if !ordinary && e.kind() == ErrorKind::BrokenPipe => Ok(()), // its reader has seen enough
        written => written,
    }
}

/// A temporary file in the same folder, to be renamed when it is complete; its mode follows the umask.
fn temporary_beside(path: &Path) -> io::Result<NamedTempFile> {
    let folder = named_or_here(path.parent().unwrap_or(Path::new("")));
    let mut builder = tempfile::Builder::new();
    builder.prefix(TEMPORARY);
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    builder.tempfile_in(folder)
}

/// Whether a file with this name is a temporary one, left behind by a process that was killed.
pub fn is_temporary(name: &OsStr) -> bool {
    name.as_encoded_bytes().starts_with(TEMPORARY.as_bytes())
}

/// Gives a file the mode of the one it will replace; false if it cannot replace it because the owners differ.
#[cfg(unix)]
fn keep_mode(temporary: &NamedTempFile, old: &Metadata) -> io::Result<bool> {
    use std::os::unix::fs::MetadataExt;
    let own = temporary.as_file().metadata()?;
    if (own.uid(), own.gid()) != (old.uid(), old.gid()) {
        return Ok(false);
    }
    temporary.as_file().set_permissions(old.permissions())?;
    Ok(true)
}

#[cfg(not(unix))]
fn keep_mode(_: &NamedTempFile, _: &Metadata) -> io::Result<bool> {
    Ok(true)
}

#[cfg(unix)]
fn several_names(file: &Metadata) -> bool {
    std::os::unix::fs::MetadataExt::nlink(file) > 1
}

#[cfg(not(unix))]
fn several_names(_: &Metadata) -> bool {
    false
}

/// Reports only the kind of an I/O error, since its full text would name the temporary file.
fn unwritable(path: &Path, problem: ErrorKind) -> Error {
    Error::file(path, format!("cannot be written: {problem}"))
}
