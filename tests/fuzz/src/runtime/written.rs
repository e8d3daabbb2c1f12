//! Values as text and as bytes, intact and damaged.

use core::fmt::Debug;

use fastrand::Rng;
use serde::{Serialize, de::DeserializeOwned};

/// Reads a value back from JSON and from bytes: the same bits, by the digits of `{:?}`.
pub fn assert_round_trip<T: Serialize + DeserializeOwned + Debug>(value: &T) {
    let text = serde_json::to_string(value).expect("a value that can be written");
    let back: T = serde_json::from_str(&text).unwrap_or_else(|error| panic!("{error}: {text}"));
    assert_eq!(format!("{back:?}"), format!("{value:?}"), "through {text}");
    let bytes = postcard::to_allocvec(value).expect("a value that can be written");
    let back: T = postcard::from_bytes(&bytes).unwrap_or_else(|error| panic!("{error}: {value:?}"));
    assert_eq!(format!("{back:?}"), format!("{value:?}"), "through bytes");
}

/// Reads what is left of a written value after some damage: whatever is still accepted is a value of its type.
pub fn read_damaged<T: Serialize + DeserializeOwned + Debug>(
    value: &T,
    check: fn(&T),
    rng: &mut Rng,
) {
    let text = serde_json::to_string(value).expect("a value that can be written");
    let text = damaged(text.into_bytes(), rng, |rng| TEXT[rng.usize(..TEXT.len())]);
    if let Ok(read) = serde_json::from_slice::<T>(&text) {
        check(&read);
        assert_round_trip(&read);
    }
    let bytes = postcard::to_allocvec(value).expect("a value that can be written");
    let bytes = damaged(bytes, rng, |rng| rng.u8(..));
    if let Ok(read) = postcard::from_bytes::<T>(&bytes) {
        check(&read);
        assert_round_trip(&read);
    }
}

const TEXT: &[u8] = b"0123456789.eE+-{}[]\":, nulltraxyzw\\u\x00\xFF";

/// A few bytes changed, left out, put in or repeated.
fn damaged(mut bytes: Vec<u8>, rng: &mut Rng, byte: impl Fn(&mut Rng) -> u8) -> Vec<u8> {
    for _ in 0..=rng.usize(..3) {
        if bytes.is_empty() {
            break;
        }
        let place = rng.usize(..bytes.len());
        match rng.u8(..4) {
            0 => {
                bytes.remove(place);
            }
            1 => bytes.insert(place, byte(rng)),
            2 => {
                let repeated = bytes[place..].to_vec();
                bytes.splice(place..place, repeated.into_iter().take(1 + rng.usize(..8)));
            }
            _ => bytes[place] = byte(rng),
        }
    }
    bytes
}
