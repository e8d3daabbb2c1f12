//! How a tensor is serialised: under the word that says its convention,
//! `{ "tensor": { "xx": .. } }`.

use serde::{Deserialize, Serialize};

use super::{InertiaTensor, InvalidInertia};

/// Written as `tensor`, read as either.
#[derive(Serialize, Deserialize)]
#[serde(rename = "InertiaTensor", rename_all = "snake_case")]
pub(super) enum Written {
    Tensor(Entries),
    Products(Entries),
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Entries {
    xx: f64,
    yy: f64,
    zz: f64,
    xy: f64,
    yz: f64,
    zx: f64,
}

impl From<InertiaTensor> for Written {
    fn from(inertia: InertiaTensor) -> Self {
        let [xx, yy, zz] = inertia.moments();
        let [xy, yz, zx] = inertia.off_diagonals();
        Self::Tensor(Entries {
            xx,
            yy,
            zz,
            xy,
            yz,
            zx,
        })
    }
}

impl TryFrom<Written> for InertiaTensor {
    type Error = InvalidInertia;

    fn try_from(written: Written) -> Result<Self, InvalidInertia> {
        match written {
            Written::Tensor(e) => Self::tensor(e.xx, e.yy, e.zz, e.xy, e.yz, e.zx),
            Written::Products(e) => Self::products(e.xx, e.yy, e.zz, e.xy, e.yz, e.zx),
        }
    }
}
