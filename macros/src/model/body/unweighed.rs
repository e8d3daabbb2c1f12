//! Bodies as read with unknown masses, which show how their fields depend on mass.

use std::cell::RefCell;
use std::rc::Rc;

use crate::families::Family;
use crate::model::kinematics::Workspace;
use crate::model::words::Frame;
use crate::symbolic::Id;

use super::load::Load;
use super::substance::Substance;

/// Bodies with a symbol for each mass, in a workspace of their own.
pub struct Unweighed {
    pub work: Workspace,
    pub bodies: Vec<UnweighedBody>,
}

/// They are shared, because a model may be copied.
pub type Shared = Rc<RefCell<Unweighed>>;

/// A body with a symbol for its mass.
pub struct UnweighedBody {
    pub frame: Frame,
    pub mass: Option<Id>,
    /// The distinct entries of its inertia.
    pub inertia: Vec<Id>,
    pub fields: Vec<Load>,
}

impl Unweighed {
    pub fn shared(work: Workspace, bodies: Vec<UnweighedBody>) -> Shared {
        Rc::new(RefCell::new(Self { work, bodies }))
    }
}

impl UnweighedBody {
    pub fn new<'l>(
        (substance, frame): (&Substance, Frame),
        loads: impl Iterator<Item = &'l Load>,
    ) -> Self {
        let fields = loads.filter(|load| load.family == Family::Field);
        Self {
            frame,
            mass: substance.mass,
            inertia: substance.inertia_entries(),
            fields: fields.cloned().collect(),
        }
    }
}
