//! The smallest description for which a claim fails.

use crate::description::body::{Body, What};
use crate::description::expression::{Place, Scalar};

/// Descriptions that have one thing less.
pub fn smaller(body: &Body) -> Vec<Body> {
    let mut all = Vec::new();
    for index in 0..body.loads.len() {
        // what is refuted may be said of a load by its number
        let mut less = body.clone();
        if matches!(
            less.loads[index].what,
            What::OpenForce(..) | What::OpenMoment(..)
        ) || index + 1 == body.loads.len()
        {
            less.loads.remove(index);
            all.push(less);
            continue;
        }
        less.loads.remove(index);
        all.push(less);
    }
    for constraint in 0..body.constraints.len() {
        for load in 0..body.loads.len() {
            if body.loads[load].is_open() {
                let mut less = body.clone();
                less.constraints.remove(constraint);
                less.loads.remove(load);
                all.push(less);
            }
        }
    }
    let mut less = body.clone();
    if !matches!(body.pole, Place::Center) {
        less.pole = Place::Center;
        all.push(less);
    }
    if let Some(last) = body.locals.len().checked_sub(1) {
        let text = format!("{body:?}");
        if !text.contains(&format!("Local({last})")) {
            let mut less = body.clone();
            less.locals.pop();
            all.push(less);
        }
    }
    if let Some(mass) = &body.mass
        && !matches!(mass, Scalar::Literal(_))
    {
        let mut less = body.clone();
        less.mass = Some(Scalar::literal(2, 0));
        all.push(less);
    }
    all
}
