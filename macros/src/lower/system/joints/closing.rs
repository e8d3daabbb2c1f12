//! Joints that close loops.

use crate::errors::Errors;
use crate::lower::system::reading::reader::Reader;
use crate::model::{Axes, Connection};
use crate::syntax::call;

use super::joint::ReadJoint;

impl Reader<'_> {
    /// Separates joints that close loops from the other joints.
    pub fn closings(
        &mut self,
        closing: &[usize],
        mut joints: Vec<Option<ReadJoint>>,
        errors: &mut Errors,
    ) -> (Vec<Connection>, Vec<Option<ReadJoint>>) {
        let mut closings = Vec::new();
        for index in closing {
            self.members.joints[*index].closes = true;
            let Some(written) = joints[*index].take() else {
                continue;
            };
            let mut connection = written.connection;
            if let (Axes::Written(1), false, [axis]) = (
                connection.kind.axes,
                self.system.is_planar,
                &*connection.directions,
            ) {
                let both = self.across(*axis);
                connection.directions.extend(both);
            }
            if connection
                .pitch
                .is_some_and(|pitch| self.work.graph.is_zero(pitch))
            {
                let value = self.system.joints[*index].value.as_ref();
                let place = value.and_then(call).map(|((_, all), _)| all[3].extent);
                errors.push(
                    place.unwrap_or(written.mention.into()),
                    "a screw that closes a loop has a pitch: without one it is `revolute(P, Q, direction)`",
                );
                continue;
            }
            closings.push(connection);
        }
        (closings, joints)
    }
}
