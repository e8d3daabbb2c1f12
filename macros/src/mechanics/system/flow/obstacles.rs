//! Obstacles to a closed form.

use crate::mechanics::closed_forms::dependence;
use crate::model::{System, TreeJoint, Variable, Workspace};
use crate::symbolic::Id;

use crate::mechanics::system::equations::{SystemEquations, loads};

/// Joints without a closed form, and the reasons.
pub struct Obstacles<'a> {
    pub system: &'a System,
    pub equations: &'a SystemEquations,
    pub work: &'a Workspace,
    /// By number.
    pub failing: Vec<usize>,
}

/// Under constraints.
pub const CLOSED: &str = "where loops are closed or constraints are written there is no closed form in this version: leave \
                          out `flow`, and the motion is integrated";
/// What paths do not support.
pub const CHANGING: &str =
    "no closed form: mass and inertia change; leave out `flow`, and the motion is integrated";

impl Obstacles<'_> {
    /// One for everything that a joint to the ground carries.
    pub fn all(&self) -> Vec<String> {
        let mut roots: Vec<usize> = self.failing.iter().map(|joint| self.root(*joint)).collect();
        roots.sort_unstable();
        roots.dedup();
        let mut all: Vec<String> = roots.into_iter().map(|root| self.of_tree(root)).collect();
        all.dedup();
        all
    }

    fn root(&self, mut joint: usize) -> usize {
        while let Some(carrier) = self.system.joints[joint].carrier {
            joint = carrier;
        }
        joint
    }

    fn of_tree(&self, root: usize) -> String {
        let failing = self.failing.iter().copied();
        let failing: Vec<usize> = failing.filter(|joint| self.root(*joint) == root).collect();
        let found = |joint: &usize| &self.equations.accelerations[*joint][..];
        let accelerations: Vec<Id> = failing.iter().flat_map(found).copied().collect();
        if let Some(load) = self.changing(&accelerations) {
            return load;
        }
        if let Some(gyrostat) = self.gyrostat(root) {
            return gyrostat;
        }
        let names = failing.iter().map(|joint| &self.system.joints[*joint].name);
        let names: Vec<String> = names.map(|name| format!("`{name}`")).collect();
        match &names[..] {
            [name] => {
                let word = dependence(self.work, &accelerations);
                format!("the acceleration of {name} depends on {word}, in a way that has none here")
            }
            names => format!(
                "the accelerations of {} depend on each other",
                names.join(" and ")
            ),
        }
    }

    /// The obstacle for a body in space that carries rotors.
    fn gyrostat(&self, root: usize) -> Option<String> {
        let joints = &self.system.joints;
        let carried = self.system.written.iter().filter(|joint| **joint != root);
        let carried = carried.filter(|joint| self.root(**joint) == root);
        let carried: Vec<&TreeJoint> = carried.map(|joint| &joints[*joint]).collect();
        let has = |joint: &TreeJoint, variable| joint.coordinates.get(variable, 0).is_some();
        let are_rotors = carried.iter().all(|joint| has(joint, Variable::Angle));
        if carried.is_empty() || !are_rotors || !has(&joints[root], Variable::Quaternion) {
            return None;
        }
        let (name, found) = (&joints[root].name, &self.equations.accelerations[root]);
        let angular = &found[found.len().saturating_sub(3)..];
        let is_turned = self.work.depend_on(angular, &[Variable::Quaternion]);
        Some(if is_turned {
            format!(
                "a moment that depends on the attitude acts on the gyrostat that `{name}` carries"
            )
        } else {
            format!(
                "what `{name}` carries is a gyrostat that is not known to be symmetric about one axis, that of all its \
                 rotors and of the moments on it (write equal moments of inertia alike), and other gyrostats turn by \
                 elliptic integrals of the third kind"
            )
        })
    }

    /// The first load that is not constant, of those that affect these accelerations.
    fn changing(&self, accelerations: &[Id]) -> Option<String> {
        let known = self.work.graph.reachable(accelerations, |_| true);
        let loads = loads(self.system, self.work).into_iter();
        let mut changing = loads.filter_map(|(name, parts)| {
            let symbols = self.work.graph.reachable(&parts, |_| true).into_iter();
            let mut late = symbols.filter(|id| !self.work.graph.is_early(*id));
            let acts = late.any(|id| self.work.meaning(id).is_some() && known.contains(&id));
            let word = dependence(self.work, &parts);
            acts.then(|| format!("the load `{name}` depends on {word}, and is not constant"))
        });
        changing.next()
    }
}
