//! Another reader of such files, in doubles, and Newton's and Euler's laws for what it reads: with
//! the accelerations of the described system, no joint is loaded along its freedom.

use std::collections::HashMap;
use std::fs;

use nalgebra::{Matrix3, Rotation3, Unit, Vector3};

type Vec3 = Vector3<f64>;

struct Link {
    mass: f64,
    center: Vec3,
    /// About G, in the axes of the link.
    inertia: Matrix3<f64>,
}

struct Joint {
    name: String,
    kind: String,
    parent: usize,
    child: usize,
    turned: Rotation3<f64>,
    place: Vec3,
    axis: Vec3,
}

/// A force on a link, world axes: the link, where in the world, and the force.
pub type Push = (String, Vec3, Vec3);

pub struct Robot {
    names: Vec<String>,
    links: Vec<Link>,
    joints: Vec<Joint>,
}

/// A coordinate, its rate and its acceleration.
pub type Rates = [f64; 3];

/// How the origin of a link moves, world axes.
#[derive(Clone, Copy)]
pub struct Moving {
    pub axes: Rotation3<f64>,
    pub place: Vec3,
    pub w: Vec3,
    pub v: Vec3,
    pub turning: Vec3,
    pub a: Vec3,
}

impl Moving {
    pub fn ground() -> Self {
        let zero = Vec3::zeros();
        Self {
            axes: Rotation3::identity(),
            place: zero,
            w: zero,
            v: zero,
            turning: zero,
            a: zero,
        }
    }
}

fn three(node: Option<roxmltree::Node<'_, '_>>, name: &str) -> Vec3 {
    let text = node
        .and_then(|node| node.attribute(name))
        .unwrap_or("0 0 0");
    let all: Vec<f64> = text
        .split_whitespace()
        .map(|one| one.parse().unwrap())
        .collect();
    Vec3::new(all[0], all[1], all[2])
}

fn rotation(node: Option<roxmltree::Node<'_, '_>>) -> Rotation3<f64> {
    let rpy = three(node, "rpy");
    // the file says right angles with few digits
    let right = |angle: f64| {
        let count = (angle / std::f64::consts::FRAC_PI_2).round();
        let right = count * std::f64::consts::FRAC_PI_2;
        if (angle - right).abs() < 1e-7 {
            right
        } else {
            angle
        }
    };
    Rotation3::from_euler_angles(right(rpy.x), right(rpy.y), right(rpy.z))
}

impl Robot {
    pub fn read(path: &str) -> Self {
        let text = fs::read_to_string(path).unwrap();
        let document = roxmltree::Document::parse(&text).unwrap();
        let child = |node: roxmltree::Node<'_, '_>, tag: &str| {
            node.children()
                .find(|child| child.has_tag_name(tag))
                .map(|child| child.id())
        };
        let get = |node, tag| child(node, tag).and_then(|id| document.get_node(id));
        let root = document.root_element();
        let (mut links, mut joints, mut names) = (Vec::new(), Vec::new(), Vec::new());
        for node in root.children().filter(|node| node.has_tag_name("link")) {
            names.push(node.attribute("name").unwrap());
            let number = |node: roxmltree::Node<'_, '_>, name| -> f64 {
                node.attribute(name).unwrap().parse().unwrap()
            };
            links.push(match get(node, "inertial") {
                None => Link {
                    mass: 0.0,
                    center: Vec3::zeros(),
                    inertia: Matrix3::zeros(),
                },
                Some(inertial) => {
                    let inertia = get(inertial, "inertia").unwrap();
                    let [xx, yy, zz, xy, yz, xz] = ["ixx", "iyy", "izz", "ixy", "iyz", "ixz"]
                        .map(|name| number(inertia, name));
                    let own = Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz);
                    let turned = rotation(get(inertial, "origin"));
                    Link {
                        mass: number(get(inertial, "mass").unwrap(), "value"),
                        center: three(get(inertial, "origin"), "xyz"),
                        inertia: turned * own * turned.transpose(),
                    }
                }
            });
        }
        for node in root.children().filter(|node| node.has_tag_name("joint")) {
            let end = |tag| {
                let name = get(node, tag).unwrap().attribute("link").unwrap();
                names.iter().position(|other| *other == name).unwrap()
            };
            let axis = get(node, "axis").map_or(Vec3::x(), |axis| three(Some(axis), "xyz"));
            joints.push(Joint {
                name: node.attribute("name").unwrap().to_owned(),
                kind: node.attribute("type").unwrap().to_owned(),
                parent: end("parent"),
                child: end("child"),
                turned: rotation(get(node, "origin")),
                place: three(get(node, "origin"), "xyz"),
                axis: axis.normalize(),
            });
        }
        let names = names.into_iter().map(str::to_owned).collect();
        Self {
            names,
            links,
            joints,
        }
    }

    fn root(&self) -> usize {
        let is_root = |link: &usize| self.joints.iter().all(|joint| joint.child != *link);
        (0..self.links.len()).find(is_root).unwrap()
    }

    /// Puts a ball on a link, at a point in the axes of that.
    pub fn add_ball(&mut self, on: &str, place: Vec3, mass: f64, radius: f64) {
        let number = self.number(on);
        let link = &mut self.links[number];
        let whole = link.mass + mass;
        let center = (link.mass * link.center + mass * place) / whole;
        let ball = Matrix3::identity() * (0.4 * mass * radius * radius);
        let moved = |mass: f64, from: Vec3| {
            let r = from - center;
            mass * (Matrix3::identity() * r.norm_squared() - r * r.transpose())
        };
        link.inertia += ball + moved(link.mass, link.center) + moved(mass, place);
        (link.mass, link.center) = (whole, center);
    }

    /// Gives mass to a link that has none, about its origin.
    pub fn give(&mut self, name: &str, mass: f64, inertia: Matrix3<f64>) {
        let number = self.number(name);
        self.links[number].mass = mass;
        self.links[number].inertia = inertia;
    }

    pub fn number(&self, name: &str) -> usize {
        self.names.iter().position(|other| other == name).unwrap()
    }

    /// The motion of every link.
    pub fn motions(&self, base: Moving, rates: &HashMap<&str, Rates>) -> Vec<Moving> {
        let mut all: Vec<Option<Moving>> = vec![None; self.links.len()];
        all[self.root()] = Some(base);
        while all.iter().any(Option::is_none) {
            for joint in &self.joints {
                if let (Some(from), None) = (all[joint.parent], all[joint.child]) {
                    let rates = rates.get(joint.name.as_str()).copied().unwrap_or_default();
                    all[joint.child] = Some(joint.motion(&from, rates));
                }
            }
        }
        all.into_iter().flatten().collect()
    }

    /// The load along each joint that moves, and along all that a free base may do, each beside the
    /// sizes of what it is a sum of.
    pub fn loads(
        &self,
        base: Moving,
        is_free: bool,
        rates: &HashMap<&str, Rates>,
        (gravity, pushes): (Vec3, &[Push]),
    ) -> Vec<(f64, f64)> {
        let motions = self.motions(base, rates);
        let about = |at: Vec3, included: &dyn Fn(usize) -> bool| {
            let (mut sums, mut sizes) = ([Vec3::zeros(); 2], [0.0; 2]);
            for (number, (link, moving)) in self.links.iter().zip(&motions).enumerate() {
                if !included(number) {
                    continue;
                }
                let arm = moving.axes * link.center;
                let (w, turning) = (moving.w, moving.turning);
                let a = moving.a + turning.cross(&arm) + w.cross(&w.cross(&arm));
                let force = link.mass * (a - gravity);
                let inertia = moving.axes * link.inertia * moving.axes.transpose();
                let own = inertia * turning + w.cross(&(inertia * w));
                let lever = (moving.place + arm - at).cross(&force);
                sums[0] += force;
                sums[1] += own + lever;
                sizes[0] += force.norm();
                sizes[1] += own.norm() + lever.norm();
            }
            for (name, place, force) in pushes {
                if included(self.number(name)) {
                    let lever = (place - at).cross(force);
                    sums[0] -= force;
                    sums[1] -= lever;
                    sizes[0] += force.norm();
                    sizes[1] += lever.norm();
                }
            }
            (sums, sizes)
        };
        let mut loads = Vec::new();
        for joint in &self.joints {
            if !rates.contains_key(joint.name.as_str()) {
                continue;
            }
            let (axes, at) = (motions[joint.child].axes, motions[joint.child].place);
            let (sums, sizes) = about(at, &|link| self.is_above(joint.child, link));
            let which = usize::from(joint.kind != "prismatic");
            loads.push(((axes * joint.axis).dot(&sums[which]), sizes[which]));
        }
        if is_free {
            let (sums, sizes) = about(base.place, &|_| true);
            for (sum, size) in sums.iter().zip(sizes) {
                loads.extend(sum.iter().map(|part| (*part, size)));
            }
        }
        loads
    }

    /// Whether a link carries another, or is it.
    fn is_above(&self, above: usize, link: usize) -> bool {
        let mut link = link;
        loop {
            if link == above {
                return true;
            }
            match self.joints.iter().find(|joint| joint.child == link) {
                Some(joint) => link = joint.parent,
                None => return false,
            }
        }
    }
}

impl Joint {
    fn motion(&self, from: &Moving, [q, rate, second]: Rates) -> Moving {
        let slides = self.kind == "prismatic";
        let axis = Unit::new_normalize(self.axis);
        let still = from.axes * self.turned;
        let along = still * self.axis;
        let turned = if slides {
            still
        } else {
            still * Rotation3::from_axis_angle(&axis, q)
        };
        let slid = if slides { along * q } else { Vec3::zeros() };
        let arm = from.axes * self.place + slid;
        let mut to = Moving {
            axes: turned,
            place: from.place + arm,
            w: from.w,
            v: from.v + from.w.cross(&arm),
            turning: from.turning,
            a: from.a + from.turning.cross(&arm) + from.w.cross(&from.w.cross(&arm)),
        };
        if slides {
            to.v += along * rate;
            to.a += 2.0 * from.w.cross(&(along * rate)) + along * second;
        } else {
            to.w += along * rate;
            to.turning += along * second + from.w.cross(&(along * rate));
        }
        to
    }
}
