//! The exact solution at places along the beam, for a table or a figure: it has no nodes of its own.

use super::exact::Exact;
use crate::scene::{Foundation, Scene};

/// Values at one side of a place: where a force acts, shear has one value to the left of it and another to the right.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sample {
    /// Where \[length\].
    pub x: f64,
    /// `v`, positive downwards \[length\].
    pub deflection: f64,
    /// `v'`.
    pub slope: f64,
    /// `h = u − v` \[length\]; infinite without a foundation.
    pub clearance: f64,
    /// Contact pressure, without concentrated forces \[force / length\].
    pub pressure: f64,
    /// `M = −EI v''`, positive with the underside in tension \[force · length\].
    pub moment: f64,
    /// `V = M'` \[force\].
    pub shear: f64,
}

impl Exact {
    /// Samples from support to support of `scene`, which this is the solution of: the ends of equal intervals, and besides
    /// wherever something begins, ends or acts. There, and where shear or pressure jump, a place has two samples, one for
    /// each side.
    #[must_use]
    pub fn samples(&self, scene: &Scene, intervals: u32) -> Vec<Sample> {
        let length = scene.beam().length();
        let mut samples = Vec::new();
        for x in self.places(scene, intervals) {
            let [left, right] = self.shear(x);
            let sample = |pressure, shear| Sample {
                x,
                deflection: self.deflection(x),
                slope: self.slope(x),
                clearance: self.clearance(x),
                pressure,
                moment: self.moment(x),
                shear,
            };
            let jumps = self.state.contacts.iter().any(|c| sits_at(c.from, x) || sits_at(c.to, x));
            let loaded = scene.load().point().iter().any(|load| sits_at(load.at, x));
            let inside = 0.0 < x && x < length;
            if 0.0 < x && (!inside || jumps || loaded) {
                // Pressure is that of the right-hand side; a step to the left is that of the other.
                samples.push(sample(self.pressure(x.next_down()), left));
            }
            if x < length {
                samples.push(sample(self.pressure(x), right));
            }
        }
        samples
    }

    fn places(&self, scene: &Scene, intervals: u32) -> Vec<f64> {
        let length = scene.beam().length();
        let even = (0..=intervals).map(|i| length * f64::from(i) / f64::from(intervals));
        let mut places: Vec<f64> = even.collect();
        places.extend(self.state.contacts.iter().flat_map(|c| [c.from, c.to]));
        places.extend(scene.load().point().iter().map(|load| load.at));
        places.extend(scene.load().linear().iter().flat_map(|load| [load.from, load.to]));
        if let Some(Foundation::Polyline { points }) = scene.foundation() {
            places.extend(points.iter().map(|point| point[0]));
        }
        places.retain(|x| (0.0..=length).contains(x));
        // −0.0 is a place on the beam as well.
        places.iter_mut().for_each(|x| *x += 0.0);
        places.sort_by(f64::total_cmp);
        places.dedup();
        places
    }
}

/// The same places are computed in the same way: they are the same bits or they are other places.
fn sits_at(place: f64, x: f64) -> bool {
    place.total_cmp(&x).is_eq()
}
