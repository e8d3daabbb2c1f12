use newton_euler::rigid_body;

rigid_body!(Wing {
    motion: translation,
    mass: 12[kg],
    inputs: [x, y, s[m]],
    locals: [
        missing = table(x, "missing.csv"),
        empty = table(x, "empty.csv"),
        letters = table(x, "letters.csv"),
        ragged = table(x, "ragged.csv"),
        back = table(x, "back.csv"),
        one = table(x, "one.csv"),
        single = table(x, "single.csv"),
        which = table(x, "polar.csv"),
        column = table(x, "polar.csv", "drga"),
        bare = table(x, "bare.csv", "drag"),
        narrow = table(x, y, "narrow.csv"),
        corner = table(x, y, "corner.csv"),
        more = table(x, y, s, "polar.csv"),
        columns = table(x, "polar.csv", "lift", "drag"),
        alone = table("polar.csv"),
        unit = table(x, "narrow.csv"[furlong]),
        behind = table("polar.csv", x),
        text = "polar.csv",
        sum = 1[m] + table(x, "narrow.csv"[N]),
    ],
});

fn main() {}
