//! Joints that close loops.

use crate::model::Closing;

use super::joint::Written;
use crate::lower::system::reading::reader::Reader;

impl Reader<'_> {
    /// Takes the joints that close loops from the others.
    pub fn closings(
        &mut self,
        closing: &[usize],
        mut joints: Vec<Option<Written>>,
    ) -> (Vec<Closing>, Vec<Option<Written>>) {
        let mut closings = Vec::new();
        for index in closing {
            self.members.joints[*index].closes = true;
            let Some(written) = joints[*index].take() else {
                continue;
            };
            closings.push(Closing {
                name: written.name,
                kind: written.kind,
                carrier: written.carrier,
                carried: written.carried,
                place: written.place,
                pin: written.pin,
                directions: written.directions,
                turned: written.turned,
            });
        }
        (closings, joints)
    }
}
