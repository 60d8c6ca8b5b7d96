//! Changes to texts that a parser may stumble over: of bytes, of words, of numbers, of whole lines.

use palkki_evidence::random::Random;

/// Words that mean something, or used to.
const WORDS: [&str; 40] = [
    "title",
    "[beam]\n",
    "length = ",
    "bending_stiffness = ",
    "[load]\n",
    "uniform",
    "linear",
    "[[load.point]]\n",
    "at",
    "force",
    "[foundation]\n",
    "depth",
    "polynomial = [",
    "cosine = {",
    "mean",
    "amplitude",
    "wavelength",
    "phase",
    "points = [[",
    "survey = 'levels.csv'\n",
    "[units]\n",
    "x,depth\n",
    "x,force\n",
    "nan",
    "inf",
    "-inf",
    "-0.0",
    "1e400",
    "5e-324",
    "0x7fffffffffffffff",
    "1_000",
    "\u{feff}",
    "\r\n",
    "\"\"\"",
    "'''",
    "\0",
    "\u{9b}",
    "#",
    ",,",
    "\u{202e}",
];

/// `text` with one to eight changes.
pub(crate) fn mutated(text: &[u8], other: &[u8], random: &mut Random) -> Vec<u8> {
    /// Bytes beyond which a text is not made longer.
    const LONGEST: usize = 4000;
    let mut bytes = text.to_vec();
    for _ in 0..=random.below(8) {
        let at = random.below(bytes.len() + 1);
        let (from, to) = (at.min(bytes.len()), (at + 1 + random.below(20)).min(bytes.len()));
        match random.below(9) {
            0 if at < bytes.len() => bytes[at] ^= 1 << random.below(8),
            1 if at < bytes.len() => bytes[at] = random.pick(b"0123456789.-+eE_ \n\t,[]{}='\"#\\"),
            2 => drop(bytes.drain(from..to)),
            3 => bytes.insert(at, u8::try_from(random.below(256)).unwrap_or(0)),
            4 | 5 => drop(bytes.splice(at..at, random.pick(&WORDS).bytes())),
            6 => drop(bytes.splice(at..at, format!("{:e}", f64::from_bits(random.bits())).into_bytes())),
            7 => {
                let piece = bytes[from..to].to_vec();
                drop(bytes.splice(at..at, piece));
            }
            _ => {
                // The tail of another text.
                let cut = random.below(other.len() + 1);
                bytes.truncate(at);
                bytes.extend_from_slice(&other[cut..]);
            }
        }
        bytes.truncate(LONGEST);
    }
    bytes
}
