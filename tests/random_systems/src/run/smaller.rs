//! The smallest description that fails in the same way.

use super::{Plan, failure, kind};
use crate::check::compiled::Compiled;
use crate::draw::{Extent, drawn};

/// The smallest description that fails in the same way.
pub fn smaller(plan: &Plan, index: usize, first: String) -> (String, String) {
    let mut extent = plan.extent;
    let (mut text, mut found) = (drawn(plan.seed, index, extent).text, first);
    loop {
        let mut less: Vec<Extent> = (1..extent.bodies)
            .map(|bodies| Extent { bodies, ..extent })
            .collect();
        less.extend([
            Extent {
                without: u64::MAX,
                ..extent
            },
            Extent { loops: 0, ..extent },
            Extent { loops: 1, ..extent },
            Extent {
                copies: false,
                ..extent
            },
            Extent {
                locals: false,
                ..extent
            },
            Extent {
                armatures: false,
                ..extent
            },
            Extent {
                following: false,
                ..extent
            },
            Extent {
                states: false,
                ..extent
            },
            Extent {
                ties: false,
                ..extent
            },
            Extent {
                linearized: false,
                ..extent
            },
            Extent {
                turned: false,
                ..extent
            },
            Extent {
                driven: false,
                ..extent
            },
            Extent {
                params: false,
                ..extent
            },
            Extent {
                pins: false,
                ..extent
            },
            Extent {
                places: false,
                ..extent
            },
            Extent {
                tensors: false,
                ..extent
            },
        ]);
        less.extend((0..40).map(|load| Extent {
            without: extent.without | 1 << load,
            ..extent
        }));
        let next = less.into_iter().find_map(|less| {
            let drawn = drawn(plan.seed, index, less);
            if drawn.text.len() >= text.len() {
                return None;
            }
            let compiled = Compiled::new(&drawn.text).ok()?;
            let failure = failure(&drawn, &compiled, plan, index)?;
            (kind(&failure) == kind(&found)).then_some((less, drawn.text, failure))
        });
        match next {
            Some((less, smaller, failure)) => (extent, text, found) = (less, smaller, failure),
            None => return (text, found),
        }
    }
}
