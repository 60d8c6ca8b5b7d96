//! `--proof`: the file, and what is refused.

use super::{EXAMPLE, Folder};
use crate::proof::read;
use palkki_evidence::authority::check::check;

/// The proof of an answer on a grid is that of the exact answer, which its bounds rest on.
#[test]
fn a_proof_is_written_whole() {
    let folder = Folder::new("proof");
    for arguments in ["", " --method force --intervals 40"] {
        let run = folder.run(&format!("solve example.toml --proof proof.json{arguments}"));
        assert_eq!((run.code, run.err.as_str()), (Some(0), ""));
        let proof: serde_json::Value = serde_json::from_str(&folder.read("proof.json")).expect("JSON");
        assert_eq!((&proof["version"], proof["cells"].as_array().map(Vec::len)), (&1.into(), Some(3)));
        assert!(check(&read(EXAMPLE), &proof).is_ok(), "{proof}");
    }
    let run = folder.run("solve example.toml --proof -");
    assert!(run.out.starts_with("{ \"version\": 1") && run.err.starts_with("certified"), "{}", run.err);
}

#[test]
fn what_has_no_proof_is_refused() {
    let folder = Folder::new("no_proof");
    folder.write("wave.toml", EXAMPLE.replace("depth = 1", "cosine = { mean = 1, amplitude = 0.3, wavelength = 5 }"));
    folder.write("K.mtx", "%%MatrixMarket matrix coordinate real symmetric\n1 1 1\n1 1 2.0\n");
    folder.write("body.toml", "[body]\nstiffness = 'K.mtx'\n");
    for (scene, why) in
        [("wave", "`foundation.cosine` has no values in fractions"), ("body", "a [body] has no use for it")]
    {
        let message = folder.refused(&format!("solve {scene}.toml --csv nodes.csv --proof proof.json"));
        assert!(message.contains(why), "{message}");
    }
}
