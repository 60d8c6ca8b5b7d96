//! Two-sided bounds; `null` where there is none.

use palkki::certificate::Certificate;
use serde::Serialize;

#[derive(Debug, Serialize)]
pub(super) struct CertificateObject {
    energy_lower: f64,
    energy_upper: f64,
    gap: f64,
    deflection_error: f64,
    deflection_error_at: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    best_deflection_error: Option<f64>,
    reactions: BracketsObject,
    stiffness: Option<[f64; 2]>,
    /// There only where no list of contacts was proven to be that of the beam.
    #[serde(skip_serializing_if = "Option::is_none")]
    coarse: Option<bool>,
}

#[derive(Debug, Serialize)]
struct BracketsObject {
    left: Option<[f64; 2]>,
    right: Option<[f64; 2]>,
}

impl From<&Certificate> for CertificateObject {
    fn from(certificate: &Certificate) -> Self {
        let [left, right] = certificate.reactions;
        Self {
            energy_lower: certificate.energy_lower,
            energy_upper: certificate.energy_upper,
            gap: certificate.gap,
            deflection_error: certificate.deflection_error,
            deflection_error_at: certificate.deflection_error_at,
            best_deflection_error: None,
            reactions: BracketsObject { left, right },
            stiffness: certificate.stiffness,
            coarse: (!certificate.contacts_proven).then_some(true),
        }
    }
}

impl CertificateObject {
    /// For forces that somebody else computed, whose own deflection may be far from the best one.
    pub(super) fn of_forces(certificate: &Certificate) -> Self {
        Self { best_deflection_error: Some(certificate.best_deflection_error), ..certificate.into() }
    }
}
