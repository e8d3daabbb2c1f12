use newton_euler::rigid_body;

rigid_body!(Wing {
    motion: translation,
    mass: 12[kg],
    inputs: [x, y, s[m]],
    locals: [
        missing = table(x, "../compile_fail/tables/missing.csv"),
        empty = table(x, "../compile_fail/tables/empty.csv"),
        letters = table(x, "../compile_fail/tables/letters.csv"),
        ragged = table(x, "../compile_fail/tables/ragged.csv"),
        back = table(x, "../compile_fail/tables/back.csv"),
        one = table(x, "../compile_fail/tables/one.csv"),
        single = table(x, "../compile_fail/tables/single.csv"),
        which = table(x, "../compile_fail/tables/polar.csv"),
        column = table(x, "../compile_fail/tables/polar.csv", "drga"),
        twice = table(x, "../compile_fail/tables/twice.csv", "lift"),
        bare = table(x, "../compile_fail/tables/bare.csv", "drag"),
        narrow = table(x, y, "../compile_fail/tables/narrow.csv"),
        corner = table(x, y, "../compile_fail/tables/corner.csv"),
        more = table(x, y, s, "../compile_fail/tables/polar.csv"),
        columns = table(x, "../compile_fail/tables/polar.csv", "lift", "drag"),
        alone = table("../compile_fail/tables/polar.csv"),
        unit = table(x, "../compile_fail/tables/narrow.csv"[furlong]),
        behind = table("../compile_fail/tables/polar.csv", x),
        text = "../compile_fail/tables/polar.csv",
        sum = 1[m] + table(x, "../compile_fail/tables/narrow.csv"[N]),
    ],
});

fn main() {}
