//! Where measurements are stored.

use std::path::{Path, PathBuf};
use std::{fs, io};

/// Writes texts, under their names, into the folder `measures` of the target folder, and prints
/// where.
pub fn keep(target: &Path, texts: &[(&str, String)]) -> io::Result<()> {
    let folder: PathBuf = target.join("measures");
    fs::create_dir_all(&folder)?;
    for (name, text) in texts {
        let path = folder.join(name);
        fs::write(&path, text)?;
        println!("{}", path.display());
    }
    Ok(())
}
