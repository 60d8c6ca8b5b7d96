//! The numbers of a scene by their path in a scene file: reading one, and the same scene with another value.

use super::ground::GroundStiffness;
use super::quantity::{Profile, ProfileKey, Quantity};
use super::{Beam, CoupleLoad, Foundation, Joint, LinearLoad, Load, PointLoad, Scene, SceneError, Support};

/// The reason why a path does not lead to a number that can be varied.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum PathError {
    /// The scene has no number with this path.
    #[error("the scene has no number `{path}`; {} {}", it_has(near.as_deref()), in_backticks(known))]
    Unknown {
        /// The path.
        path: String,
        /// An existing path with a similar spelling.
        near: Option<String>,
        /// The existing paths; `[0…3]` stands for each of these indices.
        known: Vec<String>,
    },
    /// The length of the beam, which cannot be varied.
    #[error(
        "`beam.length` cannot be varied: places of loads, supports and ground are measured along the beam, and it is not said \
         which of them would move with its end"
    )]
    Length,
}

fn it_has(near: Option<&str>) -> String {
    near.map_or_else(|| "it has".to_owned(), |near| format!("did you mean `{near}`? It has"))
}

fn in_backticks(paths: &[String]) -> String {
    paths.iter().map(|path| format!("`{path}`")).collect::<Vec<_>>().join(", ")
}

impl Scene {
    /// The number that a path stands for. The position and the depth of a point of a polyline may be written `[0]` and `[1]`, as
    /// in the file, or `.x` and `.depth`. The path may name the default supports at both ends and a zero uniform load or axial
    /// force even if the file omits them.
    ///
    /// # Errors
    ///
    /// A [`PathError`] that lists the numbers that can be varied.
    pub(crate) fn quantity(&self, path: &str) -> Result<Quantity, PathError> {
        if path == Quantity::Length.to_string() {
            return Err(PathError::Length);
        }
        let written = match path.rsplit_once('.') {
            Some((point, "x")) if point.contains(".points[") => format!("{point}[0]"),
            Some((point, "depth")) if point.contains(".points[") => format!("{point}[1]"),
            _ => path.to_owned(),
        };
        let groups = self.groups();
        let found = groups.iter().flat_map(|group| group.all()).find(|quantity| quantity.to_string() == written);
        found.ok_or_else(|| PathError::Unknown {
            path: path.to_owned(),
            near: nearest(path, &groups),
            known: groups.iter().filter_map(Group::path).collect(),
        })
    }

    /// The value of a number; [`None`] if the scene does not have it.
    #[must_use]
    pub fn number(&self, quantity: Quantity) -> Option<f64> {
        Numbers::of(self).at(quantity).copied()
    }

    /// The same scene with another value of a number, checked again. If the scene does not have the number, nothing changes.
    ///
    /// # Errors
    ///
    /// Every [`SceneError`] of its parts.
    pub fn with_number(&self, quantity: Quantity, value: f64) -> Result<Self, SceneError> {
        self.with_numbers([(quantity, value)])
    }

    /// The same scene with several numbers changed at once. Intermediate states need not be valid scenes.
    ///
    /// # Errors
    ///
    /// Those of [`Scene::with_number`].
    pub(crate) fn with_numbers(&self, values: impl IntoIterator<Item = (Quantity, f64)>) -> Result<Self, SceneError> {
        let mut numbers = Numbers::of(self);
        for (quantity, value) in values {
            if let Some(number) = numbers.at(quantity) {
                *number = value;
            }
        }
        let Numbers { tension, supports, shape, foundation, springs, .. } = numbers;
        let beam = Beam::new(self.beam.length(), numbers.stiffness)?.with_supports(supports)?;
        let beam = beam.with_joints(numbers.joints)?.with_tension(tension)?;
        let beam = if numbers.steps.is_empty() { beam } else { beam.with_steps(numbers.steps)? };
        let beam = match shape {
            Some(shape) => beam.with_shape(shape)?,
            None => beam,
        };
        let load =
            Load::new(&beam, numbers.uniform, numbers.linear, numbers.point)?.with_couples(&beam, numbers.couple)?;
        let springs = match springs {
            Some(GroundStiffness { greatest, steps }) if steps.is_empty() => Some(GroundStiffness::one(greatest)?),
            Some(GroundStiffness { steps, .. }) => Some(GroundStiffness::in_steps(steps, beam.length())?),
            None => None,
        };
        Ok(Self::built(beam, load, foundation, springs)?.labelled(self.title.clone(), self.units.clone()))
    }

    /// The same scene with the whole foundation moved downwards by `down` \[length\].
    ///
    /// # Errors
    ///
    /// Every [`SceneError`] of [`Foundation::checked`], above all a foundation above a support.
    pub fn with_ground_moved(&self, down: f64) -> Result<Self, SceneError> {
        let mut foundation = self.foundation().cloned();
        match &mut foundation {
            None => {}
            Some(Foundation::Flat { depth }) => *depth += down,
            Some(Foundation::Polynomial { coefficients }) => coefficients.iter_mut().take(1).for_each(|c| *c += down),
            Some(Foundation::Cosine { mean, .. }) => *mean += down,
            Some(Foundation::Polyline { points }) => points.iter_mut().for_each(|point| point[1] += down),
        }
        self.above_other(foundation)
    }

    /// The numbers that can be varied.
    fn groups(&self) -> Vec<Group> {
        let steps = self.beam.steps().len();
        let mut groups = if steps == 0 { vec![Group::one(Quantity::BendingStiffness)] } else { Vec::new() };
        groups.extend([Quantity::StepAt, Quantity::StepStiffness].map(|of| Group::each(of, steps)));
        groups.push(Group::each(Quantity::JointAt, self.beam.joints().len()));
        for (i, joint) in self.beam.joints().iter().enumerate() {
            groups.extend(joint.stiffness.map(|_| Group::one(Quantity::JointStiffness(i))));
        }
        groups.push(Group::one(Quantity::Tension));
        let supports = self.beam.supports_as_given().len();
        groups.extend([Quantity::SupportAt, Quantity::SupportLevel].map(|of| Group::each(of, supports)));
        // In the order of the file.
        for (i, support) in self.beam.supports_as_given().into_iter().enumerate() {
            let own = [
                support.slope.map(|_| Quantity::SupportSlope(i)),
                support.stiffness.map(|_| Quantity::SupportStiffness(i)),
                support.turning_stiffness.map(|_| Quantity::SupportTurningStiffness(i)),
            ];
            groups.extend(own.into_iter().flatten().map(Group::one));
        }
        groups.extend(self.beam.shape().into_iter().flat_map(|shape| groups_of(Profile::Shape, shape)));
        groups.push(Group::one(Quantity::Uniform));
        let linear = self.load.linear().len();
        let ends = [Quantity::LinearFrom, Quantity::LinearTo, Quantity::LinearStart, Quantity::LinearEnd];
        groups.extend(ends.map(|of| Group::each(of, linear)));
        let point = self.load.point().len();
        groups.extend([Quantity::PointAt, Quantity::PointForce].map(|of| Group::each(of, point)));
        let couple = self.load.couple().len();
        groups.extend([Quantity::CoupleAt, Quantity::CoupleMoment].map(|of| Group::each(of, couple)));
        groups.extend(self.foundation.iter().flat_map(|foundation| groups_of(Profile::Foundation, foundation)));
        let steps = self.ground_steps().len();
        groups.extend(self.ground_stiffness().filter(|_| steps == 0).map(|_| Group::one(Quantity::GroundStiffness)));
        groups.extend([Quantity::GroundStepAt, Quantity::GroundStepStiffness].map(|of| Group::each(of, steps)));
        groups
    }
}

/// The path most similar to `path`: it ends with `path`, or at most two fifths of its letters differ.
fn nearest(path: &str, groups: &[Group]) -> Option<String> {
    /// Limit for the letters of a path that is compared, and for the paths of each group.
    const MOST: usize = 100;
    if MOST < path.len() {
        return None;
    }
    let known = groups.iter().flat_map(|group| group.all().take(MOST)).map(|quantity| quantity.to_string());
    let rated = known.filter_map(|known| {
        let letters = known.chars().count().max(path.chars().count());
        let changes = if known.ends_with(&format!(".{path}")) { 0 } else { changes(path, &known) };
        (5 * changes <= 2 * letters).then_some((changes, known))
    });
    rated.min_by_key(|(changes, _)| *changes).map(|(_, known)| known)
}

/// The smallest number of letters to insert, remove or replace to change one word into the other (edit distance).
fn changes(from: &str, to: &str) -> usize {
    let mut row: Vec<usize> = (0..=to.chars().count()).collect();
    for (i, a) in from.chars().enumerate() {
        let mut beside = i;
        row[0] = i + 1;
        for (j, b) in to.chars().enumerate() {
            let replaced = beside + usize::from(a != b);
            beside = row[j + 1];
            row[j + 1] = replaced.min(beside + 1).min(row[j] + 1);
        }
    }
    row[to.chars().count()]
}

/// The numbers of a profile.
fn groups_of(of: Profile, profile: &Foundation) -> Vec<Group> {
    let one = |key| Group::one(Quantity::Profile(of, key));
    match profile {
        Foundation::Flat { .. } => vec![one(ProfileKey::Depth)],
        Foundation::Polynomial { coefficients } => {
            let coefficient: fn(Profile, usize) -> Quantity = |of, i| Quantity::Profile(of, ProfileKey::Coefficient(i));
            vec![Group { of: Make::Profile(of, coefficient), count: coefficients.len() }]
        }
        Foundation::Cosine { .. } => {
            [ProfileKey::Mean, ProfileKey::Amplitude, ProfileKey::Wavelength, ProfileKey::Phase].map(one).into()
        }
        Foundation::Polyline { points } => {
            let axes: [fn(Profile, usize) -> Quantity; 2] = [
                |of, i| Quantity::Profile(of, ProfileKey::PolylineX(i)),
                |of, i| Quantity::Profile(of, ProfileKey::PolylineDepth(i)),
            ];
            axes.map(|axis| Group { of: Make::Profile(of, axis), count: points.len() }).into()
        }
    }
}

/// Numbers that differ only in an index.
#[derive(Debug, Clone, Copy)]
struct Group {
    of: Make,
    count: usize,
}

/// A quantity, or a function that returns the quantity with an index.
#[derive(Debug, Clone, Copy)]
enum Make {
    One(Quantity),
    Each(fn(usize) -> Quantity),
    Profile(Profile, fn(Profile, usize) -> Quantity),
}

impl Group {
    fn one(quantity: Quantity) -> Self {
        Self { of: Make::One(quantity), count: 1 }
    }

    fn each(of: fn(usize) -> Quantity, count: usize) -> Self {
        Self { of: Make::Each(of), count }
    }

    fn all(self) -> impl Iterator<Item = Quantity> {
        (0..self.count).map(move |i| match self.of {
            Make::One(quantity) => quantity,
            Make::Each(of) => of(i),
            Make::Profile(profile, of) => of(profile, i),
        })
    }

    /// The common path of the group in messages; [`None`] if the group is empty.
    fn path(&self) -> Option<String> {
        let first = self.all().next()?.to_string();
        match self.count {
            1 => Some(first),
            count => Some(first.replacen("[0]", &format!("[0…{}]", count - 1), 1)),
        }
    }
}

/// The numbers of a scene as an editable copy.
struct Numbers {
    stiffness: f64,
    steps: Vec<[f64; 2]>,
    joints: Vec<Joint>,
    tension: f64,
    /// In the order in which they were given, to which the indices refer.
    supports: Vec<Support>,
    shape: Option<Foundation>,
    uniform: f64,
    linear: Vec<LinearLoad>,
    point: Vec<PointLoad>,
    couple: Vec<CoupleLoad>,
    foundation: Option<Foundation>,
    springs: Option<GroundStiffness>,
}

impl Numbers {
    fn of(scene: &Scene) -> Self {
        let (beam, load) = (&scene.beam, &scene.load);
        Self {
            stiffness: beam.bending_stiffness(),
            steps: beam.steps().to_vec(),
            joints: beam.joints().to_vec(),
            tension: beam.tension(),
            supports: beam.supports_as_given(),
            shape: beam.shape().cloned(),
            uniform: load.uniform(),
            linear: load.linear().to_vec(),
            point: scene.point_loads(),
            couple: load.couple().to_vec(),
            foundation: scene.foundation().cloned(),
            springs: scene.stiffness.clone(),
        }
    }

    fn at(&mut self, quantity: Quantity) -> Option<&mut f64> {
        match quantity {
            Quantity::Length | Quantity::Supports | Quantity::TotalLoad => None,
            Quantity::BendingStiffness => Some(&mut self.stiffness).filter(|_| self.steps.is_empty()),
            Quantity::StepAt(i) => self.steps.get_mut(i).map(|step| &mut step[0]),
            Quantity::StepStiffness(i) => self.steps.get_mut(i).map(|step| &mut step[1]),
            Quantity::JointAt(i) => self.joints.get_mut(i).map(|joint| &mut joint.at),
            Quantity::JointStiffness(i) => self.joints.get_mut(i)?.stiffness.as_mut(),
            Quantity::Tension => Some(&mut self.tension),
            Quantity::GroundStiffness => {
                self.springs.as_mut().filter(|k| k.steps.is_empty()).map(|springs| &mut springs.greatest)
            }
            Quantity::GroundStepAt(i) => Some(&mut self.springs.as_mut()?.steps.get_mut(i)?[0]),
            Quantity::GroundStepStiffness(i) => Some(&mut self.springs.as_mut()?.steps.get_mut(i)?[1]),
            Quantity::Uniform => Some(&mut self.uniform),
            Quantity::LinearFrom(i) => self.linear.get_mut(i).map(|load| &mut load.from),
            Quantity::LinearTo(i) => self.linear.get_mut(i).map(|load| &mut load.to),
            Quantity::LinearStart(i) => self.linear.get_mut(i).map(|load| &mut load.start),
            Quantity::LinearEnd(i) => self.linear.get_mut(i).map(|load| &mut load.end),
            Quantity::PointAt(i) => self.point.get_mut(i).map(|load| &mut load.at),
            Quantity::PointForce(i) => self.point.get_mut(i).map(|load| &mut load.force),
            Quantity::CoupleAt(i) => self.couple.get_mut(i).map(|load| &mut load.at),
            Quantity::CoupleMoment(i) => self.couple.get_mut(i).map(|load| &mut load.moment),
            Quantity::SupportAt(i) => self.supports.get_mut(i).map(|support| &mut support.at),
            Quantity::SupportLevel(i) => self.supports.get_mut(i).map(|support| &mut support.level),
            Quantity::SupportSlope(i) => self.supports.get_mut(i)?.slope.as_mut(),
            Quantity::SupportStiffness(i) => self.supports.get_mut(i)?.stiffness.as_mut(),
            Quantity::SupportTurningStiffness(i) => self.supports.get_mut(i)?.turning_stiffness.as_mut(),
            Quantity::Profile(of, key) => {
                let profile = match of {
                    Profile::Foundation => self.foundation.as_mut()?,
                    Profile::Shape => self.shape.as_mut()?,
                };
                match (profile, key) {
                    (Foundation::Flat { depth }, ProfileKey::Depth) => Some(depth),
                    (Foundation::Polynomial { coefficients }, ProfileKey::Coefficient(i)) => coefficients.get_mut(i),
                    (Foundation::Cosine { mean, .. }, ProfileKey::Mean) => Some(mean),
                    (Foundation::Cosine { amplitude, .. }, ProfileKey::Amplitude) => Some(amplitude),
                    (Foundation::Cosine { wavelength, .. }, ProfileKey::Wavelength) => Some(wavelength),
                    (Foundation::Cosine { phase, .. }, ProfileKey::Phase) => Some(phase),
                    (Foundation::Polyline { points }, ProfileKey::PolylineX(i)) => Some(&mut points.get_mut(i)?[0]),
                    (Foundation::Polyline { points }, ProfileKey::PolylineDepth(i)) => Some(&mut points.get_mut(i)?[1]),
                    _ => None,
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::file::{ReadProblem, parse};
    use super::*;

    fn scene() -> Scene {
        let text = "[beam]\nlength = 10\nbending_stiffness = 2\nsupports = [{ at = 10 }, { at = 0, level = -0.5, built_in = true }]\n\
                    [load]\nuniform = 1\npoint = [{ at = 3, force = 4 }]\n\
                    [foundation]\npoints = [[0, 1], [5, 2], [10, 1]]\n";
        parse("scene.toml", text, |_| Err(ReadProblem::Missing)).expect("a scene")
    }

    #[test]
    fn every_number_that_is_listed_can_be_set() {
        let scene = scene();
        let all: Vec<Quantity> = scene.groups().iter().flat_map(|group| group.all()).collect();
        assert_eq!(all.len(), 1 + 1 + 2 + 2 + 1 + 1 + 2 + 6, "{all:?}");
        for quantity in all {
            let value = scene.number(quantity).expect("it is there");
            assert_eq!(scene.quantity(&quantity.to_string()), Ok(quantity));
            assert_eq!(scene.with_number(quantity, value).as_ref(), Ok(&scene), "{quantity}");
        }
    }

    /// Of twenty letters eight may differ, but not nine.
    #[test]
    fn a_path_with_two_fifths_of_its_letters_wrong_is_understood() {
        let scene = scene().on_springs(3.0).expect("ground");
        let told = |path: &str| scene.quantity(path).expect_err("no number").to_string();
        assert!(told("foundation.sxxxxxxxx").contains("did you mean `foundation.stiffness`?"));
        assert!(!told("foundation.xxxxxxxxx").contains("did you mean"));
    }

    /// The indices of supports are those of the file, also after one support moves past another.
    #[test]
    fn supports_are_counted_as_in_the_file() {
        let scene = scene();
        assert_eq!(scene.number(Quantity::SupportLevel(1)).map(f64::to_bits), Some((-0.5_f64).to_bits()));
        assert_eq!(scene.number(Quantity::SupportSlope(0)), None);
        let free = scene.with_number(Quantity::SupportAt(1), 4.0).expect("a scene");
        let moved = free.with_number(Quantity::SupportAt(0), 2.0).expect("a scene");
        assert_eq!(moved.number(Quantity::SupportLevel(1)).map(f64::to_bits), Some((-0.5_f64).to_bits()));
        let places: Vec<f64> = moved.beam().all_supports().iter().map(|s| s.at).collect();
        assert_eq!(places.iter().map(|x| x.to_bits()).collect::<Vec<_>>(), [2.0_f64, 4.0].map(f64::to_bits));
    }

    #[test]
    fn a_path_that_is_not_there_is_answered_with_those_that_are() {
        let scene = scene();
        assert_eq!(scene.quantity("foundation.points[1].depth"), scene.quantity("foundation.points[1][1]"));
        let error = scene.quantity("foundation.depth").expect_err("no such number");
        let message = error.to_string();
        for known in ["`beam.bending_stiffness`", "`foundation.points[0…2][1]`", "`load.point[0].at`"] {
            assert!(message.contains(known), "{message}");
        }
        assert!(!message.contains("linear"), "{message}");
        assert_eq!(scene.quantity("beam.length"), Err(PathError::Length));
    }
}
