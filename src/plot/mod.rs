//! Figures as SVG: pure functions from data to text, without I/O; the same data give the same bytes.
//!
//! [`Figure`], [`Panel`], [`Axis`] and [`Layer`] are the building blocks. [`curves()`] draws a beam in its final position, and
//! [`sheet`] draws many small ones. Deflections and bending moments grow downwards. A concentrated force is an arrow with its value,
//! on its own scale of forces.
//!
//! ```
//! use palkki::plot::{self, Axis, Curves, Figure, Layer, Panel, Style};
//! use palkki::scene::{Beam, Foundation, Load, Scene};
//! use palkki::theory;
//!
//! let beam = Beam::new(10.0, 500.0 / 384.0)?;
//! let load = Load::uniform_on(&beam, 1.0)?;
//! let scene = Scene::new(beam, load, Some(Foundation::Flat { depth: 1.0 }))?;
//! let exact = theory::solve(&scene)?;
//! let svg = plot::curves(&scene, &Curves::exact(&scene, &exact), "beam theory")?;
//! assert!(svg.starts_with("<svg"));
//!
//! // A custom figure: the slope along the beam.
//! let points = (0..=100).map(|i| f64::from(i) / 10.0).map(|x| [x, exact.slope(x)]).collect();
//! let slope = Layer::Series { points, style: Style::of_series(0), label: "slope".to_owned() };
//! let panel = Panel::new(Axis::new("x"), Axis::new("v'").down()).with(slope);
//! assert!(Figure::new("Slope", "The slope of the beam along it.", vec![panel]).svg()?.contains("slope"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod axis;
mod canvas;
mod curves;
mod draw;
mod envelope;
mod figure;
mod label;
mod layer;
mod marks;
mod palette;
mod panel;
mod sketch;
mod solution;
mod sweep;

pub use crate::text::significant;
pub use axis::Axis;
pub use curves::{Curves, PointForce};
pub use envelope::envelope;
pub use figure::Figure;
pub use layer::{Arrow, Arrows, Cell, Divisions, Layer, LoadSketch, Place, SupportKind, SupportMark};
pub use palette::{Color, Dash, Marker, Style, dark_rules};
pub use panel::Panel;
pub use solution::{curves, sheet};
pub use sweep::sweep;

/// The reason why a figure was not drawn.
#[derive(Debug, thiserror::Error)]
pub enum PlotError {
    /// A number that is not finite.
    #[error("{what} must be finite, but is {value}")]
    NotFinite {
        /// Name of the number.
        what: &'static str,
        /// Its value.
        value: f64,
    },
    /// A number that is not positive on a logarithmic axis.
    #[error("{what} must be positive on a logarithmic axis, but is {value}")]
    NotPositive {
        /// Name of the number.
        what: &'static str,
        /// Its value.
        value: f64,
    },
    /// There is nothing to draw.
    #[error("{what} must hold at least one value, but is empty")]
    Empty {
        /// Name of what is empty.
        what: &'static str,
    },
    /// Two lists that belong together have different lengths.
    #[error("{what} must have {expected} values, one for each place, but has {count}")]
    LengthMismatch {
        /// Name of the list.
        what: &'static str,
        /// Number of values in the list.
        count: usize,
        /// Number of values required.
        expected: usize,
    },
    /// The state has no values at nodes. The caller has to sample its curves.
    #[error("a state without nodes has no curves of its own; sample them into `Curves`")]
    NoNodes,
    /// The drawing library failed, which is not expected when it draws to a string.
    #[error("the figure could not be drawn: {0}")]
    Backend(String),
}

/// `value` if it is finite, otherwise an error.
fn finite(what: &'static str, value: f64) -> Result<f64, PlotError> {
    if value.is_finite() { Ok(value) } else { Err(PlotError::NotFinite { what, value }) }
}

/// Checks that `values` has one value for each position.
fn same_length(what: &'static str, values: &[f64], places: &[f64]) -> Result<(), PlotError> {
    if values.len() == places.len() {
        Ok(())
    } else {
        Err(PlotError::LengthMismatch { what, count: values.len(), expected: places.len() })
    }
}

/// A number of lines or columns as `f64`.
fn count(n: usize) -> f64 {
    f64::from(u32::try_from(n).unwrap_or(u32::MAX))
}

/// Number of equal intervals in which a smooth line is drawn; a drawing is 2400 units wide.
const SAMPLES: u32 = 600;

/// Digits of a value that is written beside its point.
const DIGITS: usize = 4;

#[cfg(test)]
mod tests {
    use super::{Curves, PlotError};
    use crate::scene::{Beam, Foundation, LinearLoad, Load, PointLoad, Scene, Units};
    use crate::state::{Contact, ContactState, Extremes, Nodes, Reactions, Regime, SupportForce};

    const LENGTH: f64 = 8.0;

    fn solution(scene: &Scene, state: &ContactState) -> Result<String, PlotError> {
        super::curves(scene, &Curves::of(scene, state)?, "")
    }

    fn scene(foundation: Option<Foundation>) -> Scene {
        let beam = Beam::new(LENGTH, 2.0).expect("a beam");
        let linear = vec![LinearLoad { from: 1.0, to: 3.0, start: 0.0, end: -2.0 }];
        let point = vec![PointLoad { at: 5.0, force: 3.25 }];
        let load = Load::new(&beam, 1.0, linear, point).expect("a load on the beam");
        let units = Units { length: Some("m".to_owned()), force: Some("kN".to_owned()) };
        Scene::new(beam, load, foundation).expect("a well-posed scene").labelled("A beam on the ground", units)
    }

    /// An invented state: the drawing does not check equilibrium.
    fn state(forces: &[f64], clearance: f64) -> ContactState {
        let step = LENGTH / f64::from(u32::try_from(forces.len() + 1).expect("few nodes"));
        let x: Vec<f64> = (1_u32..).take(forces.len()).map(|i| step * f64::from(i)).collect();
        let touching: Vec<f64> = x.iter().zip(forces).filter(|(_, f)| 0.0 < **f).map(|(x, _)| *x).collect();
        let contacts: Vec<Contact> = match (touching.first(), touching.last()) {
            (Some(&from), Some(&to)) => vec![Contact { from, to, force: forces.iter().sum(), end_forces: None }],
            _ => Vec::new(),
        };
        ContactState {
            regime: Regime::of(&contacts),
            reactions: Reactions { left: 1.625, right: -0.375 },
            supports: [(0.0, 1.625), (LENGTH, -0.375)]
                .map(|(at, force)| SupportForce { at, force, moment: None, couple: 0.0, pushes_only: false })
                .into(),
            standing: None,
            contacts,
            touches: Vec::new(),
            deflection: Extremes { max: 0.75, max_at: x[0], min: 0.0, min_at: 0.0 },
            moment: Extremes { max: 0.875, max_at: x[1], min: 0.0, min_at: 0.0 },
            energy: -1.0,
            pressure: None,
            nodes: Some(Nodes {
                discretisation: crate::state::Discretisation::BeamElements,
                deflection: x.iter().map(|x| 0.1 * x * (LENGTH - x)).collect(),
                clearance: vec![clearance; x.len()],
                contact_force: forces.to_vec(),
                moment: x.iter().map(|x| 0.05 * x * (LENGTH - x)).collect(),
                x,
            }),
        }
    }

    fn flat() -> Option<Foundation> {
        Some(Foundation::Flat { depth: 1.5 })
    }

    const FEW: [f64; 7] = [0.0, 0.0, 1.1875, 0.0, 0.4375, 0.0, 0.0];

    #[test]
    fn a_solution_shows_its_forces_and_extremes() {
        let svg = solution(&scene(flat()), &state(&FEW, 0.25)).expect("a figure");
        // Contact forces, reactions and the point load as arrows with their values, then the extremes.
        for text in
            ["1.188 kN", "0.4375 kN", "1.625 kN", "−0.375 kN", "3.25 kN", "q = −1 kN/m", "v = 0.75 m", "M = 0.875 kN·m"]
        {
            assert!(svg.contains(text), "`{text}` is missing");
        }
    }

    #[test]
    fn a_solution_says_what_it_shows() {
        let svg = solution(&scene(flat()), &state(&FEW, 0.25)).expect("a figure");
        assert!(svg.contains("<title id=\"title\">A beam on the ground</title>"), "the title is missing");
        assert!(svg.contains("It touches at 3 m to 5 m."), "the text is missing");
        assert!(!svg.contains("NaN") && !svg.contains("inf"), "a number is not finite");
    }

    #[test]
    fn a_long_contact_is_drawn_by_its_resultants() {
        // Fifteen nodes at half a length unit: at each end two forces become one arrow, and between them there is pressure.
        let mut forces = vec![0.0; 15];
        forces[3..12].fill(0.5);
        (forces[3], forces[4]) = (1.25, 0.8125);
        let svg = solution(&scene(flat()), &state(&forces, 0.0)).expect("a figure");
        assert!(svg.contains("2.063 kN") && svg.contains(">1 kN<"), "a resultant is missing");
        assert!(!svg.contains("1.25 kN") && !svg.contains("0.5 kN"), "a nodal force is written");
        assert!(svg.contains("contact pressure p"), "no pressure");
    }

    #[test]
    fn without_a_foundation_there_is_no_clearance() {
        let svg = solution(&scene(None), &state(&[0.0; 7], f64::INFINITY)).expect("a figure");
        assert!(!svg.contains("clearance h"), "a panel for nothing");
        assert!(svg.contains("There is no foundation, so there is no clearance."), "the text is missing");
    }

    #[test]
    fn nothing_at_all_can_be_drawn() {
        let beam = Beam::new(1e-300, 1e300).expect("a beam");
        let scene = Scene::new(beam, Load::default(), None).expect("a scene");
        let mut state = state(&[0.0; 7], 1.0);
        state.reactions = Reactions::default();
        state.supports.iter_mut().for_each(|support| support.force = 0.0);
        (state.deflection, state.moment) = (Extremes::default(), Extremes::default());
        state.nodes = Some(Nodes {
            discretisation: crate::state::Discretisation::BeamElements,
            x: vec![5e-301],
            deflection: vec![0.0],
            clearance: vec![f64::INFINITY],
            contact_force: vec![0.0],
            moment: vec![0.0],
        });
        assert!(solution(&scene, &state).expect("a figure").ends_with("</svg>\n"));
    }

    #[test]
    fn numbers_that_are_not_finite_are_refused() {
        let spoil: [fn(&mut ContactState); 4] = [
            |s| s.supports[0].force = f64::NAN,
            |s| s.deflection.max = f64::INFINITY,
            |s| s.nodes.as_mut().expect("nodes").moment[2] = f64::NAN,
            |s| s.nodes.as_mut().expect("nodes").clearance[1] = f64::INFINITY,
        ];
        for (i, spoil) in spoil.into_iter().enumerate() {
            let mut state = state(&FEW, 0.25);
            spoil(&mut state);
            let refused = solution(&scene(flat()), &state);
            assert!(matches!(refused, Err(PlotError::NotFinite { .. })), "{i} is not refused");
        }
    }

    #[test]
    fn lists_of_unequal_length_are_refused() {
        let mut state = state(&FEW, 0.25);
        state.nodes.as_mut().expect("nodes").moment.pop();
        let refused = solution(&scene(flat()), &state);
        assert!(
            matches!(refused, Err(PlotError::LengthMismatch { count: 6, expected: 7, .. })),
            "the list is not refused"
        );
        state.nodes = None;
        assert!(matches!(solution(&scene(flat()), &state), Err(PlotError::NoNodes)));
    }
}
