//! The serialized form of a tensor: under the word of its convention,
//! `{ "tensor": { "xx": .. } }`.

use serde::de::Error as _;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use super::InertiaTensor;

/// Written as `tensor`, read as either.
#[derive(Serialize, Deserialize)]
#[serde(
    rename = "InertiaTensor",
    rename_all = "snake_case",
    expecting = "an inertia: `tensor` or `products`"
)]
enum Written {
    Tensor(Entries),
    Products(Entries),
}

#[derive(Serialize, Deserialize)]
#[serde(
    deny_unknown_fields,
    expecting = "the entries `xx`, `yy`, `zz`, `xy`, `yz`, `zx`"
)]
struct Entries {
    xx: f64,
    yy: f64,
    zz: f64,
    xy: f64,
    yz: f64,
    zx: f64,
}

impl Serialize for InertiaTensor {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let [xx, yy, zz] = self.moments();
        let [xy, yz, zx] = self.off_diagonals();
        let entries = Entries {
            xx,
            yy,
            zz,
            xy,
            yz,
            zx,
        };
        Written::Tensor(entries).serialize(serializer)
    }
}

impl<'de> Deserialize<'de> for InertiaTensor {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let inertia = match Written::deserialize(deserializer)? {
            Written::Tensor(e) => Self::tensor(e.xx, e.yy, e.zz, e.xy, e.yz, e.zx),
            Written::Products(e) => Self::products(e.xx, e.yy, e.zz, e.xy, e.yz, e.zx),
        };
        inertia.map_err(D::Error::custom)
    }
}
