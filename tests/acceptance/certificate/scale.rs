//! Surveys of very many points: proven from a witness in one pass over its contacts and the points between them.

use palkki::certificate::{Judged, certify};
use palkki::scene::{Foundation, Scene};
use palkki::state::Contact;

use crate::scenes::uniform;

/// A survey of so many points, of which some carry the beam with forces that are chosen: the depth there is the deflection
/// under them, by integration from point to point, and all others lie deeper. Length, stiffness and load are 1.
fn survey(points: u32, contacts: u32) -> (Scene, Vec<Contact>) {
    let step = points / (contacts + 1);
    let place = |i: u32| f64::from(i) / f64::from(points);
    let width = place(step);
    // From 0.9 to 1 times what each of them would carry of the load.
    let force = |k: u32| width * (0.9 + 0.05 * f64::from(k % 3));
    let turned: f64 = (1..=contacts).map(|k| force(k) * (1.0 - place(k * step))).sum();
    let h = place(1);
    let touches = |i: u32| 0 < i && i.is_multiple_of(step) && i / step <= contacts;
    let bent = |slope: f64| {
        let (mut v, mut slope, mut moment, mut shear) = (0.0, slope, 0.0, 0.5 - turned);
        let mut values = Vec::new();
        for i in 0..=points {
            values.push(v);
            if touches(i) {
                shear += force(i / step);
            }
            v += slope * h - h * h * (moment / 2.0 + h * (shear / 6.0 - h / 24.0));
            slope -= h * (moment + h * (shear / 2.0 - h / 6.0));
            moment += h * (shear - h / 2.0);
            shear -= h;
        }
        values
    };
    let slope = -bent(0.0).pop().unwrap_or_default();
    let v = bent(slope);
    let most = v.iter().fold(0.0, |most: f64, v| most.max(v.abs()));
    let depth = |(i, v): (u32, &f64)| {
        let below = if touches(i) { 0.0 } else { 1e-3 * most * (1.0 + 0.1 * f64::from(i * 31 % 17)) };
        [place(i), v + below]
    };
    let ground = Foundation::Polyline { points: (0..).zip(&v).map(depth).collect() };
    let scene = uniform(1.0, 1.0, 1.0, ground);
    (scene, (1..=contacts).map(|k| Contact::at(place(k * step), force(k))).collect())
}

/// Few contacts with very many points between them, and many contacts. A pass over all points for each contact would take
/// hours.
#[test]
fn a_survey_of_a_hundred_thousand_points_is_proven() {
    /// Of the largest deflection: forces and curvatures from differences of depths that are known to 16 digits.
    const ERROR: f64 = 1e-9;
    for contacts in [3, 5_000] {
        let (scene, witness) = survey(100_000, contacts);
        let certificate = certify(&scene, Judged::Witness, &witness).expect("the scene can be scaled");
        assert!(certificate.contacts_proven, "{contacts} contacts: {certificate:?}");
        assert!(certificate.deflection_error <= ERROR * certificate.deflection, "{contacts} contacts: {certificate:?}");
        // Without the contacts of one half it is bounded, and not known.
        let without =
            certify(&scene, Judged::Witness, &witness[witness.len() / 2 + 1..]).expect("the scene can be scaled");
        assert!(!without.contacts_proven && without.energy_lower <= certificate.energy_upper, "{without:?}");
        assert!(certificate.energy_lower <= without.energy_upper, "{without:?}");
    }
}
