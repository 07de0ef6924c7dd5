//! Cells of a row as they are read.

use crate::sweep::RowError;
use crate::sweep::row::{JointLoad, MeasureErrors, Measures, PlyFailure};
use crate::sweep::verdict::ORDER;

/// Word for a failure that the history reaches.
pub(super) const REACHED: &str = "reached";

/// The cells of a row that are not read yet.
pub(super) struct Cells<'a>(pub(super) std::slice::Iter<'a, &'a str>);

impl<'a> Cells<'a> {
    pub(super) fn next(&mut self) -> &'a str {
        self.0.next().copied().unwrap_or_default()
    }

    /// A number, or none in an empty cell.
    pub(super) fn number(&mut self) -> Result<Option<f64>, RowError> {
        let cell = self.next();
        if cell.is_empty() {
            return Ok(None);
        }
        let value = cell.parse::<f64>();
        value
            .map(Some)
            .map_err(|_| RowError::Number(cell.to_owned()))
    }

    /// The numbers of a contact, each followed by its error where a table `states_errors`.
    pub(super) fn contact(&mut self, states_errors: bool) -> Result<Measures, RowError> {
        let load = self.number()?;
        let mut stated = || self.stated(states_errors);
        let [pressure, extent, hoop, angle] = [stated()?, stated()?, stated()?, stated()?];
        let [stick, bearing, share] = [stated()?, stated()?, stated()?];
        Ok(Measures {
            load,
            peak_pressure: pressure.0,
            contact_half_angle: extent.0,
            peak_hoop: pair(hoop.0, angle.0),
            stick_half_angle: stick.0,
            bearing_stress: bearing.0,
            load_share: share.0,
            errors: MeasureErrors {
                peak_pressure: pressure.1,
                contact_half_angle: extent.1,
                peak_hoop: hoop.1,
                peak_hoop_angle: angle.1,
                stick_half_angle: stick.1,
                bearing_stress: bearing.1,
                load_share: share.1,
            },
            ..Measures::default()
        })
    }

    /// A number, followed by its error where a table `states_errors`.
    fn stated(&mut self, states_errors: bool) -> Result<(Option<f64>, Option<f64>), RowError> {
        let value = self.number()?;
        let error = if states_errors { self.number()? } else { None };
        Ok((value, error))
    }

    pub(super) fn first_ply(
        &mut self,
        states_errors: bool,
    ) -> Result<Option<PlyFailure>, RowError> {
        let (load, load_error) = self.stated(states_errors)?;
        let [ply, criterion, mode] = [self.next(), self.next(), self.next()].map(str::to_owned);
        let (angle, found) = (self.number()?, self.next());
        Ok((!found.is_empty()).then(|| PlyFailure {
            load,
            load_error,
            ply,
            criterion,
            mode,
            angle,
            reached: found == REACHED,
        }))
    }

    pub(super) fn joint(&mut self, states_errors: bool) -> Result<Option<JointLoad>, RowError> {
        let (load, load_error) = self.stated(states_errors)?;
        let bearing_stress = self.number()?;
        let (mode, angle, found) = (self.next(), self.number()?, self.next());
        let known = ORDER.into_iter().find(|known| known.name() == mode);
        match known.zip(angle) {
            Some((mode, angle)) => Ok(Some(JointLoad {
                load,
                load_error,
                bearing_stress,
                mode,
                angle,
                reached: found == REACHED,
            })),
            None if mode.is_empty() => Ok(None),
            None => Err(RowError::Mode(mode.to_owned())),
        }
    }
}

/// The number of a case.
pub(super) fn whole(cell: &str) -> Result<usize, RowError> {
    cell.parse()
        .map_err(|_| RowError::CaseNumber(cell.to_owned()))
}

fn pair(first: Option<f64>, second: Option<f64>) -> Option<[f64; 2]> {
    first.zip(second).map(|(first, second)| [first, second])
}
