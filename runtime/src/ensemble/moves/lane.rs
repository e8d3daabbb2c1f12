//! The member in a lane of a register.

use crate::integrate::Stretch;

/// The member in a lane.
#[derive(Clone, Copy)]
pub(super) struct Lane {
    /// Its index in the blocks; `None` for an empty lane.
    pub(super) member: Option<usize>,
    pub(super) state: Progress,
    pub(super) stretch: Stretch,
}

/// The progress of a member.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Progress {
    Going,
    There,
    /// Left for separate integration.
    Left,
}

impl Lane {
    pub(super) const EMPTY: Self = Self {
        member: None,
        state: Progress::Going,
        stretch: Stretch::ALL,
    };

    /// A member that goes on in a stretch of time.
    pub(super) fn within(member: Option<usize>, stretch: Stretch) -> Self {
        Self {
            member,
            stretch,
            ..Self::EMPTY
        }
    }
}
