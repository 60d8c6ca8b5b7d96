use palkki::scene::file::{ReadProblem, parse};
use palkki::{proof, theory};
use palkki_evidence::authority::check::{Scene, check};
use palkki_evidence::random::{Feature, general};
fn main() {
    let args: Vec<u64> = std::env::args().skip(1).take(2).map(|a| a.parse().unwrap()).collect();
    let of: Vec<Feature> = std::env::args()
        .skip(4)
        .flat_map(|name| {
            Feature::ALL.into_iter().filter(move |f| format!("{f:?}").starts_with(&name)).collect::<Vec<_>>()
        })
        .collect();
    let soil = std::env::args().nth(3).is_some_and(|a| a == "s");
    let mut why = std::collections::BTreeMap::<String, Vec<u64>>::new();
    for i in args[0]..args[1] {
        let drawn = general(i, &of, soil);
        let mut note = |what: String| why.entry(what).or_default().push(i);
        let Ok(scene) = parse("scene.toml", &drawn.text, |_| Err(ReadProblem::Missing)) else {
            note("refused".into());
            continue;
        };
        let Ok(exact) = theory::solve(&scene) else {
            note("no answer".into());
            continue;
        };
        if !exact.solved {
            note("not solved".into());
            continue;
        }
        match proof::prove(&scene, &exact) {
            Err(e) => note(format!("unproven: {}", format!("{e:?}").chars().take(60).collect::<String>())),
            Ok(fields) => {
                let json = fields.json();
                let read = Scene::read(&drawn.text, &|_| Err("none".into())).unwrap();
                match check(&read, &serde_json::from_str(&json).unwrap()) {
                    Err(w) => note(format!("REFUSED {}", w.chars().take(40).collect::<String>())),
                    Ok([low, up]) => {
                        let (low, gap) = (low.to_f64().value(), (&up - &low).to_f64().value());
                        let e = exact.state.energy;
                        if std::env::var_os("W").is_some() {
                            std::fs::write(format!("/tmp/proofs/{i}.toml"), &drawn.text).unwrap();
                            std::fs::write(format!("/tmp/proofs/{i}.json"), &json).unwrap();
                            println!("{i} {low:?} {gap:e}");
                        }
                        if gap < 0.0 {
                            note("ORDER".into())
                        } else if gap > 1e-12 * e.abs() || (low - e).abs() > 1e-11 * e.abs() {
                            println!(
                                "{i} wide {:e} off {:e} lifted {}",
                                gap / e.abs(),
                                (low - e) / e,
                                fields.is_lifted
                            );
                            note("wide".into())
                        } else {
                            note("sharp".into())
                        }
                    }
                }
            }
        }
    }
    for (what, seeds) in why {
        println!("{:4} {what}: {:?}", seeds.len(), &seeds[..seeds.len().min(8)]);
    }
}
