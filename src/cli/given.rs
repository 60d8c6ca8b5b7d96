//! What is given, in words: the scene as the program understood it, before any answer.

use palkki::scene::{Foundation, Scene, Support, Units};
use palkki::text::result;

/// Lines `(name, value)`: beam, supports and own shape where they are not the paper's, loads and foundation.
pub(super) fn given(scene: &Scene) -> Vec<(&'static str, String)> {
    let unit = Unit(scene.units());
    let beam = format!(
        "length {}, bending stiffness {}",
        unit.length(scene.beam().length()),
        unit.of(scene.beam().bending_stiffness(), |force, length| format!("{force} {length}²")),
    );
    let mut lines = vec![("beam", beam)];
    if !scene.beam().is_simple() {
        lines.push(("supports", supports(scene, &unit)));
    }
    if let Some(shape) = scene.beam().shape() {
        lines.push(("own shape", profile(shape, "w", &unit)));
    }
    let ground = scene.foundation().map_or_else(|| "none".to_owned(), |foundation| profile(foundation, "u", &unit));
    lines.extend([("load", load(scene, &unit)), ("foundation", ground)]);
    lines
}

fn supports(scene: &Scene, unit: &Unit<'_>) -> String {
    let one = |support: &Support| {
        let level =
            if support.level == 0.0 { String::new() } else { format!(", level {}", unit.length(support.level)) };
        let slope = support.slope.map_or_else(String::new, |slope| format!(", built in at slope {}", result(slope)));
        format!("at {}{level}{slope}", unit.length(support.at))
    };
    let all: Vec<String> = scene.beam().supports().iter().map(one).collect();
    if all.is_empty() { "none".to_owned() } else { all.join("; ") }
}

fn load(scene: &Scene, unit: &Unit<'_>) -> String {
    let load = scene.load();
    let mut parts = Vec::new();
    if load.uniform() != 0.0 {
        parts.push(format!("uniform {}", unit.density(load.uniform())));
    }
    parts.extend(load.linear().iter().map(|part| {
        let ends = [part.start, part.end].map(|q| unit.density(q));
        format!("linear {} to {} from {} to {}", ends[0], ends[1], result(part.from), unit.length(part.to))
    }));
    parts.extend(load.point().iter().map(|part| format!("{} at {}", unit.force(part.force), unit.length(part.at))));
    if parts.is_empty() { "none".to_owned() } else { parts.join("; ") }
}

/// A profile in words; `name` is what its polynomial is called.
fn profile(profile: &Foundation, name: &str, unit: &Unit<'_>) -> String {
    match profile {
        Foundation::Flat { depth } => format!("flat, depth {}", unit.length(*depth)),
        Foundation::Polynomial { coefficients } => {
            let terms = coefficients.iter().enumerate().map(|(power, c)| match power {
                0 => result(*c),
                1 => format!("{} x", result(*c)),
                _ => format!("{} x^{power}", result(*c)),
            });
            format!("polynomial, {name} = {}", terms.collect::<Vec<_>>().join(" + ").replace("+ -", "− "))
        }
        Foundation::Cosine { mean, amplitude, wavelength, phase } => format!(
            "cosine, mean {}, amplitude {}, wavelength {}, phase {}",
            unit.length(*mean),
            unit.length(*amplitude),
            unit.length(*wavelength),
            result(*phase)
        ),
        Foundation::Polyline { points } => {
            let depths = points.iter().map(|p| p[1]);
            let (least, most) =
                depths.fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), u| (least.min(u), most.max(u)));
            format!("polyline of {} points, depths from {} to {}", points.len(), result(least), unit.length(most))
        }
    }
}

/// Numbers with the labels of the scene, where it has them.
struct Unit<'a>(&'a Units);

impl Unit<'_> {
    fn length(&self, value: f64) -> String {
        labelled(value, self.0.length.clone())
    }

    fn force(&self, value: f64) -> String {
        labelled(value, self.0.force.clone())
    }

    fn density(&self, value: f64) -> String {
        self.of(value, |force, length| format!("{force}/{length}"))
    }

    fn of(&self, value: f64, label: impl Fn(&str, &str) -> String) -> String {
        labelled(value, self.0.force.as_deref().zip(self.0.length.as_deref()).map(|(f, l)| label(f, l)))
    }
}

fn labelled(value: f64, label: Option<String>) -> String {
    label.map_or_else(|| result(value), |label| format!("{} {label}", result(value)))
}
