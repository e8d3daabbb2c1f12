//! The bodies, inputs and first states of the members in the lanes of a register.

use alloc::vec::Vec;
use core::marker::PhantomData;

use crate::bodies::columns::{Columns, Generic};
use crate::ensemble::blocks::{BLOCK, Eight};
use crate::ensemble::plan::Plan;

/// The bodies of the members in the lanes of a register.
pub(super) struct Seats<B: Generic> {
    pub(super) bodies: Vec<Eight>,
    pub(super) inputs: Vec<Eight>,
    pub(super) states: Vec<Eight>,
    kind: PhantomData<B>,
}

impl<B: Generic> Seats<B> {
    /// The first member in all lanes, so that every lane has a body.
    pub(super) fn new<A>(plan: &Plan<'_, A, B>, states: &[Eight]) -> Self {
        let bodies = if plan.members.is_uniform {
            0
        } else {
            plan.first
        };
        let rows = |rows: Option<&[Eight]>| rows.unwrap_or_default().to_vec();
        Self {
            bodies: rows(plan.members.bodies.block(bodies)),
            inputs: rows(plan.members.inputs.block(plan.first)),
            states: states[..<B::State as Columns<f64>>::COUNT].to_vec(),
            kind: PhantomData,
        }
    }

    /// Puts a member into a lane.
    pub(super) fn sit<A>(
        &mut self,
        plan: &Plan<'_, A, B>,
        states: &[Eight],
        member: usize,
        lane: usize,
    ) {
        let (block, from) = (member / BLOCK, member % BLOCK);
        let copy = |seats: &mut [Eight], rows: Option<&[Eight]>| {
            for (seat, row) in seats.iter_mut().zip(rows.unwrap_or_default()) {
                seat[lane] = row[from];
            }
        };
        if !plan.members.is_uniform {
            copy(
                &mut self.bodies,
                plan.members.bodies.block(plan.first + block),
            );
        }
        copy(
            &mut self.inputs,
            plan.members.inputs.block(plan.first + block),
        );
        let columns = <B::State as Columns<f64>>::COUNT;
        copy(
            &mut self.states,
            states.get(columns * block..columns * (block + 1)),
        );
    }
}
