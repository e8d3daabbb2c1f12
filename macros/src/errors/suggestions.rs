//! Suggestions for unknown words: a similar word, or the word for the same thing in other tools.

/// The word in `known` that was probably meant by `name`.
pub fn similar<'a>(name: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    // a name of one letter would be similar to every other letter
    let length = name.chars().count();
    let tolerated = match length {
        0 | 1 => 0,
        2..=5 => 1,
        _ => 1 + length / 5,
    };
    let is_cased =
        |known: &str| known.len() > 1 && known != name && known.eq_ignore_ascii_case(name);
    let is_as_long = |known: &&str| known.chars().count().abs_diff(length) <= tolerated;
    let near = known.into_iter().filter(is_as_long);
    near.map(|known| (distance(name, known), known))
        .filter(|(distance, known)| {
            (1..=tolerated).contains(distance) && known.len() > 1 || is_cased(known)
        })
        .min_by_key(|(distance, _)| *distance)
        .map(|(_, known)| known)
}

/// Each row lists words for one kind of joint: those used here, in files, and in other tools.
const JOINTS: [&[&str]; 10] = [
    &[
        "revolute",
        "hinge",
        "pin",
        "fixed_axis",
        "continuous",
        "rotary",
        "rotational",
    ],
    &["prismatic", "slide", "slider", "sliding", "linear"],
    &[
        "spherical",
        "ball",
        "ball_joint",
        "ball_and_socket",
        "fixed_point",
        "pivot",
    ],
    &["weld", "fixed", "rigid"],
    &[
        "free",
        "floating",
        "free_joint",
        "freejoint",
        "six_dof",
        "spatial",
    ],
    &["universal", "cardan", "hooke"],
    &["screw", "helical"],
    &["pin_in_slot", "slot", "pin_slot"],
    &["planar", "plane"],
    &["cylindrical", "cylinder", "pin_in_slot"],
];

/// Whether a word is a kind of joint, here or in other tools.
pub fn is_joint(word: &str) -> bool {
    JOINTS.iter().any(|row| row.contains(&word))
}

/// The known kind of joint that a word means in other tools.
fn joint_meant<'a>(word: &str, known: &[&'a str]) -> Option<&'a str> {
    let word = word.to_lowercase();
    let mut rows = JOINTS.iter().filter(|row| row.contains(&word.as_str()));
    rows.find_map(|row| known.iter().copied().find(|known| row.contains(known)))
}

/// `; did you mean ...?` for kinds of joints, or nothing.
pub fn hint_of_joint(word: &str, known: &[&str]) -> String {
    let meant = joint_meant(word, known).or_else(|| similar(word, known.iter().copied()));
    meant.map_or_else(String::new, |known| format!("; did you mean `{known}`?"))
}

/// `; did you mean ...?` for motions, by the joints that move a body so, or nothing.
pub fn hint_of_motion<'a>(word: &str, known: impl Iterator<Item = &'a str> + Clone) -> String {
    let meant = MOTIONS.iter().find(|row| row.contains(&word));
    let meant = meant.and_then(|row| known.clone().find(|known| row.contains(known)));
    let meant = meant.or_else(|| similar(word, known));
    meant.map_or_else(String::new, |known| format!("; did you mean `{known}`?"))
}

/// Each row lists words for one motion of a body: that used here, and those of other tools.
const MOTIONS: [&[&str]; 5] = [
    &[
        "spatial",
        "free",
        "floating",
        "freejoint",
        "six_dof",
        "rigid",
    ],
    &["planar", "plane", "flat"],
    &["pivot", "hinge", "pendulum"],
    &["fixed_axis", "revolute", "pin"],
    &["fixed_point", "spherical", "ball"],
];

/// Words of other tools, each with the word for the same thing here.
type Elsewhere = [(&'static str, &'static str)];

const FUNCTIONS: &Elsewhere = &[
    ("log", "ln"),
    ("sgn", "signum"),
    ("sign", "signum"),
    ("fabs", "abs"),
    ("arcsin", "asin"),
    ("arccos", "acos"),
    ("arctan", "atan"),
    ("arctan2", "atan2"),
    ("pow", "powi"),
    ("square", "powi"),
    ("inv", "recip"),
    ("norm2", "norm_squared"),
    ("ceiling", "ceil"),
];

const VECTOR_METHODS: &Elsewhere = &[
    ("abs", "norm"),
    ("length", "norm"),
    ("magnitude", "norm"),
    ("squared_norm", "norm_squared"),
    ("unit", "normalize"),
    ("normalized", "normalize"),
    ("square", "norm_squared"),
];

const SOLIDS: &Elsewhere = &[
    ("ball", "sphere"),
    ("disk", "disc"),
    ("circle", "disc"),
    ("bar", "rod"),
    ("beam", "rod"),
    ("pipe", "tube"),
    ("hollow_cylinder", "tube"),
    ("hollow_sphere", "shell"),
    ("block", "cuboid"),
    ("brick", "cuboid"),
    ("plate", "cuboid"),
    ("rectangle", "cuboid"),
];

const NAMES: &Elsewhere = &[
    ("time", "t"),
    ("m", "mass"),
    ("angle", "attitude"),
    ("theta", "attitude"),
    ("theta_dot", "angular_velocity"),
    ("orientation", "attitude"),
    ("quaternion", "attitude"),
    ("omega", "angular_velocity"),
    ("wx", "angular_velocity"),
    ("wy", "angular_velocity"),
    ("wz", "angular_velocity"),
    ("roll", "attitude"),
    ("pitch", "attitude"),
    ("yaw", "attitude"),
    ("com", "G"),
];

const KEYS: &Elsewhere = &[
    ("weight", "fields"),
    ("springs", "potentials"),
    ("torque", "moments"),
    ("torques", "moments"),
    ("controls", "inputs"),
    ("parameters", "params"),
    ("variables", "locals"),
    ("name", "doc"),
];

/// Keys that only systems have.
const KEYS_OF_SYSTEMS: &Elsewhere = &[
    ("rigid_bodies", "bodies"),
    ("actuators", "drives"),
    ("motors", "drives"),
];

/// Words in names, each with the unit of what is probably meant.
const QUANTITIES: &Elsewhere = &[
    ("torque", "N * m"),
    ("moment", "N * m"),
    ("force", "N"),
    ("thrust", "N"),
    ("tension", "N"),
    ("wind", "m / s"),
    ("speed", "m / s"),
    ("angle", "rad"),
    ("mass", "kg"),
    ("m", "kg"),
    ("g", "m / s ^ 2"),
    ("gravity", "m / s ^ 2"),
    ("stiffness", "N / m"),
    ("length", "m"),
    ("radius", "m"),
];
/// Those of them that stay constant.
const CONSTANT: [&str; 7] = ["mass", "m", "g", "gravity", "stiffness", "length", "radius"];

/// The unit of what a name probably means.
pub fn unit_of(name: &str) -> Option<&'static str> {
    name.split('_').find_map(|part| meant(part, QUANTITIES))
}

/// The declaration of an unknown name that says what it is, such as `motor_torque` or `g`.
pub fn declaration_meant(name: &str) -> Option<String> {
    let is_whole = |part: &&str| part.len() > 1 || part.len() == name.len();
    let mut parts = name.split('_').filter(is_whole);
    let part = parts.find(|part| meant(part, QUANTITIES).is_some())?;
    let unit = unit_of(part)?;
    Some(if CONSTANT.contains(&part) {
        format!("params: [{name} = 1[{unit}]]")
    } else {
        format!("inputs: [{name}[{unit}]]")
    })
}

fn meant(word: &str, elsewhere: &Elsewhere) -> Option<&'static str> {
    let mut all = elsewhere.iter();
    all.find_map(|(there, here)| (*there == word).then_some(*here))
}

/// The function of scalars or vectors that a word means in other tools.
pub fn function_meant(word: &str) -> Option<&'static str> {
    meant(word, FUNCTIONS)
}

/// The method of vectors that a word means in other tools.
pub fn vector_method_meant(word: &str) -> Option<&'static str> {
    meant(word, VECTOR_METHODS)
}

/// The solid that a word means in other tools.
pub fn solid_meant(word: &str) -> Option<&'static str> {
    meant(word, SOLIDS)
}

/// The built-in name that a word means in other tools.
pub fn name_meant(word: &str) -> Option<&'static str> {
    meant(word, NAMES)
}

/// The key that a word means in other tools.
pub fn foreign_key_meant(word: &str) -> Option<&'static str> {
    meant(word, KEYS)
}

/// What to write instead of a key that other tools have, and descriptions do not need.
pub fn advice_for_key(word: &str) -> Option<&'static str> {
    Some(match word {
        "com" | "cog" | "center_of_mass" | "origin" => {
            "points are measured from the center of mass, which has no key"
        }
        "position" | "velocity" | "attitude" | "orientation" | "initial" | "state" => {
            "initial values belong to the state, not to the description"
        }
        "geom" | "geometry" | "visual" | "collision" | "shape" | "color" | "mesh" => {
            "shapes are no part of the motion: leave them out"
        }
        "gravity" | "g" => "write it as a field, `fields: [weight = mass * world(..)]`",
        "parent" | "child" | "carrier" | "loops" | "closures" => {
            "bodies are connected by `joints`; a joint between bodies that are connected already closes a loop"
        }
        _ => return None,
    })
}

/// The list of a system that a word means in other tools.
pub fn foreign_list_meant(word: &str) -> Option<&'static str> {
    meant(word, KEYS_OF_SYSTEMS)
}

/// `; did you mean ...?`, or nothing.
pub fn hint<'a>(name: &str, known: impl IntoIterator<Item = &'a str>) -> String {
    similar(name, known).map_or_else(String::new, |known| format!("; did you mean `{known}`?"))
}

/// The least number of insertions, deletions, substitutions and exchanges of neighbors that turn
/// `a` into `b`.
fn distance(a: &str, b: &str) -> usize {
    let (a, b): (Vec<char>, Vec<char>) = (a.chars().collect(), b.chars().collect());
    let mut rows: Vec<Vec<usize>> = vec![(0..=b.len()).collect()];
    for i in 1..=a.len() {
        let mut row = vec![i];
        for j in 1..=b.len() {
            let same = a[i - 1] == b[j - 1];
            let mut least = rows[i - 1][j - 1] + usize::from(!same);
            least = least.min(rows[i - 1][j] + 1).min(row[j - 1] + 1);
            if i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] {
                least = least.min(rows[i - 2][j - 2] + 1);
            }
            row.push(least);
        }
        rows.push(row);
    }
    rows[a.len()][b.len()]
}
