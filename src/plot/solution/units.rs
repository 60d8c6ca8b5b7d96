//! Units and numbers as they are printed.

use crate::plot::DIGITS;
use crate::scene::Units;
use crate::text::significant;

/// Units as they are printed; `None` where the scene names none.
pub(super) struct UnitLabels {
    pub(super) length: Option<String>,
    pub(super) force: Option<String>,
    pub(super) pressure: Option<String>,
    pub(super) moment: Option<String>,
}

impl UnitLabels {
    pub(super) fn of(units: &Units) -> Self {
        let both = |join: &str| Some(format!("{}{join}{}", units.force.as_ref()?, units.length.as_ref()?));
        Self { length: units.length.clone(), force: units.force.clone(), pressure: both("/"), moment: both("·") }
    }
}

/// `1.182 kN`
pub(super) fn with_unit(value: f64, unit: Option<&String>) -> String {
    let number = significant(value, DIGITS);
    unit.map_or(number.clone(), |unit| format!("{number} {unit}"))
}
