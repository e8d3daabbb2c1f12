//! The motion of links with zero joint accelerations, as constraints between links need it.

use crate::mechanics::tree::link::{Link, Tree};
use crate::mechanics::tree::turning::Turning;
use crate::model::Labels;
use crate::symbolic::{Components, Graph, Id};

/// The place and the motion of a link, relative to the ground or to a link that carries it, in the
/// axes of that. Its acceleration is that with zero joint accelerations.
#[derive(Clone)]
pub struct Placed {
    pub turning: Turning,
    /// The axis of its rotation and the angle about it, if all joints up to the link rotate about
    /// the same axis, as in the plane.
    angle: Option<(usize, Id)>,
    pub origin: Components,
    pub velocity: Components,
    pub acceleration: Components,
    pub w: Components,
    pub alpha: Components,
}

/// A point that is fixed in a link: its place and its motion.
#[derive(Clone, Copy)]
pub struct Spot {
    pub place: Components,
    pub velocity: Components,
    pub acceleration: Components,
}

impl Placed {
    /// That of the ground or of the link itself.
    pub fn at_rest(graph: &Graph) -> Self {
        let zeros = graph.zeros();
        Self {
            turning: Turning::Parallel,
            angle: None,
            origin: zeros,
            velocity: zeros,
            acceleration: zeros,
            w: zeros,
            alpha: zeros,
        }
    }

    /// The same, seen from its own origin.
    pub fn at_origin(&self, graph: &Graph) -> Self {
        let zeros = graph.zeros();
        Self {
            origin: zeros,
            velocity: zeros,
            acceleration: zeros,
            ..self.clone()
        }
    }

    /// A point at an offset from the origin, in the axes of the link.
    pub fn spot(&self, graph: &mut Graph, offset: Components) -> Spot {
        let arm = self.turning.to_carrier(graph, offset);
        let arm = graph.quantities(arm);
        let swept = graph.cross(self.w, arm);
        let swept = graph.quantities(swept);
        let inwards = graph.cross(self.w, swept);
        let turned = graph.cross(self.alpha, arm);
        let bent = graph.add_vectors(inwards, turned);
        let [place, velocity, acceleration] = [
            graph.add_vectors(self.origin, arm),
            graph.add_vectors(self.velocity, swept),
            graph.add_vectors(self.acceleration, bent),
        ]
        .map(|vector| graph.quantities(vector));
        Spot {
            place,
            velocity,
            acceleration,
        }
    }

    /// Names the place and the motion of a link, seen from an apex.
    pub fn label(
        &self,
        graph: &Graph,
        labels: &mut Labels,
        (tree, link): (&Tree, usize),
        apex: Option<usize>,
    ) {
        let link = &seen_from((tree, link), apex);
        if let (Turning::About { cosine, sine, .. }, Some((_, angle))) = (self.turning, self.angle)
        {
            if apex.is_none() {
                labels.explain([angle], "angle of each body from the ground");
            }
            for (id, name) in [(angle, "angle"), (cosine, "cosine"), (sine, "sine")] {
                labels.name(id, format!("{name}_{link}"));
            }
        }
        if let Turning::By(rows) = &self.turning {
            labels.matrix(&format!("axes_{link}"), rows);
        }
        labels.vector(&format!("place_{link}"), self.origin);
        // about z, the axes make no difference
        let [x, y, _] = self.w;
        let is_about_z = [x, y].into_iter().all(|part| graph.is_zero(part));
        let w = if is_about_z || apex.is_some() {
            "w"
        } else {
            "w_world"
        };
        labels.vector_or_one(w, link, self.w);
        labels.vector_or_one("turning_drift", link, self.alpha);
        labels.vector(&format!("v_{link}"), self.velocity);
        labels.vector(&format!("drift_{link}"), self.acceleration);
    }

    /// A vector of the link, in the axes in which it is placed.
    pub fn to_frame(&self, graph: &mut Graph, vector: Components) -> Components {
        let turned = self.turning.to_carrier(graph, vector);
        graph.quantities(turned)
    }

    /// The motion of a link that this one carries. For a free link, its place and velocity are
    /// `free`.
    pub fn carried(&self, graph: &mut Graph, link: &Link, free: Option<[Components; 2]>) -> Self {
        let spot = self.spot(graph, link.place);
        let (turning, angle) = self.turned(graph, link);
        let mut next = Self {
            turning,
            angle,
            origin: spot.place,
            velocity: spot.velocity,
            acceleration: spot.acceleration,
            w: self.w,
            alpha: self.alpha,
        };
        if let Some([origin, velocity]) = free {
            (next.origin, next.velocity) = (origin, velocity);
        }
        for freedom in &link.freedoms {
            let about = next.to_frame(graph, freedom.twist.angular);
            let turning = graph.scale_vector(freedom.rate, about);
            let swung = graph.cross(self.w, turning);
            next.w = graph.add_vectors(next.w, turning);
            next.alpha = graph.add_vectors(next.alpha, swung);
            if let Some(given) = freedom.given {
                let driven = graph.scale_vector(given, about);
                next.alpha = graph.add_vectors(next.alpha, driven);
            }
            if free.is_some() || graph.is_zero_vector(&freedom.twist.linear) {
                continue;
            }
            let along = next.to_frame(graph, freedom.twist.linear);
            let sliding = graph.scale_vector(freedom.rate, along);
            let twice = graph.add_vectors(sliding, sliding);
            let coriolis = graph.cross(self.w, twice);
            next.velocity = graph.add_vectors(next.velocity, sliding);
            next.acceleration = graph.add_vectors(next.acceleration, coriolis);
            if let Some(given) = freedom.given {
                let driven = graph.scale_vector(given, along);
                next.acceleration = graph.add_vectors(next.acceleration, driven);
            }
        }
        for vector in [
            &mut next.velocity,
            &mut next.acceleration,
            &mut next.w,
            &mut next.alpha,
        ] {
            *vector = graph.quantities(*vector);
        }
        next
    }

    /// The rotation of a link that this one carries. If both are about the same axis, the angles
    /// are added.
    fn turned(&self, graph: &mut Graph, link: &Link) -> (Turning, Option<(usize, Id)>) {
        let own = match (link.turning, link.angle) {
            (Turning::About { axis, .. }, Some(angle)) => Some((axis, angle)),
            _ => None,
        };
        match (self.turning, link.turning) {
            (_, Turning::Parallel) => (self.turning, self.angle),
            (Turning::Parallel, turning) => (turning, own),
            (_, turning) => {
                if let (Some((axis, sum)), Some((other, angle))) = (self.angle, own)
                    && axis == other
                {
                    let sum = graph.add(sum, angle);
                    return (Turning::by_angle(graph, axis, sum), Some((axis, sum)));
                }
                let columns = graph.unit_vectors().map(|unit| {
                    let turned = turning.to_carrier(graph, unit);
                    self.to_frame(graph, turned)
                });
                let rows = [0, 1, 2].map(|i| [0, 1, 2].map(|j| columns[j][i]));
                (Turning::By(rows), None)
            }
        }
    }
}

/// The name of a link as it is seen from an apex, `None` for the ground.
pub fn seen_from((tree, link): (&Tree, usize), apex: Option<usize>) -> String {
    let name = &tree.links[link].name;
    match apex {
        None => name.clone(),
        Some(apex) => format!("{name}_from_{}", tree.links[apex].name),
    }
}

/// The motion of all links in world axes; `free` has the places and velocities of free links, by link.
pub fn place_links(
    (graph, labels): (&mut Graph, &mut Labels),
    tree: &Tree,
    free: impl Fn(usize) -> Option<[Components; 2]>,
) -> Vec<Placed> {
    let ground = Placed::at_rest(graph);
    let mut all: Vec<Placed> = Vec::new();
    for (index, link) in tree.links.iter().enumerate() {
        let carrier = link.carrier.map_or(&ground, |carrier| &all[carrier]);
        let next = carrier.carried(graph, link, free(index));
        if let Some(number) = link.carrier {
            let arm = carrier.to_frame(graph, link.place);
            labels.vector(&format!("arm_{}", tree.links[number].name), arm);
        }
        next.label(graph, labels, (tree, index), None);
        all.push(next);
    }
    all
}
