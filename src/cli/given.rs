//! The given data in words: the scene as the program reads it, before any answer.

use palkki::scene::{Foundation, Joint, Scene, Support};

use super::table::Labels;

/// Lines `(name, value)`: beam, loads and foundation; joints, tension, supports and initial shape where they differ from the paper's
/// beam.
pub(super) fn scene_lines(scene: &Scene, labels: &Labels) -> Vec<(&'static str, String)> {
    let beam = format!(
        "length {}, bending stiffness {}",
        labels.length.value(scene.beam().length()),
        stiffness(scene, labels),
    );
    let mut lines = vec![("beam", beam)];
    if !scene.beam().joints().is_empty() {
        let one = |joint: &Joint| {
            let at = labels.length.value(joint.at);
            joint
                .stiffness
                .map_or_else(|| format!("hinge at {at}"), |k| format!("at {at}, stiffness {}", labels.moment.value(k)))
        };
        lines.push(("joints", few(&scene.beam().joints().iter().map(one).collect::<Vec<_>>())));
    }
    if scene.beam().tension() != 0.0 {
        lines.push(("tension", labels.force.value(scene.beam().tension())));
    }
    if !scene.beam().is_simple() {
        lines.push(("supports", supports(scene, labels)));
    }
    if let Some(shape) = scene.beam().shape() {
        lines.push(("initial shape", profile(shape, "w", labels)));
    }
    let ground = scene.foundation().map_or_else(|| "none".to_owned(), |foundation| profile(foundation, "u", labels));
    let step = |&[at, k]: &[f64; 2]| format!("{} from {}", labels.number(k), labels.number(at));
    let gives = |k: f64| match scene.ground_steps() {
        [] => labels.number(k),
        steps => few(&steps.iter().map(step).collect::<Vec<_>>()),
    };
    let ground = match scene.ground_stiffness() {
        Some(k) => format!("{ground}, stiffness {}", gives(k)),
        None => ground,
    };
    lines.extend([("load", load(scene, labels)), ("foundation", ground)]);
    lines
}

/// The bending stiffness, or the bending stiffness of each step.
fn stiffness(scene: &Scene, labels: &Labels) -> String {
    let step =
        |&[at, value]: &[f64; 2]| format!("{} from {}", labels.bending_stiffness.value(value), labels.number(at));
    match scene.beam().steps() {
        [] => labels.bending_stiffness.value(scene.beam().bending_stiffness()),
        steps => few(&steps.iter().map(step).collect::<Vec<_>>()),
    }
}

fn supports(scene: &Scene, labels: &Labels) -> String {
    let one = |support: &Support| {
        let level = if support.level == 0.0 {
            String::new()
        } else {
            format!(", level {}", labels.length.value(support.level))
        };
        let slope = support.slope.map_or_else(String::new, |slope| match support.turning_stiffness {
            None => format!(", built in at slope {}", labels.number(slope)),
            Some(k) => format!(", turning stiffness {} from slope {}", labels.moment.value(k), labels.number(slope)),
        });
        let gives = support.stiffness.map_or_else(String::new, |k| format!(", stiffness {}", labels.density.value(k)));
        let pushes = if support.pushes_only { ", pushes only" } else { "" };
        format!("at {}{level}{gives}{slope}{pushes}", labels.length.value(support.at))
    };
    let all: Vec<String> = scene.beam().all_supports().iter().map(one).collect();
    few(&all)
}

fn load(scene: &Scene, labels: &Labels) -> String {
    let load = scene.load();
    let mut parts = Vec::new();
    if load.uniform() != 0.0 {
        parts.push(format!("uniform {}", labels.density.value(load.uniform())));
    }
    parts.extend(load.linear().iter().map(|part| {
        let ends = [part.start, part.end].map(|q| labels.density.value(q));
        format!(
            "linear {} to {} from {} to {}",
            ends[0],
            ends[1],
            labels.number(part.from),
            labels.length.value(part.to)
        )
    }));
    parts.extend(
        scene
            .point_loads()
            .iter()
            .map(|part| format!("{} at {}", labels.force.value(part.force), labels.length.value(part.at))),
    );
    parts.extend(
        load.couple()
            .iter()
            .map(|part| format!("couple {} at {}", labels.moment.value(part.moment), labels.length.value(part.at))),
    );
    few(&parts)
}

/// The first entries, and how many there are if not all are shown.
fn few(all: &[String]) -> String {
    /// About three lines of a terminal.
    const SHOWN: usize = 8;
    match all.len() {
        0 => "none".to_owned(),
        count if count <= SHOWN + 1 => all.join("; "),
        count => format!("{}; and {} more, {count} in all", all[..SHOWN].join("; "), count - SHOWN),
    }
}

/// A profile in words; `name` is the symbol of its polynomial.
fn profile(profile: &Foundation, name: &str, labels: &Labels) -> String {
    match profile {
        Foundation::Flat { depth } => format!("flat, depth {}", labels.length.value(*depth)),
        Foundation::Polynomial { coefficients } => {
            let terms = coefficients.iter().enumerate().map(|(power, c)| match power {
                0 => labels.number(*c),
                1 => format!("{} x", labels.number(*c)),
                _ => format!("{} x^{power}", labels.number(*c)),
            });
            format!("polynomial, {name} = {}", terms.collect::<Vec<_>>().join(" + ").replace("+ -", "− "))
        }
        Foundation::Cosine { mean, amplitude, wavelength, phase } => format!(
            "cosine, mean {}, amplitude {}, wavelength {}, phase {}",
            labels.length.value(*mean),
            labels.length.value(*amplitude),
            labels.length.value(*wavelength),
            labels.number(*phase)
        ),
        Foundation::Polyline { points } => {
            let depths = points.iter().map(|p| p[1]);
            let (least, most) =
                depths.fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), u| (least.min(u), most.max(u)));
            format!(
                "polyline of {} points, depths from {} to {}",
                points.len(),
                labels.number(least),
                labels.length.value(most)
            )
        }
    }
}
