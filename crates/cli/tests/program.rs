//! Running the program in a folder of its own.

use std::collections::BTreeMap;
use std::fs;
use std::path::PathBuf;
use std::process::Command;
use std::time::Duration;

use catoptric_reference::render;
use catoptric_scene::{Compiled, Crop, Document, Film, Grid, SceneFormat, View};
use tempfile::TempDir;

/// The program under test.
pub(crate) const CATOPTRIC: &str = env!("CARGO_BIN_EXE_catoptric");

/// The engines whose pictures are checked.
pub(crate) const ENGINES: [&str; 2] = ["packet", "recursive"];

/// Two mirror spheres on a plane, 13 x 7 pixels: no symmetry, no value twice by design.
pub(crate) const SCENE: &str = r#"
[image]
width = 13
height = 7

[camera]
position = [0.3, 0.5, 6]
look_at = [0, 0.2, 0]
fov = 40

[render]
max_depth = 4
background = [0.2, 0.4, 1.7]

[[lights]]
position = [3, 8, 5]
intensity = [1, 0.9, 0.8]

[[spheres]]
center = [-1, 0, 0]
radius = 1
color = [1, 0.3, 0.3]
diffuse = 0.4
specular = 0.6
shininess = 20

[[spheres]]
center = [1.2, 0, 0.4]
radius = 1
color = [0.3, 1, 0.3]
diffuse = 0.7
specular = 0.5
shininess = 8

[[planes]]
point = [0, -1, 0]
normal = [0, 1, 0]
color = [0.5, 0.5, 0.6]
reflect = 0.2
"#;

/// The same scene's beginning in JSON: a light and a sphere.
pub(crate) const JSON_SCENE: &str = r#"
{
  "image": { "width": 13, "height": 7 },
  "lights": [{ "position": [3, 8, 5] }],
  "spheres": [{ "center": [0, 0, -9], "radius": 2, "color": [1, 0.5, 0.2] }]
}
"#;

/// A folder with `scene.toml` in it.
pub(crate) struct Folder {
    folder: TempDir,
}

/// How a run ended.
#[derive(Debug)]
pub(crate) struct Ran {
    pub(crate) code: Option<i32>,
    pub(crate) stdout: Vec<u8>,
    pub(crate) stderr: String,
}

impl Folder {
    pub(crate) fn new() -> Self {
        Self::with(SCENE)
    }

    pub(crate) fn with(scene: &str) -> Self {
        let folder = TempDir::new().expect("a temporary folder");
        fs::write(folder.path().join("scene.toml"), scene).expect("a scene file");
        Self { folder }
    }

    pub(crate) fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    pub(crate) fn read(&self, name: &str) -> Vec<u8> {
        fs::read(self.path(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
    }

    pub(crate) fn write(&self, name: &str, bytes: impl AsRef<[u8]>) {
        fs::write(self.path(name), bytes).expect("a file");
    }

    /// Every name in the folder, hidden ones too, with what the regular files hold.
    pub(crate) fn contents(&self) -> BTreeMap<String, Vec<u8>> {
        let entries = fs::read_dir(self.folder.path()).expect("the folder");
        let entry = |entry: std::io::Result<fs::DirEntry>| {
            let entry = entry.expect("an entry");
            let regular = entry.file_type().is_ok_and(|kind| kind.is_file());
            let bytes = if regular { fs::read(entry.path()).expect("a file") } else { Vec::new() };
            (entry.file_name().into_string().expect("a name"), bytes)
        };
        entries.map(entry).collect()
    }

    /// Runs `catoptric` with arguments separated by blanks.
    pub(crate) fn run(&self, arguments: &str) -> Ran {
        self.run_with(arguments, "", &[])
    }

    pub(crate) fn run_with(&self, arguments: &str, stdin: &str, env: &[(&str, &str)]) -> Ran {
        let output = assert_cmd::Command::new(CATOPTRIC)
            .args(arguments.split_whitespace())
            .current_dir(self.folder.path())
            .env_remove("CATOPTRIC_ISA")
            .envs(env.iter().copied())
            .write_stdin(stdin)
            .timeout(Duration::from_secs(120))
            .output()
            .expect("the program runs");
        Ran {
            code: output.status.code(),
            stdout: output.stdout,
            stderr: String::from_utf8(output.stderr).expect("messages are text"),
        }
    }

    /// Runs a line of shell in which `catoptric` is the program.
    pub(crate) fn shell(&self, line: &str) -> Ran {
        let output = Command::new("sh")
            .args(["-c", &line.replace("catoptric", CATOPTRIC)])
            .current_dir(self.folder.path())
            .output()
            .expect("a shell");
        Ran {
            code: output.status.code(),
            stdout: output.stdout,
            stderr: String::from_utf8(output.stderr).expect("messages are text"),
        }
    }

    /// Runs and expects exit code 0.
    pub(crate) fn done(&self, arguments: &str) -> Ran {
        let ran = self.run(arguments);
        assert_eq!(ran.code, Some(0), "{arguments}: {}", ran.stderr);
        ran
    }
}

impl Ran {
    pub(crate) fn text(&self) -> &str {
        std::str::from_utf8(&self.stdout).expect("stdout is text")
    }

    pub(crate) fn json(&self) -> serde_json::Value {
        serde_json::from_slice(&self.stdout).expect("stdout is one JSON document")
    }
}

/// The recursion's picture of [`SCENE`], by the library.
pub(crate) fn reference(crop: Option<Crop>, samples: u32) -> Film {
    let document = Document::parse("test", SCENE.as_bytes(), SceneFormat::Toml);
    let scene = document.and_then(Document::into_scene).expect("a valid scene");
    let view = View::new(&scene, crop, samples).expect("a crop inside the image");
    let mut film = Film::new(view.crop().width, view.crop().height);
    let (compiled, grid) = (Compiled::new(&scene), Grid::new(&view));
    render(&compiled, &grid, &mut film, &|_| {}).expect("short paths");
    film
}

/// A PFM file by the format's definition.
pub(crate) fn pfm(width: usize, pixels: &[[f32; 3]]) -> Vec<u8> {
    let height = pixels.len() / width;
    let mut bytes = format!("PF\n{width} {height}\n-1.0\n").into_bytes();
    for y in (0..height).rev() {
        for x in 0..width {
            for channel in pixels[y * width + x] {
                bytes.extend(channel.to_le_bytes());
            }
        }
    }
    bytes
}

/// A PPM file by the format's definition.
pub(crate) fn ppm(width: usize, pixels: &[[u8; 3]]) -> Vec<u8> {
    let height = pixels.len() / width;
    let mut bytes = format!("P6\n{width} {height}\n255\n").into_bytes();
    bytes.extend(pixels.as_flattened());
    bytes
}
