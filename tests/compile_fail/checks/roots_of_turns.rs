use newton_euler::rigid_body;

// tan(pi / 7) tan(2 pi / 7) tan(3 pi / 7) is the root of seven, and not its opposite
rigid_body!(Sevenths {
    motion: translation,
    mass: 1[kg],
    locals: [
        tangents = (PI / 7).tan() * (2 * PI / 7).tan() * (3 * PI / 7).tan(),
        tiny = 1e-90,
    ],
    checks: [
        right = tangents == 7.sqrt(),
        wrong = 10[deg].sin() + tiny * tangents + tiny * 7.sqrt() == 10[deg].sin(),
    ],
});

fn main() {}
