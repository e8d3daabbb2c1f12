//! What prevents a closed form.

use crate::mechanics::answers::parts;
use crate::mechanics::closed_forms::dependence;
use crate::mechanics::proofs::all_vanish;
use crate::mechanics::tree::{SpatialVector, along_freedoms, wrench};
use crate::model::{System, TreeJoint, Variable, Workspace};
use crate::symbolic::Id;

use crate::mechanics::system::equations::SystemEquations;

/// The joints without a closed form, and why they have none.
pub struct Obstacles<'a> {
    pub system: &'a System,
    pub equations: &'a SystemEquations,
    pub work: &'a mut Workspace,
    /// The indices of these joints.
    pub failing: Vec<usize>,
}

/// The obstacle for a system under constraints.
pub const CLOSED: &str = "where loops are closed or constraints are written there is no closed form in this version: leave \
                          out `flow`, and the motion is integrated";
/// The obstacle for a system whose mass or inertia changes.
pub const CHANGING: &str =
    "no closed form: mass and inertia change; leave out `flow`, and the motion is integrated";

impl Obstacles<'_> {
    /// One obstacle for everything that one joint to the ground carries.
    pub fn all(&mut self) -> Vec<String> {
        let roots = self.failing.iter().map(|joint| self.system.root(*joint));
        let mut roots: Vec<usize> = roots.collect();
        roots.sort_unstable();
        roots.dedup();
        let mut all: Vec<String> = roots.into_iter().map(|root| self.of_tree(root)).collect();
        all.dedup();
        all
    }

    fn of_tree(&mut self, root: usize) -> String {
        let failing = self.failing.iter().copied();
        let failing: Vec<usize> = failing
            .filter(|joint| self.system.root(*joint) == root)
            .collect();
        let found = |joint: &usize| &self.equations.accelerations[*joint][..];
        let accelerations: Vec<Id> = failing.iter().flat_map(found).copied().collect();
        if let Some(load) = self.changing(root, &accelerations) {
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
        let carried = carried.filter(|joint| self.system.root(**joint) == root);
        let carried: Vec<&TreeJoint> = carried.map(|joint| &joints[*joint]).collect();
        let has = |joint: &TreeJoint, variable| joint.coordinates.get(variable, 0).is_some();
        let are_rotors = carried.iter().all(|joint| self.is_rotor(root, joint));
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

    /// Whether the rotation of a joint has no effect on its carrier.
    fn is_rotor(&self, root: usize, joint: &TreeJoint) -> bool {
        let (graph, found) = (&self.work.graph, &self.equations.accelerations[root]);
        let angle = joint.coordinates.get(Variable::Angle, 0);
        angle.is_some_and(|angle| !graph.depends_on(found, |id| id == angle))
    }

    /// The first of the loads that contribute to these accelerations and are not constant.
    fn changing(&mut self, root: usize, accelerations: &[Id]) -> Option<String> {
        let loads = self.acting(root);
        let graph = &self.work.graph;
        let known = graph.nodes_of(accelerations);
        loads.into_iter().find_map(|(name, parts)| {
            let symbols = graph.nodes_of(&parts).into_iter();
            let mut late = symbols.filter(|id| !graph.is_early(*id));
            let acts = late.any(|id| self.work.meaning(id).is_some() && known.contains(&id));
            let word = dependence(self.work, &parts);
            acts.then(|| format!("the load `{name}` depends on {word}, and is not constant"))
        })
    }

    /// The loads and drives along coordinates of the bodies that a joint to the ground carries.
    fn acting(&mut self, root: usize) -> Vec<(String, Vec<Id>)> {
        let (mut acting, mut driving) = (Vec::new(), Vec::new());
        let (system, built) = (self.system, &self.equations.built);
        for (number, (body, joint)) in system.bodies.iter().zip(&system.joints).enumerate() {
            if system.root(number) != root {
                continue;
            }
            for load in &body.loads {
                let (linear, angular) = wrench(self.work, body, [load], joint.pin);
                let load_here = SpatialVector { angular, linear };
                let graph = &mut self.work.graph;
                let along = along_freedoms(graph, &built.tree, built.body(number), load_here);
                if !all_vanish(self.work, &along) {
                    acting.push(parts(load, self.work));
                }
            }
            let drives = joint.driven_by.iter();
            driving.extend(drives.map(|(name, parts)| (name.to_string(), parts.clone())));
        }
        acting.extend(driving);
        acting
    }
}
