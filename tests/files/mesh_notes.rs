//! Notes about many meshes, in brief; what may lie at the path of a mesh's cache.

use std::fs;
use std::path::{Path, PathBuf};

use cdpr_core::Scene;
use cdpr_core::geometry::{TriangleMesh, Vector};
use cdpr_core::testing::paper_scene;
use cdpr_files::load_scene;
use cdpr_tests::meshes::*;

/// A scene with one obstacle for each of these meshes.
fn load(folder: &Path, meshes: &[(String, TriangleMesh)]) -> Scene {
    let mut text = toml::to_string(&paper_scene("meshes", Vec::new())).unwrap();
    for (name, mesh) in meshes {
        write_obj(&folder.join(name), mesh, 1.0);
        text += &format!("[[obstacles]]\nmesh = \"{name}\"\n");
    }
    let path = folder.join("scene.toml");
    fs::write(&path, text).unwrap();
    load_scene(&path).unwrap()
}

/// A mesh that is scaled, and moved away from the robot.
fn away(mesh: &TriangleMesh, scale: f64, k: usize) -> TriangleMesh {
    let by = Vector::new(10.0 + 10.0 * k as f64, 0.0, 0.0);
    TriangleMesh { vertices: mesh.vertices.iter().map(|v| v * scale + by).collect(), ..mesh.clone() }
}

#[test]
fn mesh_notes_are_grouped_by_kind_with_the_worst_case() {
    let folder = tempfile::tempdir().unwrap();
    let mut holed = block([0.0; 3], [1.0, 1.0, 1.0]);
    holed.triangles.truncate(10);
    let mut meshes = Vec::new();
    for k in 0..6 {
        let scale = 1.0 + ((k * 5) % 6) as f64 / 4.0;
        meshes.push((format!("ring {k}.obj"), away(&torus(24, 12), scale, 3 * k)));
        meshes.push((format!("angle {k}.obj"), away(&angle(), scale, 3 * k + 1)));
        meshes.push((format!("holed {k}.obj"), away(&holed, scale, 3 * k + 2)));
    }
    let scene = load(folder.path(), &meshes);
    let notes = scene.notes();
    assert!(notes.len() >= 18, "{notes:#?}");
    let brief = scene.in_brief(notes);
    assert!(brief.len() <= 5, "{brief:#?}");
    for (words, many) in [("fill it exactly", 6), ("not sound", 6)] {
        let found = brief.iter().find(|note| note.contains(words)).unwrap();
        assert!(found.starts_with(&format!("{many} meshes have a note like this one: obstacles[")), "{found}");
    }
    let reach =
        |note: &str| -> Option<f64> { note.split_once("which reach at most ")?.1.split_once(" mm")?.0.parse().ok() };
    let farthest = notes.iter().max_by(|a, b| reach(a).partial_cmp(&reach(b)).unwrap()).unwrap();
    let found = brief.iter().find(|note| note.contains("which states the largest length")).unwrap();
    assert_eq!(reach(found), reach(farthest));
    assert!(notes.iter().any(|note| found.ends_with(note.as_str())), "{found}");
    let good = scene.good_notes();
    assert_eq!(good.len(), 6);
    assert_eq!(scene.in_brief(&notes[..3]), notes[..3], "a sentence about all does not stand for some of them");

    let few = load(folder.path(), &meshes[..4]);
    assert_eq!(few.in_brief(few.notes()), few.notes(), "three of a kind are printed as they are");
}

/// The path of the cache of a mesh that is read from this folder.
fn cache_of(folder: &Path) -> PathBuf {
    let names = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    names.into_iter().find(|path| path.to_string_lossy().ends_with(".parts.json")).expect("the parts are kept")
}

#[test]
#[cfg(unix)]
fn special_files_are_not_used_as_cache() {
    use std::io::{Read, Write};
    use std::os::unix::fs::{PermissionsExt, symlink};
    let folder = tempfile::tempdir().unwrap();
    let meshes = [("angle.obj".to_string(), angle())];
    let scene = load(folder.path(), &meshes);
    let cache = cache_of(folder.path());
    let kept = fs::read(&cache).unwrap();
    let elsewhere = folder.path().join("elsewhere");

    fs::remove_file(&cache).unwrap();
    assert!(std::process::Command::new("mkfifo").arg(&cache).status().unwrap().success());
    let mut pipe = fs::OpenOptions::new().read(true).write(true).open(&cache).unwrap(); // so that writing does not wait
    assert_eq!(load(folder.path(), &meshes), scene);
    pipe.write_all(b"!").unwrap();
    let mut first = [0];
    pipe.read_exact(&mut first).unwrap();
    assert_eq!(&first, b"!", "nothing else was written");
    fs::remove_file(&cache).unwrap();

    fs::create_dir(&cache).unwrap();
    assert_eq!(load(folder.path(), &meshes), scene);
    fs::remove_dir(&cache).unwrap();

    for target in [Path::new("/dev/null"), Path::new("nowhere"), &elsewhere] {
        fs::write(&elsewhere, "precious").unwrap();
        symlink(target, &cache).unwrap();
        assert_eq!(load(folder.path(), &meshes), scene, "{}", target.display());
        assert!(fs::symlink_metadata(&cache).unwrap().is_symlink());
        assert_eq!(fs::read_to_string(&elsewhere).unwrap(), "precious");
        assert!(!folder.path().join("nowhere").exists());
        fs::remove_file(&cache).unwrap();
    }

    fs::write(&elsewhere, &kept).unwrap();
    symlink(&elsewhere, &cache).unwrap();
    assert_eq!(load(folder.path(), &meshes), scene, "a link to a cache is read");
    fs::remove_file(&cache).unwrap();

    fs::write(&cache, "{}").unwrap();
    let mode = |path: &Path, mode: u32| fs::set_permissions(path, fs::Permissions::from_mode(mode)).unwrap();
    mode(&cache, 0o000);
    assert_eq!(load(folder.path(), &meshes), scene, "not readable");
    mode(&cache, 0o644);
    let read_only = folder.path().join("read only");
    fs::create_dir(&read_only).unwrap();
    load(&read_only, &meshes);
    fs::remove_file(cache_of(&read_only)).unwrap();
    mode(&read_only, 0o555);
    assert_eq!(load_scene(read_only.join("scene.toml")).unwrap(), scene);
    assert_eq!(fs::read_dir(&read_only).unwrap().count(), 2, "nothing can be kept");
    mode(&read_only, 0o755);
}
