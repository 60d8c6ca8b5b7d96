use palkki::route::Status;
use palkki::scene::file::{ReadProblem, parse};
use palkki::solve_exactly;
use palkki_evidence::elements::{Found, Numbers, reference};
use palkki_evidence::random::{Feature, general};
fn main() {
    let args: Vec<u64> = std::env::args().skip(1).take(2).map(|a| a.parse().unwrap()).collect();
    let of: Vec<Feature> = std::env::args()
        .skip(3)
        .flat_map(|name| {
            Feature::ALL.into_iter().filter(move |f| format!("{f:?}").starts_with(&name)).collect::<Vec<_>>()
        })
        .collect();
    let (mut certified, mut count) = (0, 0);
    let mut why = std::collections::BTreeMap::<String, Vec<u64>>::new();
    let mut worst = [0.0_f64; 4];
    for i in args[0]..args[1] {
        let drawn = general(i, &of, std::env::args().nth(3).is_some_and(|a| a == "s"));
        if std::env::var_os("V").is_some() {
            eprintln!("{i}");
        }
        let mut note = |what: String| why.entry(what).or_default().push(i);
        let scene = match parse("scene.toml", &drawn.text, |_| Err(ReadProblem::Missing)) {
            Ok(scene) => scene,
            Err(error) => {
                note(format!("refused: {}", format!("{:?}", error.problem).chars().take(70).collect::<String>()));
                continue;
            }
        };
        let solution = match solve_exactly(&scene) {
            Ok(s) => s,
            Err(e) => {
                let text = format!("{e:?}");
                let found = reference(&drawn.text);
                note(format!(
                    "no answer: {} {}",
                    text.chars().take(60).collect::<String>(),
                    if matches!(found, Found::Answer(_)) { "BUT FE HAS" } else { "" }
                ));
                continue;
            }
        };
        count += 1;
        let t = std::time::Instant::now();
        if solution.verdict.status != Status::Certified {
            note(format!(
                "not certified {:?}: {}",
                solution.verdict.status,
                solution.verdict.to_string().chars().take(80).collect::<String>()
            ));
        } else {
            certified += 1;
        }
        let found = reference(&drawn.text);
        if t.elapsed().as_secs_f64() > 2.0 {
            println!("{i} slow {:?} {:?}", t.elapsed(), drawn.features);
        }
        let Found::Answer(found) = found else {
            note(format!("elements: {found:?}"));
            continue;
        };
        let (state, Some(exact)) = (&solution.state, solution.exact.as_ref()) else {
            note("no functions".into());
            continue;
        };
        let numbers = Numbers {
            supports: state.supports.iter().map(|support| support.force).collect(),
            contact: state.contact_force(),
            energy: state.energy,
            length: scene.beam().length(),
            deflections: found.places.iter().map(|x| exact.deflection(*x)).collect(),
            moments: found.places.iter().map(|x| Some(exact.moment(*x))).collect(),
        };
        let apart = found.numbers.apart(&numbers);
        let within = [1e-6, 1e-6, 1e-6, 1e-4];
        if (0..4).any(|k| !(apart[k] <= within[k] + 2.0 * found.estimate[k])) {
            note(format!("DIFFERS certified {}", solution.verdict.status == Status::Certified));
            println!("{i} {apart:?} {:?} {:?}", found.estimate, drawn.features);
        }
        (0..4).for_each(|k| worst[k] = worst[k].max(found.estimate[k]));
    }
    println!("{certified} of {count}; estimates {worst:?}");
    for (what, seeds) in why {
        println!("{:4} {what}: {:?}", seeds.len(), &seeds[..seeds.len().min(8)]);
    }
}
