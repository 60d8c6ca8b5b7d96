use palkki_evidence::elements::{Found, reference};
use palkki_evidence::random::{Feature, general};
fn main() {
    let mut args = std::env::args().skip(1);
    let i: u64 = args.next().unwrap().parse().unwrap();
    let of: Vec<Feature> = args
        .flat_map(|name| {
            Feature::ALL.into_iter().filter(move |f| format!("{f:?}").starts_with(&name)).collect::<Vec<_>>()
        })
        .collect();
    let text = if of.is_empty() {
        std::fs::read_to_string(std::env::args().nth(2).unwrap()).unwrap()
    } else {
        general(i, &of, std::env::args().nth(2).is_some_and(|a| a == "s")).text
    };
    println!("{text}");
    let t = std::time::Instant::now();
    match reference(&text) {
        Found::Answer(f) => println!(
            "# {:?} {:?} {:?}\n# deflections {:?}",
            f.numbers.supports, f.numbers.contact, f.numbers.energy, f.numbers.deflections
        ),
        o => println!("# {o:?}"),
    }
    println!("# {:?}", t.elapsed());
}
