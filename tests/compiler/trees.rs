//! Trees of bodies: accelerations compared with references of 20 digits, and the operations that
//! they take.

use serde_json::Value;

use mounted::mechanics::tree::link::{Freedom, Link, Tree};
use mounted::mechanics::tree::properties::Properties;
use mounted::mechanics::tree::spatial::SpatialVector;
use mounted::mechanics::tree::turning::Turning;
use mounted::mechanics::tree::{LinkMotion, SpatialInertia, derive_tree, lacking};
use mounted::model::Labels;
use mounted::symbolic::{Components, Graph, Id, Number, Stage};

/// A tree of a reference, and the values of its symbols.
struct Reference {
    graph: Graph,
    tree: Tree,
    values: Vec<(Id, f64)>,
    expected: Vec<f64>,
    /// Of the axes of free links, as the reference has them.
    attitude: Vec<f64>,
}

fn number(value: &Value) -> f64 {
    match value {
        Value::String(digits) => digits.parse().unwrap(),
        other => other.as_f64().unwrap(),
    }
}

fn list(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(number).collect()
}

impl Reference {
    fn read(text: &str) -> Self {
        let file: Value = serde_json::from_str(text).unwrap();
        let system = &file["system"];
        let mut reference = Self {
            graph: Graph::default(),
            tree: Tree {
                links: Vec::new(),
                gravity: Graph::default().zeros(),
            },
            values: Vec::new(),
            expected: list(&file["acceleration"]),
            attitude: Vec::new(),
        };
        reference.tree.gravity = reference.constants(&system["gravity"]);
        let (mut q, mut v, mut drives) = (
            list(&file["q"]).into_iter(),
            list(&file["v"]).into_iter(),
            list(&file["drives"]).into_iter(),
        );
        // links of the joints of the reference
        let mut links = Vec::new();
        for joint in system["joints"].as_array().unwrap() {
            let parent = joint["parent"].as_i64().unwrap();
            let carrier = usize::try_from(parent)
                .ok()
                .map(|index: usize| links[index]);
            let index = reference.joint(joint, carrier, &mut q, &mut v, &mut drives);
            links.push(index);
        }
        reference
    }

    fn exact(&mut self, value: &Value) -> Id {
        let text = match value {
            Value::String(digits) => digits.clone(),
            other => other.to_string(),
        };
        let (sign, digits) = match text.strip_prefix('-') {
            Some(digits) => (true, digits.to_owned()),
            None => (false, text),
        };
        let number = Number::parse(&digits).unwrap();
        self.graph.number(if sign { -number } else { number })
    }

    fn constants(&mut self, value: &Value) -> Components {
        let entries = value.as_array().unwrap();
        [0, 1, 2].map(|axis| self.exact(&entries[axis]))
    }

    fn symbol(&mut self, value: f64) -> Id {
        let id = self.graph.symbol(Stage::State);
        self.values.push((id, value));
        id
    }

    fn joint(
        &mut self,
        joint: &Value,
        carrier: Option<usize>,
        q: &mut impl Iterator<Item = f64>,
        v: &mut impl Iterator<Item = f64>,
        drives: &mut impl Iterator<Item = f64>,
    ) -> usize {
        let kind = joint["type"].as_str().unwrap();
        let units = self.graph.unit_vectors();
        let axis = |letter: Option<char>| "XYZ".find(letter.unwrap()).unwrap();
        let place = self.constants(&joint["p"]);
        let rows = joint["R"].as_array().unwrap();
        let rows = [0, 1, 2].map(|row| self.constants(&rows[row]));
        let is_unit = rows == units;
        let zeros = self.graph.zeros();
        let carrier = if is_unit {
            carrier
        } else {
            self.tree.links.push(Link {
                name: "frame".to_owned(),
                carrier,
                place,
                turning: Turning::By(rows),
                angle: None,
                freedoms: Vec::new(),
                is_free: false,
                falls: false,
                properties: Properties::none(&self.graph),
                added: SpatialInertia::none(&self.graph),
                force: zeros,
                moment: zeros,
            });
            Some(self.tree.links.len() - 1)
        };
        let mut place = if is_unit { place } else { zeros };
        let mut freedoms = Vec::new();
        let mut turning = Turning::Parallel;
        let mut hinge = None;
        let mut twists = Vec::new();
        match kind {
            "Spherical" | "FreeFlyer" => {
                if kind == "FreeFlyer" {
                    let _: Vec<f64> = q.take(3).collect();
                    twists.extend(units.map(|unit| SpatialVector::along(&self.graph, unit)));
                }
                let parts: Vec<f64> = q.take(4).collect();
                let ids: Vec<Id> = parts.iter().map(|part| self.symbol(*part)).collect();
                turning = Turning::quaternion(&mut self.graph, ids[3], [ids[0], ids[1], ids[2]]);
                self.attitude = parts;
                twists.extend(units.map(|unit| SpatialVector::about(&self.graph, unit)));
            }
            _ if kind.starts_with('R') => {
                let axis = axis(kind.chars().nth(1));
                let angle = self.symbol(q.next().unwrap());
                turning = Turning::by_angle(&mut self.graph, axis, angle);
                hinge = Some(angle);
                twists.push(SpatialVector::about(&self.graph, units[axis]));
            }
            _ => {
                let axis = axis(kind.chars().nth(1));
                let position = self.symbol(q.next().unwrap());
                let slid = self.graph.scale_vector(position, units[axis]);
                place = self.graph.add_vectors(place, slid);
                twists.push(SpatialVector::along(&self.graph, units[axis]));
            }
        }
        for twist in twists {
            let (rate, drive) = (v.next().unwrap(), drives.next().unwrap());
            let rate = self.symbol(rate);
            let drive = if drive == 0.0 {
                self.graph.zero()
            } else {
                self.symbol(drive)
            };
            freedoms.push(Freedom {
                given: None,
                twist,
                rate,
                armature: self.graph.zero(),
                drive,
                name: "freedom".to_owned(),
                joint: String::new(),
            });
        }
        let body = &joint["inertia"];
        let mass = self.exact(&body["m"]);
        let center = self.constants(&body["c"]);
        let inertia = body["Ic"].as_array().unwrap();
        let inertia = [0, 1, 2].map(|row| self.constants(&inertia[row]));
        let properties = Properties::of_body(&mut self.graph, mass, center, &inertia);
        let name = joint["name"].as_str().unwrap().to_owned();
        self.tree.links.push(Link {
            name,
            carrier,
            place,
            turning,
            angle: hinge,
            freedoms,
            is_free: kind == "FreeFlyer",
            falls: kind == "FreeFlyer",
            properties,
            added: SpatialInertia::none(&self.graph),
            force: zeros,
            moment: zeros,
        });
        self.tree.links.len() - 1
    }
}

/// The tree with half of the inertia of each body added to the other half, and with loads for the
/// motion that this half has without accelerations of the joints.
fn halved(reference: &mut Reference) -> Tree {
    let (graph, tree) = (&mut reference.graph, &mut reference.tree);
    let half = graph.number(Number::ratio(1, 2));
    let ground = LinkMotion::ground(graph, tree.gravity);
    let mut motions: Vec<LinkMotion> = Vec::new();
    let mut halved = tree.clone();
    for link in &mut halved.links {
        let carrier = link.carrier.map_or(ground, |carrier| motions[carrier]);
        let motion = carrier.carried(graph, link);
        motions.push(motion);
        let whole = link.properties;
        link.properties = Properties {
            mass: graph.multiply(half, whole.mass),
            first: graph.scale_vector(half, whole.first),
            inertia: whole.inertia.map(|row| graph.scale_vector(half, row)),
        };
        link.added = SpatialInertia::of(graph, link);
        let taken = motion.taken_by(graph, &link.properties);
        link.force = graph.subtract_vectors(link.force, taken.linear);
        link.moment = graph.subtract_vectors(link.moment, taken.angular);
    }
    halved
}

fn check(name: &str, text: &str, bound: u32) {
    let mut reference = Reference::read(text);
    let tree = reference.tree.clone();
    check_tree(name, &mut reference, &tree, bound);
    let tree = halved(&mut reference);
    check_tree(&format!("{name}, halved"), &mut reference, &tree, 4 * bound);
}

fn check_tree(name: &str, reference: &mut Reference, tree: &Tree, bound: u32) {
    let found = derive_tree(&mut reference.graph, &mut Labels::default(), tree).accelerations;
    let roots: Vec<Id> = found.concat();
    let cost = reference.graph.late_cost(&roots);
    let values = &reference.values;
    let value = |id: Id| values.iter().find(|(symbol, _)| *symbol == id).unwrap().1;
    let computed = reference.graph.evaluate(&roots, value);
    let scale = reference
        .expected
        .iter()
        .fold(0.0_f64, |most, a| most.max(a.abs()));
    for (found, expected) in computed.iter().zip(&reference.expected) {
        if !reference.tree.links[0].is_free {
            assert!(
                (found - expected).abs() < 1e-13 * scale,
                "{name}: {found} {expected}"
            );
        }
    }
    println!("{name}: {cost:?}");
    assert!(cost.total() - cost.trig <= bound, "{name}: {cost:?}");
}

/// What drives the freedoms of a tree that moves as in a reference, and its operations.
fn check_drives(name: &str, text: &str, bound: u32) {
    let mut reference = Reference::read(text);
    let given = reference.tree.clone();
    let solved = derive_tree(&mut reference.graph, &mut Labels::default(), &given);
    let mut tree = solved.reduced;
    let drives = tree.links.iter().flat_map(Link::open);
    let drives: Vec<Id> = drives.map(|freedom| freedom.drive).collect();
    let zero = reference.graph.zero();
    let freedoms = tree.links.iter_mut().flat_map(|link| &mut link.freedoms);
    freedoms.for_each(|freedom| freedom.drive = zero);
    let mut known = reference.expected.clone().into_iter();
    let accelerations = tree.links.iter().map(|link| {
        let known = known.by_ref().take(link.open().count());
        known.map(|known| reference.symbol(known)).collect()
    });
    let accelerations: Vec<Vec<Id>> = accelerations.collect();
    let work = (&mut reference.graph, &mut Labels::default());
    let found = lacking(work, &tree, &accelerations);
    let (found, _) = reference.graph.folded(&found);
    let cost = reference.graph.late_cost(&found);
    let values = &reference.values;
    let value = |id: Id| values.iter().find(|(symbol, _)| *symbol == id).unwrap().1;
    // of a free base the reference has the accelerations in other axes
    if !reference.tree.links[0].is_free {
        let [found, drives] = [found, drives].map(|ids| reference.graph.evaluate(&ids, value));
        let scale = reference
            .expected
            .iter()
            .fold(1.0_f64, |most, a| most.max(a.abs()));
        for (found, drive) in found.iter().zip(drives) {
            let off = (found - drive).abs();
            assert!(off < 1e-12 * scale, "{name}: {found} {drive}");
        }
    }
    println!("{name}: {cost:?}");
    assert!(cost.total() - cost.trig <= bound, "{name}: {cost:?}");
}

#[test]
fn accelerations_are_those_of_the_references() {
    check(
        "double pendulum",
        include_str!("../reference/systems/double_pendulum.json"),
        32,
    );
    check(
        "cart and pole",
        include_str!("../reference/systems/cart_pole.json"),
        17,
    );
    check(
        "furuta",
        include_str!("../reference/systems/furuta.json"),
        34,
    );
    check(
        "ball double",
        include_str!("../reference/systems/ball_double.json"),
        224,
    );
    check(
        "satellite",
        include_str!("../reference/systems/satellite3w.json"),
        149,
    );
    check("ur5", include_str!("../reference/systems/ur5.json"), 478);
}

/// Inverse dynamics; of the satellite, 30 operations turn the acceleration of the base, and the load on it is in its axes.
#[test]
fn drives_are_those_of_the_references() {
    check_drives(
        "double pendulum",
        include_str!("../reference/systems/double_pendulum.json"),
        27,
    );
    check_drives(
        "cart and pole",
        include_str!("../reference/systems/cart_pole.json"),
        14,
    );
    check_drives(
        "furuta",
        include_str!("../reference/systems/furuta.json"),
        34,
    );
    check_drives(
        "ball double",
        include_str!("../reference/systems/ball_double.json"),
        181,
    );
    check_drives(
        "satellite",
        include_str!("../reference/systems/satellite3w.json"),
        120,
    );
    check_drives("ur5", include_str!("../reference/systems/ur5.json"), 263);
}
