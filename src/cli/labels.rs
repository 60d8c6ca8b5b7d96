//! Names of quantities with the labels of their units.

use palkki::scene::Units;

/// Names of quantities with the labels of their units.
pub(super) struct Labels {
    length: Option<String>,
    force: Option<String>,
}

impl Labels {
    pub(super) fn of(units: &Units) -> Self {
        Self { length: units.length.clone(), force: units.force.clone() }
    }

    pub(super) fn length(&self, name: &str) -> String {
        with_unit(name, self.length.clone())
    }

    pub(super) fn force(&self, name: &str) -> String {
        with_unit(name, self.force.clone())
    }

    pub(super) fn stiffness(&self, name: &str) -> String {
        let unit = self.force.as_ref().zip(self.length.as_ref()).map(|(force, length)| format!("{force}/{length}"));
        with_unit(name, unit)
    }

    pub(super) fn moment(&self, name: &str) -> String {
        let unit = self.force.as_ref().zip(self.length.as_ref()).map(|(force, length)| format!("{force} {length}"));
        with_unit(name, unit)
    }
}

fn with_unit(name: &str, unit: Option<String>) -> String {
    unit.map_or_else(|| name.to_owned(), |unit| format!("{name} [{unit}]"))
}
