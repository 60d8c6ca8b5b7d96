//! What is given, in words: the scene as the program understood it, before any answer.

use palkki::scene::{Foundation, Scene, Units};
use palkki::text::result;

/// Lines `(name, value)`: beam, loads and foundation.
pub(super) fn given(scene: &Scene) -> Vec<(&'static str, String)> {
    let unit = Unit(scene.units());
    let beam = format!(
        "length {}, bending stiffness {}",
        unit.length(scene.beam().length()),
        unit.of(scene.beam().bending_stiffness(), |force, length| format!("{force} {length}²")),
    );
    vec![("beam", beam), ("load", load(scene, &unit)), ("foundation", foundation(scene, &unit))]
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

fn foundation(scene: &Scene, unit: &Unit<'_>) -> String {
    match scene.foundation() {
        None => "none".to_owned(),
        Some(Foundation::Flat { depth }) => format!("flat, depth {}", unit.length(*depth)),
        Some(Foundation::Polynomial { coefficients }) => {
            let terms = coefficients.iter().enumerate().map(|(power, c)| match power {
                0 => result(*c),
                1 => format!("{} x", result(*c)),
                _ => format!("{} x^{power}", result(*c)),
            });
            format!("polynomial, u = {}", terms.collect::<Vec<_>>().join(" + ").replace("+ -", "− "))
        }
        Some(Foundation::Cosine { mean, amplitude, wavelength, phase }) => format!(
            "cosine, mean {}, amplitude {}, wavelength {}, phase {}",
            unit.length(*mean),
            unit.length(*amplitude),
            unit.length(*wavelength),
            result(*phase)
        ),
        Some(Foundation::Polyline { points }) => {
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
